//! Views and projections: where the eye is, what it sees, and which pixel that becomes.
//!
//! Right-handed, column vectors, OpenGL clip space: the eye looks along −z, a point is seen where
//! −w ≤ x, y, z ≤ w. Angles are in radians. All but the viewport are `DMat4`, to be multiplied from the left:
//! projection · view · world.
#![cfg_attr(doc, doc = "")]
#![cfg_attr(doc, doc = include_str!("../figures/frustum.svg"))]

mod error;
mod projection;

pub use error::ViewError;
pub use projection::{frustum, frustum_infinite, orthographic, perspective};

use glam::{DMat4, DVec3, DVec4};

use crate::exact::Sum;
use crate::triangle::{scaled_cross, unit};
use error::{finite, whole};

/// Matrix from world to eye coordinates for an eye at `eye` that looks at `target`, `up` being upwards in the picture.
///
/// # Formula
///
/// ```text
/// f = (target − eye) / |target − eye|
/// s = f × up, made unit            u = s × f
///
///     ⎡  sx   sy   sz  −s·eye ⎤
/// M = ⎢  ux   uy   uz  −u·eye ⎥
///     ⎢ −fx  −fy  −fz   f·eye ⎥
///     ⎣   0    0    0     1   ⎦
/// ```
///
/// # Properties
///
/// The eye goes to the origin, the target to (0, 0, −distance), up into the half-plane x = 0, y > 0. The three
/// axes are unit and at right angles, also where `up` is within rounding of the direction of view.
///
/// - Error: at most 8 ε in each axis; the last column is the nearest double for these axes.
///
/// # Pitfalls
///
/// f·eye rounds at the scale of the eye's distance from the *origin*: a scene far from it jitters, whatever the
/// matrix. Move the origin to the scene instead.
///
/// # Errors
///
/// Coordinates that are not finite; eye and target at one place; `up` zero or exactly parallel to the
/// direction of view; a translation beyond the largest double.
///
/// # Examples
///
/// ```
/// use ombra_math::glam::DVec3;
/// use ombra_math::view::{ViewError, look_at};
///
/// let (eye, target) = (DVec3::new(0.0, 0.0, 5.0), DVec3::ZERO);
/// let m = look_at(eye, target, DVec3::Y).unwrap();
/// assert_eq!(m.transform_point3(target), DVec3::new(0.0, 0.0, -5.0));
///
/// let up = DVec3::Z;
/// assert_eq!(look_at(eye, target, up), Err(ViewError::UpAlongView { up }));
/// ```
///
/// # References
///
/// In no deck; the light's camera of Olomouc, «Stínová paměť hloubky», is one.
#[doc(alias = "look at")]
#[doc(alias = "gluLookAt")]
#[doc(alias = "view matrix")]
pub fn look_at(eye: DVec3, target: DVec3, up: DVec3) -> Result<DMat4, ViewError> {
    for (what, v) in [("eye", eye), ("target", target), ("up", up)] {
        for value in v.to_array() {
            finite(what, value)?;
        }
    }
    // Halves, where the difference itself is too long.
    let d = target - eye;
    let d = if d.is_finite() {
        d
    } else {
        target * 0.5 - eye * 0.5
    };
    let forward = unit(d).ok_or(ViewError::NoDirection { eye })?;
    // Exact signs: zero only if up is parallel to the true direction, not to the rounded one.
    let (side, _) = scaled_cross(eye, target, up);
    let side = unit(side).ok_or(ViewError::UpAlongView { up })?;
    let upward = side.cross(forward);
    let row = |axis: DVec3| {
        let products = [0, 1, 2].map(|i| [-axis[i], eye[i], 1.0]);
        axis.extend(Sum::of(&products).to_f64())
    };
    let m = DMat4::from_cols(row(side), row(upward), row(-forward), DVec4::W).transpose();
    whole(m, "eye coordinates")
}

/// The picture that the cube −1 … 1 is spread over, in pixels.
///
/// # Formula
///
/// ```text
/// x = (x_ndc + 1)/2 · width      y = (1 − y_ndc)/2 · height      z = (z_ndc + 1)/2
/// ```
///
/// # Pitfalls
///
/// Pixel (0, 0) is at the top left and y runs down, so that a counter-clockwise triangle comes out clockwise. Pixel
/// (i, j) covers i … i+1 by j … j+1, and its centre is (i + ½, j + ½).
///
/// # Examples
///
/// ```
/// use ombra_math::glam::DVec3;
/// use ombra_math::view::Viewport;
///
/// let viewport = Viewport { width: 640, height: 480 };
/// assert_eq!(viewport.to_pixel(DVec3::new(-1.0, 1.0, -1.0)), DVec3::ZERO);
/// assert_eq!(viewport.to_pixel(DVec3::ZERO), DVec3::new(320.0, 240.0, 0.5));
/// ```
///
/// # References
///
/// In no deck; the depth range 0 … 1 is OpenGL's default.
#[doc(alias = "NDC")]
#[doc(alias = "normalized device coordinates")]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Viewport {
    /// Columns of pixels.
    pub width: u32,
    /// Rows of pixels.
    pub height: u32,
}

impl Viewport {
    /// The point of the picture for normalised device coordinates, with its depth.
    ///
    /// Total: points outside the cube land outside the picture, NaN gives NaN.
    ///
    /// # Properties
    ///
    /// - Error: at most 2 ε of width, height and 1 for points inside.
    #[doc(alias = "viewport transform")]
    #[must_use]
    pub fn to_pixel(&self, ndc: DVec3) -> DVec3 {
        DVec3::new(
            0.5 * (ndc.x + 1.0) * f64::from(self.width),
            0.5 * (1.0 - ndc.y) * f64::from(self.height),
            0.5 * (ndc.z + 1.0),
        )
    }
}

#[cfg(test)]
mod tests;
