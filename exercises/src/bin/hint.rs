//! One hint more for an exercise: `cargo run --bin hint math1`.

use std::process::ExitCode;

use ombra_exercises::{Exercise, exercises, find, read, root, write};

/// The file that remembers how many hints were shown, a line an exercise: its name and a number.
const SHOWN: &str = ".hints.txt";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match run(&arguments) {
        Ok(text) => {
            println!("{text}");
            ExitCode::SUCCESS
        }
        Err(sentence) => {
            eprintln!("error: {sentence}");
            ExitCode::from(2)
        }
    }
}

fn run(arguments: &[String]) -> Result<String, String> {
    let exercises = exercises(&read(&root().join("info.toml"))?);
    let shown = read(&root().join(SHOWN)).unwrap_or_default();
    match arguments {
        [] => Ok(list(&exercises, &shown)),
        [asked] => {
            let exercise = find(&exercises, asked)?;
            let number = (count(&shown, exercise) + 1).min(exercise.hints.len());
            let text = hint(exercise, number)?;
            let remembered = remember(&exercises, &shown, exercise, number);
            write(&root().join(SHOWN), remembered.as_bytes())?;
            Ok(text)
        }
        [asked, number] => {
            let exercise = find(&exercises, asked)?;
            let wrong = || format!("{number:?} is no hint of {}: it has 1 to {}", exercise.name, exercise.hints.len());
            hint(exercise, number.parse().map_err(|_| wrong())?).map_err(|_| wrong())
        }
        _ => Err("one exercise is asked for, and at most the number of a hint: `cargo run --bin hint math1 2`".to_owned()),
    }
}

fn list(exercises: &[Exercise], shown: &str) -> String {
    let mut text = String::new();
    for exercise in exercises {
        let (seen, all) = (count(shown, exercise), exercise.hints.len());
        text += &format!("{:<32} {seen} of {all} hints shown\n", exercise.name);
    }
    text + "\nThe next hint of an exercise: cargo run --bin hint math1\nA hint again: cargo run --bin hint math1 2"
}

/// How many hints of an exercise were shown.
fn count(shown: &str, exercise: &Exercise) -> usize {
    let mut lines = shown.lines().filter_map(|line| line.split_once(' '));
    lines
        .find(|(name, _)| *name == exercise.name)
        .and_then(|(_, number)| number.trim().parse().ok())
        .unwrap_or(0)
}

/// The lines of the file after hint `number` of `exercise` was shown.
fn remember(exercises: &[Exercise], shown: &str, exercise: &Exercise, number: usize) -> String {
    let line = |other: &Exercise| {
        let number = if other == exercise {
            number
        } else {
            count(shown, other)
        };
        (number > 0).then(|| format!("{} {number}\n", other.name))
    };
    exercises.iter().filter_map(line).collect()
}

fn hint(exercise: &Exercise, number: usize) -> Result<String, String> {
    let hint = number.checked_sub(1).and_then(|at| exercise.hints.get(at));
    let hint = hint.ok_or_else(|| format!("{} has no hint {number}", exercise.name))?;
    let Exercise { name, dir, hints } = exercise;
    let next = if number < hints.len() {
        format!("For the next one: cargo run --bin hint {name}")
    } else {
        format!("That was the last one. A solution is in solutions/{dir}/{name}.rs.")
    };
    Ok(format!(
        "{name}, hint {number} of {}\n\n{hint}\n\n{next}",
        hints.len()
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn two() -> Vec<Exercise> {
        ["a1", "a12"]
            .map(|name| Exercise {
                name: name.to_owned(),
                dir: "a".to_owned(),
                hints: ["idea", "step", "code"].map(str::to_owned).to_vec(),
            })
            .to_vec()
    }

    #[test]
    fn hints_come_one_after_another() {
        let all = two();
        let mut shown = String::new();
        for number in 1..=3 {
            assert_eq!(count(&shown, &all[0]) + 1, number);
            shown = remember(&all, &shown, &all[0], number);
        }
        shown = remember(&all, &shown, &all[1], 1);
        assert_eq!(shown, "a1 3\na12 1\n");
    }

    #[test]
    fn a_hint_says_what_comes_after_it() {
        let all = two();
        let said = hint(&all[0], 1).unwrap_or_default();
        assert!(
            said.contains("idea") && said.ends_with("cargo run --bin hint a1"),
            "{said}"
        );
        let said = hint(&all[0], 3).unwrap_or_default();
        assert!(said.ends_with("solutions/a/a1.rs."), "{said}");
        assert!(hint(&all[0], 0).is_err() && hint(&all[0], 4).is_err());
    }

    #[test]
    fn a_file_of_another_form_counts_nothing() {
        for shown in ["", "a1\n", "a1 many\n", "a12 1\n"] {
            assert_eq!(count(shown, &two()[0]), 0, "{shown:?}");
        }
    }
}
