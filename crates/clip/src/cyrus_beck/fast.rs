//! Fast form: the side with the latest entry is the one whose ends lie on different sides of the segment's line, so that
//! no t is needed.

use core::cmp::Ordering;

use ombra_math::glam::DVec2;
use ombra_math::work::Count;

use super::{crossing, orientation, turn};
use crate::outline::{edges, is_finite};
use crate::segment::Segment;

/// [`clip_segment`](super::clip_segment), counting its [work](crate#counted-work).
#[must_use]
pub fn clip_segment(convex: &[DVec2], segment: Segment, work: &mut impl Count) -> Option<Segment> {
    if !segment.is_finite() || !is_finite(convex) {
        return None;
    }
    let outside = turn(convex, work)?.reverse();
    Some(Segment {
        a: entry(convex, segment, outside, work)?,
        b: entry(convex, segment.reversed(), outside, work)?,
    })
}

/// The first point from a on that is inside.
fn entry(
    convex: &[DVec2],
    segment: Segment,
    outside: Ordering,
    work: &mut impl Count,
) -> Option<DVec2> {
    let Segment { a, b } = segment;
    let mut inside = true;
    for (p, q) in edges(convex) {
        if orientation((p, q), a, work)? != outside {
            continue;
        }
        inside = false;
        let reaches = orientation((p, q), b, work)? != outside;
        // Both on the line is no case: a would be on it, not outside.
        let passes_between = orientation((a, b), p, work)? != orientation((a, b), q, work)?;
        if reaches && passes_between {
            return Some(crossing(segment, (p, q), work));
        }
    }
    inside.then_some(a)
}
