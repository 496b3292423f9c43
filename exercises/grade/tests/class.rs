//! `ombra-grade class`: every form of submission and every kind of answer, and a run that is broken off and taken up.

// A helper of a test is a test.
#![allow(clippy::unwrap_used)]

use std::collections::BTreeMap;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::time::Duration;

const MARKER: &str = "// ---- tests: leave everything below as it is ----";
/// Two exercises, `fn double(x: u32) -> u32` both, and nothing to build beside them.
const NAMES: [&str; 2] = ["a1_first", "b1_second"];
const RIGHT: &str = "fn double(x: u32) -> u32 { 2 * x }\n";
const WRONG: &str = "fn double(x: u32) -> u32 { x + 1 }\n";

struct Place(PathBuf);

impl Place {
    fn new(name: &str) -> Self {
        let dir = std::env::temp_dir().join(format!("ombra-class-{name}-{}", std::process::id()));
        fs::create_dir_all(&dir).unwrap();
        let place = Self(dir.canonicalize().unwrap());
        let mut info = "format_version = 1\n".to_owned();
        for name in NAMES {
            let topic = &name[..1];
            info += &format!("[[exercises]]\nname = '{name}'\ndir = '{topic}'\n");
            let tests = format!(
                "fn double(x: u32) -> u32 {{ todo!() }}\n{MARKER}\n\nfn main() {{}}\n\n#[cfg(test)]\nmod {name} {{\n    \
                 use super::double;\n\n    #[test]\n    fn one() {{\n        assert_eq!(double(1), 2);\n    }}\n\n    \
                 #[test]\n    fn ten() {{\n        assert_eq!(double(10), 20, \"ten\");\n    }}\n}}\n"
            );
            place.write(
                &format!("set/exercises/{topic}/{name}.rs"),
                tests.as_bytes(),
            );
        }
        place.write("set/info.toml", info.as_bytes());
        let manifest = "bin = [\n]\n[package]\nname = \"small\"\nedition = \"2024\"\n[workspace]\n";
        place.write("set/Cargo.toml", manifest.as_bytes());
        let lock = "version = 4\n\n[[package]]\nname = \"small\"\nversion = \"0.0.0\"\n";
        place.write("set/Cargo.lock", lock.as_bytes());
        place
    }

    fn path(&self, inside: &str) -> PathBuf {
        self.0.join(inside)
    }

    fn write(&self, inside: &str, bytes: &[u8]) {
        let path = self.path(inside);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, bytes).unwrap();
    }

    fn command(&self, submissions: &str) -> Command {
        let mut command = class(
            &self.path("set"),
            &self.path(submissions),
            &self.path("out"),
        );
        command.args(["--time-limit", "2"]);
        command
    }

    fn grade(&self, submissions: &str) -> Output {
        self.command(submissions).output().unwrap()
    }

    fn table(&self) -> BTreeMap<String, BTreeMap<String, String>> {
        table(&self.path("out/class.csv"))
    }
}

impl Drop for Place {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

fn class(set: &Path, submissions: &Path, out: &Path) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_ombra-grade"));
    command.arg("--exercises").arg(set);
    command.arg("class").arg(submissions).arg("--out").arg(out);
    command
}

/// A table as RFC 4180 has it, read by a reader that knows nothing of the one who wrote it: by student, by column.
fn table(path: &Path) -> BTreeMap<String, BTreeMap<String, String>> {
    let text = fs::read_to_string(path).unwrap();
    let (mut rows, mut row, mut field) = (Vec::new(), Vec::new(), String::new());
    let mut quoted = false;
    let mut chars = text.chars().peekable();
    while let Some(c) = chars.next() {
        match c {
            '"' if quoted && chars.peek() == Some(&'"') => field.extend(chars.next()),
            '"' => quoted = !quoted,
            ',' if !quoted => row.push(std::mem::take(&mut field)),
            '\n' if !quoted => {
                row.push(std::mem::take(&mut field));
                rows.push(std::mem::take(&mut row));
            }
            '\r' if !quoted => {}
            _ => field.push(c),
        }
    }
    assert!(!quoted && row.is_empty() && field.is_empty());
    let head = rows.remove(0);
    let line = |row: Vec<String>| {
        assert_eq!(row.len(), head.len());
        (row[0].clone(), head.iter().cloned().zip(row).collect())
    };
    rows.into_iter().map(line).collect()
}

