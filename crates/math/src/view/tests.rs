use super::*;
use core::f64::consts::FRAC_PI_2;
use ombra_oracle::Exact;
use ombra_oracle::vector::{cross, dot, exact, minus};
use proptest::num::f64::ANY;
use proptest::prelude::*;

const EPS: f64 = f64::EPSILON;

fn corners() -> impl Iterator<Item = DVec3> {
    (0..8).map(|i| DVec3::new((i & 1).into(), (i >> 1 & 1).into(), (i >> 2).into()) * 2.0 - 1.0)
}

/// The slide's matrix for l = −1, r = 3, b = −2, t = 1, n = 2, f = 6, worked by hand.
#[test]
fn the_lectures_frustum() {
    let m = frustum(-1.0, 3.0, -2.0, 1.0, 2.0, 6.0).unwrap();
    assert_eq!(m.row(0), DVec4::new(1.0, 0.0, 0.5, 0.0));
    assert_eq!(m.row(1), DVec4::new(0.0, 4.0 / 3.0, -1.0 / 3.0, 0.0));
    assert_eq!(m.row(2), DVec4::new(0.0, 0.0, -2.0, -6.0));
    assert_eq!(m.row(3), DVec4::new(0.0, 0.0, -1.0, 0.0));
    let m = frustum_infinite(-1.0, 3.0, -2.0, 1.0, 2.0).unwrap();
    assert_eq!(m.row(2), DVec4::new(0.0, 0.0, -1.0, -4.0));
}

#[test]
fn corners_go_to_corners() {
    let (l, r, b, t, n, f) = (-0.3, 1.1, -0.7, 0.2, 0.4, 90.0);
    let pick = |low: f64, high: f64, side: f64| if side < 0.0 { low } else { high };
    for corner in corners() {
        let depth = pick(n, f, corner.z);
        let on_near = DVec3::new(pick(l, r, corner.x), pick(b, t, corner.y), -n);
        let m = frustum(l, r, b, t, n, f).unwrap();
        let p = m.project_point3(on_near * (depth / n));
        // Entries up to (r+l)/(r−l) < 1, 2f/(f−n) < 3: a dozen roundings at scale 4.
        assert!(
            (p - corner).abs().max_element() <= 24.0 * EPS,
            "{corner} {p}"
        );
        let m = orthographic(l, r, b, t, n, f).unwrap();
        let p = m.transform_point3(on_near.with_z(-depth));
        assert!(
            (p - corner).abs().max_element() <= 12.0 * EPS,
            "{corner} {p}"
        );
    }
}

#[test]
fn the_infinite_frustum_is_the_limit() {
    let n = 0.5;
    let limit = frustum_infinite(-1.0, 2.0, -1.0, 1.0, n).unwrap();
    for f in [1e2, 1e4, 1e6] {
        let m = frustum(-1.0, 2.0, -1.0, 1.0, n, f).unwrap();
        let off = limit - m;
        // 2n/(f−n) and 2n²/(f−n): times f they tend to 2n and 2n², with an error of n/f.
        assert!(
            (off.z_axis.z * f / (2.0 * n) - 1.0).abs() <= 1.1 * n / f + EPS * f,
            "{f}"
        );
        assert!(
            (off.w_axis.z * f / (2.0 * n * n) - 1.0).abs() <= 1.1 * n / f + 4.0 * EPS * f,
            "{f}"
        );
        assert_eq!((off.x_axis, off.y_axis), (DVec4::ZERO, DVec4::ZERO));
    }
}

#[test]
fn infinitely_far_vertices_are_not_cut() {
    for d in [5e-324, 1.0, 3.7, 1e300] {
        for n in [1e-300, 0.1, 1e300] {
            let m = frustum_infinite(-n, n, -2.0 * n, n, n).unwrap();
            let p = m * DVec4::new(0.0, 0.0, -d, 0.0);
            assert_eq!((p.z, p.w), (d, d));
            assert!(p.x.abs() <= p.w && p.y.abs() <= p.w);
            // With a far plane it is cut: z > w.
            let m = frustum(-n, n, -2.0 * n, n, n, 8.0 * n).unwrap();
            let p = m * DVec4::new(0.0, 0.0, -d, 0.0);
            assert!(p.z > p.w || d == 5e-324);
        }
    }
    // Sides: an eye left of its whole window does not see straight ahead.
    let p = frustum_infinite(1.0, 2.0, -1.0, 1.0, 1.0).unwrap() * DVec4::new(0.0, 0.0, -1.0, 0.0);
    assert!(p.x < -p.w);
}

