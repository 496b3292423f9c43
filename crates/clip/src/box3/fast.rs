//! Fast form: codes for what is inside or beyond one face, otherwise from the latest entry to the earliest exit.

use core::cmp::Ordering;

use ombra_math::glam::DVec3;
use ombra_math::work::{Count, Counter};

use super::{Box3, Face, cut, outcode, seen};
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
    if !a.is_finite() || !b.is_finite() || bounds.is_empty() {
        return None;
    }
    if !(codes[0] & codes[1]).is_inside() {
        return None;
    }
    if (codes[0] | codes[1]).is_inside() {
        return Some([a, b]);
    }
    let mut left = Interval::WHOLE;
    for face in Face::ALL {
        let beyond = codes.map(|code| code.has(face));
        let side = (face.axis(), face.limit(bounds));
        left.cut(side, beyond, |k, best| first_met([a, b], k, best, work))?;
    }
    left.ends(
        [a, b],
        |entry, exit, work| first_met([a, b], entry, exit, work),
        |(axis, limit), work| {
            work.add(Counter::Divisions, 1);
            cut([a, b], axis, limit)
        },
        work,
    )
}

/// The axis across a face, and where on it the face stands.
type Place = (usize, f64);

/// Which of two faces is met first from a to b: seen along the third axis, a question in the plane.
fn first_met(segment: [DVec3; 2], (i, c): Place, (j, k): Place, work: &mut impl Count) -> Ordering {
    let other = if i == j {
        Line::Vertical(k)
    } else {
        Line::Horizontal(k)
    };
    order(seen(segment, i, j), Line::Vertical(c), other, work)
}
