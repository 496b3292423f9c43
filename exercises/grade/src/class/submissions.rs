//! Who handed in what: the folder or zip that a learning platform gives.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use crate::answers::{self, Answers, Handed};
use crate::report::Status;
use crate::set::Set;

/// What one student handed in.
pub struct Submission {
    student: String,
    source: Source,
}

enum Source {
    /// A folder or a zip, read when its turn comes.
    Path(PathBuf),
    /// Files that were read with those of others.
    Files(Vec<Handed>),
    /// A link in the student's place.
    Link,
}

impl Submission {
    /// Whose it is.
    pub fn student(&self) -> &str {
        &self.student
    }

    /// Its answers; a submission that cannot be read has none, and says why.
    pub fn answers(&self, set: &Set) -> Answers {
        let student = &self.student;
        let link =
            "the submission is a link, and links are not followed: hand in the files themselves";
        match &self.source {
            Source::Files(files) => Answers::among(set, student, files),
            Source::Link => Answers::none(set, student, Status::Link, link),
            Source::Path(path) => Answers::of(set, student, path)
                .unwrap_or_else(|why| Answers::none(set, student, Status::Unreadable, &why)),
        }
    }
}

/// The submissions of a class, sorted by student.
pub fn read(set: &Set, path: &Path) -> Result<Vec<Submission>, String> {
    let by_student = if path.is_dir() {
        in_folder(set, path)?
    } else if answers::is_zip(&path.to_string_lossy()) && path.is_file() {
        in_zip(set, path)?
    } else {
        return Err(format!(
            "{} is neither a folder of submissions nor a zip of them",
            path.display()
        ));
    };
    if by_student.is_empty() {
        return Err(format!(
            "{} holds no submission: a folder or a zip for each student, or files such as NAME_{}.rs",
            path.display(),
            set.exercises
                .first()
                .map_or("EXERCISE", |exercise| &exercise.name)
        ));
    }
    let submission = |(student, source)| Submission { student, source };
    Ok(by_student.into_iter().map(submission).collect())
}

fn in_folder(set: &Set, dir: &Path) -> Result<BTreeMap<String, Source>, String> {
    if dir.join("info.toml").is_file() || dir.join("exercises").join("info.toml").is_file() {
        return Err(format!(
            "{} is one copy of the exercises, not a folder of submissions: `grade` grades one",
            dir.display()
        ));
    }
    let sentence = |error: std::io::Error| format!("cannot read {}: {error}", dir.display());
    let mut found = BTreeMap::new();
    let mut flat = Vec::new();
    for entry in fs::read_dir(dir).map_err(sentence)? {
        let entry = entry.map_err(sentence)?;
        let kind = entry.file_type().map_err(sentence)?;
        let name = entry.file_name().to_string_lossy().into_owned();
        let stem = name
            .rsplit_once('.')
            .map_or(name.as_str(), |(stem, _)| stem);
        if name.starts_with('.') || name == "__MACOSX" {
            continue;
        } else if kind.is_symlink() {
            add(&mut found, name, Source::Link);
        } else if kind.is_dir() {
            add(&mut found, name, Source::Path(entry.path()));
        } else if answers::is_zip(&name) {
            add(&mut found, stem.to_owned(), Source::Path(entry.path()));
        } else if name.ends_with(".rs") {
            flat.push(answers::read_file(&entry.path(), name));
        }
    }
    for (student, files) in by_file_name(set, flat) {
        add(&mut found, student, Source::Files(files));
    }
    Ok(found)
}

/// A folder and a zip of one name are two submissions.
fn add(found: &mut BTreeMap<String, Source>, student: String, source: Source) {
    let mut name = student.clone();
    let mut number = 1;
    while found.contains_key(&name) {
        number += 1;
        name = format!("{student} ({number})");
    }
    found.insert(name, source);
}

