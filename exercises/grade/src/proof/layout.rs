//! Whether the files of the set are what info.toml, Cargo.toml and rustlings expect.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use crate::crate_dir::rust_files;
use crate::exercise_file::{MARKER, count_markers, rejection, split, test_names};
use crate::join::join;
use crate::set::{Exercise, Set, read_text, split_bins};

/// The texts of one exercise.
#[derive(Debug)]
pub struct Sources {
    /// Its name.
    pub name: String,
    /// The tests that the stub must fail.
    pub fails: Vec<String>,
    /// All its tests.
    pub tests: Vec<String>,
    /// The part of the exercise above the marker line.
    pub stub: String,
    /// The file of the solution.
    pub solution: String,
    /// The tests: the exercise's file from the marker line on.
    pub below: String,
    /// Its stored wrong answers.
    pub wrong: Vec<Wrong>,
    /// Right answers that go another way than the solution.
    pub right: Vec<Right>,
}

/// A right answer that goes another way than the solution.
#[derive(Debug)]
pub struct Right {
    /// The name of its file, without `.rs`.
    pub file: String,
    /// Its text, which stands above the marker line.
    pub above: String,
}

impl Right {
    /// The name of its module in the generated crate.
    pub fn module(&self) -> String {
        format!("right_{}", self.file)
    }
}

/// A stored wrong answer.
#[derive(Debug)]
pub struct Wrong {
    /// The name of its file, without `.rs`.
    pub file: String,
    /// The test that must reject it.
    pub test: String,
    /// What the message must contain.
    pub phrase: String,
    /// Its text, which stands above the marker line.
    pub above: String,
}

impl Wrong {
    /// The name of its module in the generated crate.
    pub fn module(&self) -> String {
        format!("wrong_{}", self.file)
    }
}

impl Sources {
    /// Each variant's module and whole text.
    pub fn variants(&self) -> Vec<(String, String)> {
        let mut variants = vec![
            ("stub".to_owned(), join(&self.stub, &self.below)),
            ("solution".to_owned(), join(&self.solution, &self.below)),
        ];
        variants.extend(
            self.wrong
                .iter()
                .map(|wrong| (wrong.module(), join(&wrong.above, &self.below))),
        );
        variants.extend(
            self.right
                .iter()
                .map(|right| (right.module(), join(&right.above, &self.below))),
        );
        variants
    }
}

/// The exercises that can be read, and what is wrong with the set.
pub fn check(set: &Set) -> Result<(Vec<Sources>, Vec<String>), String> {
    let mut problems = Vec::new();
    if set.exercises.is_empty() {
        problems.push("info.toml lists no exercise".to_owned());
    }
    match split_bins(&set.manifest) {
        Some([_, list, _]) if list == set.bins() => {}
        Some(_) => problems.push(format!(
            "the bin list of Cargo.toml is out of step with info.toml (`rustlings dev update` writes it); \
             it must be:{}",
            set.bins()
        )),
        None => problems.push("Cargo.toml has no list `bin = [`".to_owned()),
    }
    check_stray_files(set, &mut problems)?;
    check_lock(set, &mut problems)?;
    let mut exercises = Vec::new();
    for exercise in &set.exercises {
        let before = problems.len();
        let sources = read_sources(set, exercise, &mut problems)?;
        if problems.len() == before {
            exercises.extend(sources);
        }
    }
    check_format(set, &mut problems)?;
    Ok((exercises, problems))
}

