//! Cohen–Sutherland: four bits say where a point lies, and decide most segments without any intersection.
//!
//! The lines of the window's sides cut the plane into nine regions. Two codes tell at once that a segment is wholly
//! inside (OR is zero) or wholly beyond one side (AND is not); what is left is cut at one side and asked again.
#![cfg_attr(doc, doc = "")]
#![cfg_attr(doc, doc = include_str!("../figures/outcodes.svg"))]
#![cfg_attr(doc, doc = "")]
#![cfg_attr(doc, doc = include_str!("../figures/cohen-sutherland-steps.svg"))]

use core::iter::successors;

use ombra_math::glam::DVec2;
use ombra_math::work::{Count, Counter};

use crate::crossing::{compare, cut};
use crate::segment::Segment;
use crate::window::{Line, Side, Window};

mod fast;
mod outcode;
mod textbook;

pub use outcode::{Outcode, outcode};
pub use textbook::textbook;

/// [`clip_segment`] by the iterations of the slides, counting its [work](crate#counted-work).
///
/// # Properties
///
/// - The same result, bit for bit.
/// - Error: none: each coordinate is the double nearest to the exact one.
///
/// # References
///
/// As for [`clip_segment`].
#[must_use]
pub fn clip_segment_plain(
    window: &Window,
    given: Segment,
    work: &mut impl Count,
) -> Option<Segment> {
    if !given.is_finite() || window.is_empty() {
        return None;
    }
    let Segment { mut a, mut b } = given;
    let mut codes = [outcode(window, a), outcode(window, b)];
    work.add(Counter::Comparisons, 8);
    loop {
        // OR = 0000: both ends inside. AND ≠ 0000: both beyond one side.
        if (codes[0] | codes[1]).is_inside() {
            return Some(Segment { a, b });
        }
        if !(codes[0] & codes[1]).is_inside() {
            return None;
        }
        // Cut at the first side whose bits differ, then test both again.
        let side = first_difference(codes)?;
        let (p, code) = crossing(window, given, side);
        work.add(Counter::Divisions, 1);
        work.add(Counter::Comparisons, 2);
        // The crossing replaces the end with the bit 1.
        if codes[0].has(side) {
            (a, codes[0]) = (p, code);
        } else {
            (b, codes[1]) = (p, code);
        }
    }
}

/// The first side that one end lies beyond and the other does not.
fn first_difference([a, b]: [Outcode; 2]) -> Option<Side> {
    Side::ALL
        .into_iter()
        .find(|&side| a.has(side) != b.has(side))
}

/// Where the segment as given crosses a side, and the code of that point: of the true one, of which the point is the
/// nearest double.
fn crossing(window: &Window, given: Segment, side: Side) -> (DVec2, Outcode) {
    let line = window.line(side);
    let p = cut(given, line);
    let [_, [low, high]] = line.turn(window.min, window.max);
    let [_, [along, _]] = line.turn(p, p);
    let [below, above] = match line {
        Line::Vertical(_) => [Outcode::BELOW, Outcode::ABOVE],
        Line::Horizontal(_) => [Outcode::LEFT, Outcode::RIGHT],
    };
    let code = if compare(given, line, along, high).is_gt() {
        above
    } else if compare(given, line, along, low).is_lt() {
        below
    } else {
        Outcode::INSIDE
    };
    (p, code)
}

/// The part of `segment` in `window`, or `None` if there is none.
///
/// # Formula
///
/// ```text
/// repeat:  code_a OR  code_b = 0000   →   inside
///          code_a AND code_b ≠ 0000   →   outside
///          otherwise cut at the first bit that differs;
///           the end with the bit 1 becomes the crossing
/// ```
///
/// # Properties
///
/// - Error: none: each coordinate is the double nearest to the exact one.
/// - Ends inside are returned unchanged; others lie on the border, in the window exactly. So clipping twice changes
///   nothing.
/// - Whether anything remains is decided exactly: a corner is missed or touched as it is, not as rounding says.
///   A segment that touches a corner gives that point, twice.
/// - Direction is kept, and the reversed segment gives the same points.
/// - A point (a = b) comes back if it is inside; a window that is a segment or a point works like any other.
/// - `None` if an end is not finite. Coordinates of any size: nothing overflows.
///
/// # Pitfalls
///
/// - Testing only OR in each iteration: (4, 14) → (14, 8) is cut to (32/3, 10) and then has the codes 0010 and 0010,
///   no bit differs, and the slide's loop finds nothing to cut (errata [E22](crate#e22)).
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
/// Grafica 3, «Algoritmo Cohen-Sutherland»; errata [E22](crate#e22).
#[doc(alias = "line clipping")]
#[inline]
#[must_use]
pub fn clip_segment(window: &Window, segment: Segment) -> Option<Segment> {
    fast::clip_segment(window, segment, &mut ())
}

/// Each gives the same answer as the function of its name and counts its [work](crate#counted-work), which comes last.
pub mod counted {
    pub use super::fast::clip_segment;
}

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
    #[doc(alias = "trivial accept")]
    Accept,
    /// AND is not 0000: the whole segment is beyond one side.
    #[doc(alias = "trivial reject")]
    #[doc(alias = "rejection")]
    Reject,
    /// The first bit that differs: the end that has it is replaced by the crossing with its side.
    Cut {
        /// The side of that bit.
        side: Side,
        /// Whether it is a that is replaced; otherwise b.
        replaces_a: bool,
    },
}

/// The iterations of the method, the last one accepting or rejecting; none for an end that is not finite, nor for an
/// empty window (made by hand with `min` above `max`, or with NaN).
///
/// # Properties
///
/// - Error: none: each new coordinate is the double nearest to the exact one.
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
    if !segment.is_finite() || window.is_empty() {
        return Vec::new();
    }
    let codes = [segment.a, segment.b].map(|end| outcode(window, end));
    successors(Step::of(segment, codes), |step| step.next(window, segment)).collect()
}

impl Step {
    /// What follows from two codes.
    fn of(segment: Segment, codes: [Outcode; 2]) -> Option<Self> {
        let decision = if (codes[0] | codes[1]).is_inside() {
            Decision::Accept
        } else if !(codes[0] & codes[1]).is_inside() {
            Decision::Reject
        } else {
            let side = first_difference(codes)?;
            let replaces_a = codes[0].has(side);
            Decision::Cut { side, replaces_a }
        };
        Some(Self {
            segment,
            codes,
            decision,
        })
    }

    /// The next iteration, after a cut.
    fn next(&self, window: &Window, given: Segment) -> Option<Self> {
        let Decision::Cut { side, replaces_a } = self.decision else {
            return None;
        };
        let (p, code) = crossing(window, given, side);
        let (Segment { a, b }, [code_a, code_b]) = (self.segment, self.codes);
        if replaces_a {
            Self::of(Segment { a: p, b }, [code, code_b])
        } else {
            Self::of(Segment { a, b: p }, [code_a, code])
        }
    }
}

#[cfg(test)]
mod tests;
