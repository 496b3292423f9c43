//! Figures of the clipping lecture: what is kept is vermilion, what is cut off faint and dashed.

mod board;
mod cohen_sutherland;
mod outcodes;
mod point_window;
mod polygon_cases;
mod segment_cases;
mod sutherland_hodgman;

use crate::figure::Figure;

/// In the order of the lecture.
pub(crate) const FIGURES: &[Figure] = &[
    point_window::FIGURE,
    segment_cases::FIGURE,
    outcodes::FIGURE,
    cohen_sutherland::FIGURE,
    sutherland_hodgman::FIGURE,
    polygon_cases::FIGURE,
];
