use glam::DVec2;

/// A window, its border included.
#[derive(Clone, Copy, Debug)]
struct Window {
    /// (x_min, y_min).
    min: DVec2,
    /// (x_max, y_max), none of them smaller.
    max: DVec2,
}

/// Whether the point lies in the window.
///
/// ```text
/// x_min ≤ x ≤ x_max      y_min ≤ y ≤ y_max
/// ```
///
/// The border is inside, however small the step beyond it is outside. A point with a coordinate that is NaN lies
/// nowhere, so not in a window; nothing lies in a window with such a corner.
///
/// Grafica 3, Clipping.
fn contains(window: Window, p: DVec2) -> bool {
    // TODO: the four inequalities.
    todo!()
}

// ---- tests: leave everything below as it is ----

fn main() {}

#[cfg(test)]
mod clip1_point_in_window {
    use super::{Window, contains};
    use assess::{Inputs, SIDES, point_beside, short_point, show_point};
    use glam::DVec2;

    /// The inequality that keeps a point within each side.
    const INEQUALITIES: [&str; 4] = ["y ≤ y_max", "y_min ≤ y", "x ≤ x_max", "x_min ≤ x"];

    /// Fails with `why` unless the answer is `want`.
    #[track_caller]
    fn check(window: Window, p: DVec2, want: bool, why: &str) {
        let got = contains(window, p);
        let name = |is_in| if is_in { "inside" } else { "outside" };
        let _picture = point_beside(window.min, window.max, p, name(got), name(want));
        assert!(
            got == want,
            "{}, window {} to {}: expected {want}, got {got}: {why}",
            show_point(p),
            short_point(window.min),
            short_point(window.max),
        );
    }

    /// What is wrong far from any border.
    #[track_caller]
    fn plain() {
        let window = Window {
            min: DVec2::new(1.0, 2.0),
            max: DVec2::new(4.0, 9.0),
        };
        let inside = DVec2::new(3.0, 8.0);
        let beyond = [(3.0, 20.0), (3.0, -20.0), (20.0, 8.0), (-20.0, 8.0)].map(DVec2::from);
        let corners = [(20.0, 20.0), (-20.0, 20.0), (20.0, -20.0), (-20.0, -20.0)].map(DVec2::from);
        let is_in = contains(window, inside);
        let beyond_in = beyond.map(|p| contains(window, p));
        let corner_in = corners.map(|p| contains(window, p));
        let outside = || beyond_in.into_iter().chain(corner_in);
        assert!(
            is_in || !outside().all(|is_in| is_in),
            "false inside, true outside: the other way round"
        );
        // (8, 3) is outside; with x and y exchanged it is (3, 8).
        assert!(
            is_in || !contains(window, DVec2::new(inside.y, inside.x)),
            "(3, 8), window (1, 2) to (4, 9), is outside for you, and (8, 3) inside: x and y are exchanged"
        );
        for (name, bounds, exchanged) in [
            ("x", "x_min and x_max", DVec2::X),
            ("y", "y_min and y_max", DVec2::Y),
            ("x and y", "min and max", DVec2::ONE),
        ] {
            let by = exchanged * (window.max - window.min);
            let turned = Window {
                min: window.min + by,
                max: window.max - by,
            };
            assert!(
                is_in || !contains(turned, inside),
                "(3, 8) is outside the window (1, 2) to (4, 9) for you, and inside when {bounds} are exchanged: which \
                 is the smaller {name}?"
            );
        }
        assert!(
            is_in || outside().any(|is_in| is_in),
            "false for a point inside the window, and for eight points around it"
        );
        assert!(
            !is_in || outside().any(|is_in| !is_in),
            "true for a point inside the window, and for eight points around it: each of the four inequalities must hold, \
             `&&`"
        );
        check(window, inside, true, "it lies between all four sides");
        assert!(
            beyond_in != [true; 4] || corner_in != [false; 4],
            "a point beyond one side is inside for you, whichever the side: all four inequalities must hold, `&&`"
        );
        for (i, p) in beyond.into_iter().enumerate() {
            let why = format!("it lies beyond the {} side: {}", SIDES[i], INEQUALITIES[i]);
            check(window, p, false, &why);
        }
        for p in corners {
            check(window, p, false, "it lies beyond two sides");
        }
    }

    fn slide() -> Window {
        Window {
            min: DVec2::ZERO,
            max: DVec2::splat(10.0),
        }
    }

    fn any(inputs: &mut Inputs) -> Window {
        let [min, size] = [(-50, 50), (1, 50)].map(|(low, high)| {
            DVec2::new(
                inputs.integer(low, high).into(),
                inputs.integer(low, high).into(),
            )
        });
        Window {
            min,
            max: min + size,
        }
    }

