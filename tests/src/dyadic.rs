//! Exact arithmetic on the doubles: a whole number times a power of two.
//!
//! Every finite double is m · 2ᵉ, and so are sums and products of them. Keeping one exponent per number, in
//! place of a fraction reduced at every step, makes a case at 10^±300 cost microseconds.

use core::cmp::Ordering;
use core::ops::{Add, Mul, Neg, Sub};

use num_bigint::{BigInt, Sign};

/// The number `mantissa` · 2^`exponent`, exactly.
#[derive(Clone, Debug)]
pub struct Dyadic {
    mantissa: BigInt,
    exponent: i64,
}

impl Dyadic {
    /// Nothing.
    #[must_use]
    pub const fn zero() -> Self {
        Self {
            mantissa: BigInt::ZERO,
            exponent: 0,
        }
    }

    /// The double `x`, or `None` if it is not finite.
    #[must_use]
    pub fn new(x: f64) -> Option<Self> {
        if !x.is_finite() {
            return None;
        }
        let bits = x.to_bits();
        let (field, fraction) = ((bits >> 52) & 0x7ff, bits & ((1 << 52) - 1));
        // A subnormal has no hidden one and the exponent of the smallest normal.
        let (magnitude, exponent) = if field == 0 {
            (fraction, -1074)
        } else {
            (fraction | 1 << 52, i64::try_from(field).ok()? - 1075)
        };
        if magnitude == 0 {
            return Some(Self::zero());
        }
        let odd = magnitude >> magnitude.trailing_zeros();
        let mantissa = BigInt::from(odd);
        Some(Self {
            mantissa: if x < 0.0 { -mantissa } else { mantissa },
            exponent: exponent + i64::from(magnitude.trailing_zeros()),
        })
    }

    /// 2^`exponent`.
    #[must_use]
    pub fn power_of_two(exponent: i64) -> Self {
        Self {
            mantissa: BigInt::from(1),
            exponent,
        }
    }

    /// This times 2^`shift`.
    #[must_use]
    pub fn scaled(&self, shift: i64) -> Self {
        Self {
            mantissa: self.mantissa.clone(),
            exponent: self.exponent + shift,
        }
    }

    /// The sign, as the order against zero.
    #[must_use]
    pub fn sign(&self) -> Ordering {
        match self.mantissa.sign() {
            Sign::Minus => Ordering::Less,
            Sign::NoSign => Ordering::Equal,
            Sign::Plus => Ordering::Greater,
        }
    }

    /// Whether this is zero.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.sign() == Ordering::Equal
    }

    /// The absolute value.
    #[must_use]
    pub fn abs(&self) -> Self {
        Self {
            mantissa: BigInt::from(self.mantissa.magnitude().clone()),
            exponent: self.exponent,
        }
    }

    /// The order of two numbers, exactly.
    #[must_use]
    pub fn compare(&self, other: &Self) -> Ordering {
        let (sign, other_sign) = (self.sign(), other.sign());
        if sign != other_sign || sign == Ordering::Equal {
            return sign.cmp(&other_sign);
        }
        // Different leading places decide without a subtraction.
        let by_magnitude = self.leading_place().cmp(&other.leading_place());
        if by_magnitude == Ordering::Equal {
            (self - other).sign()
        } else if sign == Ordering::Less {
            by_magnitude.reverse()
        } else {
            by_magnitude
        }
    }

    /// The exponent of the leading bit: ⌊log₂ |x|⌋, for x ≠ 0.
    fn leading_place(&self) -> i64 {
        i64::try_from(self.mantissa.bits()).unwrap_or(i64::MAX) + self.exponent - 1
    }
}

