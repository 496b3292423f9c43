//! A student's answers, as they were handed in: a folder or a zip, the files flat or nested.

use std::collections::BTreeMap;
use std::fs;
use std::io::{Cursor, Read};
use std::path::Path;

use crate::exercise_file::split;
use crate::report::Status;
use crate::set::{Exercise, Set};

/// An answer longer than this is no answer to an exercise.
const LARGEST_FILE: u64 = 1 << 20;
/// A zip that holds more than answers: as large as this.
const LARGEST_ZIP: u64 = 256 << 20;
/// A zip of more files than these is no submission.
const MOST_ENTRIES: usize = 10_000;

/// Folders in which no answer lies: what comes with the exercises, what cargo, git and macOS make.
const PASSED_OVER: [&str; 7] = [
    ".git",
    "__MACOSX",
    "grade",
    "right",
    "solutions",
    "target",
    "wrong",
];

/// What a student handed in.
#[derive(Debug, Hash)]
pub struct Answers {
    /// Who it is.
    pub student: String,
    /// By exercise the student's part of the file, or why there is none; what is not here is missing.
    pub files: BTreeMap<String, Result<String, (Status, String)>>,
}

/// One file of a submission.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Handed {
    /// Its path within the submission, with forward slashes.
    pub path: String,
    /// Its content, or why it is not read.
    pub content: Result<Vec<u8>, (Status, String)>,
}

impl Handed {
    fn name(&self) -> &str {
        self.path.rsplit('/').next().unwrap_or_default()
    }

    fn unreadable(path: String, why: String) -> Self {
        Self {
            path,
            content: Err((Status::Unreadable, why)),
        }
    }

    /// A link, whatever it leads to: a classmate's answer would be a right one.
    fn link(path: String, what: &str) -> Self {
        let why = format!("{what} is a link, and links are not followed: hand in the file itself");
        Self {
            path,
            content: Err((Status::Link, why)),
        }
    }
}

impl Answers {
    /// The answers among the files of a submission.
    pub fn among(set: &Set, student: &str, handed: &[Handed]) -> Self {
        let mut files = BTreeMap::new();
        for exercise in &set.exercises {
            files.extend(answer(exercise, handed).map(|found| (exercise.name.clone(), found)));
        }
        Self {
            student: student.to_owned(),
            files,
        }
    }

    /// No exercise can be graded, all for one reason.
    pub fn none(set: &Set, student: &str, status: Status, why: &str) -> Self {
        let no_answer = |exercise: &Exercise| {
            let why = (status, why.to_owned());
            (exercise.name.clone(), Err(why))
        };
        Self {
            student: student.to_owned(),
            files: set.exercises.iter().map(no_answer).collect(),
        }
    }

    /// The answers of one student's folder or zip.
    pub fn of(set: &Set, student: &str, path: &Path) -> Result<Self, String> {
        let handed = if path.is_dir() {
            folder(path)?
        } else if is_zip(&path.to_string_lossy()) && path.is_file() {
            zip(&read_zip(path)?)?
        } else {
            return Err(format!("{} is neither a folder nor a zip", path.display()));
        };
        Ok(Self::among(set, student, &handed))
    }
}

/// The student's part of an exercise's file, or why it cannot be had; `None` where nothing of that name is there.
fn answer(exercise: &Exercise, handed: &[Handed]) -> Option<Result<String, (Status, String)>> {
    let name = format!("{}.rs", exercise.name);
    let place = format!("exercises/{}/{name}", exercise.topic);
    let (mut in_place, mut elsewhere) = (Vec::new(), Vec::new());
    for file in handed.iter().filter(|file| file.name() == name) {
        let is_in_place = file.path == place || file.path.ends_with(&format!("/{place}"));
        let rank = if is_in_place {
            &mut in_place
        } else {
            &mut elsewhere
        };
        rank.push(file);
    }
    let mut found = if in_place.is_empty() {
        elsewhere
    } else {
        in_place
    };
    found.dedup_by(|a, b| a.content == b.content);
    match found.as_slice() {
        [] => {
            // The file may lie in what a link leads to.
            let linked = handed.iter().find(|file| {
                matches!(file.content, Err((Status::Link, _))) && !file.name().ends_with(".rs")
            })?;
            Some(linked.content.clone().map(|_| String::new()))
        }
        [one] => Some(one.content.clone().and_then(|bytes| students_part(&bytes))),
        [one, another, ..] => Some(Err((
            Status::Unreadable,
            format!(
                "two different files claim to be the answer: {} and {}",
                one.path, another.path
            ),
        ))),
    }
}

