//! The shadows lecture: where light does not reach, and what it costs to know.
//!
//! | module | lecture topic |
//! | --- | --- |
//! | [`planar`] | the shadow on a plane: matrix, per point, polygon, clipped to its receiver |
//! | [`fake`] | an ellipse instead of a shadow |
//!
//! A light is homogeneous: w = 1 a place, w = 0 a direction *towards* the light, and a negative w the same place
//! as with all signs turned.

pub mod fake;
pub mod planar;