    /// A point of the window on a side, and the same point `by` beyond it.
    fn on_side(inputs: &mut Inputs, window: Window, side: usize) -> (DVec2, impl Fn(f64) -> DVec2) {
        let share = [(); 2].map(|()| f64::from(inputs.integer(1, 7)) / 8.0);
        let mut p = window.min + DVec2::from(share) * (window.max - window.min);
        let axis = if side < 2 { 1 } else { 0 };
        let (border, out) = match side % 2 {
            0 => (window.max[axis], 1.0),
            _ => (window.min[axis], -1.0),
        };
        p[axis] = border;
        (p, move |by| {
            let mut p = p;
            p[axis] += out * by;
            p
        })
    }

    #[test]
    fn known_points() {
        plain();
        for (x, y, want, why) in [
            (5.0, 5.0, true, "the middle"),
            (12.0, 12.0, false, "x > x_max and y > y_max"),
            (5.0, -0.5, false, "y < y_min"),
            (
                0.0,
                10.0,
                true,
                "x = x_min and y = y_max, and the border is inside",
            ),
            (
                10.0,
                10.0,
                true,
                "x = x_max and y = y_max, and the border is inside",
            ),
            (10.000001, 5.0, false, "x > x_max"),
        ] {
            check(slide(), DVec2::new(x, y), want, why);
        }
    }

    /// Windows of which the plain cases are right.
    #[track_caller]
    fn windows(seed: u64) -> Vec<Window> {
        plain();
        let mut inputs = Inputs::new(seed);
        let any = (0..50).map(|_| any(&mut inputs));
        let windows: Vec<Window> = [slide()].into_iter().chain(any).collect();
        let mut inputs = Inputs::new(seed + 1);
        for &window in &windows {
            let middle = (window.min + window.max) / 2.0;
            check(window, middle, true, "it is the middle of the window");
            for (side, name) in SIDES.into_iter().enumerate() {
                let (_, beyond) = on_side(&mut inputs, window, side);
                let (why_in, why_out) = (
                    format!("it lies 0.1 within the {name} side"),
                    format!("it lies 0.1 beyond the {name} side"),
                );
                check(window, beyond(-0.1), true, &why_in);
                check(window, beyond(0.1), false, &why_out);
            }
        }
        windows
    }

    #[test]
    fn on_the_border() {
        let mut inputs = Inputs::new(31);
        for window in windows(31) {
            for (side, name) in SIDES.into_iter().enumerate() {
                let (p, _) = on_side(&mut inputs, window, side);
                check(
                    window,
                    p,
                    true,
                    &format!("it is on the {name} side, and the border is inside, ≤"),
                );
            }
        }
        let point = Window {
            min: DVec2::ONE,
            max: DVec2::ONE,
        };
        check(
            point,
            DVec2::ONE,
            true,
            "a window of one point holds that point: ≤",
        );
    }

    #[test]
    fn beyond_each_side() {
        let mut inputs = Inputs::new(33);
        for window in windows(33) {
            for (side, name) in SIDES.into_iter().enumerate() {
                let (on, beyond) = on_side(&mut inputs, window, side);
                for by in [1e-3, 1e-6, 1e-9] {
                    check(
                        window,
                        beyond(by),
                        false,
                        &format!(
                            "it lies {by:e} beyond the {name} side, so outside: compare with the side itself, without a \
                             tolerance"
                        ),
                    );
                }
                // The next number: only the coordinate of the side changes.
                let next = DVec2::from([0, 1].map(|i| {
                    if beyond(1.0)[i] > on[i] {
                        on[i].next_up()
                    } else if beyond(1.0)[i] < on[i] {
                        on[i].next_down()
                    } else {
                        on[i]
                    }
                }));
                check(
                    window,
                    next,
                    false,
                    &format!(
                        "it lies beyond the {name} side by the least there is: compare with the side itself, with nothing \
                         that is computed from it"
                    ),
                );
            }
        }
    }

    #[test]
    fn not_a_number_and_infinite() {
        plain();
        let window = slide();
        let (nan, inf) = (f64::NAN, f64::INFINITY);
        for p in [(nan, 5.0), (5.0, nan), (nan, nan)].map(DVec2::from) {
            let why = "every comparison with NaN is false, so ask whether it is in, not whether it is out";
            check(window, p, false, why);
            for strange in [Window { min: p, ..window }, Window { max: p, ..window }] {
                let why = "a corner is NaN, and nothing lies in such a window";
                check(strange, DVec2::splat(5.0), false, why);
            }
        }
        let everywhere = Window {
            min: DVec2::splat(-inf),
            max: DVec2::splat(inf),
        };
        for p in [(inf, 5.0), (5.0, -inf), (f64::MAX, -f64::MAX)].map(DVec2::from) {
            check(window, p, false, "it is beyond the window, however far");
            check(
                everywhere,
                p,
                true,
                "everything but NaN lies in the window −∞…∞, its border included",
            );
        }
    }
}
