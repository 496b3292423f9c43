//! Two primitives along the sight lines they share: one hides the other, both are visible, or they cross.
//!
//! Seen from the eye a convex polygon is a convex cone, or a prism in a parallel view. Everything the object-space
//! methods ask about two polygons is the sign of a determinant: do their cones overlap, and who is nearer there?
#![doc(alias = "occlusion")]

use core::cmp::Ordering;

use ombra_math::glam::{DVec3, DVec4};
use ombra_math::predicates::orient_3d;

use crate::polygon::Polygon;

mod bound;
mod cut_plane;
mod eye;
mod outline;
mod rings;
mod seen;

pub use cut_plane::CutPlane;
pub(crate) use eye::Eye;
pub(crate) use outline::convex;
pub(crate) use rings::rings;
pub use seen::Seen;

/// How two polygons lie along the sight lines that meet the inside of both.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Pair {
    /// No sight line meets the inside of both (they may touch): both are visible, in any order.
    Apart,
    /// The first hides some of the second, and nowhere the other way round.
    FirstNearer,
    /// The second hides some of the first, and nowhere the other way round.
    SecondNearer,
    /// Each hides some of the other: they cross.
    Crossing,
    /// They share sight lines and lie at the same depth on all of them.
    Coplanar,
}

impl Pair {
    /// The same pair, with the second called the first.
    #[must_use]
    pub const fn swapped(self) -> Self {
        match self {
            Self::FirstNearer => Self::SecondNearer,
            Self::SecondNearer => Self::FirstNearer,
            same => same,
        }
    }

    /// Whether the first, submitted before the second, hides some of it: of equal depths the first is seen.
    pub(crate) fn first_hides(self) -> bool {
        matches!(self, Self::FirstNearer | Self::Crossing | Self::Coplanar)
    }

    /// Whether the second, submitted after the first, hides some of it.
    pub(crate) fn second_hides(self) -> bool {
        matches!(self, Self::SecondNearer | Self::Crossing)
    }
}

/// How `first` and `second` lie as seen from `eye`: w ≠ 0 a place, w = 0 the direction towards the viewer.
///
/// # Formula
///
/// ```text
/// apart:   all of Q on or outside one plane through the eye and an edge of P,
///          or the other way round
/// nearer:  where the cones overlap, P on the eye's side of the plane of Q
/// ```
///
/// # Properties
///
/// - Whether they are apart is decided exactly, so polygons that share edges or corners are.
/// - Who is nearer is decided exactly as well, but what is no farther than [`tolerance`] from the other's plane counts
///   as in it: equally deep.
/// - From a place, sight lines are rays in all directions: what lies behind a camera's back counts, and hides nothing
///   in front of it. In a parallel view they are whole lines.
/// - A polygon whose plane holds the eye is an edge: not seen, and hiding nothing. It is [`Pair::Apart`] from all
///   others; so is everything without an eye (0, NaN, ∞, a place beyond the largest double) and what is no polygon.
/// - Exchanging the two exchanges the answer.
///
/// # Pitfalls
///
/// Distance from the eye does not tell: a large floor may have its middle nearer to the eye than a box that stands on
/// it far away and hides a part of it.
///
/// Equal depth within a tolerance is not transitive. Of three sheets, each within it of the next but the first not of
/// the third, the outer two are told apart and neither is from the middle one.
///
/// For many pairs make each [`Seen`] once and use [`compare_seen`].
///
/// # Examples
///
/// ```
/// use ombra_hsr::pair::{Pair, compare};
/// use ombra_hsr::polygon::Polygon;
/// use ombra_math::glam::{DVec3, DVec4};
///
/// let square = |x: f64, z: f64| {
///     let corners = [(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)];
///     Polygon::new(corners.map(|(i, j)| DVec3::new(x + i, j, z)).to_vec()).unwrap()
/// };
/// let (above, place) = (DVec4::Z, DVec4::new(3.0, 1.0, 4.0, 1.0));
/// assert_eq!(compare(&square(0.0, 0.0), &square(1.0, 1.0), above), Pair::SecondNearer);
/// assert_eq!(compare(&square(0.0, 0.0), &square(2.0, 1.0), above), Pair::Apart); // they touch
/// assert_eq!(compare(&square(0.0, 0.0), &square(2.0, 1.0), place), Pair::SecondNearer);
/// ```
///
/// # References
///
/// Grafica 3, «Approccio Object-Space»: A hides B, both are visible, A hides a part of B.
#[must_use]
pub fn compare(first: &Polygon, second: &Polygon, eye: DVec4) -> Pair {
    match (Seen::new(first, eye), Seen::new(second, eye)) {
        (Some(first), Some(second)) => compare_seen(&first, &second),
        _ => Pair::Apart,
    }
}

/// [`compare`] for two polygons seen from the same eye; from different eyes the answer has no meaning.
#[must_use]
pub fn compare_seen(p: &Seen, q: &Seen) -> Pair {
    // One outline twice shares every sight line: nothing to look for.
    let is_twice = p.vertices.len() > 2 && p.vertices == q.vertices;
    let far_apart = || p.bound.apart(&q.bound, p.scale.max(q.scale));
    if !is_twice && (far_apart() || apart(p, q)) {
        return Pair::Apart;
    }
    // All of one on one side of the other's plane?
    let (of_p, of_q) = (q.depths_of(p), p.depths_of(q).swapped());
    match (of_p.verdict(), of_q.verdict()) {
        (Pair::Coplanar, _) | (_, Pair::Coplanar) => Pair::Coplanar,
        (Pair::Crossing, Pair::Crossing) => overlap(p, q).verdict(),
        (Pair::Crossing, told) | (told, Pair::Crossing) => told,
        (told, same) if told == same => told,
        // Depths about the tolerance: near enough for one, not for the other.
        _ => overlap(p, q).verdict(),
    }
}

