//! Step budgets: a loop that never ends is stopped and told so.

use std::cell::{Cell, RefCell};
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::time::Duration;

/// A number of steps that an algorithm may take.
///
/// A callback that the student's loop must call, a pixel plotted or a node visited, takes one step each.
#[derive(Clone, Debug)]
pub struct Steps {
    limit: usize,
    taken: usize,
}

impl Steps {
    /// A budget of `limit` steps.
    #[must_use]
    pub fn new(limit: usize) -> Self {
        Self { limit, taken: 0 }
    }

    /// Takes one step.
    ///
    /// # Panics
    ///
    /// When the budget is used up.
    #[track_caller]
    pub fn take(&mut self, what: &str) {
        assert!(
            self.taken < self.limit,
            "{what}: {} steps were enough and the loop still runs: when does it end?",
            self.limit,
        );
        self.taken += 1;
    }

    /// How many steps were taken.
    #[must_use]
    pub fn taken(&self) -> usize {
        self.taken
    }
}

/// Collects what an iterator gives, at most `limit` items.
///
/// # Panics
///
/// When it gives more.
#[track_caller]
pub fn collect_within<T>(what: &str, limit: usize, items: impl IntoIterator<Item = T>) -> Vec<T> {
    let mut steps = Steps::new(limit);
    let mut collected = Vec::new();
    for item in items {
        steps.take(what);
        collected.push(item);
    }
    collected
}

/// What `run` hands to its callback, at most `limit` times.
///
/// # Panics
///
/// When it calls more often.
#[track_caller]
pub fn calls_within<T>(what: &str, limit: usize, run: impl FnOnce(&mut dyn FnMut(T))) -> Vec<T> {
    let mut steps = Steps::new(limit);
    let mut calls = Vec::new();
    run(&mut |call| {
        steps.take(what);
        calls.push(call);
    });
    calls
}

/// What `run` hands to its callback in the first `limit` calls; there it is stopped, however many would follow.
///
/// So the beginning of a segment of 2³² pixels can be looked at. `Err` with Rust's own words where a number
/// of `run` overflows; any other panic goes on.
pub fn first_calls<T>(limit: usize, run: impl FnOnce(&mut dyn FnMut(T))) -> Result<Vec<T>, String> {
    struct Enough;
    let mut calls = Vec::new();
    let mut take = |call| {
        calls.push(call);
        if calls.len() >= limit {
            // Unwinds without a message: nothing went wrong.
            resume_unwind(Box::new(Enough));
        }
    };
    match catch_unwind(AssertUnwindSafe(|| run(&mut take))) {
        Err(panic) if !panic.is::<Enough>() => {
            let said = match panic.downcast_ref::<String>() {
                Some(said) => said.as_str(),
                None => panic.downcast_ref::<&str>().copied().unwrap_or(""),
            };
            if said.ends_with("with overflow") {
                return Err(said.to_owned());
            }
            resume_unwind(panic);
        }
        _ => Ok(calls),
    }
}

/// How long an answer may take that needs milliseconds; only a loop in which nothing is counted takes longer.
const PATIENCE: Duration = Duration::from_secs(5);

/// What `run` returns, unless it is still at it after some seconds. It runs in a thread of its own, of the same name.
///
/// # Panics
///
/// When it does not end. A panic of `run` goes on here.
#[track_caller]
pub fn watched<T: Send + 'static>(what: &str, run: impl FnOnce() -> T + Send + 'static) -> T {
    let (sender, receiver) = channel();
    let name = std::thread::current().name().unwrap_or("test").to_owned();
    let spawned = std::thread::Builder::new().name(name).spawn(move || {
        // Who no longer waits needs no result.
        let _ = sender.send(run());
    });
    let thread = match spawned {
        Ok(thread) => thread,
        Err(error) => panic!("{what}: no thread can be started: {error}"),
    };
    match receiver.recv_timeout(PATIENCE) {
        Ok(result) => result,
        Err(RecvTimeoutError::Timeout) => panic!(
            "{what}: still at it after {} s, and nothing of ours is called any more: does a loop never end?",
            PATIENCE.as_secs()
        ),
        Err(RecvTimeoutError::Disconnected) => match thread.join() {
            Err(panic) => resume_unwind(panic),
            Ok(()) => panic!("{what}: nothing is returned"),
        },
    }
}

/// An addition of a coordinate that is kept, remembered for [`sums`].
#[must_use]
pub fn sum(x: f64, m: f64) -> f64 {
    SUMS.with_borrow_mut(|sums| {
        // Whoever adds without end is stopped by others.
        if sums.len() < 1 << 20 {
            sums.push((x, m));
        }
    });
    x + m
}

