//! Sutherland–Hodgman: a polygon clipped against one side after another.
//!
//! Walk round the polygon. A vertex inside is kept; where an edge passes from one side to the other, the point
//! where it crosses is put in. What comes out is a polygon again, ready for the next side.
#![cfg_attr(doc, doc = "")]
#![cfg_attr(doc, doc = include_str!("../figures/sutherland-hodgman-steps.svg"))]

use ombra_math::exact::{dot, relative};
use ombra_math::glam::{DVec2, DVec3, DVec4};
use ombra_math::homogeneous::{incidence, point};
use ombra_math::plane::Plane;

use crate::crossing::between_products;

mod window;

pub use window::{clip_polygon, clip_polygon_counted};

/// The part of a closed polygon where `side` is not negative.
///
/// The method itself, for vertices of any kind: places, homogeneous points, points with attributes.
///
/// # Formula
///
/// ```text
/// for each edge A → B:   A in,  B in     put B
///                        A in,  B out    put the crossing
///                        A out, B in     put the crossing, then B
///                        A out, B out    put nothing
/// ```
///
/// `side(v)` is positive inside, 0 on the border, negative outside; a border vertex is inside and no crossing is
/// put beside it. `cut(inside, outside, s_in, s_out)` gives the crossing, with s_in > 0 > s_out the values of `side`.
///
/// # Properties
///
/// Vertices keep their order; vertices that are kept are kept unchanged. `cut` always gets the inside vertex
/// first, so that two polygons that share an edge get the same crossing. No vertex stands twice in a row. Fewer than three
/// vertices are no polygon: the answer is then empty, as it is if any `side` is NaN.
///
/// # Pitfalls
///
/// A concave polygon that falls into several pieces comes out as one, joined by edges that run back and forth
/// along the border.
///
/// # Examples
///
/// ```
/// use ombra_clip::sutherland_hodgman::clip_by;
///
/// // A triangle against x ≥ 0.
/// let triangle = [(-1.0, 0.0), (1.0, 0.0), (1.0, 2.0)];
/// let lerp = |a: f64, b: f64, t: f64| a + (b - a) * t;
/// let clipped = clip_by(&triangle, |v: (f64, f64)| v.0, |a, b, sa, sb| {
///     let t = sa / (sa - sb);
///     (0.0, lerp(a.1, b.1, t))
/// });
/// assert_eq!(clipped, [(0.0, 1.0), (0.0, 0.0), (1.0, 0.0), (1.0, 2.0)]);
/// ```
///
/// # References
///
/// Grafica 3, «Clipping di un poligono». I. E. Sutherland, G. W. Hodgman, «Reentrant polygon clipping», 1974.
#[must_use]
pub fn clip_by<V: Copy + PartialEq>(
    polygon: &[V],
    side: impl Fn(V) -> f64,
    cut: impl Fn(V, V, f64, f64) -> V,
) -> Vec<V> {
    let sides: Vec<f64> = polygon.iter().map(|&v| side(v)).collect();
    let Some((&last, &last_side)) = polygon.last().zip(sides.last()) else {
        return Vec::new();
    };
    let none_inside = !sides.iter().any(|&s| s > 0.0);
    if sides.iter().any(|s| s.is_nan()) || (none_inside && sides.iter().any(|&s| s < 0.0)) {
        return Vec::new();
    }
    let mut kept: Vec<V> = Vec::with_capacity(polygon.len() + 2);
    let mut put = |v: V| {
        if kept.last() != Some(&v) {
            kept.push(v);
        }
    };
    let (mut a, mut a_side) = (last, last_side);
    for (&b, &b_side) in polygon.iter().zip(&sides) {
        if a_side > 0.0 && b_side < 0.0 {
            put(cut(a, b, a_side, b_side));
        } else if a_side < 0.0 && b_side > 0.0 {
            put(cut(b, a, b_side, a_side));
        }
        if b_side >= 0.0 {
            put(b);
        }
        (a, a_side) = (b, b_side);
    }
    while kept.len() > 1 && kept.first() == kept.last() {
        kept.pop();
    }
    if kept.len() < 3 { Vec::new() } else { kept }
}

