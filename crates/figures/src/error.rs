//! Why a figure could not be drawn, in one sentence that names the offending value.

use core::fmt;

/// What was wrong with a figure's options, its object, its labels or the place it should be written to.
#[derive(Clone, Debug, PartialEq)]
pub enum FigureError {
    /// An option has a value that it cannot have.
    Value {
        /// The option, as typed: `--theme`.
        option: &'static str,
        /// What was given.
        value: String,
        /// What it takes.
        allowed: String,
    },
    /// An input of a figure has a value that it cannot have.
    Input {
        /// Its name.
        name: &'static str,
        /// What was given.
        value: String,
        /// What it takes.
        allowed: String,
    },
    /// No figure and no lecture has this name, or this part of a name.
    UnknownFigure {
        /// What was given.
        pattern: String,
        /// The names that come nearest to it.
        nearest: String,
    },
    /// An object could not be read from a file.
    Object {
        /// The file's name as given.
        file: String,
        /// What is wrong with it and what is allowed.
        reason: String,
    },
    /// The object, light and plane together leave nothing to draw.
    Scene {
        /// What is wrong, with its values.
        reason: String,
    },
    /// The embedded typeface cannot be read.
    Font,
    /// The embedded typeface lacks a character.
    MissingGlyph {
        /// The character.
        character: char,
        /// The label it stands in.
        text: String,
    },
    /// A label's markup does not parse.
    Markup {
        /// The label.
        text: String,
        /// What is wrong with it.
        reason: &'static str,
    },
    /// A value of a chart cannot be drawn on its axis.
    Chart {
        /// What is wrong, with its value.
        reason: String,
    },
    /// A file or folder could not be written.
    Write {
        /// Its path.
        path: String,
        /// What the system said.
        reason: String,
    },
}

impl fmt::Display for FigureError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Value {
                option,
                value,
                allowed,
            } => write!(f, "{option} cannot be '{value}': it is {allowed}"),
            Self::Input {
                name,
                value,
                allowed,
            } => write!(f, "the input {name} cannot be '{value}': it is {allowed}"),
            Self::UnknownFigure { pattern, nearest } => write!(
                f,
                "there is no figure or lecture '{pattern}'; the nearest are {nearest}; 'ombra list' names all"
            ),
            Self::Object { file, reason } => write!(f, "--mesh {file}: {reason}"),
            Self::Scene { reason } => f.write_str(reason),
            Self::Font => f.write_str("the embedded typeface cannot be read"),
            Self::MissingGlyph { character, text } => write!(
                f,
                "the label '{text}' has the character '{character}' (U+{:04X}), which the figures' typeface lacks",
                u32::from(*character)
            ),
            Self::Markup { text, reason } => {
                write!(f, "the label '{text}' does not parse: {reason}")
            }
            Self::Chart { reason } => f.write_str(reason),
            Self::Write { path, reason } => write!(f, "{path} cannot be written: {reason}"),
        }
    }
}

impl core::error::Error for FigureError {}
