//! The view volume −w ≤ x, y, z ≤ w: clipping before the division by w.
//!
//! Behind the eye w is negative, and the division would turn what lies there in front of it. Clipped as homogeneous
//! points, segments and polygons may reach behind the eye or to infinity; what remains has w > 0. Attributes are
//! linear here, before the division, and no longer afterwards.
#![cfg_attr(doc, doc = "")]
#![cfg_attr(doc, doc = include_str!("../figures/w-zero.svg"))]
#![doc(alias = "clip space")]
#![doc(alias = "view frustum")]
#![doc(alias = "canonical view volume")]

use core::array;

use ombra_math::glam::{DVec3, DVec4};
use ombra_math::work::{Count, Counter};

use crate::crossing::between;
use crate::interval::Interval;
use crate::outline::closed;
use crate::sutherland_hodgman::clip_by_plain;

mod fast;
mod plane;

pub use plane::ViewPlane;
use plane::order;

/// A corner of a polygon before the division by w: where it is, and numbers that are linear over the polygon (colour,
/// texture coordinates, a normal).
///
/// # References
///
/// CIS 781, «Avoiding far plane clipping».
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vertex<const N: usize> {
    /// The homogeneous point.
    pub position: DVec4,
    /// What is interpolated along.
    pub attributes: [f64; N],
}

/// [`clip_segment`] with its loop, counting its [work](crate#counted-work).
///
/// # Properties
///
/// - Error: none: each coordinate is the double nearest to that of the exact crossing.
///
/// # References
///
/// As for [`clip_segment`].
#[must_use]
pub fn clip_segment_plain([a, b]: [DVec4; 2], work: &mut impl Count) -> Option<[DVec4; 2]> {
    if !is_point(a) || !is_point(b) {
        return None;
    }
    // Against each plane: s_A < 0 enters there, s_B < 0 leaves there; of both nothing is left.
    let mut left = Interval::WHOLE;
    for plane in ViewPlane::ALL {
        work.add(Counter::Comparisons, 2);
        let beyond = [plane.side(a) < 0.0, plane.side(b) < 0.0];
        left.cut(plane, beyond, |k, best| order([k, best], [a, b], work))?;
    }
    // From the latest entry to the earliest exit.
    let clipped = left.ends(
        [a, b],
        |entry, exit, work| order([entry, exit], [a, b], work),
        |plane, work| {
            work.add(Counter::Divisions, 1);
            crossing(plane, a, b)
        },
        work,
    )?;
    // Through (0, 0, 0, 0), which is no point, only the other end is left.
    match clipped.map(|p| p == DVec4::ZERO) {
        [false, false] => Some(clipped),
        [true, false] => Some([clipped[1]; 2]),
        [false, true] => Some([clipped[0]; 2]),
        [true, true] => None,
    }
}

/// [`clip_polygon_to`], one pass of Sutherland and Hodgman a plane, counting its [work](crate#counted-work).
///
/// # Properties
///
/// - The same result, bit for bit.
/// - Error: none but that each number of a crossing is the double nearest to that of the edge it cuts.
///
/// # References
///
/// As for [`clip_polygon`].
#[must_use]
pub fn clip_polygon_to_plain<const N: usize>(
    polygon: &[Vertex<N>],
    planes: &[ViewPlane],
    work: &mut impl Count,
) -> Vec<Vertex<N>> {
    if polygon.len() < 3 || !polygon.iter().all(|v| is_point(v.position)) {
        return Vec::new();
    }
    let mut clipped = polygon.to_vec();
    for &plane in planes {
        let side = |v: Vertex<N>| plane.side(v.position);
        clipped = clip_by_plain(&clipped, side, |a, b, _, _| cut(plane, a, b), work);
    }
    settled(clipped)
}

fn is_point(p: DVec4) -> bool {
    p.is_finite() && p != DVec4::ZERO
}

/// The crossing of a b with a plane that has them on different sides.
fn crossing(plane: ViewPlane, a: DVec4, b: DVec4) -> DVec4 {
    let (sa, sb) = (plane.terms(a), plane.terms(b));
    DVec4::from_array([0, 1, 2, 3].map(|k| between(sa, sb, [a[k], b[k]])))
}

fn cut<const N: usize>(plane: ViewPlane, a: Vertex<N>, b: Vertex<N>) -> Vertex<N> {
    let (sa, sb) = (plane.terms(a.position), plane.terms(b.position));
    let (p, q) = (a.attributes, b.attributes);
    Vertex {
        position: crossing(plane, a.position, b.position),
        attributes: array::from_fn(|k| between(sa, sb, [p[k], q[k]])),
    }
}

/// Without corners at (0, 0, 0, 0), which an edge through that leaves and which is no point, and without repeated ones.
fn settled<const N: usize>(mut polygon: Vec<Vertex<N>>) -> Vec<Vertex<N>> {
    polygon.retain(|v| v.position != DVec4::ZERO);
    polygon.dedup();
    closed(polygon)
}

/// Whether a homogeneous point lies in the view volume, border included.
///
/// # Formula
///
/// ```text
/// −w ≤ x ≤ w      −w ≤ y ≤ w      −w ≤ z ≤ w
/// ```
///
/// # Properties
///
/// Then w > 0: (0, 0, 0, 0) is no point, and a NaN lies nowhere.
#[must_use]
pub fn contains(p: DVec4) -> bool {
    p.w > 0.0 && p.truncate().abs().cmple(DVec3::splat(p.w)).all()
}

