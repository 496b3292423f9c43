//! Where a segment crosses a line: the one place where clipping computes a point.
//!
//! Every crossing is the double nearest to the exact one. Rounding to nearest keeps order (x ≤ y gives
//! fl(x) ≤ fl(y)), and that is why clipped points lie in the window exactly, why clipping twice changes nothing,
//! why both directions of a segment give the same point, and why methods that cut in a different order agree.

use core::cmp::Ordering;

use ombra_math::exact::Sum;
use ombra_math::glam::{DVec2, Vec2Swizzles};
use ombra_math::predicates::orient_2d;
use ombra_math::work::{Count, Counter};

use crate::segment::Segment;
use crate::window::{Line, Window};

mod fast;
mod queue;

pub(crate) use fast::{LARGE, at, between, between_products, several_at};
pub(crate) use queue::{LENGTH, Queue};

/// The height at which a segment crosses the upright line at `x`, to the nearest double; `None` if it lies on one
/// side of that line or along it, or a number is not finite.
///
/// # Formula
///
/// ```text
/// y = (y_a (x_b − x) + y_b (x − x_a)) / (x_b − x_a)
/// ```
///
/// # Properties
///
/// - Error: none: the double nearest to the exact one, ties to even, at every exponent.
/// - So it is the same for both directions of the segment; where the line meets an end, it is that end's y.
///
/// # Pitfalls
///
/// y_a + t (y_b − y_a) with a rounded t can leave the window it was cut to by an ulp, and b's own y is not hit at
/// t = 1.
///
/// # Examples
///
/// ```
/// use ombra_clip::{Segment, crossing};
/// use ombra_math::glam::{DVec2, Vec2Swizzles};
///
/// let s = Segment::new(DVec2::new(0.0, 1.0), DVec2::new(3.0, 2.0));
/// assert_eq!(crossing::at_x(s, 1.0), Some(4.0 / 3.0));
/// assert_eq!(crossing::at_x(s, 4.0), None);
/// ```
///
/// # References
///
/// Grafica 3, «Clipping di un segmento»: the parametric equations, solved for one coordinate.
#[must_use]
pub fn at_x(segment: Segment, x: f64) -> Option<f64> {
    let Segment { a, b } = segment;
    let finite = segment.is_finite() && x.is_finite();
    let between = (a.x <= x && x <= b.x) || (b.x <= x && x <= a.x);
    (finite && between && a.x != b.x).then(|| cut(segment, Line::Vertical(x)).y)
}

/// The x at which a segment crosses the level line at `y`: [`at_x`] with the axes exchanged.
///
/// # Properties
///
/// - Error: none: the double nearest to the exact one, ties to even, at every exponent.
#[must_use]
pub fn at_y(segment: Segment, y: f64) -> Option<f64> {
    at_x(Segment::new(segment.a.yx(), segment.b.yx()), y)
}

/// Plain form: the formula of [`at_x`] without any rounding but the last.
///
/// ```text
/// y = (s₀ y₁ − s₁ y₀) / (s₀ − s₁)          s = Σ p q
/// ```
#[cold]
#[inline(never)]
pub(crate) fn exact(s0: &[[f64; 2]], s1: &[[f64; 2]], [y0, y1]: [f64; 2]) -> f64 {
    let (mut above, mut below) = (Sum::default(), Sum::default());
    for &[p, q] in s0 {
        above.add([p, q, y1]);
        below.add([p, q, 1.0]);
    }
    for &[p, q] in s1 {
        above.add([-p, q, y0]);
        below.add([-p, q, 1.0]);
    }
    above.quotient(&below) + 0.0
}

/// The point where a segment with ends on both sides of `line` crosses it; NaN for one that does not. Never −0.
#[inline]
pub(crate) fn cut(segment: Segment, line: Line) -> DVec2 {
    let [across, along] = line.turn(segment.a, segment.b);
    line.point(at(line.place(), across, along))
}

/// [`cut`], or `None` where that point of the line lies outside the window: decided exactly, not after rounding.
#[inline]
pub(crate) fn cut_in_window(window: &Window, segment: Segment, line: Line) -> Option<DVec2> {
    let p = cut(segment, line);
    let [_, [low, high]] = line.turn(window.min, window.max);
    let [_, [along, _]] = line.turn(p, p);
    let inside = (low < along && along < high)
        || (along == low || along == high)
            && compare(segment, line, along, low) != Ordering::Less
            && compare(segment, line, along, high) != Ordering::Greater;
    inside.then_some(p)
}

/// Whether the exact crossing with `line`, at `rounded` along it, comes before, at or after `limit`.
#[inline]
pub(crate) fn compare(segment: Segment, line: Line, rounded: f64, limit: f64) -> Ordering {
    // Rounding keeps order, so only equality needs a second look.
    match rounded.partial_cmp(&limit) {
        None | Some(Ordering::Equal) => compare_exactly(segment, line, limit),
        Some(order) => order,
    }
}

/// Whether a segment crosses `line` before, at or after `limit` along it.
#[cold]
pub(crate) fn compare_exactly(segment: Segment, line: Line, limit: f64) -> Ordering {
    let Segment { a, b } = segment;
    // Left of an upward segment is smaller x; left of one to the right is larger y.
    let turned = match line {
        Line::Vertical(_) => a.x < b.x,
        Line::Horizontal(_) => a.y > b.y,
    };
    let side = orient_2d(a, b, line.point(limit)).unwrap_or(Ordering::Equal);
    if turned { side.reverse() } else { side }
}

/// [`compare_exactly`], in doubles where their error bound allows.
#[inline]
pub(crate) fn compare_quickly(segment: Segment, line: Line, limit: f64) -> Ordering {
    // How far the crossing is beyond the limit, times the height of b above a.
    let [[a, b], [p, q]] = line.turn(segment.a, segment.b);
    let (height, left) = (b - a, (line.place() - a) * (q - p));
    let right = (limit - p) * height;
    let (difference, size) = (left - right, left.abs() + right.abs());
    // Each product has three roundings, and their difference one.
    if difference.abs() > 4.0 * f64::EPSILON * size && size > 1.0 / LARGE {
        match (difference > 0.0) == (height > 0.0) {
            true => Ordering::Greater,
            false => Ordering::Less,
        }
    } else {
        compare_exactly(segment, line, limit)
    }
}

/// Which of two lines a segment that crosses both meets first.
pub(crate) fn order(
    segment: Segment,
    first: Line,
    second: Line,
    work: &mut impl Count,
) -> Ordering {
    let (c, k) = (first.place(), second.place());
    work.add(Counter::Comparisons, 1);
    let order = if first.is_vertical() == second.is_vertical() {
        c.partial_cmp(&k).unwrap_or(Ordering::Equal)
    } else {
        work.add(Counter::Multiplications, 2);
        compare_exactly(segment, first, k)
    };
    let [[from, to], _] = second.turn(segment.a, segment.b);
    if from < to { order } else { order.reverse() }
}

#[cfg(test)]
mod tests;
