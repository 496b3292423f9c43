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

/// A set for one answer a student: what is tried on a single exercise.
const ONE: [&str; 1] = ["one"];

/// Two exercises, whose answers may disturb each other.
const TWO: [&str; 2] = ["first", "second"];

fn tests_of_double(name: &str) -> String {
    format!(
        "{MARKER}\n\nfn main() {{}}\n\n#[cfg(test)]\nmod {name} {{\n    use super::double;\n\n    #[test]\n    fn one() {{\n        \
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
        Self::of(name, &NAMES)
    }

    fn of(name: &str, names: &[&str]) -> Self {
        let dir =
            std::env::temp_dir().join(format!("ombra-grade-test-{name}-{}", std::process::id()));
        fs::create_dir_all(&dir).unwrap();
        let mut info = "format_version = 1\n".to_owned();
        for &name in names {
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
                    tests_of_double(name)
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
        // The student's own tests, here none, never count.
        let text =
            format!("fn double(x: u32) -> u32 {{ {body} }}\r\n{MARKER}\r\nfn main() {{}}\r\n");
        self.file(name, &text);
    }

    fn file(&self, name: &str, text: &str) {
        let topic = if name < "m" { "first" } else { "second" };
        write(
            &self
                .0
                .join("student/exercises")
                .join(topic)
                .join(format!("{name}.rs")),
            text,
        );
    }

    /// Grades the student and gives each exercise's status and the report.
    fn graded(&self) -> (BTreeMap<String, String>, String) {
        let output = self.grade("student", "out", &["--time-limit", "2"]);
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{said}");
        let summary = fs::read(self.path("out/summary.json")).unwrap();
        let summary: serde_json::Value = serde_json::from_slice(&summary).unwrap();
        let mut found = BTreeMap::new();
        for topic in summary["topics"].as_array().unwrap() {
            for result in topic["results"].as_array().unwrap() {
                let text = |key: &str| result[key].as_str().unwrap().to_owned();
                found.insert(text("name"), text("status"));
            }
        }
        let junit = fs::read_to_string(self.path("out/junit.xml")).unwrap();
        (found, junit)
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
        (
            "nowhere",
            "out",
            &[][..],
            "nowhere is neither a folder nor a zip",
        ),
        (
            "empty",
            "out",
            &[],
            "holds no exercise of the set, such as exercises",
        ),
        ("student", "file", &[], "is a file, but must be a folder"),
        ("student", "student/out/deep", &[], "which is only read"),
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

/// The tests of a set of one exercise, on answers that are right, wrong or something else altogether.
#[track_caller]
fn one_answer(name: &str, text: &str, status: &str, sentence: &str) {
    let place = Place::of(name, &ONE);
    place.file("one", text);
    let (found, junit) = place.graded();
    assert_eq!(found["one"], status, "{junit}");
    assert!(junit.contains(sentence), "{sentence}\n{junit}");
}

#[test]
fn a_forged_report_does_not_count() {
    let forged = format!(
        "fn double(_: u32) -> u32 {{
    println!(\"test one::one ... ok\");
    println!(\"\\ntest result: ok. 1 passed; 0 failed; 0 ignored; 0 measured; 0 filtered out\");
    std::process::exit(0)
}}
{MARKER}
"
    );
    one_answer(
        "forged",
        &forged,
        "failed",
        "the program ended before its test did (exit status: 0)",
    );
}

#[test]
fn a_token_read_too_late_is_empty() {
    let reads = format!(
        "fn double(_: u32) -> u32 {{
    let mut token = String::new();
    std::io::stdin().read_line(&mut token).unwrap();
    print!(\"{{token}}\");
    std::process::exit(0)
}}
{MARKER}
"
    );
    one_answer(
        "token",
        &reads,
        "failed",
        "the program ended before its test did",
    );
}

#[test]
fn macros_of_an_answer_do_not_reach_the_tests() {
    let macros = "macro_rules! assert_eq { ($($any:tt)*) => {}; }\nmacro_rules! assert { ($($any:tt)*) => {}; }\n";
    let wrong = format!("fn double(x: u32) -> u32 {{ x + 5 }}\n{MARKER}\n");
    let exported = macros.replace("macro_rules", "#[macro_export]\nmacro_rules");
    for (name, text) in [
        ("macros", format!("{macros}{wrong}")),
        ("exported", format!("{exported}{wrong}")),
        ("used", format!("#![macro_use]\n{macros}{wrong}")),
    ] {
        one_answer(name, &text, "failed", "&lt;twice&gt; &amp; one");
    }
    // An answer that lets its macros out of its module reaches no other's tests either.
    let place = Place::of("two", &TWO);
    place.file("first", &format!("#![macro_use]\n{macros}{wrong}"));
    place.file("second", &wrong);
    let (found, junit) = place.graded();
    assert_eq!(
        [&found["first"], &found["second"]],
        ["failed", "failed"],
        "{junit}"
    );
}

#[test]
fn right_answers_of_every_form_are_solved() {
    let double = "fn double(x: u32) -> u32 { 2 * x }\n";
    for (name, text) in [
        ("no-marker", double.to_owned()),
        (
            "main",
            format!("{double}fn main() {{}}\n{MARKER}\nfn main() {{}}\n"),
        ),
        (
            "attributes",
            format!("// mine\n#![allow(unused)]\n//! My answer.\n\n{double}{MARKER}\n"),
        ),
        (
            "bom",
            format!("\u{feff}{double}{MARKER}\n").replace('\n', "\r\n"),
        ),
        (
            "path",
            format!(
                "mod help {{ pub fn twice(x: u32) -> u32 {{ x + x }} }}\nfn double(x: u32) -> u32 {{ crate::help::twice(x) }}\n{MARKER}\n"
            ),
        ),
        (
            "own-tests",
            format!(
                "{double}#[cfg(test)]\nmod one {{\n    use super::double;\n    #[test]\n    fn one() {{ double(7); }}\n}}\n{MARKER}\n"
            ),
        ),
        (
            "prints",
            format!(
                "fn double(x: u32) -> u32 {{ for _ in 0..200_000 {{ println!(\"so many lines of output\"); }} 2 * x }}\n{MARKER}\n"
            ),
        ),
        (
            "warnings",
            format!("#![deny(warnings)]\nfn unused() {{}}\n{double}{MARKER}\n"),
        ),
    ] {
        one_answer(name, &text, "solved", "failures=\"0\" errors=\"0\"");
    }
}

#[test]
fn answers_that_do_not_go_together_stand_alone() {
    let place = Place::of("clash", &TWO);
    let exported = format!(
        "#[macro_export]\nmacro_rules! twice {{ ($x:expr) => {{ 2 * $x }}; }}\nfn double(x: u32) -> u32 {{ twice!(x) }}\n{MARKER}\n"
    );
    place.file("first", &exported);
    place.file("second", &exported);
    let (found, junit) = place.graded();
    assert_eq!(
        [&found["first"], &found["second"]],
        ["solved", "solved"],
        "{junit}"
    );
}

#[test]
fn one_that_does_not_compile_is_told_with_its_own_lines() {
    let place = Place::of("lines", &TWO);
    place.file(
        "first",
        &format!("#![allow(unused)]\n\nfn double(x: u32) -> u32 {{ 2 * }}\n{MARKER}\n"),
    );
    place.file(
        "second",
        &format!("fn double(x: u64) -> u64 {{ 2 * x }}\n{MARKER}\n"),
    );
    let (found, junit) = place.graded();
    assert_eq!(found["first"], "does not compile", "{junit}");
    assert!(
        junit.contains("--&gt; exercises/first/first.rs:3:"),
        "{junit}"
    );
    // Another signature than the one asked for: u64 goes through these tests all the same.
    assert_eq!(found["second"], "solved", "{junit}");
}

#[test]
fn memory_without_end_is_told() {
    if cfg!(target_os = "linux") {
        let collects = format!(
            "fn double(x: u32) -> u32 {{ let mut all = vec![]; loop {{ all.push(vec![0_u8; 1 << 26]); std::hint::black_box(x); }} }}\n{MARKER}\n"
        );
        one_answer(
            "memory",
            &collects,
            "failed",
            "does a loop collect without end?",
        );
    }
}

#[cfg(unix)]
#[test]
fn a_program_that_outlives_its_test_is_seen_and_ended() {
    // It passes, fails or loops, but in each case something goes on.
    let child = |rest: &str| {
        format!(
            "fn double(x: u32) -> u32 {{
    let child = std::process::Command::new(\"sleep\").arg(\"61.25\").spawn();
    std::mem::forget(child);
    {rest}
}}
{MARKER}
"
        )
    };
    let started = std::time::Instant::now();
    one_answer(
        "child",
        &child("2 * x"),
        "failed",
        "a program that it had started still ran",
    );
    one_answer(
        "child-fails",
        &child("x"),
        "failed",
        "&lt;twice&gt; &amp; one",
    );
    one_answer(
        "child-loops",
        &child("loop { std::hint::black_box(x); }"),
        "time limit",
        "stopped after 2 s",
    );
    assert!(started.elapsed().as_secs() < 40, "{:?}", started.elapsed());
    let still = Command::new("pgrep").args(["-f", "sleep 61.25"]).output();
    assert!(still.is_err() || still.is_ok_and(|found| found.stdout.is_empty()));
}

#[test]
#[ignore = "takes two minutes: the compiler's time limit, twice"]
fn a_constant_that_loops_is_told() {
    let constant =
        format!("const TWO: u32 = loop {{}};\nfn double(x: u32) -> u32 {{ TWO * x }}\n{MARKER}\n");
    one_answer(
        "constant",
        &constant,
        "does not compile",
        "does a constant loop without end?",
    );
}

#[test]
fn the_compiler_is_quoted_as_if_the_tests_stood_in_the_file() {
    let place = Place::of("quoted", &TWO);
    place.file(
        "first",
        &format!("use std::nowhere::Nothing;\n\nfn double(x: u32) -> u32 {{ 2 * x }}\n{MARKER}\n"),
    );
    place.file(
        "second",
        &format!("fn double(x: u32, y: u32) -> u32 {{ x + y }}\n{MARKER}\n"),
    );
    let (found, junit) = place.graded();
    assert_eq!(found["first"], "does not compile", "{junit}");
    assert_eq!(found["second"], "does not compile", "{junit}");
    for part in [
        " --&gt; exercises/first/first.rs:1:10\n  |\n1 | use std::nowhere::Nothing;\n  |          ^^^^^^^ could",
        "the tests want the names and parameters as the exercise gives them",
        "--&gt; exercises/second/second.rs:12:20\n",
    ] {
        assert!(junit.contains(part), "{part}\n{junit}");
    }
    assert!(!junit.contains("tests/"), "{junit}");
}

#[test]
fn a_test_beside_one_that_loops_has_its_own_time() {
    let place = Place::of("times", &TWO);
    let loops =
        "fn double(x: u32) -> u32 { while x == 1 { std::hint::black_box(x); } 2 * x }\n".to_owned();
    place.file("first", &format!("{loops}{MARKER}\n"));
    let (found, junit) = place.graded();
    assert_eq!(found["first"], "time limit", "{junit}");
    let time = |test: &str| -> f64 {
        let (_, after) = junit
            .split_once(&format!("first\" name=\"{test}\" time=\""))
            .unwrap();
        after.split('"').next().unwrap().parse().unwrap()
    };
    assert!(time("one") >= 2.0 && time("ten") < 1.5, "{junit}");
}

#[cfg(unix)]
#[test]
fn a_test_that_loops_does_not_outlive_the_grader() {
    let place = Place::of("orphan", &TWO);
    let loops = "fn double(x: u32) -> u32 { loop { std::hint::black_box(x); } }\n";
    place.file("first", &format!("{loops}{MARKER}\n"));
    let mut grader = Command::new(env!("CARGO_BIN_EXE_ombra-grade"))
        .arg("--exercises")
        .arg(place.path("set"))
        .arg("grade")
        .arg(place.path("student"))
        .arg("--out")
        .arg(place.path("out"))
        .args(["--time-limit", "3"])
        .env("TMPDIR", &place.0)
        .spawn()
        .unwrap();
    let runs = || {
        let listed = Command::new("ps").args(["-A", "-o", "args"]).output();
        let listed = String::from_utf8_lossy(&listed.unwrap().stdout).into_owned();
        let of_ours = |line: &str| line.contains("-orphan-") && line.contains("first::one");
        listed.lines().any(of_ours)
    };
    let wait = |state: bool| {
        for _ in 0..600 {
            if runs() == state {
                return;
            }
            std::thread::sleep(std::time::Duration::from_millis(100));
        }
        panic!(
            "the test of the answer {}",
            if state { "never ran" } else { "still runs" }
        );
    };
    wait(true);
    grader.kill().unwrap();
    grader.wait().unwrap();
    wait(false);
}
