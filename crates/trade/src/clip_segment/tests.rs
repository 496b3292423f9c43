use super::*;
use crate::report::made_up::lines;
use crate::run::judged::judged;

const EXACT: [&str; 4] = ["direct", "Cohen–Sutherland", "Liang–Barsky", "Cyrus–Beck"];

#[test]
fn errors_and_counts() {
    let rows = judged(&STUDY);
    assert_eq!(rows.len(), (11 + 13) * 6);
    for row in &rows {
        let (k, deviation, context) = (row.setting, row.deviation, row.context());
        assert_eq!(deviation.asked, 400, "{context}");
        if EXACT.contains(&row.technique) {
            assert_eq!(deviation.missing, 0, "{context}");
            // Half an ulp of coordinates below 16, over a window of 10.2.
            assert!(deviation.max <= 2f64.powi(-50) / 10.0, "{context}");
            // Nothing crosses the border where all ends are inside.
            assert!(row.work.divisions <= 4 * 400, "{context}");
        } else {
            // A cut errs by a few roundings of the ends; the second cut of a flat segment by its slope times that.
            assert!(
                deviation.max <= 1e3 * k.max(1.0) * f64::EPSILON,
                "{context}"
            );
        }
    }
}

#[test]
fn who_is_outside_costs_no_intersection() {
    let rows = judged(&STUDY);
    let divisions = |technique, k| {
        let row = rows
            .iter()
            .find(|r| (r.sweep, r.technique, r.setting) == ("outside", technique, k));
        row.unwrap().work.divisions
    };
    for technique in EXACT {
        let (all_in, all_out) = (divisions(technique, 0.0), divisions(technique, 1.0));
        assert!(
            all_in > 0 && all_out < all_in,
            "{technique}: {all_in}, {all_out}"
        );
    }
    // Of what is outside, Liang–Barsky intersects nothing; the direct method tries every side that is crossed.
    assert_eq!(divisions("Liang–Barsky", 1.0), 0);
    for k in [0.0, 0.5, 1.0] {
        assert!(divisions("direct", k) > divisions("Liang–Barsky", k));
    }
}

#[test]
fn textbook_forms_lose_a_digit_for_every_digit_of_distance() {
    let rows = judged(&STUDY);
    for row in rows.iter().filter(|row| row.sweep == "far-ends") {
        let (k, deviation, context) = (row.setting, row.deviation, row.context());
        if row.technique.starts_with("textbook") && (1e2..=1e10).contains(&k) {
            // Ends of k are rounded to k ε, so differences of them are too.
            assert!(deviation.max >= 0.05 * k * f64::EPSILON, "{context}");
        }
    }
}

#[test]
fn the_study_says_what_exactness_costs() {
    let report = crate::run::run(&STUDY, Effort::Quick, &mut |_| ()).unwrap();
    let said = lines(&report.advice);
    assert!(said[0].starts_with("ends rounded once | "), "{said:?}");
    assert!(
        said.iter().any(|line| line.contains("textbook L–B")),
        "{said:?}"
    );
    let charts = report
        .charts(&ombra_figures::style::Style::default())
        .unwrap();
    assert_eq!(charts.len(), 3);
}
