//! Files written whole or not at all: into temporary files beside their goals, then renamed. What a run that was killed
//! leaves of them is swept away by the next run that writes into the same folder.
//!
//! Nothing here but the standard library: the grader of the exercises, which is built without the drawing kit, compiles
//! this same file.

use core::fmt;
use std::collections::BTreeSet;
use std::ffi::OsString;
use std::fs;
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};
use std::process;
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Duration;

/// What a temporary file's name ends with: `.NAME.PROCESS-COUNT.part`.
const MARK: &str = ".part";
/// No file takes longer to be written than this.
const LONGEST: Duration = Duration::from_secs(3600);
/// How many temporary files this process has begun.
static COUNT: AtomicU64 = AtomicU64::new(0);

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
        sweep_once(folder);
        // No two writers share a temporary file: the process and a count name it. A leftover of an earlier process of
        // the same number is passed over.
        let (path, mut file) = loop {
            let count = COUNT.fetch_add(1, Ordering::SeqCst);
            let mut own = OsString::from(".");
            own.push(name);
            own.push(format!(".{}-{count}{MARK}", process::id()));
            let path = folder.join(own);
            match fs::File::create_new(&path) {
                Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {}
                file => break (path, file.map_err(wrong)?),
            }
        };
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

/// Sweeps a folder at the first file that this process writes there.
fn sweep_once(folder: &Path) {
    static SWEPT: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());
    let new = SWEPT
        .lock()
        .is_ok_and(|mut swept| swept.insert(folder.to_owned()));
    if new {
        sweep(folder);
    }
}

/// Removes the temporary files in `folder` whose process is no more, or that are older than an hour. Where processes
/// cannot be asked for, age alone decides. A file that cannot be removed stays.
pub fn sweep(folder: &Path) {
    let Ok(entries) = fs::read_dir(folder) else {
        return;
    };
    let listed: Vec<_> = entries.flatten().collect();
    // What this process has begun before the list was made has a smaller count.
    let begun = COUNT.load(Ordering::SeqCst);
    for entry in listed {
        let name = entry.file_name();
        let Some((process, count)) = name.to_str().and_then(writer) else {
            continue;
        };
        let Ok(about) = entry.metadata() else {
            continue;
        };
        let age = about.modified().ok().and_then(|at| at.elapsed().ok());
        let gone = if process == process::id() {
            count >= begun
        } else {
            is_gone(process)
        };
        if about.is_file() && (gone || age.is_some_and(|age| age > LONGEST)) {
            let _ = fs::remove_file(entry.path());
        }
    }
}

/// The process and the count in the name of a temporary file.
fn writer(name: &str) -> Option<(u32, u64)> {
    let (goal, own) = name
        .strip_prefix('.')?
        .strip_suffix(MARK)?
        .rsplit_once('.')?;
    let (process, count) = own.split_once('-')?;
    let plain = |digits: &str| !digits.is_empty() && digits.bytes().all(|b| b.is_ascii_digit());
    if goal.is_empty() || !plain(process) || !plain(count) {
        return None;
    }
    Some((process.parse().ok()?, count.parse().ok()?))
}

/// Whether no process has this number; never where that cannot be known.
fn is_gone(process: u32) -> bool {
    let processes = Path::new("/proc");
    // Our own is there, where the system lists its processes.
    processes.join("self").join("stat").exists() && !processes.join(process.to_string()).exists()
}

#[cfg(test)]
mod tests {
    use std::env;
    use std::process::{Command, Stdio};
    use std::thread::sleep;
    use std::time::{Instant, SystemTime};

    use super::*;

    struct Folder(PathBuf);

    impl Folder {
        fn new(name: &str) -> Folder {
            let path = env::temp_dir().join(format!("ombra-whole-{name}-{}", process::id()));
            let _ = fs::remove_dir_all(&path);
            fs::create_dir_all(&path).unwrap();
            Folder(path)
        }

        fn names(&self) -> Vec<String> {
            let entries = fs::read_dir(&self.0).unwrap();
            let mut names: Vec<_> = entries
                .map(|entry| entry.unwrap().file_name().into_string().unwrap())
                .collect();
            names.sort();
            names
        }
    }

    impl Drop for Folder {
        fn drop(&mut self) {
            let _ = fs::remove_dir_all(&self.0);
        }
    }

    const GOAL: &str = "OMBRA_TEST_OF_A_KILLED_RUN";

    /// The run that is killed: started by the test below, in the middle of writing for as long as it lives.
    #[test]
    fn a_run_in_the_middle() {
        let Some(goal) = env::var_os(GOAL) else {
            return;
        };
        let written = Temporary::write(Path::new(&goal), b"half").unwrap();
        sleep(Duration::from_secs(60));
        drop(written);
    }

    #[test]
    #[cfg(target_os = "linux")]
    fn leftovers_of_a_killed_run_are_swept_by_the_next() {
        let folder = Folder::new("killed");
        let goal = folder.0.join("a.svg");
        let (_, module) = module_path!().split_once("::").unwrap();
        let mut run = Command::new(env::current_exe().unwrap())
            .args(["--exact", &format!("{module}::a_run_in_the_middle")])
            .env(GOAL, &goal)
            .stdout(Stdio::null())
            .spawn()
            .unwrap();
        let begun = Instant::now();
        while folder.names().is_empty() && begun.elapsed() < Duration::from_secs(30) {
            sleep(Duration::from_millis(5));
        }
        // As long as it lives its file is left alone.
        sweep(&folder.0);
        let names = folder.names();
        let killed = run.kill().and_then(|()| run.wait());
        assert!(killed.is_ok() && names.len() == 1, "{names:?}");
        assert_eq!(folder.names(), names);
        together(&[(&goal, b"whole")]).unwrap();
        assert_eq!(folder.names(), ["a.svg"]);
    }

    #[test]
    fn files_of_others_and_of_living_writers_stay() {
        let folder = Folder::new("others");
        let own = process::id();
        let path = |name: &str| folder.0.join(name);
        let goal = path("b.svg");
        let living = Temporary::write(&goal, b"half").unwrap();
        let living_name = living
            .path
            .file_name()
            .unwrap()
            .to_str()
            .unwrap()
            .to_owned();
        let others = [
            ".backup.2024-05".to_owned(),
            ".git".to_owned(),
            "a.svg.999999999-0.part".to_owned(),
            ".999999999-0.part".to_owned(),
            ".a.svg.999999999-+1.part".to_owned(),
            ".a.svg.99999999999-1.part".to_owned(),
            ".a.part".to_owned(),
        ];
        for name in &others {
            fs::write(path(name), "").unwrap();
        }
        fs::create_dir(path(".folder.999999999-0.part")).unwrap();
        // An earlier process of our number, which had begun more files than we have.
        fs::write(path(&format!(".c.svg.{own}-{}.part", u64::MAX)), "").unwrap();
        // Older than an hour.
        let old = path(&format!(".d.svg.{own}-0.part"));
        let hours = SystemTime::now() - Duration::from_secs(7200);
        fs::File::create(&old).unwrap().set_modified(hours).unwrap();
        sweep(&folder.0);
        let mut expected = others.to_vec();
        expected.extend([living_name, ".folder.999999999-0.part".to_owned()]);
        expected.sort();
        assert_eq!(folder.names(), expected);
        drop(living);
        sweep(&path("not there"));
    }

    #[test]
    #[cfg(target_os = "linux")]
    fn a_process_is_asked_for() {
        assert!(!is_gone(process::id()));
        // Above the largest number that Linux gives.
        assert!(is_gone(u32::MAX));
    }
}
