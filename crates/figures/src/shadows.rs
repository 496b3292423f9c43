//! Figures of the shadows lecture.

mod any_plane;
mod cube;
mod fake;
mod false_shadow;
mod scene;
mod similar_triangles;
mod why;

use crate::figure::Figure;

/// In the order of the lecture.
pub(crate) const WHY: Figure = why::FIGURE;
pub(crate) const SIMILAR_TRIANGLES: Figure = similar_triangles::FIGURE;
pub(crate) const CUBE_INFINITY: Figure = cube::INFINITY;
pub(crate) const CUBE_POINT: Figure = cube::POINT;
pub(crate) const ANY_PLANE: Figure = any_plane::FIGURE;
pub(crate) const FALSE_SHADOW: Figure = false_shadow::FIGURE;
pub(crate) const FAKE: Figure = fake::FIGURE;
