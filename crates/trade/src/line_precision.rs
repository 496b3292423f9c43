//! Study: the pixels of a segment, by product, by sum and by integers.
//!
//! # What is asked
//!
//! Segments of 10 to 10⁷ moves, with any slope, in all eight octants; the sweep is `length`. Short ones come many at a
//! time, so that all slopes are there.
//!
//! # Error
//!
//! ```text
//! e = |y − y*|        y* = ⌈i·dy/dx − ½⌉
//! in pixels, i moves from the start along the longer axis
//! ```
//!
//! y* is the pixel nearest to the exact line, at a tie the one nearer the start: a quotient of integers, taken anew at
//! each move. A pixel in another column is no answer to this column's question and counts as missing. Two charts: the
//! largest e, and the share of pixels with e > 0.
//!
//! # Techniques
//!
//! [`analytic`] (the baseline), [`DDA`](ombra_raster::dda) in f64 and f32 and
//! [`Bresenham`](ombra_raster::bresenham), as `ombra-raster` has them: one pixel after another. Each goes into a checksum
//! that depends on the order and costs two additions, since storing ten million pixels would cost more than
//! finding them. Who judges draws the segment once more and compares pixels with the truth and their checksum
//! with the one that was timed.

mod advice;
mod segments;

use std::rc::Rc;

use ombra_raster::{analytic, bresenham, dda};

use crate::case;
use crate::deviation::Measure;
use crate::line_precision::advice::advice;
use crate::line_precision::segments::Segments;
use crate::study::{Effort, Question, Shown, Study, Sweep, What};

/// The study.
pub const STUDY: Study = Study {
    id: "line-precision",
    summary: "The pixels of a segment: analytic, DDA, Bresenham",
    unit: "pixel",
    errors: &[
        Measure::Largest("distance from the right pixel (pixels)"),
        Measure::Share("wrong pixels"),
    ],
    charted_work: &[],
    charts: &[
        Shown {
            sweep: "length",
            what: What::Error(0),
        },
        Shown {
            sweep: "length",
            what: What::Cost(5),
        },
    ],
    ends: &[],
    sweeps,
    advice,
};

fn sweeps(effort: Effort) -> Vec<Sweep> {
    let questions = [10, 100, 1000, 10_000, 100_000, 1_000_000, 10_000_000].map(|length| {
        // About as many pixels at each length, up to where two slopes are the least to ask.
        let number = (effort.choose(100_000, 1_000_000) / length).clamp(2, 1000);
        question(&Rc::new(Segments::new(length, number)))
    });
    vec![Sweep {
        name: "length",
        knob: "moves from end to end",
        questions: questions.into(),
    }]
}

/// A technique that is an iterator of pixels: drawn without and with counting, and once more by who judges.
macro_rules! drawn {
    ($technique:expr, $segments:expr, $pixels:path) => {
        case!(
            $technique,
            f64::from($segments.length),
            $segments,
            |s, work| s.draw(|a, b, drawn| drawn.all($pixels(a, b, work))),
            // The iterator holds its counter. One that is nothing takes no room on the heap, so none is lost.
            |s, drawn| s.deviation(drawn, |a, b| $pixels(a, b, Box::leak(Box::new(()))))
        )
    };
}

fn question(segments: &Rc<Segments>) -> Question {
    Question {
        inputs: format!(
            "{} segments of {} moves",
            segments.ends.len(),
            segments.length
        ),
        units: segments.pixels(),
        cases: vec![
            drawn!("analytic", segments, analytic::counted::segment),
            drawn!("DDA f64", segments, dda::counted::segment),
            drawn!("DDA f32", segments, dda::counted::segment_f32),
            drawn!("Bresenham", segments, bresenham::counted::segment),
        ],
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::made_up::lines;
    use crate::run::judged::judged;

    #[test]
    fn what_is_right_how_long_and_at_what_work() {
        let rows = judged(&STUDY);
        assert_eq!(rows.len(), 7 * 4);
        for row in &rows {
            let (technique, length) = (row.technique, row.setting);
            let (work, deviation, context) = (row.work, row.deviation, row.context());
            let answered = (deviation.asked, deviation.missing);
            assert_eq!(answered, (row.units, 0), "{context}");
            let pixels = row.units as u64;
            let segments = pixels / (length as u64 + 1);
            let rounded = if technique == "Bresenham" { 0 } else { pixels };
            assert_eq!(work.roundings, rounded, "{context}");
            match technique {
                "Bresenham" => {
                    assert_eq!(deviation.wrong, 0, "{context}");
                    // Integers: an addition a move, no product, no quotient.
                    assert_eq!(work.additions, pixels - segments, "{context}");
                    assert_eq!(work.multiplications + work.divisions, 0);
                }
                "analytic" => {
                    // 12 dx² < 2⁵³ up to 27 million moves: the rounded y is on the right side of every boundary.
                    assert_eq!(deviation.wrong, 0, "{context}");
                    assert_eq!(work.multiplications, pixels, "{context}");
                }
                "DDA f64" => {
                    // 2 dx³ < 2⁵³ up to 165 000 moves.
                    assert!(deviation.wrong == 0 || length > 165_000.0, "{context}");
                    // One sum too many is no more than dx² u = 10¹⁴ · 2⁻⁵³ away: the next pixel at most.
                    assert!(deviation.max <= 1.0, "{context}");
                    assert_eq!(work.multiplications, 0, "{context}");
                }
                _ => {
                    // (0, 0)→(299, 231) is the shortest that goes wrong.
                    assert!(deviation.wrong == 0 || length > 298.0, "{context}");
                    assert_eq!(work.multiplications, 0, "{context}");
                }
            }
        }
        let f32_at = |k| {
            let mut rows = rows.iter();
            let row = rows.find(|row| row.technique == "DDA f32" && row.setting == k);
            row.map(|row| (row.deviation.max, row.deviation.wrong_share()))
                .unwrap()
        };
        // u = 2⁻²⁴: the errors of 10⁴ sums reach 10⁸ u = 6 pixels if all go one way, those of 10⁷ millions.
        assert!(f32_at(1e3).1 > 0.0 && f32_at(1e3).0 == 1.0);
        assert!(
            f32_at(1e7).0 > 1e4 && f32_at(1e7).1 > 0.9,
            "{:?}",
            f32_at(1e7)
        );
    }

    #[test]
    fn the_study_says_where_floating_point_ends() {
        let said = crate::run::run(&STUDY, Effort::Quick, &mut |_| ()).unwrap();
        let lines = lines(&said.advice);
        assert!(lines[0].starts_with("every pixel right | "), "{lines:?}");
        assert!(
            lines[0].contains(" | to 10⁷ moves | 1.0 | nothing"),
            "{lines:?}"
        );
        let wrong = |line: &&String| line.contains("| DDA f32 |") && line.contains("| beyond: ");
        assert!(lines.iter().any(|line| wrong(&line)), "{lines:?}");
        let charts = said
            .charts(&ombra_figures::style::Style::default())
            .unwrap();
        assert_eq!(charts.len(), 2);
    }
}
