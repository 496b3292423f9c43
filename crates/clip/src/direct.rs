//! The direct method: intersect the segment with all four sides of the window.
//!
//! The lecture's first approach, and its costly one: every side that is not parallel is intersected, and an
//! intersection counts where its parameter lies in [0, 1] on the segment and on the side.
#![cfg_attr(doc, doc = "")]
#![cfg_attr(doc, doc = include_str!("../figures/segment-cases.svg"))]

use ombra_math::work::{Count, Counter};

use crate::crossing::cut_in_window;
use crate::segment::Segment;
use crate::window::{Side, Window};

/// [`clip_segment`] as the slide tells it, counting its [work](crate#counted-work).
///
/// # Properties
///
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
    // Both ends inside: the whole segment is.
    let Segment { mut a, mut b } = segment;
    let mut inside = [window.contains(a), window.contains(b)];
    work.add(Counter::Comparisons, 8);
    if inside == [true, true] {
        return Some(segment);
    }
    for side in Side::ALL {
        // Not parallel to the side, and 0 < t_segm < 1: just one end lies beyond it.
        let line = window.line(side);
        let [[from, to], _] = line.turn(segment.a, segment.b);
        let beyond = [segment.a, segment.b].map(|end| window.is_beyond(side, end));
        work.add(Counter::Comparisons, 3);
        if from == to || beyond[0] == beyond[1] {
            continue;
        }
        // 0 ≤ t_side ≤ 1: the intersection lies within the side.
        work.add(Counter::Divisions, 1);
        work.add(Counter::Comparisons, 2);
        let Some(p) = cut_in_window(window, segment, line) else {
            continue;
        };
        // It replaces the end beyond the side.
        if beyond[0] {
            (a, inside[0]) = (p, true);
        } else {
            (b, inside[1]) = (p, true);
        }
    }
    (inside == [true, true]).then_some(Segment { a, b })
}

/// The part of `segment` in `window`, or `None` if there is none.
///
/// # Formula
///
/// ```text
/// for each side:  not parallel to the segment,
///                 0 ≤ t_segm ≤ 1,   t_segm = (x_side − x_a) / (x_b − x_a)
///                 0 ≤ t_side ≤ 1    that is   y_min ≤ y ≤ y_max
/// ```
///
/// # Properties
///
/// - The same, bit for bit, as [`cohen_sutherland::clip_segment`](crate::cohen_sutherland::clip_segment), where the
///   properties stand.
/// - Error: none: each coordinate is the double nearest to the exact one.
///
/// # Pitfalls
///
/// Without the parallel check first, a segment along a side divides 0 by 0.
///
/// # Examples
///
/// ```
/// use ombra_clip::{Segment, Window, direct};
/// use ombra_math::glam::DVec2;
///
/// let window = Window::new(DVec2::ZERO, DVec2::splat(10.0))?;
/// let across = Segment::new(DVec2::new(-5.0, 5.0), DVec2::new(15.0, 5.0));
/// let inside = Segment::new(DVec2::new(0.0, 5.0), DVec2::new(10.0, 5.0));
/// assert_eq!(direct::clip_segment(&window, across), Some(inside));
/// # Ok::<(), ombra_clip::WindowError>(())
/// ```
///
/// # References
///
/// Grafica 3, «Clipping di un segmento», approccio diretto.
#[must_use]
pub fn clip_segment(window: &Window, segment: Segment) -> Option<Segment> {
    clip_segment_plain(window, segment, &mut ())
}

/// Each gives the same answer as the function of its name and counts its [work](crate#counted-work), which comes last.
pub mod counted {
    pub use super::clip_segment_plain as clip_segment;
}

#[cfg(test)]
mod tests;
