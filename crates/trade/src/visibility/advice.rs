//! The study's advice.

use crate::advice::{
    Advice, Choice, Stretch, between, extent, lost, number, percent, stretches, times,
};
use crate::report::{Measured, Row};

/// The share of wrong pixels that the advice keeps to, where some may be wrong.
const TOLERANCE: f64 = 1e-2;

/// What to take where a few pixels may be wrong and where none may, and what a mere sort costs.
pub fn advice(sweeps: &[Measured]) -> Advice {
    let Some(sweep) = sweeps.first() else {
        return Advice::default();
    };
    let baseline = sweep.rows().next().map_or("", |row| row.technique);
    let need = format!("at most {} of the pixels wrong", percent(TOLERANCE));
    let mut rows = choices(sweep, TOLERANCE, &need);
    // Who has no pixel wrong at one setting by chance only is not asked.
    let mut exact = sweep.clone();
    for question in &mut exact.questions {
        let is_exact = |row: &Row| sweep.rows_of(row.technique).all(|row| row.error == 0.0);
        question.rows.retain(is_exact);
    }
    if exact.rows().next().is_some() {
        rows.extend(choices(&exact, 0.0, "no pixel wrong"));
    }
    let rest = sweep.techniques().into_iter();
    let rest = rest.filter(|technique| !rows.iter().any(|row| row.method == *technique));
    let rest: Vec<Choice> = rest.map(|technique| other(sweep, technique)).collect();
    rows.extend(rest);
    Advice { baseline, rows }
}

/// The ranges of primitives over which one technique is the one to take.
fn choices(sweep: &Measured, tolerance: f64, need: &str) -> Vec<Choice> {
    let choice = |stretch: &Stretch| {
        let within = |row: &&Row| stretch.from <= row.setting && row.setting <= stretch.to;
        let technique = stretch.technique.unwrap_or("");
        let most = extent(sweep.rows_of(technique).filter(within).map(|row| row.error)).1;
        Choice {
            need: need.to_owned(),
            method: stretch.name().to_owned(),
            setting: format!("{} primitives", stretch.range(number)),
            cost: stretch
                .technique
                .map_or_else(String::new, |_| between(stretch.ratios, times)),
            loss: stretch.technique.map_or_else(String::new, |_| wrong(most)),
        }
    };
    stretches(sweep, tolerance).iter().map(choice).collect()
}

/// A technique that is never the one to take.
fn other(sweep: &Measured, technique: &'static str) -> Choice {
    let rows = || sweep.rows_of(technique);
    let most = extent(rows().map(|row| row.error)).1;
    Choice {
        need: match technique {
            "image space" => "the lecture's count, n·m·k",
            "sort only" => "an order at once, unproved",
            _ => "for comparison",
        }
        .to_owned(),
        method: technique.to_owned(),
        setting: format!(
            "{} primitives",
            between(extent(rows().map(|row| row.setting)), number)
        ),
        cost: between(extent(rows().map(|row| row.ratio)), times),
        loss: wrong(most),
    }
}

fn wrong(most: f64) -> String {
    lost(most, |share| {
        format!("up to {} of the pixels wrong", percent(share))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::made_up::{self, lines};
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
        let apart = vec![
            at(10.0, 0.0, true),
            at(30.0, 1e-2, true),
            at(100.0, 0.02, false),
        ];
        let found = advice(&[made_up::sweep("primitives", apart)]);
        assert_eq!(found.baseline, "z-buffer");
        assert_eq!(
            lines(&found),
            [
                "at most 1.0 % of the pixels wrong | z-buffer | 10 to 30 primitives | 1.0 | up to 1.0 % of the pixels wrong",
                "at most 1.0 % of the pixels wrong | painter | 100 primitives | 4.0 | nothing",
                "no pixel wrong | object space | 10 to 30 primitives | 10 to 30 | nothing",
                "no pixel wrong | painter | 100 primitives | 4.0 | nothing",
                "an order at once, unproved | sort only | 10 to 30 primitives | 2.0 | up to 20 % of the pixels wrong",
            ]
        );
        assert_eq!(advice(&[]), Advice::default());
    }

    #[test]
    fn no_technique() {
        let mut bad = at(100.0, 0.02, true);
        bad[1].error = 0.5;
        bad[2].error = 0.5;
        let together = vec![at(10.0, 0.0, true), bad];
        assert_eq!(
            lines(&advice(&[made_up::sweep("primitives", together)]))[1],
            "at most 1.0 % of the pixels wrong | none that is measured here | 100 primitives |  | "
        );
    }
}
