//! Cyrus–Beck: a segment against a convex polygon or polyhedron of any number of sides.
//!
//! Each side is a line or plane with an inside. A segment that starts beyond it enters there, one that ends beyond it
//! leaves there; what remains runs from the latest entry to the earliest exit.

use core::cmp::Ordering;

use ombra_math::double_double::DoubleDouble;
use ombra_math::exact::{Sum, dot};
use ombra_math::glam::{DVec2, DVec3};
use ombra_math::homogeneous::point;
use ombra_math::plane::Plane;
use ombra_math::predicates::orient_2d;
use ombra_math::work::{Count, Counter};

use crate::crossing::between_products;
use crate::outline::{edges, is_finite};
use crate::segment::Segment;

/// The part of `segment` in a convex polygon, or `None` if there is none.
///
/// # Formula
///
/// ```text
/// N_i inward normal of the side P_i Q_i,   D = B − A
/// t_i = N_i·(P_i − A) / N_i·D       N_i·D > 0 enters, N_i·D < 0 leaves, N_i·D = 0 is parallel
/// from max(0, entries) to min(1, exits);    nothing is left where that is empty
/// ```
///
/// # Properties
///
/// - The polygon may turn either way; its border is inside.
/// - Whether anything remains is decided exactly: of a convex polygon, the side with the latest entry is the one whose
///   ends lie on different sides of the segment's line, so that signs of orientations take the place of t's.
/// - Ends inside are returned unchanged, others are nearest doubles to the true crossings; direction is kept. With the
///   corners of a window the answer is that of the other methods, bit for bit.
/// - `None` for a polygon without area, or a number that is not finite.
///
/// # Pitfalls
///
/// On a side at an angle the nearest double may lie outside, by rounding, so clipping again may move it by an ulp.
/// For a polygon that is not convex the answer means nothing.
///
/// # Examples
///
/// ```
/// use ombra_clip::{Segment, cyrus_beck};
/// use ombra_math::glam::DVec2;
///
/// let diamond = [(5.0, 0.0), (10.0, 5.0), (5.0, 10.0), (0.0, 5.0)].map(DVec2::from);
/// let across = Segment::new(DVec2::new(-5.0, 3.0), DVec2::new(15.0, 3.0));
/// let inside = Segment::new(DVec2::new(2.0, 3.0), DVec2::new(8.0, 3.0));
/// assert_eq!(cyrus_beck::clip_segment(&diamond, across), Some(inside));
/// ```
///
/// # References
///
/// Grafica 3, «Clipping», convex polygons and polyhedra. M. Cyrus, J. Beck, «Generalized two- and three-dimensional
/// clipping», 1978.
#[must_use]
pub fn clip_segment(convex: &[DVec2], segment: Segment) -> Option<Segment> {
    clip_segment_counted(convex, segment, &mut ())
}

/// [`clip_segment`], counting a division for each intersection.
#[must_use]
pub fn clip_segment_counted(
    convex: &[DVec2],
    segment: Segment,
    work: &mut impl Count,
) -> Option<Segment> {
    if !segment.is_finite() || !is_finite(convex) {
        return None;
    }
    let outside = match turn(convex)? {
        Ordering::Greater => Ordering::Less,
        _ => Ordering::Greater,
    };
    Some(Segment {
        a: entry(convex, segment, outside, work)?,
        b: entry(convex, segment.reversed(), outside, work)?,
    })
}

/// The first point from a on that is inside.
fn entry(
    convex: &[DVec2],
    segment: Segment,
    outside: Ordering,
    work: &mut impl Count,
) -> Option<DVec2> {
    let Segment { a, b } = segment;
    let mut inside = true;
    for (p, q) in edges(convex) {
        if orient_2d(p, q, a)? != outside {
            continue;
        }
        inside = false;
        let reaches = orient_2d(p, q, b)? != outside;
        // Both on the line is no case: a would be on it, not outside.
        let passes_between = orient_2d(a, b, p)? != orient_2d(a, b, q)?;
        if reaches && passes_between {
            work.add(Counter::Divisions, 1);
            return Some(crossing(segment, p, q));
        }
    }
    inside.then_some(a)
}

