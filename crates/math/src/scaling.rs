//! Scaling by powers of two, which rounds nothing: how a formula keeps clear of overflow and underflow.
//!
//! A number is taken apart into f · 2ᵉ, the formula works on the f, and the power of two comes back at the end. All
//! digits are those of the formula as it stands; only its range grows.

use libm::{ilogb, scalbn};

/// `x` as f · 2ᵉ with 1 ≤ |f| < 2; zero, NaN and ±∞ are themselves, with e = 0.
///
/// # Properties
///
/// - Error: none: both are exact.
///
/// # Examples
///
/// ```
/// use ombra_math::scaling::split;
///
/// assert_eq!(split(-12.0), (-1.5, 3));
/// assert_eq!(split(5e-324), (1.0, -1074));
/// ```
#[must_use]
pub fn split(x: f64) -> (f64, i32) {
    let ([f], exponent) = normalised([x]);
    (f, exponent)
}

/// Each of `x` times 2ᵉ.
///
/// # Properties
///
/// - Error: none: exact, or the nearest subnormal; ±∞ beyond the largest double.
#[must_use]
pub fn scaled<const N: usize>(x: [f64; N], exponent: i32) -> [f64; N] {
    x.map(|x| scalbn(x, exponent))
}

/// The numbers `x` as f · 2ᵉ, the largest |f| between 1 and 2; e = 0 where none but zeros, NaN and ±∞ are there.
///
/// # Properties
///
/// - Error: none: exact, or for what is 10³⁰⁰ times smaller than the largest the nearest subnormal.
///
/// # Examples
///
/// ```
/// use ombra_math::scaling::normalised;
///
/// assert_eq!(normalised([12.0, -3.0]), ([1.5, -0.375], 3));
/// ```
#[must_use]
pub fn normalised<const N: usize>(x: [f64; N]) -> ([f64; N], i32) {
    let sizes = x.iter().map(|x| x.abs()).filter(|x| x.is_finite());
    let largest = sizes.fold(0.0, f64::max);
    let exponent = if largest > 0.0 { ilogb(largest) } else { 0 };
    (scaled(x, -exponent), exponent)
}

/// Numbers x · 2ᵉ of one exponent each, brought to one for all: f · 2ᵉ, the largest |f| between 1 and 2.
///
/// # Properties
///
/// - Error: none: exact, or for what is 10³⁰⁰ times smaller than the largest the nearest subnormal.
///
/// # Examples
///
/// ```
/// use ombra_math::scaling::common;
///
/// assert_eq!(common([(1.0, 5000), (12.0, 4999), (0.0, 0)]), ([0.25, 1.5, 0.0], 5002));
/// ```
#[must_use]
pub fn common<const N: usize>(x: [(f64, i32); N]) -> ([f64; N], i32) {
    let exponent = x
        .iter()
        .filter(|(x, _)| *x != 0.0 && x.is_finite())
        .map(|&(x, e)| ilogb(x).saturating_add(e))
        .max()
        .unwrap_or(0);
    let f = x.map(|(x, e)| scalbn(x, e.saturating_sub(exponent)));
    (f, exponent)
}

/// The product of `factors`, from left to right, divided by `divisor`: no intermediate overflows or vanishes.
///
/// # Formula
///
/// ```text
/// x₁ x₂ … xₙ / y
/// ```
///
/// # Properties
///
/// A factor of 0, NaN or ±∞, or such a divisor, counts as in plain arithmetic. Up to 500 factors.
///
/// - Error: at most ½ (n + 1) ε |value|; subnormal values half the smallest double more.
///
/// # Examples
///
/// ```
/// use ombra_math::scaling::product_over;
///
/// assert_eq!(product_over([1e200, 1e200], 4e200), 2.5e199);
/// ```
#[must_use]
pub fn product_over<const N: usize>(factors: [f64; N], divisor: f64) -> f64 {
    let (divisor, down) = split(divisor);
    let (mut product, mut up) = (1.0, 0i32);
    for (f, e) in factors.map(split) {
        product *= f;
        up = up.saturating_add(e);
    }
    scalbn(product / divisor, up.saturating_sub(down))
}

#[cfg(test)]
mod tests {
    use super::*;
    use ombra_oracle::Exact;
    use proptest::prelude::*;

    fn exact(x: f64) -> Exact {
        Exact::new(x).unwrap()
    }

    fn number() -> impl Strategy<Value = f64> {
        prop_oneof![
            9 => (-2.0..2.0f64, -1074..1023i32).prop_map(|(m, e)| scalbn(m, e)),
            1 => Just(0.0),
        ]
    }

    #[test]
    fn what_has_no_size_stays() {
        for x in [0.0, -0.0, f64::INFINITY, f64::NEG_INFINITY, f64::NAN] {
            let (f, e) = split(x);
            assert_eq!((f.to_bits(), e), (x.to_bits(), 0));
        }
        assert_eq!(normalised([f64::INFINITY, 8.0]), ([f64::INFINITY, 1.0], 3));
        assert_eq!(common::<0>([]), ([], 0));
        assert_eq!(product_over([1e300, 0.0, 1e300], 1e-300), 0.0);
        assert!(product_over([0.0], 0.0).is_nan());
        assert_eq!(product_over([-1.0], 0.0), f64::NEG_INFINITY);
        assert_eq!(product_over([1.0, 2.0], f64::INFINITY), 0.0);
    }

    #[test]
    fn exponents_at_the_ends() {
        let (top, least) = (i32::MAX, i32::MIN);
        assert_eq!(common([(1.0, top), (1.0, least)]), ([1.0, 0.0], top));
        assert_eq!(common([(1.0, top), (2.0, top)]), ([1.0, 2.0], top));
        assert_eq!(common([(0.0, top), (1.0, least)]), ([0.0, 1.0], least));
        assert_eq!(common([(5e-324, least)]).1, least);
    }

    proptest! {
        #[test]
        fn nothing_is_rounded(x in [number(), number(), number()]) {
            let (f, e) = normalised(x);
            let largest = f.iter().fold(0.0f64, |m, f| m.max(f.abs()));
            prop_assert!(largest == 0.0 || (1.0..2.0).contains(&largest));
            for (f, x) in f.into_iter().zip(x) {
                // What is lost is beyond the last place of the smallest double.
                prop_assert!(exact(f).scaled(e.into()) == x || f.abs() < 1e-300);
            }
            for x in x {
                let (f, e) = split(x);
                prop_assert_eq!(exact(f).scaled(e.into()), x);
            }
        }

        /// n products and a quotient, each rounded once.
        #[test]
        fn products_are_right_whatever_is_on_the_way(x in [number(), number(), number()], y in number()) {
            prop_assume!(y != 0.0);
            let found = product_over(x, y);
            let right = (exact(x[0]) * exact(x[1]) * exact(x[2])).over(&exact(y)).unwrap();
            if right.abs() > f64::MAX {
                prop_assert!(found.abs() == f64::INFINITY || found.abs() == f64::MAX);
            } else {
                let bound = right.abs() * exact(2.0 * f64::EPSILON) + Exact::power_of_two(-1075);
                prop_assert!((exact(found) - right).abs() <= bound, "{:e}", found);
            }
        }
    }
}
