//! Where a segment crosses a line: the one place where clipping computes a point.
//!
//! Every crossing is the double nearest to the exact one. Rounding to nearest keeps order (x ≤ y gives
//! fl(x) ≤ fl(y)), and that is why clipped points lie in the window exactly, why clipping twice changes nothing,
//! why both directions of a segment give the same point, and why methods that cut in a different order agree.

use core::cmp::Ordering;

use ombra_math::double_double::{DoubleDouble, UNIT_ROUNDOFF};
use ombra_math::exact::Sum;
use ombra_math::glam::{DVec2, Vec2Swizzles};
use ombra_math::predicates::orient_2d;
use ombra_math::work::{Count, Counter};

use crate::lanes::Lanes;
use crate::segment::Segment;
use crate::window::{Line, Window};

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
/// The nearest double (ties to even) at every exponent, so the same for both directions of the segment. Where the
/// line meets an end, that end's y.
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
#[must_use]
pub fn at_y(segment: Segment, y: f64) -> Option<f64> {
    at_x(Segment::new(segment.a.yx(), segment.b.yx()), y)
}

mod entries;
mod queue;

pub(crate) use entries::two_entries;
pub(crate) use queue::{LENGTH, Queue};

/// The point where a segment with ends on both sides of `line` crosses it; NaN for one that does not. Never −0.
#[inline]
pub(crate) fn cut(segment: Segment, line: Line) -> DVec2 {
    let Segment { a, b } = segment;
    match line {
        Line::Vertical(x) => DVec2::new(x, at(x, [a.x, b.x], [a.y, b.y])),
        Line::Horizontal(y) => DVec2::new(at(y, [a.y, b.y], [a.x, b.x]), y),
    }
}

/// [`cut`], or `None` where that point of the line lies outside the window: decided exactly, not after rounding.
#[inline]
pub(crate) fn cut_in_window(window: &Window, segment: Segment, line: Line) -> Option<DVec2> {
    let p = cut(segment, line);
    let (along, low, high) = match line {
        Line::Vertical(_) => (p.y, window.min.y, window.max.y),
        Line::Horizontal(_) => (p.x, window.min.x, window.max.x),
    };
    let inside = if low < along && along < high {
        true
    } else if along == low || along == high {
        compare(segment, line, along, low) != Ordering::Less
            && compare(segment, line, along, high) != Ordering::Greater
    } else {
        false
    };
    inside.then_some(p)
}

/// Whether the exact crossing with `line`, at `rounded` along it, comes before, at or after `limit`.
#[inline]
pub(crate) fn compare(segment: Segment, line: Line, rounded: f64, limit: f64) -> Ordering {
    // Rounding keeps order, so only equality needs a second look.
    if rounded < limit {
        Ordering::Less
    } else if rounded > limit {
        Ordering::Greater
    } else {
        compare_exactly(segment, line, limit)
    }
}

/// Whether a segment crosses `line` before, at or after `limit` along it.
#[cold]
pub(crate) fn compare_exactly(segment: Segment, line: Line, limit: f64) -> Ordering {
    let Segment { a, b } = segment;
    // Left of an upward segment is smaller x; left of one to the right is larger y.
    let (corner, turned) = match line {
        Line::Vertical(x) => (DVec2::new(x, limit), a.x < b.x),
        Line::Horizontal(y) => (DVec2::new(limit, y), a.y > b.y),
    };
    match orient_2d(a, b, corner) {
        Some(side) if turned => side.reverse(),
        Some(side) => side,
        None => Ordering::Equal,
    }
}

