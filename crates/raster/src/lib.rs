//! The rasterization lecture: which pixels stand for a segment, a polygon, a triangle.

pub mod analytic;
pub mod bresenham;
pub mod dda;
pub mod rectangle;

pub mod attributes;
pub mod buffers;
pub mod polygon;
pub mod span;
pub mod triangle;
