//! The clipping lecture: what of a polygon lies on the right side.
//!
//! | module | lecture topic |
//! | --- | --- |
//! | [`sutherland_hodgman`] | a polygon against one line, plane or side after another |

pub mod sutherland_hodgman;
