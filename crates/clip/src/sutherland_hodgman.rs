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
use ombra_math::work::{Count, Counter};

use crate::crossing::between_products;

mod sides;
mod window;

pub use window::{clip_polygon, clip_polygon_counted, clip_polygon_in_passes};

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
    clip_by_counted(polygon, side, cut, &mut ())
}

/// [`clip_by`], counting its [work](crate#counted-work): that of `side` and `cut` as one comparison and one division.
#[must_use]
pub fn clip_by_counted<V: Copy + PartialEq>(
    polygon: &[V],
    side: impl Fn(V) -> f64,
    cut: impl Fn(V, V, f64, f64) -> V,
    work: &mut impl Count,
) -> Vec<V> {
    work.add(Counter::Vertices, polygon.len() as u64);
    work.add(Counter::Comparisons, polygon.len() as u64);
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
        if (a_side > 0.0 && b_side < 0.0) || (a_side < 0.0 && b_side > 0.0) {
            work.add(Counter::Divisions, 1);
        }
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
    clip_against_line_counted(polygon, half, &mut ())
}

/// [`clip_against_line`], counting its [work](crate#counted-work).
#[must_use]
pub fn clip_against_line_counted(
    polygon: &[DVec2],
    half: HalfPlane,
    work: &mut impl Count,
) -> Vec<DVec2> {
    work.add(Counter::Multiplications, 2 * polygon.len() as u64);
    clip_by_counted(
        polygon,
        |p| half.side(p),
        |a, b, _, _| {
            let (sa, sb) = (half.products(a), half.products(b));
            DVec2::new(
                between_products(&sa, &sb, [a.x, b.x]),
                between_products(&sa, &sb, [a.y, b.y]),
            )
        },
        work,
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
/// Empty where nothing but an edge or a vertex is left, or a coordinate is not finite. A normal of 0 is no plane: all is
/// inside for d ≥ 0, nothing for d < 0.
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
    clip_against_plane_counted(polygon, plane, &mut ())
}

/// [`clip_against_plane`], counting its [work](crate#counted-work).
#[must_use]
pub fn clip_against_plane_counted(
    polygon: &[DVec3],
    plane: &Plane,
    work: &mut impl Count,
) -> Vec<DVec3> {
    work.add(Counter::Multiplications, 3 * polygon.len() as u64);
    let scaled: Vec<_> = polygon
        .iter()
        .map(|&v| dot(plane.coefficients(), point(v)))
        .collect();
    let sides = relative(&scaled);
    let vertices: Vec<_> = polygon.iter().copied().zip(sides).collect();
    let clipped = clip_by_counted(
        &vertices,
        |(_, side)| side,
        |(a, _), (b, _), sa, sb| {
            let [wa, wb] = weights(sa, sb);
            // Rounding may not leave the edge's box.
            ((a * wa + b * wb).max(a.min(b)).min(a.max(b)), 0.0)
        },
        work,
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
    clip_homogeneous_counted(polygon, plane, &mut ())
}

/// [`clip_homogeneous`], counting its [work](crate#counted-work): four multiplications for π·P.
#[must_use]
pub fn clip_homogeneous_counted(
    polygon: &[DVec4],
    plane: DVec4,
    work: &mut impl Count,
) -> Vec<DVec4> {
    work.add(Counter::Multiplications, 4 * polygon.len() as u64);
    let side = |p| incidence(plane, p).clamp(-f64::MAX, f64::MAX);
    let cut = |a, b, sa: f64, sb: f64| {
        // Any multiple will do: the power of two that keeps the weights below ½ costs no digit.
        let exponent = -libm::ilogb(sa.max(-sb)) - 2;
        b * libm::scalbn(sa, exponent) - a * libm::scalbn(sb, exponent)
    };
    clip_by_counted(polygon, side, cut, work)
}

/// The shares of the inside and the outside vertex in the crossing, from s_in > 0 > s_out below 2.
fn weights(s_in: f64, s_out: f64) -> [f64; 2] {
    let length = s_in - s_out;
    [-s_out / length, s_in / length]
}

#[cfg(test)]
mod tests;
