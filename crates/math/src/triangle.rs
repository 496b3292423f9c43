//! Triangles: normal, area, barycentric coordinates, and the face normal that vertex normals give.
//!
//! A triangle A, B, C runs counter-clockwise as seen from its front. A component of its normal decides whether
//! a face is seen or lit, so each one has the exact sign: what rounding could have spoilt is summed again by
//! [`crate::exact`].
#![cfg_attr(doc, doc = "")]
#![cfg_attr(doc, doc = include_str!("../figures/barycentric-weights.svg"))]

use crate::exact::Sum;
use crate::scaling::{common, normalised};
use glam::DVec3;

/// Normal of the triangle A, B, C: twice its area long, towards whoever sees A, B, C run counter-clockwise.
///
/// # Formula
///
/// ```text
/// n = AB × AC          AB = b − a,  AC = c − a
/// ```
///
/// # Properties
///
/// Each component has the exact sign and is 0 only where it is 0. The normal of a
/// degenerate triangle is zero. Which corner comes first does not matter; exchanging two turns it over.
///
/// - Error: at most 2⁻⁴¹ |component| in each.
///
/// # Pitfalls
///
/// Not of unit length. Its components are products of two lengths: with sides beyond 10¹⁵⁴ they are ±∞, below
/// 10⁻¹⁶² they are 0; [`area`] and [`barycentric`] have no such limits. A corner that is not finite gives NaN.
///
/// # Examples
///
/// ```
/// use ombra_math::glam::DVec3;
/// use ombra_math::triangle::normal;
///
/// let n = normal(DVec3::ZERO, DVec3::new(10.0, 0.0, 5.0), DVec3::new(3.0, 2.0, 5.0));
/// assert_eq!(n, DVec3::new(-10.0, -35.0, 20.0));
/// ```
///
/// # References
///
/// Olomouc, «Flat shading», first example.
#[doc(alias = "cross product")]
#[doc(alias = "surface normal")]
#[must_use]
pub fn normal(a: DVec3, b: DVec3, c: DVec3) -> DVec3 {
    let [x, y, z] = CYCLE.map(|ij| {
        let [a, b, c] = [a, b, c].map(|p| pick(p, ij));
        cross_plain(difference(b, a), difference(c, a))
            .unwrap_or_else(|| cross_exact(a, b, c).to_f64())
    });
    DVec3::new(x, y, z)
}

/// Area of the triangle A, B, C.
///
/// # Formula
///
/// ```text
/// area = |AB × AC| / 2
/// ```
///
/// # Properties
///
/// Right wherever a double holds it, needles and corners at 10³⁰⁰ included; 0 exactly for a
/// degenerate triangle (the nearest subnormal, perhaps 0, below 10⁻³⁰⁸). NaN for a corner that is not finite.
///
/// - Error: at most 2⁻⁴⁰ |value|; subnormal values half the smallest double more.
///
/// # Examples
///
/// ```
/// use ombra_math::glam::DVec3;
/// use ombra_math::triangle::area;
///
/// assert_eq!(area(DVec3::ZERO, DVec3::X * 1e300, DVec3::Y * 1e-300), 0.5);
/// ```
///
/// # References
///
/// Olomouc, «Flat shading»: half the length of the vector product.
#[must_use]
pub fn area(a: DVec3, b: DVec3, c: DVec3) -> f64 {
    let (n, exponent) = scaled_normal(a, b, c);
    libm::scalbn(n.length(), exponent - 1)
}

/// Barycentric coordinates (α, β, γ) of the point of the triangle's plane nearest to `p`, so that it is αA + βB + γC.
///
/// # Formula
///
/// ```text
/// n = AB × AC
/// α = (PB × PC)·n / n·n      β = (AP × AC)·n / n·n      γ = (AB × AP)·n / n·n
/// ```
///
/// # Properties
///
/// α + β + γ = 1 but for rounding. All three are ≥ 0 inside and on the border; on the line of a side, the
/// coordinate of the corner opposite is 0, and at a corner the coordinates are 1, 0, 0 exactly. Scaling all four points
/// changes nothing.
///
/// - Error: at most 2⁻³⁹ |w| / |n| in each, w its own vector product.
///
/// # Pitfalls
///
/// A point above or below the plane has the coordinates of its projection: the answer does not tell whether
/// `p` lies in the plane. On a needle, a small step across it changes the coordinates a lot.
///
/// # Errors
///
/// `None` for a degenerate triangle (exactly collinear corners), a point that is not finite, and coordinates
/// beyond what a double holds.
///
/// # Examples
///
/// ```
/// use ombra_math::glam::DVec3;
/// use ombra_math::triangle::barycentric;
///
/// let [a, b, c] = [DVec3::ZERO, DVec3::X * 4.0, DVec3::Y * 4.0];
/// let above = DVec3::new(1.0, 2.0, 9.0);
/// assert_eq!(barycentric(above, a, b, c), Some(DVec3::new(0.25, 0.25, 0.5)));
/// assert_eq!(barycentric(above, a, b, b), None);
/// ```
///
/// # References
///
/// Olomouc, «Gouraud shading»: the interpolation of vertex values, here in one step.
#[doc(alias = "areal coordinates")]
#[must_use]
pub fn barycentric(p: DVec3, a: DVec3, b: DVec3, c: DVec3) -> Option<DVec3> {
    let (n, exponent) = scaled_normal(a, b, c);
    if n == DVec3::ZERO {
        return None;
    }
    let share = |[a, b, c]: [DVec3; 3]| {
        let (w, e) = scaled_normal(a, b, c);
        libm::scalbn(w.dot(n) / n.length_squared(), e - exponent)
    };
    let coordinates = DVec3::new(share([p, b, c]), share([a, p, c]), share([a, b, p]));
    coordinates.is_finite().then_some(coordinates)
}

