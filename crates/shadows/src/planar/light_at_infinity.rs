//! The shadow on the ground of a light at infinity: all rays are parallel.
//!
//! From a vertex, walk against the direction L towards the light until the height is 0. Nothing is divided by a number that
//! depends on the vertex, so the shadow is an affine map: its matrix has the last row 0 0 0 1.
#![cfg_attr(doc, doc = "")]
#![cfg_attr(doc, doc = include_str!("../../figures/cube-infinity.svg"))]

use ombra_math::glam::{DMat4, DVec3, DVec4};

use super::error::{PlanarShadowError, check_light};

/// The matrix of a light at infinity in the direction `l`, onto the ground y = 0.
///
/// # Formula
///
/// ```text
///     ⎡ 1  −L_x/L_y  0  0 ⎤
/// M = ⎢ 0      0     0  0 ⎥        P_x = V_x − (V_y / L_y) L_x
///     ⎢ 0  −L_z/L_y  1  0 ⎥        P_z = V_z − (V_y / L_y) L_z
///     ⎣ 0      0     0  1 ⎦
/// ```
///
/// # Properties
///
/// w stays 1: no division is needed, and none tells a false shadow from a true one. t = V_y / L_y is negative for a
/// vertex behind the ground.
///
/// - Error: none: each entry is the nearest double.
///
/// # Pitfalls
///
/// A slide's worked answer ends in a row of zeros; the last row of the shadows is w = 1.
///
/// # Errors
///
/// A direction that is not finite or zero; one along the ground (L_y = 0), which casts no shadow; one so low that
/// L_x/L_y or L_z/L_y is beyond the largest double.
///
/// # Examples
///
/// ```
/// use ombra_math::glam::{DVec3, DVec4};
/// use ombra_math::homogeneous::point;
/// use ombra_shadows::planar::ground_matrix_directional;
///
/// let m = ground_matrix_directional(DVec3::splat(10.0))?;
/// assert_eq!(m * point(DVec3::new(10.0, 30.0, 10.0)), DVec4::new(-20.0, 0.0, -20.0, 1.0));
/// # Ok::<(), ombra_shadows::planar::PlanarShadowError>(())
/// ```
///
/// # References
///
/// Olomouc, «Zdroj v nekonečnu».
#[doc(alias = "directional light")]
#[doc(alias = "light at infinity")]
#[doc(alias = "sun")]
pub fn ground_matrix_directional(l: DVec3) -> Result<DMat4, PlanarShadowError> {
    let light = l.extend(0.0);
    check_light(light)?;
    if l.y == 0.0 {
        return Err(PlanarShadowError::LightAlongPlane(light));
    }
    let m = DMat4::from_cols(
        DVec4::X,
        DVec4::new(-l.x / l.y, 0.0, -l.z / l.y, 0.0),
        DVec4::Z,
        DVec4::W,
    );
    if m.is_finite() {
        Ok(m)
    } else {
        Err(PlanarShadowError::TooLarge(light))
    }
}
