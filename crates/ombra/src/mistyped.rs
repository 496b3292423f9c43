//! What is said of a command line that cannot be read: one sentence, with what is allowed.

use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{Command, Error};

/// The sentence, or none where clap's own answer is wanted: help and version.
pub fn sentence(error: &Error, arguments: &Command, typed: &[String]) -> Option<String> {
    let named = |kind| match error.get(kind) {
        Some(ContextValue::String(text)) => Some(text.as_str()),
        Some(ContextValue::Strings(texts)) => texts.first().map(String::as_str),
        _ => None,
    };
    // clap names options together with their values: `--size <SIZE>`.
    let option = named(ContextKind::InvalidArg);
    let option = option.map(|text| text.split_whitespace().next().unwrap_or(text));
    let command = typed
        .iter()
        .find_map(|word| arguments.find_subcommand(word))
        .unwrap_or(arguments);
    let allowed = allowed(command);
    Some(match (error.kind(), option) {
        (ErrorKind::DisplayHelp | ErrorKind::DisplayVersion, _) => return None,
        (ErrorKind::UnknownArgument, Some(option)) => {
            format!("there is no option or argument '{option}': {allowed}")
        }
        (ErrorKind::InvalidValue | ErrorKind::WrongNumberOfValues, Some(option)) => {
            format!("{option} needs a value: {}", meaning(command, option))
        }
        (ErrorKind::TooManyValues, Some(option)) => {
            let value = named(ContextKind::InvalidValue).unwrap_or_default();
            format!("{option} takes no value '{value}': {allowed}")
        }
        (ErrorKind::ArgumentConflict, Some(option)) => {
            match named(ContextKind::PriorArg).and_then(|text| text.split_whitespace().next()) {
                Some(other) if other != option => {
                    format!("{option} cannot stand beside {other}: give one of them")
                }
                _ => format!("{option} is there twice: give it once"),
            }
        }
        (ErrorKind::InvalidSubcommand, _) => {
            let word = named(ContextKind::InvalidSubcommand).unwrap_or_default();
            format!("there is no command '{word}': {allowed}")
        }
        (ErrorKind::InvalidUtf8, _) => format!("an argument is not text in UTF-8: {allowed}"),
        _ => format!("a command is missing: {allowed}"),
    })
}

/// `'ombra figures' takes --format, --size`.
fn allowed(command: &Command) -> String {
    let commands = command.get_subcommands().map(|c| c.get_name().to_owned());
    let options = command
        .get_arguments()
        .filter_map(|argument| Some(format!("--{}", argument.get_long()?)));
    let all: Vec<String> = commands.chain(options).collect();
    let name = command.get_bin_name().unwrap_or(command.get_name());
    format!("'{name}' takes {}", all.join(", "))
}

/// The help of an option.
fn meaning(command: &Command, option: &str) -> String {
    let long = option.trim_start_matches('-');
    command
        .get_arguments()
        .find(|argument| argument.get_long() == Some(long))
        .and_then(|argument| Some(argument.get_help()?.to_string()))
        .unwrap_or_else(|| allowed(command))
}

#[cfg(test)]
mod tests {
    use clap::{CommandFactory as _, Parser as _};

    use super::*;
    use crate::Arguments;

    fn said(words: &[&str]) -> Option<String> {
        let typed: Vec<String> = ["ombra"].iter().chain(words).map(|&w| w.into()).collect();
        let error = Arguments::try_parse_from(&typed).err()?;
        let mut arguments = Arguments::command();
        arguments.build();
        sentence(&error, &arguments, typed.get(1..)?)
    }

    #[test]
    fn a_mistyped_option_is_one_sentence_with_what_is_allowed() {
        for (words, parts) in [
            (
                &["figures", "--thme", "dark"][..],
                &[
                    "no option or argument '--thme'",
                    "'ombra figures' takes",
                    "--theme",
                ][..],
            ),
            (&["figures", "-x"], &["'-x'", "--size"]),
            (
                &["list", "raster"],
                &["'raster'", "'ombra list' takes --lang"],
            ),
            (
                &["figures", "--size"],
                &["--size needs a value", "WIDTHxHEIGHT"],
            ),
            (&["figures", "--text=yes"], &["--text takes no value 'yes'"]),
            (
                &["figures", "--docs", "--size", "640x360"],
                &["--docs cannot stand beside --size"],
            ),
            (
                &["figures", "--lang", "en", "--lang", "it"],
                &["--lang is there twice"],
            ),
            (
                &["figurs"],
                &["no command 'figurs'", "figures, trade, list"],
            ),
            (&["--quick"], &["'--quick'", "figures, trade, list"]),
            (&[], &["a command is missing", "figures, trade, list"]),
        ] {
            let sentence = said(words).unwrap();
            assert!(!sentence.contains('\n'), "{words:?}: {sentence}");
            for part in parts {
                assert!(sentence.contains(part), "{words:?}: {sentence}");
            }
        }
    }

    #[test]
    fn help_and_version_are_no_mistakes() {
        for words in [&["--help"][..], &["figures", "-h"], &["--version"]] {
            assert_eq!(said(words), None, "{words:?}");
        }
    }
}
