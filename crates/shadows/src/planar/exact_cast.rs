//! The shadow of a point: decided exactly, rounded once.

use core::cmp::Ordering;

use ombra_math::double_double::{DoubleDouble, UNIT_ROUNDOFF};
use ombra_math::exact::{Sum, dot, relative};
use ombra_math::glam::{DVec3, DVec4};
use ombra_math::homogeneous::point;
use ombra_math::plane::Plane;
use ombra_math::scaling::common;
use ombra_math::work::{Count, Counter};

/// Where a vertex lies on the ray from the light to the plane.
///
/// # Formula
///
/// On S(t) = V − t (V − L), which meets the plane at t = (n·V + d) / (n·V + d − π·L), for a light at a place:
///
/// ```text
/// t ≤ 0        Casts            the vertex is between light and plane (or on the plane)
/// 0 < t < 1    BehindPlane      the plane is between vertex and light
/// t > 1        BeyondLight      the light is between vertex and plane
/// ```
///
/// For a light at infinity, S(t) = V − t L meets it at t = (n·V + d) / (n·L): t ≥ 0 casts, t < 0 is behind. (The
/// decks' two t run opposite ways: V − L points away from a light at a place, L towards one at infinity.)
///
/// # References
///
/// Olomouc, «Zdroj světla v bodě» and «Nevýhody»; Croatian 8.4, projected shadows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Placement {
    /// Between the light and the plane, or on the plane: a true shadow.
    Casts,
    /// On the other side of the plane than the light.
    BehindPlane,
    /// As far from the plane as the light: the shadow runs to infinity.
    LevelWithLight,
    /// Farther from the plane than the light.
    BeyondLight,
    /// The light shines along the plane, or lies on it: the plane is not lit, and nothing casts.
    LightAlongPlane,
}

/// Where `v` lies on the ray from `light` to `plane`; `None` if a coordinate is not finite, or there is no plane
/// (zero normal) or no light (zero vector).
///
/// # Properties
///
/// Exact for all finite input. A plane and the same plane turned round, or a light and its negative, give the same
/// answer.
///
/// # Examples
///
/// ```
/// use ombra_math::glam::{DVec3, DVec4};
/// use ombra_math::plane::Plane;
/// use ombra_shadows::planar::{Placement, classify};
///
/// let light = DVec4::new(0.0, 100.0, 100.0, 1.0);
/// let at_height = |y| classify(Plane::GROUND, light, DVec3::new(0.0, y, 0.0));
/// assert_eq!(at_height(20.0), Some(Placement::Casts));
/// assert_eq!(at_height(-1.0), Some(Placement::BehindPlane));
/// assert_eq!(at_height(100.0), Some(Placement::LevelWithLight));
/// assert_eq!(at_height(101.0), Some(Placement::BeyondLight));
/// ```
///
/// # References
///
/// Olomouc, «Zdroj světla v bodě» and «Nevýhody»; Croatian 8.4, projected shadows.
#[must_use]
pub fn classify(plane: Plane, light: DVec4, v: DVec3) -> Option<Placement> {
    let light = towards_place(light);
    if plane.normal == DVec3::ZERO || light == DVec4::ZERO {
        return None;
    }
    let light_side = dot(plane.coefficients(), light).0.partial_cmp(&0.0)?;
    let vertex_side = dot(plane.coefficients(), point(v)).0.partial_cmp(&0.0)?;
    Some(if light_side == Ordering::Equal {
        Placement::LightAlongPlane
    } else if vertex_side == light_side.reverse() {
        Placement::BehindPlane
    } else if light.w == 0.0 {
        Placement::Casts
    } else {
        match denominator(plane, light, v).sign()? {
            Ordering::Equal => Placement::LevelWithLight,
            sign if sign == light_side => Placement::Casts,
            _ => Placement::BeyondLight,
        }
    })
}

