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
/// itself, not a rounded one; the other coordinate may be off by a few roundings. `None` where nothing lies inside,
/// however little beyond the window the segment passes; only where that is less than the rounding of its own coordinates
/// may it go either way. No coordinate is larger than 10¹⁵ times the window.
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
    use assess::{Inputs, SIDES, WindowCase, short_point};
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
    #[track_caller]
    fn known(a: (f64, f64), b: (f64, f64), inside: Option<[(f64, f64); 2]>) {
        let case = WindowCase::known(a, b, inside);
        case.check(got(&case));
    }

    #[test]
    fn known_segments() {
        known((-5.0, 5.0), (15.0, 5.0), Some([(0.0, 5.0), (10.0, 5.0)]));
        known((2.0, 3.0), (7.0, 9.0), Some([(2.0, 3.0), (7.0, 9.0)]));
        known((2.0, 3.0), (12.0, 8.0), Some([(2.0, 3.0), (10.0, 7.0)]));
        known(
            (2.0, 14.0),
            (8.0, -4.0),
            Some([(10.0 / 3.0, 10.0), (20.0 / 3.0, 0.0)]),
        );
        known((4.0, 14.0), (14.0, 8.0), None);
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
        // A side on an axis, crossed 5 along it, halfway: nothing is rounded.
        let crossing = |off: f64, side: usize| {
            let place = |along: f64, off: f64| match side {
                0 => DVec2::new(along, off),
                1 => DVec2::new(along, -off),
                2 => DVec2::new(off, along),
                _ => DVec2::new(-off, along),
            };
            let (p, q) = (place(0.0, 0.0), place(10.0, -10.0));
            WindowCase {
                min: p.min(q),
                max: p.max(q),
                a: place(2.0, off),
                b: place(8.0, -off),
                inside: Some((place(5.0, 0.0), place(8.0, -off))),
            }
        };
        for (side, name) in SIDES.into_iter().enumerate() {
            let steep = crossing(3.0, side);
            steep.check(got(&steep));
            for off in [1e-3, 1e-6, 1e-9, 2f64.powi(-41), 2f64.powi(-901)] {
                let case = crossing(off, side);
                let kept = got(&case);
                let _picture = case.picture(kept);
                let (x, across) = if side < 2 { ("y", "x") } else { ("x", "y") };
                // A single point, b: the crossing was not looked for.
                assert!(
                    kept.is_some_and(|(p, q)| p != q),
                    "{case}: it crosses the {name} side where {across} = 5, as it does with {x}_a and {x}_b 6 apart, which \
                     was right; now got {}. Parallel is {x}_a = {x}_b and nothing else",
                    kept.map_or("None".to_owned(), |(p, q)| format!(
                        "{} to {}",
                        short_point(p),
                        short_point(q)
                    )),
                );
                case.assert_right(kept);
            }
        }
    }

    #[test]
    fn any_segment() {
        let mut inputs = Inputs::new(34);
        let all: Vec<(WindowCase, Ends)> = WindowCase::many(400, &mut inputs, WindowCase::crossing)
            .into_iter()
            .map(|case| (case, got(&case)))
            .collect();
        WindowCase::assert_no_pattern(&all);
        for (case, got) in &all {
            case.check(*got);
        }
    }

    #[test]
    fn nothing_inside() {
        let mut inputs = Inputs::new(35);
        for case in WindowCase::many(400, &mut inputs, WindowCase::passing) {
            case.check(got(&case));
        }
    }

    #[test]
    fn a_hair_outside() {
        WindowCase::check_hairs(got);
    }

    #[test]
    fn on_the_sides_themselves() {
        known((-1e15, 5.0), (1e15, 5.0), Some([(0.0, 5.0), (10.0, 5.0)]));
        known((5.0, 1e15), (5.0, -1e15), Some([(5.0, 10.0), (5.0, 0.0)]));
        let mut inputs = Inputs::new(36);
        for case in WindowCase::many(400, &mut inputs, WindowCase::rounded) {
            case.check(got(&case));
        }
    }
}
