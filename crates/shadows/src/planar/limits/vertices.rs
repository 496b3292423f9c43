//! What a clipped polygon needs to know of its vertices, exact where a sign decides.

use ombra_math::exact::{Sum, relative};
use ombra_math::glam::{DVec3, DVec4};
use ombra_math::homogeneous::point;
use ombra_math::plane::Plane;
use ombra_math::scaling::common;

use crate::planar::placement::denominator;

/// s V_j − t L_j.
fn numerator(plane: Plane, light: DVec4, v: DVec3, j: usize) -> Sum {
    let (pi, v4) = (plane.coefficients(), point(v));
    let mut sum = Sum::default();
    for i in 0..4 {
        sum.add([pi[i], light[i], v[j]]);
        sum.add([-pi[i], v4[i], light[j]]);
    }
    sum
}

/// The shadow of a vertex below the light, on whichever side of the plane: rounding may put a vertex that was clipped
/// to the plane a little behind it. w = 1, or scaled to ordinary size where the place is beyond the range of doubles.
pub(super) fn homogeneous_shadow(plane: Plane, light: DVec4, v: DVec3) -> DVec4 {
    let w = denominator(plane, light, v);
    let sums = [0, 1, 2].map(|j| numerator(plane, light, v, j));
    let p = DVec3::from_array(sums.each_ref().map(|sum| sum.quotient(&w)));
    if p.is_finite() {
        return point(p);
    }
    let (p, exponent) = common(sums.map(|sum| sum.to_scaled()));
    let (w, w_exponent) = w.to_scaled();
    let p = DVec3::from(p) * w.signum();
    p.extend(libm::scalbn(w.abs(), w_exponent - exponent))
}

/// s − L_w t of each vertex, the largest between 1 and 2: positive where a vertex is nearer to the plane than the
/// light, for a plane with the light in front. Signs are exact, also of heights too small beside the largest.
pub(super) fn heights_below_light(plane: Plane, light: DVec4, polygon: &[DVec3]) -> Vec<f64> {
    let heights: Vec<_> = polygon
        .iter()
        .map(|&v| denominator(plane, light, v).to_scaled())
        .collect();
    relative(&heights)
}

/// The direction from the light's place to `v`, of any length that keeps its digits.
pub(super) fn direction_from_light(light: DVec4, v: DVec3) -> DVec3 {
    let sums = [0, 1, 2].map(|j| Sum::of(&[[light.w, v[j], 1.0], [-1.0, light[j], 1.0]]));
    let plain = DVec3::from_array(sums.each_ref().map(Sum::to_f64));
    if plain.is_finite() && plain.abs().max_element().is_normal() {
        return plain;
    }
    common(sums.map(|sum| sum.to_scaled())).0.into()
}