fn read_sources(
    set: &Set,
    exercise: &Exercise,
    problems: &mut Vec<String>,
) -> Result<Option<Sources>, String> {
    let name = &exercise.name;
    let mut problem = |sentence: String| problems.push(format!("{name}: {sentence}"));

    let hints = ["1. ", "2. ", "3. ", "4. "].map(|start| {
        exercise
            .hint
            .lines()
            .filter(|l| l.starts_with(start))
            .count()
    });
    if hints != [1, 1, 1, 0] {
        problem("its hint needs three paragraphs, `1. `, `2. `, `3. `: the idea, the step, nearly the code".into());
    }

    // The exercise: marker, entry point, a place for the answer.
    let stub_path = exercise.path();
    let (stub, solution) =
        match [&stub_path, &exercise.solution_path()].map(|path| read_text(&set.root.join(path))) {
            [Ok(stub), Ok(solution)] => (stub, solution),
            [stub, solution] => {
                [stub, solution]
                    .into_iter()
                    .filter_map(Result::err)
                    .for_each(problem);
                return Ok(None);
            }
        };
    let Some((above, below)) = split(&stub).filter(|_| count_markers(&stub) == 1) else {
        problem(format!(
            "the exercise must have the marker line once: {MARKER}"
        ));
        return Ok(None);
    };
    if count_markers(&solution) > 0 {
        problem("the solution has a marker line: it is only the part above it".into());
    }
    for (what, text) in [("exercise", &stub), ("solution", &solution)] {
        if !text.contains("\nfn main() {}\n") {
            problem(format!("the {what} has no line `fn main() {{}}`"));
        }
    }
    if !above.contains("// TODO") || !above.contains("todo!()") {
        problem(
            "the exercise needs a comment `// TODO` and a `todo!()` above the marker line".into(),
        );
    }
    if solution.contains("todo!") || solution.contains("// TODO") {
        problem("the solution still has a TODO".into());
    }
    let docs = |text: &str| {
        text.lines()
            .filter(|line| line.starts_with("///"))
            .map(str::to_owned)
            .collect::<Vec<_>>()
    };
    if docs(above) != docs(&solution) || docs(above).is_empty() {
        problem("exercise and solution need the same doc comment".into());
    }

    // The tests and which of them the stub fails.
    let tests = test_names(below);
    if tests.len() < 3 || !below.contains(&format!("#[cfg(test)]\nmod {name} {{\n")) {
        problem(format!(
            "it needs `mod {name}` with at least three tests: the slide's, one on no slide, an extreme"
        ));
    }
    if below.contains("use super::*") {
        problem(
            "its tests must import by name: `use super::*` relies on what a student imports".into(),
        );
    }
    if exercise.fails.is_empty() || exercise.fails.iter().any(|test| !tests.contains(test)) {
        problem(format!(
            "`fails` in info.toml must name tests of the file: {}",
            tests.join(", ")
        ));
    }

    let wrong = read_wrong(&set.root.join("wrong").join(name), &tests, &mut problem)?;
    let right = read_right(&set.root.join("right").join(name), &mut problem)?;
    Ok(Some(Sources {
        name: name.clone(),
        fails: exercise.fails.clone(),
        tests,
        below: below.to_owned(),
        stub: above.to_owned(),
        solution,
        wrong,
        right,
    }))
}

fn read_wrong(
    dir: &Path,
    tests: &[String],
    mut problem: impl FnMut(String),
) -> Result<Vec<Wrong>, String> {
    let mut wrong: Vec<Wrong> = Vec::new();
    for (file, above) in read_answers(dir, &mut problem)? {
        let Some(stated) = rejection(&above) else {
            problem(format!(
                "the first line of wrong answer {file} is not `// rejected by TEST: PHRASE`"
            ));
            continue;
        };
        if !tests.iter().any(|test| test == stated.test) {
            problem(format!(
                "wrong answer {file} names the test {}, which is not there",
                stated.test
            ));
        }
        if wrong.iter().any(|other| other.phrase == stated.phrase) {
            problem(format!(
                "wrong answer {file} is rejected by the phrase of another one: {}",
                stated.phrase
            ));
        }
        wrong.push(Wrong {
            test: stated.test.to_owned(),
            phrase: stated.phrase.to_owned(),
            file,
            above,
        });
    }
    if wrong.len() < 2 {
        problem(format!(
            "wrong answers in wrong/: {}, but at least 2 are asked for",
            wrong.len()
        ));
    }
    Ok(wrong)
}

/// The right answers, each with the way that it goes in its first line: `// right: WAY`.
fn read_right(dir: &Path, mut problem: impl FnMut(String)) -> Result<Vec<Right>, String> {
    let answers = read_answers(dir, &mut problem)?;
    let mut right = Vec::new();
    for (file, above) in answers {
        if !above.starts_with("// right: ") {
            problem(format!(
                "the first line of right answer {file} is not `// right: WAY`"
            ));
        }
        right.push(Right { file, above });
    }
    Ok(right)
}

