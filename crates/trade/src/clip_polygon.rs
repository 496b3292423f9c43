//! Study: a polygon against a window, as one outline or in separate pieces.
//!
//! # What is asked
//!
//! Polygons that cross the window's border often; few vertices come in many polygons at a time.
//!
//! | sweep | knob | polygon | in the window |
//! | --- | --- | --- | --- |
//! | `star` | vertices, 4 … 10⁴ | star-shaped round the window's middle, every other edge across the border | one piece |
//! | `comb` | vertices, 4 … 10⁴ | teeth that reach up into the window from a back below it | as many pieces as teeth |
//! | `far-star` | distance / size of the window, 1 … 10¹² | a star of 64 vertices, every other one that far away | one piece |
//!
//! # Error
//!
//! ```text
//! e = |area − A*| / A*
//!
//! A* = −Σ ∫ (clamp(y(x), y_min, y_max) − y_min) dx
//!      over the edges, x from edge to edge and in [x_min, x_max]
//! ```
//!
//! The area of the answer is that of exactly its vertices. A* is found without clipping any polygon: each edge adds the
//! area below it, and each sum is a quotient of integers, cut off at 2⁻³⁰⁰. Counted besides: vertices that lie outside
//! the window they were clipped against.
//!
//! # Techniques
//!
//! - `Sutherland–Hodgman` (the baseline): [`clip_polygon`](ombra_clip::sutherland_hodgman::clip_polygon), in one pass.
//! - `plain form`: the slide's, [`clip_polygon_plain`](ombra_clip::sutherland_hodgman::clip_polygon_plain), a pass a side,
//!   which gives the same answer.
//! - `pieces`: [`pieces::clip_polygon`]. The others leave what falls apart joined by
//!   edges along the border, which have no area: no error shows that, but an outline drawn does.
//! - `textbook f64`, `textbook f32`: four passes with crossings a + t (b − a), t rounded, of what the last pass has left.
//!   In f32 the vertices are stored in f32 too.

mod advice;
mod polygons;

use std::rc::Rc;

use ombra_clip::{pieces, sutherland_hodgman};

use crate::advice::power_of_ten;
use crate::case;
use crate::clip_polygon::advice::advice;
use crate::clip_polygon::polygons::WindowAndPolygons;
use crate::deviation::Measure;
use crate::study::{Effort, Question, Shown, Study, Sweep, What};

/// The study.
pub const STUDY: Study = Study {
    id: "clip-polygon",
    summary: "A polygon against a window: Sutherland–Hodgman, separate pieces",
    unit: "vertex",
    errors: &[Measure::Largest("relative error of the area")],
    charted_work: &[],
    charts: &[
        Shown {
            sweep: "far-star",
            what: What::Error(0),
        },
        Shown {
            sweep: "star",
            what: What::Time,
        },
        Shown {
            sweep: "far-star",
            what: What::Cost(6),
        },
    ],
    ends: &[],
    sweeps,
    advice,
};

fn sweeps(effort: Effort) -> Vec<Sweep> {
    let sweep = |name: &'static str, polygons: fn(usize, usize) -> WindowAndPolygons| {
        let questions = [4, 16, 64, 256, 1024, 4096, 10_000].map(|vertices| {
            let number = (effort.choose(1000, 20_000) / vertices).clamp(1, 500);
            let inputs = match number {
                1 => format!("1 polygon of {vertices} vertices"),
                _ => format!("{number} polygons of {vertices} vertices"),
            };
            question(
                inputs,
                vertices as f64,
                &Rc::new(polygons(vertices, number)),
            )
        });
        Sweep {
            name,
            knob: "vertices",
            questions: questions.into(),
        }
    };
    let far = (0..=12).map(|k| {
        let distance = libm::exp10(f64::from(k));
        let number = effort.choose(10, 100);
        let scene = Rc::new(WindowAndPolygons::far_stars(distance, 64, number));
        let inputs = format!(
            "{number} polygons with vertices {} window sizes away",
            power_of_ten(distance)
        );
        question(inputs, distance, &scene)
    });
    let far = Sweep {
        name: "far-star",
        knob: "distance of the vertices / window size",
        questions: far.collect(),
    };
    vec![
        sweep("star", WindowAndPolygons::stars),
        sweep("comb", WindowAndPolygons::combs),
        far,
    ]
}

fn question(inputs: String, k: f64, scene: &Rc<WindowAndPolygons>) -> Question {
    Question {
        inputs,
        units: scene.polygons.iter().map(Vec::len).sum(),
        cases: vec![
            case!(
                "Sutherland–Hodgman",
                k,
                scene,
                |s, work| s.each(|p| sutherland_hodgman::counted::clip_polygon(&s.window, p, work)),
                |s, outlines| s.verdict(outlines),
            ),
            case!(
                "plain form",
                k,
                scene,
                |s, work| s.each(|p| sutherland_hodgman::clip_polygon_plain(&s.window, p, work)),
                |s, outlines| s.verdict(outlines),
            ),
            case!(
                "pieces",
                k,
                scene,
                |s, work| s.each(|p| pieces::counted::clip_polygon(&s.window, p, work)),
                |s, outlines| s.verdict_of_pieces(outlines),
            ),
            case!(
                "textbook f64",
                k,
                scene,
                |s, work| s.each(|p| sutherland_hodgman::textbook(&s.window, p, work)),
                |s, outlines| s.verdict(outlines),
            ),
            case!(
                "textbook f32",
                k,
                scene,
                |s, work| s.each_f32(|p| sutherland_hodgman::textbook_f32(&s.window, p, work)),
                |s, outlines| s.verdict_f32(outlines),
            ),
        ],
    }
}

#[cfg(test)]
mod tests;
