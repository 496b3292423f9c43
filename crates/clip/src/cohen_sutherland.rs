//! Cohen–Sutherland: four bits say where a point lies, and decide most segments without any intersection.
//!
//! The lines of the window's sides cut the plane into nine regions. Two codes tell at once that a segment is wholly
//! inside (OR is zero) or wholly beyond one side (AND is not); what is left is cut at one side and asked again.
#![cfg_attr(doc, doc = "")]
#![cfg_attr(doc, doc = include_str!("../figures/outcodes.svg"))]

use core::cmp::Ordering;
use core::fmt;
use core::ops::{BitAnd, BitOr};

use ombra_math::glam::{DVec2, Vec2Swizzles};
use ombra_math::work::{Count, Counter};

use crate::crossing::{compare, cut, cut_in_window, two_entries};
use crate::lanes::{Mask, and, negative, not, or, select};
use crate::segment::Segment;
use crate::window::{Line, Side, Window};

/// Where a point lies: above, below, right, left of the window.
///
/// # Formula
///
/// ```text
/// bit 1: y > y_max      bit 2: y < y_min      bit 3: x > x_max      bit 4: x < x_min
/// 1001 | 1000 | 1010
/// 0001 | 0000 | 0010
/// 0101 | 0100 | 0110
/// ```
///
/// # Properties
///
/// Bits are written from left to right, as the lecture does. 0000 is the window itself, border included.
///
/// # References
///
/// Grafica 3, «Algoritmo Cohen-Sutherland».
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Outcode(u8);

impl Outcode {
    /// 0000.
    pub const INSIDE: Self = Self(0);
    /// 1000.
    pub const ABOVE: Self = Self(0b1000);
    /// 0100.
    pub const BELOW: Self = Self(0b0100);
    /// 0010.
    pub const RIGHT: Self = Self(0b0010);
    /// 0001.
    pub const LEFT: Self = Self(0b0001);

    /// The code with the one bit of `side`.
    #[must_use]
    pub const fn of(side: Side) -> Self {
        match side {
            Side::Above => Self::ABOVE,
            Side::Below => Self::BELOW,
            Side::Right => Self::RIGHT,
            Side::Left => Self::LEFT,
        }
    }

    /// The four bits as a number, `0b1001` for 1001.
    #[must_use]
    pub const fn bits(self) -> u8 {
        self.0
    }

    /// Whether all bits are 0.
    #[must_use]
    pub const fn is_inside(self) -> bool {
        self.0 == 0
    }

    /// Whether the bit of `side` is 1.
    #[must_use]
    pub const fn has(self, side: Side) -> bool {
        self.0 & Self::of(side).0 != 0
    }
}

/// Four digits: `1001` is above and to the left.
impl fmt::Display for Outcode {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:04b}", self.0)
    }
}

impl BitAnd for Outcode {
    type Output = Self;
    fn bitand(self, other: Self) -> Self {
        Self(self.0 & other.0)
    }
}

impl BitOr for Outcode {
    type Output = Self;
    fn bitor(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }
}

/// The region of `p`.
///
/// # Properties
///
/// 0000 exactly where [`Window::contains`] says inside: a coordinate that is NaN sets both bits of its axis, which no
/// number does.
///
/// # Examples
///
/// ```
/// use ombra_clip::Window;
/// use ombra_clip::cohen_sutherland::outcode;
/// use ombra_math::glam::DVec2;
///
/// let window = Window::new(DVec2::ZERO, DVec2::splat(10.0))?;
/// let (a, b) = (outcode(&window, DVec2::new(-1.0, 11.0)), outcode(&window, DVec2::new(11.0, 11.0)));
/// assert_eq!(format!("{a} AND {b} = {}", a & b), "1001 AND 1010 = 1000");
/// # Ok::<(), ombra_clip::WindowError>(())
/// ```
///
/// # References
///
/// Grafica 3, «Algoritmo Cohen-Sutherland».
#[allow(clippy::neg_cmp_op_on_partial_ord)] // so that NaN is not inside
#[inline]
#[must_use]
pub fn outcode(window: &Window, p: DVec2) -> Outcode {
    Outcode(
        u8::from(!(p.y <= window.max.y)) << 3
            | u8::from(!(p.y >= window.min.y)) << 2
            | u8::from(!(p.x <= window.max.x)) << 1
            | u8::from(!(p.x >= window.min.x)),
    )
}

