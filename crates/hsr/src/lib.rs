//! The hidden-surfaces lecture: what of a scene an eye sees.
//!
//! | module | lecture topic |
//! | --- | --- |
//! | [`polygon`] | a planar convex polygon in space: the primitive of the lecture |
//! | [`pair`] | two primitives: one hides the other, both are visible, or they cross |
//! | [`object_space`] | the visible parts of every primitive, as polygons |
//! | [`image_space`] | a ray a pixel, the nearest hit wins |
//! | [`painter`] | back to front; what to do when no order exists |
//! | [`z_buffer`] | a depth a pixel, primitives in any order |
//! | [`back_face`] | faces turned away, left out before anything else |
//! | [`picture`] | which primitive is seen at each pixel: what the methods are compared by |
//!
//! An eye is homogeneous: w = 1 a place, w = 0 the direction *towards* the viewer of a parallel view.

pub mod back_face;
pub mod image_space;
pub mod object_space;
pub mod painter;
pub mod pair;
pub mod picture;
pub mod polygon;
pub mod z_buffer;

pub use polygon::Polygon;
