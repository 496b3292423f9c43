//! The direct method: intersect the segment with all four sides of the window.
//!
//! The lecture's first approach, and its costly one: every side that is not parallel is intersected, and an
//! intersection counts where its parameter lies in [0, 1] on the segment and on the side.
#![cfg_attr(doc, doc = "")]
#![cfg_attr(doc, doc = include_str!("../figures/segment-cases.svg"))]

use ombra_math::work::{Count, Counter};

use crate::crossing::cut_in_window;
use crate::segment::Segment;
use crate::window::{Line, Side, Window};

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
/// The same, bit for bit, as [`cohen_sutherland::clip_segment`](crate::cohen_sutherland::clip_segment), where the
/// properties stand.
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
    work.add(Counter::Comparisons, 8);
    let inside = [window.contains(a), window.contains(b)];
    if inside == [true, true] {
        return Some(segment);
    }
    let mut clipped = segment;
    let mut reached = inside;
    for side in Side::ALL {
        work.add(Counter::Comparisons, 3);
        let line = window.line(side);
        let parallel = match line {
            Line::Vertical(_) => a.x == b.x,
            Line::Horizontal(_) => a.y == b.y,
        };
        let beyond = [window.is_beyond(side, a), window.is_beyond(side, b)];
        // t_segm is within ]0, 1[ where just one end lies beyond the side.
        if parallel || beyond[0] == beyond[1] {
            continue;
        }
        work.add(Counter::Divisions, 1);
        work.add(Counter::Comparisons, 2);
        let Some(p) = cut_in_window(window, segment, line) else {
            continue;
        };
        // The end beyond the side is cut off.
        if beyond[0] {
            (clipped.a, reached[0]) = (p, true);
        } else {
            (clipped.b, reached[1]) = (p, true);
        }
    }
    (reached == [true, true]).then_some(clipped)
}

#[cfg(test)]
mod tests;
