//! The study's advice.

use crate::advice::{Advice, Choice, between, extent, percent, power_of_ten, times};
use crate::report::{Measured, Row};

/// The techniques that are right everywhere, the cheapest first, then the others: where they are right, and what goes
/// wrong from where on.
pub fn advice(sweeps: &[Measured]) -> Advice {
    let Some(sweep) = sweeps.first() else {
        return Advice::default();
    };
    let is_right = |technique: &&str| sweep.rows_of(technique).all(|row| row.error == 0.0);
    let (mut right, wrong): (Vec<_>, Vec<_>) = sweep.techniques().into_iter().partition(is_right);
    right.sort_by(|a, b| sweep.typical_ratio(a).total_cmp(&sweep.typical_ratio(b)));
    let all: Vec<&'static str> = right.into_iter().chain(wrong).collect();
    let baseline = all.first().copied().unwrap_or("");
    let rows = all
        .into_iter()
        .map(|technique| choice(sweep, technique, baseline));
    Advice {
        baseline,
        rows: rows.collect(),
    }
}

/// `DDA f32`: how far it is right, and `99 % of the pixels at 10⁷ moves, up to 10⁴ beside the right one`.
fn choice(sweep: &Measured, technique: &'static str, baseline: &str) -> Choice {
    let reach = sweep
        .rows_of(technique)
        .take_while(|row| row.error == 0.0)
        .last();
    let moves = |row: Option<&Row>| row.map_or_else(String::new, |row| power_of_ten(row.setting));
    let last = sweep.rows_of(technique).last();
    let (need, setting) = match reach {
        Some(_) => ("every pixel right", format!("to {} moves", moves(reach))),
        None => ("a line, roughly", "any length".to_owned()),
    };
    let wrong = last.filter(|_| moves(reach) != moves(last));
    let loss = wrong.map_or_else(
        || "nothing".to_owned(),
        |row| {
            format!(
                "beyond: {} of the pixels at {} moves, by up to {}",
                percent(row.deviation.wrong_share()),
                power_of_ten(row.setting),
                row.deviation.max,
            )
        },
    );
    let ratios = sweep.rows_of(technique).filter_map(|row| {
        let of = sweep
            .rows_of(baseline)
            .find(|other| other.setting == row.setting)?;
        Some(row.ratio / of.ratio)
    });
    Choice {
        need: need.to_owned(),
        method: technique.to_owned(),
        setting,
        cost: between(extent(ratios), times),
        loss,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::deviation::Deviation;
    use crate::report::made_up::{self, lines};

    /// Two pixels of segments of 10 and of 1000 moves.
    fn sweep(techniques: &[(&'static str, f64, [[f64; 2]; 2])]) -> Measured {
        let question = |i: usize| {
            let rows = techniques.iter().map(|&(technique, ratio, errors)| {
                let deviation = Deviation::of(errors[i].map(Some));
                Row {
                    deviation,
                    ..made_up::row(technique, [10.0, 1000.0][i], ratio, Some(deviation.max))
                }
            });
            rows.collect()
        };
        made_up::sweep("length", vec![question(0), question(1)])
    }

    #[test]
    fn the_cheapest_right_one_the_others_and_the_wrong_ones() {
        let zero = [[0.0; 2]; 2];
        let late = [[0.0; 2], [0.0, 7.0]];
        let found = advice(&[sweep(&[
            ("slow", 2.0, zero),
            ("sum", 0.1, late),
            ("quick", 0.5, zero),
            ("never", 0.5, [[0.0, 1.0], [3.0, 1.0]]),
        ])]);
        assert_eq!(found.baseline, "quick");
        assert_eq!(
            lines(&found),
            [
                "every pixel right | quick | to 10³ moves | 1.0 | nothing",
                "every pixel right | slow | to 10³ moves | 4.0 | nothing",
                "every pixel right | sum | to 10 moves | 0.2 | beyond: 50 % of the pixels at 10³ moves, by up to 7",
                "a line, roughly | never | any length | 1.0 | beyond: 100 % of the pixels at 10³ moves, by up to 3",
            ]
        );
        assert_eq!(advice(&[]), Advice::default());
    }
}
