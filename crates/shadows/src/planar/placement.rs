//! Whether a vertex lies between the light and the plane: a true shadow, or a false one.

use core::cmp::Ordering;

use ombra_math::exact::{Sum, dot};
use ombra_math::glam::{DVec3, DVec4};
use ombra_math::homogeneous::point;
use ombra_math::plane::Plane;

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
#[doc(alias = "false shadow")]
#[doc(alias = "anti-shadow")]
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

/// The light with w ≥ 0: −L is the same place.
#[inline]
pub(super) fn towards_place(light: DVec4) -> DVec4 {
    if light.w < 0.0 { -light } else { light }
}

/// s − L_w t, where the plane's d has cancelled.
pub(super) fn denominator(plane: Plane, light: DVec4, v: DVec3) -> Sum {
    let mut sum = Sum::default();
    for i in 0..3 {
        sum.add([plane.normal[i], light[i], 1.0]);
        sum.add([-plane.normal[i], light.w, v[i]]);
    }
    sum
}
