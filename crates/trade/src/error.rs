//! Why a study could not be run or written, in one sentence.

use core::fmt;

use ombra_figures::error::FigureError;

/// What went wrong.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum TradeError {
    /// No study has this name.
    UnknownStudy {
        /// What was given.
        name: String,
        /// The studies there are.
        allowed: String,
    },
    /// A technique answers differently when its work is counted, so its errors would not be those of what was timed.
    Differs {
        /// The study's id.
        study: &'static str,
        /// The technique.
        technique: &'static str,
        /// Its knob's setting.
        setting: f64,
    },
    /// Stored results cannot be read.
    Table {
        /// The file, or the study's id where there is none.
        file: String,
        /// What is wrong with it and what is allowed.
        reason: String,
    },
    /// A chart could not be drawn, or a file not be written.
    Figure(FigureError),
}

impl fmt::Display for TradeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::UnknownStudy { name, allowed } => {
                write!(f, "there is no study '{name}': there are {allowed}")
            }
            Self::Differs {
                study,
                technique,
                setting,
            } => write!(
                f,
                "{study}: '{technique}' at {setting:e} answers differently when its work is counted; both runs must agree"
            ),
            Self::Table { file, reason } => write!(f, "{file}: {reason}"),
            Self::Figure(error) => error.fmt(f),
        }
    }
}

impl core::error::Error for TradeError {}

impl From<FigureError> for TradeError {
    fn from(error: FigureError) -> Self {
        Self::Figure(error)
    }
}
