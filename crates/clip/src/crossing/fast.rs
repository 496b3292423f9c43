//! Fast form: the nearest double from twice the digits of a double, exactly only where these leave doubt.

use ombra_math::double_double::{DoubleDouble, UNIT_ROUNDOFF};
use ombra_math::glam::DVec2;

use super::exact;
use crate::lanes::Lanes;

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
pub(super) fn at_carefully(c: f64, [x0, x1]: [f64; 2], y: [f64; 2]) -> f64 {
    between([x0, -c], [x1, -c], y)
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
        Some(y) => y + 0.0, // not −0
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
