//! Planes n·X + d = 0: what light falls on and polygons are clipped against.
//!
//! The normal need not be a unit vector, so the slides' integer planes stay integers. Which side a point lies
//! on is decided exactly.
#![cfg_attr(doc, doc = "")]
#![cfg_attr(doc, doc = include_str!("../figures/plane.svg"))]

use core::cmp::Ordering;

use glam::{DVec3, DVec4};

use crate::exact::{Sum, dot};
use crate::homogeneous::point;
use crate::scaling::{common, normalised};

/// The points X with n·X + d = 0.
///
/// # Formula
///
/// ```text
/// n·X + d = a x + b y + c z + d = 0        n = (a, b, c), of any length but 0
/// d = −n·Q                                 for a point Q of the plane
/// ```
///
/// # Properties
///
/// Any multiple of the coefficients is the same plane; a negative one turns its front to the other side.
///
/// # Examples
///
/// ```
/// use ombra_math::glam::DVec3;
/// use ombra_math::plane::Plane;
///
/// let wall = Plane::through(DVec3::new(0.0, 0.0, -40.0), DVec3::new(0.0, 0.0, 2.0)).unwrap();
/// assert_eq!(wall.d, 80.0);
/// assert_eq!(wall.signed_distance(DVec3::new(5.0, 7.0, -37.0)), 3.0);
/// ```
///
/// # References
///
/// Bologna, «Ombre su piani», general case; Olomouc, «Projekce na libovolnou plochu».
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane {
    /// n = (a, b, c), towards the plane's front.
    pub normal: DVec3,
    /// d = −n·Q.
    pub d: f64,
}

impl Plane {
    /// The ground of the lectures' examples, y = 0, seen from above.
    pub const GROUND: Self = Self {
        normal: DVec3::Y,
        d: 0.0,
    };

    /// The plane through `point` with the given `normal`, or `None` if there is none: the normal is zero, a
    /// coordinate is not finite, or d is beyond the largest double.
    ///
    /// # Formula
    ///
    /// ```text
    /// d = −n·Q
    /// ```
    ///
    /// # Properties
    ///
    /// d is the double nearest to −n·Q, also where its three products cancel.
    ///
    /// - Error: none: d is the nearest double.
    ///
    /// # Examples
    ///
    /// ```
    /// use ombra_math::glam::DVec3;
    /// use ombra_math::plane::Plane;
    ///
    /// assert_eq!(Plane::through(DVec3::ZERO, DVec3::Y), Some(Plane::GROUND));
    /// assert_eq!(Plane::through(DVec3::ZERO, DVec3::ZERO), None);
    /// ```
    ///
    /// # References
    ///
    /// Bologna, «Ombre su piani», general case.
    #[must_use]
    pub fn through(point: DVec3, normal: DVec3) -> Option<Self> {
        let dot = Sum::of(&[
            [-normal.x, point.x, 1.0],
            [-normal.y, point.y, 1.0],
            [-normal.z, point.z, 1.0],
        ]);
        let plane = Self {
            normal,
            d: dot.to_f64(),
        };
        (plane.d.is_finite() && normal != DVec3::ZERO).then_some(plane)
    }

    /// The plane of the triangle a b c, its front where they run counter-clockwise, or `None` for a triangle
    /// without one: collinear or coinciding points, a coordinate that is not finite.
    ///
    /// # Formula
    ///
    /// ```text
    /// n = AB × AC          d = −n·A
    /// ```
    ///
    /// # Properties
    ///
    /// Whether the points are collinear is decided exactly, and each coordinate of n is the nearest double. Where
    /// n or d would leave the range of doubles, the plane is scaled by a power of two.
    ///
    /// - Error: none: each is the nearest double, times a power of two common to all.
    ///
    /// # Examples
    ///
    /// ```
    /// use ombra_math::glam::{DVec3, DVec4};
    /// use ombra_math::plane::Plane;
    ///
    /// let (a, b, c) = (DVec3::ZERO, DVec3::new(10.0, 0.0, 5.0), DVec3::new(3.0, 2.0, 5.0));
    /// let plane = Plane::of_triangle(a, b, c).unwrap();
    /// assert_eq!(plane.coefficients(), DVec4::new(-10.0, -35.0, 20.0, 0.0));
    /// ```
    ///
    /// # References
    ///
    /// Olomouc, «Flat shading», first example.
    #[must_use]
    pub fn of_triangle(a: DVec3, b: DVec3, c: DVec3) -> Option<Self> {
        // (b − a) × (c − a) = a×b + b×c + c×a, so no difference is rounded; d = −det(a, b, c).
        let component = |i: usize, j: usize| {
            let minor = |p: DVec3, q: DVec3| [[p[i], q[j], 1.0], [-p[j], q[i], 1.0]];
            Sum::of(&[minor(a, b), minor(b, c), minor(c, a)].concat())
        };
        let determinant = [(0, 1, 2), (1, 2, 0), (2, 0, 1)]
            .map(|(i, j, k)| [[-a[i], b[j], c[k]], [a[i], b[k], c[j]]])
            .concat();
        let sums = [
            component(1, 2),
            component(2, 0),
            component(0, 1),
            Sum::of(&determinant),
        ];
        if sums.iter().any(|sum| sum.sign().is_none()) {
            return None;
        }
        let plain = sums.each_ref().map(Sum::to_f64);
        let lost =
            |(sum, &x): (&Sum, &f64)| !(x.is_normal() || sum.sign() == Some(Ordering::Equal));
        let [x, y, z, d] = if sums.iter().zip(&plain).any(lost) {
            // Bring the largest coefficient to the exponent 0.
            common(sums.each_ref().map(Sum::to_scaled)).0
        } else {
            plain
        };
        let normal = DVec3::new(x, y, z);
        (normal != DVec3::ZERO).then_some(Self { normal, d })
    }

