//! Figures of the shadows lecture.

mod any_plane;
mod cube;
mod cut;
mod fake;
mod false_shadow;
mod light;
mod matrix;
mod setting;
mod shadow;
mod similar_triangles;
mod stage;
mod why;

use crate::figure::Figure;

/// In the order of the lecture.
pub(crate) const FIGURES: &[Figure] = &[
    why::FIGURE,
    similar_triangles::FIGURE,
    cube::INFINITY,
    cube::POINT,
    matrix::FIGURE,
    any_plane::FIGURE,
    false_shadow::FIGURE,
    fake::FIGURE,
];