#[test]
fn perspective_is_a_symmetric_frustum() {
    for (fov_y, aspect, n, f) in [
        (FRAC_PI_2, 1.5, 0.1, 100.0),
        (0.3, 0.5, 2.0, 3.0),
        (3.0, 1.0, 1.0, 1e9),
    ] {
        let t = n * libm::tan(0.5 * fov_y);
        let expected = frustum(-aspect * t, aspect * t, -t, t, n, f).unwrap();
        let m = perspective(fov_y, aspect, n, f).unwrap();
        for (x, y) in m.to_cols_array().into_iter().zip(expected.to_cols_array()) {
            assert!((x - y).abs() <= 4.0 * EPS * y.abs(), "{x} {y}");
        }
    }
}

#[test]
fn pixels() {
    let v = Viewport {
        width: 8,
        height: 4,
    };
    assert_eq!(v.to_pixel(DVec3::new(-1.0, 1.0, -1.0)), DVec3::ZERO);
    assert_eq!(
        v.to_pixel(DVec3::new(1.0, -1.0, 1.0)),
        DVec3::new(8.0, 4.0, 1.0)
    );
    // The centre of pixel (5, 1).
    assert_eq!(
        v.to_pixel(DVec3::new(0.375, 0.25, 0.0)),
        DVec3::new(5.5, 1.5, 0.5)
    );
    assert!(v.to_pixel(DVec3::splat(f64::NAN)).is_nan());
    assert_eq!(
        Viewport {
            width: 0,
            height: 0
        }
        .to_pixel(DVec3::ONE),
        DVec3::new(0.0, 0.0, 1.0)
    );
}

#[test]
fn a_known_view() {
    // Eye on the diagonal, worked by hand: s = (1, 0, −1)/√2, u = (−1, 2, −1)/√6, f = −(1, 1, 1)/√3.
    let m = look_at(DVec3::splat(2.0), DVec3::ZERO, DVec3::Y * 7.0).unwrap();
    let expected = [
        DVec3::new(1.0, 0.0, -1.0) / 2f64.sqrt(),
        DVec3::new(-1.0, 2.0, -1.0) / 6f64.sqrt(),
        DVec3::ONE / 3f64.sqrt(),
    ];
    for (i, axis) in expected.into_iter().enumerate() {
        assert!(
            (m.row(i).truncate() - axis).abs().max_element() <= 4.0 * EPS,
            "{i}"
        );
    }
    assert!(
        (m.w_axis - DVec4::new(0.0, 0.0, -12f64.sqrt(), 1.0))
            .abs()
            .max_element()
            <= 8.0 * EPS
    );
}

