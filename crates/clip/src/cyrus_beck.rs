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

/// [`clip_segment`], counting its [work](crate#counted-work).
#[must_use]
pub fn clip_segment_counted(
    convex: &[DVec2],
    segment: Segment,
    work: &mut impl Count,
) -> Option<Segment> {
    if !segment.is_finite() || !is_finite(convex) {
        return None;
    }
    let outside = match turn(convex, work)? {
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
        if orientation(p, q, a, work)? != outside {
            continue;
        }
        inside = false;
        let reaches = orientation(p, q, b, work)? != outside;
        // Both on the line is no case: a would be on it, not outside.
        let passes_between = orientation(a, b, p, work)? != orientation(a, b, q, work)?;
        if reaches && passes_between {
            work.add(Counter::Divisions, 1);
            return Some(crossing(segment, p, q));
        }
    }
    inside.then_some(a)
}

/// How a convex polygon turns; `None` without area.
fn turn(convex: &[DVec2], work: &mut impl Count) -> Option<Ordering> {
    let next = convex.iter().cycle().skip(1);
    let after = convex.iter().cycle().skip(2);
    convex
        .iter()
        .zip(next.zip(after))
        .filter_map(|(&a, (&b, &c))| orientation(a, b, c, work))
        .find(|&turn| turn != Ordering::Equal)
}

/// On which side of a b the point c lies.
fn orientation(a: DVec2, b: DVec2, c: DVec2, work: &mut impl Count) -> Option<Ordering> {
    work.add(Counter::Multiplications, 2);
    work.add(Counter::Comparisons, 1);
    orient_2d(a, b, c)
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
/// - Ends inside are returned unchanged, others are nearest doubles to the true crossings; direction is kept,
///   beyond those sizes to that 8ε.
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

/// [`clip_segment_3d`], counting its [work](crate#counted-work).
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
    let later = |p: &Plane, q: &Plane, work: &mut _| {
        Count::add(work, Counter::Multiplications, 2);
        Count::add(work, Counter::Comparisons, 1);
        order(p, q, a, b)
    };
    for plane in planes {
        let beyond = |x: DVec3| plane.side(x).map(|side| side == Ordering::Less);
        work.add(Counter::Multiplications, 6);
        work.add(Counter::Comparisons, 2);
        match (beyond(a)?, beyond(b)?) {
            (false, false) => {}
            (true, true) => return None,
            (true, false) => {
                let is_later =
                    entry.is_none_or(|best| later(plane, best, work) == Ordering::Greater);
                entry = if is_later { Some(plane) } else { entry };
            }
            (false, true) => {
                let is_earlier = exit.is_none_or(|best| later(plane, best, work) == Ordering::Less);
                exit = if is_earlier { Some(plane) } else { exit };
            }
        }
    }
    if let (Some(entry), Some(exit)) = (entry, exit)
        && later(entry, exit, work) == Ordering::Greater
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
mod tests;
