//! Proof and grading of the exercises.
//!
//! `prove` shows of every exercise that its stub fails, its solution passes and its stored wrong answers are
//! rejected by a message that names the mistake. `grade` runs the pristine tests on a student's answers.

mod answers;
mod build;
mod class;
mod compile;
mod crate_dir;
mod exercise_file;
mod grading;
mod harness;
mod join;
mod libtest;
mod proof;
mod report;
mod run;
mod set;
// The students' programs part a file by the same line.
#[path = "../../src/marker.rs"]
mod marker;
// One way to write files for the whole course; a dependency on the drawing kit would cost minutes of compiling.
#[path = "../../../crates/figures/src/whole.rs"]
mod whole;

use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Duration;

use answers::Answers;
use clap::{Parser, Subcommand};
use grading::Course;

#[derive(Parser)]
#[command(name = "ombra-grade", about, version)]
struct Arguments {
    /// The folder of the exercises, which holds info.toml
    #[arg(long, global = true, value_name = "DIR")]
    exercises: Option<PathBuf>,
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Prove every exercise: stub, solution, wrong answers
    Prove,
    /// Run the pristine tests on a student's answers, write junit.xml and summary.json
    Grade {
        /// The student's copy of the exercises, a folder or a zip; it is only read
        student_dir: PathBuf,
        /// The folder that gets junit.xml and summary.json
        #[arg(long, value_name = "DIR")]
        out: PathBuf,
        /// How long the tests of one exercise may run, from 0.1 to 3600 seconds
        #[arg(long, value_name = "SECONDS", default_value = "10", value_parser = seconds)]
        time_limit: Duration,
    },
    /// Grade a class: write class.csv, and feedback and reports for each student
    ///
    /// A run that was broken off is taken up by the same command: who is graded is not graded again.
    Class {
        /// A folder or a zip: of a folder or a zip for each student, or of files STUDENT_EXERCISE.rs
        submissions: PathBuf,
        /// The folder that gets class.csv and a folder for each student
        #[arg(long, value_name = "DIR")]
        out: PathBuf,
        /// How long the tests of one exercise may run, from 0.1 to 3600 seconds
        #[arg(long, value_name = "SECONDS", default_value = "10", value_parser = seconds)]
        time_limit: Duration,
        /// How many students are graded at a time; as many as there are processors if not given
        #[arg(long, value_name = "N")]
        jobs: Option<NonZeroUsize>,
    },
}

fn seconds(text: &str) -> Result<Duration, String> {
    match text.parse::<f64>() {
        Ok(seconds) if (0.1..=3600.0).contains(&seconds) => Ok(Duration::from_secs_f64(seconds)),
        _ => Err("a time limit is a number of seconds from 0.1 to 3600".to_owned()),
    }
}

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    let set = match set::Set::read(&exercises_dir(arguments.exercises)) {
        Ok(set) => set,
        Err(sentence) => return bad_input(&sentence),
    };
    match arguments.command {
        Command::Prove => match proof::prove(&set) {
            Ok(true) => ExitCode::SUCCESS,
            Ok(false) => ExitCode::FAILURE,
            Err(sentence) => bad_input(&sentence),
        },
        Command::Grade {
            student_dir,
            out,
            time_limit,
        } => match grade(&set, &student_dir, &out, time_limit) {
            Ok(()) => ExitCode::SUCCESS,
            Err(sentence) => bad_input(&sentence),
        },
        Command::Class {
            submissions,
            out,
            time_limit,
            jobs,
        } => {
            let graded = out_dir(&out, &submissions).and_then(|out| {
                let jobs = jobs.or_else(|| std::thread::available_parallelism().ok());
                let options = class::Options {
                    out,
                    limit: time_limit,
                    jobs: jobs.unwrap_or(NonZeroUsize::MIN),
                };
                class::grade(&set, &submissions, &options)
            });
            match graded {
                Ok(true) => ExitCode::SUCCESS,
                Ok(false) => ExitCode::FAILURE,
                Err(sentence) => bad_input(&sentence),
            }
        }
    }
}

/// Grades one student and writes junit.xml and summary.json into `out`.
fn grade(set: &set::Set, student: &Path, out: &Path, limit: Duration) -> Result<(), String> {
    let answers = Answers::of(set, &student.display().to_string(), student)?;
    if answers.files.is_empty() {
        let example = set.exercises.first().map(set::Exercise::path);
        return Err(format!(
            "{} holds no exercise of the set, such as {}",
            student.display(),
            example.unwrap_or_default().display()
        ));
    }
    let out = out_dir(out, student)?;
    let course = Course::prepare(set)?;
    let scratch = crate_dir::Scratch::new()?;
    let report = course.grade(&answers, limit, scratch.path())?;
    whole::together(&[
        (&out.join("junit.xml"), report.junit().as_bytes()),
        (&out.join("summary.json"), report.json(0).as_bytes()),
    ])
    .map_err(|refused| refused.to_string())?;
    print!("{}", report.table());
    Ok(())
}

/// The report's folder as a full path, which must not lie in what is graded: that is only read.
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
    if student
        .canonicalize()
        .is_ok_and(|student| full.starts_with(student))
    {
        return Err(format!(
            "--out {} lies in {}, which is only read: name another one",
            out.display(),
            student.display()
        ));
    }
    Ok(full)
}

fn bad_input(sentence: &str) -> ExitCode {
    eprintln!("error: {sentence}");
    ExitCode::from(2)
}

/// The folder asked for, else the one `cargo run` was started on, else one in or at the current folder.
fn exercises_dir(asked: Option<PathBuf>) -> PathBuf {
    let beside_the_package = || {
        let package = PathBuf::from(std::env::var_os("CARGO_MANIFEST_DIR")?);
        Some(package.parent()?.to_owned())
    };
    let here = || {
        PathBuf::from(if PathBuf::from("info.toml").is_file() {
            "."
        } else {
            "exercises"
        })
    };
    asked.or_else(beside_the_package).unwrap_or_else(here)
}
