//! Running a program under a time limit.

use std::io::Read;
use std::path::Path;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

/// How much of each output is kept of a program that prints without end.
const KEPT_BYTES: usize = 1 << 24;

/// How a program ended.
#[derive(Debug)]
pub struct Ended {
    /// Its exit status, or `None` when it was stopped at the time limit.
    pub status: Option<ExitStatus>,
    /// What it printed.
    pub stdout: String,
    /// What it printed as errors.
    pub stderr: String,
    /// How long it ran.
    pub time: Duration,
}

/// A program that runs.
pub struct Running {
    child: Child,
    started: Instant,
    stdout: JoinHandle<String>,
    stderr: JoinHandle<String>,
}

/// Starts a program in the folder `dir`.
pub fn start(program: &Path, arguments: &[&str], dir: &Path) -> Result<Running, String> {
    let sentence = |why: String| format!("cannot start {}: {why}", program.display());
    let mut child = Command::new(program)
        .args(arguments)
        .current_dir(dir)
        .env("RUST_BACKTRACE", "0")
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .map_err(|error| sentence(error.to_string()))?;
    let stdout = child
        .stdout
        .take()
        .ok_or_else(|| sentence("no output".to_owned()))?;
    let stderr = child
        .stderr
        .take()
        .ok_or_else(|| sentence("no output".to_owned()))?;
    Ok(Running {
        child,
        started: Instant::now(),
        stdout: thread::spawn(move || read_first(stdout)),
        stderr: thread::spawn(move || read_first(stderr)),
    })
}

impl Running {
    /// Waits for the program's end, or ends it `limit` after its start.
    pub fn wait(mut self, limit: Duration) -> Result<Ended, String> {
        let status = loop {
            let ended = self
                .child
                .try_wait()
                .map_err(|error| format!("cannot wait for a program: {error}"))?;
            if ended.is_some() {
                break ended;
            }
            if self.started.elapsed() >= limit {
                // It may have ended by itself since the last look: either way it is over.
                let _ = self.child.kill();
                let _ = self.child.wait();
                break None;
            }
            thread::sleep(Duration::from_millis(2));
        };
        Ok(Ended {
            status,
            time: self.started.elapsed(),
            stdout: self.stdout.join().unwrap_or_default(),
            stderr: self.stderr.join().unwrap_or_default(),
        })
    }
}

/// Reads to the end, and keeps the beginning.
fn read_first(mut source: impl Read) -> String {
    let mut kept = Vec::new();
    let mut buffer = [0; 1 << 13];
    while let Ok(count @ 1..) = source.read(&mut buffer) {
        let room = KEPT_BYTES.saturating_sub(kept.len());
        kept.extend(buffer.iter().take(count.min(room)));
    }
    String::from_utf8_lossy(&kept).into_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn output_without_end_is_cut() {
        let text = read_first(std::io::repeat(b'x').take(3 * KEPT_BYTES as u64));
        assert_eq!(text.len(), KEPT_BYTES);
        assert_eq!(read_first(&b"short \xff"[..]), "short \u{fffd}");
    }

    #[test]
    fn a_program_that_is_not_there_gets_a_sentence() {
        let why = start(Path::new("no-such-program"), &[], Path::new("."))
            .err()
            .unwrap();
        assert!(why.starts_with("cannot start no-such-program: "), "{why}");
    }
}
