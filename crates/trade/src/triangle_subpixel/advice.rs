//! The study's sentence.

use crate::advice::{percent, times};
use crate::report::{Measured, Row};

/// The share of wrong pixels that the advice keeps to.
const TOLERANCE: f64 = 1e-3;

/// What the rule is worth, and how many bits are enough.
pub fn advice(sweeps: &[Measured]) -> String {
    let Some(question) = sweeps.first().and_then(|sweep| sweep.questions.first()) else {
        return String::new();
    };
    let most = |technique, kind: &str| {
        let rows = sweeps.iter().flat_map(|sweep| sweep.rows_of(technique));
        let faults = rows.flat_map(|row| &row.faults);
        let of_kind = faults.filter(|(name, _)| *name == kind);
        of_kind.map(|&(_, number)| number).max().unwrap_or(0)
    };
    let share = |number: u64| percent(number as f64 / question.units.max(1) as f64);
    let faults = most("top-left", "gaps") + most("top-left", "overlaps");
    let rule = if faults == 0 {
        format!(
            "The top-left rule draws no pixel twice and none never, whatever the sub-pixel bits, \
             while both edges inclusive draws up to {} of pixels twice and no rule leaves up to {} out",
            share(most("both inclusive", "overlaps")),
            share(most("no rule", "gaps")),
        )
    } else {
        format!("The top-left rule draws {faults} pixels twice or never")
    };
    let keeps = |row: &&Row| row.error <= TOLERANCE;
    let rows = question.rows.iter();
    let fewest = rows
        .filter(|row| row.technique == "top-left")
        .filter(keeps)
        .min_by(|a, b| a.setting.total_cmp(&b.setting));
    let bits = match fewest {
        Some(row) => format!(
            "{} bits are enough for less than {} of pixels to change their triangle ({}, at {} times the time of exact cover)",
            row.setting,
            percent(TOLERANCE),
            percent(row.error),
            times(row.ratio),
        ),
        None => format!(
            "no number of bits keeps the pixels that change their triangle below {}",
            percent(TOLERANCE)
        ),
    };
    format!("{rule}; {bits}.")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::deviation::Deviation;
    use crate::report::Answered;
    use crate::statistics::Quartiles;
    use ombra_math::work::Work;

    fn row(technique: &'static str, bits: f64, error: f64, gaps: u64, overlaps: u64) -> Row {
        Row {
            technique,
            setting: bits,
            error,
            deviation: Deviation::of([Some(error)]),
            faults: vec![("gaps", gaps), ("overlaps", overlaps)],
            work: Work::default(),
            nanoseconds: Quartiles::of(&[1.0]),
            ratio: 0.5 + bits / 10.0,
            on_front: false,
        }
    }

    fn sweep(rows: Vec<Row>) -> Measured {
        Measured {
            name: "bits",
            knob: "",
            charted: 0,
            questions: vec![Answered {
                inputs: String::new(),
                units: 1000,
                rows,
            }],
        }
    }

    #[test]
    fn the_fewest_bits_that_are_enough() {
        let rows = vec![
            row("cover", 0.0, 0.0, 0, 0),
            row("top-left", 12.0, 1e-5, 0, 0),
            row("top-left", 8.0, 5e-4, 0, 0),
            row("top-left", 4.0, 2e-3, 0, 0),
            row("both inclusive", 8.0, 0.1, 0, 3),
            row("both inclusive", 4.0, 0.1, 0, 42),
            row("no rule", 4.0, 0.1, 41, 0),
        ];
        assert_eq!(
            advice(&[sweep(rows)]),
            "The top-left rule draws no pixel twice and none never, whatever the sub-pixel bits, while both edges \
             inclusive draws up to 4.2 % of pixels twice and no rule leaves up to 4.1 % out; 8 bits are enough for less \
             than 0.10 % of pixels to change their triangle (0.050 %, at 1.3 times the time of exact cover)."
        );
        assert_eq!(
            advice(&[sweep(vec![row("top-left", 4.0, 2e-3, 1, 1)])]),
            "The top-left rule draws 2 pixels twice or never; \
             no number of bits keeps the pixels that change their triangle below 0.10 %."
        );
        assert_eq!(advice(&[]), "");
    }
}
