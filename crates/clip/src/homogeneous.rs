//! The view volume −w ≤ x, y, z ≤ w: clipping before the division by w.
//!
//! Behind the eye w is negative, and the division would turn what lies there in front of it. Clipped as homogeneous
//! points, segments and polygons may reach behind the eye or to infinity; what remains has w > 0. Attributes are
//! linear here, before the division, and no longer afterwards.

use core::cmp::Ordering;

use ombra_math::exact::Sum;
use ombra_math::glam::{DVec3, DVec4};

use crate::crossing::between;
use crate::sutherland_hodgman::clip_by;

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
    let [a, b] = segment;
    if !is_point(a) || !is_point(b) {
        return None;
    }
    let (mut entry, mut exit): (Option<ViewPlane>, Option<ViewPlane>) = (None, None);
    for plane in ViewPlane::ALL {
        match (plane.side(a) < 0.0, plane.side(b) < 0.0) {
            (false, false) => {}
            (true, true) => return None,
            (true, false) => {
                let later = |best| order(plane, best, a, b) == Ordering::Greater;
                entry = if entry.is_none_or(later) {
                    Some(plane)
                } else {
                    entry
                };
            }
            (false, true) => {
                let earlier = |best| order(plane, best, a, b) == Ordering::Less;
                exit = if exit.is_none_or(earlier) {
                    Some(plane)
                } else {
                    exit
                };
            }
        }
    }
    if let (Some(entry), Some(exit)) = (entry, exit)
        && order(entry, exit, a, b) == Ordering::Greater
    {
        return None;
    }
    let cut = |plane: ViewPlane| crossing(plane, a, b);
    let clipped = [entry.map_or(a, cut), exit.map_or(b, cut)];
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
fn order(p: ViewPlane, q: ViewPlane, a: DVec4, b: DVec4) -> Ordering {
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
/// - Empty for fewer than three corners, a polygon that only touches, one with a position that is not finite or zero.
///
/// # Pitfalls
///
/// Dividing first, and clipping the picture, keeps triangles that reach behind the eye, turned inside out. A concave
/// polygon that falls apart comes out in one, as from [`clip_by`].
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
    clip_polygon_to(polygon, &ViewPlane::ALL)
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
    if polygon.len() < 3 || !polygon.iter().all(|v| is_point(v.position)) {
        return Vec::new();
    }
    let mut clipped = polygon.to_vec();
    for &plane in planes {
        // Most polygons lie on the inner side of most planes.
        if clipped.iter().all(|v| plane.side(v.position) >= 0.0) {
            continue;
        }
        clipped = clip_by(
            &clipped,
            |v| plane.side(v.position),
            |a, b, _, _| cut(plane, a, b),
        );
    }
    // An edge through (0, 0, 0, 0) leaves that, which is no point.
    clipped.retain(|v| v.position != DVec4::ZERO);
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
mod tests {
    use super::*;
    use crate::oracle::{self, R, beside, int, is_nearest, number, r};
    use ombra_math::glam::DVec3;
    use ombra_math::view::frustum;
    use proptest::prelude::*;

    fn v(x: f64, y: f64, z: f64, w: f64) -> DVec4 {
        DVec4::new(x, y, z, w)
    }

    #[test]
    fn a_segment_that_passes_the_eye() {
        // Seen by an eye at the origin: from 10 in front, 5 above the axis, to 10 behind. Near plane at 1, far at 100.
        let view = frustum(-1.0, 1.0, -1.0, 1.0, 1.0, 100.0).unwrap();
        let ends = [DVec3::new(0.0, 5.0, -10.0), DVec3::new(0.0, -5.0, 10.0)];
        let [a, b] = ends.map(|p| view * p.extend(1.0));
        assert!(a.w > 0.0 && b.w < 0.0);
        let [c, d] = clip_segment([a, b]).unwrap();
        assert_eq!(c, a);
        assert_eq!(d.z, -d.w);
        // Through the eye itself, all of it projects to one point of the picture.
        assert!((d.y / d.w - a.y / a.w).abs() <= 4.0 * f64::EPSILON);
        // The vertex infinitely far away, (0, 0, −D, 0), in a projection to infinity is on the far plane, not beyond.
        let view = ombra_math::view::frustum_infinite(-1.0, 1.0, -1.0, 1.0, 1.0).unwrap();
        let infinite = view * v(0.0, 0.0, -3.0, 0.0);
        assert!(contains(infinite) && infinite.z == infinite.w);
    }

    #[test]
    fn degenerate() {
        let (o, huge) = (v(0.0, 0.0, 0.0, 1.0), f64::MAX);
        let corner = v(1.0, 1.0, 1.0, 1.0);
        let cases = [
            ([o, o], Some([o, o])),
            ([corner, corner], Some([corner, corner])),
            ([-o, -o], None),
            ([DVec4::ZERO, o], None),
            // From a place to its opposite: all one place.
            ([o, -o], Some([o, o])),
            ([v(3.0, 0.0, 0.0, 1.0), v(-3.0, 0.0, 0.0, -1.0)], None),
            // To a point at infinity, from one at infinity.
            ([o, v(1.0, 0.0, 0.0, 0.0)], Some([o, v(0.5, 0.0, 0.0, 0.5)])),
            ([v(1.0, 0.0, 0.0, 0.0), v(-1.0, 0.0, 0.0, 0.0)], None),
            // Through an edge of the volume; past it by one double.
            (
                [v(0.0, 2.0, 0.0, 1.0), v(2.0, 0.0, 0.0, 1.0)],
                Some([v(1.0, 1.0, 0.0, 1.0); 2]),
            ),
            (
                [v(0.0, 2.0, 0.0, 1.0), v(2.0, f64::EPSILON, 0.0, 1.0)],
                None,
            ),
            (
                [v(-huge, 0.0, 0.0, 1.0), v(huge, 0.0, 0.0, 1.0)],
                Some([v(-1.0, 0.0, 0.0, 1.0), v(1.0, 0.0, 0.0, 1.0)]),
            ),
        ];
        for (s, expected) in cases {
            assert_eq!(clip_segment(s), expected, "{s:?}");
        }
        let with = |position| Vertex {
            position,
            attributes: [],
        };
        let triangle = [
            v(0.0, 0.0, 0.0, 1.0),
            v(1.0, 0.0, 0.0, 1.0),
            v(0.0, 1.0, 0.0, 1.0),
        ]
        .map(with);
        assert_eq!(clip_polygon(&triangle), triangle);
        assert_eq!(clip_polygon(&triangle[..2]), []);
        assert_eq!(clip_polygon::<3>(&[]), []);
        // It touches the volume along an edge.
        let beside = [
            v(1.0, 0.0, 0.0, 1.0),
            v(2.0, 0.0, 0.0, 1.0),
            v(1.0, 1.0, 0.0, 1.0),
        ]
        .map(with);
        assert_eq!(clip_polygon(&beside), []);
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert_eq!(clip_segment([o, v(0.0, 0.0, 0.0, bad)]), None);
            assert_eq!(clip_segment([v(bad, 0.0, 0.0, 1.0), o]), None);
            assert!(!contains(v(bad, 0.0, 0.0, 1.0)));
            assert_eq!(
                clip_polygon(&[triangle[0], triangle[1], with(v(bad, 0.0, 0.0, 1.0))]),
                []
            );
        }
        assert_eq!(
            clip_polygon(&[triangle[0], triangle[1], with(DVec4::ZERO)]),
            []
        );
        assert!(contains(o) && !contains(DVec4::ZERO) && !contains(-o));
    }

    /// Coordinates that often put a point on a plane, or next to one.
    fn position() -> impl Strategy<Value = DVec4> {
        let w = prop_oneof![Just(1.0), Just(-1.0), Just(0.0), -4.0..4.0f64, number()];
        let of_w = prop::array::uniform3((0u8..6, number(), -2i64..3));
        (w, of_w).prop_map(|(w, of_w)| {
            let [x, y, z] = of_w.map(|(kind, x, i)| match kind {
                0 => beside(w, i),
                1 => -beside(w, i),
                2 => beside(2.0 * w, i),
                _ => x,
            });
            let p = DVec4::new(x, y, z, w);
            if p.is_finite() { p } else { DVec4::W }
        })
    }

    fn sides(a: DVec4, b: DVec4) -> Vec<[R; 2]> {
        let of = |p: DVec4| -> Vec<R> {
            let w = r(p.w);
            [p.x, p.y, p.z]
                .into_iter()
                .flat_map(|x| [&w - r(x), &w + r(x)])
                .collect()
        };
        of(a).into_iter().zip(of(b)).map(|(s, e)| [s, e]).collect()
    }

    fn vertex() -> impl Strategy<Value = Vertex<2>> {
        (prop::array::uniform4(-6i32..7), 0i32..9, 0i32..9).prop_map(|(p, s, t)| Vertex {
            position: DVec4::from(p.map(f64::from)),
            attributes: [s.into(), t.into()],
        })
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(3000))]

        #[test]
        fn segments_are_nearest_doubles(a in position(), b in position(), through in prop::array::uniform3(-1i32..2), i in -2i64..3, kind in 0u8..3) {
            // Two times in three through a corner, an edge or a face of the volume, or next to that.
            let [x, y, z] = through.map(f64::from);
            let beyond = DVec4::new(x, y, z, 1.0) * 2.0 - a;
            let beyond = DVec4::new(beside(beyond.x, i), beyond.y, beyond.z, beyond.w);
            let b = if kind > 0 && beyond.is_finite() { beyond } else { b };
            let expected = oracle::interval(&sides(a, b));
            let clipped = clip_segment([a, b]);
            let Some(t) = expected else {
                prop_assert_eq!(clipped, None);
                return Ok(());
            };
            let ends = t.map(|t| [0, 1, 2, 3].map(|k| oracle::at(&t, a[k], b[k])));
            let zero = |p: &[R; 4]| p.iter().all(|x| *x == int(0));
            let Some(clipped) = clipped else {
                // Only (0, 0, 0, 0) is left.
                prop_assert!((zero(&ends[0]) && zero(&ends[1])) || a == DVec4::ZERO || b == DVec4::ZERO);
                return Ok(());
            };
            for (p, end) in clipped.iter().zip(&ends) {
                prop_assert!(contains(*p));
                for k in 0..4 {
                    prop_assert!(zero(end) || is_nearest(p[k], &end[k]), "{} {}", p[k], end[k]);
                }
            }
            prop_assert!(!contains(a) || clipped[0] == a);
            prop_assert!(!contains(b) || clipped[1] == b);
            prop_assert_eq!(clip_segment(clipped), Some(clipped));
            prop_assert_eq!(clip_segment([b, a]), Some([clipped[1], clipped[0]]));
        }

        #[test]
        fn polygons_lie_in_the_volume(polygon in prop::collection::vec(vertex(), 3..7)) {
            let clipped = clip_polygon(&polygon);
            prop_assert!(clipped.iter().all(|v| contains(v.position)));
            prop_assert_eq!(clip_polygon(&clipped), clipped);
        }

        /// Attributes that are linear in the position stay that function of it, and the picture is the same as that
        /// of the plane Sutherland–Hodgman where all is in front of the eye.
        #[test]
        fn attributes_are_carried_along(mut triangle in prop::array::uniform3(vertex())) {
            let linear = |p: DVec4| [p.x + 2.0 * p.y - p.z + 3.0 * p.w, p.w];
            for v in &mut triangle {
                v.attributes = linear(v.position);
            }
            for v in clip_polygon(&triangle) {
                let expected = linear(v.position);
                // Up to 6 crossings in a row, each coordinate off by half an ulp of 6, with factors 1, 2, 1, 3, and the
                // attribute by half an ulp of 42.
                let bound = 6.0 * (7.0 * 3.0 + 21.0) * f64::EPSILON;
                for (x, e) in v.attributes.iter().zip(expected) {
                    prop_assert!((x - e).abs() <= bound, "{x} {e}");
                }
            }
        }

        #[test]
        fn the_picture_is_that_of_the_plane_method(triangle in prop::array::uniform3((-6i32..7, -6i32..7))) {
            let flat = triangle.map(|(x, y)| ombra_math::glam::DVec2::new(f64::from(x) / 2.0, f64::from(y) / 2.0));
            let lifted = flat.map(|p| Vertex { position: DVec4::new(p.x, p.y, 0.0, 1.0), attributes: [] });
            let one = ombra_math::glam::DVec2::ONE;
            let window = crate::Window { min: -one, max: one };
            let expected = oracle::area(&crate::sutherland_hodgman::clip_polygon(&window, &flat));
            let picture: Vec<_> = clip_polygon(&lifted).iter().map(|v| v.position.truncate().truncate() / v.position.w).collect();
            let error = oracle::absolute(oracle::area(&picture) - expected);
            // Nine corners at most, each off by two roundings of numbers up to 1, times twice the size 2.
            prop_assert!(error <= r(9.0 * 2.0 * f64::EPSILON * 4.0));
        }

        #[test]
        fn triangles_that_share_an_edge_share_its_crossings(a in vertex(), b in vertex(), c in vertex(), d in vertex()) {
            // On the edge itself, crossings are those of a b, whichever way it runs.
            for plane in ViewPlane::ALL {
                let of = |p: &[Vertex<2>]| clip_polygon_to(p, &[plane]);
                let (s, e) = (plane.side(a.position), plane.side(b.position));
                let (one, other) = (of(&[a, b, c]), of(&[b, a, d]));
                if s * e < 0.0 && one.len() > 2 && other.len() > 2 {
                    let (front, back) = if s > 0.0 { (a, b) } else { (b, a) };
                    let shared = cut(plane, front, back);
                    // Between a place and its opposite lies (0, 0, 0, 0), which is dropped.
                    let dropped = shared.position == DVec4::ZERO;
                    prop_assert!(dropped || (one.contains(&shared) && other.contains(&shared)));
                }
            }
        }

        #[test]
        fn never_panics(x in prop::collection::vec(proptest::num::f64::ANY, 24)) {
            let p: Vec<DVec4> = x.chunks_exact(4).map(DVec4::from_slice).collect();
            if let Some(clipped) = clip_segment([p[0], p[1]]) {
                prop_assert!(clipped.iter().all(|&p| contains(p)), "{clipped:?}");
            }
            let polygon: Vec<_> = p.iter().map(|&position| Vertex { position, attributes: [x[0], x[5]] }).collect();
            prop_assert!(clip_polygon(&polygon).iter().all(|v| contains(v.position)));
        }
    }
}
