//! The study's sentence.

use crate::advice::{percent, times};
use crate::report::{Measured, Row};
use ombra_math::work::Counter;

/// What culling changes, what it saves, and in what time.
pub fn advice(sweeps: &[Measured]) -> String {
    let pairs = |culled: &'static str, whole: &'static str| -> Vec<(&Row, &Row)> {
        let questions = sweeps.iter().flat_map(|sweep| &sweep.questions);
        let found = questions.filter_map(|question| {
            let find = |name| question.rows.iter().find(|row| row.technique == name);
            Some((find(culled)?, find(whole)?))
        });
        found.collect()
    };
    let culled = pairs("z-buffer, culled", "z-buffer");
    let before = pairs("z-buffer, left out before", "z-buffer");
    let object_space = pairs("object space, culled", "object space");
    if culled.is_empty() {
        return String::new();
    }
    let mut parts = vec![format!(
        "Culling changes {}: the z-buffer makes {} of the depth tests, in {} times the time",
        changed(&[&culled[..], &object_space].concat()),
        shares(&culled, Counter::DepthTests),
        ratios(&culled)
    )];
    if !before.is_empty() {
        parts.push(format!(
            "left out before, {} of the vertices are transformed, in {} times the time ({} changed)",
            shares(&before, Counter::Vertices),
            ratios(&before),
            changed(&before)
        ));
    }
    if !object_space.is_empty() {
        parts.push(format!(
            "object space compares {} of the pairs, in {} times the time",
            shares(&object_space, Counter::Pairs),
            ratios(&object_space)
        ));
    }
    parts.join("; ") + "."
}

/// How many pixels are unlike those without culling: `no pixel`, `3 pixels`.
fn changed(pairs: &[(&Row, &Row)]) -> String {
    let faults = pairs.iter().flat_map(|(row, _)| &row.faults);
    match faults.map(|(_, number)| number).sum::<u64>() {
        0 => "no pixel".to_owned(),
        1 => "1 pixel".to_owned(),
        unlike => format!("{unlike} pixels"),
    }
}

/// From the least to the greatest share of the work that is left: `50 %`, `28 to 71 %`.
fn shares(pairs: &[(&Row, &Row)], what: Counter) -> String {
    let share = |(row, whole): &(&Row, &Row)| {
        row.work.get(what) as f64 / whole.work.get(what).max(1) as f64
    };
    let (low, high) = range(pairs.iter().map(share));
    let (low, high) = (percent(low), percent(high));
    if low == high {
        return low;
    }
    format!("{} to {high}", low.trim_end_matches(" %"))
}

/// From the least to the greatest of times over those without culling.
fn ratios(pairs: &[(&Row, &Row)]) -> String {
    let (low, high) = range(pairs.iter().map(|(row, whole)| row.ratio / whole.ratio));
    let (low, high) = (times(low), times(high));
    if low == high {
        return low;
    }
    format!("{low} to {high}")
}

fn range(values: impl Iterator<Item = f64>) -> (f64, f64) {
    values.fold((f64::INFINITY, 0.0), |(low, high), x| {
        (x.min(low), x.max(high))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::deviation::Deviation;
    use crate::report::Answered;
    use crate::statistics::Quartiles;
    use ombra_math::work::{Count, Work};

    fn row(technique: &'static str, ratio: f64, work: &[(Counter, u64)], unlike: u64) -> Row {
        let mut counted = Work::default();
        for &(what, n) in work {
            counted.add(what, n);
        }
        Row {
            technique,
            setting: 1.0,
            error: 0.0,
            deviation: Deviation::of([Some(0.0)]),
            faults: vec![("unlike without culling", unlike)],
            work: counted,
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
            name: "sphere",
            knob: "",
            charted: 0,
            questions: questions.collect(),
        }
    }

    #[test]
    fn what_is_saved() {
        use Counter::{DepthTests, Pairs, Vertices};
        let few = vec![
            row("z-buffer", 1.0, &[(DepthTests, 800), (Vertices, 50)], 0),
            row(
                "z-buffer, culled",
                0.6,
                &[(DepthTests, 400), (Vertices, 50)],
                0,
            ),
            row(
                "z-buffer, left out before",
                0.5,
                &[(DepthTests, 400), (Vertices, 30)],
                1,
            ),
            row("object space", 20.0, &[(Pairs, 1000)], 0),
            row("object space, culled", 8.0, &[(Pairs, 250)], 2),
        ];
        let many = vec![
            row("z-buffer", 1.0, &[(DepthTests, 900), (Vertices, 500)], 0),
            row(
                "z-buffer, culled",
                0.8,
                &[(DepthTests, 450), (Vertices, 500)],
                0,
            ),
            row(
                "z-buffer, left out before",
                1.4,
                &[(DepthTests, 450), (Vertices, 290)],
                0,
            ),
        ];
        assert_eq!(
            advice(&[sweep(vec![few, many.clone()])]),
            "Culling changes 2 pixels: the z-buffer makes 50 % of the depth tests, in 0.6 to 0.8 times the time; \
             left out before, 58 to 60 % of the vertices are transformed, in 0.5 to 1.4 times the time (1 pixel \
             changed); object space compares 25 % of the pairs, in 0.4 times the time."
        );
        assert!(advice(&[sweep(vec![many])]).starts_with("Culling changes no pixel: "));
        assert_eq!(advice(&[]), "");
    }
}
