//! Figures of the clipping lecture: what is kept is vermilion, what is cut off faint and dashed.

mod bars;
mod board;
mod cohen_sutherland;
mod cyrus_beck;
mod liang_barsky;
mod outcodes;
mod point_window;
mod polygon_cases;
mod segment_cases;
mod sutherland_hodgman;
mod w_zero;

use crate::figure::Figure;

/// In the order of the lecture.
pub(crate) const FIGURES: &[Figure] = &[
    point_window::FIGURE,
    segment_cases::FIGURE,
    outcodes::FIGURE,
    cohen_sutherland::FIGURE,
    liang_barsky::FIGURE,
    cyrus_beck::FIGURE,
    sutherland_hodgman::FIGURE,
    polygon_cases::FIGURE,
    w_zero::FIGURE,
];
