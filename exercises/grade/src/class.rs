//! A class in one command: submissions in, a table and feedback out.

mod submissions;

use std::collections::BTreeSet;
use std::fs;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;
use std::time::Duration;

use serde_json::Value;

use crate::answers::Answers;
use crate::grading::Course;
use crate::report::Report;
use crate::set::{Set, read_text};
use crate::whole;
use submissions::Submission;

/// Where a run keeps the students' programs; it is gone when the run ends.
const WORK: &str = ".work";

/// How a class is graded.
pub struct Options {
    /// The folder of the reports.
    pub out: PathBuf,
    /// How long the tests of one exercise may run.
    pub limit: Duration,
    /// How many students are graded at a time.
    pub jobs: NonZeroUsize,
}

/// Grades each submission below `path`, writes feedback for each student and the table class.csv; whether all could be
/// graded.
///
/// A student whose report stands already, from the same answers, tests and time limit, is not graded again.
pub fn grade(set: &Set, path: &Path, options: &Options) -> Result<bool, String> {
    let found = submissions::read(set, path)?;
    let students: Vec<&str> = found.iter().map(Submission::student).collect();
    let folders = folder_names(&students);
    let work = options.out.join(WORK);
    // A run that was broken off left it.
    let _ = fs::remove_dir_all(&work);
    let course = Course::prepare(set)?;

    let (next, done) = (AtomicUsize::new(0), Mutex::new((0, Vec::new())));
    let grade_next = || {
        while let Some((submission, folder)) = {
            let index = next.fetch_add(1, Ordering::Relaxed);
            found.get(index).zip(folders.get(index))
        } {
            let answers = submission.answers(set);
            let place = Place {
                out: options.out.join(folder),
                work: work.join(folder),
            };
            let said = one(&course, &answers, options.limit, &place);
            // A thread that panicked has added its line or has not: the count is whole either way.
            let mut done = done.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
            done.0 += 1;
            let line = said.as_ref().unwrap_or_else(|why| why);
            eprintln!("{} of {}  {}: {line}", done.0, found.len(), answers.student);
            if let Err(why) = said {
                done.1.push((answers.student.clone(), why));
            }
        }
    };
    thread::scope(|scope| {
        for _ in 0..options.jobs.get().min(found.len()) {
            scope.spawn(grade_next);
        }
    });
    let _ = fs::remove_dir_all(&work);

    let (_, failures) = done
        .into_inner()
        .unwrap_or_else(|poisoned| poisoned.into_inner());
    let table = table(set, &students, &folders, &failures, &options.out)?;
    let file = options.out.join("class.csv");
    whole::together(&[(&file, &table)]).map_err(|refused| refused.to_string())?;
    println!("{}", file.display());
    Ok(failures.is_empty())
}

/// Where a student's reports go, and where the programs are built.
struct Place {
    out: PathBuf,
    work: PathBuf,
}

/// Grades one student unless that is done already, and says how it went.
fn one(
    course: &Course,
    answers: &Answers,
    limit: Duration,
    place: &Place,
) -> Result<String, String> {
    let fingerprint = fingerprint(course, answers, limit);
    let summary = place.out.join("summary.json");
    let stands = |text: String| {
        let summary: Value = serde_json::from_str(&text).ok()?;
        let same = summary["fingerprint"] == format!("{fingerprint:016x}")
            && summary["student"] == answers.student;
        same.then(|| {
            format!(
                "{} of {} solved, graded before",
                summary["exercises_solved"], summary["exercises"]
            )
        })
    };
    if let Some(said) = fs::read_to_string(&summary).ok().and_then(stands) {
        return Ok(said);
    }
    fs::create_dir_all(&place.work)
        .map_err(|error| format!("cannot make {}: {error}", place.work.display()))?;
    let report = course.grade(answers, limit, &place.work);
    let written = report.and_then(|report| {
        write(&report, fingerprint, place)?;
        let [solved, exercises] = report.solved();
        Ok(format!("{solved} of {exercises} solved"))
    });
    let _ = fs::remove_dir_all(&place.work);
    written
}

/// Feedback, reports and pictures, in a folder of the student's own.
fn write(report: &Report, fingerprint: u64, place: &Place) -> Result<(), String> {
    // The pictures of an earlier grading show other answers.
    let pictures = place.out.join("pictures");
    let _ = fs::remove_dir_all(&pictures);
    let mut files: Vec<(PathBuf, Vec<u8>)> = Vec::new();
    let drawn = fs::read_dir(place.work.join("pictures"));
    for entry in drawn.into_iter().flatten().flatten() {
        let is_picture = entry
            .path()
            .extension()
            .is_some_and(|ending| ending == "svg")
            && entry.file_type().is_ok_and(|kind| kind.is_file());
        if is_picture && let Ok(bytes) = fs::read(entry.path()) {
            files.push((pictures.join(entry.file_name()), bytes));
        }
    }
    files.push((
        place.out.join("feedback.txt"),
        report.feedback().into_bytes(),
    ));
    files.push((place.out.join("junit.xml"), report.junit().into_bytes()));
    // The last one: whoever finds it finds the others.
    files.push((
        place.out.join("summary.json"),
        report.json(fingerprint).into_bytes(),
    ));
    let files: Vec<(&Path, &[u8])> = files
        .iter()
        .map(|(path, bytes)| (path.as_path(), bytes.as_slice()))
        .collect();
    whole::together(&files).map_err(|refused| refused.to_string())
}