/// What stands above the marker line. Without the line all of it is the student's: the tests that count are ours anyway.
fn students_part(bytes: &[u8]) -> Result<String, (Status, String)> {
    let text = std::str::from_utf8(bytes).map_err(|error| {
        let why = format!(
            "the file is not text in UTF-8: byte {} is {:#04x}",
            error.valid_up_to(),
            bytes.get(error.valid_up_to()).copied().unwrap_or_default()
        );
        (Status::Unreadable, why)
    })?;
    Ok(split(text).map_or(text, |(above, _)| above).to_owned())
}

/// Whether a file's name is that of a zip.
pub fn is_zip(name: &str) -> bool {
    let ending = name.rsplit('.').next().unwrap_or_default();
    ending.eq_ignore_ascii_case("zip")
}

fn is_passed_over(folder: &str) -> bool {
    PASSED_OVER.contains(&folder)
}

/// The Rust files of a folder and all below, and of the zips in it. Links are told, not followed.
pub fn folder(dir: &Path) -> Result<Vec<Handed>, String> {
    let mut files = Vec::new();
    let mut folders = vec![(dir.to_owned(), String::new())];
    while let Some((full, inside)) = folders.pop() {
        let sentence = |error: std::io::Error| format!("cannot read {}: {error}", full.display());
        for entry in fs::read_dir(&full).map_err(sentence)? {
            let entry = entry.map_err(sentence)?;
            let kind = entry.file_type().map_err(sentence)?;
            let name = entry.file_name().to_string_lossy().into_owned();
            let path = format!("{inside}{name}");
            if is_passed_over(&name) {
                continue;
            }
            if kind.is_symlink() {
                files.push(Handed::link(path.clone(), &path));
            } else if kind.is_dir() && name.ends_with(".rs") {
                files.push(Handed::unreadable(
                    path,
                    "this is a folder, not a file".to_owned(),
                ));
            } else if kind.is_dir() {
                folders.push((entry.path(), format!("{path}/")));
            } else if name.ends_with(".rs") {
                files.push(read_file(&entry.path(), path));
            } else if is_zip(&name) {
                let read = read_zip(&entry.path()).and_then(|bytes| zip(&bytes));
                let inner = read.map_err(|why| format!("{path}: {why}"))?;
                files.extend(inner.into_iter().map(|file| Handed {
                    path: format!("{path}/{}", file.path),
                    ..file
                }));
            }
        }
    }
    files.sort_by(|a, b| a.path.cmp(&b.path));
    Ok(files)
}

/// A file as it was handed in.
pub fn read_file(file: &Path, path: String) -> Handed {
    let content = match fs::metadata(file) {
        Ok(metadata) if metadata.len() > LARGEST_FILE => Err(too_large(metadata.len())),
        Ok(_) => fs::read(file).map_err(|error| format!("the file cannot be read: {error}")),
        Err(error) => Err(format!("the file cannot be read: {error}")),
    };
    Handed {
        path,
        content: content.map_err(|why| (Status::Unreadable, why)),
    }
}

fn too_large(bytes: u64) -> String {
    format!("the file has {bytes} bytes, at most {LARGEST_FILE} are read")
}

/// The bytes of a zip.
pub fn read_zip(path: &Path) -> Result<Vec<u8>, String> {
    let sentence = |error: std::io::Error| format!("the zip cannot be read: {error}");
    let length = fs::metadata(path).map_err(sentence)?.len();
    if length > LARGEST_ZIP {
        return Err(format!(
            "the zip has {length} bytes, at most {LARGEST_ZIP} are read"
        ));
    }
    fs::read(path).map_err(sentence)
}

/// The Rust files of a zip, read in memory: nothing is unpacked on the disk.
pub fn zip(bytes: &[u8]) -> Result<Vec<Handed>, String> {
    Ok(
        entries(bytes, &|path| path.ends_with(".rs") || is_zip(path), 1)?
            .into_iter()
            .filter(|file| file.name().ends_with(".rs") || file.content.is_err())
            .collect(),
    )
}

