//! Sums of products without rounding, at every exponent a double has.
//!
//! Where a sign decides (which side of a plane, lit or not), rounding must not. Each product of up to three
//! doubles is an integer times a power of two, so a fixed-point number wide enough for every such product
//! holds their sum exactly; sign, nearest double and nearest quotient are then read off it.

mod magnitude;

use core::cmp::Ordering;
use core::ops::Sub;

use glam::DVec4;

use self::magnitude::{Magnitude, round};
use crate::double_double::{DoubleDouble, UNIT_ROUNDOFF};

/// Weight of the lowest bit: the product of three smallest subnormals, 2⁻¹⁰⁷⁴ each.
const LOWEST: i32 = -3 * 1074;
/// 6294 bits reach the product of three times `f64::MAX`; the rest is head-room for sign and carries.
const LIMBS: usize = 100;

/// An exact sum of products of three doubles.
///
/// # Formula
///
/// ```text
/// S = Σ aₖ bₖ cₖ          without any rounding
/// ```
///
/// # Properties
///
/// Holds up to 2⁶⁴ products of any finite doubles: no overflow, no underflow. A factor that is NaN or infinite
/// makes the sum undefined: [`Sum::sign`] is then `None`, [`Sum::to_f64`] NaN.
///
/// # Pitfalls
///
/// 800 bytes and some 20 ns a product: decide with a rounded value and its error bound first, and come here
/// only when that leaves doubt.
///
/// # Examples
///
/// ```
/// use core::cmp::Ordering;
/// use ombra_math::exact::Sum;
///
/// let huge = 1e300;
/// let sum = Sum::of(&[[huge, huge, 1.0], [-huge, huge, 1.0], [5e-324, 5e-324, 5e-324]]);
/// assert_eq!(sum.sign(), Some(Ordering::Greater));
///
/// let third = Sum::of(&[[1.0, 1.0, 1.0]]).quotient(&Sum::of(&[[3.0, 1.0, 1.0]]));
/// assert_eq!(third, 1.0 / 3.0);
/// ```
///
/// # References
///
/// In no deck. U. Kulisch, «Computer Arithmetic and Validity», 2013: the long accumulator.
#[derive(Clone, Debug)]
pub struct Sum {
    /// Two's complement, lowest limb first.
    limbs: [u64; LIMBS],
    undefined: bool,
}

impl Default for Sum {
    fn default() -> Self {
        Self {
            limbs: [0; LIMBS],
            undefined: false,
        }
    }
}

impl Sum {
    /// The sum of the products of `terms`.
    #[must_use]
    pub fn of(terms: &[[f64; 3]]) -> Self {
        let mut sum = Self::default();
        for &term in terms {
            sum.add(term);
        }
        sum
    }

    /// (a·b) x = (a₁b₁ + a₂b₂ + a₃b₃ + a₄b₄) x.
    #[must_use]
    pub fn dot(a: DVec4, b: DVec4, x: f64) -> Self {
        Self::of(&[0, 1, 2, 3].map(|i| [a[i], b[i], x]))
    }

    /// Adds the product of three `factors`.
    pub fn add(&mut self, factors: [f64; 3]) {
        if factors.iter().any(|f| !f.is_finite()) {
            self.undefined = true;
            return;
        }
        let [(ma, ea), (mb, eb), (mc, ec)] = factors.map(integer_and_exponent);
        if ma == 0 || mb == 0 || mc == 0 {
            return;
        }
        // 53 + 53 + 53 bits, as three limbs, then shifted to their place.
        let ab = u128::from(ma) * u128::from(mb);
        let low = u128::from(ab as u64) * u128::from(mc);
        let high = (ab >> 64) * u128::from(mc) + (low >> 64);
        let place = (ea + eb + ec - LOWEST) as usize;
        let (limb, shift) = (place / 64, place % 64);
        let spread = |x: u128, k: usize| ((x << shift) >> (64 * k)) as u64;
        let top = (high >> 64) as u64;
        let words = [
            spread(u128::from(low as u64), 0),
            spread(u128::from(low as u64), 1) | spread(u128::from(high as u64), 0),
            spread(u128::from(high as u64), 1) | spread(u128::from(top), 0),
            spread(u128::from(top), 1),
        ];
        let negative = factors.iter().filter(|f| f.is_sign_negative()).count() % 2 == 1;
        let mut carry = false;
        for (i, limb) in self.limbs.iter_mut().skip(limb).enumerate() {
            let word = words.get(i).copied().unwrap_or(0);
            if i >= words.len() && !carry {
                break;
            }
            let (x, c1) = if negative {
                limb.overflowing_sub(word)
            } else {
                limb.overflowing_add(word)
            };
            let (x, c2) = if negative {
                x.overflowing_sub(u64::from(carry))
            } else {
                x.overflowing_add(u64::from(carry))
            };
            *limb = x;
            carry = c1 || c2;
        }
    }