/// The points p with n·p ≥ offset.
///
/// # Formula
///
/// ```text
/// n·p = n_x x + n_y y ≥ offset          n points inside, and need not be of unit length
/// ```
///
/// # Properties
///
/// The border n·p = offset belongs to it. With a zero normal it is the whole plane or nothing.
///
/// # Examples
///
/// ```
/// use ombra_clip::sutherland_hodgman::HalfPlane;
/// use ombra_math::glam::DVec2;
///
/// // x ≤ 10
/// let left_of_10 = HalfPlane { normal: -DVec2::X, offset: -10.0 };
/// assert!(left_of_10.contains(DVec2::new(10.0, 3.0)));
/// assert!(!left_of_10.contains(DVec2::new(10.000001, 3.0)));
/// ```
///
/// # References
///
/// Grafica 3, «Clipping di un poligono»: the polygon against one line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HalfPlane {
    /// n, towards the inside.
    pub normal: DVec2,
    /// n·Q for a point Q of the line.
    pub offset: f64,
}

impl HalfPlane {
    /// Whether n·p ≥ offset: exact, and never for NaN or ∞.
    #[must_use]
    pub fn contains(&self, p: DVec2) -> bool {
        self.side(p) >= 0.0
    }

    /// A number with the sign of n·p − offset; NaN if a coordinate is not finite.
    fn side(&self, p: DVec2) -> f64 {
        let (normal, offset) = (self.normal, self.offset);
        let line = DVec4::new(normal.x, normal.y, offset, 0.0);
        dot(line, DVec4::new(p.x, p.y, -1.0, 0.0)).0
    }

    /// n·p − offset as a sum of products.
    fn products(&self, p: DVec2) -> [[f64; 2]; 3] {
        [
            [self.normal.x, p.x],
            [self.normal.y, p.y],
            [self.offset, -1.0],
        ]
    }
}

/// The part of a polygon on one side of a line.
///
/// # Formula
///
/// ```text
/// inside: n·p ≥ offset          crossing: p = (s_A B − s_B A) / (s_A − s_B),  s = n·p − offset
/// ```
///
/// # Properties
///
/// Which side a vertex lies on is exact; both coordinates of a crossing are nearest doubles, so for an upright or
/// level line crossings lie on it exactly. Vertices inside are kept unchanged and in order. Empty where nothing but an
/// edge or a vertex is left, or a number is not finite.
///
/// # Pitfalls
///
/// See [`clip_by`] for concave polygons. For a line at an angle the nearest double may lie beyond it, by rounding of
/// its coordinates: no double may lie on it at all.
///
/// # Examples
///
/// ```
/// use ombra_clip::sutherland_hodgman::{HalfPlane, clip_against_line};
/// use ombra_math::glam::DVec2;
///
/// let square = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)].map(DVec2::from);
/// let below_diagonal = HalfPlane { normal: DVec2::new(-1.0, -1.0), offset: -4.0 }; // x + y ≤ 4
/// let half = [(0.0, 0.0), (4.0, 0.0), (0.0, 4.0)].map(DVec2::from);
/// assert_eq!(clip_against_line(&square, below_diagonal), half);
/// ```
///
/// # References
///
/// Grafica 3, «Clipping di un poligono».
#[must_use]
pub fn clip_against_line(polygon: &[DVec2], half: HalfPlane) -> Vec<DVec2> {
    clip_by(
        polygon,
        |p| half.side(p),
        |a, b, _, _| {
            let (sa, sb) = (half.products(a), half.products(b));
            DVec2::new(
                between_products(&sa, &sb, [a.x, b.x]),
                between_products(&sa, &sb, [a.y, b.y]),
            )
        },
    )
}

