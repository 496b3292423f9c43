//! Fake shadows: an ellipse instead of the object's outline.
//!
//! The cheapest shadow there is: it says where an object stands and how large it is, not what shape it has.
#![cfg_attr(doc, doc = "")]
#![cfg_attr(doc, doc = include_str!("../figures/fake.svg"))]
#![doc(alias = "blob shadow")]

use ombra_math::glam::{DVec3, DVec4};
use ombra_math::plane::Plane;

use crate::planar::cast;

/// An ellipse in space: C + cos φ · u + sin φ · v.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ellipse {
    /// C, its centre.
    pub center: DVec3,
    /// One semi-axis, from the centre.
    pub u: DVec3,
    /// The other semi-axis, at right angles to the first.
    pub v: DVec3,
}

impl Ellipse {
    /// The point at the angle φ in radians, from the end of u towards the end of v.
    ///
    /// # Formula
    ///
    /// ```text
    /// C + cos φ · u + sin φ · v
    /// ```
    ///
    /// # Properties
    ///
    /// - Error: at most 3 ε (|C| + |u| + |v|) in each coordinate.
    #[must_use]
    pub fn point(&self, phi: f64) -> DVec3 {
        self.center + self.u * libm::cos(phi) + self.v * libm::sin(phi)
    }
}

/// The fake shadow of an object on `plane`: an ellipse with the object's largest extents, under the object as `light`
/// sees it. `None` where the object's middle has no true shadow, there are no points, one is not finite, or an extent is
/// beyond the largest double.
///
/// # Formula
///
/// ```text
/// C  = shadow of the middle of the object's bounding box
/// ‖u‖ = ½ (max e₁·X − min e₁·X),   ‖v‖ = ½ (max e₂·X − min e₂·X)   over its points X
/// e₁ = the coordinate axis most along the plane, made to lie in it
/// e₂ = e₁ × n, both of unit length
/// n = plane.normal / ‖plane.normal‖
/// ```
///
/// # Properties
///
/// On the ground, u is along x and v along z, and the ellipse is as wide and deep as the object. One vertex is cast
/// whatever the object's size. It does not stretch as the light sinks, and does not turn with the object.
///
/// - Error: the centre as of cast for the rounded middle; the axes at most 16 ε max|X|.
///
/// # Pitfalls
///
/// The extents are the object's own, not those of its shadow: under a low light the true shadow is much longer.
///
/// # Examples
///
/// ```
/// use ombra_math::glam::{DVec3, DVec4};
/// use ombra_math::plane::Plane;
/// use ombra_math::solids::slide_cube;
/// use ombra_shadows::fake::ellipse;
///
/// let shadow = ellipse(&slide_cube().positions, Plane::GROUND, DVec4::new(10.0, 10.0, 10.0, 0.0)).unwrap();
/// assert_eq!(shadow.center, DVec3::new(-20.0, 0.0, -20.0));
/// assert_eq!((shadow.u, shadow.v), (DVec3::X * 5.0, DVec3::Z * 5.0));
/// ```
///
/// # References
///
/// Olomouc, «Zjednodušení»; Croatian 8.4, fake shadows.
#[must_use]
pub fn ellipse(points: &[DVec3], plane: Plane, light: DVec4) -> Option<Ellipse> {
    let (&first, rest) = points.split_first()?;
    if points.iter().any(|p| !p.is_finite()) {
        return None;
    }
    let (min, max) = rest
        .iter()
        .fold((first, first), |(min, max), &p| (min.min(p), max.max(p)));
    // The shadow of its middle. Halved first, so that the middle of a huge object is finite.
    let center = cast(plane, light, min / 2.0 + max / 2.0)?;
    // Two directions in the plane, the first near a coordinate axis.
    let n = plane.normal / plane.normal.abs().max_element();
    let n = n / n.length();
    let along = n.abs();
    let axis = if along.x <= along.y && along.x <= along.z {
        DVec3::X
    } else if along.z <= along.y {
        DVec3::Z
    } else {
        DVec3::Y
    };
    let e1 = (axis - n * n.dot(axis)).normalize_or_zero();
    let e2 = e1.cross(n);
    // Half of how far the object reaches along each.
    let half_extent = |e: DVec3| {
        let heights = points.iter().map(|&p| e.dot(p / 2.0));
        let (low, high) = heights.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), x| {
            (l.min(x), h.max(x))
        });
        high - low
    };
    let ellipse = Ellipse {
        center,
        u: e1 * half_extent(e1),
        v: e2 * half_extent(e2),
    };
    (ellipse.u.is_finite() && ellipse.v.is_finite()).then_some(ellipse)
}

#[cfg(test)]
mod tests {
    use super::*;
    use ombra_math::solids::slide_cube;
    use ombra_oracle::Exact;

    const SUN: DVec4 = DVec4::new(10.0, 10.0, 10.0, 0.0);

