use super::*;
use ombra_oracle::{Exact, vector};
use proptest::num::f64::ANY;
use proptest::prelude::*;

fn exact(x: f64) -> Exact {
    Exact::new(x).unwrap()
}

fn within(x: f64, expected: &Exact, bound: &Exact) -> bool {
    (exact(x) - expected).abs() <= *bound
}

fn exact_area(a: DVec2, b: DVec2, p: DVec2) -> Exact {
    let [a, b, p] = [a, b, p].map(|p| vector::exact(p).unwrap());
    vector::turn(&a, &b, &p)
}

fn exact_weights([a, b, c]: [DVec2; 3], p: DVec2) -> Option<[Exact; 3]> {
    let whole = exact_area(a, b, c);
    (whole != 0)
        .then(|| [(b, c), (c, a), (a, b)].map(|(a, b)| exact_area(a, b, p).over(&whole).unwrap()))
}

/// ε times `k`.
fn epsilon(k: i32) -> Exact {
    exact(f64::EPSILON) * Exact::from(k)
}

/// Of ordinary size; a third are slivers, off a line by 10⁻¹² or less.
fn triangle() -> impl Strategy<Value = [DVec2; 3]> {
    let point = || [-100.0..100.0f64, -100.0..100.0].prop_map(DVec2::from_array);
    prop_oneof![
        2 => [point(), point(), point()],
        1 => (point(), point(), -1.0..2.0, -1e-12..1e-12f64)
            .prop_map(|(a, b, t, off)| [a, b, a + (b - a) * t + DVec2::new(off, -off)]),
    ]
}

/// Positive, over ten orders of magnitude.
fn w() -> impl Strategy<Value = [f64; 3]> {
    let w = || (1.0..2.0f64, -17..17i32).prop_map(|(m, e)| libm::scalbn(m, e));
    [w(), w(), w()]
}

