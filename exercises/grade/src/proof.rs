//! The proof of every exercise: its stub fails, its solution passes, its wrong answers are rejected by name.
//!
//! All variants are modules of one generated crate, so that the whole set costs one compilation of its tests and
//! one run of clippy.

mod layout;

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use crate::build::{self, Built};
use crate::libtest::{self, Outcome};
use crate::set::Set;
use crate::{crate_dir, run};
#[cfg(test)]
use layout::Right;
use layout::{Sources, Wrong};

/// No test program of the course comes near this; it ends a proof in which something loops.
const TIME_LIMIT: Duration = Duration::from_secs(120);

/// A student reads no more lines than these.
const LONGEST_MESSAGE: usize = 10;

/// Proves the set, prints what was found, and says whether all of it holds.
pub fn prove(set: &Set) -> Result<bool, String> {
    let started = Instant::now();
    let (exercises, problems) = layout::check(set)?;
    if !problems.is_empty() {
        return Ok(fail(&problems));
    }

    // One crate of all variants.
    let dir = scratch_dir(set);
    let target = dir.join("target");
    crate_dir::prepare(&dir, set, "")?;
    generate(&dir.join("src"), &exercises)?;

    let tests = build::cargo(
        &dir,
        &target,
        &["test", "--no-run", "--workspace", "--lib"],
        &[],
    )?;
    if !tests.succeeded {
        return Ok(fail(&build_problems(
            &tests,
            "does not compile with warnings denied",
        )));
    }
    let clippy = ["clippy", "--workspace", "--lib", "--profile", "test"];
    let clippy = build::cargo(&dir, &target, &clippy, &["-D", "warnings"])?;
    let mut problems = Vec::new();
    if !clippy.succeeded {
        problems = build_problems(&clippy, "is not clippy-clean");
    }

    // One run of all tests.
    let mut outcomes = BTreeMap::new();
    for program in tests.programs.values() {
        let ended = run::start(program, &[], &dir, "", None)?.wait(TIME_LIMIT)?;
        outcomes.append(&mut libtest::outcomes(&ended.stdout));
        if ended.status.is_none() {
            problems.push(format!(
                "the tests ran longer than {} s and were stopped",
                TIME_LIMIT.as_secs()
            ));
        }
    }

    for exercise in &exercises {
        let before = problems.len();
        judge(exercise, &outcomes, &mut problems);
        if problems.len() == before {
            println!(
                "{:<32} stub fails {}, solution passes {}, answers rejected {}, accepted {}",
                exercise.name,
                exercise.fails.len(),
                exercise.tests.len(),
                exercise.wrong.len(),
                exercise.right.len(),
            );
        }
    }
    let of_an_exercise = |name: &str| {
        exercises
            .iter()
            .any(|e| name.starts_with(&format!("{}::", e.name)))
    };
    for (name, outcome) in outcomes.iter().filter(|(name, _)| !of_an_exercise(name)) {
        if let Outcome::Failed(message) = outcome {
            problems.push(format!(
                "a test of the exercises' library fails, {name}: {message}"
            ));
        }
    }
    if !problems.is_empty() {
        return Ok(fail(&problems));
    }
    println!(
        "exercises proved: {}, in {:.1} s",
        exercises.len(),
        started.elapsed().as_secs_f64()
    );
    Ok(true)
}

fn fail(problems: &[String]) -> bool {
    for problem in problems {
        eprintln!("not proved: {problem}");
    }
    let word = if problems.len() == 1 {
        "problem"
    } else {
        "problems"
    };
    eprintln!("{} {word}", problems.len());
    false
}

/// A folder of its own below the workspace's target folder, kept so that the next proof builds only what changed.
fn scratch_dir(set: &Set) -> PathBuf {
    let asked = std::env::var_os("CARGO_TARGET_DIR").map(PathBuf::from);
    // The set stands in a workspace, or alone as a copy.
    let workspace = set
        .root
        .parent()
        .filter(|dir| dir.join("Cargo.lock").is_file());
    let target = asked.filter(|dir| dir.is_absolute());
    let target = target.unwrap_or_else(|| workspace.unwrap_or(&set.root).join("target"));
    target.join("exercises-proof")
}

