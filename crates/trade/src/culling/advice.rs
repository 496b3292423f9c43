//! The study's sentence.

use crate::advice::{between, extent, percent, times};
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
    let culled = pairs("culled z-buffer", "z-buffer");
    let before = pairs("z-buffer of front faces", "z-buffer");
    let object_space = pairs("culled object space", "object space");
    if culled.is_empty() {
        return String::new();
    }
    let mut parts = vec![format!(
        "Cull the back faces of a closed solid: {}, and the z-buffer makes {} of the depth tests, in {} times the time",
        changed(&[&culled[..], &object_space].concat()),
        shares(&culled, Counter::DepthTests),
        ratios(&culled)
    )];
    if !object_space.is_empty() {
        parts.push(format!(
            "object space compares {} of the pairs, in {} times the time",
            shares(&object_space, Counter::Pairs),
            ratios(&object_space)
        ));
    }
    if !before.is_empty() {
        let pairs = before.iter().zip(&culled);
        let quicker = pairs.filter(|((before, _), (culled, _))| before.ratio < culled.ratio);
        parts.push(format!(
            "leaving them out before transforms {} of the vertices, but finding them takes time too: {} times the \
             z-buffer's in all, less than by culling for {} of {} solids ({})",
            shares(&before, Counter::Vertices),
            ratios(&before),
            quicker.count(),
            before.len(),
            changed(&before)
        ));
    }
    parts.join("; ") + "."
}

/// How many pixels are unlike those without culling: `no pixel changes`, `3 pixels change`.
fn changed(pairs: &[(&Row, &Row)]) -> String {
    let faults = pairs.iter().flat_map(|(row, _)| &row.faults);
    match faults.map(|(_, number)| number).sum::<u64>() {
        0 => "no pixel changes".to_owned(),
        1 => "1 pixel changes".to_owned(),
        unlike => format!("{unlike} pixels change"),
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
fn ratios(pairs: &[(&Row, &Row)]) -> String {
    let ratio = |(row, whole): &(&Row, &Row)| row.ratio / whole.ratio;
    between(extent(pairs.iter().map(ratio)), times)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::made_up;
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
        assert_eq!(
            advice(&[made_up::sweep("sphere", vec![few, many.clone()])]),
            "Cull the back faces of a closed solid: 2 pixels change, and the z-buffer makes 50 % of the depth tests, in \
             0.6 to 0.8 times the time; object space compares 25 % of the pairs, in 0.4 times the time; leaving them \
             out before transforms 58 % to 60 % of the vertices, but finding them takes time too: 0.5 to 1.4 times the \
             z-buffer's in all, less than by culling for 1 of 2 solids (1 pixel changes)."
        );
        let many = advice(&[made_up::sweep("sphere", vec![many])]);
        assert!(
            many.starts_with("Cull the back faces of a closed solid: no pixel changes, "),
            "{many}"
        );
        assert_eq!(advice(&[]), "");
    }
}
