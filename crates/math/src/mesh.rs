//! Indexed triangle meshes: shared vertices, edges with the two faces beside them, vertex normals.
//!
//! A shadow volume is drawn from the edges between a lit and an unlit face, so a mesh must tell for each edge
//! which faces it has, and whether every edge has two. Everything here takes time linear in the mesh.

mod edges;
mod normals;

pub use edges::Edge;
pub use normals::Weighting;

use core::fmt;
use glam::DVec3;

/// Triangles that share vertices.
///
/// # Properties
///
/// A face is seen from the side from which its vertices run counter-clockwise. [`Mesh::new`] checks what it is
/// given; the fields are public, so every method is total as well: a triangle that names a missing vertex is as
/// good as absent.
///
/// # Examples
///
/// ```
/// use ombra_math::glam::DVec3;
/// use ombra_math::mesh::{Mesh, MeshError};
///
/// let corners = vec![DVec3::ZERO, DVec3::X, DVec3::Y];
/// let mesh = Mesh::new(corners.clone(), vec![[0, 1, 2]]).unwrap();
/// assert!(!mesh.is_closed());
///
/// let error = Mesh::new(corners, vec![[0, 1, 3]]).unwrap_err();
/// assert_eq!(error, MeshError::Index { triangle: 0, index: 3, vertices: 3 });
/// assert_eq!(error.to_string(), "triangle 0 names vertex 3, but there are 3, numbered from 0");
/// ```
///
/// # References
///
/// Grafica 3 and CIS 781 take their casters so; Olomouc, «Stínové těleso».
#[doc(alias = "triangle mesh")]
#[doc(alias = "indexed face set")]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// The places of the vertices.
    pub positions: Vec<DVec3>,
    /// The three vertices of each triangle, as indices into `positions`.
    pub triangles: Vec<[u32; 3]>,
}

/// What is wrong with a mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum MeshError {
    /// A triangle names a vertex that is not there.
    Index {
        /// The triangle.
        triangle: usize,
        /// The vertex it names.
        index: u32,
        /// How many vertices there are.
        vertices: usize,
    },
    /// A position is NaN or infinite.
    Position {
        /// The vertex.
        vertex: usize,
        /// Its position.
        position: DVec3,
    },
    /// More than [`Mesh::MAX_TRIANGLES`].
    TooManyTriangles {
        /// How many there are.
        triangles: usize,
    },
}

impl fmt::Display for MeshError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Index {
                triangle,
                index,
                vertices,
            } => write!(
                f,
                "triangle {triangle} names vertex {index}, but there are {vertices}, numbered from 0"
            ),
            Self::Position { vertex, position } => {
                write!(
                    f,
                    "vertex {vertex} is at {position}; its coordinates must be finite numbers"
                )
            }
            Self::TooManyTriangles { triangles } => {
                write!(
                    f,
                    "{triangles} triangles are too many; at most {} are allowed",
                    Mesh::MAX_TRIANGLES
                )
            }
        }
    }
}

impl core::error::Error for MeshError {}

impl Mesh {
    /// The most triangles a mesh can have, 1 431 655 765: their sides are numbered with 32 bits.
    pub const MAX_TRIANGLES: usize = (u32::MAX / 3) as usize;

    /// A mesh of `positions` and `triangles`, checked.
    ///
    /// # Errors
    ///
    /// A triangle that names a missing vertex, a position that is not finite, more than
    /// [`Mesh::MAX_TRIANGLES`]. Degenerate triangles and unused vertices are allowed.
    pub fn new(positions: Vec<DVec3>, triangles: Vec<[u32; 3]>) -> Result<Self, MeshError> {
        if triangles.len() > Self::MAX_TRIANGLES {
            return Err(MeshError::TooManyTriangles {
                triangles: triangles.len(),
            });
        }
        if let Some((vertex, &position)) =
            positions.iter().enumerate().find(|(_, p)| !p.is_finite())
        {
            return Err(MeshError::Position { vertex, position });
        }
        let vertices = positions.len();
        for (triangle, corners) in triangles.iter().enumerate() {
            if let Some(&index) = corners.iter().find(|&&i| i as usize >= vertices) {
                return Err(MeshError::Index {
                    triangle,
                    index,
                    vertices,
                });
            }
        }
        Ok(Self {
            positions,
            triangles,
        })
    }

    /// The corners of triangle `i`, or `None` if there is no such triangle or one of its vertices is missing.
    ///
    /// # Properties
    ///
    /// - Error: none.
    #[must_use]
    pub fn triangle(&self, i: usize) -> Option<[DVec3; 3]> {
        let &[a, b, c] = self.triangles.get(i)?;
        let at = |index: u32| self.positions.get(index as usize).copied();
        Some([at(a)?, at(b)?, at(c)?])
    }

