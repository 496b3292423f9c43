//! Sutherland–Hodgman: a polygon clipped against one side after another.
//!
//! Walk round the polygon. A vertex inside is kept; where an edge passes from one side to the other, the point
//! where it crosses is put in. What comes out is a polygon again, ready for the next side.

use ombra_math::glam::{DVec3, DVec4};
use ombra_math::homogeneous::incidence;
use ombra_math::plane::Plane;

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
/// first, so that two polygons that share an edge get the same crossing. No vertex is repeated. Fewer than three
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
/// Grafica 3, «Clipping di poligoni». I. E. Sutherland, G. W. Hodgman, «Reentrant polygon clipping», 1974.
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
    if sides.iter().any(|s| s.is_nan()) {
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
/// Which side a vertex lies on is exact, except that a distance below the smallest double counts as none. A
/// crossing is within 4ε of the larger of the two ends' coordinates, and equal for both directions of the edge.
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
/// Grafica 3, «Clipping di poligoni»; Croatian 8.4, projected shadows (an object behind the plane).
#[must_use]
pub fn clip_against_plane(polygon: &[DVec3], plane: &Plane) -> Vec<DVec3> {
    clip_by(
        polygon,
        |v| plane.signed_distance(v),
        |a, b, sa, sb| {
            let [wa, wb] = weights(sa, sb);
            a * wa + b * wb
        },
    )
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
/// CIS 781, «Avoiding far plane clipping»; Grafica 3, «Clipping di poligoni». J. F. Blinn, M. E. Newell,
/// «Clipping using homogeneous coordinates», 1978.
#[must_use]
pub fn clip_homogeneous(polygon: &[DVec4], plane: DVec4) -> Vec<DVec4> {
    let side = |p| incidence(plane, p).clamp(-f64::MAX, f64::MAX);
    clip_by(polygon, side, |a, b, sa, sb| {
        // Any multiple will do: the power of two that keeps the weights below 2 costs no digit.
        let exponent = -libm::ilogb(sa.max(-sb));
        b * libm::scalbn(sa, exponent) - a * libm::scalbn(sb, exponent)
    })
}

/// The shares of the inside and the outside vertex in the crossing, from s_in > 0 > s_out.
fn weights(s_in: f64, s_out: f64) -> [f64; 2] {
    // Halved, so that the difference of two huge values stays finite.
    let (s_in, s_out) = if s_in - s_out < f64::INFINITY {
        (s_in, s_out)
    } else {
        (s_in / 2.0, s_out / 2.0)
    };
    let length = s_in - s_out;
    [-s_out / length, s_in / length]
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_bigint::BigInt;
    use num_rational::BigRational;
    use ombra_math::homogeneous::point;
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
        fn never_panics(x in prop::collection::vec(proptest::num::f64::ANY, 16), n in 0usize..4) {
            let p4: Vec<_> = x.chunks_exact(4).map(DVec4::from_slice).collect();
            let p3: Vec<_> = p4.iter().map(|p| p.truncate()).collect();
            let plane = Plane { normal: p3[n], d: x[n] };
            prop_assert!(clip_against_plane(&p3, &plane).iter().all(|p| !p.is_nan()));
            let _ = clip_homogeneous(&p4, p4[n]);
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
