//! Which primitive is seen at each pixel: what the methods are compared by.
//!
//! The picture of a method is a buffer of primitives' numbers. [`paint`] makes it of polygons in a given order, for the
//! methods that end in one; [`triangles`] hands the same polygons to the z-buffer; [`compare`] tells where two pictures
//! differ, and how far from any edge that is.

mod difference;

use core::fmt;

use ombra_clip::homogeneous::{Vertex, clip_polygon};
use ombra_math::camera::Camera;
use ombra_math::glam::{DVec2, DVec4, UVec2};
use ombra_math::homogeneous::project;
use ombra_math::mesh::{Mesh, MeshError};
use ombra_math::view::Viewport;
use ombra_math::work::Count;
use ombra_raster::buffers::image::{ImageBuffer, Luma};
use ombra_raster::buffers::{self, BufferError};
use ombra_raster::polygon::{self, FillRule, PolygonError};

use crate::polygon::Polygon;

pub use difference::{Difference, compare};

/// A primitive's number for every pixel, [`NOTHING`] where none is seen.
pub type IdBuffer = ImageBuffer<Luma<u32>, Vec<u32>>;

/// The number of no primitive: the background.
pub const NOTHING: u32 = u32::MAX;

/// Why there is no picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PictureError {
    /// The buffer is too large.
    Buffer(BufferError),
    /// The camera has no eye: a number of its matrix is NaN or infinite, or the matrix cannot be inverted.
    NoEye {
        /// Which row of the matrix: the first that is not finite, or else the last.
        row: usize,
        /// What stands in it.
        numbers: DVec4,
    },
    /// A pixel has no sight line, though the camera has an eye.
    NoSightLine {
        /// The pixel.
        pixel: UVec2,
    },
    /// A primitive's number does not fit below [`NOTHING`].
    TooMany {
        /// The number.
        id: usize,
    },
    /// A vertex falls beyond the largest double in pixel coordinates.
    TooFar {
        /// The primitive's number.
        id: usize,
    },
    /// Pictures of two sizes cannot be compared.
    Sizes {
        /// Columns and rows of the first.
        first: UVec2,
        /// Columns and rows of the second.
        second: UVec2,
    },
}

impl fmt::Display for PictureError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Buffer(error) => error.fmt(f),
            Self::NoEye { row, numbers } => write!(
                f,
                "the camera's matrix, with {:?} in row {row}, has no eye; it must be finite and invertible",
                numbers.to_array()
            ),
            Self::NoSightLine { pixel } => write!(
                f,
                "pixel {pixel} has no sight line; the camera's matrix must be invertible there too"
            ),
            Self::TooMany { id } => write!(
                f,
                "primitive {id} is one too many; at most {NOTHING} are allowed, numbered from 0"
            ),
            Self::TooFar { id } => write!(
                f,
                "a vertex of primitive {id} has no finite pixel coordinates; bring the view volume to a smaller scale"
            ),
            Self::Sizes { first, second } => write!(
                f,
                "one picture has {first} columns and rows, the other {second}; they must be of one size"
            ),
        }
    }
}

impl core::error::Error for PictureError {}

impl From<BufferError> for PictureError {
    fn from(error: BufferError) -> Self {
        Self::Buffer(error)
    }
}

/// [`paint`], counting what [`polygon::counted::fill`] counts: vertices after clipping, edge records, fragments.
///
/// # Errors
///
/// As [`paint`].
pub fn paint_plain<'a>(
    parts: impl IntoIterator<Item = (usize, &'a Polygon)>,
    camera: &Camera,
    work: &mut impl Count,
) -> Result<IdBuffer, PictureError> {
    let mut picture = background(camera)?;
    let (width, height) = picture.dimensions();
    // Back to front: each over what is painted already.
    for (id, polygon) in parts {
        // Clip and project,
        let outline = projected(polygon, camera);
        let number = number(id)?;
        // then fill.
        let spans =
            polygon::counted::fill(&[outline], FillRule::NonZero, width, height, &mut *work)
                .map_err(|PolygonError::NotFinite { .. }| PictureError::TooFar { id })?;
        buffers::paint(&mut picture, spans, Luma([number]))?;
    }
    Ok(picture)
}

