//! Grading: the pristine tests, run on the part of each file that is the student's.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::time::Duration;

use crate::answers::Answers;
use crate::compile::{Compiler, Complaint};
use crate::crate_dir::{self, Scratch};
use crate::exercise_file::{MARKER, split, test_module, test_names};
use crate::join::{join_file, without_tests};
use crate::report::{ExerciseResult, Report, Status, Test, Verdict};
use crate::set::{Exercise, Set, read_text};
use crate::{build, harness, libtest, run};

/// A student reads no more of what the compiler says of one file.
const COMPILER_LINES: usize = 60;

/// How many bytes a test may ask for; none of the course comes near it.
const MEMORY: u64 = 512 << 20;

/// How long after the time limit a test ends by itself.
const ALONE: Duration = Duration::from_secs(2);

/// What all students share, made once: the tests as functions, the compiled libraries that they use.
pub struct Course {
    exercises: Vec<Tests>,
    compiler: Compiler,
    /// Holds the libraries.
    _scratch: Scratch,
}

/// The tests of one exercise.
struct Tests {
    exercise: Exercise,
    names: Vec<String>,
    callable: String,
    /// How many lines stand between the marker line and the tests.
    lines_before: usize,
}

impl Tests {
    fn name(&self) -> &str {
        &self.exercise.name
    }

    /// The file of the answer with forward slashes, as every system takes them.
    fn answer_file(&self) -> String {
        format!("exercises/{}/{}.rs", self.exercise.topic, self.name())
    }

    fn tests_file(&self) -> String {
        format!("exercises/{}/{}", self.exercise.topic, self.tests_beside())
    }

    /// The same from the file of the answer.
    fn tests_beside(&self) -> String {
        format!("tests/{}.rs", self.name())
    }

    /// What the compiler says of the answer, as if the tests stood in its file.
    fn told(&self, complaints: Vec<Complaint>) -> String {
        let in_tests = complaints
            .first()
            .is_some_and(|first| first.file == self.tests_file());
        let said: String = complaints.into_iter().map(|c| c.text).collect();
        let mut said = without_tests(&said, self.name(), &self.tests_beside());
        // On Windows the compiler joins the folder of the tests by a backslash.
        let tests = self.tests_file();
        for tests in [tests.replace("/tests/", "\\tests/"), tests] {
            said = said.replace(&tests, &self.answer_file());
        }
        if in_tests {
            said.insert_str(
                0,
                "the tests want the names and parameters as the exercise gives them\n",
            );
        }
        first_lines(&said)
    }

    /// Each test as the command line names it, and its path from the module that holds the answer.
    fn paths(&self, module: &str) -> Vec<(String, String)> {
        let name = self.name();
        let path = |test: &String| {
            (
                format!("{name}::{test}"),
                format!("{module}::{name}::{test}"),
            )
        };
        self.names.iter().map(path).collect()
    }
}

impl Course {
    /// Reads the tests and compiles what they use.
    pub fn prepare(set: &Set) -> Result<Self, String> {
        let mut exercises = Vec::new();
        for exercise in &set.exercises {
            let pristine = read_text(&set.root.join(exercise.path()))?;
            let (_, below) = split(&pristine).ok_or_else(|| {
                format!(
                    "{}: the line `{MARKER}` is missing",
                    exercise.path().display()
                )
            })?;
            exercises.push(Tests {
                exercise: exercise.clone(),
                names: test_names(below),
                callable: harness::callable(below),
                lines_before: below.matches('\n').count()
                    - test_module(below).matches('\n').count(),
            });
        }

        let scratch = Scratch::new()?;
        crate_dir::prepare(scratch.path(), set, "")?;
        crate_dir::write(&scratch.path().join("src").join("lib.rs"), "")?;
        let target = scratch.path().join("target");
        let built = build::cargo(scratch.path(), &target, &["build"], &[])?;
        if !built.succeeded {
            return Err(format!(
                "cargo could not build what the tests use:\n{}",
                built.cargo_said
            ));
        }
        let used = set.dependencies()?;
        let externs = built
            .libraries
            .into_iter()
            .filter(|(name, _)| used.contains(name));
        Ok(Self {
            exercises,
            compiler: Compiler::new(externs.collect(), target.join("debug").join("deps")),
            _scratch: scratch,
        })
    }

