//! Study: the shadow of a point on a plane, by matrix, quotient, parameter and correctly rounded.
//!
//! # What is asked
//!
//! A plane that is parallel to no axis, a light, and vertices that all cast a shadow; they are doubles, and the truth is
//! the shadow of exactly these doubles. Three things are turned until digits are lost:
//!
//! | sweep | knob | what cancels |
//! | --- | --- | --- |
//! | `towards-plane` | distance of the light / its height, 1 … 10¹⁵ | s = π·L, and t = n·V + d of vertices below it |
//! | `to-infinity` | 1/w of the light (D, w), 1 … 10¹⁵ | V − L, where the light is made a place |
//! | `far-from-origin` | distance of the scene from the origin / its size, 1 … 10¹² | n·V against d |
//!
//! # Error
//!
//! ```text
//! e = ‖P − P*‖∞ / ‖P* − O‖∞
//! P* the exact shadow,  O the middle of the scene (the origin in the first two)
//! ```
//!
//! P is the answer as it is, P* a quotient of integers; only e itself is rounded. With ‖P*‖∞ below, an error as large as
//! the scene would look small far from the origin, just because the coordinates are large; distances from O do not.
//!
//! # Techniques
//!
//! - `matrix f64` (the baseline), `matrix f32`: the shadow matrix, made in doubles once a light outside the clock, times
//!   a vertex, divided by w where w > 0. In f32 the vertices are stored in f32 too, as in a vertex buffer. (A vertex
//!   behind the plane has w > 0 too: pipelines clip it away. None is behind it here.)
//! - `quotient f64`, `parameter f64`, `cast`: [`by_quotient`], [`by_parameter`] and the correctly rounded
//!   [`cast`](ombra_shadows::planar::cast()) of `ombra-shadows`, which also decide whether there is a shadow.
//! - `directional f64` (`to-infinity`): the light is taken as a direction, w = 0, and w divided out of the matrix, so that
//!   nine multiplications are left. Its error is that of calling a far light infinitely far, O(w).
//! - `moved origin f64` (`far-from-origin`): O is subtracted from every vertex, and the shadow stays relative to O.
//!
//! Counted work is of numbers as the technique has them: a multiplication of `cast` is one of double-doubles, a dozen
//! or more of doubles.
//!
//! [`by_quotient`]: ombra_shadows::planar::textbook::by_quotient
//! [`by_parameter`]: ombra_shadows::planar::textbook::by_parameter

mod advice;
mod casts;
mod techniques;

use std::rc::Rc;

use crate::advice::power_of_ten;
use crate::case;
use crate::deviation::Measure;
use crate::planar_precision::advice::advice;
use crate::planar_precision::casts::Casts;
use crate::planar_precision::techniques::{
    cast, directional_f64, matrix_f32, matrix_f64, moved_origin, parameter_f64, quotient_f64,
};
use crate::study::{Case, Effort, Question, Shown, Study, Sweep, What};

/// The study.
pub const STUDY: Study = Study {
    id: "planar-precision",
    summary: "The shadow of a point on a plane: matrix, quotient, parameter, correctly rounded",
    unit: "vertex",
    errors: &[Measure::Largest("relative error of the shadow")],
    charted_work: &[],
    charts: &[
        Shown {
            sweep: "towards-plane",
            what: What::Error(0),
        },
        Shown {
            sweep: "towards-plane",
            what: What::Cost(4),
        },
        Shown {
            sweep: "far-from-origin",
            what: What::Error(0),
        },
        Shown {
            sweep: "far-from-origin",
            what: What::Cost(6),
        },
        Shown {
            sweep: "to-infinity",
            what: What::Error(0),
        },
    ],
    ends: &[],
    sweeps,
    advice,
};

fn sweeps(effort: Effort) -> Vec<Sweep> {
    let vertices = effort.choose(200, 2000);
    let powers = |last: i32| (0..=last).map(|k| libm::exp10(f64::from(k)));
    let towards_plane = powers(15).map(|k| {
        let scene = Rc::new(Casts::towards_plane(1.0 / k, vertices));
        let inputs = format!("light {} times as far as high", power_of_ten(k));
        question(inputs, &scene, common(k, &scene))
    });
    let to_infinity = powers(15).map(|k| {
        let scene = Rc::new(Casts::to_infinity(1.0 / k, vertices));
        let mut cases = common(k, &scene);
        cases.push(case!(
            "directional f64",
            k,
            &scene,
            |s, work| directional_f64(s, work),
            |s, shadows| s.deviation(shadows),
        ));
        question(
            format!("light (D, {})", power_of_ten(1.0 / k)),
            &scene,
            cases,
        )
    });
    let far = powers(12).map(|k| {
        let scene = Rc::new(Casts::far_from_origin(k, vertices));
        let mut cases = common(k, &scene);
        cases.push(case!(
            "moved origin f64",
            k,
            &scene,
            |s, work| moved_origin(s, work),
            |s, shadows| s.deviation_from_middle(shadows),
        ));
        question(
            format!("scene {} times its size away", power_of_ten(k)),
            &scene,
            cases,
        )
    });
    vec![
        Sweep {
            name: "towards-plane",
            knob: "distance of the light / its height",
            questions: towards_plane.collect(),
        },
        Sweep {
            name: "to-infinity",
            knob: "1 / w of the light",
            questions: to_infinity.collect(),
        },
        Sweep {
            name: "far-from-origin",
            knob: "distance from the origin / size of the scene",
            questions: far.collect(),
        },
    ]
}

fn question(light: String, scene: &Casts, cases: Vec<Case>) -> Question {
    let units = scene.vertices.len();
    Question {
        inputs: format!("{light}; {units} vertices"),
        units,
        cases,
    }
}

/// The techniques that every sweep compares.
fn common(k: f64, scene: &Rc<Casts>) -> Vec<Case> {
    let judge = |s: &Casts, shadows: &Vec<_>| s.deviation(shadows);
    let judge_f32 = |s: &Casts, shadows: &Vec<_>| s.deviation_f32(shadows);
    vec![
        case!("matrix f64", k, scene, |s, work| matrix_f64(s, work), judge),
        case!(
            "matrix f32",
            k,
            scene,
            |s, work| matrix_f32(s, work),
            judge_f32
        ),
        case!(
            "quotient f64",
            k,
            scene,
            |s, work| quotient_f64(s, work),
            judge
        ),
        case!(
            "parameter f64",
            k,
            scene,
            |s, work| parameter_f64(s, work),
            judge
        ),
        case!("cast", k, scene, |s, work| cast(s, work), judge),
    ]
}

#[cfg(test)]
mod tests;
