//! What the tests of the exercises share: compares whose message says what differs and by how much, pictures
//! of characters and of one's own, the pixels of a segment, step budgets that stop a loop without an end, and inputs that no file
//! shows.
//!
//! Every check panics when it fails, and names the line of the test that called it.

mod compare;
mod grid;
mod inputs;
mod picture;
mod segment;
mod shadow;
mod steps;
mod sticks;
mod windows;

pub use compare::{
    brief, brief_number, is_near, near, near_number, parallel, show, show_number, show_point,
    show_points, some,
};
pub use grid::Grid;
pub use inputs::Inputs;
pub use picture::{Ink, Panel, Picture};
pub use segment::Segment;
pub use shadow::{brief4, shadow_bound, shadow_plan, shadow_section};
pub use steps::{
    Steps, calls_within, collect_within, counted, first_calls, sum, sums, watched, within_calls,
};
pub use sticks::painted_sticks;
pub use windows::{PolygonCase, SIDES, WindowCase, point_beside, short_point};