    /// The names of all tests, for who wants to know whether they have changed.
    pub fn tests(&self) -> impl Iterator<Item = (&str, &str)> {
        self.exercises
            .iter()
            .map(|tests| (tests.name(), tests.callable.as_str()))
    }

    /// Grades a student's answers in the empty folder `work`. What failing tests drew lies in its `pictures` then.
    pub fn grade(&self, answers: &Answers, limit: Duration, work: &Path) -> Result<Report, String> {
        let compiled = self.compile(answers, work)?;
        let mut results = Vec::new();
        for tests in &self.exercises {
            results.push(match answers.files.get(tests.name()) {
                None => without_a_run(tests, Status::Missing, "the file is not there"),
                Some(Err((status, why))) => without_a_run(tests, *status, why),
                Some(Ok(_)) => match compiled.get(tests.name()) {
                    Some(Ok(program)) => run_tests(tests, &work.join(program), work, limit)?,
                    Some(Err(why)) => without_a_run(tests, Status::DoesNotCompile, why),
                    None => return Err(format!("nothing was compiled of {}", tests.name())),
                },
            });
        }
        Ok(Report {
            student: answers.student.clone(),
            time_limit: limit,
            results,
        })
    }

    /// By exercise the program that holds its tests, or what the compiler says.
    ///
    /// All answers are modules of one program. Those that do not compile are taken out and the rest is built again; each
    /// of them is then built alone, as the whole program that it was in the student's folder.
    fn compile(
        &self,
        answers: &Answers,
        work: &Path,
    ) -> Result<BTreeMap<String, Result<String, String>>, String> {
        let mut together = Vec::new();
        let mut alone = Vec::new();
        for tests in &self.exercises {
            let Some(Ok(answer)) = answers.files.get(tests.name()) else {
                continue;
            };
            let joined = join_file(answer, tests.name(), &tests.tests_beside());
            crate_dir::write(&work.join(tests.answer_file()), &joined)?;
            // The lines of the tests have the numbers that they have in the student's file.
            let above = answer.matches('\n').count() + tests.lines_before;
            let callable = format!("{}{}", "\n".repeat(above), tests.callable);
            crate_dir::write(&work.join(tests.tests_file()), &callable)?;
            // Macros that leave their module could reach the tests of other answers.
            if answer.contains("macro_use") {
                alone.push(tests);
            } else {
                together.push(tests);
            }
        }

        let mut compiled = BTreeMap::new();
        while !together.is_empty() {
            match self.compile_together(&together, work)? {
                Ok(()) => {
                    for tests in together.drain(..) {
                        compiled.insert(tests.name().to_owned(), Ok(PROGRAM.to_owned()));
                    }
                }
                Err(complaints) => {
                    let files: BTreeSet<&str> =
                        complaints.iter().map(|c| c.file.as_str()).collect();
                    let (blamed, rest): (Vec<_>, Vec<_>) = together.iter().partition(|tests| {
                        files.contains(tests.answer_file().as_str())
                            || files.contains(tests.tests_file().as_str())
                    });
                    // A complaint that names no answer may be about any.
                    let (blamed, rest) = if blamed.is_empty() {
                        (rest, blamed)
                    } else {
                        (blamed, rest)
                    };
                    alone.extend(blamed);
                    together = rest;
                }
            }
        }
        for tests in alone {
            compiled.insert(tests.name().to_owned(), self.compile_alone(tests, work)?);
        }
        Ok(compiled)
    }

    fn compile_together(
        &self,
        together: &[&Tests],
        work: &Path,
    ) -> Result<Result<(), Vec<Complaint>>, String> {
        let mut source = String::new();
        let mut paths = Vec::new();
        for tests in together {
            source += &format!(
                "#[path = \"{}\"]\nmod {};\n",
                tests.answer_file(),
                tests.name()
            );
            paths.extend(tests.paths(tests.name()));
        }
        source += &harness::main(&paths);
        crate_dir::write(&work.join("together.rs"), &source)?;
        self.compiler
            .compile(work, "bin", "together.rs", PROGRAM, &[])
    }

