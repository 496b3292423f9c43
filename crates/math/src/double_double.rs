//! Twice the digits of a double: an unevaluated sum of two.
//!
//! Between a rounded formula and an exact [`Sum`](crate::exact::Sum) lies this: some 20 operations instead of
//! one, 106 bits instead of 53. With its error bound it settles almost every case that needs the nearest double
//! or the right sign; what stays in doubt goes to the exact sum.

use core::ops::{Add, Mul, Neg, Sub};

/// hi + lo, with |lo| ≤ ½ ulp(hi).
///
/// # Properties
///
/// With u = 2⁻⁵³ and no overflow or underflow on the way ([`DoubleDouble::in_range`]):
///
/// ```text
/// product(a, b)    exact
/// x ± y            within 3u² (|x| + |y|)
/// x · y            within 8u² |x y|
/// x.times(a)       within 4u² |x a|
/// x.over(y)        within 16u² |x / y|
/// x.sqrt()         within 8u² √x
/// ```
///
/// # Examples
///
/// ```
/// use ombra_math::double_double::DoubleDouble;
///
/// let a = 1.0 + f64::EPSILON;
/// let square = DoubleDouble::product(a, a); // 1 + 2ε + ε²: the last term does not fit a double
/// assert_eq!((square.hi, square.lo), (1.0 + 2.0 * f64::EPSILON, f64::EPSILON * f64::EPSILON));
/// ```
///
/// # References
///
/// In no deck. T. J. Dekker, «A floating-point technique for extending the available precision», 1971;
/// M. Joldes, J.-M. Muller, V. Popescu, «Tight and rigorous error bounds for basic building blocks of
/// double-word arithmetic», 2017.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DoubleDouble {
    /// The value, rounded to a double.
    pub hi: f64,
    /// What rounding left.
    pub lo: f64,
}

/// u = 2⁻⁵³: half the distance from 1 to the next double.
pub const UNIT_ROUNDOFF: f64 = f64::EPSILON / 2.0;

impl DoubleDouble {
    /// a + b without error.
    ///
    /// # Properties
    ///
    /// - Error: none.
    #[inline]
    #[must_use]
    pub fn sum(a: f64, b: f64) -> Self {
        let hi = a + b;
        let b_part = hi - a;
        let lo = (a - (hi - b_part)) + (b - b_part);
        Self { hi, lo }
    }

    /// a · b without error.
    ///
    /// # Properties
    ///
    /// - Error: none, for factors in range.
    #[inline]
    #[must_use]
    pub fn product(a: f64, b: f64) -> Self {
        // Dekker's splitting, not `mul_add`: that is a slow library call wherever the target has no fused instruction.
        let hi = a * b;
        let ((a1, a2), (b1, b2)) = (split(a), split(b));
        let lo = ((a1 * b1 - hi) + a1 * b2 + a2 * b1) + a2 * b2;
        Self { hi, lo }
    }

    /// This value times the double `a`.
    ///
    /// # Properties
    ///
    /// - Error: at most ε² |value|.
    #[inline]
    #[must_use]
    pub fn times(self, a: f64) -> Self {
        let p = Self::product(self.hi, a);
        ordered_sum(p.hi, p.lo + self.lo * a)
    }

    /// This value divided by `divisor`.
    ///
    /// # Properties
    ///
    /// - Error: at most 4 ε² |value|.
    #[inline]
    #[must_use]
    pub fn over(self, divisor: Self) -> Self {
        let q = self.hi / divisor.hi;
        let rest = self - divisor.times(q);
        ordered_sum(q, (rest.hi + rest.lo) / divisor.hi)
    }

    /// The square root of this value, 0 where it is not positive.
    ///
    /// # Properties
    ///
    /// - Error: at most 2 ε² |value|.
    #[inline]
    #[must_use]
    pub fn sqrt(self) -> Self {
        if self.hi <= 0.0 {
            return Self::default();
        }
        let root = self.hi.sqrt();
        let rest = self - Self::product(root, root);
        ordered_sum(root, rest.hi / (2.0 * root))
    }

    /// Whether products of three such numbers, and sums of some of those, stay clear of overflow and underflow:
    /// 0, or 2⁻²⁵⁰ ≤ |x| < 2²⁵¹.
    #[inline]
    #[must_use]
    pub fn in_range(x: f64) -> bool {
        let exponent = x.to_bits() >> 52 & 0x7ff;
        x == 0.0 || (1023 - 250..=1023 + 250).contains(&exponent)
    }
}

