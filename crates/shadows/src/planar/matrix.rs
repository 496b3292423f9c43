//! The shadow as a matrix, for a pipeline that multiplies every vertex by one anyway.

use core::cmp::Ordering;
use core::fmt;

use ombra_math::exact::dot;
use ombra_math::glam::{DMat4, DVec3, DVec4};
use ombra_math::plane::Plane;
use ombra_math::scaling::normalised;

use super::exact_cast::towards_place;

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
/// - The diagonal is summed without the term that cancels. Each entry is within 2ε of its terms, or
///   in a scaled matrix within the last place of a subnormal.
/// - A matrix with an entry that would overflow, or underflow and lose digits, is scaled by a power of two (as a
///   homogeneous matrix it is the same).
///
/// # Pitfalls
///
/// - Bologna's slide prints the transpose (erratum E1): Lπᵀ has the rows L_x (a, b, c, d), L_y (a, b, c, d), …; what it shows is what a
///   column-major array of those rows looks like. Olomouc's has one entry wrong and stands for row
///   vectors (E2).
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
/// # Pitfalls
///
/// With a light below the ground (L_y < 0) the signs turn over: w is negative for the true shadows of what hangs
/// below. [`shadow_matrix`] turns the plane round instead.
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

fn check_light(light: DVec4) -> Result<(), PlanarShadowError> {
    if !light.is_finite() {
        Err(PlanarShadowError::LightNotFinite(light))
    } else if light == DVec4::ZERO {
        Err(PlanarShadowError::NoLight)
    } else {
        Ok(())
    }
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
mod tests {
    use super::*;

    #[test]
    fn sentences_name_the_value() {
        let bad = DVec4::new(f64::NAN, 1.0, 0.0, 1.0);
        let message = shadow_matrix(Plane::GROUND, bad).unwrap_err().to_string();
        assert!(
            message.contains("[NaN, 1, 0, 1]") && message.contains("finite"),
            "{message}"
        );
        let message = shadow_matrix(Plane::GROUND, DVec4::X)
            .unwrap_err()
            .to_string();
        assert!(
            message.contains("[1, 0, 0, 0]") && message.contains("along the plane"),
            "{message}"
        );
    }

    #[test]
    fn the_light_is_in_the_kernel_and_the_plane_is_kept() {
        let plane = Plane {
            normal: DVec3::new(1.0, 2.0, 3.0),
            d: 4.0,
        };
        let light = DVec4::new(3.0, 7.0, 2.0, 1.0);
        let m = shadow_matrix(plane, light).unwrap();
        assert_eq!(m * light, DVec4::ZERO);
        let on_plane = DVec4::new(-4.0, 0.0, 0.0, 1.0);
        assert_eq!(m * on_plane, on_plane * plane.coefficients().dot(light));
        // The corrected entries of the slide's matrix, as rows of the transpose.
        assert_eq!(m.row(3), DVec4::new(-1.0, -2.0, -3.0, 23.0));
        assert_eq!(m * DVec4::ONE, DVec4::new(-3.0, -43.0, 7.0, 17.0));
    }

    #[test]
    fn ground_matrices_are_the_general_one() {
        let l = DVec3::new(0.0, 100.0, 100.0);
        assert_eq!(
            shadow_matrix(Plane::GROUND, l.extend(1.0)),
            ground_matrix_point(l)
        );
        let l = DVec3::splat(10.0);
        let general = shadow_matrix(Plane::GROUND, l.extend(0.0)).unwrap();
        assert_eq!(general / 10.0, ground_matrix_directional(l).unwrap());
    }

    #[test]
    fn a_turned_plane_or_light_is_the_same() {
        let plane = Plane {
            normal: DVec3::new(1.0, -2.0, 0.5),
            d: 3.0,
        };
        for light in [
            DVec4::new(3.0, 9.0, -2.0, 1.0),
            DVec4::new(3.0, 9.0, -2.0, 0.0),
        ] {
            let m = shadow_matrix(plane, light).unwrap();
            assert_eq!(shadow_matrix(plane.turned(), light).unwrap(), m);
            if light.w != 0.0 {
                assert_eq!(shadow_matrix(plane, -light).unwrap(), m);
            }
        }
    }

    #[test]
    fn extremes_are_scaled_or_refused() {
        let tall = Plane {
            normal: DVec3::Y * 1e300,
            d: 0.0,
        };
        let m = shadow_matrix(tall, DVec4::new(1e300, 1e300, 0.0, 1.0)).unwrap();
        let p = m * DVec4::new(0.0, 1e290, 0.0, 1.0);
        assert!((p.x / p.w + 1e290).abs() < 1e280, "{p}");
        let tiny = Plane {
            normal: DVec3::Y * 1e-300,
            d: 0.0,
        };
        let m = shadow_matrix(tiny, DVec4::new(0.0, 1e-300, 1e-300, 0.0)).unwrap();
        assert_eq!(
            m * DVec4::new(0.0, 5.0, 0.0, 1.0) / m.w_axis.w,
            DVec4::new(0.0, 0.0, -5.0, 1.0)
        );
        assert_eq!(
            ground_matrix_directional(DVec3::new(1e300, 1e-300, 0.0)),
            Err(PlanarShadowError::TooLarge(DVec4::new(
                1e300, 1e-300, 0.0, 0.0
            )))
        );
        for (plane, light) in [
            (
                Plane {
                    normal: DVec3::ZERO,
                    d: 1.0,
                },
                DVec4::ONE,
            ),
            (
                Plane {
                    normal: DVec3::NAN,
                    d: 1.0,
                },
                DVec4::ONE,
            ),
            (
                Plane {
                    normal: DVec3::Y,
                    d: f64::INFINITY,
                },
                DVec4::ONE,
            ),
            (Plane::GROUND, DVec4::ZERO),
            (Plane::GROUND, DVec4::INFINITY),
            (Plane::GROUND, DVec4::new(1.0, 0.0, 3.0, 1.0)),
        ] {
            assert!(shadow_matrix(plane, light).is_err(), "{plane:?} {light}");
        }
    }
}