/// One iteration: the segment as it is, the codes of its ends, and what follows from them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step {
    /// What has not been cut off yet.
    pub segment: Segment,
    /// The codes of a and b.
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
    let entries = two_entries(window, [x, y], [x.yx(), y.yx()], within);
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

/// The same without haste: an end beyond one side is cut there or the segment misses; one in a corner's region is cut
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

/// The iterations of the method, the last one accepting or rejecting; empty if an end is not finite.
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

/// [`clip_segment`] in its plain form, counting a division for each intersection.
///
/// # Properties
///
/// The same result, bit for bit.
#[must_use]
pub fn clip_segment_counted(
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
mod tests {
    use super::*;
    use crate::oracle::{self, is_nearest, r, window_and_segment};
    use crate::{direct, liang_barsky};
    use proptest::prelude::*;

    fn lecture() -> Window {
        Window::new(DVec2::ZERO, DVec2::splat(10.0)).unwrap()
    }

    fn segment(a: (f64, f64), b: (f64, f64)) -> Segment {
        Segment::new(a.into(), b.into())
    }

    /// The answer of every method, which must be one.
    fn clip(window: &Window, s: Segment) -> Option<Segment> {
        let answers = [
            clip_segment(window, s),
            clip_segment_counted(window, s, &mut ()),
            direct::clip_segment(window, s),
            liang_barsky::clip_segment(window, s),
        ];
        let bits = |s: Option<Segment>| s.map(|s| [s.a.x, s.a.y, s.b.x, s.b.y].map(f64::to_bits));
        for other in answers {
            assert_eq!(
                bits(answers[0]),
                bits(other),
                "{window:?} {s:?}: {answers:?}"
            );
        }
        answers[0]
    }

    #[test]
    fn the_lectures_segments() {
        let w = lecture();
        assert_eq!(
            clip(&w, segment((-5.0, 5.0), (15.0, 5.0))),
            Some(segment((0.0, 5.0), (10.0, 5.0)))
        );
        assert_eq!(
            clip(&w, segment((2.0, 14.0), (8.0, -4.0))),
            Some(segment((10.0 / 3.0, 10.0), (20.0 / 3.0, 0.0)))
        );
        assert_eq!(clip(&w, segment((4.0, 14.0), (14.0, 8.0))), None);
    }

    #[test]
    fn the_lectures_codes() {
        let w = lecture();
        let code = |x: f64, y: f64| outcode(&w, DVec2::new(x, y));
        let expected = [
            ["1001", "1000", "1010"],
            ["0001", "0000", "0010"],
            ["0101", "0100", "0110"],
        ];
        for (row, y) in expected.iter().zip([15.0, 5.0, -5.0]) {
            for (code_, x) in row.iter().zip([-5.0, 5.0, 15.0]) {
                assert_eq!(code(x, y).to_string(), *code_);
            }
        }
        let and = |p: (f64, f64), q: (f64, f64)| (code(p.0, p.1) & code(q.0, q.1)).to_string();
        assert_eq!(and((-5.0, 15.0), (15.0, 15.0)), "1000");
        assert_eq!(and((2.0, -5.0), (8.0, -5.0)), "0100");
        assert_eq!(and((-5.0, 5.0), (-5.0, -5.0)), "0001");
        assert_eq!((code(-5.0, 15.0) | code(15.0, 5.0)).to_string(), "1011");
    }

    #[test]
    fn the_lectures_iterations() {
        let steps = trace(&lecture(), segment((2.0, 14.0), (8.0, -4.0)));
        let cut = |side, replaces_a| Decision::Cut { side, replaces_a };
        let decisions: Vec<_> = steps.iter().map(|step| step.decision).collect();
        assert_eq!(
            decisions,
            [
                cut(Side::Above, true),
                cut(Side::Below, false),
                Decision::Accept
            ]
        );
        assert_eq!(steps[1].segment, segment((10.0 / 3.0, 10.0), (8.0, -4.0)));
        // Errata E22: AND is tested again after the cut.
        let steps = trace(&lecture(), segment((4.0, 14.0), (14.0, 8.0)));
        assert_eq!(steps.len(), 2);
        assert_eq!(steps[1].segment.a, DVec2::new(32.0 / 3.0, 10.0));
        assert_eq!(steps[1].codes.map(|c| c.to_string()), ["0010", "0010"]);
        assert_eq!(steps[1].decision, Decision::Reject);
    }

    #[test]
    fn beside_a_corner() {
        let w = lecture();
        // Through (0, 10) exactly; then the far end one double up, and one down.
        let through = segment((-3.0, 7.0), (5.0, 15.0));
        let corner = DVec2::new(0.0, 10.0);
        assert_eq!(clip(&w, through), Some(Segment::new(corner, corner)));
        assert_eq!(
            clip(&w, segment((-3.0, 7.0), (5.0, 15.0_f64.next_up()))),
            None
        );
        let inside = clip(&w, segment((-3.0, 7.0), (5.0, 15.0_f64.next_down()))).unwrap();
        assert!(w.contains(inside.a) && w.contains(inside.b));
    }

    #[test]
    fn degenerate() {
        let w = lecture();
        let (huge, tiny) = (f64::MAX, 5e-324);
        let cases = [
            // Points.
            (
                segment((5.0, 5.0), (5.0, 5.0)),
                Some(segment((5.0, 5.0), (5.0, 5.0))),
            ),
            (
                segment((10.0, 0.0), (10.0, 0.0)),
                Some(segment((10.0, 0.0), (10.0, 0.0))),
            ),
            (segment((11.0, 5.0), (11.0, 5.0)), None),
            (segment((-1.0, 11.0), (-1.0, 11.0)), None),
            // Along a side, touching an end, just beyond.
            (
                segment((-5.0, 10.0), (15.0, 10.0)),
                Some(segment((0.0, 10.0), (10.0, 10.0))),
            ),
            (
                segment((0.0, 15.0), (0.0, -5.0)),
                Some(segment((0.0, 10.0), (0.0, 0.0))),
            ),
            (segment((-5.0, -tiny), (15.0, -tiny)), None),
            (
                segment((10.0, 5.0), (15.0, 5.0)),
                Some(segment((10.0, 5.0), (10.0, 5.0))),
            ),
            // Beyond what differences of doubles hold.
            (
                segment((-huge, 5.0), (huge, 5.0)),
                Some(segment((0.0, 5.0), (10.0, 5.0))),
            ),
            (
                segment((-huge, -huge), (huge, huge)),
                Some(segment((0.0, 0.0), (10.0, 10.0))),
            ),
            (segment((-huge, huge), (huge, huge)), None),
            (
                segment((-1e308, 0.0), (1e308, 10.0)),
                Some(segment((0.0, 5.0), (10.0, 5.0))),
            ),
            (
                segment((tiny, tiny), (-tiny, tiny)),
                Some(segment((tiny, tiny), (0.0, tiny))),
            ),
        ];
        for (s, expected) in cases {
            assert_eq!(clip(&w, s), expected, "{s:?}");
        }
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            for k in 0..4 {
                let mut x = [5.0; 4];
                x[k] = bad;
                assert_eq!(clip(&w, segment((x[0], x[1]), (x[2], x[3]))), None, "{x:?}");
            }
        }
        let dot = Window::new(DVec2::splat(5.0), DVec2::splat(5.0)).unwrap();
        let at = Some(segment((5.0, 5.0), (5.0, 5.0)));
        assert_eq!(clip(&dot, segment((0.0, 0.0), (10.0, 10.0))), at);
        assert_eq!(
            clip(&dot, segment((0.0, 0.0), (10.0, 10.0_f64.next_up()))),
            None
        );
        assert_eq!(clip(&dot, segment((5.0, 0.0), (5.0, 9.0))), at);
        let (min, max) = (DVec2::new(10.0, 0.0), DVec2::new(0.0, 10.0));
        for by_hand in [
            Window { min, max },
            Window {
                min: DVec2::NAN,
                max,
            },
            Window {
                min,
                max: DVec2::NAN,
            },
        ] {
            for (s, _) in cases {
                assert_eq!(clip(&by_hand, s), None, "{by_hand:?} {s:?}");
            }
        }
    }

    #[test]
    fn counts_intersections() {
        let count = |s| {
            let mut work = ombra_math::work::Work::default();
            let mut direct = work;
            let _ = clip_segment_counted(&lecture(), s, &mut work);
            let _ = direct::clip_segment_counted(&lecture(), s, &mut direct);
            [work.divisions, direct.divisions]
        };
        assert_eq!(count(segment((2.0, 14.0), (8.0, -4.0))), [2, 2]);
        assert_eq!(count(segment((-5.0, 15.0), (-6.0, 5.0))), [0, 1]);
        // Above at x ≈ 9.3, below at x ≈ −0.2, so left too; the direct method also meets x = 10, in vain.
        assert_eq!(count(segment((-5.0, -5.0), (15.0, 16.0))), [3, 4]);
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(6000))]

        #[test]
        fn all_methods_give_the_nearest_doubles((w, s) in window_and_segment()) {
            let clipped = clip(&w, s);
            let expected = oracle::clip(&w, s);
            prop_assert_eq!(clipped.is_some(), expected.is_some(), "{:?}", expected);
            if let (Some(clipped), Some(expected)) = (clipped, expected) {
                for (p, q) in [clipped.a, clipped.b].iter().zip(&expected) {
                    prop_assert!(is_nearest(p.x, &q[0]) && is_nearest(p.y, &q[1]), "{p}");
                    prop_assert!(w.contains(*p));
                }
                prop_assert!(!w.contains(s.a) || clipped.a == s.a);
                prop_assert!(!w.contains(s.b) || clipped.b == s.b);
                prop_assert_eq!(clip(&w, clipped), Some(clipped));
                // Its direction: no coordinate turns round.
                let (d, e) = (s.b - s.a, clipped.b - clipped.a);
                prop_assert!(d.x.signum() * e.x >= 0.0 && d.y.signum() * e.y >= 0.0);
            }
            prop_assert_eq!(clip(&w, s.reversed()), clipped.map(Segment::reversed));
        }

        #[test]
        fn codes_and_inequalities_agree((w, s) in window_and_segment()) {
            prop_assert_eq!(outcode(&w, s.a).is_inside(), w.contains(s.a));
            for side in Side::ALL {
                prop_assert_eq!(outcode(&w, s.a).has(side), w.is_beyond(side, s.a));
            }
        }

        #[test]
        fn never_panics(x in prop::collection::vec(proptest::num::f64::ANY, 8)) {
            let (p, q) = (DVec2::new(x[0], x[1]), DVec2::new(x[2], x[3]));
            let s = segment((x[4], x[5]), (x[6], x[7]));
            for w in [Window { min: p, max: q }, Window { min: p.min(q), max: p.max(q) }] {
                if let Some(clipped) = clip(&w, s) {
                    prop_assert!(w.contains(clipped.a) && w.contains(clipped.b));
                }
                prop_assert_eq!(outcode(&w, s.a).is_inside(), w.contains(s.a));
            }
        }

        #[test]
        fn crossings_are_nearest_doubles((w, s) in window_and_segment(), x in oracle::number()) {
            for x in [x, w.min.x] {
                let between = (s.a.x <= x && x <= s.b.x) || (s.b.x <= x && x <= s.a.x);
                let y = crate::crossing::at_x(s, x);
                prop_assert_eq!(y.is_some(), between && s.a.x != s.b.x);
                if let Some(y) = y {
                    let t = (r(x) - r(s.a.x)) / (r(s.b.x) - r(s.a.x));
                    prop_assert!(is_nearest(y, &(r(s.a.y) + t * (r(s.b.y) - r(s.a.y)))));
                    let turned = segment((s.a.y, s.a.x), (s.b.y, s.b.x));
                    prop_assert_eq!(crate::crossing::at_y(turned, x), Some(y));
                }
            }
        }
    }
}