fn generate(src: &Path, exercises: &[Sources]) -> Result<(), String> {
    let mut lib =
        "//! Written by `ombra-grade prove`: every exercise as stub, solution and wrong answers.\n"
            .to_owned();
    lib += "#![deny(warnings)]\n#![allow(clippy::items_after_test_module)]\n";
    let mut written = BTreeSet::from([src.join("lib.rs")]);
    for exercise in exercises {
        lib += &format!("mod {} {{\n", exercise.name);
        for (module, text) in exercise.variants() {
            if module != "solution" {
                // Arguments that a body does not use yet are the one warning a stub may have.
                lib += "    #[cfg(not(clippy))]\n    #[allow(unused_variables)]\n";
            }
            lib += &format!("    mod {module};\n");
            let file = src.join(&exercise.name).join(format!("{module}.rs"));
            crate_dir::write(&file, &text)?;
            written.insert(file);
        }
        lib += "}\n";
    }
    crate_dir::write(&src.join("lib.rs"), &lib)?;
    for file in crate_dir::rust_files(src)? {
        if !written.contains(&file) {
            std::fs::remove_file(&file)
                .map_err(|error| format!("cannot remove {}: {error}", file.display()))?;
        }
    }
    Ok(())
}

/// What the compiler said, each with the file that it names; a line of its own so that it can be read.
fn build_problems(built: &Built, what: &str) -> Vec<String> {
    let name = |file: &str| match file
        .strip_prefix("src/")
        .and_then(|rest| rest.strip_suffix(".rs"))
    {
        Some(module) => format!("{} {what}", module.replacen('/', ", ", 1)),
        None => format!("{file} {what}"),
    };
    let complaints = built
        .complaints
        .iter()
        .filter(|complaint| !complaint.file.is_empty());
    let mut problems: Vec<String> = complaints
        .map(|c| format!("{}\n{}", name(&c.file), c.text))
        .collect();
    if problems.is_empty() {
        problems.push(format!("cargo fails:\n{}", built.cargo_said));
    }
    problems
}

