//! Figures of the rasterization lecture: pixels that are on are vermilion, the ideal line or edge runs thin above.

mod bresenham_choice;
mod bresenham_increments;
mod bresenham_trace;
mod columns;
mod continuous_to_discrete;
mod dda_rounding;
mod perspective_correct;
mod polygon_kinds;
mod rectangle;
mod scanline;
mod segment_slopes;
mod sliver;
mod triangle_shared_edge;

use crate::figure::Figure;

/// In the order of the lecture.
pub(crate) const FIGURES: &[Figure] = &[
    continuous_to_discrete::FIGURE,
    segment_slopes::FIGURE,
    dda_rounding::FIGURE,
    bresenham_choice::FIGURE,
    bresenham_increments::FIGURE,
    bresenham_trace::FIGURE,
    rectangle::FIGURE,
    polygon_kinds::FIGURE,
    scanline::FIGURE,
    triangle_shared_edge::FIGURE,
    sliver::FIGURE,
    perspective_correct::FIGURE,
];
