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
mod scene;
mod textbook;

use std::rc::Rc;

use ombra_clip::{cohen_sutherland, cyrus_beck, direct, liang_barsky};

use crate::advice::{percent, power_of_ten};
use crate::clip_segment::advice::advice;
use crate::clip_segment::scene::{Clipped, Scene};
use crate::deviation::Measure;
use crate::study::{Case, Effort, Question, Study, Sweep};

/// The study.
pub const STUDY: Study = Study {
    id: "clip-segment",
    summary: "A segment against a window: direct, Cohen–Sutherland, Liang–Barsky, Cyrus–Beck",
    unit: "segment",
    errors: &[Measure::Largest(
        "distance from the exact ends / window size",
    )],
    charted_work: &[],
    sweeps,
    advice,
};

fn sweeps(effort: Effort) -> Vec<Sweep> {
    let segments = effort.choose(400, 4000);
    let outside = [0, 10, 20, 30, 40, 50, 60, 70, 80, 90, 100].map(|share| {
        let share = f64::from(share) / 100.0;
        let scene = Rc::new(Scene::outside(share, segments));
        question(
            format!("{} of {segments} segments outside", percent(share)),
            share,
            &scene,
        )
    });
    let far_ends = (0..=12).map(|k| {
        let distance = (0..k).fold(1.0, |power, _| 10.0 * power);
        let scene = Rc::new(Scene::far_ends(distance, segments));
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
            charted: 5,
        },
        Sweep {
            name: "far-ends",
            knob: "distance of the ends / window size",
            questions: far_ends.collect(),
            charted: 6,
        },
    ]
}

fn question(inputs: String, k: f64, scene: &Rc<Scene>) -> Question {
    let judge = |s: &Scene, clipped: &Clipped| s.deviation(clipped);
    Question {
        inputs,
        units: scene.segments.len(),
        cases: vec![
            Case::new(
                "direct",
                k,
                scene,
                |s| s.each(|segment| direct::clip_segment(&s.window, segment)),
                |s, work| s.each(|segment| direct::clip_segment_counted(&s.window, segment, work)),
                judge,
            ),
            Case::new(
                "Cohen–Sutherland",
                k,
                scene,
                |s| s.each(|segment| cohen_sutherland::clip_segment(&s.window, segment)),
                |s, work| {
                    s.each(|segment| {
                        cohen_sutherland::clip_segment_counted(&s.window, segment, work)
                    })
                },
                judge,
            ),
            Case::new(
                "Liang–Barsky",
                k,
                scene,
                |s| s.each(|segment| liang_barsky::clip_segment(&s.window, segment)),
                |s, work| {
                    s.each(|segment| liang_barsky::clip_segment_counted(&s.window, segment, work))
                },
                judge,
            ),
            Case::new(
                "Cyrus–Beck",
                k,
                scene,
                |s| s.each(|segment| cyrus_beck::clip_segment(&s.corners, segment)),
                |s, work| {
                    s.each(|segment| cyrus_beck::clip_segment_counted(&s.corners, segment, work))
                },
                judge,
            ),
            Case::new(
                "textbook C–S",
                k,
                scene,
                |s| s.each(|segment| textbook::cohen_sutherland(&s.window, segment, &mut ())),
                |s, work| s.each(|segment| textbook::cohen_sutherland(&s.window, segment, work)),
                judge,
            ),
            Case::new(
                "textbook L–B",
                k,
                scene,
                |s| s.each(|segment| textbook::liang_barsky(&s.window, segment, &mut ())),
                |s, work| s.each(|segment| textbook::liang_barsky(&s.window, segment, work)),
                judge,
            ),
        ],
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::deviation::Deviation;
    use crate::run::judge;
    use ombra_math::work::Work;

    type Judged = Vec<(&'static str, &'static str, f64, Work, Deviation)>;

    fn judged() -> Judged {
        let sweeps = sweeps(Effort::Quick);
        let numbers = judge(STUDY.id, &sweeps, &mut |_| ()).unwrap();
        let cases = sweeps.iter().flat_map(|s| {
            let cases = s.questions.iter().flat_map(|q| &q.cases);
            cases.map(|case| (s.name, case))
        });
        cases
            .zip(numbers)
            .map(|((sweep, case), (work, verdict))| {
                (sweep, case.technique, case.setting, work, verdict.deviation)
            })
            .collect()
    }

    const EXACT: [&str; 4] = ["direct", "Cohen–Sutherland", "Liang–Barsky", "Cyrus–Beck"];

    #[test]
    fn errors_and_counts() {
        let rows = judged();
        assert_eq!(rows.len(), (11 + 13) * 6);
        for (sweep, technique, k, work, deviation) in &rows {
            let context = format!("{sweep} {technique} {k:e}: {deviation:?}, {work}");
            assert_eq!(deviation.asked, 400, "{context}");
            if EXACT.contains(technique) {
                assert_eq!(deviation.missing, 0, "{context}");
                // Half an ulp of coordinates below 16, over a window of 10.2.
                assert!(deviation.max <= 2f64.powi(-50) / 10.0, "{context}");
                // Nothing crosses the border where all ends are inside.
                assert!(work.divisions <= 4 * 400, "{context}");
            } else {
                // A cut errs by a few roundings of the ends; the second cut of a flat segment by its slope times that.
                assert!(
                    deviation.max <= 1e3 * k.max(1.0) * f64::EPSILON,
                    "{context}"
                );
            }
        }
    }

    #[test]
    fn who_is_outside_costs_no_intersection() {
        let rows = judged();
        let divisions = |technique, k| {
            let row = rows
                .iter()
                .find(|r| (r.0, r.1, r.2) == ("outside", technique, k));
            row.unwrap().3.divisions
        };
        for technique in EXACT {
            let (all_in, all_out) = (divisions(technique, 0.0), divisions(technique, 1.0));
            assert!(
                all_in > 0 && all_out < all_in,
                "{technique}: {all_in}, {all_out}"
            );
        }
        // Of what is outside, Liang–Barsky intersects nothing; the direct method tries every side that is crossed.
        assert_eq!(divisions("Liang–Barsky", 1.0), 0);
        for k in [0.0, 0.5, 1.0] {
            assert!(divisions("direct", k) > divisions("Liang–Barsky", k));
        }
    }

    #[test]
    fn textbook_forms_lose_a_digit_for_every_digit_of_distance() {
        let rows = judged();
        for (_, technique, k, _, deviation) in rows.iter().filter(|r| r.0 == "far-ends") {
            if technique.starts_with("textbook") && (1e2..=1e10).contains(k) {
                // Ends of k are rounded to k ε, so differences of them are too.
                assert!(
                    deviation.max >= 0.05 * k * f64::EPSILON,
                    "{technique} {k:e}: {deviation:?}"
                );
            }
        }
    }

    #[test]
    fn the_study_says_what_exactness_costs() {
        let report = crate::run::run(&STUDY, Effort::Quick, &mut |_| ()).unwrap();
        let said = &report.advice;
        assert!(said.starts_with("For ends rounded once use "), "{said}");
        assert!(said.contains("textbook L–B"), "{said}");
        assert!(said.ends_with('.') && !said.contains(". "), "{said}");
        let charts = report
            .charts(&ombra_figures::style::Style::default())
            .unwrap();
        assert_eq!(charts.len(), 6);
    }
}
