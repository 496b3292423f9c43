//! Orientation of points, exact: where a sign decides, rounding must not.
//!
//! The determinant of nearly collinear points is mostly rounding error when computed in doubles. Inside its
//! range the `robust` crate decides; outside (a triangle of 10⁻²⁰⁰, or of 10²⁰⁰) an exact
//! [`Sum`] does.
#![doc(alias = "orientation test")]

use core::cmp::Ordering;

use glam::{DVec2, DVec3};
use robust::{Coord, Coord3D};

use crate::double_double::DoubleDouble;
use crate::exact::Sum;

/// How a b c turn: `Greater` counter-clockwise (y up), `Equal` collinear, `Less` clockwise; `None` if a
/// coordinate is not finite.
///
/// # Formula
///
/// ```text
///         | bx − ax   by − ay |
/// sign of | cx − ax   cy − ay |
/// ```
///
/// # Properties
///
/// Exact for all finite input. Even permutations of the points give the same answer, odd ones the opposite.
///
/// # Pitfalls
///
/// With y down, as on a screen, counter-clockwise looks clockwise.
///
/// # Examples
///
/// ```
/// use core::cmp::Ordering;
/// use ombra_math::glam::DVec2;
/// use ombra_math::predicates::orient_2d;
///
/// let (a, b) = (DVec2::ZERO, DVec2::splat(3.0));
/// assert_eq!(orient_2d(a, b, DVec2::new(0.1, 0.1)), Some(Ordering::Equal));
/// assert_eq!(orient_2d(a, b, DVec2::new(0.1, 0.1_f64.next_up())), Some(Ordering::Greater));
/// ```
///
/// # References
///
/// In no deck. J. R. Shewchuk, «Adaptive precision floating-point arithmetic and fast robust geometric
/// predicates», 1997.
#[doc(alias = "counter-clockwise")]
#[doc(alias = "ccw")]
#[must_use]
pub fn orient_2d(a: DVec2, b: DVec2, c: DVec2) -> Option<Ordering> {
    let points = [a, b, c];
    if points
        .iter()
        .all(|p| p.to_array().into_iter().all(DoubleDouble::in_range))
    {
        let [a, b, c] = points.map(|p| Coord { x: p.x, y: p.y });
        return robust::orient2d(a, b, c).partial_cmp(&0.0);
    }
    // Products of the differences, multiplied out: the differences themselves would be rounded.
    let minor = |p: DVec2, q: DVec2| [[p.x, q.y, 1.0], [-p.y, q.x, 1.0]];
    Sum::of(&[minor(a, b), minor(b, c), minor(c, a)].concat()).sign()
}

/// Where d lies from the plane of a b c: `Greater` in front, from where they run counter-clockwise, `Equal`
/// on the plane, `Less` behind; `None` if a coordinate is not finite.
///
/// # Formula
///
/// ```text
/// sign of (AB × AC)·AD
/// ```
///
/// # Properties
///
/// Exact for all finite input. Even permutations of the points give the same answer, odd ones the opposite.
///
/// # Examples
///
/// ```
/// use core::cmp::Ordering;
/// use ombra_math::glam::DVec3;
/// use ombra_math::predicates::orient_3d;
///
/// let above = DVec3::new(0.3, 0.3, 5e-324);
/// assert_eq!(orient_3d(DVec3::ZERO, DVec3::X, DVec3::Y, above), Some(Ordering::Greater));
/// ```
///
/// # References
///
/// In no deck. Shewchuk, as for [`orient_2d`]; his predicate has the opposite sign.
#[must_use]
pub fn orient_3d(a: DVec3, b: DVec3, c: DVec3, d: DVec3) -> Option<Ordering> {
    let points = [a, b, c, d];
    if points
        .iter()
        .all(|p| p.to_array().into_iter().all(DoubleDouble::in_range))
    {
        let [a, b, c, d] = points.map(|p| Coord3D {
            x: p.x,
            y: p.y,
            z: p.z,
        });
        return 0.0.partial_cmp(&robust::orient3d(a, b, c, d));
    }
    // det(AB, AC, AD) = det(b, c, d) − det(a, c, d) + det(a, b, d) − det(a, b, c).
    let determinant = |sign: f64, p: DVec3, q: DVec3, r: DVec3| {
        [(0, 1, 2), (1, 2, 0), (2, 0, 1)]
            .map(|(i, j, k)| [[sign * p[i], q[j], r[k]], [-sign * p[i], q[k], r[j]]])
            .concat()
    };
    let terms = [
        determinant(1.0, b, c, d),
        determinant(-1.0, a, c, d),
        determinant(1.0, a, b, d),
        determinant(-1.0, a, b, c),
    ];
    Sum::of(&terms.concat()).sign()
}

#[cfg(test)]
mod tests {
    use super::*;
    use ombra_oracle::vector::{cross, dot, exact, minus, turn};
    use proptest::prelude::*;

