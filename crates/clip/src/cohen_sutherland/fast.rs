//! Fast form: both ends at once, without branches.

use ombra_math::glam::{DVec2, Vec2Swizzles};
use ombra_math::work::{Count, Counter};

use super::clip_segment_plain;
use crate::crossing::several_at;
use crate::lanes::{Lanes, Mask, and, at_most, negative, not, opaque, or, select, turn};
use crate::segment::Segment;
use crate::window::Window;

/// [`clip_segment`](super::clip_segment), counting its [work](crate#counted-work): where the codes leave any doubt, that
/// of a crossing for each end, for both are computed at once.
#[inline]
#[must_use]
pub fn clip_segment(window: &Window, segment: Segment, work: &mut impl Count) -> Option<Segment> {
    work.add(Counter::Comparisons, 8);
    // The same two tests, for both ends at once.
    let Segment { a, b } = segment;
    let (x, y) = (DVec2::new(a.x, b.x), DVec2::new(a.y, b.y));
    let distances = [
        x + (0.0 - window.min.x), // on the border 0 for −0 too
        (window.max.x + 0.0) - x,
        y + (0.0 - window.min.y),
        (window.max.y + 0.0) - y,
    ];
    let [left, right, below, above] = distances.map(negative);
    let outside = or(or(left, right), or(below, above));
    if outside[0] | outside[1] == 0 {
        // A NaN has any sign, and a window made by hand may have anything.
        let inside = segment.is_finite() && !window.is_empty();
        // Built anew: one and the same registers for all answers.
        return inside.then(|| Segment::new(DVec2::new(x.x, y.x), DVec2::new(x.y, y.y)));
    }
    if both_ends(left) | both_ends(right) | both_ends(below) | both_ends(above) != 0 {
        return None;
    }
    // Each end enters by itself; what is wrong for one inside is not looked at.
    let [left, right, below, above] = distances;
    let within = [left.min(right), below.min(above)];
    let (entries, certain, missed) = two_entries(window, [x, y], [x.yx(), y.yx()], within, work);
    if both_ends(or(certain, not(outside))) != 0 && !window.is_empty() {
        let x = select(outside, entries[0], x);
        let y = select(outside, entries[1], y);
        return Some(Segment::new(DVec2::new(x.x, y.x), DVec2::new(x.y, y.y)));
    }
    let missed = and(missed, outside);
    if missed[0] | missed[1] != 0 {
        return None;
    }
    clip_carefully(window, segment)
}

fn both_ends(mask: Mask) -> u64 {
    mask[0] & mask[1]
}

/// The same again, exactly.
#[cold]
#[inline(never)]
fn clip_carefully(window: &Window, segment: Segment) -> Option<Segment> {
    clip_segment_plain(window, segment, &mut ())
}

/// Where two segments at once enter the window, each coming from outside; x and y of their first ends and of
/// their second ones, and how far within the window the first ends are in x and in y, negative outside. The answer: the
/// x and the y of both entries, which are certain, and which do not exist for certain.
///
/// Without branches: on random segments a wrong guess of the processor costs more than the arithmetic.
#[inline(always)]
fn two_entries(
    window: &Window,
    [ax, ay]: [DVec2; 2],
    [bx, by]: [DVec2; 2],
    [within_x, within_y]: [DVec2; 2],
    work: &mut impl Count,
) -> ([DVec2; 2], Mask, Mask) {
    // For each: is it beyond a side, which line is met last, does the crossing lie within the side?
    work.add(Counter::Comparisons, 2 * 4);
    work.add(Counter::Multiplications, 2 * 2);
    work.add(Counter::Divisions, 2);
    let splat = DVec2::splat;
    let (min_x, min_y) = (splat(window.min.x), splat(window.min.y));
    let (max_x, max_y) = (splat(window.max.x), splat(window.max.y));
    // The corner next to an end, or the foot on the side next to it. Of its lines, the one that is met last counts.
    let corner_x = ax.max(min_x).min(max_x) + 0.0;
    let corner_y = ay.max(min_y).min(max_y) + 0.0;
    let (dx, dy) = ((bx - ax).abs(), (by - ay).abs());
    let upright = opaque(and(
        within_x.less(DVec2::ZERO),
        at_most(within_x * dy, within_y * dx),
    ));
    // Turn the plane so that this line is upright.
    let [a, along_a] = turn(upright, ax, ay);
    let [b, along_b] = turn(upright, bx, by);
    let [c, _] = turn(upright, corner_x, corner_y);
    let [_, low] = turn(upright, min_x, min_y);
    let [_, high] = turn(upright, max_x, max_y);
    let (along, rounded) = several_at(c, [a, b], [along_a, along_b]);
    // In the window, and not at a corner.
    let certain = and(rounded, and(low.less(along), along.less(high)));
    // Beyond a side that the end is not beyond, it misses. At a corner, rounding may have chosen the wrong line.
    let below = and(along.less(low), at_most(low, along_a));
    let above = and(high.less(along), at_most(along_a, high));
    (
        turn(upright, c, along),
        certain,
        and(rounded, or(below, above)),
    )
}
