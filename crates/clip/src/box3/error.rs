//! What is wrong with two corners.

use core::fmt;

use ombra_math::glam::DVec3;

/// Why two corners are no box.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Box3Error {
    /// A coordinate is NaN or infinite.
    NotFinite {
        /// The corner with that coordinate.
        corner: DVec3,
    },
    /// A coordinate of the first corner exceeds the second's.
    Swapped {
        /// The corner given as the least.
        min: DVec3,
        /// The corner given as the greatest.
        max: DVec3,
    },
}

impl fmt::Display for Box3Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotFinite { corner } => {
                write!(
                    f,
                    "box corner {corner}: all coordinates must be finite numbers"
                )
            }
            Self::Swapped { min, max } => write!(
                f,
                "box from {min} to {max}: no coordinate of the first corner may exceed the second's"
            ),
        }
    }
}

impl core::error::Error for Box3Error {}
