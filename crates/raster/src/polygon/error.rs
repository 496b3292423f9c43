//! What is wrong with contours.

use core::fmt;

use ombra_math::glam::DVec2;

/// Why contours cannot be filled.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PolygonError {
    /// A coordinate is NaN or infinite.
    NotFinite {
        /// Index of the contour.
        contour: usize,
        /// Index of the vertex in it.
        vertex: usize,
        /// The vertex.
        point: DVec2,
    },
}

impl fmt::Display for PolygonError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self::NotFinite {
            contour,
            vertex,
            point: DVec2 { x, y },
        } = self;
        write!(
            f,
            "vertex {vertex} of contour {contour} is ({x}, {y}): both coordinates must be finite"
        )
    }
}

impl core::error::Error for PolygonError {}