/// The entries of a zip that are `wanted`, and those of zips in it, `deep` zips down.
pub fn entries(
    bytes: &[u8],
    wanted: &dyn Fn(&str) -> bool,
    deep: usize,
) -> Result<Vec<Handed>, String> {
    let broken = |error: zip::result::ZipError| format!("the zip cannot be read: {error}");
    let mut archive = zip::ZipArchive::new(Cursor::new(bytes)).map_err(broken)?;
    if archive.len() > MOST_ENTRIES {
        return Err(format!(
            "the zip has {} entries, at most {MOST_ENTRIES} are read",
            archive.len()
        ));
    }
    let mut files = Vec::new();
    for index in 0..archive.len() {
        let (path, is_link, is_dir) = {
            let entry = archive.by_index_raw(index).map_err(broken)?;
            (
                entry.name().map_err(broken)?.replace('\\', "/"),
                entry.is_symlink(),
                entry.is_dir(),
            )
        };
        let folders = path.rsplit_once('/').map_or("", |(folders, _)| folders);
        if is_dir || folders.split('/').any(is_passed_over) {
            continue;
        }
        if is_link {
            files.push(Handed::link(path.clone(), &path));
            continue;
        }
        if !wanted(&path) {
            continue;
        }
        let is_inner = is_zip(&path);
        let most = if is_inner { LARGEST_ZIP } else { LARGEST_FILE };
        let mut content = Vec::new();
        let read = archive
            .by_index(index)
            .map_err(|error| format!("the file cannot be read: {error}"))
            .and_then(|entry| {
                // What the zip says of its length may be wrong.
                let read = entry.take(most + 1).read_to_end(&mut content);
                read.map_err(|error| format!("the file cannot be read: {error}"))
            });
        match read {
            Err(why) => files.push(Handed::unreadable(path, why)),
            Ok(length) if length as u64 > most => {
                files.push(Handed::unreadable(
                    path,
                    format!("the file has more than {most} bytes"),
                ));
            }
            Ok(_) if is_inner && deep > 0 => {
                let inner = entries(&content, wanted, deep - 1);
                files.extend(
                    inner
                        .map_err(|why| format!("{path}: {why}"))?
                        .into_iter()
                        .map(|file| Handed {
                            path: format!("{path}/{}", file.path),
                            ..file
                        }),
                );
            }
            Ok(_) => files.push(Handed {
                path,
                content: Ok(content),
            }),
        }
    }
    files.sort_by(|a, b| a.path.cmp(&b.path));
    Ok(files)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exercise_file::MARKER;

    fn exercise() -> Exercise {
        Exercise {
            name: "a1".into(),
            topic: "a".into(),
            hint: String::new(),
            fails: Vec::new(),
        }
    }

    fn file(path: &str, text: &str) -> Handed {
        Handed {
            path: path.into(),
            content: Ok(text.into()),
        }
    }

    #[test]
    fn the_file_in_its_place_counts_before_others() {
        let flat = file("a1.rs", "flat");
        let nested = file("mine/exercises/a/a1.rs", &format!("nested\n{MARKER}\n"));
        let other = file("old/a1.rs", "old");
        let found = |handed: &[Handed]| answer(&exercise(), handed);
        assert_eq!(found(&[]), None);
        assert_eq!(found(&[file("a/b1.rs", "b")]), None);
        assert_eq!(found(std::slice::from_ref(&flat)), Some(Ok("flat".into())));
        assert_eq!(
            found(&[flat.clone(), nested, other.clone()]),
            Some(Ok("nested\n".into()))
        );
        assert_eq!(
            found(&[flat.clone(), file("again/a1.rs", "flat")]),
            Some(Ok("flat".into()))
        );
        let Some(Err((Status::Unreadable, why))) = found(&[flat, other]) else {
            panic!("two files, one answer");
        };
        assert!(why.ends_with("a1.rs and old/a1.rs"), "{why}");
    }

    #[test]
    fn links_are_told() {
        let to_file = [Handed::link("exercises/a/a1.rs".into(), "a1.rs")];
        let to_folder = [Handed::link("exercises".into(), "exercises")];
        for handed in [to_file, to_folder] {
            let found = answer(&exercise(), &handed);
            assert!(matches!(found, Some(Err((Status::Link, _)))), "{found:?}");
        }
    }

    #[test]
    fn what_is_not_text_gets_a_sentence() {
        let (_, why) = students_part(b"ab\xff").unwrap_err();
        assert_eq!(why, "the file is not text in UTF-8: byte 2 is 0xff");
    }
}
