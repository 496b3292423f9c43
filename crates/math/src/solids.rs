//! The solids of the lectures as meshes: the decks' cube, cuboid, tetrahedron, sphere, torus and teapot.
//!
//! Faces run counter-clockwise as seen from outside, y is up, and all but the teapot are closed. Vertices are
//! shared: one for each place, one for each pole.

mod teapot;

pub use teapot::teapot;

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
/// x = r sin θ cos φ     y = r cos θ     z = −r sin θ sin φ      θ = π j/stacks,  φ = 2π i/slices
/// ```
///
/// # Properties
///
/// Vertices within 4 ε·r of the sphere; each pole is one vertex; no triangle is degenerate; closed. 2·slices·(stacks − 1)
/// triangles. The mesh is inscribed, so its volume is smaller than the ball's by a share that falls with
/// the square of the parts.
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
/// x = (R + r cos β) cos φ     y = −r sin β     z = −(R + r cos β) sin φ     φ = 2π i/around,  β = 2π j/across
/// ```
///
/// # Properties
///
/// Closed, of genus 1, 2·around·across triangles, none degenerate; vertices within 4 ε·(R + r) of the surface.
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

/// A mesh that grows ring by ring; a ring of one vertex is a pole.
///
/// Each ring runs counter-clockwise as seen from the rings before it, so that the faces between look outwards.
#[derive(Default)]
struct Rings {
    mesh: Mesh,
    /// First vertex of the last ring, and how many it has.
    last: Option<(u32, u32)>,
}

impl Rings {
    fn push(&mut self, ring: impl IntoIterator<Item = DVec3>) {
        let first = self.mesh.positions.len() as u32;
        self.mesh.positions.extend(ring);
        let ring = (first, self.mesh.positions.len() as u32 - first);
        if let Some(last) = self.last.replace(ring) {
            self.join(last, ring);
        }
    }

    /// Joins the last ring to the first, which must be as long.
    fn close(&mut self) {
        if let Some(last) = self.last {
            self.join(last, (0, last.1));
        }
    }

    /// Begins another piece.
    fn cut(&mut self) {
        self.last = None;
    }

    fn join(&mut self, (above, count_above): (u32, u32), (below, count_below): (u32, u32)) {
        let count = count_above.max(count_below);
        for i in 0..count {
            let next = (i + 1) % count;
            if count_below > 1 {
                let top = if count_above > 1 { above + i } else { above };
                self.mesh.triangles.push([top, below + i, below + next]);
            }
            if count_above > 1 {
                let bottom = if count_below > 1 { below + next } else { below };
                self.mesh.triangles.push([above + i, bottom, above + next]);
            }
        }
    }
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
mod tests {
    use super::*;
    use proptest::num::f64::ANY;
    use proptest::prelude::*;

    const EPS: f64 = f64::EPSILON;

    /// Six times the volume, as the sum of the determinants of the triangles.
    fn volume(mesh: &Mesh) -> f64 {
        let corners = (0..mesh.triangles.len()).filter_map(|i| mesh.triangle(i));
        corners.map(|[a, b, c]| a.dot(b.cross(c))).sum::<f64>() / 6.0
    }

    /// V − E + F.
    fn euler(mesh: &Mesh) -> i64 {
        mesh.positions.len() as i64 - mesh.edges().len() as i64 + mesh.triangles.len() as i64
    }

    #[test]
    fn the_decks_cube() {
        let cube = slide_cube();
        let expected = [
            (0, 20, 0),
            (10, 20, 0),
            (10, 20, 10),
            (0, 20, 10),
            (0, 30, 0),
            (10, 30, 0),
            (10, 30, 10),
            (0, 30, 10),
        ];
        let expected = expected.map(|(x, y, z)| DVec3::new(x.into(), y.into(), z.into()));
        assert_eq!(cube.positions, expected);
        assert_eq!(volume(&cube), 1000.0);
        assert_eq!(
            cube.positions,
            cuboid(expected[0], expected[6]).unwrap().positions
        );
    }

