//! What is wrong with a triangle.

use core::fmt;

use ombra_math::glam::DVec2;

/// Why a triangle is not covered with pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TriangleError {
    /// A coordinate is NaN or infinite.
    NotFinite {
        /// Index of the vertex.
        vertex: usize,
        /// The vertex.
        point: DVec2,
    },
}

impl fmt::Display for TriangleError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self::NotFinite {
            vertex,
            point: DVec2 { x, y },
        } = self;
        write!(
            f,
            "vertex {vertex} of the triangle is ({x}, {y}): both coordinates must be finite"
        )
    }
}

impl core::error::Error for TriangleError {}

/// Refuses the first vertex that is not finite.
pub(super) fn check(triangle: [DVec2; 3]) -> Result<(), TriangleError> {
    match (0..).zip(triangle).find(|(_, point)| !point.is_finite()) {
        Some((vertex, point)) => Err(TriangleError::NotFinite { vertex, point }),
        None => Ok(()),
    }
}