/// [`compare_exactly`], in doubles where their error bound allows.
#[inline]
pub(crate) fn compare_quickly(segment: Segment, line: Line, limit: f64) -> Ordering {
    let Segment { a, b } = segment;
    // How far the crossing is beyond the limit, times the height of b above a.
    let (height, left, right) = match line {
        Line::Vertical(x) => (
            b.x - a.x,
            (x - a.x) * (b.y - a.y),
            (limit - a.y) * (b.x - a.x),
        ),
        Line::Horizontal(y) => (
            b.y - a.y,
            (y - a.y) * (b.x - a.x),
            (limit - a.x) * (b.y - a.y),
        ),
    };
    let (difference, size) = (left - right, left.abs() + right.abs());
    // Each product has three roundings, and their difference one.
    if difference.abs() > 4.0 * f64::EPSILON * size && size > 1.0 / LARGE {
        if (difference > 0.0) == (height > 0.0) {
            Ordering::Greater
        } else {
            Ordering::Less
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
    let Segment { a, b } = segment;
    work.add(Counter::Comparisons, 1);
    if matches!(first, Line::Vertical(_)) != matches!(second, Line::Vertical(_)) {
        work.add(Counter::Multiplications, 2);
    }
    let along = |from: f64, to: f64, o: Ordering| if from < to { o } else { o.reverse() };
    match (first, second) {
        (Line::Vertical(c), Line::Vertical(k)) => {
            along(a.x, b.x, c.partial_cmp(&k).unwrap_or(Ordering::Equal))
        }
        (Line::Horizontal(c), Line::Horizontal(k)) => {
            along(a.y, b.y, c.partial_cmp(&k).unwrap_or(Ordering::Equal))
        }
        (Line::Vertical(_), Line::Horizontal(k)) => {
            along(a.y, b.y, compare_exactly(segment, first, k))
        }
        (Line::Horizontal(_), Line::Vertical(k)) => {
            along(a.x, b.x, compare_exactly(segment, first, k))
        }
    }
}

/// y where x = `c`, on the way from (x₀, y₀) to (x₁, y₁), x₀ and x₁ on either side of c: the nearest double.
pub(crate) fn at(c: f64, x: [f64; 2], y: [f64; 2]) -> f64 {
    let splat = DVec2::splat;
    let (rounded, certain) = several_at(splat(c), x.map(splat), y.map(splat));
    if certain[0] != 0 {
        rounded.x
    } else {
        at_carefully(c, x, y)
    }
}

#[cold]
#[inline(never)]
fn at_carefully(c: f64, [x0, x1]: [f64; 2], y: [f64; 2]) -> f64 {
    let u = DoubleDouble::sum(c, -x0);
    let w = DoubleDouble::sum(x1, -x0);
    match rounded(u, w, y, SLACK) {
        Some(y) => y + 0.0, // not −0
        None => exact(&[[x0, 1.0], [-c, 1.0]], &[[x1, 1.0], [-c, 1.0]], y),
    }
}

/// Fast form: several answers of [`at`] at once, with a mask where they are certain.
///
/// With t cut to 24 bits and the differences to 29, their products fit doubles; the rest is below 2⁻²² of the whole
/// and needs no more than a double. The error is below 2⁻⁷² (|y₀| + |y₁|). If the value moved by four times that to
/// either side rounds to one double, so does the exact one.
#[inline(always)]
pub(crate) fn several_at<L: Lanes>(c: L, [x0, x1]: [L; 2], [y0, y1]: [L; 2]) -> (L, L::Mask) {
    let (u, u_rest) = difference(c, x0);
    let (w, w_rest) = difference(x1, x0);
    let (v, v_rest) = difference(y1, y0);
    let of_w = w.all(1.0) / w;
    let t = (u * of_w).first_bits::<24>();
    let (w1, v1) = (w.first_bits::<29>(), v.first_bits::<29>());
    // u − t w, of which only the first difference cancels, and that is exact.
    let rest = (u - t * w1) - t * (w - w1) + (u_rest - t * w_rest);
    let (y, y_rest) = sum(y0, t * v1);
    let small = y_rest + (t * (v - v1) + (rest * (v * of_w) + t * v_rest));
    let size = y0.abs() + y1.abs();
    let slack = size * size.all(SLACK_72);
    let (low, high) = (y + (small - slack), y + (small + slack));
    // Then nothing overflows, and no product loses digits below the smallest double.
    let in_range = L::and(
        (size + w.abs()).less(size.all(LARGE)),
        size.all(1.0 / LARGE).less(size * w.abs()),
    );
    (low, L::and(low.equal(high), in_range))
}

/// a + b, rounded, and what that leaves.
#[inline(always)]
fn sum<L: Lanes>(a: L, b: L) -> (L, L) {
    let s = a + b;
    let b_part = s - a;
    (s, (a - (s - b_part)) + (b - b_part))
}

/// a − b, rounded, and what that leaves.
#[inline(always)]
fn difference<L: Lanes>(a: L, b: L) -> (L, L) {
    let d = a - b;
    let a_part = d + b;
    (d, (a - a_part) - (b - (a_part - d)))
}

/// 2⁻⁷⁰.
const SLACK_72: f64 = f64::from_bits((1023 - 70) << 52);

/// The same between two points whose distances from the line are the sums p + q of two doubles each, one positive
/// and one negative.
#[inline]
pub(crate) fn between(s0: [f64; 2], s1: [f64; 2], y: [f64; 2]) -> f64 {
    let u = -DoubleDouble::sum(s0[0], s0[1]);
    let w = DoubleDouble::sum(s1[0], s1[1]) + u;
    match rounded(u, w, y, SLACK) {
        Some(y) => y + 0.0,
        None => exact(&s0.map(|s| [s, 1.0]), &s1.map(|s| [s, 1.0]), y),
    }
}

/// The same between two points whose distances from the line are sums of products of two doubles.
pub(crate) fn between_products(s0: &[[f64; 2]], s1: &[[f64; 2]], y: [f64; 2]) -> f64 {
    let ((d0, e0), (d1, e1)) = (sum_of(s0), sum_of(s1));
    let slack = SLACK + 8.0 * (e0 / d0.hi.abs() + e1 / d1.hi.abs());
    match rounded(-d0, d1 - d0, y, slack) {
        Some(y) => y + 0.0,
        None => exact(s0, s1, y),
    }
}

/// A sum of products with a bound of its error; the bound is infinite out of the range of [`DoubleDouble`].
fn sum_of(products: &[[f64; 2]]) -> (DoubleDouble, f64) {
    let mut value = DoubleDouble::default();
    let mut size = 0.0;
    let mut in_range = true;
    for &[x, y] in products {
        let product = DoubleDouble::product(x, y);
        value = value + product;
        size += product.hi.abs();
        in_range &= DoubleDouble::in_range(x) && DoubleDouble::in_range(y);
    }
    // Each addition errs by 3u² of at most `size`; there are at most six.
    let bound = 32.0 * UNIT_ROUNDOFF * UNIT_ROUNDOFF * size;
    (value, if in_range { bound } else { f64::INFINITY })
}

/// Plain form: the formula without any rounding but the last.
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

/// 128u²: twice the error bound of [`rounded`].
const SLACK: f64 = 128.0 * UNIT_ROUNDOFF * UNIT_ROUNDOFF;

/// Fast form: the double nearest to y₀ + u (y₁ − y₀) / w, or `None` if that is in doubt. `slack` bounds the
/// relative error of u/w besides that of this function.
///
/// With u = 2⁻⁵³ the error is below 57u² (|d| + |y₀|), d being the second term: the quotient, then its remainder to
/// first order, then the last sum. If the value moved by that to either side rounds to one double, so does the exact
/// one.
#[inline]
fn rounded(u: DoubleDouble, w: DoubleDouble, [y0, y1]: [f64; 2], slack: f64) -> Option<f64> {
    let v = DoubleDouble::sum(y1, -y0);
    let p = DoubleDouble::product(u.hi, v.hi);
    let d = p.hi / w.hi;
    let r = DoubleDouble::product(d, w.hi);
    let rest = (p.hi - r.hi) + ((p.lo - r.lo) + (u.hi * v.lo + u.lo * v.hi - d * w.lo));
    let y = DoubleDouble::sum(y0, d);
    let small = y.lo + rest / w.hi;
    let slack = slack * (d.abs() + y0.abs());
    let (low, high) = (y.hi + (small - slack), y.hi + (small + slack));
    // No product on the way overflowed, and none lost digits below the smallest double.
    let in_range = y0.abs() + y1.abs() + w.hi.abs() < LARGE && p.hi.abs() > 1.0 / LARGE;
    if low == high && in_range {
        return Some(low);
    }
    // A level segment.
    let level = y0 == y1 && y0.is_finite() && u.hi.is_finite() && w.hi.is_finite() && w.hi != 0.0;
    level.then_some(y0)
}

/// 2²⁰⁰.
pub(crate) const LARGE: f64 = f64::from_bits((1023 + 200) << 52);

#[cfg(test)]
mod tests;
