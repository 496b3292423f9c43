//! Cohen–Sutherland: four bits say where a point lies, and decide most segments without any intersection.
//!
//! The lines of the window's sides cut the plane into nine regions. Two codes tell at once that a segment is wholly
//! inside (OR is zero) or wholly beyond one side (AND is not); what is left is cut at one side and asked again.
#![cfg_attr(doc, doc = "")]
#![cfg_attr(doc, doc = include_str!("../figures/outcodes.svg"))]

use core::cmp::Ordering;

use ombra_math::glam::{DVec2, Vec2Swizzles};
use ombra_math::work::{Count, Counter};

use crate::crossing::{compare, cut, cut_in_window, two_entries};
use crate::lanes::{Mask, and, negative, not, or, select};
use crate::segment::Segment;
use crate::window::{Line, Side, Window};

mod outcode;

pub use outcode::{Outcode, outcode};

/// One iteration: the segment as it is, the codes of its ends, and what follows from them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step {
    /// What has not been cut off yet.
    pub segment: Segment,
    /// The codes of a and b as the true points they stand for: rounded onto a corner, a new end may be inside by itself.
    pub codes: [Outcode; 2],
    /// What the two codes decide.
    pub decision: Decision,
}

/// What two codes decide.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Decision {
    /// OR is 0000: the whole segment is inside.
    Accept,
    /// AND is not 0000: the whole segment is beyond one side.
    Reject,
    /// The first bit that differs: the end that has it is replaced by the crossing with its side.
    Cut {
        /// The side of that bit.
        side: Side,
        /// Whether it is a that is replaced; otherwise b.
        replaces_a: bool,
    },
}

/// The part of `segment` in `window`, or `None` if there is none.
///
/// # Formula
///
/// ```text
/// repeat:  code_a OR  code_b = 0000   →   inside
///          code_a AND code_b ≠ 0000   →   outside
///          otherwise cut at the first bit that differs; the end with the bit 1 becomes the crossing
/// ```
///
/// # Properties
///
/// - Ends inside are returned unchanged; others lie on the border, in the window exactly, at the double nearest to
///   the true crossing. So clipping twice changes nothing.
/// - Whether anything remains is decided exactly: a corner is missed or touched as it is, not as rounding says.
///   A segment that touches a corner gives that point, twice.
/// - Direction is kept, and the reversed segment gives the same points.
/// - A point (a = b) comes back if it is inside; a window that is a segment or a point works like any other.
/// - `None` if an end is not finite. Coordinates of any size: nothing overflows.
///
/// # Pitfalls
///
/// - Testing only OR in each iteration: (4, 14) → (14, 8) is cut to (32/3, 10) and then has the codes 0010 and 0010,
///   no bit differs, and the slide's loop finds nothing to cut (errata E22).
/// - Cutting what an earlier cut left adds up rounding: here each crossing is that of the segment as given.
///
/// # Examples
///
/// ```
/// use ombra_clip::{Segment, Window, cohen_sutherland};
/// use ombra_math::glam::DVec2;
///
/// let window = Window::new(DVec2::ZERO, DVec2::splat(10.0))?;
/// let steep = Segment::new(DVec2::new(2.0, 14.0), DVec2::new(8.0, -4.0));
/// let inside = Segment::new(DVec2::new(10.0 / 3.0, 10.0), DVec2::new(20.0 / 3.0, 0.0));
/// assert_eq!(cohen_sutherland::clip_segment(&window, steep), Some(inside));
/// let beside = Segment::new(DVec2::new(4.0, 14.0), DVec2::new(14.0, 8.0));
/// assert_eq!(cohen_sutherland::clip_segment(&window, beside), None);
/// # Ok::<(), ombra_clip::WindowError>(())
/// ```
///
/// # References
///
/// Grafica 3, «Algoritmo Cohen-Sutherland»; errata E22.
#[inline]
#[must_use]
pub fn clip_segment(window: &Window, segment: Segment) -> Option<Segment> {
    clip_segment_counted(window, segment, &mut ())
}

/// [`clip_segment`], counting its [work](crate#counted-work): where the codes leave any doubt, that of a crossing for
/// each end, for both are computed at once.
#[inline]
#[must_use]
pub fn clip_segment_counted(
    window: &Window,
    segment: Segment,
    work: &mut impl Count,
) -> Option<Segment> {
    work.add(Counter::Comparisons, 8);
    // Fast form: the same two tests, for both ends at once.
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
    let entries = two_entries(window, [x, y], [x.yx(), y.yx()], within, work);
    if both_ends(or(entries.certain, not(outside))) != 0 && !window.is_empty() {
        let x = select(outside, entries.x, x);
        let y = select(outside, entries.y, y);
        return Some(Segment::new(DVec2::new(x.x, y.x), DVec2::new(x.y, y.y)));
    }
    let missed = and(entries.missed(), outside);
    if missed[0] | missed[1] != 0 {
        return None;
    }
    clip_carefully(window, segment)
}

