//! What Rust's test programs print.

use std::collections::BTreeMap;

/// How a test ended.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// It passed.
    Passed,
    /// It failed, with the message of its panic.
    Failed(String),
}

/// The outcome of each test that a program reported.
pub fn outcomes(stdout: &str) -> BTreeMap<String, Outcome> {
    let mut outcomes = BTreeMap::new();
    for line in stdout.lines() {
        if let Some((name, ending)) = line
            .strip_prefix("test ")
            .and_then(|rest| rest.rsplit_once(" ... "))
        {
            match ending {
                "ok" => outcomes.insert(name.to_owned(), Outcome::Passed),
                "FAILED" => outcomes.insert(name.to_owned(), Outcome::Failed(String::new())),
                _ => None,
            };
        }
    }
    // The output of the failed tests follows, each under a heading; the list of their names ends it.
    let mut heading: Option<String> = None;
    let mut captured = String::new();
    for line in stdout.lines().chain(["failures:"]) {
        let next = line
            .strip_prefix("---- ")
            .and_then(|rest| rest.strip_suffix(" stdout ----"));
        if next.is_some() || line == "failures:" {
            if let Some(Outcome::Failed(message)) =
                heading.take().and_then(|name| outcomes.get_mut(&name))
            {
                *message = panic_message(&captured).unwrap_or_default();
            }
            captured.clear();
            heading = next.map(str::to_owned);
        } else {
            captured.push_str(line);
            captured.push('\n');
        }
    }
    outcomes
}

/// The message of the last panic in a test's output, without its place; the last line names the picture of it, where
/// one was drawn.
pub fn panic_message(output: &str) -> Option<String> {
    let (_, after) = output.rsplit_once(" panicked at ")?;
    let (_, message) = after.split_once('\n')?;
    let lines = message.lines();
    let lines: Vec<&str> = lines
        .filter(|line| !line.starts_with("note: run with `RUST_BACKTRACE"))
        .collect();
    Some(lines.join("\n").trim_end().to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    const PRINTED: &str = "
running 3 tests
test a::tests::good ... ok
test a::tests::odd ... FAILED
test a::tests::bad ... FAILED

failures:

---- a::tests::odd stdout ----
a line of the student
---- a::tests::bad stdout ----

thread 'a::tests::bad' (7) panicked at src/a.rs:3:5:
the grid differs
#?.

..!
note: run with `RUST_BACKTRACE=1` environment variable to display a backtrace


failures:
    a::tests::bad
    a::tests::odd

test result: FAILED. 1 passed; 2 failed; 0 ignored; 0 measured; 0 filtered out; finished in 0.01s
";

    #[test]
    fn outcomes_have_the_message_of_the_panic() {
        let found = outcomes(PRINTED);
        assert_eq!(found.len(), 3);
        assert_eq!(found["a::tests::good"], Outcome::Passed);
        assert_eq!(
            found["a::tests::bad"],
            Outcome::Failed("the grid differs\n#?.\n\n..!".into())
        );
        assert_eq!(found["a::tests::odd"], Outcome::Failed(String::new()));
    }

    #[test]
    fn nothing_printed_is_no_outcome() {
        assert!(outcomes("").is_empty());
        assert!(outcomes("test a::b ...").is_empty());
        assert!(outcomes("test a::b ... ignored\n").is_empty());
    }

    #[test]
    fn the_last_panic_counts() {
        let twice = "thread 'x' panicked at a:1:1:\nfirst\nthread 'y' panicked at b:1:1:\nsecond\n";
        assert_eq!(panic_message(twice).unwrap(), "second");
        assert_eq!(panic_message("quiet"), None);
    }
}
