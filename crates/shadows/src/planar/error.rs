//! Why there is no shadow matrix, and the check of a light that says so.

use core::fmt;

use ombra_math::glam::DVec4;
use ombra_math::plane::Plane;

/// Why there is no shadow matrix.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum PlanarShadowError {
    /// A coordinate of the light is NaN or infinite.
    LightNotFinite(DVec4),
    /// All four coordinates of the light are zero.
    NoLight,
    /// A coefficient of the plane is NaN or infinite.
    PlaneNotFinite(Plane),
    /// The plane's normal is zero.
    NoPlane(Plane),
    /// The light shines along the plane, or lies on it.
    LightAlongPlane(DVec4),
    /// The direction is so low that L_x/L_y or L_z/L_y is beyond the largest double.
    TooLarge(DVec4),
}

impl fmt::Display for PlanarShadowError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::LightNotFinite(l) => {
                write!(f, "the light {l} has a coordinate that is not finite; all four must be")
            }
            Self::NoLight => f.write_str(
                "the light [0, 0, 0, 0] is neither a place (w = 1) nor a direction (w = 0, not all zero)",
            ),
            Self::PlaneNotFinite(p) => {
                write!(f, "the plane {} has a coefficient that is not finite; all four must be", p.coefficients())
            }
            Self::NoPlane(p) => {
                write!(f, "the plane {} has no normal; it must not be zero", p.coefficients())
            }
            Self::LightAlongPlane(l) => {
                write!(f, "the light {l} shines along the plane or lies on it; it must be off the plane")
            }
            Self::TooLarge(l) => {
                write!(f, "the direction {l} is too low: L_x/L_y or L_z/L_y exceeds the largest double; use shadow_matrix")
            }
        }
    }
}

impl core::error::Error for PlanarShadowError {}

/// A light that is finite and not the zero vector.
pub(super) fn check_light(light: DVec4) -> Result<(), PlanarShadowError> {
    if !light.is_finite() {
        Err(PlanarShadowError::LightNotFinite(light))
    } else if light == DVec4::ZERO {
        Err(PlanarShadowError::NoLight)
    } else {
        Ok(())
    }
}