/// How a convex polygon turns; `None` without area.
fn turn(convex: &[DVec2]) -> Option<Ordering> {
    let next = convex.iter().cycle().skip(1);
    let after = convex.iter().cycle().skip(2);
    convex
        .iter()
        .zip(next.zip(after))
        .filter_map(|(&a, (&b, &c))| orient_2d(a, b, c))
        .find(|&turn| turn != Ordering::Equal)
}

/// Where the segment crosses the line p q.
fn crossing(segment: Segment, p: DVec2, q: DVec2) -> DVec2 {
    // (q − p) × (x − p), multiplied out.
    let side = |x: DVec2| {
        [
            [p.x, q.y],
            [-p.y, q.x],
            [q.x, x.y],
            [-q.y, x.x],
            [x.x, p.y],
            [-x.y, p.x],
        ]
    };
    let Segment { a, b } = segment;
    let (sa, sb) = (side(a), side(b));
    DVec2::new(
        between_products(&sa, &sb, [a.x, b.x]),
        between_products(&sa, &sb, [a.y, b.y]),
    )
}

/// The part of a segment in space in front of all `planes`, or `None` if there is none.
///
/// # Formula
///
/// ```text
/// s_i(X) = n_i·X + d_i ≥ 0 inside       t_i = s_i(A) / (s_i(A) − s_i(B))
/// ```
///
/// # Properties
///
/// - Which side an end lies on is exact. Entries and exits are compared exactly while coordinates are 0 or between
///   2⁻²⁵⁰ and 2²⁵⁰ in size; beyond that, two whose t differ by less than some 8ε count as one.
/// - Ends inside are returned unchanged, others are nearest doubles to the true crossings; direction is kept.
/// - Without planes everything is inside. `None` if a number is not finite.
///
/// # Pitfalls
///
/// Normals point inwards. As in the plane, the nearest double may lie beyond a slanting plane by rounding.
///
/// # Examples
///
/// ```
/// use ombra_clip::cyrus_beck::clip_segment_3d;
/// use ombra_math::glam::DVec3;
/// use ombra_math::plane::Plane;
///
/// // Above the ground and below x + y + z = 6.
/// let planes = [Plane::GROUND, Plane { normal: DVec3::splat(-1.0), d: 6.0 }];
/// let upright = [DVec3::new(1.0, -7.0, 2.0), DVec3::new(1.0, 9.0, 2.0)];
/// let inside = [DVec3::new(1.0, 0.0, 2.0), DVec3::new(1.0, 3.0, 2.0)];
/// assert_eq!(clip_segment_3d(&planes, upright), Some(inside));
/// ```
///
/// # References
///
/// As for [`clip_segment`].
#[must_use]
pub fn clip_segment_3d(planes: &[Plane], segment: [DVec3; 2]) -> Option<[DVec3; 2]> {
    clip_segment_3d_counted(planes, segment, &mut ())
}

/// [`clip_segment_3d`], counting a division for each intersection and two multiplications for each comparison of t's.
#[must_use]
pub fn clip_segment_3d_counted(
    planes: &[Plane],
    [a, b]: [DVec3; 2],
    work: &mut impl Count,
) -> Option<[DVec3; 2]> {
    if !a.is_finite() || !b.is_finite() {
        return None;
    }
    let (mut entry, mut exit): (Option<&Plane>, Option<&Plane>) = (None, None);
    let mut later = |p: &Plane, q: &Plane| {
        work.add(Counter::Multiplications, 2);
        order(p, q, a, b)
    };
    for plane in planes {
        let beyond = |x: DVec3| plane.side(x).map(|side| side == Ordering::Less);
        match (beyond(a)?, beyond(b)?) {
            (false, false) => {}
            (true, true) => return None,
            (true, false) => {
                let is_later = entry.is_none_or(|best| later(plane, best) == Ordering::Greater);
                entry = if is_later { Some(plane) } else { entry };
            }
            (false, true) => {
                let is_earlier = exit.is_none_or(|best| later(plane, best) == Ordering::Less);
                exit = if is_earlier { Some(plane) } else { exit };
            }
        }
    }
    if let (Some(entry), Some(exit)) = (entry, exit)
        && later(entry, exit) == Ordering::Greater
    {
        return None;
    }
    let mut cut = |plane: &Plane| {
        work.add(Counter::Divisions, 1);
        let (sa, sb) = (products(plane, a), products(plane, b));
        let at = |k: usize| between_products(&sa, &sb, [a[k], b[k]]);
        DVec3::new(at(0), at(1), at(2))
    };
    Some([entry.map_or(a, &mut cut), exit.map_or(b, &mut cut)])
}

