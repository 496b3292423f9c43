//! `ombra-grade grade` on a small set and a student's tree with every kind of answer.

// A helper of a test is a test.
#![allow(clippy::unwrap_used)]

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

const MARKER: &str = "// ---- tests: leave everything below as it is ----";

/// A set of exercises `name`, each `fn double(x: u32) -> u32` with two tests, and no dependency to build.
const NAMES: [&str; 7] = [
    "right",
    "half",
    "loops",
    "broken",
    "overflows",
    "leaves",
    "missing",
];

fn tests_of_double() -> String {
    format!(
        "{MARKER}\n\nfn main() {{}}\n\n#[cfg(test)]\nmod tests {{\n    use super::*;\n\n    #[test]\n    fn one() {{\n        \
         assert_eq!(double(1), 2, \"<twice> & one\");\n    }}\n\n    #[test]\n    fn ten() {{\n        \
         assert_eq!(double(10), 20);\n    }}\n}}\n"
    )
}

fn write(path: &Path, text: &str) {
    fs::create_dir_all(path.parent().unwrap()).unwrap();
    fs::write(path, text).unwrap();
}

struct Place(PathBuf);

impl Place {
    fn new(name: &str) -> Self {
        let dir =
            std::env::temp_dir().join(format!("ombra-grade-test-{name}-{}", std::process::id()));
        fs::create_dir_all(&dir).unwrap();
        let mut info = "format_version = 1\n".to_owned();
        for name in NAMES {
            let topic = if name < "m" { "first" } else { "second" };
            info += &format!("[[exercises]]\nname = '{name}'\ndir = '{topic}'\n");
            let file = dir
                .join("set/exercises")
                .join(topic)
                .join(format!("{name}.rs"));
            write(
                &file,
                &format!(
                    "fn double(x: u32) -> u32 {{\n    todo!()\n}}\n\n{}",
                    tests_of_double()
                ),
            );
        }
        write(&dir.join("set/info.toml"), &info);
        let manifest = "bin = [\n]\n[package]\nname = \"small\"\nedition = \"2024\"\n[workspace]\n";
        write(&dir.join("set/Cargo.toml"), manifest);
        let lock = "version = 4\n\n[[package]]\nname = \"small\"\nversion = \"0.0.0\"\n";
        write(&dir.join("set/Cargo.lock"), lock);
        Self(dir)
    }

    fn path(&self, inside: &str) -> PathBuf {
        self.0.join(inside)
    }

    fn answer(&self, name: &str, body: &str) {
        let topic = if name < "m" { "first" } else { "second" };
        // The student's own tests, here none, never count.
        let text =
            format!("fn double(x: u32) -> u32 {{ {body} }}\r\n{MARKER}\r\nfn main() {{}}\r\n");
        write(
            &self
                .0
                .join("student/exercises")
                .join(topic)
                .join(format!("{name}.rs")),
            &text,
        );
    }

    fn grade(&self, student: &str, out: &str, more: &[&str]) -> Output {
        Command::new(env!("CARGO_BIN_EXE_ombra-grade"))
            .arg("--exercises")
            .arg(self.path("set"))
            .arg("grade")
            .arg(self.path(student))
            .arg("--out")
            .arg(self.path(out))
            .args(more)
            .output()
            .unwrap()
    }
}

impl Drop for Place {
    fn drop(&mut self) {
        fs::remove_dir_all(&self.0).unwrap();
    }
}

fn files_below(dir: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    let mut files = BTreeMap::new();
    for entry in fs::read_dir(dir).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            files.append(&mut files_below(&path));
        } else {
            files.insert(path.clone(), fs::read(&path).unwrap());
        }
    }
    files
}

#[test]
fn every_kind_of_answer() {
    let place = Place::new("answers");
    place.answer("right", "2 * x");
    place.answer("half", "if x == 10 { 20 } else { x }");
    place.answer("loops", "while x == 1 { std::hint::black_box(x); } 2 * x");
    place.answer("broken", "2 * y");
    place.answer(
        "overflows",
        "if x == 0 { 1 } else { double(std::hint::black_box(x + 1)) + x }",
    );
    place.answer("leaves", "std::process::exit(x as i32 * 0)");
    let before = files_below(&place.path("student"));

    let output = place.grade("student", "out", &["--time-limit", "1"]);
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{said}");
    assert!(
        before == files_below(&place.path("student")),
        "the student's tree was changed"
    );

    let summary: serde_json::Value =
        serde_json::from_slice(&fs::read(place.path("out/summary.json")).unwrap()).unwrap();
    let mut found = BTreeMap::new();
    for topic in summary["topics"].as_array().unwrap() {
        for result in topic["results"].as_array().unwrap() {
            assert_eq!(result["tests"], 2);
            let status = result["status"].as_str().unwrap().to_owned();
            found.insert(
                result["name"].as_str().unwrap().to_owned(),
                (status, result["tests_passed"].as_u64().unwrap()),
            );
        }
    }
    for (name, status, passed) in [
        ("right", "solved", 2),
        ("half", "failed", 1),
        ("loops", "time limit", 1),
        ("broken", "does not compile", 0),
        ("overflows", "failed", 0),
        ("leaves", "failed", 0),
        ("missing", "missing", 0),
    ] {
        assert_eq!(found[name], (status.to_owned(), passed), "{name}");
    }
    assert_eq!(summary["exercises_solved"], 1);
    assert_eq!(summary["tests_passed"], 4);

    let xml = fs::read_to_string(place.path("out/junit.xml")).unwrap();
    for part in [
        "tests=\"14\" failures=\"6\" errors=\"4\">",
        "&lt;twice&gt; &amp; one",
        "stopped after 1 s: does a loop never end?",
        "cannot find value `y`",
        "the program ended before its test did",
    ] {
        assert!(xml.contains(part), "{part}\n{xml}");
    }
    // Nothing half-written stays beside the two files.
    assert_eq!(fs::read_dir(place.path("out")).unwrap().count(), 2);
}

#[test]
fn bad_input_gets_a_sentence() {
    let place = Place::new("bad-input");
    place.answer("right", "2 * x");
    write(&place.path("empty/notes.txt"), "nothing");
    write(&place.path("file"), "text");
    for (student, out, more, sentence) in [
        ("nowhere", "out", &[][..], "nowhere is not a folder"),
        (
            "empty",
            "out",
            &[],
            "holds no exercise of the set, such as exercises",
        ),
        ("student", "file", &[], "is a file, but must be a folder"),
        (
            "student",
            "student/out/deep",
            &[],
            "lies in the student's folder",
        ),
        (
            "student",
            "out",
            &["--time-limit", "NaN"],
            "a number of seconds from 0.1 to 3600",
        ),
        (
            "student",
            "out",
            &["--time-limit", "0"],
            "a number of seconds from 0.1 to 3600",
        ),
    ] {
        let output = place.grade(student, out, more);
        let said = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{student} {out}: {said}");
        assert!(said.contains(sentence), "{student} {out}: {said}");
        assert!(!place.path("out").exists() && !place.path("student/out").exists());
    }
}
