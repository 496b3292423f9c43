//! The shadow of a point on any plane under any light, and the matrix of it.
//!
//! The plane is the 4-vector π = (n, d), the light L a homogeneous point: one formula serves the sun and a lamp. On the line
//! through light and vertex, P = (π·L) V − (π·V) L lies on the plane, for π·P = 0; the matrix is the same formula.
#![cfg_attr(doc, doc = "")]
#![cfg_attr(doc, doc = include_str!("../../figures/planar-any-plane.svg"))]
#![cfg_attr(doc, doc = "")]
#![cfg_attr(doc, doc = include_str!("../../figures/shadow-matrix.svg"))]

mod fast;

use core::cmp::Ordering;

use ombra_math::exact::{Sum, dot};
use ombra_math::glam::{DMat4, DVec3, DVec4};
use ombra_math::homogeneous::point;
use ombra_math::plane::Plane;
use ombra_math::scaling::normalised;
use ombra_math::work::{Count, Counter};

use super::error::{PlanarShadowError, check_light};
use super::placement::{Placement, classify, towards_place};

/// [`cast`] as the lecture has it, every product and sum exact: the oracle of the fast one.
///
/// # Formula
///
/// ```text
/// P = (s V − t L) / (s − L_w t)        s = π·L,  t = π·V = n·V + d
/// ```
///
/// # Properties
///
/// `work` counts vertices and the arithmetic of the formula.
///
/// - Error: none: the nearest double.
///
/// # Examples
///
/// ```
/// use ombra_math::glam::{DVec3, DVec4};
/// use ombra_math::plane::Plane;
/// use ombra_shadows::planar::any_plane::cast_plain;
///
/// let light = DVec4::new(0.0, 100.0, 100.0, 1.0);
/// let shadow = cast_plain(Plane::GROUND, light, DVec3::new(10.0, 30.0, 0.0), &mut ());
/// assert_eq!(shadow, Some(DVec3::new(100.0 / 7.0, 0.0, -300.0 / 7.0)));
/// ```
///
/// # References
///
/// Bologna, «Ombre su piani»; Olomouc, «Projekce na libovolnou plochu».
#[must_use]
pub fn cast_plain(plane: Plane, light: DVec4, v: DVec3, work: &mut impl Count) -> Option<DVec3> {
    work.add(Counter::Vertices, 1);
    let l = towards_place(light);
    // A true shadow only: the vertex between light and plane, or on the plane.
    if classify(plane, l, v)? != Placement::Casts {
        return None;
    }
    // The heights of light and vertex above the plane, s = π·L and t = π·V, times a number: never rounded.
    let s = |x: f64| Sum::dot(plane.coefficients(), l, x);
    let t = |x: f64| Sum::dot(plane.coefficients(), point(v), x);
    // How much nearer to the plane than the light, then each coordinate over it.
    let w = s(1.0) - t(l.w);
    let p = [0, 1, 2].map(|j| (s(v[j]) - t(l[j])).quotient(&w));
    work.add(Counter::Multiplications, 14);
    work.add(Counter::Additions, 10);
    work.add(Counter::Divisions, 3);
    let p = DVec3::from(p);
    p.is_finite().then_some(p)
}

/// The shadow of the point `v` on `plane`, or `None` where there is none.
///
/// # Formula
///
/// ```text
/// P = (s V − t L) / (s − L_w t)        s = π·L,  t = n·V + d
/// π = (n, d),  L = (L_x, L_y, L_z, L_w)
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
/// - Error: none: the nearest double in each coordinate.
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
    fast::cast(plane, light, v, &mut ())
}

/// The counted twin of [`cast`]: the same answer, and in `work` what it took: vertices, the arithmetic of the usual path in
/// numbers of twice the digits, and how often only exact sums could tell.
pub mod counted {
    pub use super::fast::cast;
}