/// The shadow of the point `v` on `plane`, or `None` where there is none.
///
/// # Formula
///
/// ```text
/// P = (s V − t L) / (s − L_w t)        s = π·L,  t = n·V + d,  π = (n, d),  L = (L_x, L_y, L_z, L_w)
///
/// plane y = 0, light at a place:       P_x = (L_y V_x − L_x V_y) / (L_y − V_y)
/// plane y = 0, light at infinity:      P_x = V_x − (V_y / L_y) L_x
/// ```
///
/// # Properties
///
/// For finite input each coordinate is the double nearest to the exact result, whatever cancels on the way: within
/// k ε Σ|∂P_j/∂x_i · x_i| over the eleven inputs, with k = ½. So P lies on the plane to |n·P + d| ≤ ½ ε Σ|n_j P_j|.
/// (Where the result is subnormal, add half the smallest double.)
///
/// Whether there is a shadow is exact too. There is none
///
/// - where the light shines along the plane or lies on it (s = 0),
/// - behind the plane, at the light's height and beyond it (no *false* shadows; see [`classify`]),
/// - for NaN and infinite input, without a plane or a light,
/// - where a coordinate would be beyond the largest double.
///
/// A vertex on the plane is its own shadow. As the light leaves to infinity, (D, w) with w → 0, the shadow tends to
/// that of the direction D, with an error proportional to w. As it sinks to the plane, s → 0, the shadow runs away
/// like 1/s.
///
/// # Pitfalls
///
/// A light's direction points towards the light. The printed answer of the point-light example is that of a light
/// at infinity; the exact one has the fractions below.
///
/// # Examples
///
/// ```
/// use ombra_math::glam::{DVec3, DVec4};
/// use ombra_math::plane::Plane;
/// use ombra_shadows::planar::cast;
///
/// // Light at infinity.
/// let shadow = cast(Plane::GROUND, DVec4::new(10.0, 10.0, 10.0, 0.0), DVec3::new(10.0, 20.0, 0.0));
/// assert_eq!(shadow, Some(DVec3::new(-10.0, 0.0, -20.0)));
///
/// // Light at a place.
/// let light = DVec4::new(0.0, 100.0, 100.0, 1.0);
/// let shadow = cast(Plane::GROUND, light, DVec3::new(10.0, 30.0, 0.0));
/// assert_eq!(shadow, Some(DVec3::new(100.0 / 7.0, 0.0, -300.0 / 7.0)));
///
/// // Above the light there is no shadow.
/// assert_eq!(cast(Plane::GROUND, light, DVec3::new(10.0, 130.0, 0.0)), None);
/// ```
///
/// # References
///
/// Bologna, «Ombre su piani»; Olomouc, «Zdroj v nekonečnu», «Zdroj světla v bodě», «Projekce na libovolnou plochu».
/// J. Blinn, «Me and my (fake) shadow», 1988. Rounding: A. Ziv, «Fast evaluation of elementary mathematical functions
/// with correctly rounded last bit», 1991.
#[must_use]
pub fn cast(plane: Plane, light: DVec4, v: DVec3) -> Option<DVec3> {
    cast_counted(plane, light, v, &mut ())
}

/// [`cast`], counting what it does: vertices, the arithmetic of its usual path, and the exact fallbacks.
#[must_use]
pub fn cast_counted(plane: Plane, light: DVec4, v: DVec3, work: &mut impl Count) -> Option<DVec3> {
    work.add(Counter::Vertices, 1);
    let light = towards_place(light);
    match in_double_double(plane, light, v, work) {
        Quick::Shadow(p) => Some(p),
        Quick::NoShadow => None,
        Quick::InDoubt => {
            work.add(Counter::ExactFallbacks, 1);
            exactly(plane, light, v)
        }
    }
}

/// The light with w ≥ 0: −L is the same place.
#[inline]
pub(super) fn towards_place(light: DVec4) -> DVec4 {
    if light.w < 0.0 { -light } else { light }
}

enum Quick {
    Shadow(DVec3),
    NoShadow,
    InDoubt,
}

/// The formula with 106 bits and a bound of its error. Settled where that bound leaves one answer.
fn in_double_double(plane: Plane, light: DVec4, v: DVec3, work: &mut impl Count) -> Quick {
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
        work.add(Counter::Multiplications, 1);
        work.add(Counter::Additions, 1);
    }
    (value, size)
}

/// The formula without rounding, but for the last quotient.
fn exactly(plane: Plane, light: DVec4, v: DVec3) -> Option<DVec3> {
    if classify(plane, light, v)? != Placement::Casts {
        return None;
    }
    let w = denominator(plane, light, v);
    let p = DVec3::from_array([0, 1, 2].map(|j| numerator(plane, light, v, j).quotient(&w)));
    p.is_finite().then_some(p)
}

/// s − L_w t, where the plane's d has cancelled.
fn denominator(plane: Plane, light: DVec4, v: DVec3) -> Sum {
    let mut sum = Sum::default();
    for i in 0..3 {
        sum.add([plane.normal[i], light[i], 1.0]);
        sum.add([-plane.normal[i], light.w, v[i]]);
    }
    sum
}

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

#[cfg(test)]
mod tests;
