//! A throw-away package: the set's manifest, lock file and path dependencies, with other sources.

use std::fs;
use std::path::{Path, PathBuf};

use crate::set::{Set, split_bins};

/// Makes the folder a package with the set's manifest, whose `bin` list is `bins`.
pub fn prepare(dir: &Path, set: &Set, bins: &str) -> Result<(), String> {
    let [before, _, after] = split_bins(&set.manifest).ok_or("Cargo.toml has no list `bin = [`")?;
    write(&dir.join("Cargo.toml"), &format!("{before}{bins}{after}"))?;
    let lock = set.root.join("Cargo.lock");
    if lock.is_file() {
        write(&dir.join("Cargo.lock"), &crate::set::read_text(&lock)?)?;
    }
    for path in set.path_dependencies()? {
        // A dependency outside the set could not be copied beside the copy.
        if path.is_absolute() || path.starts_with("..") {
            return Err(format!(
                "Cargo.toml: the dependency {} lies outside the set",
                path.display()
            ));
        }
        copy_package(&set.root.join(&path), &dir.join(&path))?;
    }
    Ok(())
}

/// Writes a file unless it has that content already, so that cargo does not build it again.
pub fn write(path: &Path, text: &str) -> Result<(), String> {
    if fs::read_to_string(path).is_ok_and(|old| old == text) {
        return Ok(());
    }
    path.parent()
        .map_or(Ok(()), fs::create_dir_all)
        .and_then(|()| fs::write(path, text))
        .map_err(|error| format!("cannot write {}: {error}", path.display()))
}

fn copy_package(from: &Path, to: &Path) -> Result<(), String> {
    write(
        &to.join("Cargo.toml"),
        &crate::set::read_text(&from.join("Cargo.toml"))?,
    )?;
    for file in rust_files(&from.join("src"))? {
        let inside = file.strip_prefix(from).map_err(|error| error.to_string())?;
        write(&to.join(inside), &crate::set::read_text(&file)?)?;
    }
    Ok(())
}

/// All `.rs` files below a folder, sorted; none where there is no such folder.
pub fn rust_files(dir: &Path) -> Result<Vec<PathBuf>, String> {
    let mut files = Vec::new();
    let mut folders = vec![dir.to_owned()];
    while let Some(folder) = folders.pop() {
        if !folder.is_dir() {
            continue;
        }
        let sentence = |error: std::io::Error| format!("cannot read {}: {error}", folder.display());
        for entry in fs::read_dir(&folder).map_err(sentence)? {
            let entry = entry.map_err(sentence)?;
            // A link to a folder is not followed: it could lead round in a circle.
            if entry.file_type().map_err(sentence)?.is_dir() {
                folders.push(entry.path());
            } else if entry
                .path()
                .extension()
                .is_some_and(|extension| extension == "rs")
            {
                files.push(entry.path());
            }
        }
    }
    files.sort();
    Ok(files)
}

/// A folder that is removed when it goes out of scope.
pub struct Scratch(PathBuf);

impl Scratch {
    /// A new, empty folder among the system's temporary ones.
    pub fn new() -> Result<Self, String> {
        let base = std::env::temp_dir();
        for attempt in 0..1000 {
            let dir = base.join(format!("ombra-grade-{}-{attempt}", std::process::id()));
            match fs::create_dir(&dir) {
                Ok(()) => return Ok(Self(dir)),
                Err(error) if error.kind() == std::io::ErrorKind::AlreadyExists => {}
                Err(error) => {
                    return Err(format!("cannot make the folder {}: {error}", dir.display()));
                }
            }
        }
        Err(format!("cannot make a new folder in {}", base.display()))
    }

    /// Where it is.
    pub fn path(&self) -> &Path {
        &self.0
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        // On Windows a program that was just ended may still hold its file: what stays is in a temporary folder.
        let _ = fs::remove_dir_all(&self.0);
    }
}
