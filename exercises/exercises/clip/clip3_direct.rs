use glam::DVec2;

/// A window, its border included.
#[derive(Clone, Copy, Debug)]
struct Window {
    /// (x_min, y_min).
    min: DVec2,
    /// (x_max, y_max), none of them smaller.
    max: DVec2,
}

/// What of the segment from `a` to `b` lies in the window, by its intersections with the four sides.
///
/// ```text
/// x = x_a + t (x_b − x_a)      y = y_a + t (y_b − y_a)      0 ≤ t ≤ 1
///
/// with the side x = x_min:   t = (x_min − x_a) / (x_b − x_a),   where y_min ≤ y ≤ y_max
/// ```
///
/// and likewise with the other three. First of all, is the segment parallel to the side? Then there is no t. An end
/// that lies in the window is an end of the answer, too. The answer goes the same way as a → b, and where the segment
/// touches the window in one point, both its ends are that point. An end on a side has the coordinate of the side
/// itself, not a rounded one. `None` where nothing lies inside. Coordinates are finite.
///
/// Grafica 3, Clipping di un segmento.
fn clip(window: Window, a: DVec2, b: DVec2) -> Option<(DVec2, DVec2)> {
    // TODO: all points that can be an end of the answer, each with its t; the first and the last one.
    todo!()
}

// ---- tests: leave everything below as it is ----

fn main() {}

#[cfg(test)]
mod clip3_direct {
    use super::{Window, clip};
    use assess::{Inputs, WindowCase, show_point};
    use glam::DVec2;

    type Ends = Option<(DVec2, DVec2)>;

    fn got(case: &WindowCase) -> Ends {
        let window = Window {
            min: case.min,
            max: case.max,
        };
        clip(window, case.a, case.b)
    }

    /// In the window 0…10.
    fn known(a: (f64, f64), b: (f64, f64), inside: Option<[(f64, f64); 2]>) {
        let case = WindowCase {
            min: DVec2::ZERO,
            max: DVec2::splat(10.0),
            a: a.into(),
            b: b.into(),
            inside: inside.map(|[p, q]| (p.into(), q.into())),
        };
        case.assert_right(got(&case));
    }

    #[test]
    fn known_segments() {
        known((-5.0, 5.0), (15.0, 5.0), Some([(0.0, 5.0), (10.0, 5.0)]));
        known(
            (2.0, 14.0),
            (8.0, -4.0),
            Some([(10.0 / 3.0, 10.0), (20.0 / 3.0, 0.0)]),
        );
        known((4.0, 14.0), (14.0, 8.0), None);
        known((2.0, 3.0), (7.0, 9.0), Some([(2.0, 3.0), (7.0, 9.0)]));
        known((3.0, 4.0), (3.0, 4.0), Some([(3.0, 4.0), (3.0, 4.0)]));
        known((11.0, 4.0), (11.0, 4.0), None);
    }

    #[test]
    fn parallel_and_touching() {
        known((4.0, 15.0), (4.0, -5.0), Some([(4.0, 10.0), (4.0, 0.0)]));
        known((-5.0, 11.0), (15.0, 11.0), None);
        // Along a side; up to a side; across a corner; from corner to corner.
        known(
            (-5.0, 10.0),
            (15.0, 10.0),
            Some([(0.0, 10.0), (10.0, 10.0)]),
        );
        known((-5.0, 3.0), (0.0, 3.0), Some([(0.0, 3.0), (0.0, 3.0)]));
        known((0.0, 20.0), (20.0, 0.0), Some([(10.0, 10.0), (10.0, 10.0)]));
        known((-5.0, -5.0), (15.0, 15.0), Some([(0.0, 0.0), (10.0, 10.0)]));
    }

