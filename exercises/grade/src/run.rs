//! Running a program, and all that it starts, under a limit of time and of memory.

use std::io::{Read, Write};
use std::path::Path;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::mpsc::{Receiver, channel};
use std::thread;
use std::time::{Duration, Instant};

/// How much of each output is kept of a program that prints without end: its last bytes.
const KEPT_BYTES: usize = 1 << 20;

/// How long the outputs may stay open after the program has ended: by what it started and we could not end.
const PATIENCE: Duration = Duration::from_secs(1);

/// How long what a program started may take to end after it: the system clears it away.
const GRACE: Duration = Duration::from_millis(200);

/// How a program ended.
#[derive(Debug)]
pub struct Ended {
    /// Its exit status, or `None` when it was stopped at the time limit.
    pub status: Option<ExitStatus>,
    /// The end of what it printed.
    pub stdout: String,
    /// The end of what it printed as errors.
    pub stderr: String,
    /// How long it ran.
    pub time: Duration,
    /// Whether a program that it had started still ran.
    pub left_running: bool,
}

/// A program that runs.
pub struct Running {
    child: Child,
    family: family::Family,
    started: Instant,
    stdout: Receiver<String>,
    stderr: Receiver<String>,
}

/// Starts a program in the folder `dir` and hands it `input`. Where the system can limit it, it has no more than
/// `memory` bytes.
///
/// Without a limit of memory it is a program of ours: it stays with us, so that Ctrl-C in a terminal ends it too.
pub fn start(
    program: &Path,
    arguments: &[&str],
    dir: &Path,
    input: &str,
    memory: Option<u64>,
) -> Result<Running, String> {
    let sentence = |why: String| format!("cannot start {}: {why}", program.display());
    let mut command = Command::new(program);
    command
        .args(arguments)
        .current_dir(dir)
        .env("RUST_BACKTRACE", "0")
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped());
    let (mut child, family) =
        family::spawn(&mut command, memory).map_err(|error| sentence(error.to_string()))?;
    if let Some(mut stdin) = child.stdin.take() {
        // A program that has ended already reads nothing.
        let _ = stdin.write_all(input.as_bytes());
    }
    let no_output = || sentence("no output".to_owned());
    let stdout = reader(child.stdout.take().ok_or_else(no_output)?);
    let stderr = reader(child.stderr.take().ok_or_else(no_output)?);
    Ok(Running {
        child,
        family,
        started: Instant::now(),
        stdout,
        stderr,
    })
}

impl Running {
    /// Waits for the program's end, or ends it `limit` after its start, and with it all that it started.
    pub fn wait(self, limit: Duration) -> Result<Ended, String> {
        let mut ended = wait_all(vec![self], limit)?;
        ended.pop().ok_or_else(|| "a program was lost".to_owned())
    }

    /// How it ended, if it has; it is ended when it has run for `limit`.
    fn look(&mut self, limit: Duration) -> Result<Option<Ended>, String> {
        let status = self
            .child
            .try_wait()
            .map_err(|error| format!("cannot wait for a program: {error}"))?;
        let time = self.started.elapsed();
        if status.is_none() && time < limit {
            return Ok(None);
        }
        let left_running = self.family.end(if status.is_some() {
            GRACE
        } else {
            Duration::ZERO
        });
        if status.is_none() {
            // It may have ended by itself since the last look: either way it is over.
            let _ = self.child.kill();
            let _ = self.child.wait();
        }
        Ok(Some(Ended {
            status,
            time,
            left_running: left_running && status.is_some(),
            stdout: self.stdout.recv_timeout(PATIENCE).unwrap_or_default(),
            stderr: self.stderr.recv_timeout(PATIENCE).unwrap_or_default(),
        }))
    }
}

/// Waits for programs that run side by side; each is ended `limit` after its start.
pub fn wait_all(mut running: Vec<Running>, limit: Duration) -> Result<Vec<Ended>, String> {
    let mut ended: Vec<Option<Ended>> = running.iter().map(|_| None).collect();
    loop {
        for (one, ended) in running.iter_mut().zip(&mut ended) {
            if ended.is_none() {
                *ended = one.look(limit)?;
            }
        }
        if ended.iter().all(Option::is_some) {
            return Ok(ended.into_iter().flatten().collect());
        }
        thread::sleep(Duration::from_millis(2));
    }
}

