//! Numbers without rounding, for ground truth: integers times powers of two.
//!
//! Every double is one, and so is every sum, difference and product of them. A quotient is left as its two terms and
//! rounded only when it is read, after everything that cancels has cancelled ([`Exact::ratio`]).

use core::cmp::Ordering;
use core::ops::{Add, Mul, Neg, Sub};

use num_bigint::{BigInt, Sign};

/// An integer times a power of two.
///
/// # Formula
///
/// ```text
/// x = m · 2ᵉ        m an integer of any size
/// ```
///
/// # Examples
///
/// ```
/// use ombra_trade::exact::Exact;
///
/// let of = |x| Exact::of(x).ok_or("not finite");
/// // 0.1 + 0.2 − 0.3, as the doubles they are.
/// let rest = &(&of(0.1)? + &of(0.2)?) - &of(0.3)?;
/// assert_eq!(rest.ratio(&Exact::one()), 2f64.powi(-55));
/// # Ok::<(), &str>(())
/// ```
#[derive(Clone, Debug)]
pub struct Exact {
    integer: BigInt,
    exponent: i64,
}

impl Exact {
    /// The double `x`; `None` for NaN and ±∞.
    #[must_use]
    pub fn of(x: f64) -> Option<Self> {
        if !x.is_finite() {
            return None;
        }
        let bits = x.to_bits();
        let fraction = bits & ((1 << 52) - 1);
        let (integer, exponent) = match (bits >> 52 & 0x7ff) as i64 {
            0 => (fraction, -1074),
            biased => (fraction | 1 << 52, biased - 1075),
        };
        // Trailing zeros would only be carried along.
        let zeros = if integer == 0 {
            0
        } else {
            integer.trailing_zeros()
        };
        let magnitude = BigInt::from(integer >> zeros);
        Some(Self {
            integer: if x < 0.0 { -magnitude } else { magnitude },
            exponent: if integer == 0 {
                0
            } else {
                exponent + i64::from(zeros)
            },
        })
    }

    /// 0.
    #[must_use]
    pub fn zero() -> Self {
        Self {
            integer: BigInt::from(0),
            exponent: 0,
        }
    }

    /// 1.
    #[must_use]
    pub fn one() -> Self {
        Self {
            integer: BigInt::from(1),
            exponent: 0,
        }
    }

    /// The sign, as a comparison with 0.
    #[must_use]
    pub fn sign(&self) -> Ordering {
        match self.integer.sign() {
            Sign::Minus => Ordering::Less,
            Sign::NoSign => Ordering::Equal,
            Sign::Plus => Ordering::Greater,
        }
    }

    /// |x|.
    #[must_use]
    pub fn abs(&self) -> Self {
        Self {
            integer: self.integer.magnitude().clone().into(),
            exponent: self.exponent,
        }
    }

    /// x / y as a double: 0 exactly where x = 0, otherwise within ε, as long as the quotient is a normal double.
    ///
    /// Beyond the largest double it is ±∞; by 0 it is ±∞, and 0/0 NaN.
    #[must_use]
    pub fn ratio(&self, y: &Self) -> f64 {
        let negative = (self.sign() == Ordering::Less) != (y.sign() == Ordering::Less);
        let signed = |x: f64| if negative { -x } else { x };
        match (self.sign(), y.sign()) {
            (Ordering::Equal, Ordering::Equal) => return f64::NAN,
            (Ordering::Equal, _) => return 0.0,
            (_, Ordering::Equal) => return signed(f64::INFINITY),
            _ => {}
        }
        let (top, bottom) = (self.integer.magnitude(), y.integer.magnitude());
        // A quotient of 64 or 65 bits: cutting off the rest is 2⁻⁶³ of it.
        let shift = 65 + bottom.bits() as i64 - top.bits() as i64;
        let quotient = if shift >= 0 {
            (top << shift) / bottom
        } else {
            top / (bottom << -shift)
        };
        let exponent = self.exponent - y.exponent - shift;
        // At most 66 bits, so u128 holds it.
        let value = u128::try_from(quotient).unwrap_or(u128::MAX) as f64;
        signed(libm::scalbn(value, exponent.clamp(-5000, 5000) as i32))
    }

    /// x / y to a multiple of 2⁻ᵇⁱᵗˢ, the nearer one to 0; `None` by 0.
    ///
    /// For sums of quotients, where exact ones would need a common denominator: with a few hundred bits, what is
    /// cut off is out of the sight of any double.
    #[must_use]
    pub fn quotient(&self, y: &Self, bits: u32) -> Option<Self> {
        if y.sign() == Ordering::Equal {
            return None;
        }
        let shift = self.exponent - y.exponent + i64::from(bits);
        let integer = if shift >= 0 {
            (&self.integer << shift) / &y.integer
        } else {
            &self.integer / (&y.integer << -shift)
        };
        Some(Self {
            integer,
            exponent: -i64::from(bits),
        })
    }