    /// The sign of the sum, or `None` if a factor was not finite.
    #[must_use]
    pub fn sign(&self) -> Option<Ordering> {
        if self.undefined {
            None
        } else if self.is_negative() {
            Some(Ordering::Less)
        } else if self.limbs.iter().all(|&limb| limb == 0) {
            Some(Ordering::Equal)
        } else {
            Some(Ordering::Greater)
        }
    }

    /// The double nearest to the sum, ties to even; ±∞ beyond the largest double, NaN if a factor was not finite.
    ///
    /// # Properties
    ///
    /// - Error: none: the nearest double.
    #[must_use]
    pub fn to_f64(&self) -> f64 {
        if self.undefined {
            return f64::NAN;
        }
        let Some(magnitude) = Magnitude::of(self) else {
            return 0.0;
        };
        magnitude.round(self.is_negative(), magnitude.exponent)
    }

    /// The sum as f · 2ᵉ with 1 ≤ |f| < 2 or f = 0, so that sums too large or small for a double keep their digits.
    ///
    /// f is the nearest such double; NaN if a factor was not finite.
    ///
    /// # Properties
    ///
    /// - Error: none: f is the nearest double.
    #[must_use]
    pub fn to_scaled(&self) -> (f64, i32) {
        if self.undefined {
            return (f64::NAN, 0);
        }
        let Some(magnitude) = Magnitude::of(self) else {
            return (0.0, 0);
        };
        let f = magnitude.round(self.is_negative(), 0);
        // Rounding up 1.11…1 gives 2.
        if f.abs() == 2.0 {
            (f / 2.0, magnitude.exponent + 1)
        } else {
            (f, magnitude.exponent)
        }
    }

    /// The double nearest to this sum divided by `denominator`, ties to even.
    ///
    /// Zero over anything but zero is 0; a quotient beyond the largest double is ±∞; by zero, or with a factor
    /// that was not finite, it is NaN.
    ///
    /// # Properties
    ///
    /// - Error: none: the nearest double.
    #[must_use]
    pub fn quotient(&self, denominator: &Sum) -> f64 {
        if self.undefined || denominator.undefined {
            return f64::NAN;
        }
        let Some(mut divisor) = Magnitude::of(denominator) else {
            return f64::NAN;
        };
        let Some(mut rest) = Magnitude::of(self) else {
            return 0.0;
        };
        let negative = self.is_negative() != denominator.is_negative();
        let mut exponent = rest.exponent - divisor.exponent;
        let used = rest.used.max(divisor.used) + 1;
        // Both lie in [1, 2) as seen from their first bit. Halve them for a spare bit, then divide as on paper.
        rest.halve(used);
        divisor.halve(used);
        if !rest.reaches(&divisor, used) {
            rest.double(used);
            exponent -= 1;
        }
        let mut top = 0u64;
        for _ in 0..64 {
            top <<= 1;
            if rest.reaches(&divisor, used) {
                rest.subtract(&divisor, used);
                top |= 1;
            }
            rest.double(used);
        }
        let sticky = rest.limbs.iter().take(used).any(|&limb| limb != 0);
        round(negative, top, sticky, exponent)
    }

    fn is_negative(&self) -> bool {
        self.limbs.last().is_some_and(|&limb| limb >> 63 == 1)
    }
}

impl Sub for Sum {
    type Output = Self;
    /// The difference, without rounding as well.
    fn sub(mut self, other: Self) -> Self {
        self.undefined |= other.undefined;
        let mut borrow = false;
        for (limb, word) in self.limbs.iter_mut().zip(other.limbs) {
            let (x, b1) = limb.overflowing_sub(word);
            let (x, b2) = x.overflowing_sub(u64::from(borrow));
            *limb = x;
            borrow = b1 || b2;
        }
        self
    }
}