    #[test]
    fn faces_look_outwards() {
        let inside = DVec3::new(5.0, 25.0, 5.0);
        for (mesh, inside) in [
            (slide_cube(), inside),
            (tetrahedron(), DVec3::ZERO),
            (sphere(2.0, 7, 5).unwrap(), DVec3::ZERO),
        ] {
            assert!(mesh.is_two_manifold());
            assert_eq!(euler(&mesh), 2);
            for i in 0..mesh.triangles.len() {
                let [a, b, c] = mesh.triangle(i).unwrap();
                assert!(
                    crate::triangle::normal(a, b, c).dot(a - inside) > 0.0,
                    "{i}"
                );
            }
        }
        let torus = torus(3.0, 1.0, 9, 7).unwrap();
        assert!(torus.is_two_manifold());
        assert_eq!(euler(&torus), 0);
        for i in 0..torus.triangles.len() {
            let [a, b, c] = torus.triangle(i).unwrap();
            let centre = (a + b + c) / 3.0;
            let ring = centre.with_y(0.0).normalize() * 3.0;
            assert!(
                crate::triangle::normal(a, b, c).dot(centre - ring) > 0.0,
                "{i}"
            );
        }
    }

    #[test]
    fn the_tetrahedron_is_regular() {
        let t = tetrahedron();
        for (i, p) in t.positions.iter().enumerate() {
            assert!((p.length() - 1.0).abs() <= 2.0 * EPS);
            for q in &t.positions[..i] {
                // √8/3 exactly, up to the rounding of 1/√3; and all alike.
                assert_eq!((p - q).length(), (t.positions[0] - t.positions[1]).length());
                assert!((p.dot(*q) + 1.0 / 3.0).abs() <= 2.0 * EPS);
            }
        }
    }

    /// The volume missing falls with the square of the parts.
    #[test]
    fn round_solids_tend_to_round() {
        let ball = 4.0 / 3.0 * PI * 8.0;
        let ring = 2.0 * PI * 3.0 * PI;
        let missing = |n: u32| {
            let (s, t) = (
                sphere(2.0, 2 * n, n).unwrap(),
                torus(3.0, 1.0, 2 * n, n).unwrap(),
            );
            for p in &s.positions {
                assert!((p.length() - 2.0).abs() <= 4.0 * EPS * 2.0);
            }
            for p in &t.positions {
                let tube = p.with_y(0.0).length() - 3.0;
                assert!((tube.hypot(p.y) - 1.0).abs() <= 4.0 * EPS * 4.0);
            }
            (1.0 - volume(&s) / ball, 1.0 - volume(&t) / ring)
        };
        let ((s1, t1), (s2, t2)) = (missing(24), missing(48));
        assert!(s2 > 0.0 && t2 > 0.0);
        // The next term of the series is smaller by about (π/24)² = 0.017.
        assert!(
            (s1 / s2 - 4.0).abs() < 0.1 && (t1 / t2 - 4.0).abs() < 0.1,
            "{} {}",
            s1 / s2,
            t1 / t2
        );
    }

