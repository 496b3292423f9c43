//! The shadow on the ground of a light at a place: the rays spread.
//!
//! Two similar triangles stand on the ground, the large one from the light to the shadow, the small one from the vertex to
//! the shadow. Their proportion has the vertex's height in the denominator, so as a matrix this is a perspective
//! projection: the division by w comes last.
#![cfg_attr(doc, doc = "")]
#![cfg_attr(doc, doc = include_str!("../../figures/planar-similar-triangles.svg"))]
#![cfg_attr(doc, doc = include_str!("../../figures/cube-point.svg"))]

use ombra_math::glam::{DMat4, DVec3, DVec4};

use super::error::{PlanarShadowError, check_light};

/// The matrix of a light at the place `l`, onto the ground y = 0.
///
/// # Formula
///
/// ```text
///     ⎡ L_y  −L_x   0    0  ⎤
/// M = ⎢  0     0    0    0  ⎥        P_x = (L_y V_x − L_x V_y) / (L_y − V_y)
///     ⎢  0   −L_z  L_y   0  ⎥        P_z = (L_y V_z − L_z V_y) / (L_y − V_y)
///     ⎣  0    −1    0   L_y ⎦
/// ```
///
/// # Properties
///
/// w = L_y − V_y: positive for a vertex below the light, whose shadow is true if it is also above the ground.
///
/// - Error: none.
///
/// # Pitfalls
///
/// With a light below the ground (L_y < 0) the signs turn over: w is negative for the true shadows of what hangs
/// below. [`shadow_matrix`](super::shadow_matrix) turns the plane round instead.
///
/// # Errors
///
/// A place that is not finite, or on the ground (L_y = 0).
///
/// # Examples
///
/// ```
/// use ombra_math::glam::{DVec3, DVec4};
/// use ombra_math::homogeneous::point;
/// use ombra_shadows::planar::ground_matrix_point;
///
/// let m = ground_matrix_point(DVec3::new(0.0, 100.0, 100.0))?;
/// assert_eq!(m * point(DVec3::new(10.0, 20.0, 10.0)), DVec4::new(1000.0, 0.0, -1000.0, 80.0));
/// # Ok::<(), ombra_shadows::planar::PlanarShadowError>(())
/// ```
///
/// # References
///
/// Bologna, «Ombre su piani», special case; Olomouc, «Zdroj světla v bodě».
#[doc(alias = "point light")]
pub fn ground_matrix_point(l: DVec3) -> Result<DMat4, PlanarShadowError> {
    let light = l.extend(1.0);
    check_light(light)?;
    if l.y == 0.0 {
        return Err(PlanarShadowError::LightAlongPlane(light));
    }
    Ok(DMat4::from_cols(
        DVec4::new(l.y, 0.0, 0.0, 0.0),
        DVec4::new(-l.x, 0.0, -l.z, -1.0),
        DVec4::new(0.0, 0.0, l.y, 0.0),
        DVec4::new(0.0, 0.0, 0.0, l.y),
    ))
}
