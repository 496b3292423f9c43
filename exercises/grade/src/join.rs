//! The tests and a student's part in one module, the tests in front.
//!
//! A student's `macro_rules! assert` counts from its line on, so it cannot reach tests that stand before it.

use crate::exercise_file::test_module;

/// The module of the tests of `below`, then `answer`. The answer's leading inner attributes stay first, where Rust
/// wants them.
pub fn join(answer: &str, below: &str) -> String {
    let (leading, rest) = parts(answer);
    format!("{leading}\n{}\n{rest}", test_module(below))
}

/// The same with the tests in a file of their own, so that the lines of the answer keep their numbers.
pub fn join_file(answer: &str, name: &str, tests: &str) -> String {
    let (leading, rest) = parts(answer);
    format!("{leading}{}{rest}", tests_line(name, tests))
}

/// What `join_file` puts in.
fn tests_line(name: &str, tests: &str) -> String {
    format!("#[path = \"{tests}\"] pub mod {name}; ")
}

/// What the compiler said of a file made by `join_file`, as if the tests were not there.
pub fn without_tests(said: &str, name: &str, tests: &str) -> String {
    let line = tests_line(name, tests);
    // The compiler shows lines as `NUMBER | TEXT`, marks below them as ` | MARKS`, and places as `FILE:NUMBER:COLUMN`.
    let shown = said.lines().find(|one| one.contains(&line));
    let number = shown
        .and_then(|one| one.split_once('|'))
        .map_or("", |(number, _)| number.trim());
    let place = format!("/{name}.rs:{number}:");
    let (mut text, mut shift) = (String::new(), 0);
    for one in said.split_inclusive('\n') {
        let marks = one
            .split_once("| ")
            .filter(|(gutter, _)| shift > 0 && gutter.trim().is_empty());
        if let Some((before, after)) = one.split_once(&line) {
            shift = line.len();
            text += before;
            text += after;
        } else if let Some((gutter, marks)) = marks {
            let spaces = marks.len() - marks.trim_start_matches(' ').len();
            text += gutter;
            text += "| ";
            text += marks.get(shift.min(spaces)..).unwrap_or_default();
        } else {
            shift = 0;
            text += &match one.split_once(&place) {
                Some((before, column)) if shown.is_some() => {
                    let column = column.trim_end().parse().unwrap_or(0_usize);
                    format!(
                        "{before}{place}{}\n",
                        column.saturating_sub(line.len()).max(1)
                    )
                }
                _ => one.to_owned(),
            };
        }
    }
    text
}

fn parts(answer: &str) -> (&str, &str) {
    let answer = answer.strip_prefix('\u{feff}').unwrap_or(answer);
    answer.split_at(inner_attributes(answer))
}

/// How far the inner attributes `#![…]` and inner comments `//!` reach that begin a text, with what stands between.
pub fn inner_attributes(text: &str) -> usize {
    let (mut at, mut end) = (0, 0);
    loop {
        let rest = text.get(at..).unwrap_or_default();
        let (length, is_inner) = if rest.starts_with(char::is_whitespace) {
            (rest.len() - rest.trim_start().len(), false)
        } else if rest.starts_with("//!") {
            (line(rest), true)
        } else if rest.starts_with("//") && (!rest.starts_with("///") || rest.starts_with("////")) {
            (line(rest), false)
        } else if rest.starts_with("/*!") {
            (block_comment(rest), true)
        } else if rest.starts_with("/*")
            && (!rest.starts_with("/**") || rest.starts_with("/***") || rest.starts_with("/**/"))
        {
            (block_comment(rest), false)
        } else if let Some(length) = attribute(rest) {
            (length, true)
        } else {
            return end;
        };
        at += length;
        if is_inner {
            end = at;
        }
    }
}

fn line(rest: &str) -> usize {
    rest.find('\n').map_or(rest.len(), |at| at + 1)
}