    fn compile_alone(&self, tests: &Tests, work: &Path) -> Result<Result<String, String>, String> {
        let name = tests.name();
        let library = format!("lib{name}.rlib");
        let source = tests.answer_file();
        let built = self
            .compiler
            .compile(work, "rlib", &source, &library, &[])?;
        if let Err(complaints) = built {
            return Ok(Err(tests.told(complaints)));
        }
        let main = format!("alone_{name}.rs");
        let program = format!("alone_{name}{}", std::env::consts::EXE_SUFFIX);
        crate_dir::write(&work.join(&main), &harness::main(&tests.paths("answer")))?;
        let answer = [("answer", library.as_str())];
        match self
            .compiler
            .compile(work, "bin", &main, &program, &answer)?
        {
            Ok(()) => Ok(Ok(program)),
            Err(complaints) => Ok(Err(tests.told(complaints))),
        }
    }
}

/// The program that holds all answers which compile side by side.
const PROGRAM: &str = if cfg!(windows) {
    "together.exe"
} else {
    "together"
};

fn first_lines(text: &str) -> String {
    let mut lines: Vec<&str> = text.lines().take(COMPILER_LINES).collect();
    let all = text.lines().count();
    let more = format!("… and {} lines more", all.saturating_sub(COMPILER_LINES));
    if all > COMPILER_LINES {
        lines.push(&more);
    }
    lines.join("\n")
}

fn without_a_run(tests: &Tests, status: Status, why: &str) -> ExerciseResult {
    let error = |name: &String| Test {
        name: name.clone(),
        verdict: Verdict::Error(why.to_owned()),
        time: Duration::ZERO,
    };
    ExerciseResult {
        name: tests.name().to_owned(),
        topic: tests.exercise.topic.clone(),
        status,
        tests: tests.names.iter().map(error).collect(),
    }
}

/// Every test has a process of its own, so that one that loops or overflows the stack spoils no other. All of an
/// exercise run side by side: the time limit is waited for once.
fn run_tests(
    tests: &Tests,
    program: &Path,
    work: &Path,
    limit: Duration,
) -> Result<ExerciseResult, String> {
    let (mut running, mut tokens) = (Vec::new(), Vec::new());
    // When we are gone, a test that loops ends by itself.
    let alone = (limit.as_secs() + ALONE.as_secs()).to_string();
    for name in &tests.names {
        let token = harness::token();
        let one = format!("{}::{name}", tests.name());
        running.push(run::start(
            program,
            &[&one, &alone],
            work,
            &token,
            Some(MEMORY),
        )?);
        tokens.push(token);
    }
    let mut results = Vec::new();
    let ended = run::wait_all(running, limit)?;
    for ((name, ended), token) in tests.names.iter().zip(ended).zip(tokens) {
        results.push(Test {
            name: name.clone(),
            time: ended.time,
            verdict: verdict(&ended, &token, limit),
        });
    }
    let status = if results.iter().all(|test| test.verdict == Verdict::Passed) {
        Status::Solved
    } else if results
        .iter()
        .any(|test| matches!(test.verdict, Verdict::Stopped(_)))
    {
        Status::TimeLimit
    } else {
        Status::Failed
    };
    Ok(ExerciseResult {
        name: tests.name().to_owned(),
        topic: tests.exercise.topic.clone(),
        status,
        tests: results,
    })
}

fn verdict(ended: &run::Ended, token: &str, limit: Duration) -> Verdict {
    let Some(status) = ended.status else {
        return Verdict::Stopped(format!(
            "stopped after {} s: does a loop never end?",
            limit.as_secs_f64()
        ));
    };
    let said = ended.stderr.trim();
    if status.success() && ended.stdout.contains(token) {
        return if ended.left_running {
            Verdict::Failed(
                "the test passed, but a program that it had started still ran: an answer starts no other program"
                    .to_owned(),
            )
        } else {
            Verdict::Passed
        };
    }
    Verdict::Failed(if said.contains("memory allocation of ") {
        format!(
            "more memory was asked for than the {} MiB of a test: does a loop collect without end?",
            MEMORY >> 20
        )
    } else if said.contains("has overflowed its stack") {
        "the stack overflowed: does a function call itself without end?".to_owned()
    } else if let Some(message) = libtest::panic_message(said) {
        message
    } else {
        format!("the program ended before its test did ({status}): an answer returns, it does not end the program\n{said}")
            .trim_end()
            .to_owned()
    })
}
