//! Liang–Barsky: where the segment enters each strip of the window, and where it leaves.
//!
//! Beyond the lecture. The window is what two strips have in common. A segment is inside from the latest of its
//! entries to the earliest of its exits; nothing is left of it where an exit comes first. So at most two
//! intersections are computed.
#![cfg_attr(doc, doc = "")]
#![cfg_attr(doc, doc = include_str!("../figures/liang-barsky.svg"))]
#![doc(alias = "parametric clipping")]

use core::cmp::Ordering;

use ombra_math::glam::DVec2;
use ombra_math::work::{Count, Counter};

use crate::crossing::cut;
use crate::segment::Segment;
use crate::window::{Side, Window};

use parameter::{Difference, Parameter};

mod fast;
mod parameter;
mod textbook;

pub use textbook::textbook;

/// [`clip_segment`] as the paper tells it, counting its [work](crate#counted-work).
///
/// # Properties
///
/// - The same result, bit for bit: each t is kept as the fraction q/p, and two are compared exactly.
/// - Error: none: each coordinate is the double nearest to the exact one.
///
/// # References
///
/// As for [`clip_segment`].
#[must_use]
pub fn clip_segment_plain(
    window: &Window,
    segment: Segment,
    work: &mut impl Count,
) -> Option<Segment> {
    if !segment.is_finite() || window.is_empty() {
        return None;
    }
    // The whole segment: from t = 0, its end a, to t = 1, its end b.
    let (mut t_in, mut t_out) = (Parameter::ZERO, Parameter::ONE);
    let (mut entry, mut exit) = (None, None);
    for side in Side::ALL {
        let (p, q) = inequality(window, segment, side);
        let t = Parameter::new(q, p);
        work.add(Counter::Comparisons, 3);
        work.add(Counter::Multiplications, 4);
        match p.sign() {
            // Parallel to the side: beyond it everywhere, or nowhere.
            Ordering::Equal if q.sign() == Ordering::Less => return None,
            Ordering::Equal => {}
            // It enters here: the latest entry counts.
            Ordering::Less if t > t_in => (t_in, entry) = (t, Some(side)),
            Ordering::Less => {}
            // It leaves here: the earliest exit counts.
            Ordering::Greater if t < t_out => (t_out, exit) = (t, Some(side)),
            Ordering::Greater => {}
        }
        // Nothing is left of what leaves before it enters.
        if t_in > t_out {
            return None;
        }
    }
    // a + t (b − a) at both t's, rounded once.
    let mut at = |side: Option<Side>, end: DVec2| {
        side.map_or(end, |side| {
            work.add(Counter::Divisions, 1);
            cut(segment, window.line(side))
        })
    };
    Some(Segment {
        a: at(entry, segment.a),
        b: at(exit, segment.b),
    })
}

/// p_k and q_k of t p_k ≤ q_k: where a + t (b − a) is not beyond `side`.
fn inequality(window: &Window, Segment { a, b }: Segment, side: Side) -> (Difference, Difference) {
    let minus = |x, y| Difference([x, y]);
    match side {
        Side::Above => (minus(b.y, a.y), minus(window.max.y, a.y)),
        Side::Below => (minus(a.y, b.y), minus(a.y, window.min.y)),
        Side::Right => (minus(b.x, a.x), minus(window.max.x, a.x)),
        Side::Left => (minus(a.x, b.x), minus(a.x, window.min.x)),
    }
}

/// The part of `segment` in `window`, or `None` if there is none.
///
/// # Formula
///
/// ```text
/// t p_k ≤ q_k          k      above        below        right        left
///                      p_k    y_b − y_a    y_a − y_b    x_b − x_a    x_a − x_b
///                      q_k    y_max − y_a  y_a − y_min  x_max − x_a  x_a − x_min
/// p_k < 0 enters, p_k > 0 leaves, at t_k = q_k / p_k
/// t_in = max(0, entries),  t_out = min(1, exits)
/// nothing is left where t_in > t_out
/// ```
///
/// # Properties
///
/// - The same, bit for bit, as [`cohen_sutherland::clip_segment`](crate::cohen_sutherland::clip_segment), where the
///   properties stand: an entry in x and an exit in y are compared exactly, as the side of the segment on which their
///   corner lies.
/// - Error: none: each coordinate is the double nearest to the exact one.
///
/// # Pitfalls
///
/// Comparing rounded t's keeps segments that pass beside a corner, and drops some that touch it.
///
/// # Examples
///
/// ```
/// use ombra_clip::{Segment, Window, liang_barsky};
/// use ombra_math::glam::DVec2;
///
/// let window = Window::new(DVec2::ZERO, DVec2::splat(10.0))?;
/// let steep = Segment::new(DVec2::new(2.0, 14.0), DVec2::new(8.0, -4.0));
/// let inside = Segment::new(DVec2::new(10.0 / 3.0, 10.0), DVec2::new(20.0 / 3.0, 0.0));
/// assert_eq!(liang_barsky::clip_segment(&window, steep), Some(inside));
/// # Ok::<(), ombra_clip::WindowError>(())
/// ```
///
/// # References
///
/// In no deck. Y.-D. Liang, B. A. Barsky, «A new concept and method for line clipping», 1984.
#[must_use]
pub fn clip_segment(window: &Window, segment: Segment) -> Option<Segment> {
    fast::clip_segment(window, segment, &mut ())
}

/// Each gives the same answer as the function of its name and counts its [work](crate#counted-work), which comes last.
pub mod counted {
    pub use super::fast::clip_segment;
}

#[cfg(test)]
mod tests;