/// Unit normal of a face from the normals of its three corners.
///
/// # Formula
///
/// ```text
/// n = N / |N|          N = n_A/|n_A| + n_B/|n_B| + n_C/|n_C|
/// ```
///
/// # Properties
///
/// The lengths of the given normals do not matter, nor does their order.
///
/// - Error: at most 4 ε (1 + 3 / |N|).
///
/// # Pitfalls
///
/// The slide's normals are not all of unit length: their plain mean favours the long ones, and made unit it is
/// (0.7071, 0.7071, 0) instead of (0.6071, 0.7947, 0). Where the three nearly cancel, rounding
/// picks the direction.
///
/// # Errors
///
/// `None` if a normal is zero or not finite, or if the three cancel.
///
/// # Examples
///
/// ```
/// use ombra_math::glam::DVec3;
/// use ombra_math::triangle::face_normal;
///
/// let n = face_normal([DVec3::X, DVec3::new(0.5, 1.0, 0.0), DVec3::new(0.0, 0.5, 0.0)]).unwrap();
/// let to_four_digits = DVec3::new(0.6071, 0.7947, 0.0);
/// assert!((n - to_four_digits).abs().max_element() <= 0.5e-4);
/// ```
///
/// # References
///
/// Olomouc, «Flat shading», second example.
#[must_use]
pub fn face_normal(vertex_normals: [DVec3; 3]) -> Option<DVec3> {
    let [a, b, c] = vertex_normals.map(unit);
    unit(a? + b? + c?)
}

/// `v` made unit length, whatever its scale; `None` if it is zero or not finite.
pub(crate) fn unit(v: DVec3) -> Option<DVec3> {
    let v = DVec3::from(normalised(v.to_array()).0);
    (v.is_finite() && v != DVec3::ZERO).then(|| v / v.length())
}

/// The vector AB × AC as v · 2ᵉ, the largest component of v between 1 and 2 or zero.
pub(crate) fn scaled_normal(a: DVec3, b: DVec3, c: DVec3) -> (DVec3, i32) {
    scaled(CYCLE.map(|ij| {
        let [a, b, c] = [a, b, c].map(|p| pick(p, ij));
        cross_plain(difference(b, a), difference(c, a))
            .map_or_else(|| cross_exact(a, b, c).to_scaled(), |x| (x, 0))
    }))
}

/// The vector (to − from) × v as a scaled vector, each component the nearest double.
pub(crate) fn scaled_cross(from: DVec3, to: DVec3, v: DVec3) -> (DVec3, i32) {
    scaled(CYCLE.map(|ij| {
        let [[fi, fj], [ti, tj], [vi, vj]] = [from, to, v].map(|p| pick(p, ij));
        Sum::of(&[[ti, vj, 1.0], [-fi, vj, 1.0], [-tj, vi, 1.0], [fj, vi, 1.0]]).to_scaled()
    }))
}

/// The two coordinates whose products make the x, y and z of a vector product.
pub(crate) const CYCLE: [[usize; 2]; 3] = [[1, 2], [2, 0], [0, 1]];

pub(crate) fn pick(p: DVec3, [i, j]: [usize; 2]) -> [f64; 2] {
    [p[i], p[j]]
}

fn difference(p: [f64; 2], q: [f64; 2]) -> [f64; 2] {
    [p[0] - q[0], p[1] - q[1]]
}

/// uᵢ vⱼ − uⱼ vᵢ of rounded differences where that is within 2⁻⁴¹ of the exact value.
///
/// Each product carries at most three rounding errors of 2⁻⁵³ and the subtraction one more, together below
/// 2⁻⁵¹·(|uᵢvⱼ| + |uⱼvᵢ|); products that underflow are left to the exact sum.
fn cross_plain([ui, uj]: [f64; 2], [vi, vj]: [f64; 2]) -> Option<f64> {
    const NO_UNDERFLOW: f64 = f64::MIN_POSITIVE * (1u64 << 60) as f64;
    const CANCELLED: f64 = 1.0 / 1024.0;
    let (p, q) = (ui * vj, uj * vi);
    let (cross, size) = (p - q, p.abs() + q.abs());
    let zero = |x: f64, y: f64| x == 0.0 && y.is_finite() || y == 0.0 && x.is_finite();
    if (NO_UNDERFLOW..f64::INFINITY).contains(&size) && cross.abs() >= CANCELLED * size {
        Some(cross)
    } else if zero(ui, vj) && zero(uj, vi) {
        Some(0.0)
    } else {
        None
    }
}

fn cross_exact(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> Sum {
    Sum::of(&cross_terms([a, b, c]))
}

/// What a component of AB × AC is the sum of: differences multiplied out, as they themselves would be rounded.
pub(crate) fn cross_terms([[ai, aj], [bi, bj], [ci, cj]]: [[f64; 2]; 3]) -> [[f64; 3]; 6] {
    [
        [ai, bj, 1.0],
        [-aj, bi, 1.0],
        [bi, cj, 1.0],
        [-bj, ci, 1.0],
        [ci, aj, 1.0],
        [-cj, ai, 1.0],
    ]
}

/// Components x · 2ᵉ brought to one exponent.
fn scaled(components: [(f64, i32); 3]) -> (DVec3, i32) {
    let (v, exponent) = common(components);
    (v.into(), exponent)
}

#[cfg(test)]
mod tests;
