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
//! `cohen_sutherland::clip_segment`, `liang_barsky::clip_segment`.
//!
//! # Counted work
//!
//! Whatever is called `…_counted` gives the same answer and counts what it does for it, there where it does it:
//!
//! | counter | one for each |
//! | --- | --- |
//! | comparisons | number that is held against another to decide: a coordinate against a side (four for a code or for "in the window"), n·p against 0, the parameter of one crossing against another's |
//! | multiplications | product in such a decision: two for n·p in the plane, three in space, four for a homogeneous point; two for parameters, compared as fractions |
//! | divisions | crossing that is computed, however many coordinates it has |
//! | vertices | vertex of a polygon that is looked at; one that goes on to another side is looked at again |
//!
//! A decision counts once, also where rounding leaves doubt and it is made again exactly, and a crossing is a division,
//! however it is rounded: what exactness costs is time. Not counted are tests that numbers are finite and that a vertex
//! repeats another.

pub mod box3;
pub mod cohen_sutherland;
pub mod crossing;
pub mod cyrus_beck;
pub mod direct;
#[cfg(test)]
mod extremes;
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