/// n·x + d as a sum of products.
fn products(plane: &Plane, x: DVec3) -> [[f64; 2]; 4] {
    let n = plane.normal;
    [[n.x, x.x], [n.y, x.y], [n.z, x.z], [plane.d, 1.0]]
}

/// Which of two planes, each with a and b on different sides, is met first on the way from a to b.
fn order(p: &Plane, q: &Plane, a: DVec3, b: DVec3) -> Ordering {
    // t_p < t_q  ⇔  |s_p(a)| |s_q(b)| < |s_q(a)| |s_p(b)|
    let side = |plane: &Plane, x: DVec3| dot(plane.coefficients(), point(x));
    let product = |(f, e): (f64, i32), (g, h): (f64, i32)| (f.abs() * g.abs(), e + h);
    let (left, e) = product(side(p, a), side(q, b));
    let (right, h) = product(side(q, a), side(p, b));
    // 200 binary digits are difference enough, and keep the number in range.
    let right = libm::scalbn(right, (h - e).clamp(-200, 200));
    let rounded = left.partial_cmp(&right).unwrap_or(Ordering::Equal);
    // Four values within ε and two products: 6ε of the larger.
    let certain = (left - right).abs() > 8.0 * f64::EPSILON * left.max(right);
    if certain {
        return rounded;
    }
    let coordinates = [p.normal, q.normal, a, b]
        .into_iter()
        .flat_map(|v| v.to_array())
        .chain([p.d, q.d]);
    if !coordinates.into_iter().all(DoubleDouble::in_range) {
        return Ordering::Equal;
    }
    let mut sum = Sum::default();
    // |s| = s or −s; where s(a) is 0, s(b) is not.
    let sign = |plane: &Plane| {
        if side(plane, a).0 < 0.0 || side(plane, b).0 > 0.0 {
            -1.0
        } else {
            1.0
        }
    };
    for (first, second, turned) in [(p, q, 1.0), (q, p, -1.0)] {
        let turned = turned * sign(p) * sign(q);
        for [x, y] in products(first, a) {
            let exact = DoubleDouble::product(x, y);
            for [z, w] in products(second, b) {
                // −: s(b) has the other sign than s(a).
                sum.add([-turned * exact.hi, z, w]);
                sum.add([-turned * exact.lo, z, w]);
            }
        }
    }
    sum.sign().unwrap_or(Ordering::Equal)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::oracle::{self, R, beside, int, is_nearest, r, window_and_segment};
    use crate::{Window, liang_barsky};
    use proptest::prelude::*;

    fn segment(a: (f64, f64), b: (f64, f64)) -> Segment {
        Segment::new(a.into(), b.into())
    }

    #[test]
    fn the_lectures_segments() {
        let window = Window::new(DVec2::ZERO, DVec2::splat(10.0))
            .unwrap()
            .corners();
        let mut clockwise = window;
        clockwise.reverse();
        for corners in [window, clockwise] {
            let clip = |s| clip_segment(&corners, s);
            assert_eq!(
                clip(segment((2.0, 14.0), (8.0, -4.0))),
                Some(segment((10.0 / 3.0, 10.0), (20.0 / 3.0, 0.0)))
            );
            assert_eq!(clip(segment((4.0, 14.0), (14.0, 8.0))), None);
        }
    }

    #[test]
    fn degenerate() {
        let triangle = [(0.0, 0.0), (9.0, 0.0), (0.0, 9.0)].map(DVec2::from);
        let cases = [
            // Along a side, through a corner, touching a corner, a point.
            (
                segment((-5.0, 14.0), (14.0, -5.0)),
                Some(segment((0.0, 9.0), (9.0, 0.0))),
            ),
            (
                segment((-3.0, -3.0), (9.0, 9.0)),
                Some(segment((0.0, 0.0), (4.5, 4.5))),
            ),
            (
                segment((0.0, 18.0), (0.0, 9.0)),
                Some(segment((0.0, 9.0), (0.0, 9.0))),
            ),
            (
                segment((-9.0, 0.0), (9.0, 18.0)),
                Some(segment((0.0, 9.0), (0.0, 9.0))),
            ),
            (segment((-9.0, 0.0), (9.0, 18.0_f64.next_up())), None),
            (
                segment((3.0, 3.0), (3.0, 3.0)),
                Some(segment((3.0, 3.0), (3.0, 3.0))),
            ),
            (segment((5.0, 5.0), (5.0, 5.0)), None),
            (
                segment((-f64::MAX, 3.0), (f64::MAX, 3.0)),
                Some(segment((0.0, 3.0), (6.0, 3.0))),
            ),
        ];
        for (s, expected) in cases {
            assert_eq!(clip_segment(&triangle, s), expected, "{s:?}");
        }
        let s = segment((1.0, 1.0), (2.0, 1.0));
        for flat in [
            &triangle[..0],
            &triangle[..1],
            &triangle[..2],
            &[DVec2::ONE; 5],
        ] {
            assert_eq!(clip_segment(flat, s), None);
        }
        for bad in [f64::NAN, f64::INFINITY] {
            let spoilt = [triangle[0], triangle[1], DVec2::new(0.0, bad)];
            assert_eq!(clip_segment(&spoilt, s), None);
            assert_eq!(
                clip_segment(&triangle, segment((bad, 1.0), (2.0, 1.0))),
                None
            );
            let spoilt = Plane {
                normal: DVec3::Y,
                d: bad,
            };
            assert_eq!(clip_segment_3d(&[spoilt], [DVec3::ZERO, DVec3::Y]), None);
            assert_eq!(clip_segment_3d(&[], [DVec3::splat(bad), DVec3::Y]), None);
        }
        assert_eq!(
            clip_segment_3d(&[], [DVec3::ZERO, DVec3::Y]),
            Some([DVec3::ZERO, DVec3::Y])
        );
        // A wedge of no thickness, met along its edge.
        let (ground, below) = (Plane::GROUND, Plane::GROUND.turned());
        let upright = [-DVec3::Y, DVec3::Y];
        assert_eq!(
            clip_segment_3d(&[ground, below], upright),
            Some([DVec3::ZERO; 2])
        );
    }

    #[test]
    fn counts_intersections() {
        let mut work = ombra_math::work::Work::default();
        let triangle = [(0.0, 0.0), (9.0, 0.0), (0.0, 9.0)].map(DVec2::from);
        let _ = clip_segment_counted(&triangle, segment((-1.0, 3.0), (10.0, 3.0)), &mut work);
        assert_eq!(work.divisions, 2);
    }

    /// The convex hull of some grid points, counter-clockwise.
    fn hull(mut points: Vec<DVec2>) -> Vec<DVec2> {
        points.sort_by(|p, q| p.x.total_cmp(&q.x).then(p.y.total_cmp(&q.y)));
        points.dedup();
        let mut hull: Vec<DVec2> = Vec::new();
        for pass in 0..2 {
            let from = hull.len();
            for &p in &points {
                while hull.len() >= from + 2 && {
                    let (a, b) = (hull[hull.len() - 2], hull[hull.len() - 1]);
                    (b - a).perp_dot(p - b) <= 0.0
                } {
                    hull.pop();
                }
                hull.push(p);
            }
            hull.pop();
            if pass == 0 {
                points.reverse();
            }
        }
        hull
    }

    fn plane() -> impl Strategy<Value = Plane> {
        (-3i32..4, -3i32..4, -3i32..4, -6i32..7).prop_map(|(x, y, z, d)| Plane {
            normal: DVec3::new(x.into(), y.into(), z.into()),
            d: d.into(),
        })
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(2000))]

        #[test]
        fn agrees_with_a_window((w, s) in window_and_segment()) {
            prop_assume!(w.min.x < w.max.x && w.min.y < w.max.y);
            prop_assert_eq!(clip_segment(&w.corners(), s), liang_barsky::clip_segment(&w, s));
        }

        #[test]
        fn convex_polygons(polygon in oracle::grid_polygon(), a in oracle::point(), k in 0usize..20, t in 0.0..3.0f64, i in -2i64..3) {
            let polygon = hull(polygon);
            prop_assume!(polygon.len() > 2);
            // Through a corner, or nearly.
            let corner = polygon[k % polygon.len()];
            let b = corner + (corner - a) * t;
            let b = if b.is_finite() { DVec2::new(beside(b.x, i), b.y) } else { corner };
            let s = Segment::new(a, b);
            let sides: Vec<[R; 2]> = edges(&polygon).map(|(p, q)| [a, b].map(|x| {
                (r(q.x) - r(p.x)) * (r(x.y) - r(p.y)) - (r(q.y) - r(p.y)) * (r(x.x) - r(p.x))
            })).collect();
            let expected = oracle::interval(&sides);
            let clipped = clip_segment(&polygon, s);
            prop_assert_eq!(clipped.is_some(), expected.is_some());
            if let (Some(clipped), Some(t)) = (clipped, expected) {
                for (p, t) in [clipped.a, clipped.b].iter().zip(&t) {
                    prop_assert!(is_nearest(p.x, &oracle::at(t, a.x, b.x)));
                    prop_assert!(is_nearest(p.y, &oracle::at(t, a.y, b.y)));
                }
                prop_assert!(t[0] > int(0) || clipped.a == a);
                prop_assert!(t[1] < int(1) || clipped.b == b);
            }
            let mut clockwise = polygon.clone();
            clockwise.reverse();
            prop_assert_eq!(clip_segment(&clockwise, s), clipped);
            prop_assert_eq!(clip_segment(&polygon, s.reversed()), clipped.map(Segment::reversed));
        }

        #[test]
        fn polyhedra(planes in prop::collection::vec(plane(), 1..7), x in prop::array::uniform6(-9i32..10), ulps in prop::array::uniform6(-2i64..3)) {
            // Small integers meet many edges and corners exactly; a few ulps off they do not.
            let y: Vec<f64> = x.iter().zip(ulps).map(|(&x, i)| beside(x.into(), i)).collect();
            let (a, b) = (DVec3::new(y[0], y[1], y[2]), DVec3::new(y[3], y[4], y[5]));
            let side = |p: &Plane, x: DVec3| {
                r(p.normal.x) * r(x.x) + r(p.normal.y) * r(x.y) + r(p.normal.z) * r(x.z) + r(p.d)
            };
            let sides: Vec<[R; 2]> = planes.iter().map(|p| [side(p, a), side(p, b)]).collect();
            let expected = oracle::interval(&sides);
            let clipped = clip_segment_3d(&planes, [a, b]);
            prop_assert_eq!(clipped.is_some(), expected.is_some());
            if let (Some(clipped), Some(t)) = (clipped, expected) {
                for (p, t) in clipped.iter().zip(&t) {
                    for k in 0..3 {
                        prop_assert!(is_nearest(p[k], &oracle::at(t, a[k], b[k])));
                    }
                }
            }
        }

        #[test]
        fn never_panics(x in prop::collection::vec(proptest::num::f64::ANY, 16), n in 0usize..7) {
            let p: Vec<DVec2> = x.chunks_exact(2).map(DVec2::from_slice).collect();
            let _ = clip_segment(&p[..n], Segment::new(p[6], p[7]));
            let v: Vec<DVec3> = x.chunks_exact(3).map(DVec3::from_slice).collect();
            let planes = [Plane { normal: v[0], d: x[15] }, Plane { normal: v[1], d: x[0] }, Plane { normal: v[2], d: x[1] }];
            let _ = clip_segment_3d(&planes, [v[3], v[4]]);
        }
    }
}