/// Reads in a thread of its own, which nobody waits for: another program may hold the output open.
fn reader(source: impl Read + Send + 'static) -> Receiver<String> {
    let (sender, receiver) = channel();
    thread::spawn(move || {
        // Who no longer waits needs no text.
        let _ = sender.send(read_last(source));
    });
    receiver
}

/// Reads to the end, and keeps the end.
fn read_last(mut source: impl Read) -> String {
    let mut kept = Vec::new();
    let mut buffer = [0; 1 << 13];
    while let Ok(count @ 1..) = source.read(&mut buffer) {
        kept.extend(buffer.iter().take(count));
        if kept.len() > 2 * KEPT_BYTES {
            kept.drain(..kept.len() - KEPT_BYTES);
        }
    }
    let first = kept.len().saturating_sub(KEPT_BYTES);
    String::from_utf8_lossy(kept.get(first..).unwrap_or_default()).into_owned()
}

#[cfg(unix)]
mod family {
    //! A process group. What leaves the group on purpose gets away.

    use std::os::unix::process::CommandExt;
    use std::process::{Child, Command};

    use std::thread;
    use std::time::{Duration, Instant};

    use rustix::process::{Pid, Signal, kill_process_group, test_kill_process_group};

    pub struct Family(Option<Pid>);

    pub fn spawn(command: &mut Command, memory: Option<u64>) -> std::io::Result<(Child, Family)> {
        let Some(bytes) = memory else {
            return Ok((command.spawn()?, Family(None)));
        };
        let child = command.process_group(0).spawn()?;
        let leader = Pid::from_child(&child);
        limit_memory(leader, bytes);
        Ok((child, Family(Some(leader))))
    }

    impl Family {
        /// Ends all that still run after `grace`, and says whether any did.
        pub fn end(&mut self, grace: Duration) -> bool {
            let Some(leader) = self.0.take() else {
                return false;
            };
            let since = Instant::now();
            while since.elapsed() < grace && test_kill_process_group(leader).is_ok() {
                thread::sleep(Duration::from_millis(2));
            }
            kill_process_group(leader, Signal::KILL).is_ok()
        }
    }

    impl Drop for Family {
        fn drop(&mut self) {
            self.end(Duration::ZERO);
        }
    }

    /// A loop that pushes without end gets a sentence before it has the whole machine.
    #[cfg(target_os = "linux")]
    fn limit_memory(process: Pid, bytes: u64) {
        use rustix::process::{Resource, Rlimit, prlimit};
        let limit = Rlimit {
            current: Some(bytes),
            maximum: Some(bytes),
        };
        // Without it the time limit still ends the program.
        let _ = prlimit(Some(process), Resource::As, limit);
    }

    #[cfg(not(target_os = "linux"))]
    fn limit_memory(_: Pid, _: u64) {}
}

#[cfg(windows)]
mod family {
    //! A job object, which ends all its processes when it is closed.

    use std::os::windows::io::AsRawHandle;
    use std::process::{Child, Command};
    use std::time::Duration;

    use win32job::{ExtendedLimitInfo, Job};

    pub struct Family(Option<Job>);

    pub fn spawn(command: &mut Command, _memory: Option<u64>) -> std::io::Result<(Child, Family)> {
        let child = command.spawn()?;
        let mut limits = ExtendedLimitInfo::new();
        limits.limit_kill_on_job_close();
        let job = Job::create_with_limit_info(&limits).ok();
        let job = job.filter(|job| job.assign_process(child.as_raw_handle() as isize).is_ok());
        Ok((child, Family(job)))
    }

    impl Family {
        /// Ends all that still run, and says whether any did.
        pub fn end(&mut self, _grace: Duration) -> bool {
            let Some(job) = self.0.take() else {
                return false;
            };
            let running = job.query_process_id_list();
            drop(job);
            running.is_ok_and(|running| !running.is_empty())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn of_output_without_end_the_end_is_kept() {
        let long = std::io::repeat(b'x').take(3 * KEPT_BYTES as u64);
        let text = read_last(long.chain(&b"end"[..]));
        assert_eq!(text.len(), KEPT_BYTES);
        assert!(text.ends_with("xend"));
        assert_eq!(read_last(&b"short \xff"[..]), "short \u{fffd}");
    }

    #[test]
    fn a_program_that_is_not_there_gets_a_sentence() {
        let why = start(Path::new("no-such-program"), &[], Path::new("."), "", None)
            .err()
            .unwrap();
        assert!(why.starts_with("cannot start no-such-program: "), "{why}");
    }
}
