//! Views and projections: where the eye is, what it sees, and which pixel that becomes.
//!
//! Right-handed, column vectors, OpenGL clip space: the eye looks along −z, a point is seen where
//! −w ≤ x, y, z ≤ w. Angles are in radians. All but the viewport are `DMat4`, to be multiplied from the left:
//! projection · view · world.
#![cfg_attr(doc, doc = "")]
#![cfg_attr(doc, doc = include_str!("../figures/frustum.svg"))]

use crate::exact::Sum;
use crate::triangle::{scaled_cross, unit};
use core::f64::consts::PI;
use core::fmt;
use glam::{DMat4, DVec3, DVec4};

/// Why there is no such view.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ViewError {
    /// A number is NaN or infinite.
    NotFinite {
        /// The name of the parameter.
        what: &'static str,
        /// Its value.
        value: f64,
    },
    /// Eye and target are the same place.
    NoDirection {
        /// That place.
        eye: DVec3,
    },
    /// The up vector is zero or parallel to the direction of view.
    UpAlongView {
        /// The up vector.
        up: DVec3,
    },
    /// Two opposite planes of the view volume coincide.
    NoExtent {
        /// The names of the two.
        what: &'static str,
        /// Their common value.
        value: f64,
    },
    /// A number that must be positive is not.
    NotPositive {
        /// The name of the parameter.
        what: &'static str,
        /// Its value.
        value: f64,
    },
    /// The field of view does not lie between 0 and π.
    FieldOfView {
        /// The angle in radians.
        fov_y: f64,
    },
    /// An entry of the matrix is beyond the largest double.
    TooLarge {
        /// What the entry is made of.
        what: &'static str,
    },
}

impl fmt::Display for ViewError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::NotFinite { what, value } => {
                write!(f, "{what} is {value}; it must be a finite number")
            }
            Self::NoDirection { eye } => {
                write!(f, "eye and target are both {eye}; they must be two places")
            }
            Self::UpAlongView { up } => write!(
                f,
                "up is {up}, zero or parallel to the direction of view; it must point to a side of it"
            ),
            Self::NoExtent { what, value } => {
                write!(f, "{what} are both {value}; they must differ")
            }
            Self::NotPositive { what, value } => {
                write!(f, "{what} is {value}; it must be greater than 0")
            }
            Self::FieldOfView { fov_y } => write!(
                f,
                "the field of view is {fov_y} rad; it must lie between 0 and π (an angle in degrees, perhaps?)"
            ),
            Self::TooLarge { what } => {
                write!(
                    f,
                    "{what} give an entry beyond the largest f64; bring them closer together"
                )
            }
        }
    }
}

impl core::error::Error for ViewError {}

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
/// axes are unit and at right angles within 8 ε, and point where the exact ones do within 8 ε, even where `up` is
/// within rounding of the direction of view; the last column is the exact product of those axes with the
/// eye, rounded once.
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

/// Perspective projection through the window l … r, b … t of the near plane at distance `n`; far plane at `f`.
///
/// # Formula
///
/// ```text
/// ⎡ 2n/(r−l)     0       (r+l)/(r−l)       0      ⎤
/// ⎢    0      2n/(t−b)   (t+b)/(t−b)       0      ⎥
/// ⎢    0         0      −(f+n)/(f−n)  −2fn/(f−n)  ⎥
/// ⎣    0         0           −1            0      ⎦
/// ```
///
/// # Properties
///
/// The eight corners of the view volume go to the corners of the cube −1 … 1, near to z = −1. Each entry
/// is within 4 ε of itself, subnormal ones aside.
///
/// # Pitfalls
///
/// As in OpenGL `n` and `f` are distances, so positive, though the planes lie at −n and −f. l > r, b > t or n > f is
/// allowed and mirrors that axis. Depth crowds towards 1: half of it is spent between n and 2nf/(f+n).
///
/// # Errors
///
/// A number that is not finite; n or f not positive; l = r, b = t or n = f; an entry beyond the largest double.
///
/// # Examples
///
/// ```
/// use ombra_math::glam::{DVec3, DVec4};
/// use ombra_math::view::frustum;
///
/// let m = frustum(-1.0, 1.0, -1.0, 1.0, 1.0, 3.0).unwrap();
/// assert_eq!(m.project_point3(DVec3::new(1.0, 1.0, -1.0)), DVec3::new(1.0, 1.0, -1.0));
/// assert_eq!(m.project_point3(DVec3::new(3.0, -3.0, -3.0)), DVec3::new(1.0, -1.0, 1.0));
/// ```
///
/// # References
///
/// CIS 781, «Standard glFrustum Projection Matrix».
pub fn frustum(l: f64, r: f64, b: f64, t: f64, n: f64, f: f64) -> Result<DMat4, ViewError> {
    let infinite = frustum_infinite(l, r, b, t, n)?;
    with_far(infinite, n, f)
}