    #[test]
    fn axes_lie_in_the_plane_at_right_angles() {
        let points = slide_cube().positions;
        for normal in [
            DVec3::new(0.0, 1.0, 1.0),
            DVec3::new(1.0, 2.0, 3.0),
            DVec3::new(-5.0, 0.1, 0.1),
            DVec3::X,
            DVec3::Y * 1e200,
            DVec3::Z * 1e-200,
        ] {
            let plane = Plane { normal, d: 0.0 };
            let Some(e) = ellipse(&points, plane, SUN) else {
                continue;
            };
            let n = normal / normal.abs().max_element();
            for (a, b) in [(e.u, n), (e.v, n), (e.u, e.v)] {
                assert!(
                    a.dot(b).abs() <= 8.0 * f64::EPSILON * a.length() * b.length(),
                    "{normal}"
                );
            }
            // Brute force over both axes: the extents are those of the points.
            for axis in [e.u, e.v] {
                let unit = axis / axis.length();
                let reach = points
                    .iter()
                    .map(|p| (*p - DVec3::new(5.0, 25.0, 5.0)).dot(unit))
                    .fold(0.0, f64::max);
                assert!(
                    (reach - axis.length()).abs() <= 16.0 * f64::EPSILON * 30.0,
                    "{normal}"
                );
            }
        }
    }

    #[test]
    fn the_extents_follow_the_object_and_the_centre_the_light() {
        let mut points = slide_cube().positions;
        for p in &mut points {
            p.x *= 3.0;
        }
        let e = ellipse(&points, Plane::GROUND, DVec4::Y).unwrap();
        assert_eq!(
            (e.center, e.u, e.v),
            (DVec3::new(15.0, 0.0, 5.0), DVec3::X * 15.0, DVec3::Z * 5.0)
        );
        let low = ellipse(&points, Plane::GROUND, DVec4::new(4.0, 1.0, 0.0, 0.0)).unwrap();
        assert_eq!((low.u, low.v), (e.u, e.v));
        assert_eq!(low.center, DVec3::new(15.0 - 100.0, 0.0, 5.0));
    }

    #[test]
    fn the_first_axis_is_the_one_most_along_the_plane() {
        // Lights and objects that cast on each plane; extents 2, 4 and 6 along x, y and z.
        let points = [DVec3::ZERO, DVec3::new(2.0, 4.0, 6.0)];
        let behind = DVec3::splat(-50.0);
        let slanted = DVec3::new(0.6, 0.0, 0.8);
        for (normal, u, v) in [
            (DVec3::Y, DVec3::X, DVec3::Z * 3.0),
            (DVec3::Z, DVec3::X, DVec3::Y * -2.0),
            (DVec3::X, DVec3::Z * 3.0, DVec3::Y * 2.0),
            (slanted, DVec3::Y * 2.0, DVec3::ZERO),
        ] {
            let plane = Plane::through(behind, normal).unwrap();
            let e = ellipse(&points, plane, normal.extend(0.0)).unwrap();
            assert_eq!(e.u, u, "{normal}");
            if v != DVec3::ZERO {
                assert_eq!(e.v, v, "{normal}");
            }
        }
    }

    #[test]
    fn points_are_within_their_bound() {
        for k in 0..2000 {
            let x = f64::from(k);
            let e = Ellipse {
                center: DVec3::new(x.sin(), 1e3 * x.cos(), 0.0),
                u: DVec3::new((3.0 * x).sin(), 1.0, 1e-9),
                v: DVec3::new((5.0 * x).sin(), -1.0, 1e3),
            };
            let phi = 7.0 * (11.0 * x).sin();
            let p = e.point(phi);
            let (s, c) = (libm::sin(phi), libm::cos(phi));
            for i in 0..3 {
                let q = |x: f64| Exact::new(x).unwrap();
                let right = q(e.center[i]) + q(e.u[i]) * q(c) + q(e.v[i]) * q(s);
                let size = q(e.center[i].abs() + e.u[i].abs() + e.v[i].abs());
                let off = (q(p[i]) - right).abs();
                // 3 ε but for the ε of sine and cosine themselves.
                let bound = size * q(2.0 * f64::EPSILON);
                assert!(off <= bound, "{phi}");
            }
        }
    }

    #[test]
    fn a_quarter_turn_leads_from_u_to_v() {
        let e = Ellipse {
            center: DVec3::ONE,
            u: DVec3::X * 2.0,
            v: DVec3::Z,
        };
        assert_eq!(e.point(0.0), DVec3::new(3.0, 1.0, 1.0));
        let p = e.point(core::f64::consts::FRAC_PI_2);
        assert!((p - DVec3::new(1.0, 1.0, 2.0)).abs().max_element() <= 2.0 * f64::EPSILON);
    }

    #[test]
    fn degenerate() {
        let cube = slide_cube().positions;
        let ground = Plane::GROUND;
        assert_eq!(ellipse(&[], ground, SUN), None);
        assert_eq!(ellipse(&[DVec3::NAN], ground, SUN), None);
        assert_eq!(ellipse(&[DVec3::INFINITY, DVec3::ZERO], ground, SUN), None);
        assert_eq!(
            ellipse(&cube, ground, DVec4::X),
            None,
            "light along the plane"
        );
        assert_eq!(ellipse(&cube, ground, -SUN), None, "light from below");
        assert_eq!(
            ellipse(&cube, ground, DVec4::new(0.0, 10.0, 0.0, 1.0)),
            None,
            "object above the light"
        );
        assert_eq!(
            ellipse(
                &cube,
                Plane {
                    normal: DVec3::ZERO,
                    d: 0.0
                },
                SUN
            ),
            None
        );
        let dot = ellipse(&[DVec3::Y], ground, SUN).unwrap();
        assert_eq!((dot.u, dot.v), (DVec3::ZERO, DVec3::ZERO));
    }
}
