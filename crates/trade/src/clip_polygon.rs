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
//! A* = −Σ ∫ (clamp(y(x), y_min, y_max) − y_min) dx        over the edges, x from edge to edge and in [x_min, x_max]
//! ```
//!
//! The area of the answer is that of exactly its vertices. A* is found without clipping any polygon: each edge adds the
//! area below it, and each sum is a quotient of integers, cut off at 2⁻³⁰⁰. Counted besides: vertices that lie outside
//! the window they were clipped against.
//!
//! # Techniques
//!
//! - `Sutherland–Hodgman` (the baseline): [`clip_polygon`](ombra_clip::sutherland_hodgman::clip_polygon), in one pass.
//! - `in four passes`: its plain form, [`clip_polygon_in_passes`](ombra_clip::sutherland_hodgman::clip_polygon_in_passes),
//!   which gives the same answer.
//! - `pieces`: [`pieces::clip_polygon`]. The others leave what falls apart joined by
//!   edges along the border, which have no area: no error shows that, but an outline drawn does.
//! - `textbook f64`, `textbook f32`: four passes with crossings a + t (b − a), t rounded, of what the last pass has left.
//!   In f32 the vertices are stored in f32 too.

mod advice;
mod scene;
mod textbook;

use std::rc::Rc;

use ombra_clip::{pieces, sutherland_hodgman};

use crate::advice::power_of_ten;
use crate::clip_polygon::advice::advice;
use crate::clip_polygon::scene::Scene;
use crate::deviation::Measure;
use crate::study::{Case, Effort, Question, Study, Sweep};

/// The study.
pub const STUDY: Study = Study {
    id: "clip-polygon",
    summary: "A polygon against a window: Sutherland–Hodgman, separate pieces",
    unit: "vertex",
    errors: &[Measure::Largest("relative error of the area")],
    charted_work: &[],
    sweeps,
    advice,
};