/// Perspective projection without a far plane: the limit of [`frustum`] for f → ∞.
///
/// # Formula
///
/// ```text
/// ⎡ 2n/(r−l)     0       (r+l)/(r−l)    0  ⎤
/// ⎢    0      2n/(t−b)   (t+b)/(t−b)    0  ⎥
/// ⎢    0         0           −1        −2n ⎥
/// ⎣    0         0           −1         0  ⎦
/// ```
///
/// # Properties
///
/// The vertex at infinity straight ahead, (0, 0, −D, 0), gets z = w = D, so no far plane ever cuts it; nor do the
/// sides if l ≤ 0 ≤ r and b ≤ 0 ≤ t. [`frustum`] tends to it: the third rows differ by 2n/(f−n) and 2n²/(f−n).
///
/// # Pitfalls
///
/// z = w is on the border: rounding of a later product can push a vertex at infinity beyond it. Clip with `≤`.
///
/// # Errors
///
/// As [`frustum`], but for f.
///
/// # Examples
///
/// ```
/// use ombra_math::glam::DVec4;
/// use ombra_math::view::frustum_infinite;
///
/// let m = frustum_infinite(-1.0, 2.0, -1.0, 1.0, 0.5).unwrap();
/// assert_eq!(m.row(2), DVec4::new(0.0, 0.0, -1.0, -1.0));
/// let p = m * DVec4::new(0.0, 0.0, -7.0, 0.0);
/// assert_eq!((p.z, p.w), (7.0, 7.0));
/// ```
///
/// # References
///
/// CIS 781, «Limit glFrustum Matrix as Far Plane is Moved to Infinity» and «Verifying P_inf Will Not Clip
/// Infinitely Far Away Vertices».
pub fn frustum_infinite(l: f64, r: f64, b: f64, t: f64, n: f64) -> Result<DMat4, ViewError> {
    let shift_x = shift("left and right", l, r)?;
    let shift_y = shift("bottom and top", b, t)?;
    positive("near", n)?;
    let m = DMat4::from_cols(
        DVec4::new(twice_over(n, l, r), 0.0, 0.0, 0.0),
        DVec4::new(0.0, twice_over(n, b, t), 0.0, 0.0),
        DVec4::new(shift_x, shift_y, -1.0, -1.0),
        DVec4::new(0.0, 0.0, -2.0 * n, 0.0),
    );
    whole(m, "near and the window")
}

/// Symmetric perspective projection with vertical field of view `fov_y` and `aspect` = width / height.
///
/// # Formula
///
/// ```text
/// t = n tan(fov_y / 2)     r = aspect · t     frustum(−r, r, −t, t, n, f)
/// ```
///
/// # Properties
///
/// The scale of x and y does not depend on n.
///
/// # Pitfalls
///
/// `fov_y` is the whole angle from the lower to the upper border, in radians; the horizontal one is not aspect times as
/// large.
///
/// # Errors
///
/// `fov_y` outside 0 … π (degrees, perhaps), `aspect`, n or f not positive, n = f, numbers that are not finite.
///
/// # Examples
///
/// ```
/// use core::f64::consts::FRAC_PI_2;
/// use ombra_math::view::{ViewError, perspective};
///
/// let m = perspective(FRAC_PI_2, 2.0, 1.0, 100.0).unwrap();
/// assert!((m.y_axis.y - 1.0).abs() < 1e-15 && (m.x_axis.x - 0.5).abs() < 1e-15);
/// assert_eq!(perspective(90.0, 2.0, 1.0, 100.0), Err(ViewError::FieldOfView { fov_y: 90.0 }));
/// ```
///
/// # References
///
/// CIS 781, «Standard glFrustum Projection Matrix», in its symmetric form.
pub fn perspective(fov_y: f64, aspect: f64, n: f64, f: f64) -> Result<DMat4, ViewError> {
    finite("the field of view", fov_y)?;
    if fov_y <= 0.0 || fov_y >= PI {
        return Err(ViewError::FieldOfView { fov_y });
    }
    positive("aspect", aspect)?;
    positive("near", n)?;
    let y = 1.0 / libm::tan(0.5 * fov_y);
    let m = DMat4::from_cols(
        DVec4::new(y / aspect, 0.0, 0.0, 0.0),
        DVec4::new(0.0, y, 0.0, 0.0),
        DVec4::new(0.0, 0.0, -1.0, -1.0),
        DVec4::new(0.0, 0.0, -2.0 * n, 0.0),
    );
    with_far(whole(m, "field of view, aspect and near")?, n, f)
}

