//! Fast form: which ends lie beyond a side says whether the segment enters or leaves there, and whether t matters.

use ombra_math::work::{Count, Counter};

use crate::crossing::{cut, order};
use crate::interval::Interval;
use crate::segment::Segment;
use crate::window::{Side, Window};

/// [`clip_segment`](super::clip_segment), counting its [work](crate#counted-work).
#[must_use]
pub fn clip_segment(window: &Window, segment: Segment, work: &mut impl Count) -> Option<Segment> {
    if !segment.is_finite() || window.is_empty() {
        return None;
    }
    let Segment { a, b } = segment;
    let mut left = Interval::WHOLE;
    for side in Side::ALL {
        work.add(Counter::Comparisons, 2);
        // q_k < 0 where a lies beyond the side, q_k < p_k where b does.
        let beyond = [window.is_beyond(side, a), window.is_beyond(side, b)];
        let line = window.line(side);
        left.cut(line, beyond, |k, best| order(segment, k, best, work))?;
    }
    let [a, b] = left.ends(
        [a, b],
        |entry, exit, work| order(segment, entry, exit, work),
        |line, work| {
            work.add(Counter::Divisions, 1);
            cut(segment, line)
        },
        work,
    )?;
    Some(Segment { a, b })
}
