//! Files written whole or not at all: into temporary files beside their goals, then renamed.
//!
//! Nothing here but the standard library: the grader of the exercises, which is built without the drawing kit, compiles
//! this same file.

use core::fmt;
use std::ffi::OsString;
use std::fs;
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};
use std::process;
use std::sync::atomic::{AtomicU64, Ordering};

/// A file or folder that could not be written, and what the system said.
#[derive(Debug)]
pub struct Refused {
    /// Where.
    pub path: PathBuf,
    /// Why.
    pub error: io::Error,
}

impl Refused {
    fn new(path: &Path, error: io::Error) -> Refused {
        let path = path.to_owned();
        Refused { path, error }
    }
}

impl fmt::Display for Refused {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "{} cannot be written: {}",
            self.path.display(),
            self.error
        )
    }
}

impl core::error::Error for Refused {}

/// Writes files that belong together, and the folders on the way: all are there beside their goals before the first is
/// renamed.
///
/// # Errors
///
/// [`Refused`]; what was at the paths before is then unchanged, unless the system refuses to rename a file that it has
/// just let be written beside its goal.
pub fn together(files: &[(&Path, &[u8])]) -> Result<(), Refused> {
    let mut written: Vec<Temporary> = Vec::with_capacity(files.len());
    for &(goal, bytes) in files {
        written.push(Temporary::write(goal, bytes)?);
    }
    written.iter().try_for_each(Temporary::rename)
}

/// A file beside its goal; removed unless it has taken the goal's name.
struct Temporary<'a> {
    goal: &'a Path,
    path: PathBuf,
}

impl<'a> Temporary<'a> {
    fn write(goal: &'a Path, bytes: &[u8]) -> Result<Temporary<'a>, Refused> {
        static COUNT: AtomicU64 = AtomicU64::new(0);
        let wrong = |error| Refused::new(goal, error);
        let folder = goal
            .parent()
            .filter(|folder| !folder.as_os_str().is_empty())
            .unwrap_or(Path::new("."));
        fs::create_dir_all(folder).map_err(|error| Refused::new(folder, error))?;
        let name = goal
            .file_name()
            .ok_or_else(|| wrong(io::ErrorKind::InvalidInput.into()))?;
        // A folder in the goal's place is what a rename would trip over.
        if goal.is_dir() {
            return Err(wrong(io::ErrorKind::IsADirectory.into()));
        }
        // No two writers share a temporary file: the process and a count name it.
        let mut own = OsString::from(".");
        own.push(name);
        own.push(format!(
            ".{}-{}",
            process::id(),
            COUNT.fetch_add(1, Ordering::Relaxed)
        ));
        let path = folder.join(own);
        let mut file = fs::File::create_new(&path).map_err(wrong)?;
        let temporary = Temporary { goal, path };
        let written = file.write_all(bytes).and_then(|()| file.sync_all());
        written.map_err(wrong).map(|()| temporary)
    }

    fn rename(&self) -> Result<(), Refused> {
        fs::rename(&self.path, self.goal).map_err(|error| Refused::new(self.goal, error))
    }
}

impl Drop for Temporary<'_> {
    fn drop(&mut self) {
        // Nothing is there any more once it is renamed.
        let _ = fs::remove_file(&self.path);
    }
}