    #[test]
    fn degenerate() {
        use SolidError as E;
        let (inf, max, tiny) = (f64::INFINITY, f64::MAX, 5e-324);
        let unit = DVec3::ONE;
        let cases = [
            (
                "flat",
                cuboid(unit, unit.with_x(2.0)),
                E::Extent {
                    axis: 'y',
                    min: 1.0,
                    max: 1.0,
                },
            ),
            (
                "upside down",
                cuboid(unit, DVec3::ZERO),
                E::Extent {
                    axis: 'x',
                    min: 1.0,
                    max: 0.0,
                },
            ),
            (
                "no end",
                cuboid(unit, unit * inf),
                E::Extent {
                    axis: 'x',
                    min: 1.0,
                    max: inf,
                },
            ),
            (
                "radius 0",
                sphere(0.0, 8, 8),
                E::Radius {
                    what: "radius",
                    value: 0.0,
                },
            ),
            (
                "radius ∞",
                sphere(inf, 8, 8),
                E::Radius {
                    what: "radius",
                    value: inf,
                },
            ),
            (
                "two slices",
                sphere(1.0, 2, 8),
                E::Parts {
                    what: "slices",
                    value: 2,
                    least: 3,
                },
            ),
            (
                "one stack",
                sphere(1.0, 8, 1),
                E::Parts {
                    what: "stacks",
                    value: 1,
                    least: 2,
                },
            ),
            (
                "no stack",
                sphere(1.0, 8, 0),
                E::Parts {
                    what: "stacks",
                    value: 0,
                    least: 2,
                },
            ),
            (
                "all memory",
                sphere(1.0, u32::MAX, u32::MAX),
                E::TooManyTriangles {
                    triangles: 2 * 4_294_967_295 * 4_294_967_294,
                },
            ),
            (
                "horn",
                torus(1.0, 1.0, 8, 8),
                E::Tube {
                    major: 1.0,
                    minor: 1.0,
                },
            ),
            (
                "beyond",
                torus(max, max / 2.0, 8, 8),
                E::Tube {
                    major: max,
                    minor: max / 2.0,
                },
            ),
            (
                "tube 0",
                torus(1.0, -0.0, 8, 8),
                E::Radius {
                    what: "minor",
                    value: 0.0,
                },
            ),
            (
                "two around",
                torus(2.0, 1.0, 2, 8),
                E::Parts {
                    what: "around",
                    value: 2,
                    least: 3,
                },
            ),
            (
                "two across",
                torus(2.0, 1.0, 8, 2),
                E::Parts {
                    what: "across",
                    value: 2,
                    least: 3,
                },
            ),
            (
                "too many",
                torus(2.0, 1.0, 4096, 2049),
                E::TooManyTriangles {
                    triangles: 2 * 4096 * 2049,
                },
            ),
            (
                "one division",
                teapot(1),
                E::Parts {
                    what: "divisions",
                    value: 1,
                    least: 2,
                },
            ),
            (
                "513 divisions",
                teapot(513),
                E::TooManyTriangles {
                    triangles: 64 * 513 * 513 - 8 * 513,
                },
            ),
            (
                "the most divisions",
                teapot(u32::MAX),
                E::TooManyTriangles {
                    triangles: 64 * 4_294_967_295 * 4_294_967_295 - 8 * 4_294_967_295,
                },
            ),
        ];
        for (name, found, expected) in cases {
            assert_eq!(found, Err(expected), "{name}");
            assert!(!expected.to_string().is_empty());
        }
        for result in [
            sphere(tiny, 8, 8),
            torus(1.0, tiny, 8, 8),
            torus(tiny * 2.0, tiny, 8, 8),
        ] {
            let error = result.unwrap_err();
            assert!(matches!(error, E::Collapsed { .. }) && !error.to_string().is_empty());
        }
        for radius in [1e-300, max] {
            assert!(
                sphere(radius, 64, 32)
                    .unwrap()
                    .positions
                    .iter()
                    .all(|p| p.is_finite())
            );
        }
        let whole = cuboid(DVec3::splat(-max), DVec3::splat(max)).unwrap();
        assert!(whole.is_two_manifold());
    }

    proptest! {
        #[test]
        fn never_panics(x in ANY, y in ANY, z in ANY, w in ANY, i in 0..40u32, j in 0..40u32) {
            let results = [
                cuboid(DVec3::new(x, y, z), DVec3::new(y, z, w)),
                sphere(x, i, j),
                torus(x.abs(), y.abs(), i, j),
            ];
            for mesh in results.into_iter().flatten() {
                prop_assert!(mesh.is_two_manifold());
                prop_assert!(Mesh::new(mesh.positions, mesh.triangles).is_ok());
            }
        }
    }
}
