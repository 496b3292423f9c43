//! The solids of the lectures as meshes: the decks' cube, cuboid, tetrahedron, sphere, torus and teapot.
//!
//! Faces run counter-clockwise as seen from outside, y is up, and all but the teapot are closed. Vertices are
//! shared: one for each place, one for each pole.

mod rings;
mod teapot;

pub use teapot::teapot;

use self::rings::Rings;
use crate::mesh::Mesh;
use crate::triangle::scaled_normal;
use core::f64::consts::{PI, TAU};
use core::fmt;
use glam::DVec3;

/// The most triangles that a solid is made of, 2²⁴.
pub const MAX_TRIANGLES: u128 = 1 << 24;

/// Why there is no such solid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SolidError {
    /// A box without extent along an axis.
    Extent {
        /// The axis.
        axis: char,
        /// Its lower bound.
        min: f64,
        /// Its upper bound.
        max: f64,
    },
    /// A radius that is not a positive number.
    Radius {
        /// The name of the parameter.
        what: &'static str,
        /// Its value.
        value: f64,
    },
    /// A tube that is as thick as its circle is wide, or reaches beyond the largest double.
    Tube {
        /// Radius of the circle.
        major: f64,
        /// Radius of the tube.
        minor: f64,
    },
    /// Too few parts, or too many.
    Parts {
        /// The name of the parameter.
        what: &'static str,
        /// Its value.
        value: u32,
        /// The fewest allowed.
        least: u32,
    },
    /// More than [`MAX_TRIANGLES`].
    TooManyTriangles {
        /// How many were asked for.
        triangles: u128,
    },
    /// Neighbouring vertices that round to one place or one line.
    Collapsed {
        /// One of them.
        position: DVec3,
    },
}

impl fmt::Display for SolidError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Extent { axis, min, max } => write!(
                f,
                "the box reaches from {axis} = {min} to {max}; both must be finite and the first below the second"
            ),
            Self::Radius { what, value } => {
                write!(
                    f,
                    "{what} is {value}; it must be a finite number greater than 0"
                )
            }
            Self::Tube { major, minor } => write!(
                f,
                "minor is {minor} and major {major}; minor must be the smaller, and their sum finite"
            ),
            Self::Parts { what, value, least } => {
                write!(f, "{what} is {value}; it must be at least {least}")
            }
            Self::TooManyTriangles { triangles } => {
                write!(
                    f,
                    "{triangles} triangles are too many; at most {MAX_TRIANGLES} are allowed"
                )
            }
            Self::Collapsed { position } => write!(
                f,
                "the vertices around {position} round to one place or line; take fewer parts or a larger radius"
            ),
        }
    }
}

impl core::error::Error for SolidError {}

/// The decks' cube: side 10, standing over the origin's corner from y = 20 to 30.
///
/// # Properties
///
/// Vertices in the deck's order, four below and four above. Each side is cut in two so that at (0, 20, 0) two triangles
/// of the lower side meet, two of the one at z = 0 and one of the one at x = 0.
///
/// - Error: none.
///
/// # Examples
///
/// ```
/// use ombra_math::glam::DVec3;
///
/// let cube = ombra_math::solids::slide_cube();
/// assert_eq!(cube.positions[0], DVec3::new(0.0, 20.0, 0.0));
/// assert_eq!(cube.positions[6], DVec3::new(10.0, 30.0, 10.0));
/// assert_eq!(cube.triangles.len(), 12);
/// ```
///
/// # References
///
/// Olomouc, «Zdroj v nekonečnu» and «Zdroj světla v bodě», examples.
#[must_use]
pub fn slide_cube() -> Mesh {
    block(DVec3::new(0.0, 20.0, 0.0), DVec3::new(10.0, 30.0, 10.0))
}