    /// The lowest and the highest of each coordinate, or `None` without positions. NaN is passed over.
    ///
    /// # Properties
    ///
    /// - Error: none.
    #[doc(alias = "bounding box")]
    #[doc(alias = "AABB")]
    #[must_use]
    pub fn bounds(&self) -> Option<[DVec3; 2]> {
        let &first = self.positions.first()?;
        let extend = |choose: fn(f64, f64) -> f64| {
            self.positions.iter().fold(first, |a, b| {
                DVec3::new(choose(a.x, b.x), choose(a.y, b.y), choose(a.z, b.z))
            })
        };
        Some([extend(f64::min), extend(f64::max)])
    }

    /// Each triangle, or `None` in the place of one that names a missing vertex.
    fn used_triangles(&self) -> impl Iterator<Item = Option<[u32; 3]>> {
        let vertices = self.positions.len();
        self.triangles
            .iter()
            .take(Self::MAX_TRIANGLES)
            .map(move |&t| t.iter().all(|&i| (i as usize) < vertices).then_some(t))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solids;
    use proptest::num::f64::ANY;
    use proptest::prelude::*;

    const EPS: f64 = f64::EPSILON;

    fn mesh(vertices: usize, triangles: &[[u32; 3]]) -> Mesh {
        Mesh {
            positions: vec![DVec3::ZERO; vertices],
            triangles: triangles.to_vec(),
        }
    }

    #[test]
    fn rejected() {
        let three = vec![DVec3::ZERO, DVec3::X, DVec3::Y];
        let bad = DVec3::new(0.0, f64::NEG_INFINITY, 0.0);
        let error = MeshError::Index {
            triangle: 1,
            index: u32::MAX,
            vertices: 3,
        };
        assert_eq!(
            Mesh::new(three.clone(), vec![[0, 1, 2], [0, u32::MAX, 1]]),
            Err(error)
        );
        let error = MeshError::Position {
            vertex: 1,
            position: bad,
        };
        assert_eq!(Mesh::new(vec![DVec3::ZERO, bad], vec![]), Err(error));
        assert!(error.to_string().contains("vertex 1") && error.to_string().contains("-inf"));
        let next = MeshError::Index {
            triangle: 0,
            index: 3,
            vertices: 3,
        };
        assert_eq!(Mesh::new(three.clone(), vec![[0, 1, 3]]), Err(next));
        assert!(Mesh::new(vec![], vec![]).is_ok());
        assert!(Mesh::new(three, vec![[0, 0, 0]]).is_ok());
    }

    #[test]
    fn degenerate() {
        assert_eq!(mesh(0, &[]).bounds(), None);
        let cube = solids::slide_cube();
        assert_eq!(
            cube.bounds(),
            Some([DVec3::new(0.0, 20.0, 0.0), DVec3::new(10.0, 30.0, 10.0)])
        );
        assert_eq!(mesh(2, &[[0, 1, 2]]).triangle(0), None);
        assert_eq!(mesh(2, &[]).triangle(0), None);
        let sheet = |a: DVec3, b: DVec3, c: DVec3| Mesh {
            positions: vec![a, b, c, DVec3::ONE],
            triangles: vec![[0, 1, 2]],
        };
        let (o, x, y) = (DVec3::ZERO, DVec3::X, DVec3::Y);
        let cases = [
            ("collinear", sheet(o, x, x * 2.0), o),
            ("NaN", sheet(o, x, y * f64::NAN), o),
            ("infinite", sheet(o, x, y * f64::INFINITY), o),
            ("subnormal", sheet(o, x * 5e-324, y * 5e-324), DVec3::Z),
            (
                "the whole range",
                sheet(DVec3::splat(-f64::MAX), x * f64::MAX, y * f64::MAX),
                DVec3::new(-1.0, -1.0, 3.0).normalize(),
            ),
        ];
        for (name, mesh, expected) in cases {
            for weighting in [Weighting::Plain, Weighting::Area, Weighting::Angle] {
                let normals = mesh.vertex_normals(weighting);
                assert_eq!(normals[3], DVec3::ZERO, "{name}: a vertex without faces");
                for n in &normals[..3] {
                    let off = (n - expected).length();
                    assert!(off <= 4.0 * EPS, "{name} {weighting:?}: {n}");
                }
            }
        }
        let both_sides = Mesh {
            positions: vec![o, x, y],
            triangles: vec![[0, 1, 2], [0, 2, 1]],
        };
        assert_eq!(
            both_sides.vertex_normals(Weighting::Angle),
            [DVec3::ZERO; 3]
        );
    }

    proptest! {
        #[test]
        fn never_panics(p in prop::collection::vec([ANY, ANY, ANY], 0..6), t in prop::collection::vec([0..7u32, 0..7u32, 0..7u32], 0..8)) {
            let mesh = Mesh { positions: p.into_iter().map(DVec3::from_array).collect(), triangles: t };
            for weighting in [Weighting::Plain, Weighting::Area, Weighting::Angle] {
                for n in mesh.vertex_normals(weighting) {
                    prop_assert!(n == DVec3::ZERO || (n.length() - 1.0).abs() <= 4.0 * EPS);
                }
            }
            let _ = (mesh.bounds(), mesh.is_closed(), mesh.is_two_manifold());
            let _ = Mesh::new(mesh.positions, mesh.triangles);
        }
    }
}