/// Matrix that flattens points onto `plane`, away from `light`.
///
/// # Formula
///
/// ```text
/// M = (π·L) I − L πᵀ            P = M V,  then divide by P.w
///
///     ⎡ s − L_x a     −L_x b     −L_x c     −L_x d ⎤
/// M = ⎢    −L_y a  s − L_y b     −L_y c     −L_y d ⎥        π = (a, b, c, d),  s = π·L
///     ⎢    −L_z a     −L_z b  s − L_z c     −L_z d ⎥
///     ⎣    −L_w a     −L_w b     −L_w c  s − L_w d ⎦
/// ```
///
/// # Properties
///
/// - The plane is turned round where π·L < 0, and the light where L_w < 0. So w > 0 exactly for the true shadows of
///   vertices on the light's side of the plane, and clipping keeps them: clip away n·V + d < 0 (on the light's side:
///   positive) and w ≤ 0, and no false shadow is left.
/// - M L = 0, and M V = s V for V on the plane.
/// - The diagonal is summed without the term that cancels.
/// - A matrix with an entry that would overflow, or underflow and lose digits, is scaled by a power of two (as a
///   homogeneous matrix it is the same).
/// - Error: at most 2 ε of the sum of an entry's |terms|; scaled, the last place of a subnormal.
///
/// # Pitfalls
///
/// - Bologna's slide prints the transpose (erratum [E1](crate#e1)): Lπᵀ has the rows L_x (a, b, c, d), L_y (a, b, c, d), …; what it shows is what a
///   column-major array of those rows looks like. Olomouc's has one entry wrong and stands for row
///   vectors ([E2](crate#e2)).
/// - A slide's w is y_P − y_L, negative for every true shadow: clipping then throws them all away.
/// - Divide by w, and only after clipping.
/// - M V loses the digits that cancel: see the [module's](super) page.
///
/// # Errors
///
/// A light that is not finite, zero, or along the plane; a plane that is not finite or has a zero normal.
///
/// # Examples
///
/// ```
/// use ombra_math::glam::{DVec3, DVec4};
/// use ombra_math::homogeneous::{point, project};
/// use ombra_math::plane::Plane;
/// use ombra_shadows::planar::shadow_matrix;
///
/// let m = shadow_matrix(Plane::GROUND, DVec4::new(0.0, 100.0, 100.0, 1.0))?;
/// let shadow = m * point(DVec3::new(0.0, 20.0, 0.0));
/// assert_eq!(shadow, DVec4::new(0.0, 0.0, -2000.0, 80.0));
/// assert_eq!(project(shadow), Some(DVec3::new(0.0, 0.0, -25.0)));
/// # Ok::<(), ombra_shadows::planar::PlanarShadowError>(())
/// ```
///
/// # References
///
/// Bologna, «Ombre su piani in WebGL»; Olomouc, «Projekce na libovolnou plochu». J. Blinn, «Me and my (fake) shadow»,
/// 1988.
#[doc(alias = "shadow projection matrix")]
pub fn shadow_matrix(plane: Plane, light: DVec4) -> Result<DMat4, PlanarShadowError> {
    check_light(light)?;
    if !plane.coefficients().is_finite() {
        return Err(PlanarShadowError::PlaneNotFinite(plane));
    }
    if plane.normal == DVec3::ZERO {
        return Err(PlanarShadowError::NoPlane(plane));
    }
    let l = towards_place(light);
    let pi = match dot(plane.coefficients(), l).0.partial_cmp(&0.0) {
        Some(Ordering::Greater) => plane.coefficients(),
        Some(Ordering::Less) => -plane.coefficients(),
        _ => return Err(PlanarShadowError::LightAlongPlane(light)),
    };
    let plain = entries(pi, l);
    let lost = |x: f64, y: f64| !((x * y).is_normal() || x == 0.0 || y == 0.0);
    let any_lost = pi
        .to_array()
        .iter()
        .any(|&x| l.to_array().iter().any(|&y| lost(x, y)));
    if plain.is_finite() && !any_lost {
        return Ok(plain);
    }
    // Both vectors with their largest coordinate in [1, 2): what vanishes now is 10³⁰⁰ times smaller than the rest.
    let unit = |x: DVec4| DVec4::from(normalised(x.to_array()).0);
    Ok(entries(unit(pi), unit(l)))
}

/// s I − L πᵀ.
fn entries(pi: DVec4, l: DVec4) -> DMat4 {
    let products = pi * l;
    let diagonal = |i: usize| (0..4).filter(|&k| k != i).map(|k| products[k]).sum::<f64>();
    // Adding 0 makes −0 to 0.
    let column = |j: usize| {
        let mut column = l * -pi[j] + DVec4::ZERO;
        column[j] = diagonal(j) + 0.0;
        column
    };
    DMat4::from_cols(column(0), column(1), column(2), column(3))
}

#[cfg(test)]
mod tests;
