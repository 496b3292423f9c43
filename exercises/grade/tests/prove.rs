//! `ombra-grade prove` on a small set, whole and with one thing after another broken.

// A helper of a test is a test.
#![allow(clippy::unwrap_used)]

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

const ANSWER: &str = "/// Twice x.
fn double(x: u32) -> u32 {
    BODY
}

// ---- tests: leave everything below as it is ----

fn main() {}

#[cfg(test)]
mod double {
    use super::double;

    #[test]
    fn slide() {
        assert_eq!(double(1), 2);
    }

    #[test]
    fn any() {
        for x in 3..9 {
            assert!(double(x) != x * x, \"{x}: this is the square\");
            assert!(double(x) != x, \"{x}: nothing was doubled\");
            assert_eq!(double(x), x + x);
        }
    }

    #[test]
    fn extreme() {
        assert_eq!(double(0), 0);
    }
}
";

const INFO: &str = "format_version = 1
[[exercises]]
name = 'double'
dir = 'sums'
fails = ['slide', 'any', 'extreme']
hint = '''
1. The idea.
2. The step.
3. Nearly the code.'''
";

const MANIFEST: &str = "bin = [
  { name = \"double\", path = \"exercises/sums/double.rs\" },
  { name = \"double_sol\", path = \"solutions/sums/double.rs\" },
]
[package]
name = \"small\"
edition = \"2024\"
[lints.rust]
dead_code = \"allow\"
[workspace]
";

/// The file of a solution: the answer, and the entry point of a program.
fn solution(body: &str) -> String {
    let (above, _) = ANSWER.split_once("// ---- tests").unwrap();
    above.replace("BODY", body) + "fn main() {}\n"
}

struct Set(PathBuf);

impl Set {
    fn new(name: &str) -> Self {
        let dir =
            std::env::temp_dir().join(format!("ombra-prove-test-{name}-{}", std::process::id()));
        let set = Self(dir);
        set.write("info.toml", INFO);
        set.write("Cargo.toml", MANIFEST);
        set.write(
            "Cargo.lock",
            "version = 4\n\n[[package]]\nname = \"small\"\nversion = \"0.0.0\"\n",
        );
        set.write(
            "exercises/sums/double.rs",
            &ANSWER.replace("BODY", "// TODO: once more.\n    todo!()"),
        );
        set.write("solutions/sums/double.rs", &solution("2 * x"));
        let right = "// right: by a sum\nfn double(x: u32) -> u32 {\n    x + x\n}\n";
        set.write("right/double/sum.rs", right);
        for (file, phrase, body) in [
            ("square", "this is the square", "x * x"),
            ("same", "nothing was doubled", "x"),
        ] {
            let text = format!(
                "// rejected by any: {phrase}\nfn double(x: u32) -> u32 {{\n    {body}\n}}\n"
            );
            set.write(&format!("wrong/double/{file}.rs"), &text);
        }
        set
    }

    fn path(&self, inside: &str) -> PathBuf {
        self.0.join(inside)
    }

    fn write(&self, inside: &str, text: &str) {
        let path = self.path(inside);
        fs::create_dir_all(path.parent().unwrap_or(Path::new(""))).unwrap();
        fs::write(path, text).unwrap();
    }

    fn prove(&self) -> Output {
        Command::new(env!("CARGO_BIN_EXE_ombra-grade"))
            .arg("--exercises")
            .arg(&self.0)
            .arg("prove")
            // The proof's own target folder then lies inside the set.
            .env_remove("CARGO_TARGET_DIR")
            .output()
            .unwrap()
    }
}

impl Drop for Set {
    fn drop(&mut self) {
        fs::remove_dir_all(&self.0).unwrap();
    }
}

#[test]
fn whole_set_and_wrong_answers() {
    let set = Set::new("whole");
    let output = set.prove();
    let said = String::from_utf8_lossy(&output.stdout);
    assert!(
        output.status.success(),
        "{said}{}",
        String::from_utf8_lossy(&output.stderr)
    );
    assert!(
        said.contains("stub fails 3, solution passes 3, answers rejected 2, accepted 1"),
        "{said}"
    );
    assert!(said.contains("exercises proved: 1,"), "{said}");

    for (file, text, sentence) in [
        (
            "solutions/sums/double.rs",
            solution("3 * x"),
            "the solution fails slide",
        ),
        (
            "solutions/sums/double.rs",
            solution("return 2 * x;"),
            "is not clippy-clean",
        ),
        (
            "exercises/sums/double.rs",
            ANSWER.replace("BODY", "// TODO\n    y + todo!()"),
            "double, stub does not compile",
        ),
        (
            "wrong/double/same.rs",
            "// rejected by any: nothing was doubled\nfn double(x: u32) -> u32 {\n    2 * x\n}\n"
                .to_owned(),
            "wrong answer same: any does not reject it",
        ),
        (
            "right/double/sum.rs",
            "// right: no\nfn double(x: u32) -> u32 {\n    x + 1\n}\n".to_owned(),
            "double, right answer sum: any rejects it",
        ),
    ] {
        let whole = fs::read_to_string(set.path(file)).unwrap();
        set.write(file, &text);
        let output = set.prove();
        let said = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(1), "{file}: {said}");
        assert!(said.contains(sentence), "{file}: {said}");
        set.write(file, &whole);
    }
}

#[test]
fn files_out_of_step() {
    let set = Set::new("files");
    for (file, from, to, sentence) in [
        (
            "info.toml",
            "2. The step.",
            "",
            "its hint needs three paragraphs",
        ),
        (
            "info.toml",
            "'slide', ",
            "'slip', ",
            "`fails` in info.toml must name tests of the file",
        ),
        ("info.toml", "sums", "other", "out of step with info.toml"),
        (
            "Cargo.toml",
            "double_sol",
            "double_solution",
            "out of step with info.toml",
        ),
        (
            "exercises/sums/double.rs",
            "// ---- tests",
            "// tests",
            "the exercise must have the marker line once",
        ),
        (
            "exercises/sums/double.rs",
            "fn main() {}\n",
            "",
            "the exercise has no line `fn main() {}`",
        ),
        (
            "exercises/sums/double.rs",
            "// TODO",
            "//",
            "needs a comment `// TODO`",
        ),
        (
            "exercises/sums/double.rs",
            "use super::double",
            "use super::*",
            "its tests must import by name",
        ),
        (
            "solutions/sums/double.rs",
            "fn main() {}",
            "// ---- tests: leave everything below as it is ----\nfn main() {}",
            "the solution has a marker line",
        ),
        (
            "solutions/sums/double.rs",
            "Twice x",
            "2x",
            "the same doc comment",
        ),
        (
            "solutions/sums/double.rs",
            "2 * x",
            "2*x",
            "is not formatted",
        ),
        (
            "wrong/double/same.rs",
            "rejected",
            "refused",
            "the first line of wrong answer same is not",
        ),
        (
            "right/double/sum.rs",
            "right",
            "correct",
            "the first line of right answer sum is not",
        ),
        (
            "wrong/double/same.rs",
            "by any",
            "by none",
            "names the test none, which is not there",
        ),
        (
            "wrong/double/same.rs",
            "nothing was doubled",
            "this is the square",
            "by the phrase of another one",
        ),
        (
            "wrong/double/same.rs",
            "}\n",
            "}\n// ---- tests: leave everything below as it is ----\n",
            "has a marker line",
        ),
    ] {
        let whole = fs::read_to_string(set.path(file)).unwrap();
        assert!(whole.contains(from), "{file} has no {from:?}");
        set.write(file, &whole.replacen(from, to, 1));
        let output = set.prove();
        let said = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(1), "{file}, {from:?}: {said}");
        assert!(said.contains(sentence), "{file}, {from:?}: {said}");
        set.write(file, &whole);
    }

    set.write("exercises/sums/stray.rs", "");
    set.write("wrong/gone/stray.rs", "");
    set.write("right/gone/stray.rs", "");
    fs::remove_file(set.path("wrong/double/same.rs")).unwrap();
    let said = String::from_utf8_lossy(&set.prove().stderr).replace('\\', "/");
    for sentence in [
        "exercises/sums/stray.rs belongs to no exercise",
        "wrong/gone/stray.rs belongs to no exercise",
        "right/gone/stray.rs belongs to no exercise",
        "wrong answers in wrong/: 1,",
    ] {
        assert!(said.contains(sentence), "{said}");
    }
}
