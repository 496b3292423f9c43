use core::cmp::Ordering;
use core::fmt;
use core::iter::Sum;
use core::ops::{Add, AddAssign, Mul, Neg, Sub, SubAssign};

use num_bigint::{BigInt, BigUint, Sign};

/// A number without rounding: a fraction, and a power of two.
///
/// # Formula
///
/// ```text
/// x = m / n · 2ᵉ        m an integer of any size, n an odd one, e an exponent
/// ```
///
/// # Properties
///
/// Every finite double is such a number with n = 1, and so is every sum, difference and product of them: as long as nothing
/// is divided, no fraction is ever reduced, and a case at 10^±300 costs microseconds. Fractions are reduced by sums and
/// products of quotients only.
///
/// # Examples
///
/// ```
/// use ombra_oracle::Exact;
///
/// let of = |x| Exact::new(x).ok_or("not finite");
/// // 0.1 + 0.2 − 0.3, as the doubles they are.
/// assert_eq!((of(0.1)? + of(0.2)? - of(0.3)?).nearest(), 2f64.powi(-55));
/// // A third, three times.
/// let third = Exact::from(1).over(&Exact::from(3)).ok_or("by 0")?;
/// assert!(third > third.nearest());
/// assert_eq!(&third + &third + &third, 1);
/// # Ok::<(), &str>(())
/// ```
#[derive(Clone, Debug, Default)]
pub struct Exact {
    integer: BigInt,
    exponent: i64,
    /// Odd and above 1; `None` is 1.
    denominator: Option<BigUint>,
}

impl Exact {
    /// 0.
    pub const ZERO: Self = Self {
        integer: BigInt::ZERO,
        exponent: 0,
        denominator: None,
    };

    /// The double `x`; `None` for NaN and ±∞.
    #[must_use]
    pub fn new(x: f64) -> Option<Self> {
        if !x.is_finite() {
            return None;
        }
        let bits = x.to_bits();
        let fraction = bits & ((1 << 52) - 1);
        // A subnormal has no hidden one and the exponent of the smallest normal.
        let (magnitude, exponent) = match (bits >> 52 & 0x7ff) as i64 {
            0 => (fraction, -1074),
            biased => (fraction | 1 << 52, biased - 1075),
        };
        if magnitude == 0 {
            return Some(Self::ZERO);
        }
        // Trailing zeros would only be carried along.
        let zeros = magnitude.trailing_zeros();
        let magnitude = BigInt::from(magnitude >> zeros);
        Some(Self {
            integer: if x < 0.0 { -magnitude } else { magnitude },
            exponent: exponent + i64::from(zeros),
            denominator: None,
        })
    }

    /// 2^`exponent`, whether or not a double holds it.
    #[must_use]
    pub fn power_of_two(exponent: i64) -> Self {
        Self::from(1).scaled(exponent)
    }