fn both_ends(mask: Mask) -> u64 {
    mask[0] & mask[1]
}

/// The same again, exactly: an end beyond one side is cut there or the segment misses; one in a corner's region is cut
/// at whichever of its two sides has the crossing in the window.
#[cold]
#[inline(never)]
fn clip_carefully(window: &Window, segment: Segment) -> Option<Segment> {
    if window.is_empty() || !segment.is_finite() {
        return None;
    }
    let entry = |end: DVec2| {
        if window.contains(end) {
            return Some(end);
        }
        Side::ALL
            .into_iter()
            .filter(|&side| outcode(window, end).has(side))
            .find_map(|side| cut_in_window(window, segment, window.line(side)))
    };
    Some(Segment::new(entry(segment.a)?, entry(segment.b)?))
}

/// The iterations of the method, the last one accepting or rejecting; none for an end that is not finite, nor for an
/// empty window (made by hand with `min` above `max`, or with NaN).
///
/// # Examples
///
/// ```
/// use ombra_clip::{Segment, Window, cohen_sutherland};
/// use ombra_math::glam::DVec2;
///
/// let window = Window::new(DVec2::ZERO, DVec2::splat(10.0))?;
/// let steep = Segment::new(DVec2::new(2.0, 14.0), DVec2::new(8.0, -4.0));
/// let codes: Vec<_> = cohen_sutherland::trace(&window, steep)
///     .iter()
///     .map(|step| format!("{} {}", step.codes[0], step.codes[1]))
///     .collect();
/// assert_eq!(codes, ["1000 0100", "0000 0100", "0000 0000"]);
/// # Ok::<(), ombra_clip::WindowError>(())
/// ```
///
/// # References
///
/// Grafica 3, «Algoritmo Cohen-Sutherland», the second slide's steps.
#[must_use]
pub fn trace(window: &Window, segment: Segment) -> Vec<Step> {
    let mut steps = Vec::new();
    iterate(window, segment, &mut (), |step| steps.push(step));
    steps
}

/// [`clip_segment`] in its plain form, by the iterations of [`trace`], counting its [work](crate#counted-work).
///
/// # Properties
///
/// The same result, bit for bit.
///
/// # References
///
/// As for [`trace`].
#[must_use]
pub fn clip_segment_in_steps(
    window: &Window,
    segment: Segment,
    work: &mut impl Count,
) -> Option<Segment> {
    let mut last = None;
    iterate(window, segment, work, |step| last = Some(step));
    last.filter(|step| step.decision == Decision::Accept)
        .map(|step| step.segment)
}

/// Plain form: the method as the slides have it, with both tests in each iteration.
fn iterate(window: &Window, given: Segment, work: &mut impl Count, mut report: impl FnMut(Step)) {
    if !given.is_finite() || window.is_empty() {
        return;
    }
    let mut segment = given;
    work.add(Counter::Comparisons, 8);
    let mut codes = [outcode(window, given.a), outcode(window, given.b)];
    // No side is cut twice.
    for _ in 0..=Side::ALL.len() {
        let mut step = |decision| {
            report(Step {
                segment,
                codes,
                decision,
            });
        };
        if (codes[0] | codes[1]).is_inside() {
            return step(Decision::Accept);
        }
        if !(codes[0] & codes[1]).is_inside() {
            return step(Decision::Reject);
        }
        // AND is zero and OR is not: some bit differs.
        let Some(side) = Side::ALL
            .into_iter()
            .find(|&side| codes[0].has(side) != codes[1].has(side))
        else {
            return;
        };
        let replaces_a = codes[0].has(side);
        step(Decision::Cut { side, replaces_a });
        work.add(Counter::Divisions, 1);
        work.add(Counter::Comparisons, 2);
        let line = window.line(side);
        let p = cut(given, line);
        let code = outcode_of_crossing(window, given, line, p);
        if replaces_a {
            (segment.a, codes[0]) = (p, code);
        } else {
            (segment.b, codes[1]) = (p, code);
        }
    }
}

/// The code of the crossing of `segment` with `line`, of which `p` is the nearest double.
fn outcode_of_crossing(window: &Window, segment: Segment, line: Line, p: DVec2) -> Outcode {
    let beyond = |along: f64, limit: f64, side: Side, way: Ordering| {
        if compare(segment, line, along, limit) == way {
            Outcode::of(side)
        } else {
            Outcode::INSIDE
        }
    };
    match line {
        Line::Vertical(_) => {
            beyond(p.y, window.max.y, Side::Above, Ordering::Greater)
                | beyond(p.y, window.min.y, Side::Below, Ordering::Less)
        }
        Line::Horizontal(_) => {
            beyond(p.x, window.max.x, Side::Right, Ordering::Greater)
                | beyond(p.x, window.min.x, Side::Left, Ordering::Less)
        }
    }
}

#[cfg(test)]
mod tests;