#[test]
fn degenerate() {
    use ViewError as E;
    let (inf, nan, max, tiny) = (f64::INFINITY, f64::NAN, f64::MAX, 5e-324);
    let up = DVec3::splat(0.3);
    let cases = [
        (
            "one place",
            look_at(DVec3::ONE, DVec3::ONE, DVec3::Y),
            E::NoDirection { eye: DVec3::ONE },
        ),
        (
            "parallel",
            look_at(DVec3::splat(0.1), DVec3::splat(0.7), up),
            E::UpAlongView { up },
        ),
        (
            "opposite",
            look_at(DVec3::splat(max), DVec3::splat(-max), up),
            E::UpAlongView { up },
        ),
        (
            "no up",
            look_at(DVec3::X, DVec3::Y, DVec3::ZERO),
            E::UpAlongView { up: DVec3::ZERO },
        ),
        (
            "infinite eye",
            look_at(DVec3::X * inf, DVec3::Y, up),
            E::NotFinite {
                what: "eye",
                value: inf,
            },
        ),
        (
            "far away",
            look_at(DVec3::splat(max), DVec3::ZERO, DVec3::Y),
            E::TooLarge {
                what: "eye coordinates",
            },
        ),
        (
            "no width",
            frustum(1.0, 1.0, 0.0, 1.0, 1.0, 2.0),
            E::NoExtent {
                what: "left and right",
                value: 1.0,
            },
        ),
        (
            "no height",
            frustum_infinite(0.0, 1.0, -0.0, 0.0, 1.0),
            E::NoExtent {
                what: "bottom and top",
                value: -0.0,
            },
        ),
        (
            "no depth",
            perspective(1.0, 1.0, 2.0, 2.0),
            E::NoExtent {
                what: "near and far",
                value: 2.0,
            },
        ),
        (
            "near 0",
            frustum_infinite(0.0, 1.0, 0.0, 1.0, 0.0),
            E::NotPositive {
                what: "near",
                value: 0.0,
            },
        ),
        (
            "far < 0",
            frustum(0.0, 1.0, 0.0, 1.0, 1.0, -1.0),
            E::NotPositive {
                what: "far",
                value: -1.0,
            },
        ),
        (
            "far at infinity",
            perspective(1.0, 1.0, 1.0, inf),
            E::NotFinite {
                what: "far",
                value: inf,
            },
        ),
        (
            "degrees",
            perspective(45.0, 1.0, 1.0, 2.0),
            E::FieldOfView { fov_y: 45.0 },
        ),
        (
            "aspect",
            perspective(1.0, 0.0, 1.0, 2.0),
            E::NotPositive {
                what: "aspect",
                value: 0.0,
            },
        ),
        (
            "2n",
            frustum_infinite(-1.0, 1.0, -1.0, 1.0, max),
            E::TooLarge {
                what: "near and the window",
            },
        ),
        (
            "narrow",
            orthographic(0.0, tiny, 0.0, 1.0, 0.0, 1.0),
            E::TooLarge {
                what: "the sides of the box",
            },
        ),
    ];
    for (name, found, expected) in cases {
        assert_eq!(found, Err(expected), "{name}");
        assert!(!expected.to_string().is_empty());
    }
    assert!(matches!(
        look_at(DVec3::splat(nan), DVec3::ZERO, up),
        Err(E::NotFinite { .. })
    ));
    // Large windows and a box over the whole range are fine.
    let m = orthographic(-max, max, -max, max, -max, max).unwrap();
    // 1/max is subnormal and has two bits less.
    let p = m.transform_point3(DVec3::new(max, -max, -max));
    assert!(
        (p - DVec3::new(1.0, -1.0, 1.0)).abs().max_element() <= 4.0 * EPS,
        "{p}"
    );
    assert_eq!(
        frustum_infinite(-max, max, -max, max, 5e307)
            .unwrap()
            .x_axis
            .x,
        5e307 / max
    );
    // Up a hair beside the direction of view still has a side.
    let beside = DVec3::new(0.3, 0.3, 0.3 + EPS);
    assert!(look_at(DVec3::splat(0.1), DVec3::splat(0.7), beside).is_ok());
}

fn point() -> impl Strategy<Value = DVec3> {
    [
        (-1.0..1.0f64, -100i32..100),
        (-1.0..1.0, -100i32..100),
        (-1.0..1.0, -100i32..100),
    ]
    .prop_map(|p| DVec3::from_array(p.map(|(m, e)| libm::scalbn(m, e))))
}

fn cube() -> impl Strategy<Value = DVec3> {
    [-1.0..1.0, -1.0..1.0, -1.0..1.0].prop_map(DVec3::from_array)
}

/// Each entry without rounding, its formula as the slide has it.
mod entries {
    use super::*;
    use crate::to_300_bits::{q, quotient, sine_and_cosine};

    /// The error of `found` in ε of the exact entry, what a subnormal's last place explains taken off; `None` where
    /// the entry is beyond the largest double.
    fn error(found: f64, right: &Exact) -> Option<f64> {
        if right.abs() > f64::MAX {
            return None;
        }
        let off = (q(found) - right).abs() - Exact::power_of_two(-1075);
        if off <= 0 {
            return Some(0.0);
        }
        Some(off.ratio(&right.abs()) / EPS)
    }

    fn double() -> impl Strategy<Value = f64> {
        prop_oneof![
            (-2.0..2.0f64, -1060i32..1023).prop_map(|(m, e)| libm::scalbn(m, e)),
            (-2.0..2.0f64, 1015i32..1023).prop_map(|(m, e)| libm::scalbn(m, e)),
            -3.0..3.0f64,
        ]
    }