/// The part of a polygon in space that lies in front of `plane` or on it.
///
/// # Formula
///
/// ```text
/// inside: n·X + d ≥ 0          crossing: X = A + t (B − A),  t = s_A / (s_A − s_B)
/// ```
///
/// # Properties
///
/// Which side a vertex lies on is exact. A crossing is within 4ε of the larger of the two ends' coordinates, in the box
/// round its edge, and equal for both directions of the edge.
/// Empty where nothing but an edge or a vertex is left, or a coordinate is not finite.
///
/// # Pitfalls
///
/// See [`clip_by`] for concave polygons.
///
/// # Examples
///
/// ```
/// use ombra_clip::sutherland_hodgman::clip_against_plane;
/// use ombra_math::glam::DVec3;
/// use ombra_math::plane::Plane;
///
/// let wall = [DVec3::new(0.0, -1.0, 0.0), DVec3::new(4.0, -1.0, 0.0), DVec3::new(4.0, 3.0, 0.0)];
/// let above = clip_against_plane(&wall, &Plane::GROUND);
/// assert_eq!(above, [DVec3::new(1.0, 0.0, 0.0), DVec3::new(4.0, 0.0, 0.0), DVec3::new(4.0, 3.0, 0.0)]);
/// ```
///
/// # References
///
/// Grafica 3, «Clipping di un poligono»; Croatian 8.4, projected shadows (an object behind the plane).
#[must_use]
pub fn clip_against_plane(polygon: &[DVec3], plane: &Plane) -> Vec<DVec3> {
    if plane.normal == DVec3::ZERO {
        return Vec::new();
    }
    let scaled: Vec<_> = polygon
        .iter()
        .map(|&v| dot(plane.coefficients(), point(v)))
        .collect();
    let sides = relative(&scaled);
    let vertices: Vec<_> = polygon.iter().copied().zip(sides).collect();
    let clipped = clip_by(
        &vertices,
        |(_, side)| side,
        |(a, _), (b, _), sa, sb| {
            let [wa, wb] = weights(sa, sb);
            // Rounding may not leave the edge's box.
            ((a * wa + b * wb).max(a.min(b)).min(a.max(b)), 0.0)
        },
    );
    clipped.into_iter().map(|(v, _)| v).collect()
}

/// The part of a homogeneous polygon where π·P ≥ 0.
///
/// # Formula
///
/// ```text
/// inside: π·P ≥ 0          crossing: P = (s_A B − s_B A) / (s_A − s_B)
/// ```
///
/// # Properties
///
/// Needs no division by w, so points at infinity (w = 0) and behind the eye (w < 0) are clipped like any other.
/// Sides are exact, except that values below the smallest double count as 0; values beyond the largest count as
/// the largest, and the crossing beside them is rough. Empty where nothing but an edge or a vertex is left, or a
/// coordinate is not finite.
///
/// # Pitfalls
///
/// Clip against w ≥ 0 before dividing: a polygon with w of both signs turns inside out.
///
/// # Examples
///
/// The wedge between two parallel edges that run to infinity, cut at x ≤ 5:
///
/// ```
/// use ombra_clip::sutherland_hodgman::clip_homogeneous;
/// use ombra_math::glam::DVec4;
///
/// let strip = [
///     DVec4::new(0.0, 0.0, 0.0, 1.0),
///     DVec4::new(1.0, 0.0, 0.0, 0.0), // the direction +x
///     DVec4::new(0.0, 0.0, 2.0, 1.0),
/// ];
/// let cut = clip_homogeneous(&strip, DVec4::new(-1.0, 0.0, 0.0, 5.0));
/// let places: Vec<_> = cut.iter().map(|p| *p / p.w).collect();
/// assert_eq!(places[1], DVec4::new(5.0, 0.0, 0.0, 1.0));
/// assert_eq!(places[2], DVec4::new(5.0, 0.0, 2.0, 1.0));
/// ```
///
/// # References
///
/// CIS 781, «Avoiding far plane clipping»; Grafica 3, «Clipping di un poligono». J. F. Blinn, M. E. Newell,
/// «Clipping using homogeneous coordinates», 1978.
#[must_use]
pub fn clip_homogeneous(polygon: &[DVec4], plane: DVec4) -> Vec<DVec4> {
    let side = |p| incidence(plane, p).clamp(-f64::MAX, f64::MAX);
    clip_by(polygon, side, |a, b, sa, sb| {
        // Any multiple will do: the power of two that keeps the weights below ½ costs no digit.
        let exponent = -libm::ilogb(sa.max(-sb)) - 2;
        b * libm::scalbn(sa, exponent) - a * libm::scalbn(sb, exponent)
    })
}

