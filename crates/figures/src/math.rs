//! Figures of the mathematics that all lectures share, shown beside the modules they explain.

mod barycentric;
mod frustum;
mod marks;
mod plane;
mod spherical;

use crate::figure::Figure;

/// In the order of the lecture.
pub(crate) const FIGURES: &[Figure] = &[
    plane::FIGURE,
    barycentric::FIGURE,
    spherical::FIGURE,
    frustum::FIGURE,
];
