//! The study's advice.

use crate::advice::{Advice, Choice, digits, power_of_ten, times};
use crate::report::{Measured, Row};

/// The gap, over the distance, that the advice wants told apart: two millimetres a metre away.
const GAP: f64 = 2e-3;

/// How far each format goes, the farthest first, what it costs, and what it loses beyond.
pub fn advice(sweeps: &[Measured]) -> Advice {
    let Some(sweep) = sweeps.first() else {
        return Advice::default();
    };
    let mut reaches: Vec<(&'static str, usize)> = sweep
        .techniques()
        .into_iter()
        .map(|format| (format, reach(sweep, format)))
        .collect();
    // Stable: of those that go as far, the baseline stays before the others.
    reaches.sort_by_key(|(_, reach)| core::cmp::Reverse(*reach));
    let rows = reaches
        .into_iter()
        .map(|(format, reach)| choice(sweep, format, reach));
    Advice {
        baseline: sweep.techniques().first().copied().unwrap_or(""),
        rows: rows.collect(),
    }
}

fn choice(sweep: &Measured, format: &'static str, reach: usize) -> Choice {
    let setting = match last(sweep, format, reach) {
        Some(row) => format!("near / far down to {}", power_of_ten(row.setting)),
        None => "never enough".to_owned(),
    };
    let loss = sweep
        .rows_of(format)
        .last()
        .map_or_else(String::new, |row| {
            format!(
                "at {}, gaps of up to {} of the distance",
                power_of_ten(row.setting),
                digits(row.error)
            )
        });
    Choice {
        need: format!("gaps of {} of the distance seen", power_of_ten(GAP)),
        method: format.to_owned(),
        setting,
        cost: times(sweep.typical_ratio(format)),
        loss,
    }
}

/// How many settings, from the easiest on, a format tells the gap apart at.
fn reach(sweep: &Measured, format: &str) -> usize {
    sweep
        .rows_of(format)
        .take_while(|row| row.error < GAP)
        .count()
}

fn last<'a>(sweep: &'a Measured, format: &str, reach: usize) -> Option<&'a Row> {
    sweep.rows_of(format).take(reach).last()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::made_up::{self, lines, row};

    fn sweep(formats: &[(&'static str, f64, [f64; 3])]) -> Measured {
        let question = |i: usize| {
            let setting = [0.1, 0.01, 0.001][i];
            let rows = formats.iter();
            rows.map(|&(format, ratio, errors)| row(format, setting, ratio, Some(errors[i])))
                .collect()
        };
        made_up::sweep("behind", (0..3).map(question).collect())
    }

    #[test]
    fn how_far_each_goes() {
        let sweep = sweep(&[
            ("24 bits", 1.0, [1e-6, 1e-4, 3e-3]),
            ("16 bits", 1.1, [2e-3, 1e-4, 0.25]),
            ("reversed", 0.9, [1e-7; 3]),
        ]);
        let found = advice(&[sweep]);
        assert_eq!(found.baseline, "24 bits");
        let need = "gaps of 2·10⁻³ of the distance seen";
        assert_eq!(
            lines(&found),
            [
                format!(
                    "{need} | reversed | near / far down to 10⁻³ | 0.9 | at 10⁻³, gaps of up to 10⁻⁷ of the distance"
                ),
                format!(
                    "{need} | 24 bits | near / far down to 10⁻² | 1.0 | at 10⁻³, gaps of up to 0.003 of the distance"
                ),
                format!(
                    "{need} | 16 bits | never enough | 1.1 | at 10⁻³, gaps of up to 0.25 of the distance"
                ),
            ]
        );
        assert_eq!(advice(&[]), Advice::default());
    }
}
