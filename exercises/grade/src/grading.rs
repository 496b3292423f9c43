//! Grading: the pristine tests, run on the part of each file that is the student's.

use std::fs;
use std::path::{Path, PathBuf};
use std::time::Duration;

use crate::build::{self, Built};
use crate::crate_dir::{self, Scratch};
use crate::exercise_file::{MARKER, split, test_names};
use crate::report::{ExerciseResult, Report, Status, Test, Verdict};
use crate::set::{Exercise, Set, read_text};
use crate::{libtest, run, whole};

/// An answer longer than this is no answer to an exercise.
const LARGEST_FILE: u64 = 1 << 20;

/// Grades the student's files and writes junit.xml and summary.json into `out`.
pub fn grade(set: &Set, student_dir: &Path, out: &Path, limit: Duration) -> Result<(), String> {
    let student = find_student(set, student_dir)?;
    let out = out_dir(out, &student)?;

    // The student's part above, the pristine tests below.
    let scratch = Scratch::new()?;
    let mut bins = "\n".to_owned();
    let mut prepared = Vec::new();
    for exercise in &set.exercises {
        let pristine = read_text(&set.root.join(exercise.path()))?;
        let (_, below) = split(&pristine).ok_or_else(|| {
            format!(
                "{}: the line `{MARKER}` is missing",
                exercise.path().display()
            )
        })?;
        let answer = read_answer(&student.join(exercise.path()));
        if let Ok(above) = &answer {
            crate_dir::write(
                &scratch.path().join(exercise.path()),
                &format!("{above}{below}"),
            )?;
            let Exercise { name, topic, .. } = exercise;
            bins +=
                &format!("  {{ name = \"{name}\", path = \"exercises/{topic}/{name}.rs\" }},\n");
        }
        prepared.push((exercise, test_names(below), answer.err()));
    }
    crate_dir::prepare(scratch.path(), set, &bins)?;

    // A file that does not compile stops no other.
    let target = scratch.path().join("target");
    let built = build::cargo(
        scratch.path(),
        &target,
        &["build", "--tests", "--keep-going"],
        &[],
    )?;
    let mut results = Vec::new();
    for (exercise, names, unusable) in prepared {
        results.push(match unusable {
            Some((status, why)) => without_a_run(exercise, names, status, &why),
            None => run_or_complain(exercise, names, &built, scratch.path(), limit)?,
        });
    }

    let report = Report {
        student: student_dir.display().to_string(),
        time_limit: limit,
        results,
    };
    let (junit, summary) = (report.junit(), report.json());
    whole::together(&[
        (&out.join("junit.xml"), junit.as_bytes()),
        (&out.join("summary.json"), summary.as_bytes()),
    ])
    .map_err(|refused| refused.to_string())?;
    print!("{}", report.table());
    Ok(())
}

/// The folder below which the student's `exercises/TOPIC/NAME.rs` lie.
fn find_student(set: &Set, dir: &Path) -> Result<PathBuf, String> {
    if !dir.is_dir() {
        return Err(format!(
            "the student's folder {} is not a folder",
            dir.display()
        ));
    }
    let candidates = [dir.to_owned(), dir.join("exercises")];
    let holds_one = |root: &PathBuf| {
        set.exercises
            .iter()
            .any(|exercise| root.join(exercise.path()).is_file())
    };
    let found = candidates
        .iter()
        .find(|root| holds_one(root))
        .ok_or_else(|| {
            let example = set
                .exercises
                .first()
                .map(Exercise::path)
                .unwrap_or_default();
            format!(
                "{} holds no exercise of the set, such as {}",
                dir.display(),
                example.display()
            )
        })?;
    found
        .canonicalize()
        .map_err(|error| format!("cannot find {}: {error}", found.display()))
}

/// The report's folder as a full path, which must not lie in the student's tree: that is only read.
fn out_dir(out: &Path, student: &Path) -> Result<PathBuf, String> {
    if out.exists() && !out.is_dir() {
        return Err(format!(
            "--out {} is a file, but must be a folder",
            out.display()
        ));
    }
    let absolute =
        std::path::absolute(out).map_err(|error| format!("--out {}: {error}", out.display()))?;
    // What does not exist yet has no canonical path; the nearest folder above it has.
    let existing = absolute
        .ancestors()
        .find_map(|folder| Some((folder, folder.canonicalize().ok()?)));
    let full = match existing {
        Some((folder, canonical)) => {
            canonical.join(absolute.strip_prefix(folder).unwrap_or(Path::new("")))
        }
        None => absolute,
    };
    if full.starts_with(student) {
        return Err(format!(
            "--out {} lies in the student's folder, which is only read: name another one",
            out.display()
        ));
    }
    Ok(full)
}

