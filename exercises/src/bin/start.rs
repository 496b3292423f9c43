//! A copy of the exercises to work in: `cargo run --bin start ../../ombra-exercises`.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode, Stdio};

use ombra_exercises::{COURSE, files, root, write};

fn main() -> ExitCode {
    let arguments: Vec<PathBuf> = std::env::args_os().skip(1).map(PathBuf::from).collect();
    let result = match arguments.as_slice() {
        [to] => start(&root(), to),
        _ => Err(
            "one new folder is asked for: `cargo run --bin start ../../ombra-exercises`".to_owned(),
        ),
    };
    match result {
        Ok(text) => {
            println!("{text}");
            ExitCode::SUCCESS
        }
        Err(sentence) => {
            eprintln!("error: {sentence}");
            ExitCode::from(2)
        }
    }
}

/// Copies the exercises from `root` into the new folder `to`, whole or not at all, and puts the copy under git.
fn start(root: &Path, to: &Path) -> Result<String, String> {
    let root = root
        .canonicalize()
        .map_err(|error| format!("cannot find {}: {error}", root.display()))?;
    let to = absolute(to)?;
    if to.starts_with(&root) {
        return Err(format!(
            "{} lies in the exercises themselves: name a folder outside of the checkout",
            shown(&to)
        ));
    }
    let exists = to.exists();
    if exists && !is_empty_folder(&to) {
        return Err(format!(
            "{} is there already: name a new folder, or bring an old copy up to date with `cargo run --bin update` in it",
            shown(&to)
        ));
    }

    // Beside it first: a copy that breaks off leaves no half folder of that name.
    let name = to
        .file_name()
        .ok_or_else(|| format!("{} is not the name of a folder", shown(&to)))?;
    let half = to.with_file_name(format!(
        ".{}.{}.tmp",
        name.to_string_lossy(),
        std::process::id()
    ));
    let copied = copy(&root, &half).and_then(|()| {
        if exists {
            // Windows renames onto no folder, not even an empty one.
            fs::remove_dir(&to)
                .map_err(|error| format!("cannot replace {}: {error}", shown(&to)))?;
        }
        fs::rename(&half, &to).map_err(|error| format!("cannot make {}: {error}", shown(&to)))
    });
    if let Err(sentence) = copied {
        let _ = fs::remove_dir_all(&half);
        return Err(sentence);
    }
    let git = match under_git(&to) {
        Ok(()) => "It is under git, with the exercises as they are as its first commit.".to_owned(),
        Err(why) => {
            format!("It is not under git, which only rustlings' reset of an exercise needs: {why}.")
        }
    };
    Ok(format!(
        "{} is your copy. {git}\n\nGo there and begin:\n    cd {}\n    cargo test --bin math1_triangle_normal\n\
         or, with rustlings installed,\n    rustlings",
        shown(&to),
        shown(&to),
    ))
}

fn copy(root: &Path, half: &Path) -> Result<(), String> {
    for file in files(root)? {
        let from = root.join(&file);
        let bytes =
            fs::read(&from).map_err(|error| format!("cannot read {}: {error}", shown(&from)))?;
        write(&half.join(&file), &bytes)?;
    }
    write(&half.join(COURSE), format!("{}\n", shown(root)).as_bytes())
}

/// The full path of a folder that may not be there yet.
fn absolute(to: &Path) -> Result<PathBuf, String> {
    let full = std::path::absolute(to).map_err(|error| format!("{}: {error}", to.display()))?;
    // The folder above is resolved, so that `..` and links do not hide where it lies.
    let (Some(parent), Some(name)) = (full.parent(), full.file_name()) else {
        return Ok(full);
    };
    match parent.canonicalize() {
        Ok(parent) => Ok(parent.join(name)),
        Err(error) => Err(format!(
            "the folder for it, {}, cannot be found: {error}",
            parent.display()
        )),
    }
}

/// A path as one types it: Windows' full paths begin with `\\?\`, which no shell takes.
fn shown(path: &Path) -> String {
    let text = path.display().to_string();
    text.strip_prefix(r"\\?\")
        .map_or(text.clone(), str::to_owned)
}

fn is_empty_folder(path: &Path) -> bool {
    fs::read_dir(path).is_ok_and(|mut entries| entries.next().is_none())
}

/// Makes the folder a repository with all its files in one commit.
fn under_git(dir: &Path) -> Result<(), String> {
    git(dir, &["init", "--quiet"])?;
    git(dir, &["add", "--all"])?;
    let commit = [
        "-c",
        "commit.gpgsign=false",
        "commit",
        "--quiet",
        "--message",
        "The exercises as they are",
    ];
    if git(dir, &commit).is_ok() {
        return Ok(());
    }
    // Someone who has never used git has told it no name yet.
    let name = [
        "-c",
        "user.name=student",
        "-c",
        "user.email=student@localhost",
    ];
    git(dir, &[&name[..], &commit[..]].concat())
}

fn git(dir: &Path, arguments: &[&str]) -> Result<(), String> {
    let output = Command::new("git")
        .current_dir(dir)
        .args(arguments)
        .stdin(Stdio::null())
        .output();
    match output {
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => {
            Err("git is not installed".to_owned())
        }
        Err(error) => Err(format!("git cannot be started: {error}")),
        Ok(output) if output.status.success() => Ok(()),
        Ok(output) => {
            let said = String::from_utf8_lossy(&output.stderr);
            Err(format!("git says {}", said.trim().trim_end_matches('.')))
        }
    }
}
