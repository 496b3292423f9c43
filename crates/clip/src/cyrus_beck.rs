//! Cyrus–Beck: a segment against a convex polygon or polyhedron of any number of sides.
//!
//! Each side is a line or plane with an inside. A segment that starts beyond it enters there, one that ends beyond it
//! leaves there; what remains runs from the latest entry to the earliest exit.
#![cfg_attr(doc, doc = "")]
#![cfg_attr(doc, doc = include_str!("../figures/cyrus-beck.svg"))]
#![doc(alias = "convex clipping")]

use core::cmp::Ordering;

use ombra_math::glam::{DVec2, DVec3};
use ombra_math::plane::Plane;
use ombra_math::predicates::orient_2d;
use ombra_math::work::{Count, Counter};

use crate::crossing::between_products;
use crate::interval::Interval;
use crate::outline::{edges, is_finite};
use crate::segment::Segment;

use order::{order, order_exactly, products};

mod fast;
mod order;

/// [`clip_segment`] as the paper tells it, counting its [work](crate#counted-work).
///
/// # Properties
///
/// - The same result, bit for bit, while coordinates are 0 or between 2⁻²⁵⁰ and 2²⁵⁰ in size; beyond that, entries and
///   exits may be taken for one another.
/// - Error: none: each coordinate is the double nearest to that of the exact crossing with a side.
///
/// # References
///
/// As for [`clip_segment`].
#[must_use]
pub fn clip_segment_plain(
    convex: &[DVec2],
    segment: Segment,
    work: &mut impl Count,
) -> Option<Segment> {
    let Segment { a, b } = segment;
    if !segment.is_finite() || !is_finite(convex) {
        return None;
    }
    let outside = turn(convex, work)?.reverse();
    let mut left = Interval::WHOLE;
    for side in edges(convex) {
        // N·D > 0 and A beyond the side: it enters there. N·D < 0 and B beyond it: it leaves there.
        let beyond = [a, b].map(|x| orientation(side, x, work) == Some(outside));
        // The latest entry and the earliest exit: t against t.
        left.cut(side, beyond, |k, best| {
            order_of_sides([k, best], segment, outside, work)
        })?;
    }
    // Nothing is left of what leaves before it enters.
    let [a, b] = left.ends(
        [a, b],
        |entry, exit, work| order_of_sides([entry, exit], segment, outside, work),
        |side, work| crossing(segment, side, work),
        work,
    )?;
    Some(Segment { a, b })
}

/// [`clip_segment_3d`] with its loop, counting its [work](crate#counted-work).
///
/// # Properties
///
/// - Error: none: each coordinate is the double nearest to that of the exact crossing with a plane.
///
/// # References
///
/// As for [`clip_segment`].
#[must_use]
pub fn clip_segment_3d_plain(
    planes: &[Plane],
    [a, b]: [DVec3; 2],
    work: &mut impl Count,
) -> Option<[DVec3; 2]> {
    if !a.is_finite() || !b.is_finite() {
        return None;
    }
    let later = |p: &Plane, q: &Plane, work: &mut _| {
        Count::add(work, Counter::Multiplications, 2);
        Count::add(work, Counter::Comparisons, 1);
        order(p, q, a, b)
    };
    let mut left = Interval::WHOLE;
    for plane in planes {
        // s(A) < 0 enters there, s(B) < 0 leaves there; of both nothing is left.
        work.add(Counter::Multiplications, 6);
        work.add(Counter::Comparisons, 2);
        let beyond = [
            plane.side(a)? == Ordering::Less,
            plane.side(b)? == Ordering::Less,
        ];
        left.cut(plane, beyond, |k, best| later(k, best, work))?;
    }
    left.ends(
        [a, b],
        later,
        |plane, work| {
            work.add(Counter::Divisions, 1);
            let (sa, sb) = (products(plane, a), products(plane, b));
            DVec3::from_array([0, 1, 2].map(|k| between_products(&sa, &sb, [a[k], b[k]])))
        },
        work,
    )
}

/// A side of a polygon, from P to Q.
type Edge = (DVec2, DVec2);

/// How a convex polygon turns; `None` without area.
fn turn(convex: &[DVec2], work: &mut impl Count) -> Option<Ordering> {
    let next = convex.iter().cycle().skip(1);
    let after = convex.iter().cycle().skip(2);
    convex
        .iter()
        .zip(next.zip(after))
        .filter_map(|(&a, (&b, &c))| orientation((a, b), c, work))
        .find(|&turn| turn != Ordering::Equal)
}

/// On which side of an edge the point x lies.
fn orientation((p, q): Edge, x: DVec2, work: &mut impl Count) -> Option<Ordering> {
    work.add(Counter::Multiplications, 2);
    work.add(Counter::Comparisons, 1);
    orient_2d(p, q, x)
}

/// (Q − P) × (X − P), multiplied out.
fn distance((p, q): Edge, x: DVec2) -> [[f64; 2]; 6] {
    [
        [p.x, q.y],
        [-p.y, q.x],
        [q.x, x.y],
        [-q.y, x.x],
        [x.x, p.y],
        [-x.y, p.x],
    ]
}

/// Which of two edges, each with a and b on different sides, is met first on the way from a to b.
fn order_of_sides(
    edges: [Edge; 2],
    Segment { a, b }: Segment,
    outside: Ordering,
    work: &mut impl Count,
) -> Ordering {
    work.add(Counter::Multiplications, 2);
    work.add(Counter::Comparisons, 1);
    let enters = edges.map(|(p, q)| orient_2d(p, q, a) == Some(outside));
    order_exactly(edges.map(|edge| [a, b].map(|x| distance(edge, x))), enters)
}

/// Where the segment crosses the line of an edge.
fn crossing(Segment { a, b }: Segment, edge: Edge, work: &mut impl Count) -> DVec2 {
    work.add(Counter::Divisions, 1);
    let (sa, sb) = (distance(edge, a), distance(edge, b));
    [0, 1]
        .map(|k| between_products(&sa, &sb, [a[k], b[k]]))
        .into()
}

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
/// - Error: none: each coordinate is the double nearest to the exact one.
/// - Ends inside are returned unchanged; direction is kept. With the corners of a window the answer is that of the other
///   methods, bit for bit.
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
    fast::clip_segment(convex, segment, &mut ())
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
/// - Error: none: each coordinate is the double nearest to that of the exact crossing with a plane.
/// - Ends inside are returned unchanged; direction is kept, beyond those sizes to that 8ε.
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
    clip_segment_3d_plain(planes, segment, &mut ())
}

/// Each gives the same answer as the function of its name and counts its [work](crate#counted-work), which comes last.
pub mod counted {
    pub use super::clip_segment_3d_plain as clip_segment_3d;
    pub use super::fast::clip_segment;
}

#[cfg(test)]
mod tests;