/// What a folder of reports says of an exercise, read from its XML; all three reports must agree.
fn agreeing(out: &Path, row: &BTreeMap<String, String>) {
    let folder = out.join(&row["folder"]);
    let xml = fs::read_to_string(folder.join("junit.xml")).unwrap();
    let xml = roxmltree::Document::parse(&xml).unwrap();
    let summary = fs::read(folder.join("summary.json")).unwrap();
    let summary: serde_json::Value = serde_json::from_slice(&summary).unwrap();
    let count = |tag: &str| {
        xml.descendants()
            .filter(|node| node.has_tag_name(tag))
            .count()
    };
    let number = |key: &str| row[key].parse::<usize>().unwrap();
    assert_eq!(count("testcase"), number("tests"));
    let bad = count("failure") + count("error");
    assert_eq!(count("testcase") - bad, number("tests passed"), "{row:?}");
    assert_eq!(summary["tests_passed"], number("tests passed"));
    assert_eq!(summary["exercises_solved"], number("exercises solved"));
    assert_eq!(summary["student"], row["student"].as_str());
    for suite in xml
        .descendants()
        .filter(|node| node.has_tag_name("testsuite"))
    {
        let name = suite.attribute("name").unwrap().split('.').nth(1).unwrap();
        let errors: usize = suite.attribute("errors").unwrap().parse().unwrap();
        let failures: usize = suite.attribute("failures").unwrap().parse().unwrap();
        let kind = match row[name].as_str() {
            "solved" => [false, false],
            "failed" | "time limit" => [true, false],
            _ => [false, true],
        };
        assert_eq!([failures > 0, errors > 0], kind, "{name}: {row:?}");
    }
    let feedback = fs::read_to_string(folder.join("feedback.txt")).unwrap();
    assert!(feedback.starts_with(&row["student"]), "{feedback}");
}

fn zipped(files: &[(&str, &[u8])]) -> Vec<u8> {
    let mut zip = zip::ZipWriter::new(std::io::Cursor::new(Vec::new()));
    for (path, bytes) in files {
        let options = zip::write::SimpleFileOptions::default();
        zip.start_file(*path, options).unwrap();
        zip.write_all(bytes).unwrap();
    }
    zip.finish().unwrap().into_inner()
}

