//! Study: faces turned away from the eye, drawn or left out.
//!
//! # What is asked
//!
//! A closed solid before the eye; of its faces about half look away.
//!
//! | sweep | knob | solid |
//! | --- | --- | --- |
//! | `sphere` | triangles, 10² … 10⁵ | convex: no face hides another that looks towards the eye |
//! | `torus` | triangles, 10² … 10⁵ | it hides parts of itself |
//!
//! # Error
//!
//! The share of pixels that do not show the nearest triangle, against a ray through each centre in integers. Leaving out
//! what cannot be seen should change nothing, and what it does change is counted besides: pixels that show something
//! else than by the same method without culling.
//!
//! # Techniques
//!
//! All on one thread.
//!
//! - `z-buffer` (the baseline): all faces, 24 bits.
//! - `culled z-buffer`: by the sign of each triangle in the picture, after its vertices are transformed.
//! - `z-buffer of front faces`: the others, and the vertices that only they have, are left out before anything is
//!   transformed, by [`back_face::visible`](ombra_hsr::back_face::visible). Where a face is seen nearly edge-on, moving
//!   its vertices to 2⁻⁸ of a pixel may turn it round: left out before, it leaves a gap there, and culled by the z-buffer
//!   it does not.
//! - `object space`, `culled object space`: all pairs of faces, or of those that look towards the eye. To 1000 triangles.

mod advice;
mod solid;

use std::rc::Rc;

use ombra_hsr::z_buffer::Cull;
use ombra_math::mesh::Mesh;
use ombra_math::work::Counter;

use crate::case;
use crate::culling::advice::advice;
use crate::culling::solid::{Solid, sphere, torus};
use crate::deviation::Measure;
use crate::hidden::Answer;
use crate::study::{Effort, Question, Shown, Study, Sweep, What};

/// The study.
pub const STUDY: Study = Study {
    id: "culling",
    summary: "Back faces drawn, culled, left out before",
    unit: "triangle",
    errors: &[Measure::Share("wrong pixels")],
    charted_work: &[Counter::Pairs, Counter::DepthTests],
    charts: &[
        Shown {
            sweep: "sphere",
            what: What::Work,
        },
        Shown {
            sweep: "sphere",
            what: What::Time,
        },
    ],
    ends: &[
        ("object space", "k² pairs"),
        ("culled object space", "k² pairs"),
    ],
    sweeps,
    advice,
};

/// The most triangles that are compared in pairs.
const MOST_PAIRS: usize = 1000;

fn sweeps(effort: Effort) -> Vec<Sweep> {
    let side = effort.choose(128, 512);
    let sweep = |name, solid: fn(u32) -> Mesh| Sweep {
        name,
        knob: "triangles",
        // Twice the square of this many triangles, nearly.
        questions: [8, 13, 22, 40, 71, 126, 223]
            .map(|parts| question(name, solid(parts), side))
            .into(),
    };
    vec![sweep("sphere", sphere), sweep("torus", torus)]
}

fn question(name: &str, mesh: Mesh, side: u32) -> Question {
    let triangles = mesh.triangles.len();
    let solid = Rc::new(Solid::new(mesh, side, triangles <= MOST_PAIRS));
    let setting = triangles as f64;
    let judge = |s: &Solid, answer: &Answer| s.verdict(answer);
    let mut cases = vec![
        case!(
            "z-buffer",
            setting,
            &solid,
            |s, work| s.scene.z_buffer(Cull::Nothing, work),
            judge
        ),
        case!(
            "culled z-buffer",
            setting,
            &solid,
            |s, work| s.scene.z_buffer(Cull::Back, work),
            judge
        ),
        case!(
            "z-buffer of front faces",
            setting,
            &solid,
            |s, work| s.left_out_before(work),
            judge
        ),
    ];
    if triangles <= MOST_PAIRS {
        let judge = |s: &Solid, answer: &Answer| s.verdict_of_object_space(answer);
        cases.extend([
            case!(
                "object space",
                setting,
                &solid,
                |s, work| s.scene.object_space(work),
                judge
            ),
            case!(
                "culled object space",
                setting,
                &solid,
                |s, work| s.culled_object_space(work),
                judge
            ),
        ]);
    }
    Question {
        inputs: format!("{name} of {triangles} triangles, {side}×{side} pixels"),
        units: triangles,
        cases,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::made_up::lines;
    use crate::report::{Answered, Row};
    use crate::run::run;

    fn find<'a>(question: &'a Answered, technique: &str) -> Option<&'a Row> {
        question.rows.iter().find(|row| row.technique == technique)
    }

    #[test]
    fn culling_halves_the_work_and_changes_nothing() {
        let report = run(&STUDY, Effort::Quick, &mut |_| ()).unwrap();
        for question in report.sweeps.iter().flat_map(|sweep| &sweep.questions) {
            let of = |technique| find(question, technique).unwrap();
            let whole = of("z-buffer");
            let (culled, before) = (of("culled z-buffer"), of("z-buffer of front faces"));
            let context = &question.inputs;
            for row in &question.rows {
                let unlike = row.faults[0].1;
                // Faces that snapping turns are 2⁻⁸ √2 pixels high at most, along outlines of less than 800 pixels:
                // 4.4 centres, with a spread of its root.
                let allowed = if row.technique == before.technique {
                    15
                } else {
                    0
                };
                assert!(unlike <= allowed, "{context} {}: {unlike}", row.technique);
                assert_eq!(row.deviation.missing, 0, "{context} {}", row.technique);
            }
            // A closed surface covers each pixel as often from its front as from its back, snapped or not.
            assert_eq!(whole.work.fragments, 2 * culled.work.fragments, "{context}");
            assert_eq!(
                whole.work.depth_tests,
                2 * culled.work.depth_tests,
                "{context}"
            );
            let turned = before.work.fragments.abs_diff(culled.work.fragments);
            assert!(turned <= 15, "{context}");
            // Culled by the picture, all vertices have been transformed before.
            assert_eq!(whole.work.vertices, culled.work.vertices, "{context}");
            assert!(before.work.vertices < whole.work.vertices, "{context}");

            let k = question.units as u64;
            let Some(all) = find(question, "object space") else {
                assert!(k > MOST_PAIRS as u64);
                continue;
            };
            let front = of("culled object space");
            assert_eq!(all.work.pairs, k * (k - 1) / 2, "{context}");
            // Less than half of the faces, for an eye this near; less than a quarter of the pairs.
            assert!(4 * front.work.pairs < all.work.pairs, "{context}");
            // Object space moves no vertex, so it is right.
            assert_eq!(
                (all.deviation.wrong, front.deviation.wrong),
                (0, 0),
                "{context}"
            );
        }
        let said = lines(&report.advice);
        assert!(
            said[0].starts_with("a closed solid in less time | culled z-buffer | "),
            "{said:?}"
        );
        assert!(
            said[0].ends_with(" | no pixel; 50 % of the depth tests are left"),
            "{said:?}"
        );
        let charts = report
            .charts(&ombra_figures::style::Style::default())
            .unwrap();
        assert_eq!(charts.len(), 2);
    }

    #[test]
    fn solids_are_closed_and_before_the_eye() {
        for mesh in [sphere(7), sphere(40), torus(7), torus(40)] {
            assert!(mesh.is_closed());
            let distances = mesh.positions.iter().map(|p| -p.z);
            assert!(distances.into_iter().all(|d| (2.0..16.0).contains(&d)));
        }
    }
}