/// A point inside or near the border, mixed of the corners.
fn mixed([a, b, c]: [DVec2; 3], s: f64, t: f64) -> DVec2 {
    let (s, t) = if s + t > 1.0 {
        (1.0 - s, 1.0 - t)
    } else {
        (s, t)
    };
    a + (b - a) * s + (c - a) * t
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(500))]

    #[test]
    fn weights_are_near_the_exact_ones(triangle in triangle(), s in 0.0..1.0f64, t in 0.0..1.0f64, far in -3.0..3.0f64) {
        for p in [mixed(triangle, s, t), mixed(triangle, s, 0.0), triangle[0] * far] {
            let found = weights(triangle, p);
            let Some(expected) = exact_weights(triangle, p) else {
                prop_assert_eq!(found, None);
                continue;
            };
            let found = found.unwrap();
            for i in 0..3 {
                prop_assert!(within(found[i], &expected[i], &(expected[i].abs() * epsilon(64))));
            }
        }
    }

    /// No double is nearer, whatever the scale.
    #[test]
    fn plain_weights_are_the_nearest(triangle in triangle(), s in 0.0..1.0f64, t in 0.0..1.0f64, far in -3.0..3.0f64, scale in -300..300i32) {
        for p in [mixed(triangle, s, t), mixed(triangle, s, 0.0), triangle[0] * far] {
            let scale = libm::scalbn(1.0, scale);
            let found = weights_plain(triangle.map(|corner| corner * scale), p * scale);
            let Some(expected) = exact_weights(triangle, p) else {
                prop_assert_eq!(found, None);
                continue;
            };
            for (found, expected) in found.unwrap().to_array().into_iter().zip(expected) {
                let distance = |x: f64| (exact(x) - &expected).abs();
                prop_assert!(distance(found) <= distance(found.next_up()).min(distance(found.next_down())));
            }
        }
    }

    /// Given the weights, whatever they are.
    #[test]
    fn mixing_keeps_its_bound(weights in [-9.0..9.0f64, -9.0..9.0, -9.0..9.0], a in [-9.0..9.0f64, -9.0..9.0, -9.0..9.0], cancel: bool) {
        let mut weights = weights;
        if cancel {
            // The last term takes away nearly all of the others.
            weights[2] = -(weights[0] * a[0] + weights[1] * a[1]) / a[2];
        }
        prop_assume!(weights.iter().all(|x| x.is_finite()));
        let terms: Vec<_> = (0..3).map(|i| exact(weights[i]) * exact(a[i])).collect();
        let size: Exact = terms.iter().map(Exact::abs).sum();
        prop_assert!(within(linear(weights.into(), a), &terms.iter().sum(), &(size * epsilon(2))));
    }

    #[test]
    fn attributes_are_near_the_exact_ones(triangle in triangle(), s in 0.0..1.0f64, t in 0.0..1.0f64,
                                          a in [-9.0..9.0f64, -9.0..9.0, -9.0..9.0], w in w()) {
        let p = mixed(triangle, s, t);
        let Some(lambda) = exact_weights(triangle, p) else { return Ok(()) };
        let found = weights(triangle, p).unwrap();
        let terms: Vec<_> = (0..3).map(|i| &lambda[i] * exact(a[i])).collect();
        let size: Exact = terms.iter().map(Exact::abs).sum();
        prop_assert!(within(linear(found, a), &terms.iter().sum(), &(size * epsilon(67))));

        // The mixed point is rounded: on a sliver it may lie outside, where the bound does not hold.
        prop_assume!(lambda.iter().all(|x| *x >= 0));
        let numerator: Exact = (0..3).map(|i| terms[i].over(&exact(w[i])).unwrap()).sum();
        let denominator: Exact = (0..3).map(|i| lambda[i].over(&exact(w[i])).unwrap()).sum();
        let largest = a.map(f64::abs).into_iter().fold(0.0, f64::max);
        let value = perspective(found, a, w).unwrap();
        prop_assert!(within(value, &numerator.over(&denominator).unwrap(), &(exact(largest) * epsilon(140))));

        let mu = perspective_weights(found, w).unwrap();
        let shares: Vec<_> = (0..3).map(|i| exact(found[i]).over(&exact(w[i])).unwrap()).collect();
        let total: Exact = shares.iter().sum();
        for i in 0..3 {
            let expected = shares[i].over(&total).unwrap();
            prop_assert!(within(mu[i], &expected, &(&expected * epsilon(5))));
        }
    }

    #[test]
    fn stepping_keeps_its_bound(triangle in triangle(), y in 0..100u32, start in 0..100u32, len in 1..20u32) {
        let span = Span { y, x: start..start + len };
        let Some(steps) = along(triangle, &span) else {
            prop_assert!(exact_weights(triangle, DVec2::ZERO).is_none());
            return Ok(());
        };
        let centre = |x: u32| DVec2::new(f64::from(x) + 0.5, f64::from(y) + 0.5);
        let ends = [start, start + len - 1].map(|x| exact_weights(triangle, centre(x)).unwrap());
        let mut count = 0;
        for (x, found) in span.x.clone().zip(steps) {
            let expected = exact_weights(triangle, centre(x)).unwrap();
            for i in 0..3 {
                let scale = ends[0][i].abs().max(ends[1][i].abs());
                prop_assert!(within(found[i], &expected[i], &(scale * epsilon(128))));
            }
            count += 1;
        }
        prop_assert_eq!(count, len);
    }

    #[test]
    fn never_panics(v in [ANY; 8], w in [ANY; 3], values in [ANY; 3], y in any::<u32>(), x in any::<u32>()) {
        let p = |i: usize| DVec2::new(v[2 * i], v[2 * i + 1]);
        let triangle = [p(0), p(1), p(2)];
        if let Some(found) = weights(triangle, p(3)) {
            prop_assert!(found.is_finite());
            let _ = perspective(found, values, w);
        }
        let span = Span { y, x: x.saturating_sub(3)..x };
        if let Some(steps) = along(triangle, &span) {
            prop_assert_eq!(steps.count(), span.len() as usize);
        }
        let _ = perspective(DVec3::from_array(values), values, w);
    }
}

