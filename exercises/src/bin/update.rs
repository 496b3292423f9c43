//! Brings a copy of the exercises up to date with the course: `cargo run --bin update`.
//!
//! New exercises come, the tests below each marker line are renewed; what stands above it is never touched.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use ombra_exercises::{COURSE, Exercise, exercises, files, read, root, split, write};

fn main() -> ExitCode {
    let arguments: Vec<PathBuf> = std::env::args_os().skip(1).map(PathBuf::from).collect();
    let result = match arguments.as_slice() {
        [] => remembered(&root()).and_then(|course| update(&root(), &course)),
        [course] => update(&root(), course),
        _ => Err("at most one folder is asked for, that of the course: `cargo run --bin update ../Ombra`".to_owned()),
    };
    match result {
        Ok(lines) => {
            println!("{}", lines.join("\n"));
            ExitCode::SUCCESS
        }
        Err(sentence) => {
            eprintln!("error: {sentence}");
            ExitCode::from(2)
        }
    }
}

/// The folder that the copy was made from.
fn remembered(copy: &Path) -> Result<PathBuf, String> {
    let text = read(&copy.join(COURSE)).map_err(|_| {
        "this copy does not say where the course is: name its folder, `cargo run --bin update ../Ombra`".to_owned()
    })?;
    Ok(PathBuf::from(text.trim_end_matches(['\r', '\n'])))
}

/// Renews the copy from the course's folder, or the folder `exercises` in it; says what was done, a line each.
fn update(copy: &Path, course: &Path) -> Result<Vec<String>, String> {
    let course = [course.to_owned(), course.join("exercises")]
        .into_iter()
        .find(|dir| dir.join("info.toml").is_file())
        .ok_or_else(|| {
            format!(
                "{} holds no exercises: name the folder of the course, `cargo run --bin update ../Ombra`",
                course.display()
            )
        })?;
    if same_folder(&course, copy) {
        return Err("this is the course itself: run it in your copy".to_owned());
    }
    let list = exercises(&read(&course.join("info.toml"))?);
    let mut lines = Vec::new();
    for file in files(&course)? {
        let (from, to) = (course.join(&file), copy.join(&file));
        let bytes =
            fs::read(&from).map_err(|error| format!("cannot read {}: {error}", from.display()))?;
        let old = fs::read(&to).ok();
        let exercise = list.iter().find(|exercise| exercise.path() == file);
        let (new, line) = match (exercise, &old) {
            (Some(exercise), Some(old)) => match renewed(old, &bytes) {
                Renewed::Tests(text) => (text, format!("new tests: {}", exercise.name)),
                Renewed::Same => continue,
                Renewed::NotParted => {
                    lines.push(not_parted(exercise));
                    continue;
                }
            },
            (Some(exercise), None) => (bytes, format!("new exercise: {}", exercise.name)),
            (None, Some(old)) if *old == bytes => continue,
            (None, _) => (
                bytes,
                format!("renewed: {}", file.display().to_string().replace('\\', "/")),
            ),
        };
        write(&to, &new)?;
        lines.push(line);
    }
    write(
        &copy.join(COURSE),
        format!("{}\n", full(&course)).as_bytes(),
    )?;
    if lines.is_empty() {
        lines.push("up to date".to_owned());
    }
    Ok(lines)
}

fn not_parted(exercise: &Exercise) -> String {
    format!(
        "left as it is: {}, without the line `{}`; move your answer elsewhere, delete the file, update again",
        exercise.name,
        ombra_exercises::MARKER
    )
}

#[derive(Debug, PartialEq, Eq)]
enum Renewed {
    /// The student's part with the course's tests.
    Tests(Vec<u8>),
    /// The tests are the course's already.
    Same,
    /// There is no marker line to tell the parts by.
    NotParted,
}

fn renewed(old: &[u8], new: &[u8]) -> Renewed {
    let (Ok(old), Ok(new)) = (std::str::from_utf8(old), std::str::from_utf8(new)) else {
        return Renewed::NotParted;
    };
    match (split(old), split(new)) {
        // Windows' line ends are no other tests.
        (Some((_, tests)), Some((_, below))) if tests.replace("\r\n", "\n") == below => {
            Renewed::Same
        }
        (Some((answer, _)), Some((_, below))) => {
            Renewed::Tests(format!("{answer}{below}").into_bytes())
        }
        _ => Renewed::NotParted,
    }
}

fn same_folder(a: &Path, b: &Path) -> bool {
    matches!((a.canonicalize(), b.canonicalize()), (Ok(a), Ok(b)) if a == b)
}

/// The full path, so that it is right in whatever folder the next update is run.
fn full(path: &Path) -> String {
    let full = path.canonicalize().unwrap_or_else(|_| path.to_owned());
    full.display().to_string()
}

#[cfg(test)]
mod tests {
    use super::*;
    use ombra_exercises::MARKER;

    #[test]
    fn only_what_is_below_the_marker_is_renewed() {
        let old = format!("my answer\n{MARKER}\nold tests\n");
        let new = format!("todo\n{MARKER}\nnew tests\n");
        let want = format!("my answer\n{MARKER}\nnew tests\n");
        assert_eq!(
            renewed(old.as_bytes(), new.as_bytes()),
            Renewed::Tests(want.clone().into_bytes())
        );
        assert_eq!(renewed(want.as_bytes(), new.as_bytes()), Renewed::Same);
        let windows = want.replace('\n', "\r\n");
        assert_eq!(renewed(windows.as_bytes(), new.as_bytes()), Renewed::Same);
        for old in [&b"no marker"[..], b"\xff"] {
            assert_eq!(renewed(old, new.as_bytes()), Renewed::NotParted);
        }
    }
}