fn sweeps(effort: Effort) -> Vec<Sweep> {
    let sweep = |name: &'static str, polygons: fn(usize, usize) -> Scene| {
        let questions = [4, 16, 64, 256, 1024, 4096, 10_000].map(|vertices| {
            let number = (effort.choose(1000, 20_000) / vertices).clamp(1, 500);
            let inputs = format!("{number} polygons of {vertices} vertices");
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
            charted: 3,
        }
    };
    let far = (0..=12).map(|k| {
        let distance = (0..k).fold(1.0, |power, _| 10.0 * power);
        let number = effort.choose(10, 100);
        let scene = Rc::new(Scene::far_stars(distance, 64, number));
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
        charted: 6,
    };
    vec![
        sweep("star", Scene::stars),
        sweep("comb", Scene::combs),
        far,
    ]
}

fn question(inputs: String, k: f64, scene: &Rc<Scene>) -> Question {
    Question {
        inputs,
        units: scene.polygons.iter().map(Vec::len).sum(),
        cases: vec![
            Case::new(
                "Sutherland–Hodgman",
                k,
                scene,
                |s| s.each(|p| sutherland_hodgman::clip_polygon(&s.window, p)),
                |s, work| s.each(|p| sutherland_hodgman::clip_polygon_counted(&s.window, p, work)),
                |s, outlines| s.verdict(outlines),
            ),
            Case::new(
                "in four passes",
                k,
                scene,
                |s| s.each(|p| sutherland_hodgman::clip_polygon_in_passes(&s.window, p, &mut ())),
                |s, work| {
                    s.each(|p| sutherland_hodgman::clip_polygon_in_passes(&s.window, p, work))
                },
                |s, outlines| s.verdict(outlines),
            ),
            Case::new(
                "pieces",
                k,
                scene,
                |s| s.each(|p| pieces::clip_polygon(&s.window, p)),
                |s, work| s.each(|p| pieces::clip_polygon_counted(&s.window, p, work)),
                |s, outlines| s.verdict_of_pieces(outlines),
            ),
            Case::new(
                "textbook f64",
                k,
                scene,
                |s| s.each(|p| textbook::in_f64(&s.window, p, &mut ())),
                |s, work| s.each(|p| textbook::in_f64(&s.window, p, work)),
                |s, outlines| s.verdict(outlines),
            ),
            Case::new(
                "textbook f32",
                k,
                scene,
                |s| s.each_f32(|p| textbook::in_f32(&s.window, p, &mut ())),
                |s, work| s.each_f32(|p| textbook::in_f32(&s.window, p, work)),
                |s, outlines| s.verdict_f32(outlines),
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

    struct Row {
        sweep: &'static str,
        technique: &'static str,
        k: f64,
        units: usize,
        work: Work,
        deviation: Deviation,
        outside: u64,
    }

    fn judged() -> Vec<Row> {
        let sweeps = sweeps(Effort::Quick);
        let numbers = judge(STUDY.id, &sweeps, &mut |_| ()).unwrap();
        let cases = sweeps.iter().flat_map(|s| {
            s.questions
                .iter()
                .flat_map(|q| q.cases.iter().map(|case| (s.name, q.units, case)))
        });
        cases
            .zip(numbers)
            .map(|((sweep, units, case), (work, verdict))| Row {
                sweep,
                technique: case.technique,
                k: case.setting,
                units,
                work,
                deviation: verdict.deviation,
                outside: verdict.faults[0].1,
            })
            .collect()
    }

    fn is_exact(row: &&Row) -> bool {
        !row.technique.starts_with("textbook")
    }

    #[test]
    fn rounded_once_areas_are_right_and_nothing_is_outside() {
        let rows = judged();
        assert_eq!(rows.len(), (7 + 7 + 13) * 5);
        for row in rows.iter().filter(is_exact) {
            let (sweep, technique, k, deviation) = (row.sweep, row.technique, row.k, row.deviation);
            let context = format!("{sweep} {technique} {k:e}: {deviation:?}");
            assert_eq!((deviation.missing, row.outside), (0, 0), "{context}");
            // A crossing lies on the border, half an ulp of a number below 16 from where it should, 2⁻⁵⁰; that moves the
            // area by half of the way from the vertex before to the one after, below 8. Each edge crosses twice at
            // most. No area is below 1.
            let n = (row.units / deviation.asked) as f64;
            let bound = 2.0 * n * 8.0 * 2f64.powi(-50);
            assert!(deviation.max <= bound, "{context}");
        }
    }

    #[test]
    fn textbook_forms_leave_vertices_outside_and_lose_digits_with_distance() {
        let rows = judged();
        for row in rows.iter().filter(|row| row.technique == "textbook f64") {
            let (sweep, k, deviation) = (row.sweep, row.k, row.deviation);
            let context = format!("{sweep} {k:e}: {deviation:?}");
            assert_eq!(deviation.missing, 0, "{context}");
            if sweep == "far-star" {
                // A crossing errs by some roundings of numbers of 10 k, over spikes' edges as wide as the window.
                assert!(deviation.max <= 1e3 * k * f64::EPSILON, "{context}");
                assert!(deviation.max >= 1e-2 * k * f64::EPSILON, "{context}");
                assert!(row.outside > 0, "{context}");
            }
        }
        for row in rows.iter().filter(|row| row.technique == "textbook f32") {
            // Stored in f32, coordinates are 2⁻²⁵ of themselves off: the same digits, 2²⁹ times earlier.
            assert!(row.deviation.max >= 1e-10, "{} {:e}", row.sweep, row.k);
        }
    }

    #[test]
    fn work_is_counted_where_it_is_done() {
        for row in &judged() {
            let (technique, work, units) = (row.technique, row.work, row.units as u64);
            let context = format!("{} {technique} {:e}: {work}", row.sweep, row.k);
            if technique == "pieces" {
                assert_eq!(work.vertices, units, "{context}");
                // Each edge enters and leaves once at most.
                assert!(work.divisions <= 2 * units, "{context}");
            } else {
                // The first of four passes sees every vertex; none of the others sees more than twice as many.
                assert!(work.vertices >= units, "{context}");
                assert!(work.vertices <= (1 + 2 + 4 + 8) * units, "{context}");
            }
        }
    }

    #[test]
    fn a_comb_falls_into_its_teeth() {
        let scene = Scene::combs(400, 1);
        let comb = &scene.polygons[0];
        let found = pieces::clip_polygon(&scene.window, comb);
        // One in ten stands beside the window on either side.
        assert!((80..100).contains(&found.len()), "{}", found.len());
        assert!(!sutherland_hodgman::clip_polygon(&scene.window, comb).is_empty());
        let star = &Scene::stars(400, 1).polygons[0];
        assert_eq!(pieces::clip_polygon(&scene.window, star).len(), 1);
    }

    #[test]
    fn the_study_says_what_pieces_cost() {
        let report = crate::run::run(&STUDY, Effort::Quick, &mut |_| ()).unwrap();
        let said = &report.advice;
        assert!(
            said.starts_with("To keep areas within 10⁻¹² use "),
            "{said}"
        );
        assert!(said.contains("separate pieces take "), "{said}");
        assert!(said.contains(" where vertices are 10"), "{said}");
        assert!(said.ends_with('.') && !said.contains(". "), "{said}");
        let charts = report
            .charts(&ombra_figures::style::Style::default())
            .unwrap();
        assert_eq!(charts.len(), 9);
    }
}