    /// The determinant of differences, without rounding.
    fn oracle_3d(points: [DVec3; 4]) -> Ordering {
        let [a, b, c, d] = points.map(|p| exact(p).unwrap());
        let [u, v, w] = [b, c, d].map(|p| minus(&p, &a));
        dot(&cross(&u, &v), &w).sign()
    }

    fn oracle_2d(points: [DVec2; 3]) -> Ordering {
        let [a, b, c] = points.map(|p| exact(p).unwrap());
        turn(&a, &b, &c).sign()
    }

    /// All exponents, the middle of the range, and small integers times a unit (so that zeros occur).
    fn number() -> impl Strategy<Value = f64> {
        prop_oneof![
            (-1.0..1.0f64, -1070..1020i32).prop_map(|(m, e)| libm::scalbn(m, e)),
            -4.0..4.0f64,
            (-3i32..4).prop_map(f64::from),
            (-3i32..4).prop_map(|k| f64::from(k) * 1e-200),
            (-3i32..4).prop_map(|k| f64::from(k) * 1e200),
        ]
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(2000))]

        #[test]
        fn agrees_with_exact_numbers_in_space(v in prop::collection::vec(number(), 12), k in 0i64..3) {
            let p = |i: usize| DVec3::new(v[3 * i], v[3 * i + 1], v[3 * i + 2]);
            let mut points = [p(0), p(1), p(2), p(3)];
            prop_assert_eq!(orient_3d(points[0], points[1], points[2], points[3]), Some(oracle_3d(points)));
            // A point within an ulp or two of the plane.
            points[3] = points[0] + (points[1] - points[0]) * 0.25 + (points[2] - points[0]) * 0.5;
            points[3].z = f64::from_bits(points[3].z.to_bits().wrapping_add_signed(k - 1));
            prop_assume!(points[3].is_finite());
            prop_assert_eq!(orient_3d(points[0], points[1], points[2], points[3]), Some(oracle_3d(points)));
        }

        #[test]
        fn agrees_with_exact_numbers_in_the_plane(v in prop::collection::vec(number(), 6), t in 0.0..1.0f64) {
            let mut points = [DVec2::new(v[0], v[1]), DVec2::new(v[2], v[3]), DVec2::new(v[4], v[5])];
            prop_assert_eq!(orient_2d(points[0], points[1], points[2]), Some(oracle_2d(points)));
            points[2] = points[0] + (points[1] - points[0]) * t;
            prop_assume!(points[2].is_finite());
            prop_assert_eq!(orient_2d(points[0], points[1], points[2]), Some(oracle_2d(points)));
        }

        #[test]
        fn never_panics(v in prop::collection::vec(proptest::num::f64::ANY, 12)) {
            let p = |i: usize| DVec3::new(v[3 * i], v[3 * i + 1], v[3 * i + 2]);
            let finite = v.iter().all(|x| x.is_finite());
            prop_assert_eq!(orient_3d(p(0), p(1), p(2), p(3)).is_some(), finite);
        }
    }

    /// Plain doubles are wrong at many of these 4096 points; here none may be.
    #[test]
    fn a_grid_beside_a_line() {
        let (b, c) = (DVec2::splat(12.0), DVec2::splat(24.0));
        let mut plain_errors = 0;
        for i in 0..64 {
            for j in 0..64 {
                let ulp = f64::EPSILON / 2.0;
                let a = DVec2::new(0.5 + f64::from(i) * ulp, 0.5 + f64::from(j) * ulp);
                // (12,12) and (24,24) lie on the diagonal, so only a's own side of it counts.
                let expected = a.y.partial_cmp(&a.x);
                assert_eq!(orient_2d(b, c, a), expected, "{i} {j}");
                let plain = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
                plain_errors += usize::from(plain.partial_cmp(&0.0) != expected);
            }
        }
        assert!(plain_errors > 1000, "{plain_errors}: the case is not hard");
    }

    #[test]
    fn degenerate() {
        let o = DVec3::ZERO;
        assert_eq!(orient_3d(o, o, o, o), Some(Ordering::Equal));
        assert_eq!(orient_3d(o, DVec3::X, DVec3::Y, DVec3::NAN), None);
        assert_eq!(orient_3d(o, DVec3::X, DVec3::INFINITY, DVec3::Z), None);
        assert_eq!(
            orient_2d(DVec2::ZERO, DVec2::ZERO, DVec2::ZERO),
            Some(Ordering::Equal)
        );
        assert_eq!(orient_2d(DVec2::NAN, DVec2::X, DVec2::Y), None);
        let t = 1e-200;
        assert_eq!(
            orient_2d(DVec2::ZERO, DVec2::X * t, DVec2::Y * t),
            Some(Ordering::Greater)
        );
        assert_eq!(
            orient_2d(DVec2::ZERO, DVec2::X * f64::MAX, DVec2::Y * f64::MAX),
            Some(Ordering::Greater)
        );
    }
}
