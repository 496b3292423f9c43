//! Why nothing was drawn.

use core::fmt;

use ombra_math::camera::Camera;
use ombra_math::glam::DVec3;

/// The longest side of a picture that is drawn: coordinates of 26 bits, products of 52, exact in a double.
pub const MAX_SIDE: u32 = 1 << 15;

/// Why nothing was drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum DrawError {
    /// A number of the camera's matrix is NaN or infinite.
    Matrix {
        /// Its row, from 0.
        row: usize,
        /// Its column, from 0.
        column: usize,
        /// The number.
        value: f64,
    },
    /// A position is NaN or infinite.
    Position {
        /// The vertex.
        vertex: usize,
        /// Its position.
        position: DVec3,
    },
    /// A position whose clip coordinates are beyond the largest double.
    Overflow {
        /// The vertex.
        vertex: usize,
        /// Its position.
        position: DVec3,
    },
    /// A triangle names a vertex that is not there.
    Index {
        /// The triangle.
        triangle: usize,
        /// The vertex it names.
        index: u32,
        /// How many vertices there are.
        vertices: usize,
    },
    /// The picture or the depth buffer has another size than the camera's viewport.
    Size {
        /// Columns and rows of the picture or the buffer.
        found: (u32, u32),
        /// Columns and rows of the viewport.
        viewport: (u32, u32),
    },
    /// A side of the picture is longer than [`MAX_SIDE`].
    TooLong {
        /// Columns and rows of the picture.
        size: (u32, u32),
    },
    /// There are not as many colours as triangles or vertices.
    Colours {
        /// How many there are.
        found: usize,
        /// How many there must be.
        expected: usize,
        /// What there must be one for: `"triangles"` or `"vertices"`.
        of: &'static str,
    },
}

impl fmt::Display for DrawError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Matrix { row, column, value } => write!(
                f,
                "the camera's matrix has {value} in row {row}, column {column}; all its numbers must be finite"
            ),
            Self::Position { vertex, position } => write!(
                f,
                "vertex {vertex} is at {position}; its coordinates must be finite numbers"
            ),
            Self::Overflow { vertex, position } => write!(
                f,
                "vertex {vertex} at {position} has clip coordinates beyond the largest double"
            ),
            Self::Index {
                triangle,
                index,
                vertices,
            } => write!(
                f,
                "triangle {triangle} names vertex {index}, but there are {vertices}, numbered from 0"
            ),
            Self::Size { found, viewport } => write!(
                f,
                "the buffer has {} × {} pixels, but the camera's viewport has {} × {}",
                found.0, found.1, viewport.0, viewport.1
            ),
            Self::TooLong { size } => write!(
                f,
                "a picture of {} × {} pixels is too large to draw: a side has at most {MAX_SIDE}",
                size.0, size.1
            ),
            Self::Colours {
                found,
                expected,
                of,
            } => write!(
                f,
                "the number of colours is {found}, but that of the mesh's {of} is {expected}; each needs one"
            ),
        }
    }
}

impl core::error::Error for DrawError {}

/// A buffer must have the viewport's size, and one that can be drawn.
pub(super) fn check_size(camera: &Camera, found: (u32, u32)) -> Result<(), DrawError> {
    let viewport = (camera.viewport.width, camera.viewport.height);
    if found != viewport {
        return Err(DrawError::Size { found, viewport });
    }
    if viewport.0.max(viewport.1) > MAX_SIDE {
        return Err(DrawError::TooLong { size: viewport });
    }
    Ok(())
}