/// The box from `min` to `max`, its vertices in the order of [`slide_cube`].
///
/// # Properties
///
/// - Error: none: corners of the bounds.
///
/// # Errors
///
/// A bound that is not finite, or not lower in `min` than in `max`.
///
/// # Examples
///
/// ```
/// use ombra_math::glam::DVec3;
/// use ombra_math::solids::{SolidError, cuboid};
///
/// assert!(cuboid(DVec3::ZERO, DVec3::new(4.0, 1.0, 2.0)).is_ok());
/// let flat = cuboid(DVec3::ZERO, DVec3::new(4.0, 0.0, 2.0));
/// assert_eq!(flat, Err(SolidError::Extent { axis: 'y', min: 0.0, max: 0.0 }));
/// ```
pub fn cuboid(min: DVec3, max: DVec3) -> Result<Mesh, SolidError> {
    for (axis, (min, max)) in "xyz"
        .chars()
        .zip(min.to_array().into_iter().zip(max.to_array()))
    {
        if !(min.is_finite() && max.is_finite() && min < max) {
            return Err(SolidError::Extent { axis, min, max });
        }
    }
    Ok(block(min, max))
}

fn block(min: DVec3, max: DVec3) -> Mesh {
    let level = |y: f64| {
        [
            (min.x, min.z),
            (max.x, min.z),
            (max.x, max.z),
            (min.x, max.z),
        ]
        .map(|(x, z)| DVec3::new(x, y, z))
    };
    Mesh {
        positions: [level(min.y), level(max.y)].concat(),
        triangles: vec![
            [0, 1, 2],
            [0, 2, 3], // below
            [4, 6, 5],
            [4, 7, 6], // above
            [0, 5, 1],
            [0, 4, 5], // z = min
            [1, 6, 2],
            [1, 5, 6], // x = max
            [2, 7, 3],
            [2, 6, 7], // z = max
            [3, 4, 0],
            [3, 7, 4], // x = min
        ],
    }
}

/// The regular tetrahedron inscribed in the unit sphere around the origin.
///
/// # Properties
///
/// Its corners are four of a cube's, (±1, ±1, ±1)/√3 with an even number of minus signs: all six edges come out
/// equally long to the last bit.
///
/// - Error: at most ε in each coordinate.
///
/// # Examples
///
/// ```
/// let tetrahedron = ombra_math::solids::tetrahedron();
/// assert!(tetrahedron.positions.iter().all(|p| (p.length() - 1.0).abs() < 1e-15));
/// ```
#[must_use]
pub fn tetrahedron() -> Mesh {
    let s = 1.0 / 3f64.sqrt();
    Mesh {
        positions: [
            (1.0, 1.0, 1.0),
            (1.0, -1.0, -1.0),
            (-1.0, 1.0, -1.0),
            (-1.0, -1.0, 1.0),
        ]
        .map(|(x, y, z)| DVec3::new(x, y, z) * s)
        .to_vec(),
        triangles: vec![[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]],
    }
}

/// The sphere of `radius` around the origin, poles on the y axis, in `slices` of longitude and `stacks` of latitude.
///
/// # Formula
///
/// ```text
/// x = r sin θ cos φ     y = r cos θ     z = −r sin θ sin φ
/// θ = π j/stacks,  φ = 2π i/slices
/// ```
///
/// # Properties
///
/// Each pole is one vertex; no triangle is degenerate; closed. 2·slices·(stacks − 1)
/// triangles. The mesh is inscribed, so its volume is smaller than the ball's by a share that falls with
/// the square of the parts.
///
/// - Error: at most 4 ε r from the sphere, for each vertex.
///
/// # Errors
///
/// A radius that is not finite and positive, fewer than 3 slices or 2 stacks, more than [`MAX_TRIANGLES`], a radius so
/// small (below 10⁻³⁰⁰) that vertices fall together.
///
/// # Examples
///
/// ```
/// use ombra_math::solids::{SolidError, sphere};
///
/// assert_eq!(sphere(1.0, 32, 16).unwrap().triangles.len(), 2 * 32 * 15);
/// let error = sphere(-1.0, 32, 16).unwrap_err();
/// assert_eq!(error.to_string(), "radius is -1; it must be a finite number greater than 0");
/// ```
#[doc(alias = "UV sphere")]
pub fn sphere(radius: f64, slices: u32, stacks: u32) -> Result<Mesh, SolidError> {
    positive("radius", radius)?;
    at_least("slices", slices, 3)?;
    at_least("stacks", stacks, 2)?;
    allowed(2 * u128::from(slices) * (u128::from(stacks) - 1))?;
    let around = circle(slices);
    let mut rings = Rings::default();
    rings.push([DVec3::Y * radius]);
    for j in 1..stacks {
        let (sin, cos) = libm::sincos(PI * f64::from(j) / f64::from(stacks));
        rings.push(
            around
                .iter()
                .map(|&(x, z)| DVec3::new(x * sin, cos, z * sin) * radius),
        );
    }
    rings.push([DVec3::NEG_Y * radius]);
    checked(rings.mesh)
}

