//! The pages of the documentation: every figure stands on one, no formula is wider than a page, and an erratum that a
//! function names is explained one click away.
#![allow(clippy::panic, reason = "a test that cannot go on fails")]

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use ombra_tests::sources::{files, lectures, root};

/// What a page of rustdoc shows of a line of code without a bar to move it by.
const WIDEST: usize = 92;

fn read(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

/// The Rust files of all crates, with their text.
fn sources(folder: &Path) -> Vec<(String, String)> {
    let files = files(folder, ".rs").into_iter();
    files
        .map(|file| (file.display().to_string(), read(&file)))
        .collect()
}

#[test]
fn every_figure_stands_on_a_page() {
    let mut complaints = Vec::new();
    let mut figures = 0;
    for lecture in lectures() {
        let folder = root().join("crates").join(&lecture);
        let pages: String = sources(&folder.join("src"))
            .into_iter()
            .map(|(_, text)| text)
            .collect();
        for figure in files(&folder.join("figures"), ".svg") {
            figures += 1;
            let name = figure
                .file_name()
                .unwrap_or_default()
                .to_string_lossy()
                .into_owned();
            if !pages.contains(&format!("../figures/{name}\"))]")) {
                complaints.push(format!("{lecture}: no page shows figures/{name}"));
            }
        }
    }
    assert!(complaints.is_empty(), "\n{}", complaints.join("\n"));
    assert!(figures >= 34, "{figures} figures found");
}

/// The lines of blocks in doc comments, with their numbers, where the language of the block is one that `is_wanted`.
fn blocks(source: &str, is_wanted: fn(&str) -> bool) -> Vec<(usize, &str)> {
    let (mut found, mut block) = (Vec::new(), None);
    for (i, line) in source.lines().enumerate() {
        let line = line.trim_start();
        let Some(text) = line
            .strip_prefix("///")
            .or_else(|| line.strip_prefix("//!"))
        else {
            block = None;
            continue;
        };
        let text = text.strip_prefix(' ').unwrap_or(text);
        match (block, text.trim_start().strip_prefix("```")) {
            (None, Some(language)) => block = Some(language),
            (Some(_), Some(_)) => block = None,
            // A line that rustdoc does not show.
            (Some(_), None) if text == "#" || text.starts_with("# ") => {}
            (Some(language), None) if is_wanted(language) => found.push((i + 1, text)),
            _ => {}
        }
    }
    found
}

#[test]
fn formulas_are_found() {
    let source = "/// a\n/// ```text\n/// x = 1\n///   y\n/// ```\n/// b\n/// ```\n/// code\n/// ```\nfn c() {}\n    //! ```text\n    //! z\n";
    let formulas = blocks(source, |language| language == "text");
    assert_eq!(formulas, [(3, "x = 1"), (4, "  y"), (12, "z")]);
    assert_eq!(blocks(source, str::is_empty), [(8, "code")]);
}

#[test]
fn no_formula_is_wider_than_a_page() {
    let mut complaints = Vec::new();
    let mut lines = 0;
    for (file, source) in sources(&root().join("crates")) {
        // The example of a front page is read too, all others are there to be run.
        let is_wanted = if file.ends_with("/src/lib.rs") {
            |_: &str| true
        } else {
            |language: &str| language == "text"
        };
        for (line, text) in blocks(&source, is_wanted) {
            lines += 1;
            let width = text.chars().count();
            if width > WIDEST {
                complaints.push(format!("{file}:{line}: {width} characters: {text}"));
            }
        }
    }
    assert!(complaints.is_empty(), "\n{}", complaints.join("\n"));
    assert!(lines > 200, "{lines} lines of formulas found");
}

/// The numbers that follow `before` and are followed by `after` in `text`.
fn numbers(text: &str, before: &str, after: &str) -> BTreeSet<u32> {
    let rest = text.split(before).skip(1);
    rest.filter_map(|rest| rest.split_once(after)?.0.parse().ok())
        .collect()
}

#[test]
fn errata_are_explained_on_the_front_page() {
    let notes = numbers(
        &read(&root().join("notes/src/errata.md")),
        "<a id=\"e",
        "\"></a>",
    );
    assert!(!notes.is_empty());
    let mut complaints = Vec::new();
    for lecture in lectures() {
        let folder = root().join("crates").join(&lecture).join("src");
        let front = numbers(&read(&folder.join("lib.rs")), "<a id=\"e", "\"></a>");
        for id in front.difference(&notes) {
            complaints.push(format!("{lecture}: the notes do not explain E{id}"));
        }
        let sources = sources(&folder).into_iter();
        for (file, source) in sources.filter(|(file, _)| !file.ends_with("tests.rs")) {
            let docs = source.lines().map(str::trim_start);
            let docs = docs.filter(|line| line.starts_with("///") || line.starts_with("//!"));
            for line in docs {
                for id in numbers(line, "](crate#e", ")").difference(&front) {
                    complaints.push(format!(
                        "{file}: the crate's front page does not explain E{id}"
                    ));
                }
                let (named, linked) = (line.contains("rrat"), line.contains("](crate#e"));
                if named && numbers_after_e(line) > 0 && !linked {
                    complaints.push(format!("{file}: an erratum without a link: {line}"));
                }
            }
        }
    }
    assert!(complaints.is_empty(), "\n{}", complaints.join("\n"));
}

/// How often an E with a number stands in `line` as a word.
fn numbers_after_e(line: &str) -> usize {
    let words = line.split(|c: char| !c.is_alphanumeric());
    let is_id = |word: &str| {
        word.strip_prefix('E')
            .is_some_and(|n| n.parse::<u32>().is_ok())
    };
    words.filter(|word| is_id(word)).count()
}
