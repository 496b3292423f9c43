//! Where both ends of a segment enter the window, at once.

use ombra_math::glam::DVec2;
use ombra_math::work::{Count, Counter};

use crate::crossing::several_at;
use crate::lanes::{Mask, and, at_most, less, opaque, or, turn};
use crate::window::Window;

/// Where two segments, each from outside, enter the window.
pub(crate) struct Entries {
    /// The x and the y of both.
    pub(crate) x: DVec2,
    pub(crate) y: DVec2,
    /// Which are certain: in the window, and not at a corner.
    pub(crate) certain: Mask,
    /// Along their side: the crossing with its line, the first end, the side.
    along: DVec2,
    end: DVec2,
    low: DVec2,
    high: DVec2,
    rounded: Mask,
}

impl Entries {
    /// Which do not exist, for certain.
    #[inline]
    pub(crate) fn missed(&self) -> Mask {
        // Beyond a side that the end is not beyond, it misses. At a corner, rounding may have chosen the wrong line.
        let below = and(less(self.along, self.low), at_most(self.low, self.end));
        let above = and(less(self.high, self.along), at_most(self.end, self.high));
        and(self.rounded, or(below, above))
    }
}

/// Fast form: where two segments at once enter the window, each coming from outside; x and y of their first ends and of
/// their second ones, and how far within the window the first ends are in x and in y, negative outside.
///
/// Without branches: on random segments a wrong guess of the processor costs more than the arithmetic.
#[inline(always)]
pub(crate) fn two_entries(
    window: &Window,
    [ax, ay]: [DVec2; 2],
    [bx, by]: [DVec2; 2],
    [within_x, within_y]: [DVec2; 2],
    work: &mut impl Count,
) -> Entries {
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
        less(within_x, DVec2::ZERO),
        at_most(within_x * dy, within_y * dx),
    ));
    // Turn the plane so that this line is upright.
    let [a, along_a] = turn(upright, ax, ay);
    let [b, along_b] = turn(upright, bx, by);
    let [c, _] = turn(upright, corner_x, corner_y);
    let [_, low] = turn(upright, min_x, min_y);
    let [_, high] = turn(upright, max_x, max_y);
    let (along, rounded) = several_at(c, [a, b], [along_a, along_b]);
    let [x, y] = turn(upright, c, along);
    Entries {
        x,
        y,
        certain: and(rounded, and(less(low, along), less(along, high))),
        along,
        end: along_a,
        low,
        high,
        rounded,
    }
}
