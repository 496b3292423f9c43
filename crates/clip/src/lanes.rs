//! Several numbers at a time, and choices between them without branches.
//!
//! Pairs are plain code, which the compiler turns into vector instructions; four at a time are a type of their own,
//! compiled for each set of instructions. A choice is a mask, all ones or all zeros: written as `if`, it would become
//! a branch, which costs more than the arithmetic where it is guessed wrong.

use core::ops::{Add, Div, Mul, Sub};

use fearless_simd::{Bytes, Simd, SimdBase, SimdFloat, f64x4, mask64x4, u32x8};
use ombra_math::glam::DVec2;

/// Several numbers, each with the others of its lane; every operation rounds as it does for one number.
pub(crate) trait Lanes:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self>
{
    /// Yes or no for each lane.
    type Mask: Copy;
    /// `x` in each lane.
    fn all(self, x: f64) -> Self;
    fn abs(self) -> Self;
    /// The first `N` bits of each number, zeros after them; N from 21.
    fn first_bits<const N: u32>(self) -> Self;
    /// a < b; not for NaN.
    fn less(self, other: Self) -> Self::Mask;
    /// a = b; not for NaN.
    fn equal(self, other: Self) -> Self::Mask;
    fn and(a: Self::Mask, b: Self::Mask) -> Self::Mask;
}

impl Lanes for DVec2 {
    type Mask = Mask;

    #[inline(always)]
    fn all(self, x: f64) -> Self {
        Self::splat(x)
    }

    #[inline(always)]
    fn abs(self) -> Self {
        self.abs()
    }

    #[inline(always)]
    fn first_bits<const N: u32>(self) -> Self {
        let first = |x: f64| f64::from_bits(x.to_bits() & (u64::MAX << (53 - N)));
        Self::new(first(self.x), first(self.y))
    }

    #[inline(always)]
    fn less(self, other: Self) -> Mask {
        [all_ones(self.x < other.x), all_ones(self.y < other.y)]
    }

    #[inline(always)]
    fn equal(self, other: Self) -> Mask {
        [all_ones(self.x == other.x), all_ones(self.y == other.y)]
    }

    #[inline(always)]
    fn and(a: Mask, b: Mask) -> Mask {
        and(a, b)
    }
}

impl<S: Simd> Lanes for f64x4<S> {
    type Mask = mask64x4<S>;

    #[inline(always)]
    fn all(self, x: f64) -> Self {
        Self::splat(self.simd, x)
    }

    #[inline(always)]
    fn abs(self) -> Self {
        SimdFloat::abs(self)
    }

    #[inline(always)]
    fn first_bits<const N: u32>(self) -> Self {
        let low = u32::MAX << (53 - N);
        let place_of_low = usize::from(cfg!(target_endian = "big"));
        let kept = |i: usize| if i % 2 == place_of_low { low } else { u32::MAX };
        let kept = u32x8::from_fn(self.simd, kept);
        (self.bitcast::<u32x8<S>>() & kept).bitcast()
    }

    #[inline(always)]
    fn less(self, other: Self) -> Self::Mask {
        self.simd_lt(other)
    }

    #[inline(always)]
    fn equal(self, other: Self) -> Self::Mask {
        self.simd_eq(other)
    }

    #[inline(always)]
    fn and(a: Self::Mask, b: Self::Mask) -> Self::Mask {
        a & b
    }
}

/// For each lane, all ones for yes, zeros for no.
pub(crate) type Mask = [u64; 2];

#[inline]
fn all_ones(yes: bool) -> u64 {
    u64::from(yes).wrapping_neg()
}

/// a ≤ b, lane by lane; not for NaN.
#[inline]
pub(crate) fn at_most(a: DVec2, b: DVec2) -> Mask {
    [all_ones(a.x <= b.x), all_ones(a.y <= b.y)]
}

/// Where the sign bit is set.
#[inline]
pub(crate) fn negative(a: DVec2) -> Mask {
    [a.x, a.y].map(|x| (x.to_bits() as i64 >> 63) as u64)
}

/// The same mask, of which the compiler no longer knows that it is all ones or zeros: it would make branches of it.
#[inline]
pub(crate) fn opaque(a: Mask) -> Mask {
    core::hint::black_box(a)
}

#[inline]
pub(crate) fn and(a: Mask, b: Mask) -> Mask {
    [a[0] & b[0], a[1] & b[1]]
}

#[inline]
pub(crate) fn or(a: Mask, b: Mask) -> Mask {
    [a[0] | b[0], a[1] | b[1]]
}

#[inline]
pub(crate) fn not(a: Mask) -> Mask {
    [!a[0], !a[1]]
}

/// `yes` where the mask is, `no` elsewhere.
#[inline]
pub(crate) fn select(mask: Mask, yes: DVec2, no: DVec2) -> DVec2 {
    let pick = |m: u64, y: f64, n: f64| f64::from_bits((y.to_bits() & m) | (n.to_bits() & !m));
    DVec2::new(pick(mask[0], yes.x, no.x), pick(mask[1], yes.y, no.y))
}

/// (a, b), exchanged where the mask is not.
#[inline]
pub(crate) fn turn(mask: Mask, a: DVec2, b: DVec2) -> [DVec2; 2] {
    [select(mask, a, b), select(mask, b, a)]
}
