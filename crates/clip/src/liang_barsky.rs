//! Liang–Barsky: where the segment enters each strip of the window, and where it leaves.
//!
//! Beyond the lecture. The window is what two strips have in common. A segment is inside from the latest of its
//! entries to the earliest of its exits; nothing is left of it where an exit comes first. So at most two
//! intersections are computed.

use core::cmp::Ordering;

use ombra_math::work::{Count, Counter};

use crate::crossing::{cut, order};
use crate::segment::Segment;
use crate::window::{Line, Side, Window};

/// The part of `segment` in `window`, or `None` if there is none.
///
/// # Formula
///
/// ```text
/// t p_k ≤ q_k          k      above        below        right        left
///                      p_k    y_b − y_a    y_a − y_b    x_b − x_a    x_a − x_b
///                      q_k    y_max − y_a  y_a − y_min  x_max − x_a  x_a − x_min
/// p_k < 0 enters, p_k > 0 leaves, at t_k = q_k / p_k;      t_in = max(0, entries),  t_out = min(1, exits)
/// nothing is left where t_in > t_out
/// ```
///
/// # Properties
///
/// The same, bit for bit, as [`cohen_sutherland::clip_segment`](crate::cohen_sutherland::clip_segment), where the
/// properties stand: an entry in x and an exit in y are compared exactly, as the side of the segment on which their
/// corner lies.
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
    clip_segment_counted(window, segment, &mut ())
}

/// [`clip_segment`], counting its [work](crate#counted-work).
#[must_use]
pub fn clip_segment_counted(
    window: &Window,
    segment: Segment,
    work: &mut impl Count,
) -> Option<Segment> {
    let Segment { a, b } = segment;
    if !segment.is_finite() || window.is_empty() {
        return None;
    }
    let (mut entry, mut exit): (Option<Line>, Option<Line>) = (None, None);
    for side in Side::ALL {
        let line = window.line(side);
        work.add(Counter::Comparisons, 2);
        // q_k < 0 where a lies beyond the side, q_k < p_k where b does.
        match (window.is_beyond(side, a), window.is_beyond(side, b)) {
            (false, false) => {}
            (true, true) => return None,
            (true, false) => {
                let later =
                    entry.is_none_or(|best| order(segment, line, best, work) == Ordering::Greater);
                entry = if later { Some(line) } else { entry };
            }
            (false, true) => {
                let earlier =
                    exit.is_none_or(|best| order(segment, line, best, work) == Ordering::Less);
                exit = if earlier { Some(line) } else { exit };
            }
        }
    }
    if let (Some(entry), Some(exit)) = (entry, exit)
        && order(segment, entry, exit, work) == Ordering::Greater
    {
        return None;
    }
    let mut cut_at = |line| {
        work.add(Counter::Divisions, 1);
        cut(segment, line)
    };
    Some(Segment {
        a: entry.map_or(a, &mut cut_at),
        b: exit.map_or(b, &mut cut_at),
    })
}

#[cfg(test)]
mod tests;
