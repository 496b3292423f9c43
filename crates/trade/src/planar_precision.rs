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
//! e = ‖P − P*‖∞ / ‖P* − O‖∞        P* the exact shadow,  O the middle of the scene (the origin in the first two)
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
//! - `quotient f64`, `parameter f64`, `cast`: [`cast_by_quotient`], [`cast_by_parameter`] and the correctly rounded
//!   [`cast`](ombra_shadows::planar::cast()) of `ombra-shadows`, which also decide whether there is a shadow.
//! - `directional f64` (`to-infinity`): the light is taken as a direction, w = 0, and w divided out of the matrix, so that
//!   nine multiplications are left. Its error is that of calling a far light infinitely far, O(w).
//! - `moved origin f64` (`far-from-origin`): O is subtracted from every vertex, and the shadow stays relative to O.
//!
//! Counted work is of numbers as the technique has them: a multiplication of `cast` is one of double-doubles, a dozen
//! or more of doubles.
//!
//! [`cast_by_quotient`]: ombra_shadows::planar::cast_by_quotient
//! [`cast_by_parameter`]: ombra_shadows::planar::cast_by_parameter

mod advice;
mod scene;
mod techniques;

use std::rc::Rc;

use crate::advice::power_of_ten;
use crate::deviation::Measure;
use crate::planar_precision::advice::advice;
use crate::planar_precision::scene::Scene;
use crate::planar_precision::techniques::{
    cast, directional_f64, matrix_f32, matrix_f64, moved_origin, parameter_f64, quotient_f64,
};
use crate::study::{Case, Effort, Question, Study, Sweep};

/// The study.
pub const STUDY: Study = Study {
    id: "planar-precision",
    summary: "The shadow of a point on a plane: matrix, quotient, parameter, correctly rounded",
    unit: "vertex",
    errors: &[Measure::Largest("relative error of the shadow")],
    charted_work: &[],
    sweeps,
    advice,
};