/// The shares of the inside and the outside vertex in the crossing, from s_in > 0 > s_out below 2.
fn weights(s_in: f64, s_out: f64) -> [f64; 2] {
    let length = s_in - s_out;
    [-s_out / length, s_in / length]
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_bigint::BigInt;
    use num_rational::BigRational;
    use proptest::prelude::*;

    fn exact(x: f64) -> BigRational {
        BigRational::from_float(x).unwrap()
    }

    fn v(x: f64, y: f64, z: f64) -> DVec3 {
        DVec3::new(x, y, z)
    }

    /// Twice the area of a polygon with z = 0, in rationals.
    fn area(polygon: &[DVec3]) -> BigRational {
        let mut sum = BigRational::from_integer(BigInt::from(0));
        for (i, a) in polygon.iter().enumerate() {
            let b = polygon[(i + 1) % polygon.len()];
            sum += exact(a.x) * exact(b.y) - exact(a.y) * exact(b.x);
        }
        sum
    }

    fn points<const N: usize>(p: [(f64, f64); N]) -> Vec<DVec2> {
        p.map(DVec2::from).to_vec()
    }

    #[test]
    fn the_lectures_triangle_against_one_line_then_four() {
        let line = |normal, offset| HalfPlane { normal, offset };
        let triangle = points([(5.0, 5.0), (15.0, 5.0), (5.0, 15.0)]);
        let one = clip_against_line(&triangle, line(-DVec2::X, -10.0));
        assert_eq!(
            one,
            points([(5.0, 5.0), (10.0, 5.0), (10.0, 10.0), (5.0, 15.0)])
        );
        let mut four = one;
        for side in [
            line(DVec2::X, 0.0),
            line(DVec2::Y, 0.0),
            line(-DVec2::Y, -10.0),
        ] {
            four = clip_against_line(&four, side);
        }
        four.rotate_left(1);
        assert_eq!(
            four,
            points([(5.0, 5.0), (10.0, 5.0), (10.0, 10.0), (5.0, 10.0)])
        );
    }

    #[test]
    fn degenerate_lines() {
        let square = points([(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)]);
        let line = |x, y, offset| HalfPlane {
            normal: DVec2::new(x, y),
            offset,
        };
        let huge = f64::MAX;
        let cases = [
            // No normal: all or nothing.
            (line(0.0, 0.0, 0.0), square.clone()),
            (line(0.0, 0.0, 1.0), vec![]),
            // Along a side, through a corner only, through two corners.
            (line(1.0, 0.0, 0.0), square.clone()),
            (line(1.0, 0.0, 4.0), vec![]),
            (line(-1.0, -1.0, 0.0), vec![]),
            (line(1.0, -1.0, 0.0), square[..3].to_vec()),
            (
                line(huge, huge, huge),
                points([(0.0, 1.0), (1.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)]),
            ),
            (
                line(5e-324, 0.0, 1e-323),
                points([(2.0, 0.0), (4.0, 0.0), (4.0, 4.0), (2.0, 4.0)]),
            ),
        ];
        for (half, expected) in cases {
            assert_eq!(clip_against_line(&square, half), expected, "{half:?}");
        }
        for bad in [f64::NAN, f64::INFINITY] {
            for half in [
                line(bad, 0.0, 0.0),
                line(0.0, bad, 0.0),
                line(1.0, 0.0, bad),
            ] {
                assert_eq!(clip_against_line(&square, half), []);
            }
            assert!(!line(1.0, 0.0, 0.0).contains(DVec2::new(bad, 0.0)));
        }
    }

    #[test]
    fn inside_outside_and_across() {
        let square = [
            v(0.0, 0.0, 0.0),
            v(4.0, 0.0, 0.0),
            v(4.0, 4.0, 0.0),
            v(0.0, 4.0, 0.0),
        ];
        let at = |x: f64| Plane {
            normal: DVec3::X,
            d: -x,
        };
        assert_eq!(clip_against_plane(&square, &at(-1.0)), square);
        assert_eq!(clip_against_plane(&square, &at(0.0)), square);
        assert_eq!(clip_against_plane(&square, &at(5.0)), []);
        assert_eq!(
            clip_against_plane(&square, &at(4.0)),
            [],
            "an edge alone is no polygon"
        );
        let half = clip_against_plane(&square, &at(2.0));
        assert_eq!(
            half,
            [
                v(2.0, 0.0, 0.0),
                v(4.0, 0.0, 0.0),
                v(4.0, 4.0, 0.0),
                v(2.0, 4.0, 0.0)
            ]
        );
        assert_eq!(
            clip_against_plane(&half, &at(2.0)),
            half,
            "clipping twice changes nothing"
        );
    }

    #[test]
    fn what_only_touches_is_no_polygon() {
        let touching = [
            v(0.0, 0.0, 0.0),
            v(1.0, 0.0, 0.0),
            v(2.0, 0.0, 0.0),
            v(1.0, -1.0, 0.0),
        ];
        assert_eq!(clip_against_plane(&touching, &Plane::GROUND), []);
        assert_eq!(
            clip_against_plane(&touching[..3], &Plane::GROUND),
            touching[..3]
        );
    }

    #[test]
    fn huge_coordinates_stay_finite() {
        let far = [DVec3::splat(f64::MAX), -DVec3::ONE, v(0.0, -1.0, -1.0)];
        let slanted = Plane {
            normal: DVec3::ONE,
            d: 0.0,
        };
        let cut = clip_against_plane(&far, &slanted);
        assert!(
            cut.len() == 3 && cut.iter().all(|p| p.is_finite()),
            "{cut:?}"
        );
        let wide = [
            v(-1.0, f64::MAX, 0.0),
            v(1.0, f64::MAX, 0.0),
            v(1.0, -f64::MAX, 0.0),
        ]
        .map(point);
        let cut = clip_homogeneous(&wide, DVec4::X);
        assert!(
            cut.len() == 4 && cut.iter().all(|p| p.is_finite()),
            "{cut:?}"
        );
    }

    #[test]
    fn a_diagonal_through_two_vertices_puts_no_crossing() {
        let square = [
            v(0.0, 0.0, 0.0),
            v(4.0, 0.0, 0.0),
            v(4.0, 4.0, 0.0),
            v(0.0, 4.0, 0.0),
        ];
        let plane = Plane {
            normal: v(1.0, -1.0, 0.0),
            d: 0.0,
        };
        assert_eq!(clip_against_plane(&square, &plane), square[..3]);
    }

    #[test]
    fn degenerate() {
        let triangle = [v(0.0, -1.0, 0.0), v(1.0, 1.0, 0.0), v(-1.0, 1.0, 0.0)];
        let ground = Plane::GROUND;
        assert_eq!(clip_against_plane(&[], &ground), []);
        assert_eq!(clip_against_plane(&triangle[..1], &ground), []);
        assert_eq!(clip_against_plane(&triangle[..2], &ground), []);
        assert_eq!(clip_against_plane(&[DVec3::Y; 5], &ground), []);
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert_eq!(
                clip_against_plane(&[triangle[0], triangle[1], v(bad, 1.0, 0.0)], &ground),
                []
            );
            assert_eq!(
                clip_against_plane(
                    &triangle,
                    &Plane {
                        normal: DVec3::Y,
                        d: bad
                    }
                ),
                []
            );
            assert_eq!(clip_homogeneous(&[DVec4::splat(bad); 3], DVec4::Y), []);
        }
        assert_eq!(
            clip_against_plane(
                &triangle,
                &Plane {
                    normal: DVec3::ZERO,
                    d: 1.0
                }
            ),
            []
        );
        let huge = f64::MAX;
        let cut = clip_against_plane(
            &[v(0.0, -huge, 0.0), v(huge, huge, 0.0), v(-huge, huge, 0.0)],
            &ground,
        );
        assert_eq!(cut.len(), 4);
        assert!(cut.iter().all(|p| p.is_finite() && p.y >= 0.0));
        // The crossings at ± half the smallest double both round to 0.
        let tiny = clip_against_plane(&triangle.map(|p| p * 5e-324), &ground);
        assert_eq!(
            tiny,
            [DVec3::ZERO, triangle[1] * 5e-324, triangle[2] * 5e-324]
        );
    }

    fn polygon() -> impl Strategy<Value = Vec<DVec3>> {
        prop::collection::vec((-8i32..8, -8i32..8), 3..8).prop_map(|points| {
            points
                .into_iter()
                .map(|(x, y)| v(x.into(), y.into(), 0.0))
                .collect()
        })
    }

    proptest! {
        /// Area is additive whatever the shape: bridges have none. Exact up to the crossings' rounding.
        #[test]
        fn both_sides_together_are_the_whole(polygon in polygon(), n in (-5i32..6, -5i32..6), d in -9i32..9) {
            prop_assume!(n != (0, 0));
            let plane = Plane { normal: v(n.0.into(), n.1.into(), 0.0), d: d.into() };
            let (front, back) =
                (clip_against_plane(&polygon, &plane), clip_against_plane(&polygon, &plane.turned()));
            let rest = area(&polygon) - area(&front) - area(&back);
            // At most 16 crossings, each off by 4ε · 8, times the polygon's size of 16.
            let bound = exact(16.0 * 4.0 * f64::EPSILON * 8.0 * 16.0);
            prop_assert!(rest <= bound && -rest <= bound);
            for p in front {
                let slack = 4.0 * f64::EPSILON * 8.0;
                prop_assert!(plane.signed_distance(p) >= -slack);
            }
        }

        #[test]
        fn crossings_with_a_line_are_nearest_doubles(polygon in crate::oracle::polygon(), n in (-5i32..6, -5i32..6), at in 0usize..14, i in -2i64..3) {
            use crate::oracle::{beside, is_nearest};
            prop_assume!(n != (0, 0));
            let normal = DVec2::new(n.0.into(), n.1.into());
            // Through one of the vertices, or next to it.
            let through = polygon[at % polygon.len()];
            prop_assume!(through.length() < 1e300);
            let half = HalfPlane { normal, offset: beside(normal.dot(through), i) };
            let zero = BigRational::from_integer(BigInt::from(0));
            let side = |p: DVec2| exact(normal.x) * exact(p.x) + exact(normal.y) * exact(p.y) - exact(half.offset);
            let clipped = clip_against_line(&polygon, half);
            // What the plain method keeps, in rationals.
            let mut expected = Vec::new();
            for (k, &a) in polygon.iter().enumerate() {
                let b = polygon[(k + 1) % polygon.len()];
                let (s, t) = (side(a), side(b));
                if s >= zero {
                    expected.push([exact(a.x), exact(a.y)]);
                }
                if &s * &t < zero {
                    let share = &s / (&s - &t);
                    expected.push([[a.x, b.x], [a.y, b.y]].map(|[p, q]| exact(p) + &share * (exact(q) - exact(p))));
                }
            }
            let near = |p: &DVec2, e: &[BigRational; 2]| is_nearest(p.x, &e[0]) && is_nearest(p.y, &e[1]);
            prop_assert!(clipped.iter().all(|p| expected.iter().any(|e| near(p, e))));
            prop_assert!(clipped.is_empty() || expected.iter().all(|e| clipped.iter().any(|p| near(p, e))));
            if clipped.is_empty() {
                // Nothing but at most two different points, or points of the line.
                let off_the_line = polygon.iter().any(|&p| side(p) > zero);
                let close = |x: &BigRational, y: &BigRational| {
                    let size = exact(1e-12) * (x * x + y * y + exact(1.0));
                    (x - y) * (x - y) <= size * exact(1e-12)
                };
                let mut different: Vec<[BigRational; 2]> = Vec::new();
                for e in expected {
                    if !different.iter().any(|f| close(&e[0], &f[0]) && close(&e[1], &f[1])) {
                        different.push(e);
                    }
                }
                prop_assert!(!off_the_line || different.len() < 3, "{different:?}");
            }
        }

        #[test]
        fn never_panics(x in prop::collection::vec(proptest::num::f64::ANY, 16), n in 0usize..4) {
            let p4: Vec<_> = x.chunks_exact(4).map(DVec4::from_slice).collect();
            let p3: Vec<_> = p4.iter().map(|p| p.truncate()).collect();
            let plane = Plane { normal: p3[n], d: x[n] };
            prop_assert!(clip_against_plane(&p3, &plane).iter().all(|p| !p.is_nan()));
            let _ = clip_homogeneous(&p4, p4[n]);
            let p2: Vec<_> = p4.iter().map(|p| p.truncate().truncate()).collect();
            let half = HalfPlane { normal: p2[n], offset: x[n] };
            prop_assert!(clip_against_line(&p2, half).iter().all(|p| !p.is_nan()));
        }

        #[test]
        fn homogeneous_agrees_with_places(polygon in polygon(), n in (-5i32..6, -5i32..6), d in -9i32..9, k in 1i32..9) {
            prop_assume!(n != (0, 0));
            let plane = Plane { normal: v(n.0.into(), n.1.into(), 0.0), d: d.into() };
            let places = clip_against_plane(&polygon, &plane);
            let scaled: Vec<_> = polygon.iter().map(|&p| point(p) * f64::from(k)).collect();
            let homogeneous = clip_homogeneous(&scaled, plane.coefficients());
            let homogeneous: Vec<_> = homogeneous.iter().map(|p| p.truncate() / p.w).collect();
            // Where a polygon without area comes back along itself, one form may see two crossings and the other
            // one; the area is the same.
            let difference = area(&places) - area(&homogeneous);
            let bound = exact(16.0 * 4.0 * f64::EPSILON * 8.0 * 16.0);
            prop_assert!(difference <= bound && -difference <= bound);
        }
    }
}
