//! The rasterization lecture: which pixels stand for a segment, a polygon, a triangle.
//!
//! | module | lecture topic |
//! | --- | --- |
//! | [`analytic`] | a segment by y = m x + B |
//! | [`dda`] | a segment by y += m, in `f64` and `f32` |
//! | [`bresenham`] | a segment in integers, its decisions, its part in a window |
//! | [`rectangle`] | outline and filled |
//! | [`polygon`] | outline; filled under even-odd and non-zero, edge table and active edges |
//! | [`triangle`] | edge functions with the top-left rule |
//! | [`triangle_setup`] | the same on a grid of sub-pixels, in integers, with depth |
//! | [`attributes`] | linear and perspective-correct interpolation |
//! | [`span`] | a run of pixels in a row: what filling gives |
//! | [`buffers`] | colour, depth and stencil |
//! | [`depth_format`] | a depth in 16 or 24 bits, floating point, reversed |

pub mod analytic;
pub mod attributes;
pub mod bresenham;
pub mod buffers;
pub mod dda;
mod edge;
mod octant;
pub mod depth_format;
pub mod polygon;
pub mod rectangle;
pub mod span;
mod step;
pub mod triangle;
pub mod triangle_setup;

pub use span::Span;