    /// x · 2^`shift`.
    #[must_use]
    pub fn scaled(&self, shift: i64) -> Self {
        Self {
            exponent: self.exponent + shift,
            ..self.clone()
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

    /// Whether x = 0.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.sign().is_eq()
    }

    /// |x|.
    #[must_use]
    pub fn abs(&self) -> Self {
        Self {
            integer: self.integer.magnitude().clone().into(),
            ..self.clone()
        }
    }

    /// x².
    #[must_use]
    pub fn squared(&self) -> Self {
        self * self
    }

    /// x / y; `None` by 0.
    #[must_use]
    pub fn over(&self, y: &Self) -> Option<Self> {
        let zeros = y.integer.trailing_zeros()?;
        let odd = y.integer.magnitude() >> zeros;
        let integer = match &y.denominator {
            Some(n) => &self.integer * BigInt::from(n.clone()),
            None => self.integer.clone(),
        };
        let negative = y.integer.sign() == Sign::Minus;
        Some(Self {
            integer: if negative { -integer } else { integer },
            exponent: self.exponent - y.exponent - i64::try_from(zeros).unwrap_or(i64::MAX),
            denominator: product(self.denominator.as_ref(), Some(odd).as_ref()),
        })
    }

    /// The double nearest to x / y; by 0 what the processor answers: ±∞ with the sign of x, and NaN for 0/0.
    #[must_use]
    pub fn ratio(&self, y: &Self) -> f64 {
        match (self.over(y), self.sign()) {
            (Some(quotient), _) => quotient.nearest(),
            (None, Ordering::Less) => f64::NEG_INFINITY,
            (None, Ordering::Equal) => f64::NAN,
            (None, Ordering::Greater) => f64::INFINITY,
        }
    }

    /// The double nearest to x, ties to even: ±∞ beyond the largest double by half its last place or more.
    #[must_use]
    pub fn nearest(&self) -> f64 {
        if self.is_zero() {
            return 0.0;
        }
        let one = BigUint::from(1_u8);
        let a = self.integer.magnitude();
        let b = self.denominator.as_ref().unwrap_or(&one);

        // Whole quotient q of 55 or 56 bits: a/b · 2ᵉ = (q + rest) · 2^last, the rest in [0, 1).
        let bits = |n: &BigUint| i64::try_from(n.bits()).unwrap_or(i64::MAX);
        let shift = 55 - (bits(a) - bits(b));
        let (a, b) = if shift >= 0 {
            (a << shift, b.clone())
        } else {
            (a.clone(), b << -shift)
        };
        let quotient = &a / &b;
        let rest = &quotient * &b != a;
        let q = u64::try_from(quotient).unwrap_or(u64::MAX);
        let last = self.exponent - shift;

        // Keep 53 bits, or as many as lie above the smallest subnormal: at least two bits fall off.
        let leading = i64::from(63 - q.leading_zeros()) + last;
        let place = (leading - 52).max(-1074);
        let dropped = u32::try_from(place - last).unwrap_or(u32::MAX);
        let kept = q.checked_shr(dropped).unwrap_or(0);
        let below = if dropped >= 64 {
            q
        } else {
            q - (kept << dropped)
        };
        let half = 1_u64.checked_shl(dropped - 1).unwrap_or(u64::MAX);
        let up = below > half || (below == half && (rest || kept % 2 == 1));

        // The bits of a double grow with its value: kept + 1 carries into the exponent by itself.
        let magnitude = if place > 971 {
            f64::INFINITY
        } else {
            let field = (place + 1074) as u64;
            f64::from_bits((field << 52) + kept + u64::from(up))
        };
        if self.sign().is_lt() {
            -magnitude
        } else {
            magnitude
        }
    }

    /// ⌊log₂ |x|⌋; `None` of 0.
    ///
    /// # Examples
    ///
    /// ```
    /// use ombra_oracle::Exact;
    ///
    /// let third = Exact::from(1).over(&Exact::from(3));
    /// assert_eq!(third.and_then(|x| x.exponent()), Some(-2));
    /// assert_eq!(Exact::power_of_two(-9999).exponent(), Some(-9999));
    /// ```
    #[must_use]
    pub fn exponent(&self) -> Option<i64> {
        if self.is_zero() {
            return None;
        }
        let Some(n) = &self.denominator else {
            return Some(self.leading_place());
        };
        // Between the two that the numbers of bits leave, |x| ≥ 2ᵉ decides.
        let bits = i64::try_from(n.bits()).unwrap_or(i64::MAX);
        let e = self.leading_place() - (bits - 1);
        let reached = self.abs() >= Self::power_of_two(e);
        Some(if reached { e } else { e - 1 })
    }

    /// The multiple of 2⁻ᵇⁱᵗˢ next to x, towards 0.
    ///
    /// For long sums of quotients, where exact ones would need a common denominator: with a few hundred bits, what is
    /// cut off is out of the sight of any double.
    #[must_use]
    pub fn truncated(&self, bits: u32) -> Self {
        let shift = self.exponent + i64::from(bits);
        let (mut m, mut n) = (
            self.integer.clone(),
            BigInt::from(self.denominator.clone().unwrap_or(1_u8.into())),
        );
        if shift >= 0 {
            m <<= shift;
        } else {
            n <<= -shift;
        }
        Self {
            integer: m / n,
            exponent: -i64::from(bits),
            denominator: None,
        }
    }

    /// x without its denominator, times `n`.
    fn times(&self, n: Option<&BigUint>) -> Self {
        let integer = match n {
            Some(n) => &self.integer * BigInt::from(n.clone()),
            None => self.integer.clone(),
        };
        Self {
            integer,
            exponent: self.exponent,
            denominator: None,
        }
    }

    /// The exponent of the leading bit, ⌊log₂ |m 2ᵉ|⌋, of m ≠ 0.
    fn leading_place(&self) -> i64 {
        i64::try_from(self.integer.bits()).unwrap_or(i64::MAX) - 1 + self.exponent
    }

    /// The fraction in its lowest terms.
    fn reduced(mut self) -> Self {
        let Some(n) = self.denominator.take() else {
            return self;
        };
        if self.is_zero() {
            return Self::ZERO;
        }
        // Euclid.
        let (mut a, mut b) = (n.clone(), self.integer.magnitude() % &n);
        while b != BigUint::ZERO {
            let rest = a % &b;
            (a, b) = (b, rest);
        }
        self.denominator = odd_above_one(n / &a);
        self.integer /= BigInt::from(a);
        self
    }

    fn sum(&self, other: &Self) -> Self {
        if self.denominator == other.denominator {
            let (low, high) = if self.exponent <= other.exponent {
                (self, other)
            } else {
                (other, self)
            };
            // 0 has no exponent.
            if high.is_zero() || low.is_zero() {
                return if low.is_zero() { high } else { low }.clone();
            }
            let sum = Self {
                integer: (&high.integer << (high.exponent - low.exponent)) + &low.integer,
                exponent: low.exponent,
                denominator: self.denominator.clone(),
            };
            return sum.reduced();
        }
        let sum = self.times(other.denominator.as_ref()) + other.times(self.denominator.as_ref());
        Self {
            denominator: product(self.denominator.as_ref(), other.denominator.as_ref()),
            ..sum
        }
        .reduced()
    }

    fn product(&self, other: &Self) -> Self {
        Self {
            integer: &self.integer * &other.integer,
            exponent: self.exponent + other.exponent,
            denominator: product(self.denominator.as_ref(), other.denominator.as_ref()),
        }
        .reduced()
    }
}

fn product(a: Option<&BigUint>, b: Option<&BigUint>) -> Option<BigUint> {
    match (a, b) {
        (Some(a), Some(b)) => odd_above_one(a * b),
        (n, None) | (None, n) => n.cloned().and_then(odd_above_one),
    }
}

fn odd_above_one(n: BigUint) -> Option<BigUint> {
    (n != BigUint::from(1_u8)).then_some(n)
}

/// The nearest double, for messages.
impl fmt::Display for Exact {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(&self.nearest(), f)
    }
}

