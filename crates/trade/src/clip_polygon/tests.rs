use super::*;
use crate::report::made_up::lines;
use crate::run::judged::{Judged, judged};

fn is_exact(row: &&Judged) -> bool {
    !row.technique.starts_with("textbook")
}

#[test]
fn rounded_once_areas_are_right_and_nothing_is_outside() {
    let rows = judged(&STUDY);
    assert_eq!(rows.len(), (7 + 7 + 13) * 5);
    for row in rows.iter().filter(is_exact) {
        let (deviation, context) = (row.deviation, row.context());
        assert_eq!(deviation.missing, 0, "{context}");
        assert_eq!(row.faults, [("vertices outside", 0)], "{context}");
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
    let rows = judged(&STUDY);
    for row in rows.iter().filter(|row| row.technique == "textbook f64") {
        let (k, deviation, context) = (row.setting, row.deviation, row.context());
        assert_eq!(deviation.missing, 0, "{context}");
        if row.sweep == "far-star" {
            // A crossing errs by some roundings of numbers of 10 k, over spikes' edges as wide as the window.
            assert!(deviation.max <= 1e3 * k * f64::EPSILON, "{context}");
            assert!(deviation.max >= 1e-2 * k * f64::EPSILON, "{context}");
            assert!(row.faults[0].1 > 0, "{context}");
        }
    }
    for row in rows.iter().filter(|row| row.technique == "textbook f32") {
        // Stored in f32, coordinates are 2⁻²⁵ of themselves off: the same digits, 2²⁹ times earlier.
        assert!(row.deviation.max >= 1e-10, "{}", row.context());
    }
}

#[test]
fn work_is_counted_where_it_is_done() {
    for row in &judged(&STUDY) {
        let (work, units, context) = (row.work, row.units as u64, row.context());
        if row.technique == "pieces" {
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
    let scene = WindowAndPolygons::combs(400, 1);
    let comb = &scene.polygons[0];
    let found = pieces::clip_polygon(&scene.window, comb);
    // One in ten stands beside the window on either side.
    assert!((80..100).contains(&found.len()), "{}", found.len());
    assert!(!sutherland_hodgman::clip_polygon(&scene.window, comb).is_empty());
    let star = &WindowAndPolygons::stars(400, 1).polygons[0];
    assert_eq!(pieces::clip_polygon(&scene.window, star).len(), 1);
}

#[test]
fn the_study_says_what_pieces_cost() {
    let report = crate::run::run(&STUDY, Effort::Quick, &mut |_| ()).unwrap();
    let said = lines(&report.advice);
    // Only what is made of exact clipping leaves nothing outside and no error at any distance.
    let start = "areas to 10⁻¹², every vertex in the window | Sutherland–Hodgman | to 10¹² window sizes away | 1.0 | ";
    assert!(said[0].starts_with(start), "{said:?}");
    for technique in ["pieces", "textbook f64", "textbook f32"] {
        assert!(said.iter().any(|line| line.contains(technique)), "{said:?}");
    }
    let charts = report
        .charts(&ombra_figures::style::Style::default())
        .unwrap();
    assert_eq!(charts.len(), 3);
}
