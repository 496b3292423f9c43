//! An exercise's file: what is above the marker line is the student's, what is below are the tests.

pub use crate::marker::{MARKER, split};

/// How many marker lines a text has.
pub fn count_markers(text: &str) -> usize {
    text.lines()
        .filter(|line| line.trim_end() == MARKER)
        .count()
}

/// The module of the tests: what follows the marker line and the entry point.
pub fn test_module(below: &str) -> &str {
    let start = below.find("#[cfg(test)]").unwrap_or(below.len());
    below.get(start..).unwrap_or_default()
}

/// The names of the test functions of a text, in their order, each as libtest prints it.
pub fn test_names(below: &str) -> Vec<String> {
    let mut names = Vec::new();
    let mut is_test = false;
    for line in below.lines().map(str::trim) {
        if line == "#[test]" {
            is_test = true;
        } else if let Some(rest) = line.strip_prefix("fn ") {
            if is_test && let Some((name, _)) = rest.split_once('(') {
                names.push(name.to_owned());
            }
            is_test = false;
        }
    }
    names
}

/// What a wrong answer says of itself in its first line: `// rejected by TEST: PHRASE`.
#[derive(Debug, PartialEq, Eq)]
pub struct Rejection<'a> {
    /// The test that must reject it.
    pub test: &'a str,
    /// What the message must contain.
    pub phrase: &'a str,
}

/// The rejection that a wrong answer states.
pub fn rejection(text: &str) -> Option<Rejection<'_>> {
    let (test, phrase) = text
        .lines()
        .next()?
        .strip_prefix("// rejected by ")?
        .split_once(": ")?;
    let (test, phrase) = (test.trim(), phrase.trim());
    (!test.is_empty() && !phrase.is_empty()).then_some(Rejection { test, phrase })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn split_parts_at_the_first_marker() {
        let text = format!("answer\n{MARKER}\ntests\n{MARKER}\n");
        let (above, below) = split(&text).unwrap();
        assert_eq!(above, "answer\n");
        assert_eq!(below, &text["answer\n".len()..]);
        assert_eq!(count_markers(&text), 2);
    }

    #[test]
    fn split_takes_windows_lines_and_a_marker_at_either_end() {
        let windows = format!("answer\r\n{MARKER}\r\ntests\r\n");
        assert_eq!(split(&windows).unwrap().0, "answer\r\n");
        assert_eq!(split(MARKER), Some(("", MARKER)));
        let last = format!("answer\n{MARKER}");
        assert_eq!(split(&last), Some(("answer\n", MARKER)));
    }

    #[test]
    fn split_wants_the_whole_line() {
        assert_eq!(split(""), None);
        assert_eq!(split("answer\n// ---- tests\n"), None);
        assert_eq!(split(&format!("let s = \"{MARKER}\";\n")), None);
    }

    #[test]
    fn test_names_are_those_under_the_attribute() {
        let below = "
            fn main() {}
            mod tests {
                fn examine(a: u8) {}
                #[test]
                fn first() {}
                #[test]
                #[ignore]
                fn second() {
                    fn inner() {}
                }
            }";
        assert_eq!(test_names(below), ["first", "second"]);
    }

    #[test]
    fn rejection_reads_the_first_line_only() {
        let stated = rejection("// rejected by any: transposed: see E1\nfn f() {}\n").unwrap();
        assert_eq!((stated.test, stated.phrase), ("any", "transposed: see E1"));
        assert_eq!(rejection("fn f() {}\n// rejected by any: late\n"), None);
        assert_eq!(rejection("// rejected by any: \n"), None);
        assert_eq!(rejection(""), None);
    }
}