impl From<i32> for Exact {
    fn from(x: i32) -> Self {
        Self::from(i128::from(x))
    }
}

impl From<u32> for Exact {
    fn from(x: u32) -> Self {
        Self::from(i128::from(x))
    }
}

impl From<i64> for Exact {
    fn from(x: i64) -> Self {
        Self::from(i128::from(x))
    }
}

impl From<i128> for Exact {
    fn from(x: i128) -> Self {
        Self {
            integer: x.into(),
            ..Self::ZERO
        }
    }
}

/// An operator for values and references alike, by the method that does it.
macro_rules! operator {
    ($operator:ident, $name:ident, |$x:ident, $y:ident| $body:expr) => {
        impl $operator<&Exact> for &Exact {
            type Output = Exact;

            fn $name(self, other: &Exact) -> Exact {
                let ($x, $y) = (self, other);
                $body
            }
        }

        impl $operator<Exact> for &Exact {
            type Output = Exact;

            fn $name(self, other: Exact) -> Exact {
                self.$name(&other)
            }
        }

        impl $operator<&Exact> for Exact {
            type Output = Exact;

            fn $name(self, other: &Exact) -> Exact {
                (&self).$name(other)
            }
        }

        impl $operator<Exact> for Exact {
            type Output = Exact;

            fn $name(self, other: Exact) -> Exact {
                (&self).$name(&other)
            }
        }
    };
}

operator!(Add, add, |x, y| x.sum(y));
operator!(Sub, sub, |x, y| x.sum(&-y));
operator!(Mul, mul, |x, y| x.product(y));

impl Neg for Exact {
    type Output = Self;

    fn neg(self) -> Self {
        Self {
            integer: -self.integer,
            ..self
        }
    }
}

impl Neg for &Exact {
    type Output = Exact;

    fn neg(self) -> Exact {
        -self.clone()
    }
}

impl AddAssign for Exact {
    fn add_assign(&mut self, other: Self) {
        *self = self.sum(&other);
    }
}

impl SubAssign for Exact {
    fn sub_assign(&mut self, other: Self) {
        *self = self.sum(&-other);
    }
}

impl Sum for Exact {
    fn sum<I: Iterator<Item = Self>>(terms: I) -> Self {
        terms.fold(Self::ZERO, |sum, x| sum + x)
    }
}

impl<'a> Sum<&'a Self> for Exact {
    fn sum<I: Iterator<Item = &'a Self>>(terms: I) -> Self {
        terms.fold(Self::ZERO, |sum, x| sum + x)
    }
}

impl Ord for Exact {
    fn cmp(&self, other: &Self) -> Ordering {
        let by_sign = self.sign().cmp(&other.sign());
        if by_sign.is_ne() || self.is_zero() {
            return by_sign;
        }
        // a/m and b/n, both positive or both negative: a n and b m.
        let left = self.times(other.denominator.as_ref());
        let right = other.times(self.denominator.as_ref());
        // Different leading places decide without a subtraction.
        match left.leading_place().cmp(&right.leading_place()) {
            Ordering::Equal => (left - right).sign(),
            by_size if self.sign().is_lt() => by_size.reverse(),
            by_size => by_size,
        }
    }
}

impl PartialOrd for Exact {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Exact {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Exact {}

impl PartialEq<i32> for Exact {
    fn eq(&self, other: &i32) -> bool {
        self.cmp(&Self::from(*other)).is_eq()
    }
}

impl PartialOrd<i32> for Exact {
    fn partial_cmp(&self, other: &i32) -> Option<Ordering> {
        Some(self.cmp(&Self::from(*other)))
    }
}

/// A double that is not finite equals no number.
impl PartialEq<f64> for Exact {
    fn eq(&self, other: &f64) -> bool {
        Self::new(*other).is_some_and(|x| *self == x)
    }
}

/// ±∞ lie beyond all numbers; NaN has no order.
impl PartialOrd<f64> for Exact {
    fn partial_cmp(&self, other: &f64) -> Option<Ordering> {
        match Self::new(*other) {
            Some(x) => Some(self.cmp(&x)),
            None => 0.0_f64.partial_cmp(other),
        }
    }
}

#[cfg(test)]
mod tests;