/// a·b = a₁b₁ + a₂b₂ + a₃b₃ + a₄b₄ as f · 2ᵉ, its sign exact and its relative error at most ε.
///
/// # Formula
///
/// ```text
/// π·P = a x + b y + c z + d w        (value f · 2ᵉ: a double could overflow or vanish)
/// ```
///
/// # Properties
///
/// f = 0 exactly where a·b = 0; (NaN, 0) if a coordinate is not finite. Ordinary coordinates take some 30 ns and
/// e = 0; only a value of 0, cancellation beyond 2⁻³⁸ and extreme exponents go to the exact sum.
///
/// - Error: at most ε |value|, the sign exact.
///
/// # Examples
///
/// ```
/// use ombra_math::exact::dot;
/// use ombra_math::glam::DVec4;
///
/// let (plane, point) = (DVec4::new(0.1, 0.2, -0.3, 0.0), DVec4::new(1.0, 1.0, 1.0, 1.0));
/// assert_eq!(dot(plane, point).0.signum(), 1.0); // 0.1 + 0.2 > 0.3 as doubles, by 2⁻⁵⁵ only
/// ```
#[must_use]
pub fn dot(a: DVec4, b: DVec4) -> (f64, i32) {
    let (a, b) = (a.to_array(), b.to_array());
    if a.iter().chain(&b).all(|&x| DoubleDouble::in_range(x)) {
        let (value, bound) = dot_in_double_double(a, b);
        // Rounded once more, a value with 64 right bits is within 1 ε.
        if value.hi.abs() * (UNIT_ROUNDOFF / 2048.0) > bound {
            return (value.hi, 0);
        }
    }
    Sum::dot(a.into(), b.into(), 1.0).to_scaled()
}

/// Numbers f · 2ᵉ brought to one exponent, the largest of theirs: as ratios, of [`Sum::to_scaled`] the largest between
/// 1 and 2.
///
/// # Properties
///
/// Every sign is kept: what is too small beside the largest becomes the smallest double of its sign, and only 0
/// becomes 0. NaN stays NaN. Any exponents are taken, from `i32::MIN` to `i32::MAX`.
///
/// - Error: none: exact, or below the smallest normal double the nearest, which is not 0.
///
/// # Examples
///
/// ```
/// use ombra_math::exact::relative;
///
/// assert_eq!(relative(&[(1.5, 3000), (-1.0, 2999), (0.0, 0), (1.0, -3000)]), [1.5, -0.5, 0.0, 5e-324]);
/// ```
#[must_use]
pub fn relative(scaled: &[(f64, i32)]) -> Vec<f64> {
    let exponents = scaled.iter().filter(|(f, _)| *f != 0.0).map(|&(_, e)| e);
    let top = exponents.max().unwrap_or(0);
    let one = |&(f, e): &(f64, i32)| {
        let x = libm::scalbn(f, e.saturating_sub(top));
        if x == 0.0 && f != 0.0 {
            f64::from_bits(1).copysign(f)
        } else {
            x
        }
    };
    scaled.iter().map(one).collect()
}

/// a·b for coordinates in range, with a bound of its error.
pub(crate) fn dot_in_double_double(a: [f64; 4], b: [f64; 4]) -> (DoubleDouble, f64) {
    let mut value = DoubleDouble::default();
    let mut size = 0.0;
    for (x, y) in a.into_iter().zip(b) {
        let product = DoubleDouble::product(x, y);
        value = value + product;
        size += product.hi.abs();
    }
    // Three additions, 3u² of at most `size` each; 16 leaves room for the rounding of `size`.
    (value, 16.0 * UNIT_ROUNDOFF * UNIT_ROUNDOFF * size)
}

/// |x| = m · 2ᵉ with an integer m below 2⁵³.
fn integer_and_exponent(x: f64) -> (u64, i32) {
    let bits = x.to_bits();
    let fraction = bits & ((1 << 52) - 1);
    match (bits >> 52 & 0x7ff) as i32 {
        0 => (fraction, -1074),
        biased => (fraction | 1 << 52, biased - 1075),
    }
}

#[cfg(test)]
mod tests;
