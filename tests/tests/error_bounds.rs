//! Every public function that answers a double says how far off it can be: a line `- Error: …` of its page.
#![allow(clippy::panic, reason = "a test that cannot go on fails")]

use std::fs;
use std::path::{Path, PathBuf};

/// The crates whose functions all say so.
const CRATES: [&str; 2] = ["math", "shadows"];

/// What holds doubles, as a signature names it.
const DOUBLES: [&str; 8] = [
    "f64",
    "DVec2",
    "DVec3",
    "DVec4",
    "DMat4",
    "Self",
    "Ellipse",
    "SightLine",
];

fn sources(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        let path = entry.path();
        if path.is_dir() {
            sources(&path, found);
        } else if path.extension().is_some_and(|e| e == "rs") && !path.ends_with("tests.rs") {
            found.push(path);
        }
    }
}

/// The public functions of a source whose answer holds doubles, with the bound that each states.
fn bounds(source: &str) -> Vec<(String, Option<String>)> {
    let source = source.split("#[cfg(test)]").next().unwrap_or_default();
    let mut found = Vec::new();
    let mut doc: Vec<&str> = Vec::new();
    let mut lines = source.lines().map(str::trim);
    while let Some(line) = lines.next() {
        if let Some(text) = line.strip_prefix("///") {
            doc.push(text.trim());
            continue;
        }
        if line.starts_with("#[") {
            continue;
        }
        let rest = line
            .strip_prefix("pub fn ")
            .or_else(|| line.strip_prefix("pub const fn "));
        if let Some(rest) = rest {
            let mut signature = rest.to_owned();
            while !signature.contains(['{', ';']) {
                let Some(next) = lines.next() else { break };
                signature.push_str(next);
            }
            let answer = signature.split_once("->").map_or("", |(_, answer)| answer);
            let is_word = |c: char| c.is_alphanumeric() || c == '_';
            let words: Vec<&str> = answer.split(|c| !is_word(c)).collect();
            if DOUBLES.iter().any(|double| words.contains(double)) {
                let name = rest.split(|c| !is_word(c)).next().unwrap_or_default();
                let bound = doc.iter().find_map(|line| line.strip_prefix("- Error: "));
                found.push((name.to_owned(), bound.map(str::to_owned)));
            }
        }
        doc.clear();
    }
    found
}

#[test]
fn each_function_states_its_bound() {
    let mut missing = Vec::new();
    for name in CRATES {
        let mut files = Vec::new();
        let folder = Path::new(env!("CARGO_MANIFEST_DIR"))
            .join("../crates")
            .join(name)
            .join("src");
        sources(&folder, &mut files);
        files.sort();
        let mut stated = 0;
        for file in files {
            let text =
                fs::read_to_string(&file).unwrap_or_else(|e| panic!("{}: {e}", file.display()));
            for (function, bound) in bounds(&text) {
                match bound {
                    Some(_) => stated += 1,
                    None => missing.push(format!("{}: {function}", file.display())),
                }
            }
        }
        assert!(stated > 5, "{name}: only {stated} bounds were found");
    }
    // What makes a type of exact parts, or a checked copy of what it is given.
    let exempt = ["exact.rs: of", "exact.rs: dot", "mesh.rs: new"];
    missing.retain(|m| !exempt.iter().any(|e| m.ends_with(e)));
    assert!(
        missing.is_empty(),
        "without a line `- Error: `:\n{}",
        missing.join("\n")
    );
}

#[test]
fn sources_are_read_as_written() {
    let source = "
/// One.
///
/// - Error: none.
#[must_use]
pub fn one(x: f64) -> f64 {
/// Two.
pub fn two(
    x: f64,
) -> Option<DVec3> {
/// Three.
pub fn three(x: f64) -> bool {
/// - Error: none.
pub(crate) fn four() -> f64 {
#[cfg(test)]
pub fn five() -> f64 {";
    let expected = [("one", Some("none.")), ("two", None)];
    let expected = expected.map(|(name, bound)| (name.to_owned(), bound.map(str::to_owned)));
    assert_eq!(bounds(source), expected);
}