/// The distance from a polygon's plane up to which another one counts as equally near, for the larger of their
/// [`Seen::scale`]s.
///
/// # Formula
///
/// ```text
/// δ = 64 ε · largest coordinate of either + 32 · smallest double
/// ```
///
/// # Properties
///
/// - Error: ½ ε · δ
/// - That is the rounding of coordinates: turned and moved, a wall still stands on its floor only as far as its
///   coordinates can tell. Distances of a [`CutPlane`] are right within half of it, vertices made by cutting to a few ε
///   a cut. It is measured across the plane: along a sight line that grazes the plane it is more.
/// - The second term counts below 10⁻²⁹² only, where doubles lose their digits.
#[must_use]
pub fn tolerance(scale: f64) -> f64 {
    64.0 * f64::EPSILON * scale + 32.0 * SMALLEST
}

/// 2⁻¹⁰⁷⁴: what products below the normal doubles are rounded to.
const SMALLEST: f64 = f64::from_bits(1);

/// Whether somewhere the one is nearer, or farther, than the other.
#[derive(Clone, Copy, Default)]
struct Depths {
    nearer: bool,
    farther: bool,
}

impl Depths {
    fn add(&mut self, nearness: Ordering) {
        self.nearer |= nearness == Ordering::Greater;
        self.farther |= nearness == Ordering::Less;
    }

    fn swapped(self) -> Self {
        Self {
            nearer: self.farther,
            farther: self.nearer,
        }
    }

    /// What these depths of the first make of two polygons that share sight lines.
    fn verdict(self) -> Pair {
        match (self.nearer, self.farther) {
            (false, false) => Pair::Coplanar,
            (true, false) => Pair::FirstNearer,
            (false, true) => Pair::SecondNearer,
            (true, true) => Pair::Crossing,
        }
    }
}

/// Whether a plane through the eye has one cone on each side.
fn apart(p: &Seen, q: &Seen) -> bool {
    p.has_side_before(q) || q.has_side_before(p) || apart_behind(p, q)
}

/// Whether two cones are apart that do not fit into one half-space, as one lies behind the eye.
///
/// A plane between them can be turned until it touches two corners: an edge of one of them, or one corner of each. In
/// one half-space an edge can always be reached.
fn apart_behind(p: &Seen, q: &Seen) -> bool {
    let Eye::Place(eye) = p.eye else {
        return false;
    };
    // In one half-space an edge would have told.
    if p.is_ahead(eye, q) || q.is_ahead(eye, p) {
        return false;
    }
    let sides = |a, b, of: &Seen| {
        let mut sides = Depths::default();
        for &v in &of.vertices {
            sides.add(p.eye.turn(a, b, v).unwrap_or(Ordering::Equal));
        }
        sides
    };
    p.vertices.iter().any(|&a| {
        q.vertices.iter().any(|&b| {
            let (of_p, of_q) = (sides(a, b, p), sides(a, b, q));
            // In line with the eye the two corners have no plane, and nothing lies beside it.
            (of_p.nearer && !of_p.farther && !of_q.nearer)
                || (of_p.farther && !of_p.nearer && !of_q.farther)
        })
    })
}

/// Who is nearer where they are not apart.
///
/// The difference in depth changes its sign across a plane through the eye, so the corners of the region seen through
/// both tell: corners of one inside the other, and edges that cross.
fn overlap(p: &Seen, q: &Seen) -> Depths {
    let tolerance = tolerance(p.scale.max(q.scale));
    let mut depths = Depths::default();
    for &v in p.vertices.iter().filter(|&&v| q.covers(v)) {
        depths.add(q.nearness(v, tolerance));
    }
    for &v in q.vertices.iter().filter(|&&v| p.covers(v)) {
        depths.add(p.nearness(v, tolerance).reverse());
    }
    for edge in &p.edges {
        for other in &q.edges {
            let [[a, b], [c, d]] = [edge.ends, other.ends];
            let (of_c, of_d) = (p.turn(edge, c), p.turn(edge, d));
            let (of_a, of_b) = (q.turn(other, a), q.turn(other, b));
            // On opposite sides of each other, and not behind the eye.
            let strictly = of_c != Ordering::Equal && of_a != Ordering::Equal;
            if strictly && of_c == of_d.reverse() && of_a == of_b.reverse() && of_d == of_a {
                depths.add(above([a, b], [c, d], of_d, tolerance));
            }
        }
    }
    depths
}

/// Of two segments that cross as seen, whether the first passes in front of the second; `turn` is how the end of the
/// second lies from the first.
fn above([a, b]: [DVec3; 2], [c, d]: [DVec3; 2], turn: Ordering, tolerance: f64) -> Ordering {
    // Their common normal. It points to the eye where the second turns to the left of the first.
    let across = CutPlane::along(a, [0.5 * b - 0.5 * a, 0.5 * d - 0.5 * c]);
    if across.is_none_or(|across| across.distance(c).abs() <= tolerance) {
        return Ordering::Equal;
    }
    // (AB × CD)·AC = −(AB × AC)·AD.
    let volume = orient_3d(a, b, c, d).unwrap_or(Ordering::Equal);
    if turn == Ordering::Greater {
        volume
    } else {
        volume.reverse()
    }
}

#[cfg(test)]
mod oracle;
#[cfg(test)]
mod tests;
