//! Figures of the hidden surfaces lecture.

use crate::figure::Figure;

/// In the order of the lecture.
pub(crate) const FIGURES: &[Figure] = &[];
