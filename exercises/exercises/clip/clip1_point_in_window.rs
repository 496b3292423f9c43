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
    use assess::{Inputs, show_point};
    use glam::DVec2;

    /// The name of each side, and the place of a side: 0 or 1 for x or y, and whether it is the larger.
    const SIDES: [(&str, usize, bool); 4] = [
        ("upper", 1, true),
        ("lower", 1, false),
        ("right", 0, true),
        ("left", 0, false),
    ];

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

    fn show(window: Window) -> String {
        format!(
            "the window {} to {}",
            show_point(window.min),
            show_point(window.max)
        )
    }

    /// A point of the window, with the value of `side` in its coordinate.
    fn on_side(
        inputs: &mut Inputs,
        window: Window,
        (_, axis, larger): (&str, usize, bool),
    ) -> DVec2 {
        let share = [(); 2].map(|()| f64::from(inputs.integer(1, 7)) / 8.0);
        let mut p = window.min + DVec2::from(share) * (window.max - window.min);
        p[axis] = if larger {
            window.max[axis]
        } else {
            window.min[axis]
        };
        p
    }

    #[test]
    fn known_points() {
        let window = Window {
            min: DVec2::ZERO,
            max: DVec2::splat(10.0),
        };
        for (x, y, want) in [
            (5.0, 5.0, true),
            (0.0, 10.0, true),
            (10.0, 10.0, true),
            (10.000001, 5.0, false),
            (5.0, -0.5, false),
            (12.0, 12.0, false),
        ] {
            let got = contains(window, DVec2::new(x, y));
            assert!(
                got == want,
                "({x}, {y}) in the window 0…10: expected {want}, got {got}"
            );
        }
    }

    #[test]
    fn on_the_border() {
        let mut inputs = Inputs::new(31);
        for side in SIDES.into_iter().cycle().take(200) {
            let window = any(&mut inputs);
            let p = on_side(&mut inputs, window, side);
            assert!(
                contains(window, p),
                "{} is on the {} side of {}: the border is inside, ≤",
                show_point(p),
                side.0,
                show(window),
            );
        }
        let point = Window {
            min: DVec2::ONE,
            max: DVec2::ONE,
        };
        assert!(
            contains(point, DVec2::ONE),
            "a window of one point holds that point: ≤"
        );
    }

    #[test]
    fn beyond_each_side() {
        let mut inputs = Inputs::new(32);
        for side in SIDES.into_iter().cycle().take(200) {
            let window = any(&mut inputs);
            let p = on_side(&mut inputs, window, side);
            let beyond = |by: f64| {
                let mut p = p;
                p[side.1] += if side.2 { by } else { -by };
                p
            };
            let far = beyond(7.0);
            assert!(
                !contains(window, far),
                "{} lies beyond the {} side of {}: all four inequalities are needed",
                show_point(far),
                side.0,
                show(window),
            );
            let mut next = p;
            next[side.1] = if side.2 {
                p[side.1].next_up()
            } else {
                p[side.1].next_down()
            };
            for p in [beyond(1e-3), beyond(1e-6), beyond(1e-9), next] {
                assert!(
                    !contains(window, p),
                    "{} lies just beyond the {} side of {}, so outside: compare with the side itself, without a tolerance",
                    show_point(p),
                    side.0,
                    show(window),
                );
            }
        }
    }

    #[test]
    fn not_a_number_and_infinite() {
        let window = Window {
            min: DVec2::ZERO,
            max: DVec2::splat(10.0),
        };
        let (nan, inf) = (f64::NAN, f64::INFINITY);
        for p in [(nan, 5.0), (5.0, nan), (nan, nan)].map(DVec2::from) {
            assert!(
                !contains(window, p),
                "{} in the window 0…10: every comparison with NaN is false, so ask whether it is in, not whether it is \
                 out",
                show_point(p),
            );
            for strange in [Window { min: p, ..window }, Window { max: p, ..window }] {
                assert!(
                    !contains(strange, DVec2::splat(5.0)),
                    "nothing lies in {}",
                    show(strange)
                );
            }
        }
        let everywhere = Window {
            min: DVec2::splat(-inf),
            max: DVec2::splat(inf),
        };
        for p in [(inf, 5.0), (5.0, -inf), (f64::MAX, -f64::MAX)].map(DVec2::from) {
            assert!(
                !contains(window, p),
                "{} lies outside the window 0…10",
                show_point(p)
            );
            assert!(
                contains(everywhere, p),
                "{} lies in the window −∞…∞",
                show_point(p)
            );
        }
    }
}
