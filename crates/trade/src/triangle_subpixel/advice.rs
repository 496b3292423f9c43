//! The study's advice.

use crate::advice::{Advice, Choice, between, extent, lost, percent, times};
use crate::report::{Measured, Row};

/// The share of wrong pixels that the advice keeps to.
const TOLERANCE: f64 = 1e-3;

/// How many bits are enough, what the next fewer lose, who is exact, and what the rule is worth.
pub fn advice(sweeps: &[Measured]) -> Advice {
    let Some(question) = sweeps.first().and_then(|sweep| sweep.questions.first()) else {
        return Advice::default();
    };
    let of = |technique: &'static str| {
        question
            .rows
            .iter()
            .filter(move |row| row.technique == technique)
    };
    let by_bits = |a: &&Row, b: &&Row| a.setting.total_cmp(&b.setting);
    let enough = of("top-left")
        .filter(|row| row.error <= TOLERANCE)
        .min_by(by_bits);
    let fewer = of("top-left")
        .filter(|row| enough.is_none_or(|enough| row.setting < enough.setting))
        .max_by(by_bits);
    let bits = |row: &Row, need: String| Choice {
        need,
        method: row.technique.to_owned(),
        setting: format!("{} bits", row.setting),
        cost: times(row.ratio),
        loss: lost(row.error, |share| {
            format!("{} of the pixels go to a neighbour", percent(share))
        }),
    };
    let keep = percent(TOLERANCE);
    let mut rows: Vec<Choice> = enough
        .map(|row| {
            bits(
                row,
                format!("each pixel once, at most {keep} by a neighbour"),
            )
        })
        .into_iter()
        .chain(fewer.map(|row| bits(row, "each pixel once, larger coordinates".to_owned())))
        .chain(
            of("cover")
                .max_by(by_bits)
                .map(|row| bits(row, "each pixel by its owner".to_owned())),
        )
        .collect();
    // What each rule draws twice, or not at all, at its worst.
    let shared = |technique: &'static str, need: &str| {
        let measured = || {
            sweeps
                .iter()
                .flat_map(move |sweep| sweep.rows_of(technique))
        };
        let most = |kind: &str| {
            let faults = measured().flat_map(|row| &row.faults);
            let of_kind = faults
                .filter(|(name, _)| *name == kind)
                .map(|&(_, number)| number);
            of_kind.max().unwrap_or(0) as f64 / question.units.max(1) as f64
        };
        measured().next()?;
        let parts = [
            (most("overlaps"), "drawn twice"),
            (most("gaps"), "left out"),
        ];
        let parts = parts.iter().filter(|(share, _)| *share > 0.0);
        let parts: Vec<String> = parts
            .map(|(share, what)| format!("up to {} {what}", percent(*share)))
            .collect();
        Some(Choice {
            need: need.to_owned(),
            method: technique.to_owned(),
            setting: "any bits".to_owned(),
            cost: between(extent(of(technique).map(|row| row.ratio)), times),
            loss: match parts.as_slice() {
                [] => "no pixel drawn twice or left out".to_owned(),
                parts => parts.join(", "),
            },
        })
    };
    let rules = [
        ("top-left", "no gap, no overlap"),
        ("both inclusive", "never: edges drawn by both"),
        ("no rule", "never: edges drawn by none"),
    ];
    rows.extend(
        rules
            .into_iter()
            .filter_map(|(technique, need)| shared(technique, need)),
    );
    Advice {
        baseline: question.rows.first().map_or("", |row| row.technique),
        rows,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::made_up::{self, lines};

    fn row(technique: &'static str, bits: f64, error: f64, gaps: u64, overlaps: u64) -> Row {
        Row {
            faults: vec![("gaps", gaps), ("overlaps", overlaps)],
            ..made_up::row(technique, bits, 0.5 + bits / 10.0, Some(error))
        }
    }

    fn sweep(rows: Vec<Row>) -> Measured {
        made_up::sweep("bits", vec![rows])
    }

    #[test]
    fn the_fewest_bits_that_are_enough() {
        let rows = vec![
            row("cover", 5.0, 0.0, 0, 0),
            row("top-left", 12.0, 1e-5, 0, 0),
            row("top-left", 8.0, 5e-4, 0, 0),
            row("top-left", 4.0, 2e-3, 0, 0),
            row("both inclusive", 8.0, 0.1, 0, 3),
            row("both inclusive", 4.0, 0.1, 0, 42),
            row("no rule", 4.0, 0.1, 41, 0),
        ];
        let found = advice(&[sweep(rows)]);
        assert_eq!(found.baseline, "cover");
        assert_eq!(
            lines(&found),
            [
                "each pixel once, at most 0.10 % by a neighbour | top-left | 8 bits | 1.3 | 0.050 % of the pixels go to a neighbour",
                "each pixel once, larger coordinates | top-left | 4 bits | 0.9 | 0.20 % of the pixels go to a neighbour",
                "each pixel by its owner | cover | 5 bits | 1.0 | nothing",
                "no gap, no overlap | top-left | any bits | 0.9 to 1.7 | no pixel drawn twice or left out",
                "never: edges drawn by both | both inclusive | any bits | 0.9 to 1.3 | up to 4.2 % drawn twice",
                "never: edges drawn by none | no rule | any bits | 0.9 | up to 4.1 % left out",
            ]
        );
        let gaping = advice(&[sweep(vec![row("top-left", 4.0, 2e-3, 1, 1)])]);
        assert_eq!(
            lines(&gaping),
            [
                "each pixel once, larger coordinates | top-left | 4 bits | 0.9 | 0.20 % of the pixels go to a neighbour",
                "no gap, no overlap | top-left | any bits | 0.9 | up to 0.10 % drawn twice, up to 0.10 % left out",
            ]
        );
        assert_eq!(advice(&[]), Advice::default());
    }
}
