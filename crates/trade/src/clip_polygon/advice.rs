//! The study's advice.

use crate::advice::{Advice, Choice, between, digits, extent, power_of_ten, times};
use crate::report::{Measured, Row};

/// The error of areas that the advice keeps to.
const TOLERANCE: f64 = 1e-12;
/// The sweep over the distance of the vertices.
const FAR: &str = "far-star";

/// The cheapest technique that is right everywhere, what the others take, and what the wrong ones get wrong.
pub fn advice(sweeps: &[Measured]) -> Advice {
    let keep = power_of_ten(TOLERANCE);
    let techniques = sweeps.first().map(Measured::techniques).unwrap_or_default();
    let is_right = |name: &&str| {
        let mut rows = rows_of(sweeps, name);
        rows.all(|row| row.error <= TOLERANCE && outside(row) == 0)
    };
    let (mut right, wrong): (Vec<_>, Vec<_>) = techniques.into_iter().partition(is_right);
    let time = |name: &str| -> f64 { sweeps.iter().map(|s| s.typical_ratio(name)).sum() };
    right.sort_by(|a, b| time(a).total_cmp(&time(b)));
    let all: Vec<&'static str> = right.iter().chain(&wrong).copied().collect();
    let baseline = all.first().copied().unwrap_or("");
    let choice = |name: &&'static str| {
        let ratio = |sweep: &Measured| sweep.typical_ratio(name) / sweep.typical_ratio(baseline);
        let is_right = right.contains(name);
        Choice {
            need: match *name {
                "pieces" => "what falls apart, in pieces of its own".to_owned(),
                "plain form" => "the lecture's loop, a pass a side".to_owned(),
                _ if is_right => format!("areas to {keep}, every vertex in the window"),
                _ => "speed, vertices near the window".to_owned(),
            },
            method: (*name).to_owned(),
            setting: match farthest(sweeps, name).filter(|_| is_right) {
                Some(row) => format!("to {} window sizes away", power_of_ten(row.setting)),
                None => "few window sizes away".to_owned(),
            },
            cost: between(extent(sweeps.iter().map(ratio)), times),
            loss: loss(sweeps, name, is_right),
        }
    };
    Advice {
        baseline,
        rows: all.iter().map(choice).collect(),
    }
}

fn rows_of<'a>(sweeps: &'a [Measured], name: &'a str) -> impl Iterator<Item = &'a Row> {
    sweeps.iter().flat_map(move |sweep| sweep.rows_of(name))
}

/// Of the most distant vertices.
fn farthest<'a>(sweeps: &'a [Measured], name: &'a str) -> Option<&'a Row> {
    let far = sweeps.iter().find(|sweep| sweep.name == FAR)?;
    far.rows_of(name).last()
}

/// How many vertices lie outside the window.
fn outside(row: &Row) -> u64 {
    row.faults.iter().map(|fault| fault.1).sum()
}

/// `36 in 100 vertices outside; areas off by 10⁻¹⁵, 10⁻⁹ at 10³`
fn loss(sweeps: &[Measured], name: &str, is_right: bool) -> String {
    if is_right {
        let most = extent(rows_of(sweeps, name).map(|row| row.error)).1;
        return format!("areas off by {}", digits(most));
    }
    let questions = sweeps.iter().flat_map(|sweep| &sweep.questions);
    let shares = questions.flat_map(|question| {
        let mine = question.rows.iter().filter(|row| row.technique == name);
        mine.map(|row| outside(row) as f64 / question.units.max(1) as f64)
    });
    let near = sweeps.iter().filter(|sweep| sweep.name != FAR);
    let near = near
        .flat_map(|sweep| sweep.rows_of(name))
        .map(|row| row.error);
    let mut said = format!(
        "up to {:.0} vertices outside for 100 given; areas off by {}",
        100.0 * extent(shares).1,
        digits(extent(near).1)
    );
    if let Some(row) = farthest(sweeps, name) {
        said = format!(
            "{said}, {} at {}",
            digits(row.error),
            power_of_ten(row.setting)
        );
    }
    said
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::made_up::{self, lines};

    /// At 1 and at 10³; of each technique its ratio, its errors, and its vertices outside of 1000.
    fn sweep(name: &'static str, techniques: &[(&'static str, f64, [f64; 2], u64)]) -> Measured {
        let question = |i: usize| {
            let rows = techniques
                .iter()
                .map(|&(technique, ratio, errors, outside)| Row {
                    faults: vec![("vertices outside", outside)],
                    ..made_up::row(technique, [1.0, 1e3][i], ratio, Some(errors[i]))
                });
            rows.collect()
        };
        made_up::sweep(name, vec![question(0), question(1)])
    }

    #[test]
    fn the_cheapest_right_one_and_what_the_others_take() {
        let (good, late) = ([1e-16; 2], [1e-13, 1e-9]);
        let near = [
            ("outline", 1.0, good, 0),
            ("pieces", 1.5, good, 0),
            ("rough", 0.5, [1e-15; 2], 360),
        ];
        let far = [
            ("outline", 1.0, good, 0),
            ("pieces", 3.0, good, 0),
            ("rough", 0.5, late, 2),
        ];
        let found = advice(&[sweep("star", &near), sweep("far-star", &far)]);
        assert_eq!(found.baseline, "outline");
        assert_eq!(
            lines(&found),
            [
                "areas to 10⁻¹², every vertex in the window | outline | to 10³ window sizes away | 1.0 | areas off by 10⁻¹⁶",
                "what falls apart, in pieces of its own | pieces | to 10³ window sizes away | 1.5 to 3.0 | areas off by 10⁻¹⁶",
                "speed, vertices near the window | rough | few window sizes away | 0.5 | up to 36 vertices outside for 100 given; areas off by 10⁻¹⁵, 10⁻⁹ at 10³",
            ]
        );
        assert_eq!(advice(&[]), Advice::default());
    }
}