/// The answers of a folder: each file's name and its text.
fn read_answers(
    dir: &Path,
    mut problem: impl FnMut(String),
) -> Result<Vec<(String, String)>, String> {
    let mut answers = Vec::new();
    for path in rust_files(dir)? {
        let file = path
            .file_stem()
            .unwrap_or_default()
            .to_string_lossy()
            .into_owned();
        if !file
            .chars()
            .all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_')
        {
            problem(format!(
                "the answer {file:?} is not named by lower-case letters, digits and underscores"
            ));
        }
        let above = read_text(&path)?;
        if count_markers(&above) > 0 {
            problem(format!(
                "the answer {file} has a marker line: it is only the part above it"
            ));
        }
        answers.push((file, above));
    }
    Ok(answers)
}

/// No `.rs` file may lie in the four folders but those of an exercise.
fn check_stray_files(set: &Set, problems: &mut Vec<String>) -> Result<(), String> {
    let known: BTreeSet<PathBuf> = set
        .exercises
        .iter()
        .flat_map(|e| [e.path(), e.solution_path()])
        .collect();
    for folder in ["exercises", "solutions", "wrong", "right"] {
        for file in rust_files(&set.root.join(folder))? {
            let inside = file.strip_prefix(&set.root).unwrap_or(&file);
            let of_an_exercise = |dir: &Path| {
                set.exercises.iter().any(|e| {
                    ["wrong", "right"]
                        .iter()
                        .any(|f| dir == Path::new(f).join(&e.name))
                })
            };
            if !known.contains(inside) && !inside.parent().is_some_and(of_an_exercise) {
                problems.push(format!(
                    "{} belongs to no exercise of info.toml",
                    inside.display()
                ));
            }
        }
    }
    Ok(())
}

/// The set's lock file has the versions that the workspace around it has.
fn check_lock(set: &Set, problems: &mut Vec<String>) -> Result<(), String> {
    let Some(workspace) = set
        .root
        .parent()
        .map(|dir| dir.join("Cargo.lock"))
        .filter(|lock| lock.is_file())
    else {
        return Ok(());
    };
    let versions = |path: &Path| -> Result<BTreeSet<(String, String)>, String> {
        let lock: toml::Table = read_text(path)?
            .parse()
            .map_err(|error| format!("{}: {error}", path.display()))?;
        let packages = lock
            .get("package")
            .and_then(toml::Value::as_array)
            .into_iter()
            .flatten();
        let text = |package: &toml::Value, key: &str| {
            package
                .get(key)
                .and_then(toml::Value::as_str)
                .map(str::to_owned)
        };
        Ok(packages
            .filter_map(|package| Some((text(package, "name")?, text(package, "version")?)))
            .collect())
    };
    let theirs = versions(&workspace)?;
    for (name, version) in versions(&set.root.join("Cargo.lock"))? {
        let mut same_name = theirs.iter().filter(|(other, _)| *other == name).peekable();
        if same_name.peek().is_some() && !same_name.any(|(_, other)| *other == version) {
            problems.push(format!(
                "Cargo.lock has {name} {version}, another version than the workspace's"
            ));
        }
    }
    Ok(())
}

fn check_format(set: &Set, problems: &mut Vec<String>) -> Result<(), String> {
    let mut files = Vec::new();
    for folder in ["exercises", "solutions", "wrong", "right", "assess"] {
        files.extend(rust_files(&set.root.join(folder))?);
    }
    let output = Command::new("rustfmt")
        .current_dir(&set.root)
        .args(["--check", "--edition", "2024", "--files-with-diff"])
        .args(files)
        .stdin(Stdio::null())
        .output()
        .map_err(|error| format!("cannot start rustfmt: {error}"))?;
    let listed: BTreeSet<_> = String::from_utf8_lossy(&output.stdout)
        .lines()
        .map(PathBuf::from)
        .collect();
    for file in listed {
        problems.push(format!(
            "{} is not formatted",
            file.strip_prefix(&set.root).unwrap_or(&file).display()
        ));
    }
    if !output.status.success() && !output.stderr.is_empty() {
        problems.push(format!(
            "rustfmt: {}",
            String::from_utf8_lossy(&output.stderr).trim_end()
        ));
    }
    Ok(())
}