fn sweeps(effort: Effort) -> Vec<Sweep> {
    let vertices = effort.choose(200, 2000);
    let powers = |last: i32| (0..=last).map(power);
    let towards_plane = powers(15).map(|k| {
        let scene = Rc::new(Scene::towards_plane(1.0 / k, vertices));
        let inputs = format!("light {} times as far as high", power_of_ten(k));
        question(inputs, &scene, common(k, &scene))
    });
    let to_infinity = powers(15).map(|k| {
        let scene = Rc::new(Scene::to_infinity(1.0 / k, vertices));
        let mut cases = common(k, &scene);
        cases.push(Case::new(
            "directional f64",
            k,
            &scene,
            |s| directional_f64(s, &mut ()),
            directional_f64,
            |s, shadows| s.deviation(shadows),
        ));
        question(
            format!("light (D, {})", power_of_ten(1.0 / k)),
            &scene,
            cases,
        )
    });
    let far = powers(12).map(|k| {
        let scene = Rc::new(Scene::far_from_origin(k, vertices));
        let mut cases = common(k, &scene);
        cases.push(Case::new(
            "moved origin f64",
            k,
            &scene,
            |s| moved_origin(s, &mut ()),
            moved_origin,
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
            charted: 4,
        },
        Sweep {
            name: "to-infinity",
            knob: "1 / w of the light",
            questions: to_infinity.collect(),
            charted: 7,
        },
        Sweep {
            name: "far-from-origin",
            knob: "distance from the origin / size of the scene",
            questions: far.collect(),
            charted: 6,
        },
    ]
}

/// 10ᵏ; exact up to 10²².
fn power(k: i32) -> f64 {
    (0..k).fold(1.0, |power, _| 10.0 * power)
}

fn question(light: String, scene: &Scene, cases: Vec<Case>) -> Question {
    let units = scene.vertices.len();
    Question {
        inputs: format!("{light}; {units} vertices"),
        units,
        cases,
    }
}

/// The techniques that every sweep compares.
fn common(k: f64, scene: &Rc<Scene>) -> Vec<Case> {
    let judge = |s: &Scene, shadows: &Vec<_>| s.deviation(shadows);
    let judge_f32 = |s: &Scene, shadows: &Vec<_>| s.deviation_f32(shadows);
    vec![
        Case::new(
            "matrix f64",
            k,
            scene,
            |s| matrix_f64(s, &mut ()),
            matrix_f64,
            judge,
        ),
        Case::new(
            "matrix f32",
            k,
            scene,
            |s| matrix_f32(s, &mut ()),
            matrix_f32,
            judge_f32,
        ),
        Case::new(
            "quotient f64",
            k,
            scene,
            |s| quotient_f64(s, &mut ()),
            quotient_f64,
            judge,
        ),
        Case::new(
            "parameter f64",
            k,
            scene,
            |s| parameter_f64(s, &mut ()),
            parameter_f64,
            judge,
        ),
        Case::new("cast", k, scene, |s| cast(s, &mut ()), cast, judge),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::deviation::Deviation;
    use crate::run::judge;
    use ombra_figures::style::{Size, Style, Theme};
    use ombra_math::work::Work;

    type Judged = Vec<(&'static str, &'static str, f64, Work, Deviation)>;

    /// Errors and counts of a quick run, without times.
    fn judged() -> Judged {
        let sweeps = sweeps(Effort::Quick);
        let numbers = judge(STUDY.id, &sweeps, &mut |_| ()).unwrap();
        let cases = sweeps.iter().flat_map(|s| {
            s.questions
                .iter()
                .flat_map(|q| &q.cases)
                .map(|c| (s.name, c))
        });
        cases
            .zip(numbers)
            .map(|((sweep, case), (work, verdict))| {
                (sweep, case.technique, case.setting, work, verdict.deviation)
            })
            .collect()
    }

    /// Setting and worst error along a sweep.
    fn along<'a>(
        judged: &'a Judged,
        sweep: &'a str,
        technique: &'a str,
    ) -> impl Iterator<Item = (f64, f64)> + 'a {
        let rows = judged
            .iter()
            .filter(move |row| row.0 == sweep && row.1 == technique);
        rows.map(|row| (row.2, row.4.worst()))
    }

    #[test]
    fn errors_and_counts_are_the_same_on_every_run() {
        // By bits, since the error of no answers is NaN.
        let bits = |judged: &Judged| -> Vec<_> {
            let bits = judged.iter().map(|row| {
                (
                    row.3,
                    row.4.missing,
                    row.4.max.to_bits(),
                    row.4.rms.to_bits(),
                )
            });
            bits.collect()
        };
        let (first, second) = (judged(), judged());
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
        assert!(
            sweeps(Effort::Quick)
                .iter()
                .all(|s| s.charted < s.questions.len())
        );
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
        for (sweep, technique, k, work, _) in &judged() {
            // Where nothing goes missing, every vertex costs the same.
            if *k > 1.0 {
                continue;
            }
            assert_eq!(work.vertices, 200, "{sweep} {technique}");
            if let Some((_, m, a, d)) = expected.iter().find(|e| e.0 == *technique) {
                let counted = (work.multiplications, work.additions, work.divisions);
                assert_eq!(counted, (200 * m, 200 * a, 200 * d), "{sweep} {technique}");
            }
        }
    }

    #[test]
    fn cast_is_the_nearest_double() {
        // Half an ulp of each coordinate is at most 2⁻⁵³ of the largest; far from the origin that is not small.
        let rows = judged();
        for sweep in ["towards-plane", "to-infinity"] {
            for (k, error) in along(&rows, sweep, "cast") {
                assert!(error <= f64::EPSILON / 2.0, "{sweep} {k:e}: {error:e}");
            }
        }
        assert!(
            rows.iter()
                .filter(|row| row.1 == "cast")
                .all(|row| row.4.missing == 0)
        );
    }

    #[test]
    fn plain_doubles_lose_a_digit_for_every_digit_of_height() {
        let rows = judged();
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
        let rows = judged();
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
        let rows = judged();
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
        let rows = judged();
        let find = |technique| along(&rows, "far-from-origin", technique).collect::<Vec<_>>();
        for (k, error) in find("moved origin f64") {
            // Measured: 3 ε.
            assert!(error <= 8.0 * f64::EPSILON, "{k:e}: {error:e}");
        }
        for ((k, matrix), (_, quotient)) in find("matrix f64").into_iter().zip(find("quotient f64"))
        {
            // d multiplies coordinates in the matrix: terms of k² cancel, against terms of k in the quotient.
            if k >= 100.0 {
                assert!(matrix >= 0.1 * k * k * f64::EPSILON, "{k:e}: {matrix:e}");
                assert!(quotient <= 100.0 * k * f64::EPSILON, "{k:e}: {quotient:e}");
            }
        }
    }

    #[test]
    fn a_report_has_one_sentence_and_three_charts_a_sweep() {
        let report = crate::run::run(&STUDY, Effort::Quick, &mut |_| ()).unwrap();
        let said = &report.advice;
        assert!(
            said.starts_with("To keep every shadow within 10⁻⁹ of the exact one, use "),
            "{said}"
        );
        assert!(said.ends_with('.') && !said.contains(". "), "{said}");
        assert!(
            said.contains("cast (") && said.contains("moved origin f64 ("),
            "{said}"
        );
        for size in [Size::FULL_HD, Size::new(1024, 768).unwrap()] {
            for &theme in Theme::ALL {
                let style = Style {
                    size,
                    theme,
                    ..Style::default()
                };
                let charts = report.charts(&style).unwrap();
                assert_eq!(charts.len(), 9);
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
}