/// Parallel projection of the box l … r, b … t, −n … −f.
///
/// # Formula
///
/// ```text
/// ⎡ 2/(r−l)     0        0      −(r+l)/(r−l) ⎤
/// ⎢    0     2/(t−b)     0      −(t+b)/(t−b) ⎥
/// ⎢    0        0    −2/(f−n)   −(f+n)/(f−n) ⎥
/// ⎣    0        0        0            1      ⎦
/// ```
///
/// # Properties
///
/// The corners of the box go to the corners of the cube −1 … 1, near to z = −1; w stays 1, depth is linear. Each
/// entry is within 4 ε of itself, subnormal ones aside.
///
/// # Pitfalls
///
/// n and f are distances ahead of the eye, so the planes lie at −n and −f; a negative n lies behind it.
///
/// # Errors
///
/// A number that is not finite; l = r, b = t or n = f; an entry beyond the largest double.
///
/// # Examples
///
/// ```
/// use ombra_math::glam::DVec3;
/// use ombra_math::view::orthographic;
///
/// let m = orthographic(0.0, 8.0, 0.0, 6.0, -1.0, 1.0).unwrap();
/// assert_eq!(m.transform_point3(DVec3::new(8.0, 3.0, 0.0)), DVec3::new(1.0, 0.0, 0.0));
/// ```
///
/// # References
///
/// In no deck; the camera of a light at infinity.
pub fn orthographic(l: f64, r: f64, b: f64, t: f64, n: f64, f: f64) -> Result<DMat4, ViewError> {
    let shift_x = shift("left and right", l, r)?;
    let shift_y = shift("bottom and top", b, t)?;
    let shift_z = shift("near and far", n, f)?;
    let m = DMat4::from_cols(
        DVec4::new(twice_over(1.0, l, r), 0.0, 0.0, 0.0),
        DVec4::new(0.0, twice_over(1.0, b, t), 0.0, 0.0),
        DVec4::new(0.0, 0.0, -twice_over(1.0, n, f), 0.0),
        DVec4::new(-shift_x, -shift_y, -shift_z, 1.0),
    );
    whole(m, "the sides of the box")
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
    /// Total: points outside the cube land outside the picture, NaN gives NaN. Within 2 ε of width, height
    /// and 1 for points inside.
    #[must_use]
    pub fn to_pixel(&self, ndc: DVec3) -> DVec3 {
        DVec3::new(
            0.5 * (ndc.x + 1.0) * f64::from(self.width),
            0.5 * (1.0 - ndc.y) * f64::from(self.height),
            0.5 * (ndc.z + 1.0),
        )
    }
}

/// 2n/(high − low), also where 2n or the difference alone is beyond the largest double.
fn twice_over(n: f64, low: f64, high: f64) -> f64 {
    let (twice, difference) = (2.0 * n, high - low);
    if twice.is_finite() && difference.is_finite() {
        twice / difference
    } else {
        n / (0.5 * high - 0.5 * low)
    }
}

/// (high + low)/(high − low), once the two are finite and differ.
fn shift(what: &'static str, low: f64, high: f64) -> Result<f64, ViewError> {
    finite(what, low)?;
    finite(what, high)?;
    if low == high {
        return Err(ViewError::NoExtent { what, value: low });
    }
    let (sum, difference) = (high + low, high - low);
    if sum.is_finite() && difference.is_finite() {
        return Ok(sum / difference);
    }
    Ok((0.5 * high + 0.5 * low) / (0.5 * high - 0.5 * low))
}

/// `infinite` with a far plane: third row −(f+n)/(f−n), −2fn/(f−n).
fn with_far(infinite: DMat4, n: f64, f: f64) -> Result<DMat4, ViewError> {
    positive("far", f)?;
    let scale = shift("near and far", n, f)?;
    let mut m = infinite;
    m.z_axis.z = -scale;
    m.w_axis.z = -2.0 * n * (f / (f - n));
    whole(m, "near and far")
}

fn finite(what: &'static str, value: f64) -> Result<(), ViewError> {
    if value.is_finite() {
        Ok(())
    } else {
        Err(ViewError::NotFinite { what, value })
    }
}

fn positive(what: &'static str, value: f64) -> Result<(), ViewError> {
    finite(what, value)?;
    if value > 0.0 {
        Ok(())
    } else {
        Err(ViewError::NotPositive { what, value })
    }
}

fn whole(m: DMat4, what: &'static str) -> Result<DMat4, ViewError> {
    if m.is_finite() {
        Ok(m)
    } else {
        Err(ViewError::TooLarge { what })
    }
}

#[cfg(test)]
mod tests;