/// The part of the student's file above the marker line.
fn read_answer(path: &Path) -> Result<String, (Status, String)> {
    let unreadable = |why: String| (Status::Unreadable, why);
    match fs::metadata(path) {
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => {
            return Err((Status::Missing, "the file is not there".to_owned()));
        }
        Err(error) => return Err(unreadable(format!("the file cannot be read: {error}"))),
        Ok(metadata) if !metadata.is_file() => {
            return Err(unreadable("this is not a file".to_owned()));
        }
        Ok(metadata) if metadata.len() > LARGEST_FILE => {
            return Err(unreadable(format!(
                "the file has {} bytes, at most {LARGEST_FILE} are read",
                metadata.len()
            )));
        }
        Ok(_) => {}
    }
    let text = fs::read_to_string(path)
        .map_err(|error| unreadable(format!("the file cannot be read: {error}")))?;
    let (above, _) = split(&text).ok_or_else(|| {
        unreadable(format!(
            "the line `{MARKER}` is missing, so the answer cannot be told from the tests"
        ))
    })?;
    Ok(above.to_owned())
}

fn without_a_run(
    exercise: &Exercise,
    names: Vec<String>,
    status: Status,
    why: &str,
) -> ExerciseResult {
    let error = |name| Test {
        name,
        verdict: Verdict::Error(why.to_owned()),
        time: Duration::ZERO,
    };
    ExerciseResult {
        name: exercise.name.clone(),
        topic: exercise.topic.clone(),
        status,
        tests: names.into_iter().map(error).collect(),
    }
}

fn run_or_complain(
    exercise: &Exercise,
    names: Vec<String>,
    built: &Built,
    dir: &Path,
    limit: Duration,
) -> Result<ExerciseResult, String> {
    let Some(program) = built.programs.get(&exercise.name) else {
        let complaints = built
            .complaints
            .iter()
            .filter(|complaint| complaint.target == exercise.name);
        let text: Vec<&str> = complaints
            .map(|complaint| complaint.text.as_str())
            .collect();
        // Without a complaint about this file the fault is not the student's.
        if text.is_empty() {
            return Err(format!(
                "cargo could not build {}:\n{}",
                exercise.name, built.cargo_said
            ));
        }
        return Ok(without_a_run(
            exercise,
            names,
            Status::DoesNotCompile,
            &text.concat(),
        ));
    };

    // Every test has a process of its own, so that one that loops or overflows the stack spoils no other.
    let mut running = Vec::new();
    for name in names {
        let one = format!("{}::{name}", exercise.name);
        running.push((
            name,
            run::start(program, &["--exact", &one, "--nocapture"], dir)?,
        ));
    }
    let mut tests = Vec::new();
    for (name, running) in running {
        let ended = running.wait(limit)?;
        tests.push(Test {
            name,
            time: ended.time,
            verdict: verdict(&ended, limit),
        });
    }
    let status = if tests.iter().all(|test| test.verdict == Verdict::Passed) {
        Status::Solved
    } else if tests
        .iter()
        .any(|test| matches!(test.verdict, Verdict::Stopped(_)))
    {
        Status::TimeLimit
    } else {
        Status::Failed
    };
    Ok(ExerciseResult {
        name: exercise.name.clone(),
        topic: exercise.topic.clone(),
        status,
        tests,
    })
}

fn verdict(ended: &run::Ended, limit: Duration) -> Verdict {
    match ended.status {
        None => Verdict::Stopped(format!(
            "stopped after {} s: does a loop never end?",
            limit.as_secs_f64()
        )),
        Some(status) if status.success() && libtest::one_passed(&ended.stdout) => Verdict::Passed,
        Some(status) => {
            Verdict::Failed(libtest::panic_message(&ended.stderr).unwrap_or_else(|| {
                format!(
                    "the program ended before its test did ({status})\n{}",
                    ended.stderr.trim()
                )
            }))
        }
    }
}
