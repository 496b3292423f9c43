//! Proof and grading of the exercises.
//!
//! `prove` shows of every exercise that its stub fails, its solution passes and its stored wrong answers are
//! rejected by a message that names the mistake. `grade` runs the pristine tests on a student's answers.

mod build;
mod crate_dir;
mod exercise_file;
mod grading;
mod join;
mod libtest;
mod proof;
mod report;
mod run;
mod set;
// One way to write files for the whole course; a dependency on the drawing kit would cost minutes of compiling.
#[path = "../../../crates/figures/src/whole.rs"]
mod whole;

use std::path::PathBuf;
use std::process::ExitCode;
use std::time::Duration;

use clap::{Parser, Subcommand};

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
        /// The student's copy of the exercises; it is only read
        student_dir: PathBuf,
        /// The folder that gets junit.xml and summary.json
        #[arg(long, value_name = "DIR")]
        out: PathBuf,
        /// How long the tests of one exercise may run, from 0.1 to 3600 seconds
        #[arg(long, value_name = "SECONDS", default_value = "10", value_parser = seconds)]
        time_limit: Duration,
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
        } => match grading::grade(&set, &student_dir, &out, time_limit) {
            Ok(()) => ExitCode::SUCCESS,
            Err(sentence) => bad_input(&sentence),
        },
    }
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
