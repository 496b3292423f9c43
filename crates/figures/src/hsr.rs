//! Figures of the hidden surfaces lecture.

mod back_face;
mod depth_precision;
#[cfg(test)]
mod drawn;
mod image_space_ray;
mod object_space_pairs;
mod painter_cycle;
mod painter_steps;
mod primitives;
mod stage;
mod zbuffer_steps;

use crate::figure::Figure;

/// In the order of the lecture.
pub(crate) const FIGURES: &[Figure] = &[
    object_space_pairs::FIGURE,
    image_space_ray::FIGURE,
    painter_steps::FIGURE,
    painter_cycle::FIGURE,
    zbuffer_steps::FIGURE,
    depth_precision::FIGURE,
    back_face::FIGURE,
];
