//! Spherical coordinates: distance r, polar angle θ from the z axis, azimuth φ from the x axis; and the areas
//! and solid angles that a range of θ and φ covers.
//!
//! All angles are in radians. A direction is (θ, φ) alone, a point of the unit sphere.
#![cfg_attr(doc, doc = "")]
#![cfg_attr(doc, doc = include_str!("../figures/spherical.svg"))]
#![doc(alias = "polar coordinates")]

use core::f64::consts::TAU;
use core::ops::Range;
use glam::DVec3;

use crate::double_double::DoubleDouble;
use crate::scaling::{normalised, product_over};

/// The plane angle of a full circle, 2π rad.
pub const FULL_CIRCLE: f64 = TAU;

/// The solid angle of the full sphere, 4π sr.
pub const FULL_SPHERE: f64 = 2.0 * TAU;

/// A place by its distance and direction from the origin.
///
/// # Formula
///
/// ```text
/// x = r cos φ sin θ        r = √(x² + y² + z²)
/// y = r sin φ sin θ        θ = atan2(√(x² + y²), z)      0 ≤ θ ≤ π
/// z = r cos θ              φ = atan2(y, x)              −π ≤ φ ≤ π
/// ```
///
/// # Pitfalls
///
/// θ is the angle from the pole, 0 along +z, and not the elevation above the horizon. tan φ is y / x; only
/// `atan2(y, x)` tells a direction from the opposite one, which a bare arctangent confuses.
///
/// # Examples
///
/// ```
/// use core::f64::consts::{FRAC_PI_2, PI};
/// use ombra_math::glam::DVec3;
/// use ombra_math::spherical::Spherical;
///
/// let west = Spherical::from_cartesian(DVec3::new(-2.0, 0.0, 0.0));
/// assert_eq!(west, Spherical { r: 2.0, theta: FRAC_PI_2, phi: PI });
/// assert_eq!(Spherical { r: 3.0, theta: 0.0, phi: 1.0 }.to_cartesian(), DVec3::new(0.0, 0.0, 3.0));
/// ```
///
/// # References
///
/// Olomouc, «Prostorové úhly».
#[doc(alias = "azimuth")]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Spherical {
    /// Distance from the origin.
    pub r: f64,
    /// Polar angle, from +z towards the xy plane.
    pub theta: f64,
    /// Azimuth, from +x towards +y.
    pub phi: f64,
}

impl Spherical {
    /// Spherical coordinates of the point `p`.
    ///
    /// # Properties
    ///
    /// There and back again is within 8 ε·r in each coordinate. At the poles φ has no meaning: on the axis with
    /// x = y = +0 it is 0; the origin has r = θ = φ = 0. Signs of zero count as they do for `atan2`:
    /// (−1, −0, 0) has φ = −π.
    ///
    /// - Error: at most 2 ε of itself for r, θ and φ; subnormal ones their last place.
    ///
    /// # Pitfalls
    ///
    /// r is ∞ where the distance is beyond the largest double; the angles are right even there. A point
    /// with a coordinate that is not finite has none: all three are NaN.
    #[must_use]
    pub fn from_cartesian(p: DVec3) -> Self {
        if !p.is_finite() {
            return Self {
                r: f64::NAN,
                theta: f64::NAN,
                phi: f64::NAN,
            };
        }
        let ([x, y, z], exponent) = normalised(p.to_array());
        let across = libm::hypot(x, y);
        Self {
            r: libm::scalbn(libm::hypot(across, z), exponent),
            theta: libm::atan2(across, z),
            // From the unscaled ones, where a small coordinate still has all its digits.
            phi: libm::atan2(p.y, p.x),
        }
    }

    /// The point with these coordinates.
    ///
    /// # Properties
    ///
    /// Any θ and φ are taken, a negative r is the opposite point.
    ///
    /// - Error: at most 4 ε r in each coordinate.
    ///
    /// # Pitfalls
    ///
    /// π is not a double, so θ = π gives not the south pole but a point 1.2·10⁻¹⁶ r beside it.
    #[must_use]
    pub fn to_cartesian(&self) -> DVec3 {
        let (sin_theta, cos_theta) = libm::sincos(self.theta);
        let (sin_phi, cos_phi) = libm::sincos(self.phi);
        DVec3::new(cos_phi * sin_theta, sin_phi * sin_theta, cos_theta) * self.r
    }
}

