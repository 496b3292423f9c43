//! The method in plain doubles.

use ombra_math::glam::DVec2;
use ombra_math::work::{Count, Counter};

use super::{Outcode, outcode};
use crate::segment::Segment;
use crate::window::{Side, Window};

/// [`clip_segment`](super::clip_segment) as a textbook has it, in plain doubles, counting its [work](crate#counted-work).
///
/// # Formula
///
/// ```text
/// x = x_a + (x_b − x_a) (y_side − y_a) / (y_b − y_a)          a, b: what the last cut has left
/// ```
///
/// # Properties
///
/// - Error: unbounded: some ε of the ends' coordinates for one cut, for a second one the segment's slope times that.
/// - Any input has an answer, for no end is cut more often than there are sides. With ends that are not finite it means
///   nothing.
///
/// # Pitfalls
///
/// - Far ends cost digits. What is left of (−10¹², 1 − 10¹²) → (10¹², 10¹²) in the lecture's window begins at (0, 0.5);
///   here at (0, 0.49988).
/// - The codes are those of rounded points: (−0.1, 9.9) → (0.025, 10.025) passes beside the corner (0, 10) and is kept.
///
/// # Examples
///
/// ```
/// use ombra_clip::{Segment, Window, cohen_sutherland};
/// use ombra_math::glam::DVec2;
///
/// let window = Window::new(DVec2::ZERO, DVec2::splat(10.0))?;
/// let beside = Segment::new(DVec2::new(-0.1, 9.9), DVec2::new(0.025, 10.025));
/// assert_eq!(cohen_sutherland::clip_segment(&window, beside), None);
/// assert!(cohen_sutherland::textbook(&window, beside, &mut ()).is_some());
/// # Ok::<(), ombra_clip::WindowError>(())
/// ```
///
/// # References
///
/// Grafica 3, «Algoritmo Cohen-Sutherland».
#[must_use]
pub fn textbook(window: &Window, segment: Segment, work: &mut impl Count) -> Option<Segment> {
    let Segment { mut a, mut b } = segment;
    let mut codes = [outcode(window, a), outcode(window, b)];
    work.add(Counter::Comparisons, 8);
    // Each side is cut at once for each end, or rounding leads round in circles.
    for _ in 0..=2 * Side::ALL.len() {
        // OR = 0000: both ends inside. AND ≠ 0000: both beyond one side.
        if (codes[0] | codes[1]).is_inside() {
            return Some(Segment { a, b });
        }
        if !(codes[0] & codes[1]).is_inside() {
            return None;
        }
        // Cut an end that is outside, then test both again.
        let replaces_a = !codes[0].is_inside();
        let outside = if replaces_a { codes[0] } else { codes[1] };
        let p = cut(window, a, b, outside);
        work.add(Counter::Divisions, 1);
        work.add(Counter::Multiplications, 1);
        work.add(Counter::Additions, 4);
        work.add(Counter::Comparisons, 4);
        if replaces_a {
            (a, codes[0]) = (p, outcode(window, p));
        } else {
            (b, codes[1]) = (p, outcode(window, p));
        }
    }
    None
}

/// The crossing of a → b with the first side that `outside` names.
fn cut(window: &Window, a: DVec2, b: DVec2, outside: Outcode) -> DVec2 {
    let at_y = |y: f64| DVec2::new(a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y), y);
    let at_x = |x: f64| DVec2::new(x, a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x));
    if outside.has(Side::Above) {
        at_y(window.max.y)
    } else if outside.has(Side::Below) {
        at_y(window.min.y)
    } else if outside.has(Side::Right) {
        at_x(window.max.x)
    } else {
        at_x(window.min.x)
    }
}
