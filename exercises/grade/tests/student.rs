//! A student's way: start, test, hint, update, as the README of the exercises shows it.

// A helper of a test is a test.
#![allow(clippy::unwrap_used)]

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

const NAME: &str = "math1_triangle_normal";
const FILE: &str = "exercises/math/math1_triangle_normal.rs";
const MARKER: &str = "// ---- tests: leave everything below as it is ----";

fn course() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// The folder of the built programs, the same in every run.
fn target() -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).join("student")
}

fn cargo(dir: &Path, arguments: &[&str]) -> Output {
    Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()))
        .current_dir(dir)
        .args(arguments)
        .env("CARGO_TARGET_DIR", target())
        .env("RUST_BACKTRACE", "0")
        .env_remove("RUSTFLAGS")
        .env_remove("CARGO_ENCODED_RUSTFLAGS")
        .env_remove("CARGO_BUILD_RUSTFLAGS")
        .env_remove("CARGO_MANIFEST_DIR")
        .output()
        .unwrap()
}

/// What a program printed, whether it went well or not.
fn text(output: &Output) -> String {
    String::from_utf8_lossy(&output.stdout).into_owned() + &String::from_utf8_lossy(&output.stderr)
}

#[track_caller]
fn said(output: &Output, code: i32, sentence: &str) {
    let text = text(output);
    assert_eq!(output.status.code(), Some(code), "{text}");
    assert!(text.contains(sentence), "{sentence}\n{text}");
}

/// A folder that goes when the test ends.
struct Place(PathBuf);

impl Place {
    fn new(name: &str) -> Self {
        let dir =
            std::env::temp_dir().join(format!("ombra-student-test-{name}-{}", std::process::id()));
        fs::create_dir_all(&dir).unwrap();
        Self(dir.canonicalize().unwrap())
    }

    fn copy(&self) -> PathBuf {
        self.0.join("my exercises")
    }
}

impl Drop for Place {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

fn has_git() -> bool {
    Command::new("git").arg("--version").output().is_ok()
}

#[test]
fn the_first_half_hour() {
    let place = Place::new("half-hour");
    let copy = place.copy();
    let to = copy.to_str().unwrap();
    let start = |to: &str| cargo(&course(), &["run", "--quiet", "--bin", "start", to]);
    said(&start(to), 0, "is your copy");
    for left_out in ["wrong", "right", "grade", "target"] {
        assert!(!copy.join(left_out).exists(), "{left_out}");
    }
    if has_git() {
        let git = |arguments: &[&str]| {
            let output = Command::new("git")
                .current_dir(&copy)
                .args(arguments)
                .output();
            text(&output.unwrap())
        };
        assert_eq!(git(&["log", "--format=%s"]), "The exercises as they are\n");
        assert_eq!(git(&["status", "--porcelain"]), "");
    }
    said(&start(to), 2, "is there already");
    said(&start("inside"), 2, "lies in the exercises themselves");
    said(&start("no/such/folder"), 2, "cannot be found");

    // The exercise fails, the right answer passes.
    let test = || cargo(&copy, &["test", "--bin", NAME]);
    said(&test(), 101, "not yet implemented");
    let stub = fs::read_to_string(copy.join(FILE)).unwrap();
    let answer = stub.replace("todo!()", "(b - a).cross(c - a)");
    fs::write(copy.join(FILE), &answer).unwrap();
    // The beginning of a name runs its tests.
    let some = cargo(&copy, &["test", "--bin", NAME, "math1"]);
    said(&some, 0, "4 passed; 0 failed");

    let hint = |more: &[&str]| {
        let hint = ["run", "--quiet", "--bin", "hint"];
        cargo(&copy, &[&hint[..], more].concat())
    };
    said(&hint(&["math1"]), 0, "hint 1 of 3");
    said(&hint(&["math1"]), 0, "hint 2 of 3");
    said(&hint(&["math1"]), 0, "hint 3 of 3");
    said(&hint(&["math1"]), 0, "That was the last one");
    said(&hint(&["math1", "1"]), 0, "hint 1 of 3");
    said(
        &hint(&[]),
        0,
        "math1_triangle_normal            3 of 3 hints shown",
    );
    said(
        &hint(&["raster9"]),
        2,
        "no exercise begins with \"raster9\"",
    );
    said(&hint(&["math"]), 2, "may be math1_triangle_normal, math2");
    said(
        &hint(&["math1", "4"]),
        2,
        "\"4\" is no hint of math1_triangle_normal: it has 1 to 3",
    );

    // What is below the marker is the course's, what is above it stays; a file that is gone comes again.
    let update = || cargo(&copy, &["run", "--quiet", "--bin", "update"]);
    said(&update(), 0, "up to date");
    let mine = answer.split(MARKER).next().unwrap();
    fs::write(copy.join(FILE), format!("{mine}{MARKER}\nfn main() {{}}\n")).unwrap();
    fs::remove_file(copy.join("exercises/math/math2_face_normal.rs")).unwrap();
    fs::write(
        copy.join("exercises/math/math4_spherical.rs"),
        "fn main() {}\n",
    )
    .unwrap();
    fs::write(copy.join("README.md"), "mine\n").unwrap();
    let output = update();
    said(&output, 0, "new tests: math1_triangle_normal");
    said(&output, 0, "new exercise: math2_face_normal");
    said(
        &output,
        0,
        "left as it is: math4_spherical, without the line",
    );
    said(&output, 0, "renewed: README.md");
    assert_eq!(fs::read_to_string(copy.join(FILE)).unwrap(), answer);
    let left = fs::read_to_string(copy.join("exercises/math/math4_spherical.rs")).unwrap();
    assert_eq!(left, "fn main() {}\n");
    fs::remove_file(copy.join("exercises/math/math4_spherical.rs")).unwrap();
    said(&update(), 0, "new exercise: math4_spherical");
    said(&update(), 0, "up to date");
    fs::remove_file(copy.join(".course.txt")).unwrap();
    said(&update(), 2, "does not say where the course is");
    let itself = cargo(&course(), &["run", "--quiet", "--bin", "update", "."]);
    said(&itself, 2, "this is the course itself");
}

#[test]
fn a_machine_without_git_and_one_that_git_does_not_know() {
    let place = Place::new("git");
    let built = cargo(&course(), &["build", "--quiet", "--bin", "start"]);
    assert!(built.status.success(), "{}", text(&built));
    let program = target()
        .join("debug")
        .join(format!("start{}", std::env::consts::EXE_SUFFIX));
    let start = |to: &str| {
        let mut command = Command::new(&program);
        command
            .arg(place.0.join(to))
            .env("CARGO_MANIFEST_DIR", course());
        command
    };

    let without = start("without").env("PATH", "").output().unwrap();
    said(
        &without,
        0,
        "It is not under git, which only rustlings' reset of an exercise needs: git is not installed",
    );
    assert!(place.0.join("without").join(FILE).is_file());

    if has_git() {
        let nowhere = place.0.join("no-such-file");
        let unknown = start("unknown")
            .env("GIT_CONFIG_GLOBAL", &nowhere)
            .env("GIT_CONFIG_SYSTEM", &nowhere)
            .output()
            .unwrap();
        said(&unknown, 0, "It is under git");
    }
}

#[test]
fn the_programs_pass_their_own_tests() {
    let own = ["test", "--lib", "--bin", "hint", "--bin", "update"];
    let output = cargo(&course(), &own);
    assert!(output.status.success(), "{}", text(&output));
}
