//! Oracles that the crates are measured against, in numbers without rounding ([`ombra_oracle`]): plain, and independent of what
//! they measure.
//!
//! | module | what it answers |
//! | --- | --- |
//! | [`shadow`] | the planar shadow of one vertex as an exact fraction, its decision and its condition |
//! | [`region`] | containment and blocking for shadow polygons, by exact signs |
//! | [`pixel`] | the pixels of a segment and of a triangle, by definition |
//! | [`clipping`] | what of a segment lies in a rectangle, a box, the view volume, to the nearest double; polygons in the view volume; areas |
//! | [`halfway`] | whether a double is the nearest one, by the points half way to its neighbours |
//! | [`whole_faces`] | faces with whole-number corners, and viewers of them |
//! | [`cases`] | random input spread over the whole range of exponents, a third of it next to a degenerate case |
//! | [`sources`] | what the crates offer, read from their sources |
//! | [`topic_index`] | the README's table of topics, taken apart |

pub mod cases;
pub mod clipping;
pub mod halfway;
pub mod pixel;
pub mod region;
pub mod shadow;
pub mod sources;
pub mod topic_index;
pub mod whole_faces;