    /// Two numbers, a third of them close to each other.
    fn sides() -> impl Strategy<Value = [f64; 2]> {
        prop_oneof![
            2 => [double(), double()],
            1 => (double(), 1i64..100).prop_map(|(x, k)| [x, f64::from_bits((x.to_bits() as i64 + k) as u64)]),
        ]
    }

    fn depths() -> impl Strategy<Value = [f64; 2]> {
        sides().prop_map(|z| z.map(f64::abs))
    }

    /// A matrix where all entries can be held, and within `bound` ε of each.
    fn check(
        found: Result<DMat4, ViewError>,
        right: &[Exact; 16],
        bound: f64,
    ) -> Result<(), TestCaseError> {
        let m = found.unwrap_or(DMat4::ZERO).to_cols_array();
        let errors: Vec<_> = m
            .into_iter()
            .zip(right)
            .map(|(x, right)| error(x, right))
            .collect();
        if errors.iter().any(Option::is_none) {
            prop_assert!(found.is_err());
            return Ok(());
        }
        prop_assert!(found.is_ok(), "{:?}", found);
        for (e, x) in errors.into_iter().flatten().zip(m) {
            prop_assert!(e <= bound, "{x:e} is off by {e} ε in {found:?}");
        }
        Ok(())
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(4000))]

        #[test]
        fn of_the_frustum([l, r] in sides(), [b, t] in sides(), [n, f] in depths()) {
            prop_assume!([l, r, b, t, n, f].iter().all(|x| x.is_finite()) && l != r && b != t && n != f && n > 0.0 && f > 0.0);
            let [o, two] = [q(0.0), q(2.0)];
            let [l_, r_, b_, t_, n_, f_] = [l, r, b, t, n, f].map(q);
            let x = quotient(&(&two * &n_), &(&r_ - &l_));
            let y = quotient(&(&two * &n_), &(&t_ - &b_));
            let sx = quotient(&(&r_ + &l_), &(&r_ - &l_));
            let sy = quotient(&(&t_ + &b_), &(&t_ - &b_));
            let z = -quotient(&(&f_ + &n_), &(&f_ - &n_));
            let w = -quotient(&(&two * &f_ * &n_), &(&f_ - &n_));
            let rest = [x, o.clone(), o.clone(), o.clone(), o.clone(), y, o.clone(), o.clone(), sx, sy];
            let columns = |z: Exact, w: Exact| -> [Exact; 16] {
                let last = [z, q(-1.0), o.clone(), o.clone(), w, o.clone()];
                rest.iter().cloned().chain(last).collect::<Vec<_>>().try_into().unwrap()
            };
            check(frustum(l, r, b, t, n, f), &columns(z, w), 2.0)?;
            check(frustum_infinite(l, r, b, t, n), &columns(q(-1.0), -&two * &n_), 2.0)?;
        }

        #[test]
        fn of_the_box([l, r] in sides(), [b, t] in sides(), [n, f] in sides()) {
            prop_assume!([l, r, b, t, n, f].iter().all(|x| x.is_finite()) && l != r && b != t && n != f);
            let o = || q(0.0);
            let scale = |low: f64, high: f64| quotient(&q(2.0), &(q(high) - q(low)));
            let shift = |low: f64, high: f64| -quotient(&(q(high) + q(low)), &(q(high) - q(low)));
            let right = [
                scale(l, r), o(), o(), o(), o(), scale(b, t), o(), o(), o(), o(), -scale(n, f), o(),
                shift(l, r), shift(b, t), shift(n, f), q(1.0),
            ];
            check(orthographic(l, r, b, t, n, f), &right, 2.0)?;
        }

        /// 1/tan is taken from a cosine and a sine without rounding: Taylor's series of the half angle.
        #[test]
        fn of_the_symmetric_frustum(fov in 0.001..3.13f64, aspect in double(), [n, f] in depths()) {
            let aspect = aspect.abs();
            prop_assume!(aspect > 0.0 && n.is_finite() && f.is_finite() && n != f && n > 0.0 && f > 0.0);
            let (sin, cos) = sine_and_cosine(&q(fov).scaled(-1));
            let y = quotient(&cos, &sin);
            let o = || q(0.0);
            let [n_, f_] = [n, f].map(q);
            let z = -quotient(&(&f_ + &n_), &(&f_ - &n_));
            let w = -quotient(&(q(2.0) * &f_ * &n_), &(&f_ - &n_));
            let right = [
                quotient(&y, &q(aspect)), o(), o(), o(), o(), y, o(), o(), o(), o(), z, q(-1.0), o(), o(), w, o(),
            ];
            check(perspective(fov, aspect, n, f), &right, 3.0)?;
        }
    }
}

