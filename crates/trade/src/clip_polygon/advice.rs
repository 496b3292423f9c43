//! The study's sentence.

use crate::advice::{between, extent, power_of_ten, times};
use crate::report::{Measured, Row};

/// The error of areas that the advice keeps to.
const TOLERANCE: f64 = 1e-12;
/// The sweep over the distance of the vertices.
const FAR: &str = "far-star";

/// The cheapest technique that is right everywhere, what the others take, and what the wrong ones get wrong.
pub fn advice(sweeps: &[Measured]) -> String {
    let keep = power_of_ten(TOLERANCE);
    let techniques = sweeps.first().map(Measured::techniques).unwrap_or_default();
    let is_right = |name: &&str| {
        let mut rows = rows_of(sweeps, name);
        rows.all(|row| row.error <= TOLERANCE && outside(row) == 0)
    };
    let (mut right, wrong): (Vec<&str>, Vec<&str>) = techniques.into_iter().partition(is_right);
    let time = |name: &str| -> f64 { sweeps.iter().map(|s| s.typical_ratio(name)).sum() };
    right.sort_by(|a, b| time(a).total_cmp(&time(b)));
    let Some((best, others)) = right.split_first() else {
        return format!("No technique keeps areas within {keep} and every vertex in the window.");
    };
    let takes = |name: &str| {
        let ratio = |sweep: &Measured| sweep.typical_ratio(name) / sweep.typical_ratio(best);
        format!(
            "{name} takes {}",
            between(extent(sweeps.iter().map(ratio)), times)
        )
    };
    let others = others.iter().map(|name| takes(name));
    let wrong = wrong
        .iter()
        .map(|name| format!("{}, but {}", takes(name), loss(sweeps, name)));
    let all: Vec<String> = others.chain(wrong).collect();
    let mut said = format!("To keep areas within {keep} and every vertex in the window use {best}");
    if let Some(away) = farthest(sweeps, best).map(|row| power_of_ten(row.setting)) {
        said = format!("{said}, also where vertices are {away} window sizes away");
    }
    if !all.is_empty() {
        said = format!("{said}; with its time as 1, {}", all.join(", "));
    }
    said + "."
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

/// `leaves up to 36 vertices outside for 100 given and has relative errors of up to 10⁻¹⁵, of 7·10⁻⁵ where …`
fn loss(sweeps: &[Measured], name: &str) -> String {
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
        "leaves up to {:.0} vertices outside for 100 given and has relative errors of up to {}",
        100.0 * extent(shares).1,
        power_of_ten(extent(near).1)
    );
    if let Some(error) = farthest(sweeps, name).map(|row| power_of_ten(row.error)) {
        said = format!("{said}, of {error} where they are that far");
    }
    said
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::made_up;

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
        assert_eq!(
            advice(&[sweep("star", &near), sweep("far-star", &far)]),
            "To keep areas within 10⁻¹² and every vertex in the window use outline, also where vertices are 10³ window \
             sizes away; \
             with its time as 1, pieces takes 1.5 to 3.0, rough takes 0.5, but leaves up to 36 vertices outside for 100 \
             given and has relative errors of up to 10⁻¹⁵, of 10⁻⁹ where they are that far."
        );
        let none = "No technique keeps areas within 10⁻¹² and every vertex in the window.";
        assert_eq!(advice(&[sweep("star", &near[2..])]), none);
        assert_eq!(advice(&[]), none);
    }
}
