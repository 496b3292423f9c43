//! Homogeneous points, directions and lights: four numbers that hold a place (w = 1) or a direction (w = 0).
//!
//! With them one formula serves a light at a place and a light at infinity, and a perspective projection is a
//! matrix followed by one division.
#![doc(alias = "homogeneous coordinates")]

use glam::{DVec3, DVec4};

use crate::exact::dot;

/// The place `p` as a homogeneous point.
///
/// # Formula
///
/// ```text
/// (x, y, z)  →  (x, y, z, 1)
/// ```
///
/// # Properties
///
/// - Error: none.
///
/// # Examples
///
/// ```
/// use ombra_math::glam::{DVec3, DVec4};
/// use ombra_math::homogeneous::point;
///
/// assert_eq!(point(DVec3::new(0.0, 100.0, 100.0)), DVec4::new(0.0, 100.0, 100.0, 1.0));
/// ```
///
/// # References
///
/// Bologna, «Ombre su piani in WebGL»: the light in homogeneous coordinates.
#[must_use]
pub const fn point(p: DVec3) -> DVec4 {
    DVec4::new(p.x, p.y, p.z, 1.0)
}

/// The direction `d` as a point at infinity.
///
/// # Formula
///
/// ```text
/// (x, y, z)  →  (x, y, z, 0)
/// ```
///
/// # Properties
///
/// - Error: none.
///
/// # Pitfalls
///
/// A light's direction points *towards* the light, against the way its rays travel.
///
/// # Examples
///
/// ```
/// use ombra_math::glam::{DVec3, DVec4};
/// use ombra_math::homogeneous::direction;
///
/// assert_eq!(direction(DVec3::splat(10.0)), DVec4::new(10.0, 10.0, 10.0, 0.0));
/// ```
///
/// # References
///
/// CIS 781, «Verifying P_inf will not clip infinitely far away vertices»: the vertex (0, 0, −D, 0).
#[doc(alias = "ideal point")]
#[must_use]
pub const fn direction(d: DVec3) -> DVec4 {
    DVec4::new(d.x, d.y, d.z, 0.0)
}

/// The place that `p` stands for, or `None` where there is none: at infinity (w = 0), or beyond what `f64` holds.
///
/// # Formula
///
/// ```text
/// (x, y, z, w)  →  (x/w, y/w, z/w)          w ≠ 0
/// ```
///
/// # Properties
///
/// `p` and any multiple of it, negative ones included, stand for the same place. Each coordinate is the double
/// nearest to its quotient.
///
/// - Error: none: the nearest double in each coordinate.
///
/// # Pitfalls
///
/// Division forgets the sign of w, and with it whether the point was in front of the eye or behind: clip
/// before dividing.
///
/// # Examples
///
/// ```
/// use ombra_math::glam::{DVec3, DVec4};
/// use ombra_math::homogeneous::project;
///
/// assert_eq!(project(DVec4::new(0.0, 0.0, -2000.0, 80.0)), Some(DVec3::new(0.0, 0.0, -25.0)));
/// assert_eq!(project(DVec4::new(1.0, 2.0, 3.0, 0.0)), None);
/// ```
///
/// # References
///
/// Bologna, «Ombre su piani in WebGL»; Olomouc, «Zdroj světla v bodě».
#[doc(alias = "perspective divide")]
#[must_use]
pub fn project(p: DVec4) -> Option<DVec3> {
    let q = p.truncate() / p.w;
    // A quotient by w = 0 is infinite or NaN, so one check answers for everything; only ±∞ as w would slip by.
    (q.is_finite() && p.w.is_finite()).then_some(q)
}

/// π·P: 0 where the homogeneous point `p` lies on the plane with the coefficients `plane`, positive in front.
///
/// # Formula
///
/// ```text
/// π·P = a x + b y + c z + d w
/// ```
///
/// # Properties
///
/// The relative error is at most ε and the sign exact, unless the value is below the smallest double (then 0) or
/// beyond the largest (then ±∞). NaN if a coordinate is not finite.
///
/// - Error: at most ε |value|, the sign exact; subnormal values half the smallest double more.
///
/// # Pitfalls
///
/// For w < 0 the sign is that of the opposite point.
///
/// # Examples
///
/// ```
/// use ombra_math::glam::{DVec3, DVec4};
/// use ombra_math::homogeneous::{direction, incidence};
/// use ombra_math::plane::Plane;
///
/// // A direction along the plane meets it at infinity.
/// assert_eq!(incidence(Plane::GROUND.coefficients(), direction(DVec3::X)), 0.0);
/// ```
///
/// # References
///
/// Bologna, «Ombre su piani in WebGL»: the factor dot of the matrix.
#[must_use]
pub fn incidence(plane: DVec4, p: DVec4) -> f64 {
    let (value, exponent) = dot(plane, p);
    libm::scalbn(value, exponent)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_multiple_is_the_same_place() {
        let p = DVec4::new(3.0, -1.5, 0.25, 1.0);
        for k in [1.0, -1.0, 80.0, -80.0, 1e300, 1e-300] {
            let q = project(p * k).unwrap();
            assert!(
                (q - p.truncate()).abs().max_element() <= 2.0 * f64::EPSILON * 3.0,
                "{k}"
            );
        }
    }

    #[test]
    fn incidence_at_the_extremes() {
        let plane = DVec4::new(1e300, -1e300, 0.0, 5e-324);
        for (p, expected) in [
            (DVec4::new(1e300, 1e300, 7.0, 1.0), 5e-324),
            (DVec4::new(1e300, 1e300, 7.0, 0.25), 0.0),
            (DVec4::new(1e300, 0.0, 7.0, 1.0), f64::INFINITY),
            (DVec4::new(1.0, 2.0, 0.0, 1.0), -1e300),
        ] {
            assert_eq!(incidence(plane, p), expected, "{p}");
        }
        assert!(incidence(plane, DVec4::NAN).is_nan());
    }

    #[test]
    fn degenerate() {
        let cases = [
            (DVec4::ZERO, None),
            (DVec4::new(0.0, 1.0, 0.0, -0.0), None),
            (DVec4::new(f64::NAN, 1.0, 0.0, 1.0), None),
            (DVec4::new(1.0, 1.0, 0.0, f64::NAN), None),
            (DVec4::new(1.0, 1.0, 0.0, f64::INFINITY), None),
            (DVec4::new(f64::INFINITY, 1.0, 0.0, 1.0), None),
            (DVec4::new(f64::MAX, 0.0, 0.0, 0.5), None),
            (
                DVec4::new(f64::MAX, 0.0, 0.0, 1.0),
                Some(DVec3::new(f64::MAX, 0.0, 0.0)),
            ),
            (DVec4::new(5e-324, 0.0, 0.0, 5e-324), Some(DVec3::X)),
        ];
        for (p, expected) in cases {
            assert_eq!(project(p), expected, "{p}");
        }
    }
}