/// The torus around the y axis: a tube of radius `minor` whose middle runs along the circle of radius `major`.
///
/// # Formula
///
/// ```text
/// x = (R + r cos β) cos φ     y = −r sin β     z = −(R + r cos β) sin φ
/// φ = 2π i/around,  β = 2π j/across
/// ```
///
/// # Properties
///
/// Closed, of genus 1, 2·around·across triangles, none degenerate.
///
/// - Error: at most 4 ε (R + r) from the surface, for each vertex.
///
/// # Errors
///
/// Radii that are not finite and positive, a tube that touches itself (minor ≥ major), R + r beyond the
/// largest double, fewer than 3 parts around or across, more than [`MAX_TRIANGLES`], a tube so thin beside its circle
/// that vertices fall together.
///
/// # Examples
///
/// ```
/// use ombra_math::solids::{SolidError, torus};
///
/// assert!(torus(3.0, 1.0, 48, 16).unwrap().is_two_manifold());
/// assert_eq!(torus(1.0, 2.0, 48, 16), Err(SolidError::Tube { major: 1.0, minor: 2.0 }));
/// ```
#[doc(alias = "doughnut")]
pub fn torus(major: f64, minor: f64, around: u32, across: u32) -> Result<Mesh, SolidError> {
    positive("major", major)?;
    positive("minor", minor)?;
    if minor >= major || !(major + minor).is_finite() {
        return Err(SolidError::Tube { major, minor });
    }
    at_least("around", around, 3)?;
    at_least("across", across, 3)?;
    allowed(2 * u128::from(around) * u128::from(across))?;
    let circle = circle(around);
    let mut rings = Rings::default();
    for j in 0..across {
        let (sin, cos) = libm::sincos(TAU * f64::from(j) / f64::from(across));
        let (rho, y) = (major + minor * cos, -minor * sin);
        rings.push(circle.iter().map(|&(x, z)| DVec3::new(x * rho, y, z * rho)));
    }
    rings.close();
    checked(rings.mesh)
}

/// `n` directions (x, z) around the y axis, counter-clockwise as seen from above.
fn circle(n: u32) -> Vec<(f64, f64)> {
    (0..n)
        .map(|i| {
            let (sin, cos) = libm::sincos(TAU * f64::from(i) / f64::from(n));
            (cos, -sin)
        })
        .collect()
}

fn positive(what: &'static str, value: f64) -> Result<(), SolidError> {
    if value.is_finite() && value > 0.0 {
        Ok(())
    } else {
        Err(SolidError::Radius { what, value })
    }
}

fn at_least(what: &'static str, value: u32, least: u32) -> Result<(), SolidError> {
    if value >= least {
        Ok(())
    } else {
        Err(SolidError::Parts { what, value, least })
    }
}

/// Before anything is allocated.
fn allowed(triangles: u128) -> Result<(), SolidError> {
    if triangles <= MAX_TRIANGLES {
        Ok(())
    } else {
        Err(SolidError::TooManyTriangles { triangles })
    }
}

/// `mesh`, unless rounding made one of its triangles degenerate.
fn checked(mesh: Mesh) -> Result<Mesh, SolidError> {
    for [a, b, c] in (0..mesh.triangles.len()).filter_map(|i| mesh.triangle(i)) {
        if scaled_normal(a, b, c).0 == DVec3::ZERO {
            return Err(SolidError::Collapsed { position: a });
        }
    }
    Ok(mesh)
}

#[cfg(test)]
mod tests;