/// Area of the differential patch at polar angle `theta` on a sphere of radius `r`, per dθ dφ.
///
/// # Formula
///
/// ```text
/// dA = r² sin θ dθ dφ
/// ```
///
/// # Properties
///
/// Right wherever a double holds it, also where r² alone is too large or too small.
///
/// - Error: at most 2 ε |value|; subnormal values their last place.
///
/// # Pitfalls
///
/// Patches of equal dθ and dφ shrink towards the poles; directions drawn evenly in θ and φ crowd there.
///
/// # Examples
///
/// ```
/// use core::f64::consts::FRAC_PI_2;
/// use ombra_math::spherical::area_element;
///
/// assert_eq!(area_element(3.0, FRAC_PI_2), 9.0); // at the equator
/// assert_eq!(area_element(3.0, 0.0), 0.0); // at the pole
/// ```
///
/// # References
///
/// Olomouc, «Diferenciální plocha».
#[must_use]
pub fn area_element(r: f64, theta: f64) -> f64 {
    product_over([r, r, solid_angle_element(theta)], 1.0)
}

/// Differential solid angle at polar angle `theta`, per dθ dφ: the patch on the unit sphere.
///
/// # Formula
///
/// ```text
/// dω = dA / r² = sin θ dθ dφ
/// ```
///
/// # Properties
///
/// - Error: at most ε |value|.
///
/// # Examples
///
/// ```
/// use ombra_math::spherical::solid_angle_element;
///
/// assert!((solid_angle_element(core::f64::consts::FRAC_PI_6) - 0.5).abs() <= f64::EPSILON);
/// ```
///
/// # References
///
/// Olomouc, «Diferenciální plocha».
#[must_use]
pub fn solid_angle_element(theta: f64) -> f64 {
    libm::sin(theta)
}

/// Solid angle of a range of `theta` and `phi`, in steradians: the integral of dω.
///
/// # Formula
///
/// ```text
/// Ω = (cos θ₀ − cos θ₁)(φ₁ − φ₀) = 2 sin((θ₀ + θ₁)/2) sin((θ₁ − θ₀)/2) (φ₁ − φ₀)
/// ```
///
/// # Properties
///
/// The second form is computed, its two angles with all their digits: ranges lose none, small or near a pole. A range
/// given backwards counts negative. Times r² it is the area on a sphere of radius r.
///
/// - Error: at most 4 ε |Ω| for θ in 0 … π, beyond 4 ε |φ₁ − φ₀|; subnormal values their last place.
///
/// # Pitfalls
///
/// θ beyond 0 … π and φ over more than 2π cover directions twice, and the formula does not notice.
///
/// # Examples
///
/// ```
/// use core::f64::consts::{FRAC_PI_2, PI};
/// use ombra_math::spherical::{FULL_CIRCLE, FULL_SPHERE, solid_angle};
///
/// assert_eq!(solid_angle(0.0..PI, 0.0..FULL_CIRCLE), FULL_SPHERE);
/// let hemisphere = solid_angle(0.0..FRAC_PI_2, 0.0..FULL_CIRCLE);
/// assert!((hemisphere / (2.0 * PI) - 1.0).abs() <= 2.0 * f64::EPSILON);
/// ```
///
/// # References
///
/// Olomouc, «Diferenciální plocha»: the full sphere is 4π.
#[doc(alias = "steradian")]
#[must_use]
pub fn solid_angle(theta: Range<f64>, phi: Range<f64>) -> f64 {
    let middle = sin_of_sum(0.5 * theta.start, 0.5 * theta.end);
    let half = sin_of_sum(0.5 * theta.end, -0.5 * theta.start);
    // Half of φ's range twice: the whole may be beyond the largest double.
    let width = phi.end - phi.start;
    if width.is_finite() {
        product_over([2.0, middle, half, width], 1.0)
    } else {
        product_over([4.0, middle, half, 0.5 * phi.end - 0.5 * phi.start], 1.0)
    }
}

