//! Speed against accuracy, measured: every technique of the course that has a knob, on the same inputs.
//!
//! A [study](study::Study) puts [questions](study::Question) to techniques. A run takes each case's time in interleaved
//! rounds, counts its work exactly, and compares its answers with a ground truth that owes nothing to it
//! and rounds nothing ([`ombra_oracle`]; [`run::run`]); the [report](report::Report) is a table, charts with the Pareto front, and advice
//! made from the numbers: what to take for which need, at which setting, at what cost, and what is lost.
//! Charts and advice are drawn anew from the [table](report::Report::read) without a run.
//!
//! | module | what it is |
//! | --- | --- |
//! | [`study`] | what a study is made of |
//! | [`run`] | interleaved rounds, errors, counted work |
//! | [`report`] | table, charts, files |
//! | [`advice`] | which technique to take where |
//! | [`pareto`] | the choices that nothing beats |
//! | [`deviation`], [`statistics`] | largest and RMS error; medians and quartiles |
//! | [`random`] | inputs that repeat |
//! | [`line_precision`] | study: the pixels of a segment |
//! | [`triangle_subpixel`] | study: triangles that share edges, snapped |
//! | [`clip_segment`] | study: a segment against a window |
//! | [`clip_polygon`] | study: a polygon against a window |
//! | [`visibility`] | study: the nearest primitive at each pixel |
//! | [`depth_format`] | study: two surfaces almost on one another |
//! | [`culling`] | study: faces turned away from the eye |
//! | [`planar_precision`] | study: the shadow of a point on a plane |
//!
//! # Adding a study
//!
//! Name the techniques, their knob, the inputs and the ground truth; then add the study to [`studies`].
//!
//! ```
//! use std::rc::Rc;
//! use ombra_math::work::{Count, Counter};
//! use ombra_trade::advice::Advice;
//! use ombra_trade::case;
//! use ombra_trade::deviation::{Deviation, Measure};
//! use ombra_trade::run::run;
//! use ombra_trade::study::{Effort, Question, Shown, Study, Sweep, What};
//!
//! // A technique: the sum of n tenths, by additions of doubles or by one product.
//! fn added(n: u32, work: &mut impl Count) -> f64 {
//!     (0..n).fold(0.0, |sum, _| {
//!         work.add(Counter::Additions, 1);
//!         sum + 0.1
//!     })
//! }
//! fn multiplied(n: u32, work: &mut impl Count) -> f64 {
//!     work.add(Counter::Multiplications, 1);
//!     f64::from(n) * 0.1
//! }
//! // The ground truth: n/10, as far as a double can say it.
//! fn judge(n: &u32, sum: &f64) -> Deviation {
//!     Deviation::of([Some(sum - f64::from(*n) / 10.0)])
//! }
//!
//! let study = Study {
//!     id: "tenths",
//!     summary: "n tenths, added or multiplied",
//!     unit: "sum",
//!     errors: &[Measure::Largest("error of the sum")],
//!     charted_work: &[],
//!     charts: &[Shown { sweep: "count", what: What::Error(0) }],
//!     ends: &[],
//!     sweeps: |_effort| {
//!         let question = |n: u32| {
//!             let (inputs, knob) = (Rc::new(n), f64::from(n));
//!             Question {
//!                 inputs: format!("{n} tenths"),
//!                 units: 1,
//!                 cases: vec![
//!                     case!("added", knob, &inputs, |n, work| added(*n, work), judge),
//!                     case!(
//!                         "multiplied", knob, &inputs, |n, work| multiplied(*n, work), judge
//!                     ),
//!                 ],
//!             }
//!         };
//!         let questions = [10, 100, 1000].map(question).into();
//!         vec![Sweep { name: "count", knob: "number of tenths", questions }]
//!     },
//!     advice: |_| Advice::default(),
//! };
//! let report = run(&study, Effort::Quick, &mut |_progress| ())?;
//! let rows = &report.sweeps[0].questions[0].rows;
//! assert_eq!((rows[0].work.additions, rows[0].deviation.max), (10, f64::EPSILON / 2.0));
//! assert_eq!((rows[1].work.multiplications, rows[1].deviation.max), (1, 0.0));
//! # Ok::<(), ombra_trade::error::TradeError>(())
//! ```
#![doc(html_root_url = "https://docs.rs/ombra-trade/latest")]

pub mod advice;
mod charts;
pub mod clip_polygon;
pub mod clip_segment;
mod clipping;
pub mod culling;
pub mod depth_format;
pub mod deviation;
pub mod error;
mod hidden;
pub mod line_precision;
pub mod pareto;
pub mod planar_precision;
pub mod random;
pub mod report;
pub mod run;
pub mod statistics;
pub mod study;
pub mod triangle_subpixel;
pub mod visibility;

use error::TradeError;
use study::Study;

/// All studies, in the order of the course.
#[must_use]
pub fn studies() -> &'static [Study] {
    &[
        line_precision::STUDY,
        triangle_subpixel::STUDY,
        clip_segment::STUDY,
        clip_polygon::STUDY,
        visibility::STUDY,
        depth_format::STUDY,
        culling::STUDY,
        planar_precision::STUDY,
    ]
}

/// The studies that `names` name, in the order of [`studies`]; all when there is none.
///
/// # Errors
///
/// [`TradeError::UnknownStudy`] for the first name that no study has.
pub fn select<N: AsRef<str>>(names: &[N]) -> Result<Vec<&'static Study>, TradeError> {
    for name in names {
        if !studies().iter().any(|study| study.id == name.as_ref()) {
            let ids: Vec<_> = studies().iter().map(|study| study.id).collect();
            return Err(TradeError::UnknownStudy {
                name: name.as_ref().to_owned(),
                allowed: ids.join(", "),
            });
        }
    }
    let wanted =
        |study: &&Study| names.is_empty() || names.iter().any(|name| name.as_ref() == study.id);
    Ok(studies().iter().filter(wanted).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn studies_are_chosen_by_name() {
        assert_eq!(
            select::<&str>(&[]).map(|chosen| chosen.len()),
            Ok(studies().len())
        );
        assert_eq!(
            select(&["planar-precision"]).map(|chosen| chosen.len()),
            Ok(1)
        );
        let error = select(&["planar-precision", "planar"])
            .err()
            .map(|error| error.to_string());
        assert_eq!(
            error.as_deref(),
            Some(
                "there is no study 'planar': there are line-precision, triangle-subpixel, clip-segment, clip-polygon, visibility, depth-format, culling, planar-precision"
            )
        );
    }

    #[test]
    fn ids_are_unique_and_of_one_form() {
        let mut ids: Vec<_> = studies().iter().map(|study| study.id).collect();
        assert!(ids.iter().all(|id| !id.is_empty() && id.bytes().all(|b| b.is_ascii_lowercase() || b == b'-')));
        ids.dedup();
        assert_eq!(ids.len(), studies().len());
    }
}
