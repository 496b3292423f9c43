//! The clipping lecture: what of a segment or a polygon lies inside.
pub mod box3;
pub mod cohen_sutherland;
pub mod crossing;
pub mod cyrus_beck;
pub mod direct;
pub mod homogeneous;
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