fn said(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

#[test]
fn every_form_of_submission() {
    let place = Place::new("forms");
    let right = format!("{RIGHT}{MARKER}\n");
    let (right, wrong) = (right.as_bytes(), WRONG.as_bytes());
    // Nested as the copy is, flat, deep in other folders, with what comes along.
    place.write("in/nested/exercises/a/a1_first.rs", right);
    place.write("in/nested/exercises/b/b1_second.rs", wrong);
    place.write("in/nested/solutions/a/a1_first.rs", wrong);
    place.write("in/nested/target/a1_first.rs", wrong);
    place.write("in/flat/a1_first.rs", right);
    place.write(
        "in/Žofie, \"Zo\" =1+1_123_assignsubmission_file_/mine/ombra/exercises/a/a1_first.rs",
        right,
    );
    place.write("in/two/a1_first.rs", right);
    place.write("in/two/old/a1_first.rs", wrong);
    place.write("in/text/a1_first.rs", b"fn double\xff");
    place.write("in/folder/a1_first.rs/inside.rs", right);
    place.write("in/empty/notes.txt", b"sorry");
    place.write("in/large/a1_first.rs", &vec![b' '; (1 << 20) + 1]);
    // Zips: of a copy, flat, in a folder, broken, with a link in it.
    let copy = zipped(&[
        ("mine/exercises/a/a1_first.rs", right),
        ("mine/solutions/b/b1_second.rs", right),
    ]);
    place.write("in/zip-copy.zip", &copy);
    place.write(
        "in/zip-flat.ZIP",
        &zipped(&[("a1_first.rs", right), ("__MACOSX/b1_second.rs", wrong)]),
    );
    place.write("in/zip-inside/answers.zip", &copy);
    place.write("in/zip-broken.zip", &copy[..copy.len() / 2]);
    let mut with_link = zip::ZipWriter::new(std::io::Cursor::new(Vec::new()));
    let options = zip::write::SimpleFileOptions::default();
    with_link
        .add_symlink("a1_first.rs", "../nested/a1_first.rs", options)
        .unwrap();
    place.write("in/zip-link.zip", &with_link.finish().unwrap().into_inner());
    // Files of all in one folder.
    place.write("in/smithann_12_34_a1_first.rs", wrong);
    place.write("in/smithann_12_35_a1_first-1.rs", right);
    place.write("in/jones_LATE_13_36_b1_second.rs", right);
    place.write("in/.DS_Store", b"");
    if cfg!(unix) {
        #[cfg(unix)]
        {
            use std::os::unix::fs::symlink;
            fs::create_dir_all(place.path("in/link-file")).unwrap();
            symlink(
                "../flat/a1_first.rs",
                place.path("in/link-file/a1_first.rs"),
            )
            .unwrap();
            symlink("flat", place.path("in/link-student")).unwrap();
            fs::create_dir_all(place.path("in/link-folder")).unwrap();
            symlink(
                "../nested/exercises",
                place.path("in/link-folder/exercises"),
            )
            .unwrap();
        }
    }

    let output = place.grade("in");
    assert!(output.status.success(), "{}", said(&output));
    let table = place.table();
    let want = [
        ("nested", "solved", "failed"),
        ("flat", "solved", "missing"),
        (
            "Žofie, \"Zo\" =1+1_123_assignsubmission_file_",
            "solved",
            "missing",
        ),
        ("two", "unreadable", "missing"),
        ("text", "unreadable", "missing"),
        ("folder", "unreadable", "missing"),
        ("empty", "missing", "missing"),
        ("large", "unreadable", "missing"),
        ("zip-copy", "solved", "missing"),
        ("zip-flat", "solved", "missing"),
        ("zip-inside", "solved", "missing"),
        ("zip-broken", "unreadable", "unreadable"),
        ("zip-link", "link", "missing"),
        ("smithann", "solved", "missing"),
        ("jones", "missing", "solved"),
        ("link-file", "link", "missing"),
        ("link-student", "link", "link"),
        ("link-folder", "link", "link"),
    ];
    let want = &want[..if cfg!(unix) { 18 } else { 15 }];
    for (student, first, second) in want {
        let row = &table[*student];
        assert_eq!(
            [&row["a1_first"], &row["b1_second"]],
            [first, second],
            "{student}"
        );
        agreeing(&place.path("out"), row);
    }
    assert_eq!(table.len(), want.len());
    assert!(!place.path("out/.work").exists());

    // The same in one zip, with and without a folder around them.
    let as_one = |around: &str| {
        let name = |inside: &str| format!("{around}{inside}");
        let files = [
            (name("ann/exercises/a/a1_first.rs"), right.to_vec()),
            (name("bob/answers.zip"), copy.clone()),
            (name("cid.zip"), copy.clone()),
        ];
        let files: Vec<(&str, &[u8])> = files
            .iter()
            .map(|(path, bytes)| (path.as_str(), bytes.as_slice()))
            .collect();
        zipped(&files)
    };
    for around in ["", "course 2026/"] {
        place.write("all.zip", &as_one(around));
        let output = place.grade("all.zip");
        assert!(output.status.success(), "{}", said(&output));
        let table = place.table();
        let solved: Vec<&String> = table
            .iter()
            .filter(|(_, row)| row["a1_first"] == "solved")
            .map(|(name, _)| name)
            .collect();
        assert_eq!(solved, ["ann", "bob", "cid"], "{around:?}");
    }
}

#[test]
fn a_run_is_taken_up_where_it_was_broken_off() {
    let place = Place::new("resume");
    for number in 0..6 {
        // The last ones loop, so there is time to break the run off.
        let answer = if number < 4 {
            RIGHT
        } else {
            "fn double(x: u32) -> u32 { loop { std::hint::black_box(x); } }\n"
        };
        place.write(&format!("in/s{number}/a1_first.rs"), answer.as_bytes());
    }
    let mut running = place
        .command("in")
        .args(["--jobs", "1"])
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    let has_summary = |number: usize| place.path(&format!("out/s{number}/summary.json")).is_file();
    while !has_summary(3) {
        std::thread::sleep(Duration::from_millis(10));
    }
    running.kill().unwrap();
    running.wait().unwrap();
    assert!(!has_summary(5) && !place.path("out/class.csv").exists());
    let times = |number: usize| {
        let file = fs::metadata(place.path(&format!("out/s{number}/summary.json"))).unwrap();
        file.modified().unwrap()
    };
    let before = times(0);

    let again = place.grade("in");
    assert!(again.status.success(), "{}", said(&again));
    assert!(
        said(&again).matches("graded before").count() >= 4,
        "{}",
        said(&again)
    );
    assert_eq!(times(0), before);
    let table = place.table();
    let statuses: Vec<&str> = table.values().map(|row| row["a1_first"].as_str()).collect();
    assert_eq!(
        statuses,
        [
            "solved",
            "solved",
            "solved",
            "solved",
            "time limit",
            "time limit"
        ]
    );

    // Who hands in anew, and only they, are graded anew.
    place.write("in/s2/a1_first.rs", WRONG.as_bytes());
    let third = place.grade("in");
    assert_eq!(
        said(&third).matches("graded before").count(),
        5,
        "{}",
        said(&third)
    );
    assert_eq!(place.table()["s2"]["a1_first"], "failed");
    // Other tests are another grading for all.
    let file = place.path("set/exercises/a/a1_first.rs");
    let tests = fs::read_to_string(&file).unwrap();
    fs::write(&file, tests.replace("double(10), 20", "double(11), 22")).unwrap();
    let fourth = place.grade("in");
    assert_eq!(
        said(&fourth).matches("graded before").count(),
        0,
        "{}",
        said(&fourth)
    );
}

#[test]
fn bad_input_gets_a_sentence() {
    let place = Place::new("bad");
    place.write("nothing/notes.txt", b"");
    place.write("copy/info.toml", b"");
    place.write("broken.zip", b"PK no");
    place.write("in/ann/a1_first.rs", RIGHT.as_bytes());
    for (submissions, sentence) in [
        ("nowhere", "is neither a folder of submissions nor a zip"),
        (
            "nothing",
            "holds no submission: a folder or a zip for each student, or files such as NAME_a1_first.rs",
        ),
        ("copy", "is one copy of the exercises"),
        ("broken.zip", "broken.zip: the zip cannot be read"),
    ] {
        let output = place.grade(submissions);
        assert_eq!(output.status.code(), Some(2), "{submissions}");
        assert!(
            said(&output).contains(sentence),
            "{submissions}: {}",
            said(&output)
        );
        assert!(!place.path("out").exists());
    }
    let inside = class(&place.path("set"), &place.path("in"), &place.path("in/out"))
        .output()
        .unwrap();
    assert!(
        said(&inside).contains("which is only read"),
        "{}",
        said(&inside)
    );
    let jobs = place.command("in").args(["--jobs", "0"]).output().unwrap();
    assert_eq!(jobs.status.code(), Some(2));
}

/// The course's own exercises, 300 students in 20 states: some 10 minutes on two cores.
#[test]
#[ignore = "takes minutes: run before a term begins"]
fn three_hundred_submissions_of_the_course() {
    let set = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let place = Place::new("three-hundred");
    let solutions: Vec<(String, String, String)> = files(&set.join("solutions"));
    let stubs = files(&set.join("exercises"));
    let mut want = BTreeMap::new();
    for number in 0..300 {
        let state = STATES[number % STATES.len()];
        let student = format!("{state}-{number:03}");
        // One exercise is in that state, another each time; all others are right.
        let (victim, ..) = &solutions[number / STATES.len() % solutions.len()];
        let stub_of = |name: &str| {
            stubs
                .iter()
                .find(|(other, ..)| other == name)
                .unwrap()
                .2
                .clone()
        };
        let status = hand_in(
            &place,
            state,
            &student,
            &solutions,
            victim,
            &stub_of(victim),
        );
        want.insert(student, (victim.clone(), status));
    }
    let out = place.path("out");
    let command = || {
        let mut command = class(&set, &place.path("in"), &out);
        command.args(["--time-limit", "3"]);
        command
    };
    // Broken off once, then taken up.
    let mut running = command()
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    std::thread::sleep(Duration::from_secs(60));
    running.kill().unwrap();
    running.wait().unwrap();
    let output = command().output().unwrap();
    let said = said(&output);
    assert!(output.status.success(), "{said}");
    println!(
        "graded before the run was broken off: {}",
        said.matches("graded before").count()
    );
    assert!(said.contains("graded before"));

    let table = table(&out.join("class.csv"));
    assert_eq!(table.len(), 300);
    for (student, (victim, status)) in want {
        let row = &table[&student];
        agreeing(&out, row);
        for (name, ..) in &solutions {
            let expected = match status {
                All(status) => status,
                One(status) if *name == victim => status,
                One(_) => "solved",
            };
            assert_eq!(row[name], expected, "{student}, {name}");
        }
    }
    // Neither a program that an answer started nor a test that loops outlives the graders, also not the one that was killed.
    std::thread::sleep(Duration::from_secs(6));
    let work = out.join(".work");
    for running in ["sleep 61.75", work.to_str().unwrap()] {
        let left = Command::new("pgrep").args(["-f", running]).output();
        let none = left.is_err() || left.is_ok_and(|found| found.stdout.is_empty());
        assert!(none, "{running} still runs");
    }
}

#[derive(Clone, Copy)]
enum Status {
    All(&'static str),
    One(&'static str),
}
use Status::{All, One};

const STATES: [&str; 20] = [
    "right",
    "stub",
    "syntax",
    "types",
    "deleted-tests",
    "changed-tests",
    "loops",
    "forged",
    "exits",
    "child",
    "macros",
    "memory",
    "link",
    "link-all",
    "zip",
    "zip-flat",
    "flat",
    "bom-crlf",
    "missing",
    "no-marker",
];

/// Name, path in the copy, and text of each file of a folder of the set.
fn files(dir: &Path) -> Vec<(String, String, String)> {
    let mut all = Vec::new();
    for topic in fs::read_dir(dir).unwrap() {
        let topic = topic.unwrap();
        for file in fs::read_dir(topic.path()).unwrap() {
            let file = file.unwrap();
            let name = file
                .file_name()
                .to_string_lossy()
                .trim_end_matches(".rs")
                .to_owned();
            let path = format!(
                "exercises/{}/{name}.rs",
                topic.file_name().to_string_lossy()
            );
            all.push((name, path, fs::read_to_string(file.path()).unwrap()));
        }
    }
    all.sort();
    all
}

/// The body of the first function that the student writes, replaced.
fn with_body(stub: &str, body: &str) -> String {
    stub.replacen("todo!()", body, 1)
}

fn hand_in(
    place: &Place,
    state: &str,
    student: &str,
    solutions: &[(String, String, String)],
    victim: &str,
    stub: &str,
) -> Status {
    let marked = |text: &str| format!("{text}{MARKER}\n");
    let right = |text: &str| marked(&text.replace("\nfn main() {}\n", "\n"));
    let exit = "std::process::exit(0)";
    let (changed, status) = match state {
        "stub" => (Some(stub.to_owned()), One("failed")),
        "syntax" => (
            Some(with_body(stub, "let let = ;")),
            One("does not compile"),
        ),
        "types" => (Some(with_body(stub, "\"text\"")), One("does not compile")),
        "loops" => (
            Some(with_body(stub, "loop { std::hint::black_box(1); }")),
            One("time limit"),
        ),
        "forged" => {
            let forged =
                format!("println!(\"test result: ok. 1 passed; 0 failed; 0 ignored\"); {exit}");
            (Some(with_body(stub, &forged)), One("failed"))
        }
        "exits" => (Some(with_body(stub, exit)), One("failed")),
        "child" => {
            let child = "std::mem::forget(std::process::Command::new(\"sleep\").arg(\"61.75\").spawn()); loop {}";
            (Some(with_body(stub, child)), One("time limit"))
        }
        "macros" => {
            let macros = "macro_rules! assert { ($($any:tt)*) => {}; }\nmacro_rules! panic { ($($any:tt)*) => {}; }\n";
            (Some(format!("{macros}{stub}")), One("failed"))
        }
        "memory" => {
            let memory = "let mut all = vec![]; loop { all.push(vec![0_u8; 1 << 26]); }";
            (Some(with_body(stub, memory)), One("failed"))
        }
        "link" => (None, One("link")),
        "missing" => (None, One("missing")),
        "link-all" => (None, All("link")),
        _ => (None, One("solved")),
    };
    let mut zip: Vec<(String, Vec<u8>)> = Vec::new();
    for (name, path, text) in solutions {
        let mut text = match (&changed, name == victim) {
            (Some(changed), true) => changed.clone(),
            _ => right(text),
        };
        let mut path = format!("in/{student}/{path}");
        match state {
            "link" | "missing" if name == victim => {
                #[cfg(unix)]
                if state == "link" {
                    fs::create_dir_all(place.path(&path).parent().unwrap()).unwrap();
                    std::os::unix::fs::symlink("/in/right-000", place.path(&path)).unwrap();
                }
                continue;
            }
            "link-all" => continue,
            "deleted-tests" => text = text.replace(MARKER, &format!("{MARKER}\nfn main() {{}}")),
            "changed-tests" => {
                text += "#[cfg(test)]\nmod mine {\n    #[test]\n    fn always() {}\n}\n"
            }
            "bom-crlf" => text = format!("\u{feff}{text}").replace('\n', "\r\n"),
            "no-marker" => text = text.replace(MARKER, ""),
            "flat" | "zip-flat" => path = format!("in/{student}/{name}.rs"),
            _ => {}
        }
        if state.starts_with("zip") {
            zip.push((
                path.replace(&format!("in/{student}/"), ""),
                text.into_bytes(),
            ));
        } else {
            place.write(&path, text.as_bytes());
        }
    }
    if state.starts_with("zip") {
        let files: Vec<(&str, &[u8])> = zip
            .iter()
            .map(|(path, bytes)| (path.as_str(), bytes.as_slice()))
            .collect();
        place.write(&format!("in/{student}.zip"), &zipped(&files));
    }
    #[cfg(unix)]
    if state == "link-all" {
        std::os::unix::fs::symlink("right-000", place.path(&format!("in/{student}"))).unwrap();
    }
    status
}
