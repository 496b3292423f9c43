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
//! - `image space, boxes`: [`cast`](ombra_hsr::image_space::cast), a ray with the primitives about its pixel.
//! - `object space`: every primitive with every other, k (k − 1)/2 pairs; the visible parts are painted. To 3000
//!   primitives.
//! - `painter`: [`order_by_cutting`](ombra_hsr::painter::order_by_cutting), painted back to front.
//! - `sort only`: painted by the distance of the farthest vertex, no pair compared.

mod advice;
mod scene;

use std::rc::Rc;

use ombra_hsr::z_buffer::Cull;
use ombra_math::work::Counter;

use crate::deviation::Measure;
use crate::hidden::{Answer, Scene};
use crate::study::{Case, Effort, Question, Study, Sweep};
use crate::visibility::advice::advice;
use crate::visibility::scene::triangles;

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
            charted: 3,
        },
        Sweep {
            name: "pixels",
            knob: "pixels",
            questions: pictures.into(),
            charted: 4,
        },
    ]
}

fn question(k: usize, side: u32, setting: f64, limits: Limits) -> Question {
    let scene = Rc::new(Scene::new(triangles(k), side));
    let judge = |s: &Scene, answer: &Answer| s.deviation(answer);
    let case =
        |technique, timed, counted| Case::new(technique, setting, &scene, timed, counted, judge);
    let mut cases = vec![case(
        "z-buffer",
        |s| s.z_buffer(Cull::Nothing, &mut ()),
        |s, work| s.z_buffer(Cull::Nothing, work),
    )];
    if k <= limits.rays {
        cases.push(case(
            "image space",
            |s| s.image_space(&mut ()),
            |s, work| s.image_space(work),
        ));
    }
    if k <= limits.sorted {
        cases.push(case(
            "image space, boxes",
            |s| s.image_space_in_boxes(&mut ()),
            |s, work| s.image_space_in_boxes(work),
        ));
    }
    if k <= limits.pairs {
        cases.push(case(
            "object space",
            |s| s.object_space(&mut ()),
            |s, work| s.object_space(work),
        ));
    }
    if k <= limits.sorted {
        cases.push(case(
            "painter",
            |s| s.painter(&mut ()),
            |s, work| s.painter(work),
        ));
    }
    cases.push(case(
        "sort only",
        |s| s.sort_only(&mut ()),
        |s, work| s.sort_only(work),
    ));
    Question {
        inputs: format!("{k} triangles, {side}×{side} pixels"),
        units: scene.pixels(),
        cases,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::deviation::Deviation;
    use crate::run::judge;
    use crate::visibility::scene::LAYERS;
    use ombra_math::work::Work;

    struct Row {
        sweep: &'static str,
        technique: &'static str,
        k: u64,
        pixels: u64,
        work: Work,
        deviation: Deviation,
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
                k: if sweep == "pixels" {
                    300
                } else {
                    case.setting as u64
                },
                pixels: units as u64,
                work,
                deviation: verdict.deviation,
            })
            .collect()
    }

    /// e in count ∝ settingᵉ, from one row to the next.
    fn exponents(rows: &[Row], sweep: &str, technique: &str, what: Counter) -> Vec<f64> {
        let mine = rows
            .iter()
            .filter(|row| row.sweep == sweep && row.technique == technique);
        let setting = |row: &Row| if sweep == "pixels" { row.pixels } else { row.k } as f64;
        let points: Vec<_> = mine
            .map(|row| (setting(row), row.work.get(what) as f64))
            .collect();
        let pairs = points.iter().zip(points.iter().skip(1));
        let found: Vec<f64> = pairs
            .map(|(a, b)| (b.1 / a.1).ln() / (b.0 / a.0).ln())
            .collect();
        assert!(found.len() >= 2);
        found
    }

    #[test]
    fn work_is_what_the_lecture_says() {
        for row in &judged() {
            let (k, pixels, work) = (row.k, row.pixels, row.work);
            let context = format!("{} {} {k} {pixels}: {work}", row.sweep, row.technique);
            let expected = LAYERS * pixels as f64;
            // Centres in triangles at random places: as many as their area says, with a spread of √n at most.
            let covered = (work.fragments as f64 - expected).abs() <= 5.0 * expected.sqrt();
            match row.technique {
                "z-buffer" => {
                    assert_eq!(work.depth_tests, work.fragments, "{context}");
                    assert_eq!(work.vertices, 3 * k, "{context}");
                    assert!(covered, "{context}");
                }
                "image space" => {
                    assert_eq!(work.rays, pixels, "{context}");
                    assert_eq!(work.intersections, pixels * k, "{context}");
                }
                "image space, boxes" => {
                    assert_eq!(work.rays, pixels, "{context}");
                    assert!(work.intersections < pixels * k, "{context}");
                }
                "object space" => {
                    assert_eq!(work.pairs, k * (k - 1) / 2, "{context}");
                    // What is visible covers no pixel twice.
                    assert!(work.fragments <= pixels, "{context}");
                }
                "painter" => assert!(work.pairs > 0 && covered, "{context}"),
                _ => assert!(work.pairs == 0 && covered, "{context}"),
            }
        }
    }

    #[test]
    fn growth_with_primitives_and_with_pixels() {
        let rows = judged();
        let growth = |sweep, technique, what| exponents(&rows, sweep, technique, what);
        let within = |found: Vec<f64>, low: f64, high: f64| {
            assert!(
                found.iter().all(|e| (low..=high).contains(e)),
                "{found:?} not in {low} to {high}"
            );
        };
        // k (k − 1)/2 from 10 to 30: ln(435/45) / ln 3 = 2.065; it falls to 2.
        let pairs = growth("primitives", "object space", Counter::Pairs);
        within(pairs, 2.0, 2.066);
        within(
            growth("primitives", "image space", Counter::Intersections),
            1.0 - 1e-9,
            1.0 + 1e-9,
        );
        // Five spreads of √8192, over a factor of 3 at least: ln(1 + 2 · 5/√8192) / ln 3.
        within(
            growth("primitives", "z-buffer", Counter::DepthTests),
            -0.1,
            0.1,
        );
        // From 100 primitives on hardly any are cut: those that overlap in the picture, a few each.
        let painter = growth("primitives", "painter", Counter::Pairs);
        within(painter[2..].to_vec(), 0.0, 1.0);

        within(growth("pixels", "object space", Counter::Pairs), 0.0, 0.0);
        within(growth("pixels", "painter", Counter::Pairs), 0.0, 0.0);
        within(
            growth("pixels", "image space", Counter::Intersections),
            1.0 - 1e-9,
            1.0 + 1e-9,
        );
        // From 4 × 4 pixels on: ln(1 + 2 · 5/√32) / ln 4 = 0.73.
        within(
            growth("pixels", "z-buffer", Counter::DepthTests),
            0.27,
            1.73,
        );
    }

    #[test]
    fn only_snapping_and_a_mere_sort_are_wrong_anywhere() {
        for row in &judged() {
            let (k, deviation) = (row.k as f64, row.deviation);
            let context = format!("{} {} {k}: {deviation:?}", row.sweep, row.technique);
            assert_eq!(
                (deviation.asked as u64, deviation.missing),
                (row.pixels, 0),
                "{context}"
            );
            match row.technique {
                "z-buffer" => {
                    // Vertices move by half of 2⁻⁸ pixel a coordinate, so edges by 2⁻⁸ / √2 at most. The centres that
                    // near an edge, on both sides: all edges have the length 3 k s, with k s² √3/4 = the area covered.
                    let area = LAYERS * row.pixels as f64;
                    let length = 3.0 * (4.0 * area * k / 3f64.sqrt()).sqrt();
                    let centres = length * 2.0 / 256.0 / 2f64.sqrt();
                    let bound = centres + 5.0 * centres.sqrt() + 1.0;
                    assert!(deviation.wrong as f64 <= bound, "{bound} {context}");
                }
                "sort only" if row.sweep == "primitives" => {
                    // Large triangles at all inclinations cross.
                    let floor = if k <= 300.0 { 0.01 } else { 1e-3 };
                    assert!(deviation.wrong_share() > floor, "{context}");
                }
                "sort only" => {}
                // No centre of these is within rounding of an edge.
                _ => assert_eq!(deviation.wrong, 0, "{context}"),
            }
        }
    }

    const SMALL: Study = Study {
        sweeps: |_| {
            let limits = Limits {
                rays: 100,
                pairs: 100,
                sorted: 100,
            };
            let questions = [10, 30, 100].map(|k| question(k, 24, k as f64, limits));
            vec![Sweep {
                name: "primitives",
                knob: "primitives",
                questions: questions.into(),
                charted: 1,
            }]
        },
        ..STUDY
    };

    #[test]
    fn the_study_says_how_work_grows() {
        let report = crate::run::run(&SMALL, Effort::Quick, &mut |_| ()).unwrap();
        let said = &report.advice;
        assert!(
            said.starts_with("For at most 0.10 % of wrong pixels use "),
            "{said}"
        );
        for part in [
            "from 10 to 100 primitives work grows: depth tests of z-buffer ",
            "intersections of image space 10 times",
            "pairs of object space 110 times",
        ] {
            assert!(said.contains(part), "{said}");
        }
        assert!(said.ends_with("% wrong.") && !said.contains(". "), "{said}");
        let charts = report
            .charts(&ombra_figures::style::Style::default())
            .unwrap();
        let ids: Vec<_> = charts.iter().map(|chart| chart.id.as_str()).collect();
        assert_eq!(
            ids,
            ["error", "time", "work", "cost"]
                .map(|kind| format!("trade/visibility/primitives-{kind}"))
        );
    }
}