/// The part of a segment in the view volume, or `None` if there is none.
///
/// # Formula
///
/// ```text
/// P(t) = (1 − t) A + t B       s = w ± x, w ± y, w ± z       t = s_A / (s_A − s_B)
/// ```
///
/// # Properties
///
/// - Error: none: each coordinate is the double nearest to that of the exact crossing (1 − t) A + t B.
/// - Ends inside are returned unchanged; others lie in the volume exactly, on their plane exactly, and clipping twice
///   changes nothing.
/// - Whether anything remains is decided exactly. Results have w > 0 and can be divided by it.
/// - The points between A and B are those of (1 − t) A + t B: with w of both signs that is the segment through infinity,
///   of which the part in front of the eye remains.
/// - A segment through (0, 0, 0, 0), from a point to its opposite, is a single place: it is given twice.
/// - `None` if an end is that zero vector, or not finite.
///
/// # Pitfalls
///
/// After the division the middle of the clipped segment is not the middle of its picture: interpolate before.
///
/// # Examples
///
/// ```
/// use ombra_clip::homogeneous::clip_segment;
/// use ombra_math::glam::DVec4;
///
/// // From the middle of the picture to a point behind the eye.
/// let (a, b) = (DVec4::new(0.0, 0.0, 1.0, 2.0), DVec4::new(0.0, 4.0, -4.0, -2.0));
/// let [near_end, far_end] = clip_segment([a, b]).unwrap();
/// assert_eq!(near_end, a);
/// assert_eq!(far_end, DVec4::new(0.0, 1.0, -0.25, 1.0)); // t = 1/4, on y = w
/// ```
///
/// # References
///
/// CIS 781, «Avoiding far plane clipping», «Verifying P_inf will not clip infinitely far away vertices». J. F. Blinn,
/// M. E. Newell, «Clipping using homogeneous coordinates», 1978.
#[must_use]
pub fn clip_segment(segment: [DVec4; 2]) -> Option<[DVec4; 2]> {
    clip_segment_plain(segment, &mut ())
}

/// The part of a polygon in the view volume, attributes carried along.
///
/// # Formula
///
/// ```text
/// against each plane:   inside s ≥ 0,   s = w ± x, w ± y, w ± z
/// crossing:   P = (s_A B − s_B A) / (s_A − s_B),   and so each attribute
/// ```
///
/// # Properties
///
/// - Error: none but that each number of a crossing is the double nearest to that of the edge it cuts.
/// - An edge that was cut before is the one between rounded corners: up to six roundings add up.
/// - Corners inside are returned unchanged and in order, others lie in the volume exactly; w > 0 everywhere. Clipping
///   twice changes nothing.
/// - A shared edge gives the same crossing in both polygons: no cracks.
/// - No corner stands twice in a row, unless its attributes differ.
/// - Empty for fewer than three corners, a polygon that only touches, one with a position that is not finite or zero.
///
/// # Pitfalls
///
/// Dividing first, and clipping the picture, keeps triangles that reach behind the eye, turned inside out. A concave
/// polygon that falls apart comes out in one, as from [`clip_by`](crate::sutherland_hodgman::clip_by).
///
/// # Examples
///
/// A triangle with one corner behind the eye:
///
/// ```
/// use ombra_clip::homogeneous::{Vertex, clip_polygon};
/// use ombra_math::glam::DVec4;
///
/// let corner = |x, y, z, w, shade| Vertex { position: DVec4::new(x, y, z, w), attributes: [shade] };
/// let triangle = [
///     corner(-1.0, 0.0, 0.0, 2.0, 0.0),
///     corner(1.0, 0.0, 0.0, 2.0, 0.0),
///     corner(0.0, 0.0, -4.0, -2.0, 1.0),
/// ];
/// let front = clip_polygon(&triangle);
/// assert_eq!(front.len(), 4);
/// // Two new corners, each a quarter of the way along, on the near plane.
/// let new: Vec<_> = front.iter().filter(|v| v.attributes == [0.25]).collect();
/// assert!(new.len() == 2 && new.iter().all(|v| v.position.z == -v.position.w));
/// ```
///
/// # References
///
/// CIS 781, «Avoiding far plane clipping»; Grafica 3, «Clipping di un poligono». Blinn and Newell, as for
/// [`clip_segment`].
#[must_use]
pub fn clip_polygon<const N: usize>(polygon: &[Vertex<N>]) -> Vec<Vertex<N>> {
    fast::clip_polygon(polygon, &mut ())
}

/// The part of a polygon inside some of the planes: all but the far one for a projection to infinity, all but near and
/// far where depth is clamped.
///
/// # Properties
///
/// - Error: none but that each number of a crossing is the double nearest to that of the edge it cuts.
/// - As for [`clip_polygon`], save that w > 0 only where the planes imply it: two opposite ones do.
#[doc(alias = "guard band")]
#[must_use]
pub fn clip_polygon_to<const N: usize>(
    polygon: &[Vertex<N>],
    planes: &[ViewPlane],
) -> Vec<Vertex<N>> {
    fast::clip_polygon_to(polygon, planes, &mut ())
}

/// Each gives the same answer as the function of its name and counts its [work](crate#counted-work), which comes last.
pub mod counted {
    pub use super::clip_segment_plain as clip_segment;
    pub use super::fast::{clip_polygon, clip_polygon_to};
}

#[cfg(test)]
mod tests;
