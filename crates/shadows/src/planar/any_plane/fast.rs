//! The shadow of a point in twice the digits, settled where the error leaves one answer, exact elsewhere.

use ombra_math::double_double::{DoubleDouble, UNIT_ROUNDOFF};
use ombra_math::glam::{DVec3, DVec4};
use ombra_math::homogeneous::point;
use ombra_math::plane::Plane;
use ombra_math::work::{Count, Counter};

use super::cast_plain;
use crate::planar::placement::towards_place;

/// The shadow of `v` on `plane`: [`cast`](super::cast()), counting its work.
///
/// # Properties
///
/// - Error: none: the nearest double in each coordinate.
#[must_use]
pub fn cast(plane: Plane, light: DVec4, v: DVec3, work: &mut impl Count) -> Option<DVec3> {
    work.add(Counter::Vertices, 1);
    let light = towards_place(light);
    match in_double_double(plane, light, v, work) {
        Quick::Shadow(p) => Some(p),
        Quick::NoShadow => None,
        Quick::InDoubt => {
            work.add(Counter::ExactFallbacks, 1);
            cast_plain(plane, light, v, &mut ())
        }
    }
}

pub(super) enum Quick {
    Shadow(DVec3),
    NoShadow,
    InDoubt,
}

/// The formula with 106 bits and a bound of its error. Settled where that bound leaves one answer.
pub(super) fn in_double_double(
    plane: Plane,
    light: DVec4,
    v: DVec3,
    work: &mut impl Count,
) -> Quick {
    let (pi, l, v) = (
        plane.coefficients().to_array(),
        light.to_array(),
        point(v).to_array(),
    );
    if ![pi, l, v]
        .iter()
        .flatten()
        .all(|&x| DoubleDouble::in_range(x))
    {
        return Quick::InDoubt;
    }
    const U2: f64 = UNIT_ROUNDOFF * UNIT_ROUNDOFF;
    let (s, s_size) = dot_and_size(pi, l, work);
    let (t, t_size) = dot_and_size(pi, v, work);
    // Errors of s and t: 16u² of their sizes, as for any dot product of four.
    if s.hi.abs() <= 16.0 * U2 * s_size || (t.hi.abs() <= 16.0 * U2 * t_size && t_size != 0.0) {
        return Quick::InDoubt;
    }
    if t.hi != 0.0 && (t.hi > 0.0) != (s.hi > 0.0) {
        return Quick::NoShadow;
    }
    let [_, _, _, lw] = l;
    let w = s - t.times(lw);
    work.add(Counter::Multiplications, 1);
    work.add(Counter::Additions, 1);
    let w_error = 32.0 * U2 * (s_size + lw * t_size);
    if w.hi.abs() <= 1024.0 * w_error {
        return Quick::InDoubt;
    }
    if (w.hi > 0.0) != (s.hi > 0.0) {
        return Quick::NoShadow;
    }
    let mut shadow = DVec3::ZERO;
    for (j, (p, (vj, lj))) in shadow
        .as_mut()
        .iter_mut()
        .zip(v.into_iter().zip(l))
        .enumerate()
    {
        // Across a coordinate axis the plane's own equation gives the coordinate, and the formula would cancel.
        if let Some(fixed) = fixed_coordinate(plane, j) {
            *p = fixed;
            continue;
        }
        let numerator = s.times(vj) - t.times(lj);
        let numerator_error = 32.0 * U2 * (s_size * vj.abs() + t_size * lj.abs());
        let q = numerator.over(w);
        work.add(Counter::Multiplications, 2);
        work.add(Counter::Additions, 1);
        work.add(Counter::Divisions, 1);
        if numerator_error == 0.0 {
            continue; // both products are of zeros
        }
        // Twice the first-order bound, and the division's own 16u².
        let error =
            2.0 * (numerator_error + q.hi.abs() * w_error) / w.hi.abs() + 32.0 * U2 * q.hi.abs();
        // If everything within the error rounds to q.hi, so does the exact quotient.
        let settled = q.hi + (q.lo + error) == q.hi && q.hi + (q.lo - error) == q.hi;
        if !settled || q.hi.abs() < 1e-250 {
            return Quick::InDoubt;
        }
        *p = q.hi;
    }
    Quick::Shadow(shadow)
}

/// −d/n_j where the plane lies across the coordinate axis j.
fn fixed_coordinate(plane: Plane, j: usize) -> Option<f64> {
    let mut others = plane.normal;
    others[j] = 0.0;
    // Adding 0 makes −0 to 0.
    (others == DVec3::ZERO).then_some(-plane.d / plane.normal[j] + 0.0)
}

/// a·b, and Σ|a_i b_i|, the measure of its error.
fn dot_and_size(a: [f64; 4], b: [f64; 4], work: &mut impl Count) -> (DoubleDouble, f64) {
    let (mut value, mut size) = (DoubleDouble::default(), 0.0);
    for (x, y) in a.into_iter().zip(b) {
        let product = DoubleDouble::product(x, y);
        value = value + product;
        size += product.hi.abs();
    }
    work.add(Counter::Multiplications, 4);
    work.add(Counter::Additions, 4);
    (value, size)
}
