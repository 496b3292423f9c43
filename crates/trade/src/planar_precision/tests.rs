use super::*;
use crate::report::made_up::lines;
use crate::run::judged::{Judged, judged};
use ombra_figures::style::{Size, Style, Theme};

/// Setting and worst error along a sweep.
fn along<'a>(
    judged: &'a [Judged],
    sweep: &'a str,
    technique: &'a str,
) -> impl Iterator<Item = (f64, f64)> + 'a {
    let rows = judged
        .iter()
        .filter(move |row| row.sweep == sweep && row.technique == technique);
    rows.map(|row| (row.setting, row.deviation.worst()))
}

#[test]
fn errors_and_counts_are_the_same_on_every_run() {
    // By bits, since the error of no answers is NaN.
    let bits = |judged: &[Judged]| -> Vec<_> {
        let bits = judged.iter().map(|row| {
            (
                row.work,
                row.deviation.missing,
                row.deviation.max.to_bits(),
                row.deviation.rms.to_bits(),
            )
        });
        bits.collect()
    };
    let (first, second) = (judged(&STUDY), judged(&STUDY));
    assert!(bits(&first) == bits(&second));
    assert_eq!(first.len(), 16 * 5 + 16 * 6 + 13 * 6);
}

#[test]
fn every_question_is_asked_in_full() {
    for effort in [Effort::Quick, Effort::Full] {
        for question in sweeps(effort).iter().flat_map(|s| &s.questions) {
            assert_eq!(
                question.units,
                effort.choose(200, 2000),
                "{}",
                question.inputs
            );
            assert!(question.cases.len() >= 5);
        }
    }
}

#[test]
fn work_is_counted_where_it_is_done() {
    // Rows times three; three quotients. For the forms of ombra-shadows: their formulas.
    let expected = [
        ("matrix f64", 12, 12, 3),
        ("matrix f32", 12, 12, 3),
        ("quotient f64", 14, 10, 3),
        ("parameter f64", 11, 13, 4),
        ("directional f64", 9, 9, 0),
        ("moved origin f64", 14, 13, 3),
    ];
    for row in &judged(&STUDY) {
        // Where nothing goes missing, every vertex costs the same.
        if row.setting > 1.0 {
            continue;
        }
        let (work, context) = (row.work, row.context());
        assert_eq!(work.vertices, 200, "{context}");
        if let Some((_, m, a, d)) = expected.iter().find(|e| e.0 == row.technique) {
            let counted = (work.multiplications, work.additions, work.divisions);
            assert_eq!(counted, (200 * m, 200 * a, 200 * d), "{context}");
        }
    }
}

#[test]
fn cast_is_the_nearest_double() {
    // Half an ulp of each coordinate is at most 2⁻⁵³ of the largest; far from the origin that is not small.
    let rows = judged(&STUDY);
    for sweep in ["towards-plane", "to-infinity"] {
        for (k, error) in along(&rows, sweep, "cast") {
            assert!(error <= f64::EPSILON / 2.0, "{sweep} {k:e}: {error:e}");
        }
    }
    assert!(
        rows.iter()
            .filter(|row| row.technique == "cast")
            .all(|row| row.deviation.missing == 0)
    );
}

#[test]
fn plain_doubles_lose_a_digit_for_every_digit_of_height() {
    let rows = judged(&STUDY);
    for technique in ["matrix f64", "quotient f64", "parameter f64"] {
        for (k, error) in along(&rows, "towards-plane", technique).filter(|&(k, _)| k <= 1e14) {
            // s and t are sums of four terms of up to 8, rounded to ε/2 each, and k times smaller than the
            // distance of 10; the shadow moves by s/(s − t) ≤ 10 times as much.
            assert!(
                error <= 100.0 * k * f64::EPSILON,
                "{technique} {k:e}: {error:e}"
            );
            assert!(
                error >= 0.1 * k * f64::EPSILON,
                "{technique} {k:e}: {error:e}"
            );
        }
    }
}

#[test]
fn a_far_light_is_a_direction_but_for_the_order_of_w() {
    let rows = judged(&STUDY);
    let errors: Vec<_> = along(&rows, "to-infinity", "directional f64").collect();
    for (near, far) in errors.iter().zip(errors.iter().skip(1)) {
        // First order: a tenth of w is a tenth of the error, to a share of w itself; until rounding is as large.
        if (100.0..=1e12).contains(&near.0) {
            let order = near.1 / far.1;
            assert!(
                (order / 10.0 - 1.0).abs() <= 10.0 / near.0 + 1e-2,
                "{near:?} {far:?}"
            );
        }
    }
}

#[test]
fn a_light_made_a_place_loses_what_its_distance_has_and_the_others_nothing() {
    let rows = judged(&STUDY);
    for technique in ["matrix f64", "quotient f64"] {
        for (k, error) in along(&rows, "to-infinity", technique) {
            // Measured: 4 ε over the whole sweep.
            assert!(error <= 8.0 * f64::EPSILON, "{technique} {k:e}: {error:e}");
        }
    }
    for (k, error) in along(&rows, "to-infinity", "parameter f64") {
        assert!(error >= 0.5 * k * f64::EPSILON, "{k:e}: {error:e}");
    }
}

#[test]
fn far_from_the_origin_the_matrix_loses_twice_the_digits() {
    let rows = judged(&STUDY);
    let find = |technique| along(&rows, "far-from-origin", technique).collect::<Vec<_>>();
    for (k, error) in find("moved origin f64") {
        // Measured: 3 ε.
        assert!(error <= 8.0 * f64::EPSILON, "{k:e}: {error:e}");
    }
    for ((k, matrix), (_, quotient)) in find("matrix f64").into_iter().zip(find("quotient f64")) {
        // d multiplies coordinates in the matrix: terms of k² cancel, against terms of k in the quotient.
        if k >= 100.0 {
            assert!(matrix >= 0.1 * k * k * f64::EPSILON, "{k:e}: {matrix:e}");
            assert!(quotient <= 100.0 * k * f64::EPSILON, "{k:e}: {quotient:e}");
        }
    }
}

#[test]
fn a_report_has_advice_and_the_charts_of_the_notes() {
    let report = crate::run::run(&STUDY, Effort::Quick, &mut |_| ()).unwrap();
    let said = lines(&report.advice);
    assert!(
        said[0].starts_with("low light, shadow to 10⁻⁹ | "),
        "{said:?}"
    );
    for technique in ["cast", "moved origin f64"] {
        assert!(said.iter().any(|line| line.contains(technique)), "{said:?}");
    }
    for size in [Size::FULL_HD, Size::new(1024, 768).unwrap()] {
        for &theme in Theme::ALL {
            let style = Style {
                size,
                theme,
                ..Style::default()
            };
            let charts = report.charts(&style).unwrap();
            assert_eq!(charts.len(), 5);
            for chart in &charts {
                for technique in report.sweeps[0].techniques() {
                    assert!(
                        chart.labels.iter().any(|label| label.text == technique),
                        "{} {technique}",
                        chart.id
                    );
                }
            }
        }
    }
}
