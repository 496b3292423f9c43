//! Study: a segment against a window, by four methods that round once and two that round as textbooks do.
//!
//! # What is asked
//!
//! A window, and segments whose ends lie anywhere; the truth is what exactly these doubles leave in the window.
//!
//! | sweep | knob | what it shows |
//! | --- | --- | --- |
//! | `outside` | share of segments outside, 0 … 100 % | what rejecting and accepting cost; ends lie in a square of three windows' size |
//! | `far-ends` | distance of the ends / size of the window, 1 … 10¹² | digits lost between far ends |
//!
//! # Error
//!
//! ```text
//! e = max(‖A − A*‖∞, ‖B − B*‖∞) / size of the window        A*, B* the exact ends
//! ```
//!
//! A* and B* are quotients of integers, found from the parameters' bounds alone; only e itself is rounded. Where nothing
//! is left and a technique says so, e = 0; where one of the two says so and the other does not, the answer counts as
//! missing.
//!
//! # Techniques
//!
//! - `direct` (the baseline), `Cohen–Sutherland`, `Liang–Barsky`, `Cyrus–Beck`: those of `ombra-clip`, which decide
//!   exactly and round each end to the nearest double. They give the same answers, so their errors are one curve.
//! - `textbook C–S`, `textbook L–B`: the same in plain doubles. The first cuts what an earlier cut has left, the second
//!   puts rounded parameters into a + t (b − a). What exactness costs is seen against them.
//!
//! Counted work is of numbers as the technique has them: a division that is rounded once is some twenty operations of doubles.

mod advice;
mod segments;

use std::rc::Rc;

use ombra_clip::{cohen_sutherland, cyrus_beck, direct, liang_barsky};

use crate::advice::{percent, power_of_ten};
use crate::case;
use crate::clip_segment::advice::advice;
use crate::clip_segment::segments::{Clipped, WindowAndSegments};
use crate::deviation::Measure;
use crate::study::{Effort, Question, Shown, Study, Sweep, What};

/// The study.
pub const STUDY: Study = Study {
    id: "clip-segment",
    summary: "A segment against a window: direct, Cohen–Sutherland, Liang–Barsky, Cyrus–Beck",
    unit: "segment",
    errors: &[Measure::Largest(
        "distance from the exact ends / window size",
    )],
    charted_work: &[],
    charts: &[
        Shown {
            sweep: "far-ends",
            what: What::Error(0),
        },
        Shown {
            sweep: "outside",
            what: What::Time,
        },
        Shown {
            sweep: "far-ends",
            what: What::Cost(6),
        },
    ],
    ends: &[],
    sweeps,
    advice,
};

fn sweeps(effort: Effort) -> Vec<Sweep> {
    let segments = effort.choose(400, 4000);
    let outside = [0, 10, 20, 30, 40, 50, 60, 70, 80, 90, 100].map(|share| {
        let share = f64::from(share) / 100.0;
        let scene = Rc::new(WindowAndSegments::outside(share, segments));
        question(
            format!("{} of {segments} segments outside", percent(share)),
            share,
            &scene,
        )
    });
    let far_ends = (0..=12).map(|k| {
        let distance = libm::exp10(f64::from(k));
        let scene = Rc::new(WindowAndSegments::far_ends(distance, segments));
        question(
            format!(
                "{segments} segments with ends {} window sizes away",
                power_of_ten(distance)
            ),
            distance,
            &scene,
        )
    });
    vec![
        Sweep {
            name: "outside",
            knob: "share of segments outside",
            questions: outside.into(),
        },
        Sweep {
            name: "far-ends",
            knob: "distance of the ends / window size",
            questions: far_ends.collect(),
        },
    ]
}

fn question(inputs: String, k: f64, scene: &Rc<WindowAndSegments>) -> Question {
    let judge = |s: &WindowAndSegments, clipped: &Clipped| s.deviation(clipped);
    Question {
        inputs,
        units: scene.segments.len(),
        cases: vec![
            case!(
                "direct",
                k,
                scene,
                |s, work| s.each(|segment| direct::counted::clip_segment(&s.window, segment, work)),
                judge,
            ),
            case!(
                "Cohen–Sutherland",
                k,
                scene,
                |s, work| s.each(|segment| cohen_sutherland::counted::clip_segment(
                    &s.window, segment, work
                )),
                judge,
            ),
            case!(
                "Liang–Barsky",
                k,
                scene,
                |s, work| s
                    .each(|segment| liang_barsky::counted::clip_segment(&s.window, segment, work)),
                judge,
            ),
            case!(
                "Cyrus–Beck",
                k,
                scene,
                |s, work| s
                    .each(|segment| cyrus_beck::counted::clip_segment(&s.corners, segment, work)),
                judge,
            ),
            case!(
                "textbook C–S",
                k,
                scene,
                |s, work| s.each(|segment| cohen_sutherland::textbook(&s.window, segment, work)),
                judge,
            ),
            case!(
                "textbook L–B",
                k,
                scene,
                |s, work| s.each(|segment| liang_barsky::textbook(&s.window, segment, work)),
                judge,
            ),
        ],
    }
}

#[cfg(test)]
mod tests;
