use super::*;
use crate::report::made_up::lines;
use crate::run::judged::{Judged, judged};
use crate::visibility::triangles::LAYERS;

impl Judged {
    /// k and n·m.
    fn primitives_and_pixels(&self) -> (u64, u64) {
        let k = if self.sweep == "pixels" {
            300.0
        } else {
            self.setting
        };
        (k as u64, self.units as u64)
    }
}

/// e in count ∝ settingᵉ, from one row to the next.
fn exponents(rows: &[Judged], sweep: &str, technique: &str, what: Counter) -> Vec<f64> {
    let mine = rows
        .iter()
        .filter(|row| row.sweep == sweep && row.technique == technique);
    let points: Vec<_> = mine
        .map(|row| (row.setting, row.work.get(what) as f64))
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
    for row in &judged(&STUDY) {
        let (k, pixels) = row.primitives_and_pixels();
        let (work, context) = (row.work, row.context());
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
            "image space with boxes" => {
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
    let rows = judged(&STUDY);
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
    for row in &judged(&STUDY) {
        let (k, pixels) = row.primitives_and_pixels();
        let (deviation, context) = (row.deviation, row.context());
        assert_eq!(
            (deviation.asked as u64, deviation.missing),
            (pixels, 0),
            "{context}"
        );
        match row.technique {
            "z-buffer" => {
                // Vertices move by half of 2⁻⁸ pixel a coordinate, so edges by 2⁻⁸ / √2 at most. The centres that
                // near an edge, on both sides: all edges have the length 3 k s, with k s² √3/4 = the area covered.
                let area = LAYERS * pixels as f64;
                let length = 3.0 * (4.0 * area * k as f64 / 3f64.sqrt()).sqrt();
                let centres = length * 2.0 / 256.0 / 2f64.sqrt();
                let bound = centres + 5.0 * centres.sqrt() + 1.0;
                assert!(deviation.wrong as f64 <= bound, "{bound} {context}");
            }
            "sort only" if row.sweep == "primitives" => {
                // Large triangles at all inclinations cross.
                let floor = if k <= 300 { 0.01 } else { 1e-3 };
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
        }]
    },
    ..STUDY
};

#[test]
fn the_study_says_what_to_take() {
    let report = crate::run::run(&SMALL, Effort::Quick, &mut |_| ()).unwrap();
    let said = lines(&report.advice);
    assert!(
        said[0].starts_with("at most 1.0 % of the pixels wrong | "),
        "{said:?}"
    );
    assert!(
        said.iter().any(|line| line.contains(" | sort only | ")),
        "{said:?}"
    );
    let charts = report
        .charts(&ombra_figures::style::Style::default())
        .unwrap();
    let ids: Vec<_> = charts.iter().map(|chart| chart.id.as_str()).collect();
    assert_eq!(
        ids,
        ["work", "time"].map(|kind| format!("trade/visibility/primitives-{kind}"))
    );
}
