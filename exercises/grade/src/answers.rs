//! A student's answers, as they were handed in.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use crate::exercise_file::split;
use crate::report::Status;
use crate::set::{Exercise, Set};

/// An answer longer than this is no answer to an exercise.
const LARGEST_FILE: u64 = 1 << 20;

/// What a student handed in.
#[derive(Debug)]
pub struct Answers {
    /// Who it is.
    pub student: String,
    /// By exercise the student's part of the file, or why there is none; what is not here is missing.
    pub files: BTreeMap<String, Result<String, (Status, String)>>,
}

/// The answers of one student's folder.
pub fn of_folder(set: &Set, dir: &Path) -> Result<Answers, String> {
    let root = find_student(set, dir)?;
    let mut files = BTreeMap::new();
    for exercise in &set.exercises {
        let answer = read_answer(&root.join(exercise.path()));
        if !matches!(answer, Err((Status::Missing, _))) {
            files.insert(exercise.name.clone(), answer);
        }
    }
    Ok(Answers {
        student: dir.display().to_string(),
        files,
    })
}

/// The folder below which the student's `exercises/TOPIC/NAME.rs` lie.
pub fn find_student(set: &Set, dir: &Path) -> Result<PathBuf, String> {
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
    // Without the marker line all of it is the student's: the tests that count are ours anyway.
    Ok(split(&text)
        .map_or(text.as_str(), |(above, _)| above)
        .to_owned())
}