impl Add for DoubleDouble {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        let s = Self::sum(self.hi, other.hi);
        let t = Self::sum(self.lo, other.lo);
        let s = ordered_sum(s.hi, s.lo + t.hi);
        ordered_sum(s.hi, s.lo + t.lo)
    }
}

impl Mul for DoubleDouble {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        let p = Self::product(self.hi, other.hi);
        ordered_sum(p.hi, p.lo + (self.hi * other.lo + self.lo * other.hi))
    }
}

impl Neg for DoubleDouble {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self {
            hi: -self.hi,
            lo: -self.lo,
        }
    }
}

impl Sub for DoubleDouble {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

/// a + b without error, where |a| ≥ |b|.
#[inline]
fn ordered_sum(a: f64, b: f64) -> DoubleDouble {
    let hi = a + b;
    DoubleDouble {
        hi,
        lo: b - (hi - a),
    }
}

/// a as a sum of two doubles of 26 bits.
#[inline]
fn split(a: f64) -> (f64, f64) {
    let c = 134_217_729.0 * a; // 2²⁷ + 1
    let high = c - (c - a);
    (high, a - high)
}

#[cfg(test)]
mod tests {
    use super::*;
    use ombra_oracle::Exact;
    use proptest::prelude::*;

    fn exact(x: f64) -> Exact {
        Exact::new(x).unwrap()
    }

    fn value(x: DoubleDouble) -> Exact {
        exact(x.hi) + exact(x.lo)
    }

    fn within(x: DoubleDouble, expected: &Exact, bound: f64) -> bool {
        (value(x) - expected).abs() <= bound
    }

    /// Exponents over the range, and numbers that almost cancel.
    fn operand() -> impl Strategy<Value = f64> {
        (-1.0..1.0f64, -60..60i32).prop_map(|(m, e)| libm::scalbn(m, e))
    }

    fn pair() -> impl Strategy<Value = (f64, f64)> {
        prop_oneof![
            (operand(), operand()),
            (operand(), -8i32..8).prop_map(|(a, k)| (a, -a * (1.0 + f64::from(k) * f64::EPSILON))),
        ]
    }

    proptest! {
        #[test]
        fn products_and_sums_of_doubles_are_exact((a, b) in pair()) {
            prop_assert_eq!(value(DoubleDouble::product(a, b)), exact(a) * exact(b));
            prop_assert_eq!(value(DoubleDouble::sum(a, b)), exact(a) + exact(b));
        }

        #[test]
        fn bounds_hold((a, b) in pair(), (c, d) in pair()) {
            let u2 = UNIT_ROUNDOFF * UNIT_ROUNDOFF;
            let (x, y) = (DoubleDouble::product(a, b), DoubleDouble::product(c, d));
            let (ex, ey) = (value(x), value(y));
            let scale = (x.hi.abs() + y.hi.abs()) * (1.0 + f64::EPSILON);
            prop_assert!(within(x + y, &(&ex + &ey), 3.0 * u2 * scale));
            prop_assert!(within(x - y, &(&ex - &ey), 3.0 * u2 * scale));
            prop_assert!(within(x.times(c), &(&ex * exact(c)), 4.0 * u2 * (x.hi * c).abs()));
            prop_assert!(within(x * y, &(&ex * &ey), 8.0 * u2 * (x.hi * y.hi).abs()));
            // √x by its square: twice the relative error.
            let square = if x.hi < 0.0 { -x } else { x };
            let root = value(square.sqrt());
            prop_assert!((root.squared() - value(square)).abs() <= 16.0 * u2 * square.hi);
            if y.hi != 0.0 {
                prop_assert!(within(x.over(y), &ex.over(&ey).unwrap(), 16.0 * u2 * (x.hi / y.hi).abs()));
            }
        }
    }

    #[test]
    fn the_range_is_as_said() {
        for (x, inside) in [
            (0.0, true),
            (-0.0, true),
            (1e75, true),
            (-1e-75, true),
            (libm::scalbn(1.0, 251).next_down(), true),
            (libm::scalbn(1.0, 251), false),
            (1e-76, false),
            (5e-324, false),
            (f64::NAN, false),
            (f64::INFINITY, false),
        ] {
            assert_eq!(DoubleDouble::in_range(x), inside, "{x:e}");
        }
    }
}