/// What `run` returns, and the additions `x + m` that it made by [`sum`].
pub fn sums<T>(run: impl FnOnce() -> T) -> (T, Vec<(f64, f64)>) {
    SUMS.take();
    let result = run();
    (result, SUMS.take())
}

thread_local! {
    static SUMS: RefCell<Vec<(f64, f64)>> = const { RefCell::new(Vec::new()) };

    /// How often [`counted`] may be called yet, and how often it might be in all; `None` while nobody counts.
    static CALLS: Cell<Option<(usize, usize, &'static str)>> = const { Cell::new(None) };
}

/// Called by a given function whose calls are counted: `what` is its name.
///
/// # Panics
///
/// When [`within_calls`] allows no more of them.
#[track_caller]
pub fn counted(what: &str) {
    match CALLS.get() {
        None => {}
        Some((0, all, because)) => {
            CALLS.set(None);
            panic!("{what} was called {all} times and more: does a loop never end? {because}");
        }
        Some((left, all, because)) => CALLS.set(Some((left - 1, all, because))),
    }
}

/// What `run` returns, if it calls [`counted`] functions at most `limit` times; `because` says why more are too many.
pub fn within_calls<T>(limit: usize, because: &'static str, run: impl FnOnce() -> T) -> T {
    CALLS.set(Some((limit, limit, because)));
    let result = run();
    CALLS.set(None);
    result
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn calls_within_the_limit_are_kept() {
        assert_eq!(
            calls_within("counting", 2, |take| (0..2).for_each(take)),
            [0, 1]
        );
    }

    #[test]
    #[should_panic(expected = "counting: 2 steps were enough and the loop still runs")]
    fn calls_beyond_the_limit_are_stopped() {
        calls_within("counting", 2, |take| (0..9).for_each(take));
    }

    #[test]
    fn first_calls_stop_a_long_run() {
        let run = |take: &mut dyn FnMut(u64)| (0..u64::MAX).for_each(take);
        assert_eq!(first_calls(3, run), Ok(vec![0, 1, 2]));
        assert_eq!(first_calls(9, |take| (0..2).for_each(take)), Ok(vec![0, 1]));
        assert_eq!(first_calls::<u8>(9, |_| ()), Ok(Vec::new()));
    }

    #[test]
    fn first_calls_tell_an_overflow() {
        let overflow = |_: &mut dyn FnMut(u8)| panic!("attempt to add with overflow");
        let said = "attempt to add with overflow".to_owned();
        assert_eq!(first_calls(9, overflow), Err(said));
    }

    #[test]
    #[should_panic(expected = "another reason")]
    fn first_calls_pass_other_panics_on() {
        let _ = first_calls(9, |take: &mut dyn FnMut(u8)| {
            take(1);
            panic!("for another reason");
        });
    }

    #[test]
    fn what_ends_is_returned_and_a_panic_goes_on() {
        assert_eq!(watched("f", || 7), 7);
        let panic = catch_unwind(|| watched("f", || resume_unwind(Box::new(5_u8))));
        assert_eq!(
            panic.err().and_then(|p| p.downcast::<u8>().ok()),
            Some(Box::new(5))
        );
    }

    #[test]
    #[should_panic(expected = "f: still at it after 5 s")]
    fn what_does_not_end_is_stopped() {
        watched("f", || {
            loop {
                std::thread::sleep(PATIENCE);
            }
        });
    }

    #[test]
    fn additions_are_remembered() {
        let (three, made) = sums(|| sum(sum(0.0, 1.0), 2.0));
        assert_eq!((three, made), (3.0, vec![(0.0, 1.0), (1.0, 2.0)]));
        assert_eq!(sums(|| ()).1, []);
    }

    #[test]
    fn counted_calls_are_allowed_up_to_their_limit() {
        assert_eq!(
            within_calls(2, "", || (0..2).map(|_| counted("f")).count()),
            2
        );
        // Nobody counts any more.
        (0..9).for_each(|_| counted("f"));
    }

    #[test]
    #[should_panic(
        expected = "f was called 3 times and more: does a loop never end? Two are enough."
    )]
    fn counted_calls_are_stopped() {
        within_calls(3, "Two are enough.", || {
            loop {
                counted("f");
            }
        });
    }

    #[test]
    fn a_budget_allows_its_limit() {
        assert_eq!(collect_within("counting", 3, 0..3), [0, 1, 2]);
        assert!(collect_within("counting", 0, 0..0).is_empty());
        let mut steps = Steps::new(2);
        steps.take("walking");
        assert_eq!(steps.taken(), 1);
    }

    #[test]
    #[should_panic(
        expected = "counting: 9 steps were enough and the loop still runs: when does it end?"
    )]
    fn a_loop_without_an_end_is_stopped() {
        collect_within("counting", 9, std::iter::repeat(()));
    }
}