/// The length of a comment `/* … */`, which may hold others.
fn block_comment(rest: &str) -> usize {
    let (mut depth, mut at) = (0_usize, 0);
    let bytes = rest.as_bytes();
    while let Some(pair) = bytes.get(at..at + 2) {
        match pair {
            b"/*" => (depth, at) = (depth + 1, at + 2),
            b"*/" => (depth, at) = (depth.saturating_sub(1), at + 2),
            _ => at += 1,
        }
        if depth == 0 {
            return at;
        }
    }
    rest.len()
}

/// The length of `#![…]` at the start of a text, the brackets in strings aside.
fn attribute(rest: &str) -> Option<usize> {
    let open = rest
        .strip_prefix('#')?
        .trim_start()
        .strip_prefix('!')?
        .trim_start();
    open.starts_with('[').then_some(())?;
    let start = rest.len() - open.len();
    let (mut depth, mut in_string, mut escaped) = (0_usize, false, false);
    for (at, byte) in open.bytes().enumerate() {
        match byte {
            _ if escaped => escaped = false,
            b'\\' if in_string => escaped = true,
            b'"' => in_string = !in_string,
            b'[' if !in_string => depth += 1,
            b']' if !in_string => {
                depth -= 1;
                if depth == 0 {
                    return Some(start + at + 1);
                }
            }
            _ => {}
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn inner_attributes_end_before_the_first_item() {
        for (text, leading) in [
            ("use a::b;\n", ""),
            ("// note\nuse a::b;\n", ""),
            ("/// of f\nfn f() {}\n", ""),
            ("#[inline]\nfn f() {}\n", ""),
            ("#![allow(x)]\nuse a;\n", "#![allow(x)]"),
            (
                "// note\n\n#![allow(x)] // why\n//! file\n\nuse a;",
                "// note\n\n#![allow(x)] // why\n//! file\n",
            ),
            (
                "#![doc = \"a ] \\\" b\"]fn f() {}",
                "#![doc = \"a ] \\\" b\"]",
            ),
            (
                "#! [ cfg_attr(a, b[0]) ]fn f() {}",
                "#! [ cfg_attr(a, b[0]) ]",
            ),
            (
                "/* /* in */ out */#![a]\n/** of f */fn f() {}",
                "/* /* in */ out */#![a]",
            ),
            ("#![never", ""),
            ("/* never", ""),
            ("", ""),
        ] {
            assert_eq!(text.split_at(inner_attributes(text)).0, leading, "{text:?}");
        }
    }

    #[test]
    fn tests_stand_before_the_answer() {
        let below = "// marker\n\nfn main() {}\n\n#[cfg(test)]\nmod a1 {\n    use super::f;\n}\n";
        assert_eq!(
            join(
                "\u{feff}#![allow(x)]\nmacro_rules! assert { () => {} }\n",
                below
            ),
            "#![allow(x)]\n#[cfg(test)]\nmod a1 {\n    use super::f;\n}\n\n\nmacro_rules! assert { () => {} }\n"
        );
    }

    #[test]
    fn the_compiler_is_quoted_without_the_line_of_the_tests() {
        let line = "#[path = \"tests/a1.rs\"] pub mod a1; ";
        let column = line.len() + 5;
        let said = format!(
            "error: no\n --> x/a1.rs:1:{column}\n  |\n1 | {line}use b;\n  | {}^ here\n  = note: |  kept\n --> x/a1.rs:2:7\n",
            " ".repeat(column - 1)
        );
        assert_eq!(
            without_tests(&said, "a1", "tests/a1.rs"),
            "error: no\n --> x/a1.rs:1:5\n  |\n1 | use b;\n  |     ^ here\n  = note: |  kept\n --> x/a1.rs:2:7\n"
        );
        assert_eq!(
            without_tests("error: x/a1.rs:1:9\n", "a1", "tests/a1.rs"),
            "error: x/a1.rs:1:9\n"
        );
    }
}
