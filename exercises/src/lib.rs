//! What `start`, `hint` and `update` share: the list of the exercises, and copies of the course's files.

mod marker;

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

pub use marker::{MARKER, split};

/// The file of a student's copy that names the folder it was copied from.
pub const COURSE: &str = ".course.txt";

/// What a student's copy does not have: what is made by working in it, and what only the proof and the grader read.
const LEFT_OUT: [&str; 9] = [
    ".course.txt",
    ".git",
    ".hints.txt",
    ".rustlings-state.txt",
    "grade",
    "pictures",
    "right",
    "target",
    "wrong",
];

/// An exercise as info.toml lists it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Exercise {
    /// The name of its files, such as `math1_triangle_normal`.
    pub name: String,
    /// The folder of its topic.
    pub dir: String,
    /// The idea, the step, nearly the code.
    pub hints: Vec<String>,
}

impl Exercise {
    /// Its file from the folder of the exercises.
    #[must_use]
    pub fn path(&self) -> PathBuf {
        let file = format!("{}.rs", self.name);
        Path::new("exercises").join(&self.dir).join(file)
    }
}

/// The folder of the exercises: that of the package which cargo runs, else the current one.
#[must_use]
pub fn root() -> PathBuf {
    std::env::var_os("CARGO_MANIFEST_DIR").map_or_else(|| PathBuf::from("."), PathBuf::from)
}

/// The exercises that the text of info.toml lists.
///
/// It reads the form that the set keeps to: `name = "…"`, `dir = "…"` and `hint = """…"""` with paragraphs that begin
/// with `1. `, `2. ` and so on.
#[must_use]
pub fn exercises(info: &str) -> Vec<Exercise> {
    let entries = info.split("[[exercises]]").skip(1);
    entries.filter_map(exercise).collect()
}

fn exercise(entry: &str) -> Option<Exercise> {
    let value = |key: &str| {
        let line = entry.lines().find_map(|line| line.strip_prefix(key))?;
        Some(line.strip_prefix(" = \"")?.split_once('"')?.0.to_owned())
    };
    let text = entry
        .split_once("hint = \"\"\"")
        .map_or("", |(_, rest)| rest);
    let text = text.split_once("\"\"\"").map_or(text, |(text, _)| text);
    let mut hints: Vec<String> = Vec::new();
    for line in text.lines() {
        let number = format!("{}. ", hints.len() + 1);
        if let Some(first) = line.strip_prefix(&number) {
            hints.push(first.to_owned());
        } else if let Some(hint) = hints.last_mut() {
            hint.push('\n');
            hint.push_str(line.strip_prefix("   ").unwrap_or(line));
        }
    }
    Some(Exercise {
        name: value("name")?,
        dir: value("dir")?,
        hints: hints.iter().map(|hint| hint.trim().to_owned()).collect(),
    })
}

/// The exercise whose name begins with `asked`, as `math1` does for `math1_triangle_normal`.
///
/// # Errors
///
/// A sentence where none or more than one does.
pub fn find<'a>(exercises: &'a [Exercise], asked: &str) -> Result<&'a Exercise, String> {
    if let Some(exact) = exercises.iter().find(|exercise| exercise.name == asked) {
        return Ok(exact);
    }
    let begin = |exercise: &&Exercise| !asked.is_empty() && exercise.name.starts_with(asked);
    let found: Vec<&Exercise> = exercises.iter().filter(begin).collect();
    let names = |of: &[&Exercise]| {
        let names: Vec<&str> = of.iter().map(|exercise| exercise.name.as_str()).collect();
        names.join(", ")
    };
    match found.as_slice() {
        [one] => Ok(one),
        [] => Err(format!(
            "no exercise begins with {asked:?}; there are {}",
            names(&exercises.iter().collect::<Vec<_>>())
        )),
        several => Err(format!("{asked:?} may be {}", names(several))),
    }
}