    /// Both integers with the smaller of the two exponents.
    fn aligned(&self, other: &Self, combine: impl Fn(&BigInt, &BigInt) -> BigInt) -> Self {
        let exponent = match (self.sign(), other.sign()) {
            (Ordering::Equal, _) => other.exponent,
            (_, Ordering::Equal) => self.exponent,
            _ => self.exponent.min(other.exponent),
        };
        let shifted = |x: &Self| &x.integer << (x.exponent - exponent).max(0);
        Self {
            integer: combine(&shifted(self), &shifted(other)),
            exponent,
        }
    }
}

impl Add for &Exact {
    type Output = Exact;

    fn add(self, other: Self) -> Exact {
        self.aligned(other, |a, b| a + b)
    }
}

impl Sub for &Exact {
    type Output = Exact;

    fn sub(self, other: Self) -> Exact {
        self.aligned(other, |a, b| a - b)
    }
}

impl Mul for &Exact {
    type Output = Exact;

    fn mul(self, other: Self) -> Exact {
        Exact {
            integer: &self.integer * &other.integer,
            exponent: self.exponent + other.exponent,
        }
    }
}

impl Neg for &Exact {
    type Output = Exact;

    fn neg(self) -> Exact {
        Exact {
            integer: -&self.integer,
            exponent: self.exponent,
        }
    }
}

impl PartialEq for Exact {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Exact {}

impl PartialOrd for Exact {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Exact {
    fn cmp(&self, other: &Self) -> Ordering {
        (self - other).sign()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_rational::BigRational;
    use proptest::prelude::*;

    fn exact(x: f64) -> Exact {
        Exact::of(x).unwrap()
    }

    /// The same number as a fraction of another library.
    fn rational(x: &Exact) -> BigRational {
        let power = BigInt::from(1) << x.exponent.unsigned_abs();
        if x.exponent < 0 {
            BigRational::new(x.integer.clone(), power)
        } else {
            BigRational::from_integer(&x.integer * power)
        }
    }

    fn finite() -> impl Strategy<Value = f64> {
        prop_oneof![
            proptest::num::f64::ANY.prop_filter("finite", |x| x.is_finite()),
            -1e3..1e3f64,
            (-9i32..9).prop_map(f64::from),
        ]
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(500))]

        #[test]
        fn arithmetic_is_that_of_fractions(a in finite(), b in finite(), c in finite()) {
            let of = |x| BigRational::from_float(x).unwrap();
            let value = &(&(&exact(a) * &exact(b)) + &exact(c)) - &exact(b);
            prop_assert_eq!(rational(&value), of(a) * of(b) + of(c) - of(b));
            prop_assert_eq!(exact(a).cmp(&exact(b)), of(a).cmp(&of(b)));
        }

        #[test]
        fn ratios_are_within_epsilon(a in finite(), b in finite(), c in finite()) {
            let (x, y) = (&(&exact(a) + &exact(b)), &exact(c));
            let quotient = x.ratio(y);
            prop_assume!(quotient.is_normal());
            let truth = rational(x) / rational(y);
            let error = (BigRational::from_float(quotient).unwrap() - &truth) / truth;
            let bound = BigRational::from_float(f64::EPSILON).unwrap();
            prop_assert!(-&bound <= error && error <= bound, "{a:e} + {b:e} over {c:e}");
        }

        #[test]
        fn quotients_are_within_a_unit_towards_zero(a in finite(), b in finite(), bits in 0..300u32) {
            prop_assume!(b != 0.0);
            let found = rational(&exact(a).quotient(&exact(b), bits).unwrap());
            let truth = BigRational::from_float(a).unwrap() / BigRational::from_float(b).unwrap();
            let cut_off = &truth - &found;
            let unit = BigRational::new(BigInt::from(1), BigInt::from(1) << bits);
            prop_assert!(-&unit < cut_off && cut_off < unit, "{a:e} / {b:e}");
            let zero = BigRational::from_integer(BigInt::from(0));
            prop_assert!(cut_off == zero || (cut_off < zero) == (truth < zero));
        }

        #[test]
        fn a_double_over_one_is_itself(x in finite()) {
            prop_assert_eq!(exact(x).ratio(&Exact::one()), x);
        }
    }

    #[test]
    fn degenerate() {
        assert!(Exact::of(f64::NAN).is_none());
        assert!(Exact::of(f64::INFINITY).is_none());
        assert_eq!(exact(-0.0), Exact::zero());
        assert_eq!(exact(0.0).ratio(&exact(-3.0)), 0.0);
        assert!(exact(0.0).ratio(&exact(0.0)).is_nan());
        assert_eq!(exact(-1.0).ratio(&exact(0.0)), f64::NEG_INFINITY);
        assert_eq!(exact(f64::MAX).ratio(&exact(5e-324)), f64::INFINITY);
        assert_eq!(exact(5e-324).ratio(&exact(f64::MAX)), 0.0);
        assert_eq!(exact(5e-324).ratio(&Exact::one()), 5e-324);
        assert_eq!((-&exact(2.0)).abs(), exact(2.0));
        assert_eq!(exact(1.0).quotient(&exact(0.0), 9), None);
        assert_eq!(exact(-7.0).quotient(&exact(2.0), 0), Some(exact(-3.0)));
    }
}