/// A number for all that a report depends on. It may differ between versions of Rust, which then grade anew.
fn fingerprint(course: &Course, answers: &Answers, limit: Duration) -> u64 {
    let mut hasher = DefaultHasher::new();
    env!("CARGO_PKG_VERSION").hash(&mut hasher);
    course.tests().for_each(|test| test.hash(&mut hasher));
    limit.hash(&mut hasher);
    answers.hash(&mut hasher);
    hasher.finish()
}

/// A folder's name for each student that every system allows, no two the same even where upper and lower case are one.
fn folder_names(students: &[&str]) -> Vec<String> {
    let mut taken = BTreeSet::from(["class.csv".to_owned(), WORK.to_owned()]);
    let mut names = Vec::new();
    for student in students {
        let allowed = |c: char| !c.is_control() && !"/\\:*?\"<>|".contains(c);
        let plain: String = student
            .chars()
            .take(100)
            .map(|c| if allowed(c) { c } else { '_' })
            .collect();
        // A dot in front hides a folder, one at the end is lost on Windows; its devices have names of their own.
        let plain = plain.trim_matches(['.', ' ']);
        let device = plain
            .split('.')
            .next()
            .unwrap_or_default()
            .to_ascii_lowercase();
        let is_device = ["con", "prn", "aux", "nul"].contains(&device.as_str())
            || (device.len() == 4 && (device.starts_with("com") || device.starts_with("lpt")));
        let plain = if plain.is_empty() || is_device {
            format!("_{plain}")
        } else {
            plain.to_owned()
        };
        let mut name = plain.clone();
        let mut number = 1;
        while !taken.insert(name.to_lowercase()) {
            number += 1;
            name = format!("{plain}-{number}");
        }
        names.push(name);
    }
    names
}

/// A line for each student: the sums, and a column for each exercise with its status in a word.
fn table(
    set: &Set,
    students: &[&str],
    folders: &[String],
    failures: &[(String, String)],
    out: &Path,
) -> Result<Vec<u8>, String> {
    let sentence = |error: csv::Error| format!("class.csv: {error}");
    let mut writer = csv::Writer::from_writer(Vec::new());
    let exercises = set.exercises.iter().map(|exercise| exercise.name.as_str());
    let sums = [
        "student",
        "exercises solved",
        "tests passed",
        "tests",
        "folder",
    ];
    writer
        .write_record(sums.into_iter().chain(exercises.clone()).chain(["note"]))
        .map_err(sentence)?;
    for (student, folder) in students.iter().zip(folders) {
        let failure = failures.iter().find(|(name, _)| name == student);
        let record = match failure {
            Some((_, why)) => {
                let empty = std::iter::repeat_n(String::new(), 3);
                let mut record = vec![(*student).to_owned()];
                record.extend(empty);
                record.push(folder.clone());
                record.extend(exercises.clone().map(|_| "not graded".to_owned()));
                record.push(why.lines().next().unwrap_or_default().to_owned());
                record
            }
            None => {
                let file = out.join(folder).join("summary.json");
                let summary: Value = serde_json::from_str(&read_text(&file)?)
                    .map_err(|error| format!("{}: {error}", file.display()))?;
                row(student, folder, &summary, exercises.clone())
            }
        };
        writer.write_record(record).map_err(sentence)?;
    }
    writer
        .into_inner()
        .map_err(|error| format!("class.csv: {error}"))
}

fn row<'a>(
    student: &str,
    folder: &str,
    summary: &Value,
    exercises: impl Iterator<Item = &'a str>,
) -> Vec<String> {
    let number = |key: &str| summary[key].to_string();
    let topics = summary["topics"].as_array().into_iter().flatten();
    let results: Vec<&Value> = topics
        .flat_map(|topic| topic["results"].as_array().into_iter().flatten())
        .collect();
    let mut record = vec![
        student.to_owned(),
        number("exercises_solved"),
        number("tests_passed"),
        number("tests"),
        folder.to_owned(),
    ];
    record.extend(exercises.map(|name| {
        let result = results.iter().find(|result| result["name"] == name);
        let status = result.and_then(|result| result["status"].as_str());
        status.unwrap_or_default().to_owned()
    }));
    record.push(String::new());
    record
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn folders_have_names_of_their_own_on_every_system() {
        let students = [
            "Ann",
            "ann",
            "a/b",
            "a:b",
            "..",
            "",
            "nul",
            "COM1.x",
            "Žofie Nováková",
            "class.csv",
            ".work",
            "end. ",
        ];
        let names = folder_names(&students);
        assert_eq!(
            names,
            [
                "Ann",
                "ann-2",
                "a_b",
                "a_b-2",
                "_",
                "_-2",
                "_nul",
                "_COM1.x",
                "Žofie Nováková",
                "class.csv-2",
                "work",
                "end"
            ]
        );
    }
}
