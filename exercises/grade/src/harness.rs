//! The program that runs one test of an answer, and proves that the test came to its end.
//!
//! Rust's own test programs print `ok`, which an answer can print too. This one reads a random token before any line of
//! an answer runs, and hands it back after the assertions have passed: an answer that ends the program, or prints whatever
//! it likes, does not know the token.

use std::hash::{BuildHasher, Hasher, RandomState};

use crate::exercise_file::test_module;

/// A token that nobody can guess.
pub fn token() -> String {
    let random = || RandomState::new().build_hasher().finish();
    format!("{:016x}{:016x}", random(), random())
}

/// The tests of `below` as plain functions that a program of ours can call: those in `mod NAME`, without the attributes
/// by which Rust's own test programs find them.
pub fn callable(below: &str) -> String {
    let mut text = String::new();
    let mut is_test = false;
    for line in test_module(below).lines() {
        match line.trim() {
            // The file is the module: `#[path = "…"] pub mod NAME;`.
            "#[cfg(test)]" => {}
            "#[test]" => is_test = true,
            trimmed if is_test && trimmed.starts_with("fn ") => {
                is_test = false;
                text += &line.replacen("fn ", "pub fn ", 1);
            }
            _ if line.starts_with("mod ") || line == "}" => {}
            _ => text += line,
        }
        text.push('\n');
    }
    text
}

/// The entry point: `tests` are names as the command line has them, and paths of the functions.
///
/// After the seconds that the command line names second it ends by itself: the one that runs it may be gone.
pub fn main(tests: &[(String, String)]) -> String {
    let arms: String = tests
        .iter()
        .map(|(name, path)| format!("        \"{name}\" => {path},\n"))
        .collect();
    // No macro is used and every path begins at its crate: an answer may define both anew.
    format!(
        "fn main() {{
    let mut token = ::std::string::String::new();
    let _ = ::std::io::Read::read_to_string(&mut ::std::io::stdin(), &mut token);
    let name = ::std::env::args().nth(1).unwrap_or_default();
    let test: fn() = match name.as_str() {{
{arms}        _ => ::std::process::exit(3),
    }};
    let seconds = ::std::env::args().nth(2).and_then(|text| text.parse().ok()).unwrap_or(3600);
    ::std::thread::spawn(move || {{
        ::std::thread::sleep(::std::time::Duration::from_secs(seconds));
        ::std::process::exit(4);
    }});
    let running = ::std::thread::Builder::new().name(name).spawn(test);
    if running.is_ok_and(|thread| thread.join().is_ok()) {{
        let _ = ::std::io::Write::write_all(&mut ::std::io::stdout(), token.as_bytes());
        let _ = ::std::io::Write::flush(&mut ::std::io::stdout());
        ::std::process::exit(0);
    }}
    ::std::process::exit(101);
}}
"
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tests_become_functions() {
        let below = "// marker\n\nfn main() {}\n\n#[cfg(test)]\nmod a1 {\n    use super::f;\n\n    fn help() {}\n\n    \
                     #[test]\n    fn one() {\n        f();\n    }\n}\n";
        assert_eq!(
            callable(below),
            "\n\n    use super::f;\n\n    fn help() {}\n\n\n    pub fn one() {\n        f();\n    }\n\n"
        );
    }

    #[test]
    fn no_two_tokens_are_the_same() {
        assert_ne!(token(), token());
        assert_eq!(token().len(), 32);
    }
}
