//! The clipping lecture: what of a point, a segment or a polygon lies inside a window.
//!
//! Windows are upright rectangles with y upwards. What decides (inside or outside, which side is met first, whether
//! anything remains) is exact; new points are the doubles nearest to the true ones ([`crossing`]), so that results
//! lie in the window exactly and clipping twice changes nothing.
//!
//! | module | lecture topic |
//! | --- | --- |
//! | [`window`] | a point in the window: four inequalities |
//! | [`segment`] | a segment and its parametric equation |
//! | [`crossing`] | where a segment crosses a side |
//! | [`direct`] | segment: intersections with all four sides |
//! | [`cohen_sutherland`] | segment: four bits for each end, and the trace of the iterations |
//! | [`liang_barsky`] | segment: entries and exits (beyond the lecture) |
//! | [`cyrus_beck`] | segment: any convex polygon or polyhedron |
//! | [`box3`] | segment in space: a box, six bits |
//! | [`homogeneous`] | segment and polygon in space: the view volume, before the division by w |
//! | [`sutherland_hodgman`] | polygon: one line or plane after another |
//! | [`pieces`] | polygon: separate parts of a concave one |
//!
//! The same question has the same signature, so that answers can be exchanged: `direct::clip_segment`,
//! `cohen_sutherland::clip_segment`, `liang_barsky::clip_segment`. Those have a `clip_segment_counted`, which counts its work.

pub mod box3;
pub mod cohen_sutherland;
pub mod crossing;
pub mod cyrus_beck;
pub mod direct;
pub mod homogeneous;
mod lanes;
pub mod liang_barsky;
#[cfg(test)]
mod oracle;
mod outline;
pub mod pieces;
pub mod segment;
pub mod sutherland_hodgman;
pub mod window;

pub use segment::Segment;
pub use window::{Window, WindowError};
