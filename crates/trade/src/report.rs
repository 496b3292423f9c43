//! The results of a study: table, charts, advice.

#[cfg(test)]
pub(crate) mod made_up;
mod read;
mod table;
mod written;

use core::fmt::Write as _;

use ombra_math::work::{Counter, Work};

use crate::advice::Advice;
use crate::deviation::{Deviation, Measure};
use crate::statistics::Quartiles;
use crate::study::{Shown, Study};

/// What a run of a study found.
#[derive(Clone, Debug, PartialEq)]
pub struct Report {
    /// The study's id.
    pub study: &'static str,
    /// The study in one line.
    pub summary: &'static str,
    /// One of the things worked on.
    pub unit: &'static str,
    /// How errors are measured; the first is what the front goes by.
    pub errors: &'static [Measure],
    /// What a chart of counted work shows.
    pub charted_work: &'static [Counter],
    /// Its charts.
    pub shown: &'static [Shown],
    /// Why curves of some techniques end.
    pub ends: &'static [(&'static str, &'static str)],
    /// Its sweeps.
    pub sweeps: Vec<Measured>,
    /// What to take, from the numbers.
    pub advice: Advice,
}

/// A sweep with its results.
#[derive(Clone, Debug, PartialEq)]
pub struct Measured {
    /// Part of file names.
    pub name: &'static str,
    /// What is turned.
    pub knob: &'static str,
    /// From easy to hard.
    pub questions: Vec<Answered>,
}

/// A question with its results.
#[derive(Clone, Debug, PartialEq)]
pub struct Answered {
    /// What the inputs are.
    pub inputs: String,
    /// How many units one answer works on.
    pub units: usize,
    /// One row a case; the first is the baseline.
    pub rows: Vec<Row>,
}

/// A technique with its knob at one setting.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// The technique.
    pub technique: &'static str,
    /// Its knob's setting.
    pub setting: f64,
    /// Its error by the study's first measure: the same on every run.
    pub error: f64,
    /// Its errors.
    pub deviation: Deviation,
    /// How many of its answers have faults of certain kinds.
    pub faults: Vec<(&'static str, u64)>,
    /// Its counted work for all units: the same on every run.
    pub work: Work,
    /// Its time a unit, in nanoseconds.
    pub nanoseconds: Quartiles,
    /// Its time over the baseline's, the median of each round's ratio.
    pub ratio: f64,
    /// Whether no case of the same question beats it in both time (ratio) and error. Of cases that err alike with the
    /// knob at one setting only those with the fewest faults in the whole study count: what leaves gaps elsewhere is not
    /// the one to choose for a few hundredths of the time.
    pub on_front: bool,
}

impl Measured {
    /// All rows, from easy to hard.
    pub fn rows(&self) -> impl Iterator<Item = &Row> {
        self.questions.iter().flat_map(|q| &q.rows)
    }

    /// Its techniques, each once, in the order in which they first appear.
    #[must_use]
    pub fn techniques(&self) -> Vec<&'static str> {
        let mut techniques = Vec::new();
        for row in self.rows() {
            if !techniques.contains(&row.technique) {
                techniques.push(row.technique);
            }
        }
        techniques
    }

    /// The rows of one technique, from easy to hard.
    pub fn rows_of(&self, technique: &str) -> impl Iterator<Item = &Row> {
        self.rows().filter(move |row| row.technique == technique)
    }

    /// The first of `counters` that a technique moves anywhere in the sweep.
    #[must_use]
    pub fn first_moved(&self, technique: &str, counters: &[Counter]) -> Option<Counter> {
        let is_moved = |&what: &Counter| self.rows_of(technique).any(|row| row.work.get(what) > 0);
        counters.iter().copied().find(is_moved)
    }

    /// The median over the sweep of a technique's time over the baseline's.
    #[must_use]
    pub fn typical_ratio(&self, technique: &str) -> f64 {
        let ratios: Vec<f64> = self.rows_of(technique).map(|row| row.ratio).collect();
        Quartiles::of(&ratios).median
    }
}

impl Report {
    /// What a study's measurements say.
    #[must_use]
    pub(crate) fn new(study: &Study, sweeps: Vec<Measured>) -> Self {
        let advice = (study.advice)(&sweeps);
        Self {
            study: study.id,
            summary: study.summary,
            unit: study.unit,
            errors: study.errors,
            charted_work: study.charted_work,
            shown: study.charts,
            ends: study.ends,
            sweeps,
            advice,
        }
    }

    /// The advice as Markdown, with what it was measured on.
    #[must_use]
    pub fn advice_markdown(&self) -> String {
        let mut text = self.advice.to_string();
        let cases = self.sweeps.iter().flat_map(Measured::rows).count();
        let _ = writeln!(
            text,
            "\n<!-- Written by `ombra trade {}` from {cases} measured cases; the table is results.csv. -->",
            self.study
        );
        text
    }
}

#[cfg(test)]
mod tests;