/// The picture of numbered polygons, each over those before it: the second half of the painter's algorithm.
///
/// # Properties
///
/// Each polygon is clipped to the view volume before the division by w, and covers the pixels whose centres it holds,
/// by the top-left rule: exactly, for the pixel coordinates its vertices are rounded to. Polygons that share an edge,
/// or a cut, leave no gap. Numbers may repeat: the parts of one primitive.
///
/// # Pitfalls
///
/// The order is the caller's: paint the farthest first. A vertex of one polygon in the middle of another's edge is
/// rounded to one side of it, and a centre that lies just there may be missed, or covered twice.
///
/// # Errors
///
/// A picture that is too large, a camera without an eye, a number from [`NOTHING`] on, a vertex beyond the largest
/// double in pixel coordinates. Polygons with fewer than three vertices or vertices that are not finite cover nothing.
///
/// # Examples
///
/// ```
/// use ombra_hsr::picture::{NOTHING, paint};
/// use ombra_hsr::polygon::Polygon;
/// use ombra_math::camera::Camera;
/// use ombra_math::glam::{DMat4, DVec3};
/// use ombra_math::view::Viewport;
///
/// let square = |min: f64, max: f64| Polygon {
///     vertices: [(min, min), (max, min), (max, max), (min, max)].map(|(x, y)| DVec3::new(x, y, 0.0)).to_vec(),
/// };
/// let camera = Camera { view_projection: DMat4::IDENTITY, viewport: Viewport { width: 4, height: 2 } };
/// let (behind, before) = (square(-0.6, 1.0), square(0.0, 1.0));
/// let picture = paint([(0, &behind), (1, &before)], &camera).unwrap();
/// assert_eq!(picture.into_raw(), [
///     NOTHING, 0, 1, 1,
///     NOTHING, 0, 0, 0,
/// ]);
/// ```
///
/// # References
///
/// Grafica 3, «Algoritmo del Pittore (depth-sort)»: the rasterization, back to front.
pub fn paint<'a>(
    parts: impl IntoIterator<Item = (usize, &'a Polygon)>,
    camera: &Camera,
) -> Result<IdBuffer, PictureError> {
    paint_plain(parts, camera, &mut ())
}

/// The same answers, each counting its work.
pub mod counted {
    pub use super::paint_plain as paint;
}

/// The polygons as one mesh, each as a fan round its first vertex, and the polygon that each triangle is of.
///
/// # Properties
///
/// Triangles come in the order of the polygons. A polygon with fewer than three vertices gives none.
///
/// # Errors
///
/// As [`Mesh::new`].
///
/// # Examples
///
/// ```
/// use ombra_hsr::picture::{polygons, triangles};
/// use ombra_math::solids::slide_cube;
///
/// let faces = polygons(&slide_cube());
/// let (mesh, sources) = triangles(&faces).unwrap();
/// assert_eq!((mesh.triangles.len(), sources), (12, (0..12).collect::<Vec<_>>()));
/// ```
pub fn triangles(polygons: &[Polygon]) -> Result<(Mesh, Vec<usize>), MeshError> {
    let mut positions = Vec::new();
    let (mut triangles, mut sources) = (Vec::new(), Vec::new());
    for (source, polygon) in polygons.iter().enumerate() {
        // Numbers that do not fit are turned down by `Mesh::new`: as many vertices are too many triangles.
        let first = positions.len() as u32;
        positions.extend_from_slice(&polygon.vertices);
        for last in (first..positions.len() as u32).skip(2) {
            triangles.push([first, last - 1, last]);
            sources.push(source);
        }
    }
    Ok((Mesh::new(positions, triangles)?, sources))
}

/// The triangles of a mesh as polygons, under their own numbers: one that names a missing vertex is an empty polygon.
#[must_use]
pub fn polygons(mesh: &Mesh) -> Vec<Polygon> {
    (0..mesh.triangles.len())
        .map(|i| Polygon {
            vertices: mesh.triangle(i).map_or_else(Vec::new, |t| t.to_vec()),
        })
        .collect()
}

/// An empty picture for `camera`, if it can take one.
pub(crate) fn background(camera: &Camera) -> Result<IdBuffer, PictureError> {
    if camera.eye().is_none() {
        let matrix = &camera.view_projection;
        let row = (0..3).find(|&row| !matrix.row(row).is_finite());
        let row = row.unwrap_or(3);
        let numbers = matrix.row(row);
        return Err(PictureError::NoEye { row, numbers });
    }
    let Viewport { width, height } = camera.viewport;
    Ok(buffers::new(width, height, Luma([NOTHING]))?)
}

/// A primitive's number as it is stored.
pub(crate) fn number(id: usize) -> Result<u32, PictureError> {
    u32::try_from(id)
        .ok()
        .filter(|&number| number != NOTHING)
        .ok_or(PictureError::TooMany { id })
}

/// What of a polygon lies in the view volume, in pixel coordinates.
fn projected(polygon: &Polygon, camera: &Camera) -> Vec<DVec2> {
    let corners: Vec<_> = polygon
        .vertices
        .iter()
        .map(|&p_world| Vertex {
            position: camera.to_clip(p_world),
            attributes: [],
        })
        .collect();
    clip_polygon(&corners)
        .iter()
        .map(|corner| {
            project(corner.position)
                .map_or(DVec2::NAN, |ndc| camera.viewport.to_pixel(ndc).truncate())
        })
        .collect()
}

#[cfg(test)]
mod tests;