/// sin(a + b) for a sum of more digits than a double has: near π, where the sine is small, its last ones count.
fn sin_of_sum(a: f64, b: f64) -> f64 {
    let angle = DoubleDouble::sum(a, b);
    if angle.lo == 0.0 {
        return libm::sin(angle.hi);
    }
    let ((sin, cos), (sin_lo, cos_lo)) = (libm::sincos(angle.hi), libm::sincos(angle.lo));
    sin * cos_lo + cos * sin_lo
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::to_300_bits::{q as exact, sine_and_cosine};
    use core::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};
    use ombra_oracle::Exact;
    use proptest::num::f64::ANY;
    use proptest::prelude::*;

    const EPS: f64 = f64::EPSILON;

    /// Errata [E6](crate#e6) and [E30](crate#e30): y / x, and θ from the pole.
    #[test]
    fn every_octant() {
        // tan φ = 4/3 and tan θ = 5/12 in the first octant; the other seven by symmetry.
        let (phi, theta) = (libm::atan(4.0 / 3.0), libm::atan(5.0 / 12.0));
        for (sx, sy, sz) in [-1.0, 1.0].into_iter().flat_map(|x| {
            [-1.0, 1.0]
                .into_iter()
                .flat_map(move |y| [-1.0, 1.0].map(|z| (x, y, z)))
        }) {
            let s = Spherical::from_cartesian(DVec3::new(3.0 * sx, 4.0 * sy, 12.0 * sz));
            let phi = sy * if sx > 0.0 { phi } else { PI - phi };
            let theta = if sz > 0.0 { theta } else { PI - theta };
            assert_eq!(s.r, 13.0);
            assert!((s.phi - phi).abs() <= 2.0 * EPS * PI, "{s:?}");
            assert!((s.theta - theta).abs() <= 2.0 * EPS * PI, "{s:?}");
            let back = s.to_cartesian() - DVec3::new(3.0 * sx, 4.0 * sy, 12.0 * sz);
            assert!(back.abs().max_element() <= 4.0 * EPS * 13.0, "{back}");
        }
    }

    #[test]
    fn full_circle_and_full_sphere() {
        assert_eq!(solid_angle(0.0..PI, 0.0..FULL_CIRCLE), FULL_SPHERE);
        assert_eq!(FULL_SPHERE, 4.0 * PI);
        // The polygon inscribed in the unit circle falls short of 2π by π³/(3n²) and higher powers.
        let n = 1000;
        let at = |i: i32| {
            Spherical {
                r: 1.0,
                theta: FRAC_PI_2,
                phi: FULL_CIRCLE * f64::from(i) / f64::from(n),
            }
            .to_cartesian()
        };
        let round: f64 = (0..n).map(|i| at(i).distance(at(i + 1))).sum();
        let short = PI.powi(3) / 3.0 / f64::from(n * n);
        assert!(
            (FULL_CIRCLE - round - short).abs() < 0.001 * short,
            "{round}"
        );
    }

    /// The midpoint rule errs by h²/24 times the integral of the second derivative, here −∫ sin = −Ω.
    #[test]
    fn sums_of_elements_tend_to_the_whole() {
        for n in [10, 100] {
            let h = PI / f64::from(n);
            let sum: f64 = (0..n)
                .map(|i| solid_angle_element((f64::from(i) + 0.5) * h) * h * TAU)
                .sum();
            let excess = (sum - FULL_SPHERE) / FULL_SPHERE;
            assert!(
                (excess / (h * h / 24.0) - 1.0).abs() < h * h,
                "{n}: {excess}"
            );
        }
        assert_eq!(area_element(2.0, 1.0), 4.0 * solid_angle_element(1.0));
    }

    #[test]
    fn small_patches_keep_their_digits() {
        let d = 1e-9;
        // sin θ dθ dφ is right to d²/24 and to the rounding of 1 + d, which the range itself carries.
        let step = (1.0 + d) - 1.0;
        let expected = libm::sin(1.0 + 0.5 * step) * step * d;
        assert!((solid_angle(1.0..1.0 + d, 0.0..d) / expected - 1.0).abs() <= 8.0 * EPS);
        // Difference of cosines, as the first form has it, keeps seven digits here.
        let naive = (libm::cos(1.0) - libm::cos(1.0 + d)) * d;
        assert!((naive / expected - 1.0).abs() > 1e-9);
    }

    fn exact_cos(x: f64) -> Exact {
        sine_and_cosine(&exact(x)).1
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(4000))]

        /// Ω = (cos θ₀ − cos θ₁)(φ₁ − φ₀) with 300 bits, at the poles and between, ranges of every width.
        #[test]
        fn every_patch_keeps_its_digits(pole in 0u8..3, m in 0.0..1.0f64, e in -30i32..1, width in 0.0..1.0f64,
                                        down in -45i32..0, phi in 0.001..TAU) {
            let (from, towards) = match pole {
                0 => (libm::scalbn(m, e), 1.0),
                1 => (PI - libm::scalbn(m, e), -1.0),
                _ => (1.0 + m, 1.0),
            };
            let to = from + towards * libm::scalbn(width, down);
            let (low, high) = (from.min(to).max(0.0), from.max(to).min(PI));
            prop_assume!(low != high);
            let right = (exact_cos(low) - exact_cos(high)) * exact(phi);
            let error = (exact(solid_angle(low..high, 0.0..phi)) - &right).ratio(&right).abs() / EPS;
            prop_assert!(error <= 4.0, "{low:e}..{high:e} is off by {error} ε");
            let back = solid_angle(high..low, 0.0..phi);
            prop_assert_eq!(back, -solid_angle(low..high, 0.0..phi));
        }
    }

    #[test]
    fn what_can_be_held_is_right() {
        // r² alone is beyond the doubles, or below them; sin θ = θ to the last bit for these θ.
        for (r, theta) in [
            (1e160, 1e-100),
            (-1e160, 1e-100),
            (1e10, 1e-318),
            (1e200, 1e-320),
        ] {
            let area = area_element(r, theta);
            let right = exact(r).squared() * exact(theta);
            let off = (exact(area) - &right).ratio(&right);
            assert!(off.abs() <= 2.0 * EPS, "{r:e} {theta:e}: {area:e}");
        }
        assert_eq!(area_element(1e-160, FRAC_PI_2), 1e-320);
        assert_eq!(area_element(1e160, FRAC_PI_2), f64::INFINITY);
        // Both sines are below the doubles together, not with a long range of φ; nor is a range beyond the largest.
        let patch = solid_angle(0.0..2e-200, 0.0..1e300);
        assert!((patch / 2e-100 - 1.0).abs() <= 4.0 * EPS, "{patch:e}");
        let patch = solid_angle(0.0..2e-100, -f64::MAX..f64::MAX);
        assert!(
            (patch / (2.0 * 2e-200 * f64::MAX) - 1.0).abs() <= 4.0 * EPS,
            "{patch:e}"
        );
    }

    #[test]
    fn degenerate() {
        let inf = f64::INFINITY;
        let third = libm::atan(2f64.sqrt());
        let cases = [
            (DVec3::ZERO, 0.0, 0.0, 0.0),
            (DVec3::Z, 1.0, 0.0, 0.0),
            (DVec3::NEG_Z, 1.0, PI, 0.0),
            (DVec3::new(-1.0, -0.0, 0.0), 1.0, FRAC_PI_2, -PI),
            (DVec3::Y * 5e-324, 5e-324, FRAC_PI_2, FRAC_PI_2),
            (DVec3::Z * f64::MAX, f64::MAX, 0.0, 0.0),
            (DVec3::splat(f64::MAX), inf, third, FRAC_PI_4),
            (DVec3::splat(1e-300), 3f64.sqrt() * 1e-300, third, FRAC_PI_4),
            (DVec3::new(5e-324, 5e-324, 1.0), 1.0, 5e-324, FRAC_PI_4),
        ];
        for (p, r, theta, phi) in cases {
            let s = Spherical::from_cartesian(p);
            assert!(s.r == r || (s.r - r).abs() <= 2.0 * EPS * r, "{p}: {s:?}");
            assert!(
                (s.theta - theta).abs() <= 2.0 * EPS && (s.phi - phi).abs() <= 2.0 * EPS,
                "{p}: {s:?}"
            );
        }
        for bad in [f64::NAN, inf, -inf] {
            let s = Spherical::from_cartesian(DVec3::new(0.0, bad, 0.0));
            assert!(s.r.is_nan() && s.theta.is_nan() && s.phi.is_nan());
        }
    }

    proptest! {
        #[test]
        fn there_and_back(m in [-1.0..1.0f64, -1.0..1.0, -1.0..1.0], e in -1000i32..1000) {
            let p = DVec3::from_array(m.map(|x| libm::scalbn(x, e)));
            let s = Spherical::from_cartesian(p);
            let back = s.to_cartesian();
            prop_assert!((back - p).abs().max_element() <= 8.0 * EPS * s.r + 1e-323, "{p} {back}");
            prop_assert!((0.0..=PI).contains(&s.theta) && s.phi.abs() <= PI);
        }

        #[test]
        fn never_panics(x in ANY, y in ANY, z in ANY, w in ANY) {
            let s = Spherical::from_cartesian(DVec3::new(x, y, z));
            prop_assert!(s.r.is_nan() || s.r >= 0.0);
            let _ = Spherical { r: x, theta: y, phi: z }.to_cartesian();
            let _ = (area_element(x, y), solid_angle(x..y, z..w));
        }
    }
}