fn judge(exercise: &Sources, outcomes: &BTreeMap<String, Outcome>, problems: &mut Vec<String>) {
    let name = &exercise.name;
    let outcome =
        |variant: &str, test: &str| outcomes.get(&format!("{name}::{variant}::{name}::{test}"));

    // The stub fails by its todo!() in the tests named for it and passes the others.
    for test in &exercise.tests {
        let named = exercise.fails.contains(test);
        match outcome("stub", test) {
            Some(Outcome::Failed(message)) if named && message.contains("not yet implemented") => {}
            Some(Outcome::Passed) if !named => {}
            Some(Outcome::Failed(message)) if named => problems.push(format!(
                "{name}: the stub fails in {test} not by its todo!(), but: {message}"
            )),
            Some(Outcome::Failed(_)) => {
                problems.push(format!(
                    "{name}: the stub fails in {test}, which `fails` does not name"
                ));
            }
            Some(Outcome::Passed) => problems.push(format!(
                "{name}: the stub passes {test}, which `fails` names"
            )),
            None => problems.push(format!("{name}: {test} reported nothing of the stub")),
        }
    }

    for test in &exercise.tests {
        match outcome("solution", test) {
            Some(Outcome::Passed) => {}
            Some(Outcome::Failed(message)) => {
                problems.push(format!("{name}: the solution fails {test}: {message}"));
            }
            None => problems.push(format!("{name}: {test} reported nothing of the solution")),
        }
    }

    for right in &exercise.right {
        for test in &exercise.tests {
            match outcome(&right.module(), test) {
                Some(Outcome::Passed) => {}
                Some(Outcome::Failed(message)) => problems.push(format!(
                    "{name}, right answer {}: {test} rejects it: {message}",
                    right.file
                )),
                None => problems.push(format!(
                    "{name}, right answer {}: {test} reported nothing",
                    right.file
                )),
            }
        }
    }

    for wrong in &exercise.wrong {
        for test in &exercise.tests {
            if let Some(Outcome::Failed(message)) = outcome(&wrong.module(), test)
                && message.lines().count() > LONGEST_MESSAGE
            {
                problems.push(format!(
                    "{name}, wrong answer {}: {test} takes {} lines, more than {LONGEST_MESSAGE}: {message}",
                    wrong.file,
                    message.lines().count()
                ));
            }
        }
        let Wrong {
            file, test, phrase, ..
        } = wrong;
        match outcome(&wrong.module(), test) {
            Some(Outcome::Failed(message)) if message.contains(phrase) => {}
            Some(Outcome::Failed(message)) => problems.push(format!(
                "{name}, wrong answer {file}: {test} rejects it without saying {phrase:?}, but: {message}"
            )),
            Some(Outcome::Passed) => {
                problems.push(format!("{name}, wrong answer {file}: {test} does not reject it"));
            }
            None => problems.push(format!("{name}, wrong answer {file}: {test} reported nothing")),
        }
        // A message that accuses of every mistake names none.
        for other in exercise.wrong.iter().filter(|other| other.file != *file) {
            for test in &exercise.tests {
                if let Some(Outcome::Failed(message)) = outcome(&wrong.module(), test)
                    && message.contains(&other.phrase)
                {
                    problems.push(format!(
                        "{name}, wrong answer {file}: {test} accuses it of the mistake of {}: {message}",
                        other.file
                    ));
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn exercise() -> Sources {
        let wrong = |file: &str, phrase: &str| Wrong {
            file: file.into(),
            test: "t".into(),
            phrase: phrase.into(),
            above: String::new(),
        };
        Sources {
            name: "e".into(),
            fails: vec!["t".into()],
            tests: vec!["t".into(), "always".into()],
            stub: String::new(),
            solution: String::new(),
            below: String::new(),
            right: vec![Right {
                file: "shift".into(),
                above: String::new(),
            }],
            wrong: vec![wrong("up", "upside down"), wrong("late", "too late")],
        }
    }

    fn proved() -> BTreeMap<String, Outcome> {
        let failed = |message: &str| Outcome::Failed(message.into());
        [
            ("stub::e::t", failed("not yet implemented")),
            ("stub::e::always", Outcome::Passed),
            ("solution::e::t", Outcome::Passed),
            ("solution::e::always", Outcome::Passed),
            ("right_shift::e::t", Outcome::Passed),
            ("right_shift::e::always", Outcome::Passed),
            ("wrong_up::e::t", failed("this is upside down")),
            ("wrong_late::e::t", failed("this is too late")),
        ]
        .map(|(name, outcome)| (format!("e::{name}"), outcome))
        .into()
    }

    #[test]
    fn what_holds_is_no_problem() {
        let mut problems = Vec::new();
        judge(&exercise(), &proved(), &mut problems);
        assert_eq!(problems, Vec::<String>::new());
    }

    #[test]
    fn each_way_of_failing_is_named() {
        let failed = |message: &str| Some(Outcome::Failed(message.into()));
        for (name, outcome, sentence) in [
            ("stub::e::t", Some(Outcome::Passed), "e: the stub passes t"),
            (
                "stub::e::t",
                failed("index out of range"),
                "not by its todo!()",
            ),
            ("stub::e::t", None, "t reported nothing of the stub"),
            (
                "stub::e::always",
                failed("not yet implemented"),
                "which `fails` does not name",
            ),
            (
                "solution::e::t",
                failed("off by one"),
                "the solution fails t: off by one",
            ),
            ("solution::e::t", None, "reported nothing of the solution"),
            (
                "right_shift::e::t",
                failed("no"),
                "right answer shift: t rejects it: no",
            ),
            (
                "right_shift::e::t",
                None,
                "right answer shift: t reported nothing",
            ),
            (
                "wrong_up::e::t",
                failed("upside down\n\n\n\n\n\n\n\n\n\n."),
                "wrong answer up: t takes 11 lines, more than 10",
            ),
            (
                "wrong_up::e::t",
                Some(Outcome::Passed),
                "wrong answer up: t does not reject it",
            ),
            (
                "wrong_up::e::t",
                failed("wrong"),
                "without saying \"upside down\", but: wrong",
            ),
            (
                "wrong_up::e::t",
                failed("upside down or too late"),
                "accuses it of the mistake of late",
            ),
            (
                "wrong_up::e::t",
                None,
                "wrong answer up: t reported nothing",
            ),
        ] {
            let mut outcomes = proved();
            match outcome {
                Some(outcome) => outcomes.insert(format!("e::{name}"), outcome),
                None => outcomes.remove(&format!("e::{name}")),
            };
            let mut problems = Vec::new();
            judge(&exercise(), &outcomes, &mut problems);
            assert_eq!(problems.len(), 1, "{name}: {problems:?}");
            assert!(problems[0].contains(sentence), "{name}: {problems:?}");
        }
    }
}
