use super::*;
use ombra_oracle::vector::{cross, dot, minus};
use ombra_oracle::{Exact, vector};
use proptest::prelude::*;

fn exact(x: f64) -> Exact {
    Exact::new(x).unwrap()
}

fn point(p: DVec3) -> [Exact; 3] {
    vector::exact(p).unwrap()
}

fn value(plane: &Plane, p: DVec3) -> Exact {
    dot(&point(plane.normal), &point(p)) + exact(plane.d)
}

fn number() -> impl Strategy<Value = f64> {
    prop_oneof![
        (-1.0..1.0f64, -1000..1000i32).prop_map(|(m, e)| libm::scalbn(m, e)),
        (-1.0..1.0f64, -40..40i32).prop_map(|(m, e)| libm::scalbn(m, e)),
        (-9i32..9).prop_map(f64::from),
    ]
}

fn vector() -> impl Strategy<Value = DVec3> {
    [number(), number(), number()].prop_map(DVec3::from_array)
}

/// A plane, and a point that often lies within a few ulps of it.
fn plane_and_point() -> impl Strategy<Value = (Plane, DVec3)> {
    (vector(), number(), vector(), any::<bool>(), -4i64..4).prop_map(
        |(normal, d, mut p, near, ulps)| {
            if near {
                let y = -(normal.x * p.x + normal.z * p.z + d) / normal.y;
                if y.is_normal() {
                    p.y = f64::from_bits(y.to_bits().wrapping_add_signed(ulps));
                }
            }
            (Plane { normal, d }, p)
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn sides_are_exact((plane, p) in plane_and_point()) {
        prop_assume!(p.is_finite());
        prop_assert_eq!(plane.side(p), Some(value(&plane, p).sign()));
    }

    #[test]
    fn distances_are_within_4_epsilon((plane, p) in plane_and_point()) {
        prop_assume!(p.is_finite() && plane.normal != DVec3::ZERO);
        let distance = plane.signed_distance(p);
        let below_all_doubles = |v: &Exact, nn: &Exact| {
            v.squared() < nn.scaled(2 * -1074)
        };
        // (n·p + d)² = distance² n·n without a root.
        let n = point(plane.normal);
        let nn = dot(&n, &n);
        let v = value(&plane, p);
        if !distance.is_normal() {
            prop_assert!(distance != 0.0 || below_all_doubles(&v, &nn));
            return Ok(());
        }
        let difference = (exact(distance).squared() * &nn - v.squared()).abs();
        prop_assert!(difference <= exact(8.0 * f64::EPSILON) * v.squared(), "{distance:e}");
        prop_assert_eq!(distance > 0.0, v > 0);
    }

    #[test]
    fn a_plane_holds_its_triangle(a in vector(), b in vector(), c in vector()) {
        // The exact normal, without the cancelled form the function uses.
        let [a_, b_, c_] = [a, b, c].map(point);
        let cross = cross(&minus(&b_, &a_), &minus(&c_, &a_));
        match Plane::of_triangle(a, b, c) {
            None => prop_assert!(cross.iter().all(|x| *x == 0)),
            Some(plane) => {
                // Parallel and of one direction, to the rounding of each coordinate; scaling keeps ratios.
                let n = plane.normal.to_array();
                let largest = (0..3).max_by(|&i, &j| n[i].abs().total_cmp(&n[j].abs())).unwrap();
                let scale = exact(n[largest]).over(&cross[largest]).unwrap();
                prop_assert!(scale > 0);
                for i in 0..3 {
                    let expected = &cross[i] * &scale;
                    let error = exact(n[i]) - &expected;
                    let bound = &expected * exact(2.0 * f64::EPSILON);
                    // A coordinate 10³⁰⁰ times smaller than the largest may be subnormal.
                    let square = bound.squared() + Exact::power_of_two(2 * -1074);
                    prop_assert!(error.squared() <= square, "{i}: {:e}", n[i]);
                }
            }
        }
    }
}

#[test]
fn degenerate() {
    let x = DVec3::X;
    for (point, normal) in [
        (DVec3::ZERO, DVec3::ZERO),
        (DVec3::NAN, x),
        (DVec3::INFINITY, x),
        (DVec3::ZERO, DVec3::NAN),
        (DVec3::ZERO, DVec3::INFINITY),
        (DVec3::splat(f64::MAX), DVec3::splat(2.0)),
    ] {
        assert_eq!(Plane::through(point, normal), None, "{point} {normal}");
    }
    for [a, b, c] in [
        [DVec3::ZERO; 3],
        [DVec3::ZERO, x, 2.0 * x],
        [x, x, DVec3::Y],
        [x * f64::MAX, x, DVec3::ZERO],
        [DVec3::NAN, x, DVec3::Y],
        [DVec3::INFINITY, x, DVec3::Y],
    ] {
        assert_eq!(Plane::of_triangle(a, b, c), None, "{a} {b} {c}");
    }
    let huge = Plane::of_triangle(x * f64::MAX, DVec3::Y * f64::MAX, DVec3::Z * f64::MAX).unwrap();
    assert_eq!(huge.normal.x, huge.normal.y);
    assert_eq!(huge.normal.y, huge.normal.z);
    assert!(Plane::of_triangle(x * 5e-324, DVec3::Y * 5e-324, DVec3::Z * 5e-324).is_some());
    assert!(
        Plane {
            normal: DVec3::ZERO,
            d: 1.0
        }
        .signed_distance(x)
        .is_nan()
    );
    assert!(Plane::GROUND.signed_distance(DVec3::NAN).is_nan());
    assert_eq!(Plane::GROUND.side(DVec3::INFINITY), None);
    let unnormalised = Plane {
        normal: DVec3::Y * 1e300,
        d: -1e300,
    };
    assert_eq!(unnormalised.signed_distance(DVec3::new(0.0, 3.0, 0.0)), 2.0);
    let tiny = Plane {
        normal: DVec3::Y * 5e-324,
        d: 0.0,
    };
    assert_eq!(tiny.signed_distance(DVec3::new(1e300, -1e300, 0.0)), -1e300);
}

#[test]
fn offsets_of_normals_of_any_length() {
    for length in [1.0, 1e300, 1e-300, 5e-324] {
        let plane = Plane {
            normal: DVec3::Y * length,
            d: 0.0,
        };
        assert_eq!(plane.offset(1.0).d, -length, "{length:e}");
    }
}

#[test]
fn turned_planes_answer_opposite() {
    let plane = Plane {
        normal: DVec3::new(1.0, 2.0, 3.0),
        d: 4.0,
    };
    let p = DVec3::new(3.0, -1.0, 7.0);
    assert_eq!(plane.turned().signed_distance(p), -plane.signed_distance(p));
    assert_eq!(plane.side(p), plane.turned().side(p).map(Ordering::reverse));
}
