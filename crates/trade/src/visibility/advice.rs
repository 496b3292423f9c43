//! The study's sentence.

use crate::advice::{Stretch, listed, percent, stretches, times};
use crate::report::Measured;
use crate::visibility::STUDY;

/// The share of wrong pixels that the advice keeps to.
const TOLERANCE: f64 = 1e-3;

/// What to take for how many primitives, how counted work grows, and what a mere sort costs.
pub fn advice(sweeps: &[Measured]) -> String {
    let Some(sweep) = sweeps.first() else {
        return String::new();
    };
    let choices: Vec<String> = stretches(sweep, TOLERANCE)
        .iter()
        .map(|stretch| choice(sweep, stretch))
        .collect();
    let mut said = format!(
        "For at most {} of wrong pixels use {}",
        percent(TOLERANCE),
        listed(&choices)
    );
    for more in [growth(sweep), sorted(sweep)].into_iter().flatten() {
        said = format!("{said}; {more}");
    }
    said + "."
}

/// `z-buffer for 10 to 1000 primitives`
fn choice(sweep: &Measured, stretch: &Stretch) -> String {
    let last = sweep.questions.iter().flat_map(|q| &q.rows);
    let last = last.map(|row| row.setting).fold(0.0, f64::max);
    let (from, to) = (stretch.from, stretch.to);
    let range = match stretch {
        stretch if stretch.to == last => format!("{from} primitives or more"),
        stretch if stretch.from == stretch.to => format!("{from} primitives"),
        _ => format!("{from} to {to} primitives"),
    };
    let Some(name) = stretch.technique else {
        return format!("none that is measured here for {range}");
    };
    let baseline = sweep.techniques().first().copied();
    if baseline == Some(name) {
        return format!("{name} for {range}");
    }
    let [low, high] = [stretch.ratios.0, stretch.ratios.1].map(times);
    let ratio = if low == high {
        low
    } else {
        format!("{low} to {high}")
    };
    format!(
        "{name} for {range} ({ratio} times the time of {})",
        baseline.unwrap_or("")
    )
}

/// How often the counted work of each technique is done again, over the settings at which all are measured.
fn growth(sweep: &Measured) -> Option<String> {
    let techniques = sweep.techniques();
    let complete = |&q: &usize| {
        let rows = sweep.questions.get(q).map_or(&[][..], |q| &q.rows);
        rows.len() == techniques.len()
    };
    let all: Vec<usize> = (0..sweep.questions.len()).filter(complete).collect();
    let [first, last] = [*all.first()?, *all.last()?];
    let setting = |q: usize| Some(sweep.questions.get(q)?.rows.first()?.setting);
    let factors: Vec<String> = techniques
        .iter()
        .filter_map(|technique| {
            let what = sweep.first_moved(technique, STUDY.charted_work)?;
            let count = |q: usize| {
                let mut rows = sweep.questions.get(q)?.rows.iter();
                let row = rows.find(|row| row.technique == *technique)?;
                Some(row.work.get(what) as f64)
            };
            let factor = times(count(last)? / count(first)?);
            Some(format!("{} of {technique} {factor} times", what.name()))
        })
        .collect();
    (first < last && !factors.is_empty()).then_some(())?;
    let [from, to] = [setting(first)?, setting(last)?];
    Some(format!(
        "from {from} to {to} primitives work grows: {}",
        listed(&factors)
    ))
}

/// How much a sort without comparisons of pairs gets wrong.
fn sorted(sweep: &Measured) -> Option<String> {
    let errors: Vec<f64> = sweep.rows_of("sort only").map(|row| row.error).collect();
    let most = errors.into_iter().reduce(f64::max)?;
    Some(format!("sort only leaves up to {} wrong", percent(most)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::deviation::Deviation;
    use crate::report::{Answered, Row};
    use crate::statistics::Quartiles;
    use ombra_math::work::{Count, Counter, Work};

    fn row(technique: &'static str, k: f64, ratio: f64, error: f64, count: (Counter, u64)) -> Row {
        let mut work = Work::default();
        work.add(count.0, count.1);
        Row {
            technique,
            setting: k,
            error,
            deviation: Deviation::of([Some(error)]),
            faults: vec![],
            work,
            nanoseconds: Quartiles::of(&[ratio]),
            ratio,
            on_front: false,
        }
    }

    fn sweep(questions: Vec<Vec<Row>>) -> Measured {
        let questions = questions.into_iter().map(|rows| Answered {
            inputs: String::new(),
            units: 1,
            rows,
        });
        Measured {
            name: "primitives",
            knob: "",
            charted: 0,
            questions: questions.collect(),
        }
    }

    #[test]
    fn choices_growth_and_a_mere_sort() {
        let (tests, pairs) = (Counter::DepthTests, Counter::Pairs);
        let at = |k: f64, error, all: bool| {
            let mut rows = vec![row("z-buffer", k, 1.0, error, (tests, 500))];
            if all {
                rows.push(row(
                    "object space",
                    k,
                    k,
                    0.0,
                    (pairs, (k * (k - 1.0) / 2.0) as u64),
                ));
                rows.push(row("sort only", k, 0.5, 0.2 / k, (Counter::Fragments, 700)));
            } else {
                rows.push(row("painter", k, 4.0, 0.0, (pairs, 900)));
            }
            rows
        };
        // Four techniques in all, but never together: no growth can be told.
        let apart = sweep(vec![
            at(10.0, 0.0, true),
            at(30.0, 0.0, true),
            at(100.0, 0.01, false),
        ]);
        assert_eq!(
            advice(&[apart]),
            "For at most 0.10 % of wrong pixels use z-buffer for 10 to 30 primitives and painter for 100 primitives or \
             more (4.0 times the time of z-buffer); sort only leaves up to 2.0 % wrong."
        );
        let mut bad = at(100.0, 0.01, true);
        bad[1].error = 0.5;
        let together = sweep(vec![at(10.0, 0.0, true), at(30.0, 0.0, true), bad]);
        assert_eq!(
            advice(&[together]),
            "For at most 0.10 % of wrong pixels use z-buffer for 10 to 30 primitives and none that is measured here \
             for 100 primitives or more; from 10 to 100 primitives work grows: depth tests of z-buffer 1.0 times, \
             pairs of object space 110 times and fragments of sort only 1.0 times; \
             sort only leaves up to 2.0 % wrong."
        );
        assert_eq!(advice(&[]), "");
    }
}
