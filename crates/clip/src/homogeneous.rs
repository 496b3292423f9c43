//! The view volume −w ≤ x, y, z ≤ w: clipping before the division by w.
//!
//! Behind the eye w is negative, and the division would turn what lies there in front of it. Clipped as homogeneous
//! points, segments and polygons may reach behind the eye or to infinity; what remains has w > 0. Attributes are
//! linear here, before the division, and no longer afterwards.

use core::cmp::Ordering;

use ombra_math::exact::Sum;
use ombra_math::glam::{DVec3, DVec4};
use ombra_math::work::{Count, Counter};

use crate::crossing::between;
use crate::sutherland_hodgman::clip_by_counted;

/// A plane of the view volume.
///
/// # Formula
///
/// ```text
/// left: w + x ≥ 0     below: w + y ≥ 0     near: w + z ≥ 0
/// right: w − x ≥ 0    above: w − y ≥ 0     far: w − z ≥ 0
/// ```
///
/// # References
///
/// CIS 781, «Standard glFrustum projection matrix» (OpenGL's clip space).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ViewPlane {
    /// x = −w.
    Left,
    /// x = w.
    Right,
    /// y = −w.
    Below,
    /// y = w.
    Above,
    /// z = −w.
    Near,
    /// z = w.
    Far,
}

impl ViewPlane {
    /// All six.
    pub const ALL: [Self; 6] = [
        Self::Near,
        Self::Far,
        Self::Left,
        Self::Right,
        Self::Below,
        Self::Above,
    ];

    /// The two numbers whose sum is positive inside: w and ± a coordinate.
    #[must_use]
    pub fn terms(self, p: DVec4) -> [f64; 2] {
        match self {
            Self::Left => [p.w, p.x],
            Self::Right => [p.w, -p.x],
            Self::Below => [p.w, p.y],
            Self::Above => [p.w, -p.y],
            Self::Near => [p.w, p.z],
            Self::Far => [p.w, -p.z],
        }
    }

    /// The sum of the terms, rounded; its sign is exact.
    fn side(self, p: DVec4) -> f64 {
        let [w, x] = self.terms(p);
        w + x
    }
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
/// - Ends inside are returned unchanged. Others are the nearest doubles, coordinate by coordinate, to the true crossing
///   (1 − t) A + t B, so they lie in the volume exactly, on their plane exactly, and clipping twice changes nothing.
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
    clip_segment_counted(segment, &mut ())
}

/// [`clip_segment`], counting its [work](crate#counted-work).
#[must_use]
pub fn clip_segment_counted([a, b]: [DVec4; 2], work: &mut impl Count) -> Option<[DVec4; 2]> {
    if !is_point(a) || !is_point(b) {
        return None;
    }
    let (mut entry, mut exit): (Option<ViewPlane>, Option<ViewPlane>) = (None, None);
    for plane in ViewPlane::ALL {
        work.add(Counter::Comparisons, 2);
        match (plane.side(a) < 0.0, plane.side(b) < 0.0) {
            (false, false) => {}
            (true, true) => return None,
            (true, false) => {
                let later = |best| order(plane, best, a, b, work) == Ordering::Greater;
                entry = if entry.is_none_or(later) {
                    Some(plane)
                } else {
                    entry
                };
            }
            (false, true) => {
                let earlier = |best| order(plane, best, a, b, work) == Ordering::Less;
                exit = if exit.is_none_or(earlier) {
                    Some(plane)
                } else {
                    exit
                };
            }
        }
    }
    if let (Some(entry), Some(exit)) = (entry, exit)
        && order(entry, exit, a, b, work) == Ordering::Greater
    {
        return None;
    }
    let mut cut = |plane: ViewPlane| {
        work.add(Counter::Divisions, 1);
        crossing(plane, a, b)
    };
    let clipped = [entry.map_or(a, &mut cut), exit.map_or(b, &mut cut)];
    match clipped.map(|p| p == DVec4::ZERO) {
        [false, false] => Some(clipped),
        [true, false] => Some([clipped[1]; 2]),
        [false, true] => Some([clipped[0]; 2]),
        [true, true] => None,
    }
}

fn is_point(p: DVec4) -> bool {
    p.is_finite() && p != DVec4::ZERO
}

/// The crossing of a b with a plane that has them on different sides.
fn crossing(plane: ViewPlane, a: DVec4, b: DVec4) -> DVec4 {
    let (sa, sb) = (plane.terms(a), plane.terms(b));
    let at = |k: usize| between(sa, sb, [a[k], b[k]]);
    DVec4::new(at(0), at(1), at(2), at(3))
}