#[test]
fn corners_and_sides_are_exact() {
    // Corners whose differences all round.
    let [a, b, c] = [(0.1, 0.7), (1e9, 0.3), (-3.3, 1e-7)].map(DVec2::from);
    assert_eq!(weights([a, b, c], a), Some(DVec3::X));
    assert_eq!(weights([a, b, c], b), Some(DVec3::Y));
    assert_eq!(weights([a, b, c], c), Some(DVec3::Z));
    let [a, b, c] = [(0.0, 0.0), (3.0, 3.0), (0.1, 5.0)].map(DVec2::from);
    for t in [0.1, 0.7, 1.0 / 3.0] {
        let found = weights([a, b, c], DVec2::splat(t)).unwrap();
        assert_eq!(found.z, 0.0);
        let beside = weights([a, b, c], DVec2::new(t, t.next_down())).unwrap();
        assert!(beside.z < 0.0 && beside.z > -f64::EPSILON);
    }
}

#[test]
fn a_constant_stays_and_equal_w_change_nothing() {
    let triangle = [(0.5, 1.0), (9.0, 2.0), (4.0, 11.0)].map(DVec2::from);
    for p in [(3.0, 4.0), (4.5, 4.5), (4.0, 9.5)] {
        let found = weights(triangle, p.into()).unwrap();
        // Σλ = 1 within 64ε, then a rounding or two.
        assert!((linear(found, [7.0; 3]) - 7.0).abs() <= 70.0 * f64::EPSILON * 7.0);
        let (plain, corrected) = (
            linear(found, [1.0, 2.0, 3.0]),
            perspective(found, [1.0, 2.0, 3.0], [5.0; 3]).unwrap(),
        );
        assert!((plain - corrected).abs() <= 70.0 * f64::EPSILON * 3.0);
    }
}

#[test]
fn degenerate() {
    let (inf, nan) = (f64::INFINITY, f64::NAN);
    let good = [(0.0, 0.0), (4.0, 0.0), (0.0, 4.0)].map(DVec2::from);
    for (name, triangle) in [
        ("a point", [DVec2::ONE; 3]),
        ("collinear", [0.1, 0.2, 0.7].map(DVec2::splat)),
        ("NaN", [DVec2::NAN, DVec2::X, DVec2::Y]),
        ("infinite", [DVec2::ZERO, DVec2::X * inf, DVec2::Y]),
    ] {
        assert_eq!(weights(triangle, DVec2::ONE), None, "{name}");
        assert!(along(triangle, &Span { y: 0, x: 0..4 }).is_none(), "{name}");
    }
    assert_eq!(weights(good, DVec2::splat(nan)), None);
    for s in [5e-324, 1e-300, 1e300] {
        // The scale does not matter, but (s, s) − (0, 4s) may round.
        let third = weights(good.map(|p| p * s), DVec2::splat(s)).unwrap();
        assert_eq!(third, DVec3::new(0.5, 0.25, 0.25), "{s}");
    }
    // A weight of 10³⁰⁰ is one; one of 10³⁰⁰ times that is not.
    let small = good.map(|p| p * 1e-160);
    assert!(weights(small, DVec2::splat(1e140)).is_some());
    assert_eq!(weights(small, DVec2::splat(1e160)), None);
    let middle = DVec3::splat(1.0 / 3.0);
    for bad in [0.0, -0.0, -1.0, nan, inf] {
        assert_eq!(
            perspective(middle, [1.0; 3], [1.0, bad, 2.0]),
            None,
            "{bad}"
        );
    }
    assert_eq!(perspective(DVec3::ZERO, [1.0; 3], [1.0; 3]), None);
    // 1/w alone would overflow.
    assert_eq!(
        perspective_weights(DVec3::new(0.5, 0.5, 0.0), [5e-324, 1e-323, 1.0]),
        Some(DVec3::new(2.0 / 3.0, 1.0 / 3.0, 0.0))
    );
}
