//! The study's advice.

use crate::advice::{Advice, Choice, between, extent, percent, times};
use crate::report::{Measured, Row};
use ombra_math::work::Counter;

/// What culling changes, what it saves, and in what time.
pub fn advice(sweeps: &[Measured]) -> Advice {
    let pairs = |culled: &'static str, whole: &'static str| -> Vec<(&Row, &Row)> {
        let questions = sweeps.iter().flat_map(|sweep| &sweep.questions);
        let found = questions.filter_map(|question| {
            let find = |name| question.rows.iter().find(|row| row.technique == name);
            Some((find(culled)?, find(whole)?))
        });
        found.collect()
    };
    let found = [
        (
            "a closed solid in less time",
            "culled z-buffer",
            "z-buffer",
            Counter::DepthTests,
        ),
        (
            "fewer vertices transformed",
            "z-buffer of front faces",
            "z-buffer",
            Counter::Vertices,
        ),
        (
            "exact outlines of a closed solid",
            "culled object space",
            "object space",
            Counter::Pairs,
        ),
    ];
    let rows = found.into_iter().filter_map(|(need, culled, whole, what)| {
        let pairs = pairs(culled, whole);
        pairs.first()?;
        let sizes = extent(pairs.iter().map(|(row, _)| row.setting));
        Some(Choice {
            need: need.to_owned(),
            method: culled.to_owned(),
            setting: format!("{} triangles", between(sizes, |size| size.to_string())),
            cost: match whole {
                "z-buffer" => between(ratios(&pairs), times),
                _ => format!("{} of {whole}", between(ratios(&pairs), times)),
            },
            loss: format!(
                "{}; {} of the {} are left",
                changed(&pairs),
                shares(&pairs, what),
                what.name()
            ),
        })
    });
    Advice {
        baseline: "z-buffer",
        rows: rows.collect(),
    }
}

/// How many pixels are unlike those without culling: `no pixel`, `3 pixels change`.
fn changed(pairs: &[(&Row, &Row)]) -> String {
    let faults = pairs.iter().flat_map(|(row, _)| &row.faults);
    match faults.map(|(_, number)| number).sum::<u64>() {
        0 => "no pixel".to_owned(),
        1 => "1 pixel".to_owned(),
        unlike => format!("{unlike} pixels"),
    }
}

/// From the least to the greatest share of the work that is left: `50 %`, `28 % to 71 %`.
fn shares(pairs: &[(&Row, &Row)], what: Counter) -> String {
    let share = |(row, whole): &(&Row, &Row)| {
        row.work.get(what) as f64 / whole.work.get(what).max(1) as f64
    };
    between(extent(pairs.iter().map(share)), percent)
}

/// From the least to the greatest of times over those without culling.
fn ratios(pairs: &[(&Row, &Row)]) -> (f64, f64) {
    let ratio = |(row, whole): &(&Row, &Row)| row.ratio / whole.ratio;
    extent(pairs.iter().map(ratio))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::made_up::{self, lines};
    use ombra_math::work::{Count, Work};

    fn row(technique: &'static str, ratio: f64, work: &[(Counter, u64)], unlike: u64) -> Row {
        let mut counted = Work::default();
        for &(what, n) in work {
            counted.add(what, n);
        }
        Row {
            faults: vec![("unlike without culling", unlike)],
            work: counted,
            ..made_up::row(technique, 1.0, ratio, Some(0.0))
        }
    }

    #[test]
    fn what_is_saved() {
        use Counter::{DepthTests, Pairs, Vertices};
        let few = vec![
            row("z-buffer", 1.0, &[(DepthTests, 800), (Vertices, 50)], 0),
            row(
                "culled z-buffer",
                0.6,
                &[(DepthTests, 400), (Vertices, 50)],
                0,
            ),
            row(
                "z-buffer of front faces",
                0.5,
                &[(DepthTests, 400), (Vertices, 30)],
                1,
            ),
            row("object space", 20.0, &[(Pairs, 1000)], 0),
            row("culled object space", 8.0, &[(Pairs, 250)], 2),
        ];
        let many = vec![
            row("z-buffer", 1.0, &[(DepthTests, 900), (Vertices, 500)], 0),
            row(
                "culled z-buffer",
                0.8,
                &[(DepthTests, 450), (Vertices, 500)],
                0,
            ),
            row(
                "z-buffer of front faces",
                1.4,
                &[(DepthTests, 450), (Vertices, 290)],
                0,
            ),
        ];
        let found = advice(&[made_up::sweep("sphere", vec![few, many])]);
        assert_eq!(
            lines(&found),
            [
                "a closed solid in less time | culled z-buffer | 1 triangles | 0.6 to 0.8 | no pixel; 50 % of the depth tests are left",
                "fewer vertices transformed | z-buffer of front faces | 1 triangles | 0.5 to 1.4 | 1 pixel; 58 % to 60 % of the vertices are left",
                "exact outlines of a closed solid | culled object space | 1 triangles | 0.4 of object space | 2 pixels; 25 % of the pairs are left",
            ]
        );
        assert!(advice(&[]).rows.is_empty());
    }
}
