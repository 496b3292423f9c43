//! Study: which primitive is seen at each pixel, by the four methods of the lecture.
//!
//! # What is asked
//!
//! Triangles at random places, turned and inclined, between 4 and 12 away from the eye; many cross each other. Together
//! they always cover twice the picture: more primitives are smaller ones, as in the lecture.
//!
//! | sweep | knob | picture |
//! | --- | --- | --- |
//! | `primitives` | k, 10 … 10⁵ | of one size |
//! | `pixels` | n·m | k = 300 |
//!
//! # Error
//!
//! The share of pixels that do not show the nearest triangle. The truth is a ray through each centre in integers, that
//! shares nothing with the methods: at all pixels, whatever k. A centre that is on an edge is not asked.
//!
//! # Techniques
//!
//! All on one thread, all until the picture is painted.
//!
//! - `z-buffer` (the baseline): 24 bits, vertices moved to 2⁻⁸ of a pixel.
//! - `image space`: every ray with every primitive, n·m·k intersections. To 300 primitives, where the line is clear.
//! - `image space with boxes`: [`cast`](ombra_hsr::image_space::cast), a ray with the primitives about its pixel.
//! - `object space`: every primitive with every other, k (k − 1)/2 pairs; the visible parts are painted. To 3000
//!   primitives.
//! - `painter`: [`order_by_cutting`](ombra_hsr::painter::order_by_cutting), painted back to front.
//! - `sort only`: painted by the distance of the farthest vertex, no pair compared.

mod advice;
mod triangles;

use std::rc::Rc;

use ombra_hsr::z_buffer::Cull;
use ombra_math::work::Counter;

use crate::case;
use crate::deviation::Measure;
use crate::hidden::{Answer, TrianglesInView};
use crate::study::{Effort, Question, Shown, Study, Sweep, What};
use crate::visibility::advice::advice;
use crate::visibility::triangles::triangles;

/// The study.
pub const STUDY: Study = Study {
    id: "visibility",
    summary: "What is seen: z-buffer, image space, object space, painter",
    unit: "pixel",
    errors: &[Measure::Share("wrong pixels")],
    charted_work: &[
        Counter::Pairs,
        Counter::Intersections,
        Counter::DepthTests,
        Counter::Fragments,
    ],
    charts: &[
        Shown {
            sweep: "primitives",
            what: What::Work,
        },
        Shown {
            sweep: "primitives",
            what: What::Time,
        },
        Shown {
            sweep: "primitives",
            what: What::Cost(3),
        },
    ],
    ends: &[
        ("image space", "n·m·k rays"),
        ("object space", "k² pairs"),
        ("image space with boxes", "few in a quick run"),
        ("painter", "few in a quick run"),
    ],
    sweeps,
    advice,
};

/// How many primitives the methods are given at most, whose cost is known to go on growing.
#[derive(Clone, Copy)]
struct Limits {
    /// Every ray with every primitive.
    rays: usize,
    /// Every primitive with every other.
    pairs: usize,
    /// Image space with boxes, and the painter.
    sorted: usize,
}

fn sweeps(effort: Effort) -> Vec<Sweep> {
    let side = effort.choose(64, 192);
    let limits = Limits {
        rays: 300,
        pairs: effort.choose(1000, 3000),
        sorted: effort.choose(10_000, 100_000),
    };
    let primitives = [10, 30, 100, 300, 1000, 3000, 10_000, 30_000, 100_000];
    let questions = primitives.map(|k| question(k, side, k as f64, limits));
    let sides = effort.choose([4, 8, 16, 32, 64], [8, 16, 32, 64, 128]);
    let pictures = sides.map(|side| question(300, side, f64::from(side * side), limits));
    vec![
        Sweep {
            name: "primitives",
            knob: "primitives",
            questions: questions.into(),
        },
        Sweep {
            name: "pixels",
            knob: "pixels",
            questions: pictures.into(),
        },
    ]
}

fn question(k: usize, side: u32, setting: f64, limits: Limits) -> Question {
    let scene = Rc::new(TrianglesInView::new(triangles(k), side));
    let judge = |s: &TrianglesInView, answer: &Answer| s.deviation(answer);
    // Up to how many primitives, and who.
    let cases = [
        (
            usize::MAX,
            case!(
                "z-buffer",
                setting,
                &scene,
                |s, work| s.z_buffer(Cull::Nothing, work),
                judge
            ),
        ),
        (
            limits.rays,
            case!(
                "image space",
                setting,
                &scene,
                |s, work| s.image_space(work),
                judge
            ),
        ),
        (
            limits.sorted,
            case!(
                "image space with boxes",
                setting,
                &scene,
                |s, work| s.image_space_in_boxes(work),
                judge
            ),
        ),
        (
            limits.pairs,
            case!(
                "object space",
                setting,
                &scene,
                |s, work| s.object_space(work),
                judge
            ),
        ),
        (
            limits.sorted,
            case!("painter", setting, &scene, |s, work| s.painter(work), judge),
        ),
        (
            usize::MAX,
            case!(
                "sort only",
                setting,
                &scene,
                |s, work| s.sort_only(work),
                judge
            ),
        ),
    ];
    let asked = cases.into_iter().filter(|(most, _)| k <= *most);
    Question {
        inputs: format!("{k} triangles, {side}×{side} pixels"),
        units: scene.pixels(),
        cases: asked.map(|(_, case)| case).collect(),
    }
}

#[cfg(test)]
mod tests;
