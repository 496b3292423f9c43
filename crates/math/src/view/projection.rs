//! From eye coordinates to clip space: frustum, its limit, symmetric perspective, parallel projection.

use core::f64::consts::PI;

use glam::{DMat4, DVec4};

use super::error::{ViewError, finite, positive, whole};
use crate::scaling::{product_over, split};

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
/// The eight corners of the view volume go to the corners of the cube −1 … 1, near to z = −1. Every matrix whose entries
/// a double holds is given, whatever is on the way to them.
///
/// - Error: at most 2 ε |entry| in each entry; subnormal entries half the smallest double more.
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
#[doc(alias = "glFrustum")]
#[doc(alias = "projection matrix")]
pub fn frustum(l: f64, r: f64, b: f64, t: f64, n: f64, f: f64) -> Result<DMat4, ViewError> {
    with_far(window(l, r, b, t, n)?, n, f)
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
/// - Error: at most 2 ε |entry| in each entry; subnormal entries half the smallest double more.
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
#[doc(alias = "infinite projection")]
pub fn frustum_infinite(l: f64, r: f64, b: f64, t: f64, n: f64) -> Result<DMat4, ViewError> {
    let mut m = window(l, r, b, t, n)?;
    m.w_axis.z = -2.0 * n;
    whole(m, "near and the window")
}

/// What the frustum has of its window, the same with and without a far plane; the entry −2n is left out.
fn window(l: f64, r: f64, b: f64, t: f64, n: f64) -> Result<DMat4, ViewError> {
    let shift_x = shift("left and right", l, r)?;
    let shift_y = shift("bottom and top", b, t)?;
    positive("near", n)?;
    let m = DMat4::from_cols(
        DVec4::new(twice_over(n, l, r), 0.0, 0.0, 0.0),
        DVec4::new(0.0, twice_over(n, b, t), 0.0, 0.0),
        DVec4::new(shift_x, shift_y, -1.0, -1.0),
        DVec4::ZERO,
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
/// - Error: at most 3 ε |entry| in each entry; subnormal entries half the smallest double more.
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
#[doc(alias = "gluPerspective")]
#[doc(alias = "field of view")]
#[doc(alias = "fov")]
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
        DVec4::ZERO,
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
/// The corners of the box go to the corners of the cube −1 … 1, near to z = −1; w stays 1, depth is linear.
///
/// - Error: at most 2 ε |entry| in each entry; subnormal entries half the smallest double more.
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
#[doc(alias = "glOrtho")]
#[doc(alias = "parallel projection")]
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

/// 2n/(high − low), also where 2n or the difference alone is beyond the largest double.
fn twice_over(n: f64, low: f64, high: f64) -> f64 {
    let difference = high - low;
    if difference.is_finite() {
        product_over([2.0, n], difference)
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

/// `m` with a far plane: third row −(f+n)/(f−n), −2fn/(f−n).
fn with_far(mut m: DMat4, n: f64, f: f64) -> Result<DMat4, ViewError> {
    positive("far", f)?;
    m.z_axis.z = -shift("near and far", n, f)?;
    // As −2n · f/(f − n), but neither quotient nor product leaves the range of doubles on the way.
    let ((n, n_exponent), (f, f_exponent), (depth, exponent)) = (split(n), split(f), split(f - n));
    m.w_axis.z = -libm::scalbn(n * (f / depth), n_exponent + f_exponent - exponent + 1);
    whole(m, "near and far")
}