#[test]
fn what_can_be_held_is_not_refused() {
    // −2fn/(f − n) by hand: 2·10⁻²⁰⁰ either way round.
    for (n, f) in [(1e200, 1e-200), (1e-200, 1e200)] {
        let m = frustum(-1.0, 1.0, -1.0, 1.0, n, f).unwrap();
        assert!((m.w_axis.z.abs() - 2e-200).abs() <= 4.0 * EPS * 2e-200);
        let m = perspective(1.0, 1.0, n, f).unwrap();
        assert!((m.w_axis.z.abs() - 2e-200).abs() <= 4.0 * EPS * 2e-200);
    }
    // −2n alone would be beyond the largest double; 2fn/(n − f) is 2f.
    let (n, f) = (1.2e308, 3.0);
    let m = frustum(-1e300, 1e300, -1e300, 1e300, n, f).unwrap();
    assert!((m.w_axis.z - 6.0).abs() <= 4.0 * EPS * 6.0);
    let m = perspective(1.0, 1.0, n, f).unwrap();
    assert!((m.w_axis.z - 6.0).abs() <= 4.0 * EPS * 6.0);
    assert!(frustum_infinite(-1e300, 1e300, -1e300, 1e300, n).is_err());
}

proptest! {
    /// Against the exact axes S = F × up, U = S × F, F = target − eye, which have no rounding at all.
    #[test]
    fn look_at_is_near_the_exact_view((eye, target, up) in prop_oneof![
        (point(), point(), point()),
        (cube(), cube(), cube()),
        (cube(), cube(), cube()).prop_map(|(e, t, by)| (e, t, (t - e) * 3.0 + by * 1e-12)),
    ]) {
        let Ok(m) = look_at(eye, target, up) else {
            return Err(TestCaseError::reject("parallel"));
        };
        let [e, t, up] = [eye, target, up].map(|v| exact(v).unwrap());
        let f = minus(&t, &e);
        let s = cross(&f, &up);
        let u = cross(&s, &f);
        let back = f.clone().map(|x| -x);
        for (i, axis) in [s, u, back].iter().enumerate() {
            let row = exact(m.row(i).truncate()).unwrap();
            // |row × axis| = |row| |axis| sin of the angle between them: 8 ε.
            let off = cross(&row, axis);
            prop_assert!(dot(&off, &off) <= dot(axis, axis).scaled(2 * (3 - 52)), "axis {i}");
            prop_assert!(dot(&row, axis) > 0);
            prop_assert!((m.row(i).truncate().length() - 1.0).abs() <= 8.0 * EPS);
            // The last column: −row·eye, to the nearest double.
            let column = Exact::new(m.w_axis[i]).unwrap();
            let error = column + dot(&row, &e);
            prop_assert!(error.abs() <= m.w_axis[i].abs() * EPS / 2.0 + 5e-324);
        }
    }

    #[test]
    fn never_panics(p in [ANY; 9]) {
        let [a, b, c] = [0, 3, 6].map(|i| DVec3::from_slice(&p[i..]));
        let matrices = [
            look_at(a, b, c),
            frustum(p[0], p[1], p[2], p[3], p[4], p[5]),
            frustum_infinite(p[0], p[1], p[2], p[3], p[4]),
            perspective(p[0], p[1], p[2], p[3]),
            perspective(1.0, p[1].abs(), p[2].abs(), p[3].abs()),
            orthographic(p[0], p[1], p[2], p[3], p[4], p[5]),
        ];
        for m in matrices {
            match m {
                Ok(m) => prop_assert!(m.is_finite()),
                Err(error) => prop_assert!(!error.to_string().is_empty()),
            }
        }
        let _ = Viewport { width: u32::MAX, height: 1 }.to_pixel(a);
    }
}