    /// The Euclidean distance of `p` from the plane, positive in front of it.
    ///
    /// # Formula
    ///
    /// ```text
    /// (n·p + d) / ‖n‖
    /// ```
    ///
    /// # Properties
    ///
    /// The sign is right for finite input, and the relative error at most 4ε, also where n·p and d cancel and for
    /// normals of any length. A subnormal distance is within its last place, one below the smallest double is 0 (see
    /// [`Plane::side`]), one beyond the largest ±∞. NaN if a coordinate of `p` or of the plane is not finite or the normal is zero.
    ///
    /// - Error: at most 4 ε |value|, the sign exact; subnormal values their last place.
    ///
    /// # Pitfalls
    ///
    /// Without the division the value grows with the normal's length: a sign, not a distance.
    ///
    /// # Examples
    ///
    /// ```
    /// use ombra_math::glam::DVec3;
    /// use ombra_math::plane::Plane;
    ///
    /// let plane = Plane { normal: DVec3::new(0.0, 3.0, 4.0), d: -5.0 };
    /// assert_eq!(plane.signed_distance(DVec3::ZERO), -1.0);
    /// ```
    ///
    /// # References
    ///
    /// Bologna, «Ombre su piani», general case.
    #[doc(alias = "point-plane distance")]
    #[must_use]
    pub fn signed_distance(&self, p: DVec3) -> f64 {
        let largest = self.normal.abs().max_element();
        if largest == 0.0 || !largest.is_finite() {
            return f64::NAN;
        }
        let (normal, scale) = normalised(self.normal.to_array());
        let (value, exponent) = dot(self.coefficients(), point(p));
        libm::scalbn(value / DVec3::from(normal).length(), exponent - scale)
    }

    /// Which side `p` lies on: `Greater` in front, `Equal` exactly on the plane, `Less` behind; `None` if a
    /// coordinate is not finite.
    ///
    /// # Formula
    ///
    /// ```text
    /// sign(n·p + d)
    /// ```
    ///
    /// # Properties
    ///
    /// Exact for all finite input, from subnormal to `f64::MAX`.
    ///
    /// # Examples
    ///
    /// ```
    /// use core::cmp::Ordering;
    /// use ombra_math::glam::DVec3;
    /// use ombra_math::plane::Plane;
    ///
    /// assert_eq!(Plane::GROUND.side(DVec3::new(1e300, 5e-324, 0.0)), Some(Ordering::Greater));
    /// assert_eq!(Plane::GROUND.side(DVec3::NAN), None);
    /// ```
    #[doc(alias = "half-space")]
    #[must_use]
    pub fn side(&self, p: DVec3) -> Option<Ordering> {
        dot(self.coefficients(), point(p)).0.partial_cmp(&0.0)
    }

    /// The plane moved by `distance` towards its front.
    ///
    /// # Formula
    ///
    /// ```text
    /// d' = d − distance ‖n‖
    /// ```
    ///
    /// # Properties
    ///
    /// What a shadow polygon needs so that it does not fight with its receiver for the same depth: cast it onto the
    /// receiver's plane moved by the bias towards the light.
    ///
    /// - Error: at most 3 ε |distance| ‖n‖ + ½ ε |d'| in d'.
    ///
    /// # Examples
    ///
    /// ```
    /// use ombra_math::glam::DVec3;
    /// use ombra_math::plane::Plane;
    ///
    /// assert_eq!(Plane::GROUND.offset(0.5).signed_distance(DVec3::ZERO), -0.5);
    /// ```
    ///
    /// # References
    ///
    /// Olomouc, «Projekční metody», the shadow polygon above or below its plane; Croatian 8.4, projected shadows
    /// (bias).
    #[must_use]
    pub fn offset(&self, distance: f64) -> Self {
        let (normal, scale) = normalised(self.normal.to_array());
        let shift = libm::scalbn(distance * DVec3::from(normal).length(), scale);
        Self {
            normal: self.normal,
            d: self.d - shift,
        }
    }

    /// The same plane with its front on the other side.
    ///
    /// # Properties
    ///
    /// - Error: none.
    #[must_use]
    pub fn turned(&self) -> Self {
        Self {
            normal: -self.normal,
            d: -self.d,
        }
    }

    /// The plane as a 4-vector π = (a, b, c, d), so that π·P = 0 for homogeneous points P of the plane.
    ///
    /// # Properties
    ///
    /// - Error: none.
    ///
    /// # Examples
    ///
    /// ```
    /// use ombra_math::glam::DVec4;
    /// use ombra_math::plane::Plane;
    ///
    /// assert_eq!(Plane::GROUND.coefficients(), DVec4::Y);
    /// ```
    ///
    /// # References
    ///
    /// Bologna, «Ombre su piani in WebGL».
    #[must_use]
    pub const fn coefficients(&self) -> DVec4 {
        DVec4::new(self.normal.x, self.normal.y, self.normal.z, self.d)
    }
}

#[cfg(test)]
mod tests;