fn in_zip(set: &Set, path: &Path) -> Result<BTreeMap<String, Source>, String> {
    let bytes = answers::read_zip(path).map_err(|why| format!("{}: {why}", path.display()))?;
    let wanted = |path: &str| path.ends_with(".rs") || answers::is_zip(path);
    let mut files =
        answers::entries(&bytes, &wanted, 0).map_err(|why| format!("{}: {why}", path.display()))?;

    // One folder around all the submissions is none itself: below it are only folders and zips.
    let around = files
        .first()
        .and_then(|file| Some(file.path.split_once('/')?.0.to_owned()));
    if let Some(around) = around.map(|folder| format!("{folder}/")) {
        let is_around = files.iter().all(|file| {
            file.path.strip_prefix(&around).is_some_and(|inside| {
                let first = inside.split('/').next().unwrap_or_default();
                let is_folder =
                    inside.contains('/') && !["exercises", "src", "assess"].contains(&first);
                let of_no_topic = set.exercises.iter().all(|exercise| exercise.topic != first);
                (is_folder && of_no_topic) || answers::is_zip(inside)
            })
        });
        if is_around {
            for file in &mut files {
                file.path = file.path.split_off(around.len());
            }
        }
    }

    let mut folders: BTreeMap<String, Vec<Handed>> = BTreeMap::new();
    let mut flat = Vec::new();
    let mut found = BTreeMap::new();
    for file in files {
        match file.path.split_once('/') {
            Some((student, inside)) => {
                let (student, path) = (student.to_owned(), inside.to_owned());
                folders
                    .entry(student)
                    .or_default()
                    .extend(opened(Handed { path, ..file }));
            }
            None if answers::is_zip(&file.path) => {
                let student = file
                    .path
                    .get(..file.path.len() - ".zip".len())
                    .unwrap_or_default();
                add(
                    &mut found,
                    student.to_owned(),
                    Source::Files(opened(file.clone())),
                );
            }
            None => flat.push(file),
        }
    }
    for (student, files) in folders.into_iter().chain(by_file_name(set, flat)) {
        add(&mut found, student, Source::Files(files));
    }
    Ok(found)
}

/// The files of a zip within the zip; another file is itself.
fn opened(file: Handed) -> Vec<Handed> {
    match &file.content {
        Ok(bytes) if answers::is_zip(&file.path) => match answers::zip(bytes) {
            Ok(files) => files,
            // It stands for any file that may have been in it.
            Err(why) => vec![Handed {
                content: Err((Status::Unreadable, format!("{}: {why}", file.path))),
                ..file
            }],
        },
        _ => vec![file],
    }
}

/// Files of all students in one folder, `smithann_12345_67890_math1_triangle_normal.rs`: by what stands before the
/// first group of digits, or before the exercise's name. Of several for an exercise, `…-1.rs`, `…-2.rs`, the last one.
fn by_file_name(set: &Set, files: Vec<Handed>) -> BTreeMap<String, Vec<Handed>> {
    let mut students: BTreeMap<String, BTreeMap<String, (u32, Handed)>> = BTreeMap::new();
    for file in files {
        let stem = file.path.strip_suffix(".rs").unwrap_or(&file.path);
        let (stem, number) = match stem.rsplit_once('-') {
            Some((stem, number)) => match number.parse() {
                Ok(number) => (stem, number),
                Err(_) => continue,
            },
            None => (stem, 0),
        };
        let names = set.exercises.iter().map(|exercise| exercise.name.as_str());
        let Some((name, before)) = names
            .filter_map(|name| Some((name, stem.strip_suffix(name)?)))
            .next()
        else {
            continue;
        };
        let student = student_of(before);
        let path = format!("{name}.rs");
        let answers = students.entry(student).or_default();
        let is_later = answers.get(name).is_none_or(|(other, _)| number >= *other);
        if is_later {
            answers.insert(name.to_owned(), (number, Handed { path, ..file }));
        }
    }
    let files = |answers: BTreeMap<String, (u32, Handed)>| {
        answers.into_values().map(|(_, file)| file).collect()
    };
    students
        .into_iter()
        .map(|(student, answers)| (student, files(answers)))
        .collect()
}

fn student_of(before: &str) -> String {
    let parts: Vec<&str> = before.split('_').collect();
    let is_mark = |part: &&str| {
        part.is_empty()
            || part.eq_ignore_ascii_case("late")
            || part.chars().all(|c| c.is_ascii_digit())
    };
    let name = parts.iter().take_while(|part| !is_mark(part));
    let name = name.copied().collect::<Vec<_>>().join("_");
    if name.is_empty() {
        "no name".to_owned()
    } else {
        name
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_ends_before_the_numbers() {
        for (before, student) in [
            ("smithann_12345_67890_", "smithann"),
            ("smithann_LATE_12345_67890_", "smithann"),
            ("ann_smith_", "ann_smith"),
            ("ann", "ann"),
            ("", "no name"),
            ("12_", "no name"),
        ] {
            assert_eq!(student_of(before), student, "{before:?}");
        }
    }
}