/// Which of two planes, each with a and b on different sides, is met first on the way from a to b: exact.
fn order(p: ViewPlane, q: ViewPlane, a: DVec4, b: DVec4, work: &mut impl Count) -> Ordering {
    work.add(Counter::Multiplications, 2);
    work.add(Counter::Comparisons, 1);
    // t_p < t_q  ⇔  |s_p(a)| |s_q(b)| < |s_q(a)| |s_p(b)|
    let left = (p.side(a) * q.side(b)).abs();
    let right = (q.side(a) * p.side(b)).abs();
    let size = left.max(right);
    // Two roundings to a side, one to a product: 3ε of the larger, if nothing left the range.
    let in_range = size < f64::MAX && size > f64::MIN_POSITIVE / f64::EPSILON;
    if in_range && (left - right).abs() > 4.0 * f64::EPSILON * size {
        return if left < right {
            Ordering::Less
        } else {
            Ordering::Greater
        };
    }
    // |s| = −s where s(a) < 0 < s(b), and s(b) has the other sign than s(a).
    let sign = |plane: ViewPlane| if plane.side(a) < 0.0 { -1.0 } else { 1.0 };
    let mut sum = Sum::default();
    for (first, second, turned) in [(p, q, 1.0), (q, p, -1.0)] {
        for x in first.terms(a) {
            for y in second.terms(b) {
                sum.add([-turned * sign(p) * sign(q), x, y]);
            }
        }
    }
    sum.sign().unwrap_or(Ordering::Equal)
}

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
/// - Corners inside are returned unchanged and in order, others lie in the volume exactly; w > 0 everywhere. Clipping
///   twice changes nothing.
/// - Each crossing is made of nearest doubles to that of the edge it cuts. An edge that was cut before is the one between
///   rounded corners: up to six roundings add up.
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
    clip_polygon_counted(polygon, &mut ())
}

/// [`clip_polygon`], counting its [work](crate#counted-work).
#[must_use]
pub fn clip_polygon_counted<const N: usize>(
    polygon: &[Vertex<N>],
    work: &mut impl Count,
) -> Vec<Vertex<N>> {
    clip_polygon_to_counted(polygon, &ViewPlane::ALL, work)
}

/// The part of a polygon inside some of the planes: all but the far one for a projection to infinity, all but near and
/// far where depth is clamped.
///
/// # Properties
///
/// As for [`clip_polygon`], save that w > 0 only where the planes imply it: two opposite ones do.
#[must_use]
pub fn clip_polygon_to<const N: usize>(
    polygon: &[Vertex<N>],
    planes: &[ViewPlane],
) -> Vec<Vertex<N>> {
    clip_polygon_to_counted(polygon, planes, &mut ())
}

/// [`clip_polygon_to`], counting its [work](crate#counted-work).
#[must_use]
pub fn clip_polygon_to_counted<const N: usize>(
    polygon: &[Vertex<N>],
    planes: &[ViewPlane],
    work: &mut impl Count,
) -> Vec<Vertex<N>> {
    if polygon.len() < 3 || !polygon.iter().all(|v| is_point(v.position)) {
        return Vec::new();
    }
    let mut clipped = polygon.to_vec();
    for &plane in planes {
        // Most polygons lie on the inner side of most planes.
        let outside = clipped.iter().position(|v| plane.side(v.position) < 0.0);
        let inside = outside.unwrap_or(clipped.len());
        work.add(Counter::Comparisons, clipped.len().min(inside + 1) as u64);
        if inside == clipped.len() {
            work.add(Counter::Vertices, inside as u64);
            continue;
        }
        clipped = clip_by_counted(
            &clipped,
            |v| plane.side(v.position),
            |a, b, _, _| cut(plane, a, b),
            work,
        );
    }
    // An edge through (0, 0, 0, 0) leaves that, which is no point.
    clipped.retain(|v| v.position != DVec4::ZERO);
    clipped.dedup();
    while clipped.len() > 1 && clipped.first() == clipped.last() {
        clipped.pop();
    }
    if clipped.len() < 3 {
        clipped.clear();
    }
    clipped
}

fn cut<const N: usize>(plane: ViewPlane, a: Vertex<N>, b: Vertex<N>) -> Vertex<N> {
    let (sa, sb) = (plane.terms(a.position), plane.terms(b.position));
    let mut attributes = a.attributes;
    for (x, (&p, &q)) in attributes
        .iter_mut()
        .zip(a.attributes.iter().zip(&b.attributes))
    {
        *x = between(sa, sb, [p, q]);
    }
    Vertex {
        position: crossing(plane, a.position, b.position),
        attributes,
    }
}

#[cfg(test)]
mod tests;
