//! An exact sum without its sign, as rounding and division need it.

use super::{LIMBS, LOWEST, Sum};

/// |S| from its first bit on: highest limb *first*, the first bit set.
pub(super) struct Magnitude {
    pub(super) limbs: [u64; LIMBS + 1],
    /// Limbs from the first to the last that is not zero.
    pub(super) used: usize,
    /// Weight of the first bit, as a power of two.
    pub(super) exponent: i32,
}

impl Magnitude {
    /// `None` for zero.
    pub(super) fn of(sum: &Sum) -> Option<Self> {
        let mut absolute = sum.limbs;
        if sum.is_negative() {
            let mut carry = true;
            for limb in &mut absolute {
                let (x, c) = (!*limb).overflowing_add(u64::from(carry));
                *limb = x;
                carry = c;
            }
        }
        let highest = absolute.iter().rposition(|&limb| limb != 0)?;
        let lowest = absolute.iter().position(|&limb| limb != 0)?;
        let shift = absolute.get(highest)?.leading_zeros();
        let used = highest - lowest + 1;
        let mut limbs = [0; LIMBS + 1];
        let pairs = absolute[..=highest]
            .iter()
            .rev()
            .zip(absolute[..highest].iter().rev().chain([&0]));
        for (to, (&limb, &next)) in limbs.iter_mut().zip(pairs).take(used) {
            *to = (((u128::from(limb) << 64 | u128::from(next)) << shift) >> 64) as u64;
        }
        let exponent = LOWEST + 64 * highest as i32 + 63 - shift as i32;
        Some(Self {
            limbs,
            used,
            exponent,
        })
    }

    /// The value with its first bit's weight put at 2^`exponent`, rounded to the nearest double.
    pub(super) fn round(&self, negative: bool, exponent: i32) -> f64 {
        let sticky = self.limbs.iter().skip(1).any(|&limb| limb != 0);
        round(negative, self.limbs[0], sticky, exponent)
    }

    pub(super) fn halve(&mut self, used: usize) {
        let mut carry = 0;
        for limb in self.limbs.iter_mut().take(used) {
            (*limb, carry) = (carry << 63 | *limb >> 1, *limb & 1);
        }
    }

    pub(super) fn double(&mut self, used: usize) {
        let mut carry = 0;
        for limb in self.limbs.iter_mut().take(used).rev() {
            (*limb, carry) = (*limb << 1 | carry, *limb >> 63);
        }
    }

    pub(super) fn reaches(&self, other: &Self, used: usize) -> bool {
        self.limbs
            .iter()
            .take(used)
            .ge(other.limbs.iter().take(used))
    }

    pub(super) fn subtract(&mut self, other: &Self, used: usize) {
        let mut borrow = false;
        for (limb, &word) in self.limbs.iter_mut().zip(&other.limbs).take(used).rev() {
            let (x, b1) = limb.overflowing_sub(word);
            let (x, b2) = x.overflowing_sub(u64::from(borrow));
            *limb = x;
            borrow = b1 || b2;
        }
    }
}

/// Nearest double, ties to even, of a number whose first 64 bits are `top` (first bit set, of weight
/// 2^`exponent`) and which goes on below them if `sticky`.
pub(super) fn round(negative: bool, top: u64, sticky: bool, exponent: i32) -> f64 {
    let sign = if negative { -1.0 } else { 1.0 };
    // A subnormal keeps fewer bits.
    let kept = 53 - (-1022 - exponent).max(0);
    if exponent > 1023 {
        return sign * f64::INFINITY;
    }
    if kept < 0 {
        return sign * 0.0;
    }
    let dropped = 64 - kept;
    let half = 1u128 << (dropped - 1);
    let (mut integer, rest) = (u128::from(top) >> dropped, u128::from(top) & (2 * half - 1));
    if rest > half || (rest == half && (sticky || integer & 1 == 1)) {
        integer += 1;
    }
    sign * libm::scalbn(integer as f64, exponent - 63 + dropped)
}