/// The double nearest to `numerator` / `denominator`, ties to even: ±∞ beyond the largest double (by half its
/// last place or more), and `None` for a denominator of zero.
#[must_use]
pub fn nearest_double(numerator: &Dyadic, denominator: &Dyadic) -> Option<f64> {
    if denominator.is_zero() {
        return None;
    }
    if numerator.is_zero() {
        return Some(0.0);
    }
    let negative = numerator.sign() != denominator.sign();
    let (a, b) = (
        numerator.mantissa.magnitude(),
        denominator.mantissa.magnitude(),
    );

    // Whole quotient Q of 55 or 56 bits: a/b · 2^e = (Q + rest) · 2^last, the rest in [0, 1).
    let bits = |n: u64| i64::try_from(n).unwrap_or(i64::MAX);
    let shift = 55 - (bits(a.bits()) - bits(b.bits()));
    let (a, b) = if shift >= 0 {
        (a << shift.unsigned_abs(), b.clone())
    } else {
        (a.clone(), b << shift.unsigned_abs())
    };
    let quotient = &a / &b;
    let rest = quotient.clone() * &b != a;
    let q = u64::try_from(quotient).ok()?;
    let last = numerator.exponent - denominator.exponent - shift;

    // Keep 53 bits, or as many as lie above the smallest subnormal.
    let leading = i64::from(63 - q.leading_zeros()) + last;
    let place = (leading - 52).max(-1074);
    let dropped = u32::try_from(place - last).ok()?;
    let kept = q.checked_shr(dropped).unwrap_or(0);
    let below = if dropped >= 64 {
        q
    } else {
        q - (kept << dropped)
    };
    let half = 1_u64.checked_shl(dropped - 1).unwrap_or(u64::MAX);
    let up = below > half || (below == half && (rest || kept % 2 == 1));
    let kept = kept + u64::from(up);

    // `kept` has at most 53 bits (or is 2⁵³), so both steps are exact unless they overflow.
    let magnitude = if place > 971 {
        f64::INFINITY
    } else {
        kept as f64 * power_of_two(place)
    };
    Some(if negative { -magnitude } else { magnitude })
}

/// The double 2^`exponent`, made from its bits; the exponent is one of those that doubles have, −1074 to 1023.
#[must_use]
pub fn power_of_two(exponent: i64) -> f64 {
    f64::from_bits(if exponent >= -1022 {
        u64::try_from(exponent + 1023).unwrap_or(0) << 52
    } else {
        1_u64 << u64::try_from(exponent + 1074).unwrap_or(0)
    })
}

impl Add for &Dyadic {
    type Output = Dyadic;

    fn add(self, other: Self) -> Dyadic {
        if self.is_zero() {
            return other.clone();
        }
        if other.is_zero() {
            return self.clone();
        }
        let (low, high) = if self.exponent <= other.exponent {
            (self, other)
        } else {
            (other, self)
        };
        let shift = (high.exponent - low.exponent).unsigned_abs();
        Dyadic {
            mantissa: (&high.mantissa << shift) + &low.mantissa,
            exponent: low.exponent,
        }
    }
}

impl Neg for &Dyadic {
    type Output = Dyadic;

    fn neg(self) -> Dyadic {
        Dyadic {
            mantissa: -&self.mantissa,
            exponent: self.exponent,
        }
    }
}

impl Sub for &Dyadic {
    type Output = Dyadic;

    fn sub(self, other: Self) -> Dyadic {
        self + &-other
    }
}

impl Mul for &Dyadic {
    type Output = Dyadic;

    fn mul(self, other: Self) -> Dyadic {
        Dyadic {
            mantissa: &self.mantissa * &other.mantissa,
            exponent: self.exponent + other.exponent,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Dyadic, nearest_double};
    use core::cmp::Ordering;
    use num_bigint::BigInt;
    use num_rational::Ratio;
    use proptest::prelude::*;

    fn dyadic(x: f64) -> Dyadic {
        Dyadic::new(x).unwrap()
    }

    fn nearest(a: f64, b: f64) -> f64 {
        nearest_double(&dyadic(a), &dyadic(b)).unwrap()
    }

    #[test]
    fn not_finite_has_none() {
        for x in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert!(Dyadic::new(x).is_none());
        }
    }

