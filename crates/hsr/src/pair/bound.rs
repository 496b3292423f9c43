//! A round cone, or cylinder, round what is seen: most pairs of a scene are far apart, and one comparison tells.

use ombra_math::glam::DVec3;

use super::eye::Eye;
use super::tolerance;

/// What surely holds all sight lines through a polygon.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Bound {
    /// Not known.
    All,
    Cone(Cone),
    Cylinder(Cylinder),
}

/// Within an angle below 90° of the unit vector `axis`: its cosine and sine.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Cone {
    axis: DVec3,
    cos: f64,
    sin: f64,
}

/// Within `radius` of the sight line through `centre`, seen along the unit vector `towards`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Cylinder {
    towards: DVec3,
    centre: DVec3,
    radius: f64,
}

impl Bound {
    /// Round the sight lines through `vertices`, of which `scale` is the largest coordinate.
    pub(super) fn new(eye: Eye, vertices: &[DVec3], scale: f64) -> Self {
        // Squares of what differences of such coordinates can be keep all their digits.
        if !(1e-100..=1e100).contains(&scale) {
            return Self::All;
        }
        match eye {
            Eye::Place(place) => {
                let rays = || vertices.iter().map(|&v| (v - place).normalize_or_zero());
                let axis = rays().sum::<DVec3>().normalize_or_zero();
                // Lowered by more than its rounding; 1 − cos is exact, and so the sine good to a few ε.
                let cos = rays().map(|ray| axis.dot(ray)).fold(1.0, f64::min) - 16.0 * f64::EPSILON;
                let sin = ((1.0 - cos) * (1.0 + cos)).sqrt();
                if cos > 0.0 {
                    Self::Cone(Cone { axis, cos, sin })
                } else {
                    Self::All
                }
            }
            Eye::Towards(towards) => {
                let towards = (towards / towards.abs().max_element()).normalize();
                let centre = vertices.iter().sum::<DVec3>() / vertices.len() as f64;
                let away = vertices.iter().map(|&v| across(v - centre, towards));
                let radius = away.fold(0.0, f64::max);
                Self::Cylinder(Cylinder {
                    towards,
                    centre,
                    radius,
                })
            }
        }
    }

    /// Whether they share no sight line, for certain; `scale` is the largest coordinate of a vertex of either.
    #[inline]
    pub(super) fn apart(&self, other: &Self, scale: f64) -> bool {
        match (*self, *other) {
            (Self::Cone(a), Self::Cone(b)) => {
                // The cosine of the angle between the axes against that of the sum of both angles, below 180°.
                a.axis.dot(b.axis) < a.cos * b.cos - a.sin * b.sin - 16.0 * f64::EPSILON
            }
            (Self::Cylinder(a), Self::Cylinder(b)) => {
                across(a.centre - b.centre, a.towards) > a.radius + b.radius + tolerance(scale)
            }
            _ => false,
        }
    }
}

/// The length of `v` as seen along the unit vector `towards`.
#[inline]
fn across(v: DVec3, towards: DVec3) -> f64 {
    (v - v.dot(towards) * towards).length()
}
