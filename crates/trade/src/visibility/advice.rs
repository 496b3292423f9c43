//! The study's sentence.

use crate::advice::{Stretch, between, extent, listed, percent, stretches, times};
use crate::report::{Answered, Measured, Row};
use crate::visibility::STUDY;

/// The share of wrong pixels that the advice keeps to, where some may be wrong.
const TOLERANCE: f64 = 1e-2;

/// What to take where a few pixels may be wrong and where none may, how counted work grows, and what a mere sort costs.
pub fn advice(sweeps: &[Measured]) -> String {
    let Some(sweep) = sweeps.first() else {
        return String::new();
    };
    let baseline = sweep.rows().next().map_or("", |row| row.technique);
    let few = choices(sweep, TOLERANCE, baseline);
    let mut said = format!(
        "For at most {} of wrong pixels use {few}",
        percent(TOLERANCE)
    );
    // Who has no pixel wrong at one setting by chance only is not asked.
    let mut exact = sweep.clone();
    for question in &mut exact.questions {
        let is_exact = |row: &Row| sweep.rows_of(row.technique).all(|row| row.error == 0.0);
        question.rows.retain(is_exact);
    }
    if exact.rows().next().is_some() {
        said = format!(
            "{said}, where none may be {}",
            choices(&exact, 0.0, baseline)
        );
    }
    for more in [growth(sweep), sorted(sweep)].into_iter().flatten() {
        said = format!("{said}; {more}");
    }
    said + "."
}

/// `object space for 10 to 100 primitives (0.8 to 7.2 times the time of z-buffer) and painter for …`
fn choices(sweep: &Measured, tolerance: f64, baseline: &str) -> String {
    let choice = |stretch: &Stretch| {
        let range = stretch.range(|k| k.to_string());
        let taken = format!("{} for {range} primitives", stretch.name());
        if stretch.technique.is_none_or(|name| name == baseline) {
            return taken;
        }
        let ratio = between(stretch.ratios, times);
        format!("{taken} ({ratio} times the time of {baseline})")
    };
    let found: Vec<String> = stretches(sweep, tolerance).iter().map(choice).collect();
    listed(&found)
}

/// By how much the counted work of each technique is multiplied, over the settings at which all are measured.
fn growth(sweep: &Measured) -> Option<String> {
    let techniques = sweep.techniques();
    let complete = sweep
        .questions
        .iter()
        .filter(|q| q.rows.len() == techniques.len());
    let complete: Vec<&Answered> = complete.collect();
    let [first, .., last] = complete.as_slice() else {
        return None;
    };
    let mut factors = Vec::new();
    for technique in techniques {
        let Some(what) = sweep.first_moved(technique, STUDY.charted_work) else {
            continue;
        };
        let count = |question: &Answered| {
            let row = question
                .rows
                .iter()
                .find(|row| row.technique == technique)?;
            Some(row.work.get(what) as f64)
        };
        let factor = count(last)? / count(first)?;
        factors.push((
            factor,
            format!("{} of {technique} {}", what.name(), times(factor)),
        ));
    }
    factors.sort_by(|a, b| b.0.total_cmp(&a.0));
    let named: Vec<String> = factors.into_iter().map(|(_, named)| named).collect();
    let [from, to] = [first.rows.first()?.setting, last.rows.first()?.setting];
    let more = times(to / from);
    (!named.is_empty()).then(|| {
        format!(
            "with {more} times as many, from {from} to {to}, work grows this many times: {}",
            listed(&named)
        )
    })
}

/// How much a sort without comparisons of pairs gets wrong.
fn sorted(sweep: &Measured) -> Option<String> {
    let most = extent(sweep.rows_of("sort only").map(|row| row.error)).1;
    (most >= 0.0).then(|| format!("sort only leaves up to {} wrong", percent(most)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::made_up;
    use ombra_math::work::{Count, Counter, Work};

    fn row(technique: &'static str, k: f64, ratio: f64, error: f64, count: (Counter, u64)) -> Row {
        let mut work = Work::default();
        work.add(count.0, count.1);
        Row {
            work,
            ..made_up::row(technique, k, ratio, Some(error))
        }
    }

    /// Without object space and the sort if not `all`.
    fn at(k: f64, error: f64, all: bool) -> Vec<Row> {
        let (tests, pairs) = (Counter::DepthTests, Counter::Pairs);
        let mut rows = vec![row("z-buffer", k, 1.0, error, (tests, 500))];
        if all {
            let compared = (k * (k - 1.0) / 2.0) as u64;
            rows.push(row("object space", k, k, 0.0, (pairs, compared)));
            rows.push(row("sort only", k, 2.0, 2.0 / k, (Counter::Fragments, 700)));
        } else {
            rows.push(row("painter", k, 4.0, 0.0, (pairs, 900)));
        }
        rows
    }

    #[test]
    fn choices_and_a_mere_sort() {
        // Four techniques in all, but never together: no growth can be told.
        let apart = vec![
            at(10.0, 0.0, true),
            at(30.0, 1e-2, true),
            at(100.0, 0.02, false),
        ];
        assert_eq!(
            advice(&[made_up::sweep("primitives", apart)]),
            "For at most 1.0 % of wrong pixels use z-buffer for 10 to 30 primitives and painter for 100 primitives \
             (4.0 times the time of z-buffer), where none may be object space for 10 to 30 primitives (10 to 30 times the time \
             of z-buffer) and painter for 100 primitives (4.0 times the time of z-buffer); \
             sort only leaves up to 20 % wrong."
        );
        assert_eq!(advice(&[]), "");
    }

    #[test]
    fn growth_and_no_technique() {
        let mut bad = at(100.0, 0.02, true);
        bad[1].error = 0.5;
        bad[2].error = 0.5;
        let together = vec![at(10.0, 0.0, true), at(30.0, 0.0, true), bad];
        assert_eq!(
            advice(&[made_up::sweep("primitives", together)]),
            "For at most 1.0 % of wrong pixels use z-buffer for 10 to 30 primitives and none that is measured here for \
             100 primitives; with 10 times as many, from 10 to 100, work grows this many times: pairs of object space \
             110, depth tests of z-buffer 1.0 and fragments of sort only 1.0; sort only leaves up to 50 % wrong."
        );
    }
}