    #[test]
    fn nearly_parallel() {
        // dx is 2⁻⁴⁰ and 2⁻⁹⁰⁰: the segment crosses the left side at y = 5, halfway.
        for tiny in [2f64.powi(-41), 2f64.powi(-901)] {
            let case = WindowCase {
                min: DVec2::ZERO,
                max: DVec2::splat(10.0),
                a: DVec2::new(-tiny, 2.0),
                b: DVec2::new(tiny, 8.0),
                inside: Some((DVec2::new(0.0, 5.0), DVec2::new(tiny, 8.0))),
            };
            assert!(
                case.is_right(got(&case)),
                "{case}: nearly parallel to the left side, and still it crosses it, at (0, 5); got {}: parallel is \
                 x_a = x_b and nothing else",
                got(&case).map_or("nothing".to_owned(), |(p, q)| format!(
                    "{} to {}",
                    show_point(p),
                    show_point(q)
                )),
            );
        }
    }

    #[test]
    fn any_segment() {
        let mut inputs = Inputs::new(34);
        let all: Vec<(WindowCase, Ends)> = (0..400)
            .map(|_| WindowCase::crossing(&mut inputs))
            .map(|case| (case, got(&case)))
            .collect();
        for (side, name) in ["upper", "lower", "right", "left"].into_iter().enumerate() {
            let all_right = |cut| {
                all.iter()
                    .filter(|(case, _)| case.is_cut_at(side) == cut)
                    .all(|(case, got)| case.is_right(*got))
            };
            let any_right = all
                .iter()
                .any(|(case, got)| case.is_cut_at(side) && case.is_right(*got));
            assert!(
                !all_right(false) || any_right,
                "right wherever the {name} side is not crossed, wrong wherever it is: is it one of your four?",
            );
        }
        for (case, got) in &all {
            if let &Some((p, q)) = got {
                // Roundings of numbers up to 200.
                let slack = 64.0 * f64::EPSILON * 200.0;
                let low = case.a.min(case.b) - slack;
                let high = case.a.max(case.b) + slack;
                for p in [p, q] {
                    assert!(
                        p.cmpge(low).all() && p.cmple(high).all(),
                        "{case}: {} lies on the line, but not between a and b: t must be within 0…1",
                        show_point(p),
                    );
                    let in_window =
                        p.cmpge(case.min - slack).all() && p.cmple(case.max + slack).all();
                    let near = |side: DVec2| (p - side).abs().min_element() <= slack;
                    assert!(
                        in_window || !(near(case.min) || near(case.max)),
                        "{case}: {} lies on the line of a side, but beyond the side: where x = x_min, y must be \
                         within y_min…y_max",
                        show_point(p),
                    );
                    assert!(in_window, "{case}: {} is not in the window", show_point(p));
                }
            }
            case.assert_right(*got);
        }
    }

    #[test]
    fn nothing_inside() {
        let mut inputs = Inputs::new(35);
        for _ in 0..400 {
            let case = WindowCase::passing(&mut inputs);
            case.assert_right(got(&case));
        }
    }

    #[test]
    fn on_the_sides_themselves() {
        let mut inputs = Inputs::new(36);
        for _ in 0..400 {
            // No whole numbers, so that something is rounded.
            let mut any = |low, high| DVec2::new(inputs.real(low, high), inputs.real(low, high));
            let min = any(-10.0, 0.0);
            let (max, a, b) = (min + any(5.0, 15.0), any(-30.0, 30.0), any(-30.0, 30.0));
            let Some((p, q)) = clip(Window { min, max }, a, b) else {
                continue;
            };
            for p in [p, q] {
                assert!(
                    p == a
                        || p == b
                        || p.x == min.x
                        || p.x == max.x
                        || p.y == min.y
                        || p.y == max.y,
                    "window {} to {}, segment {} to {}: the new end {} lies beside its side by a rounding: take the \
                     coordinate of the side, and only the other one from t",
                    show_point(min),
                    show_point(max),
                    show_point(a),
                    show_point(b),
                    show_point(p),
                );
            }
        }
        known((-1e15, 5.0), (1e15, 5.0), Some([(0.0, 5.0), (10.0, 5.0)]));
        known((5.0, 1e15), (5.0, -1e15), Some([(5.0, 10.0), (5.0, 0.0)]));
    }
}