/// All files of the course below `root` that a student's copy has, sorted, as paths from there.
///
/// # Errors
///
/// A sentence where a folder cannot be read.
pub fn files(root: &Path) -> Result<Vec<PathBuf>, String> {
    let mut files = Vec::new();
    let mut folders = vec![PathBuf::new()];
    while let Some(folder) = folders.pop() {
        let full = root.join(&folder);
        let sentence = |error: io::Error| format!("cannot read {}: {error}", full.display());
        for entry in fs::read_dir(&full).map_err(sentence)? {
            let entry = entry.map_err(sentence)?;
            let path = folder.join(entry.file_name());
            let inside = path.strip_prefix("assess").unwrap_or(&path);
            if LEFT_OUT.iter().any(|name| inside == Path::new(name)) {
                continue;
            }
            let kind = entry.file_type().map_err(sentence)?;
            if kind.is_dir() {
                folders.push(path);
            } else if kind.is_file() {
                files.push(path);
            }
        }
    }
    files.sort();
    Ok(files)
}

/// Reads a text, with a sentence that names the file when that fails.
///
/// # Errors
///
/// That sentence.
pub fn read(path: &Path) -> Result<String, String> {
    fs::read_to_string(path).map_err(|error| format!("cannot read {}: {error}", path.display()))
}

/// Writes a file whole or not at all, and makes the folder for it.
///
/// # Errors
///
/// A sentence that names the file.
pub fn write(path: &Path, bytes: &[u8]) -> Result<(), String> {
    let sentence = |error: io::Error| format!("cannot write {}: {error}", path.display());
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let half = path.with_file_name(format!(".{name}.{}.tmp", std::process::id()));
    path.parent()
        .map_or(Ok(()), fs::create_dir_all)
        .and_then(|()| fs::write(&half, bytes))
        .and_then(|()| fs::rename(&half, path))
        .map_err(|error| {
            // The file itself is as it was.
            let _ = fs::remove_file(&half);
            sentence(error)
        })
}

#[cfg(test)]
mod tests {
    use super::*;

    const INFO: &str = "format_version = 1\n
[[exercises]]
name = \"a1_first\"
dir = \"a\"
fails = [\"x\"]
hint = \"\"\"
1. The idea: so
   and so.

2. The step.

3. Nearly the code: `f(…)`,
   and `g`.\"\"\"

[[exercises]]
name = \"a12_second\"
dir = \"a\"
hint = \"\"\"
1. One.\"\"\"
";

    #[test]
    fn hints_are_parted() {
        let [first, second] = exercises(INFO)
            .try_into()
            .unwrap_or_else(|_| panic!("not two"));
        assert_eq!(
            first.path(),
            Path::new("exercises").join("a").join("a1_first.rs")
        );
        assert_eq!(
            first.hints,
            [
                "The idea: so\nand so.",
                "The step.",
                "Nearly the code: `f(…)`,\nand `g`."
            ]
        );
        assert_eq!(second.hints, ["One."]);
    }

    #[test]
    fn the_course_has_three_hints_an_exercise() -> Result<(), String> {
        let all = exercises(&read(
            &Path::new(env!("CARGO_MANIFEST_DIR")).join("info.toml"),
        )?);
        assert!(!all.is_empty());
        for exercise in all {
            assert_eq!(exercise.hints.len(), 3, "{}", exercise.name);
            assert!(
                exercise.hints.iter().all(|hint| hint.len() > 20),
                "{}",
                exercise.name
            );
        }
        Ok(())
    }

    #[test]
    fn the_beginning_of_a_name_is_enough() {
        let all = exercises(INFO);
        let name = |asked| find(&all, asked).map(|exercise| exercise.name.as_str());
        assert_eq!(name("a1_"), Ok("a1_first"));
        assert_eq!(name("a12"), Ok("a12_second"));
        assert_eq!(
            name("a1"),
            Err("\"a1\" may be a1_first, a12_second".to_owned())
        );
        for asked in ["", "b"] {
            let said = name(asked).unwrap_err();
            assert!(said.ends_with("there are a1_first, a12_second"), "{said}");
        }
    }

    #[test]
    fn the_marker_parts_a_file() {
        let text = format!("answer\r\n{MARKER}\r\ntests\r\n");
        assert_eq!(split(&text).map(|(above, _)| above), Some("answer\r\n"));
        assert_eq!(split("answer\n"), None);
    }
}
