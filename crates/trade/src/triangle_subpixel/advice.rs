//! The study's sentence.

use crate::advice::{percent, times};
use crate::report::{Measured, Row};

/// The share of wrong pixels that the advice keeps to.
const TOLERANCE: f64 = 1e-3;

/// What the rule is worth, how many bits are enough, and what integers save.
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
            "With the top-left rule every pixel is drawn exactly once, whatever the sub-pixel bits; \
             where both triangles own their common edge up to {} of the pixels are drawn twice, \
             and where neither does up to {} are left out",
            share(most("both inclusive", "overlaps")),
            share(most("no rule", "gaps")),
        )
    } else {
        format!("With the top-left rule {faults} pixels are drawn twice or not at all")
    };
    let top_left = || {
        question
            .rows
            .iter()
            .filter(|row| row.technique == "top-left")
    };
    let fewest = top_left()
        .filter(|row| row.error <= TOLERANCE)
        .min_by(|a, b| a.setting.total_cmp(&b.setting));
    let bits = match fewest {
        Some(row) => format!(
            "{} bits are enough for at most {} of the pixels to go to another triangle ({} do{}), \
             and let the edge functions be integers, in {} times the time of exact cover",
            row.setting,
            percent(TOLERANCE),
            percent(row.error),
            fewer(top_left(), row),
            times(row.ratio),
        ),
        None => format!(
            "no number of bits keeps the pixels that go to another triangle below {}",
            percent(TOLERANCE)
        ),
    };
    format!("{rule}; {bits}.")
}

/// `, 0.60 % with 4`: what the next fewer bits cost.
fn fewer<'a>(rows: impl Iterator<Item = &'a Row>, enough: &Row) -> String {
    let less = rows.filter(|row| row.setting < enough.setting);
    let next = less.max_by(|a, b| a.setting.total_cmp(&b.setting));
    let text = |row: &Row| format!(", {} with {}", percent(row.error), row.setting);
    next.map(text).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::made_up;

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
            "With the top-left rule every pixel is drawn exactly once, whatever the sub-pixel bits; where both \
             triangles own their common edge up to 4.2 % of the pixels are drawn twice, and where neither does up to \
             4.1 % are left out; 8 bits are enough for at most 0.10 % of the pixels to go to another triangle \
             (0.050 % do, 0.20 % with 4), and let the edge functions be integers, in 1.3 times the time of exact cover."
        );
        assert_eq!(
            advice(&[sweep(vec![row("top-left", 4.0, 2e-3, 1, 1)])]),
            "With the top-left rule 2 pixels are drawn twice or not at all; \
             no number of bits keeps the pixels that go to another triangle below 0.10 %."
        );
        assert_eq!(advice(&[]), "");
    }
}
