//! Fast form: codes for what is inside or beyond one face, otherwise from the latest entry to the earliest exit.

use core::cmp::Ordering;

use ombra_math::glam::DVec3;
use ombra_math::work::{Count, Counter};

use super::{Box3, Face, Place, cut, outcode, seen};
use crate::crossing::order;
use crate::interval::Interval;
use crate::window::Line;

/// [`clip_segment`](super::clip_segment), counting its [work](crate#counted-work).
#[must_use]
pub fn clip_segment(
    bounds: &Box3,
    [a, b]: [DVec3; 2],
    work: &mut impl Count,
) -> Option<[DVec3; 2]> {
    work.add(Counter::Comparisons, 12);
    let codes = [outcode(bounds, a), outcode(bounds, b)];
    let finite = a.is_finite() && b.is_finite() && !bounds.is_empty();
    if !finite || !(codes[0] & codes[1]).is_inside() {
        return None;
    }
    let either = codes[0] | codes[1];
    if either.is_inside() {
        return Some([a, b]);
    }
    let mut left = Interval::WHOLE;
    for face in Face::ALL.into_iter().filter(|&face| either.has(face)) {
        let beyond = codes.map(|code| code.has(face));
        let first_met = |k, best| first_met([a, b], k, best, work);
        left.cut(face.place(bounds), beyond, first_met)?;
    }
    left.ends(
        [a, b],
        |entry, exit, work| first_met([a, b], entry, exit, work),
        |place, work| {
            work.add(Counter::Divisions, 1);
            cut([a, b], place)
        },
        work,
    )
}

/// Which of two faces is met first from a to b: seen along the third axis, a question in the plane.
fn first_met(segment: [DVec3; 2], (i, c): Place, (j, k): Place, work: &mut impl Count) -> Ordering {
    let other = match i == j {
        true => Line::Vertical(k),
        false => Line::Horizontal(k),
    };
    order(seen(segment, i, j), Line::Vertical(c), other, work)
}