    #[test]
    fn rounds_halves_to_even_at_every_size() {
        let one = dyadic(1.0);
        let tie = |even: f64| {
            // Half a last place above `even` stays, and the least bit more goes up.
            let gap = &dyadic(even.next_up()) - &dyadic(even);
            let half = &dyadic(even) + &gap.scaled(-1);
            assert_eq!(nearest_double(&half, &one), Some(even));
            let more = &half + &Dyadic::power_of_two(-5000);
            assert_eq!(nearest_double(&more, &one), Some(even.next_up()));
            let less = &half - &Dyadic::power_of_two(-5000);
            assert_eq!(nearest_double(&less, &one), Some(even));
            // From the odd neighbour above, half a place up goes on to the next even one.
            let odd = &dyadic(even.next_up()) + &gap.scaled(-1);
            assert_eq!(nearest_double(&odd, &one), Some(even.next_up().next_up()));
        };
        for even in [1.0, 3.0e300, 0.0, f64::MIN_POSITIVE, 2.0_f64.powi(-1070)] {
            let even = if even.to_bits() % 2 == 0 {
                even
            } else {
                even.next_up()
            };
            tie(even);
        }
    }

    #[test]
    fn beyond_the_largest_double() {
        let max = dyadic(f64::MAX);
        let half_place = Dyadic::power_of_two(970);
        let one = dyadic(1.0);
        let edge = &max + &half_place;
        assert_eq!(nearest_double(&edge, &one), Some(f64::INFINITY));
        assert_eq!(nearest_double(&-&edge, &one), Some(f64::NEG_INFINITY));
        let inside = &edge - &Dyadic::power_of_two(-1074);
        assert_eq!(nearest_double(&inside, &one), Some(f64::MAX));
        assert_eq!(nearest_double(&one, &Dyadic::zero()), None);
        assert_eq!(nearest(5e-324, f64::MAX), 0.0);
        assert_eq!(nearest(f64::MAX, 5e-324), f64::INFINITY);
    }

    proptest! {
        // IEEE division is the nearest double by definition: another hand's answer for every pair of doubles.
        #[test]
        fn division_agrees_with_the_processor(a in proptest::num::f64::ANY, b in proptest::num::f64::ANY) {
            prop_assume!(a.is_finite() && b.is_finite() && b != 0.0);
            prop_assert_eq!(nearest(a, b), a / b);
        }

        #[test]
        fn sums_and_products_agree_with_the_processor(a in proptest::num::f64::ANY, b in proptest::num::f64::ANY) {
            prop_assume!(a.is_finite() && b.is_finite());
            let one = dyadic(1.0);
            let (a_exact, b_exact) = (dyadic(a), dyadic(b));
            prop_assert_eq!(nearest_double(&(&a_exact + &b_exact), &one), Some(a + b));
            prop_assert_eq!(nearest_double(&(&a_exact - &b_exact), &one), Some(a - b));
            prop_assert_eq!(nearest_double(&(&a_exact * &b_exact), &one), Some(a * b));
            prop_assert_eq!(Some(a_exact.compare(&b_exact)), a.partial_cmp(&b));
        }

        // And with reduced fractions, for a polynomial whose parts cancel.
        #[test]
        fn agrees_with_reduced_fractions(x in prop::array::uniform4(-1.0e6_f64..1.0e6)) {
            let ratio = x.map(|x| Ratio::<BigInt>::from_float(x).unwrap());
            let [a, b, c, d] = x.map(dyadic);
            let exact = &(&(&a * &b) - &(&c * &d)) * &a;
            let reduced = (&ratio[0] * &ratio[1] - &ratio[2] * &ratio[3]) * &ratio[0];
            let difference = Ratio::new(
                exact.mantissa.clone() << u64::try_from(exact.exponent + 4000).unwrap(),
                BigInt::from(1) << 4000,
            ) - reduced;
            prop_assert_eq!(difference, Ratio::from_integer(BigInt::from(0)));
            prop_assert_eq!((&exact - &exact).sign(), Ordering::Equal);
        }
    }
}
