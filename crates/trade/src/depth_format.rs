//! Study: which of two surfaces a z-buffer shows in front, by the format in which it stores depths.
//!
//! # What is asked
//!
//! Tiles of 8 × 8 pixels, each with two surfaces that lie almost on one another. From left to right they are farther away,
//! from the near plane to the far one in equal ratios; from top to bottom the gap between them grows, from 10⁻⁸ to 10
//! times their distance. The farther one is drawn first: where the format stores both depths alike, it stays.
//!
//! | sweep | knob | the two surfaces |
//! | --- | --- | --- |
//! | `behind` | near / far, 10⁻¹ … 10⁻⁶ | one behind the other: one gap, relative to the distance, all over the tile |
//! | `crossing` | near / far, 10⁻¹ … 10⁻⁶ | they cross in the middle of the tile; the gap is that at its sides |
//!
//! All are inclined, so that pixels of a tile differ in depth.
//!
//! # Error
//!
//! ```text
//! e = |z₁ − z₂| / min(z₁, z₂)   at a pixel that shows the farther surface, otherwise 0
//! ```
//!
//! So the largest error is the smallest gap from which on all are told apart, relative to the distance. Which surface is
//! nearer is decided in integers, from the distances of the corners. Counted besides: pixels that are wrong though the gap
//! is greater than [`depth_step`](ombra_hsr::z_buffer::precision::depth_step), the formula.
//!
//! # Techniques
//!
//! The formats of [`z_buffer`](ombra_hsr::z_buffer): `24 bits` (the baseline), `16 bits`, `f32`, `f32 reversed`.

mod advice;
mod tiles;

use std::rc::Rc;

use ombra_hsr::z_buffer::{Depth16, Depth24, Depth32F, DepthFormat, ReversedDepth32F};

use crate::advice::power_of_ten;
use crate::case;
use crate::depth_format::advice::advice;
use crate::depth_format::tiles::{Tiles, Together};
use crate::deviation::Measure;
use crate::hidden::Answer;
use crate::study::{Case, Effort, Question, Shown, Study, Sweep, What};

/// The study.
pub const STUDY: Study = Study {
    id: "depth-format",
    summary: "Two surfaces told apart: 16 bits, 24 bits, f32, f32 reversed",
    unit: "pixel",
    errors: &[
        Measure::Largest("gap not told apart / distance"),
        Measure::Share("wrong pixels"),
    ],
    charted_work: &[],
    charts: &[
        Shown {
            sweep: "behind",
            what: What::Error(0),
        },
        Shown {
            sweep: "behind",
            what: What::Cost(3),
        },
    ],
    ends: &[],
    sweeps,
    advice,
};

fn sweeps(effort: Effort) -> Vec<Sweep> {
    let columns = effort.choose(12, 48);
    let sweep = |name, together| Sweep {
        name,
        knob: "near / far",
        questions: (1..=6)
            .map(|k| question(libm::exp10(f64::from(-k)), columns, together))
            .collect(),
    };
    vec![
        sweep("behind", Together::Behind),
        sweep("crossing", Together::Crossing),
    ]
}

fn question(ratio: f64, columns: u32, together: Together) -> Question {
    let tiles = Rc::new(Tiles::new(ratio, columns, together));
    Question {
        inputs: format!(
            "{} pairs of surfaces, near / far = {}",
            tiles.number(),
            power_of_ten(ratio)
        ),
        units: tiles.pixels(),
        cases: vec![
            format::<Depth24>(ratio, &tiles),
            format::<Depth16>(ratio, &tiles),
            format::<Depth32F>(ratio, &tiles),
            format::<ReversedDepth32F>(ratio, &tiles),
        ],
    }
}

fn format<F: DepthFormat>(ratio: f64, tiles: &Rc<Tiles>) -> Case {
    let judge = |tiles: &Tiles, answer: &Answer| tiles.verdict::<F>(answer);
    case!(
        F::NAME,
        ratio,
        tiles,
        |tiles, work| tiles.draw::<F>(work),
        judge
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::made_up::lines;
    use crate::run::run;

    #[test]
    fn the_study_says_how_far_each_format_goes() {
        let report = run(&STUDY, Effort::Quick, &mut |_| ()).unwrap();
        for sweep in &report.sweeps {
            assert_eq!(sweep.questions.len(), 6);
            for row in sweep.questions.iter().flat_map(|q| &q.rows) {
                let context = format!("{} {} {}: {row:?}", sweep.name, row.technique, row.setting);
                // No gap greater than the formula's step is ever lost.
                assert_eq!(row.faults, [("wrong beyond the formula", 0)], "{context}");
                assert_eq!(row.deviation.missing, 0, "{context}");
                // Two triangles a surface, all fragments tested.
                assert_eq!(row.work.depth_tests, row.work.fragments, "{context}");
            }
            for (format, errors) in [
                // δ · far / near, with δ = 2⁻¹⁶ and 2⁻²⁴, where all of it fits between the planes.
                ("16 bits", &[1e-1, 1e-2, 1e-3][..]),
                ("24 bits", &[1e-1, 1e-2, 1e-3, 1e-4, 1e-5]),
            ] {
                let delta = if format == "16 bits" {
                    65_535.0
                } else {
                    16_777_215.0
                };
                for (row, ratio) in sweep.rows_of(format).zip(errors) {
                    let step = 1.0 / (delta * ratio);
                    let context =
                        format!("{} {format} {ratio}: {} of {step}", sweep.name, row.error);
                    assert!(row.error <= step && row.error >= 0.3 * step, "{context}");
                }
            }
            // 1 − d ≈ near / distance has 24 digits wherever it is.
            let reversed = sweep.rows_of("f32 reversed");
            assert!(reversed.map(|row| row.error).all(|e| e <= 2f64.powi(-23)));
        }
        let said = lines(&report.advice);
        for (format, reach) in [("f32 reversed", -6), ("24 bits", -4), ("16 bits", -2)] {
            let reach = power_of_ten(libm::exp10(f64::from(reach)));
            let start = format!(
                "gaps of 2·10⁻³ of the distance seen | {format} | near / far down to {reach} | "
            );
            assert!(said.iter().any(|line| line.starts_with(&start)), "{said:?}");
        }
        let charts = report
            .charts(&ombra_figures::style::Style::default())
            .unwrap();
        assert_eq!(charts.len(), 2);
    }
}
