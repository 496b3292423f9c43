//! Two numbers at a time, and choices between them without branches.
//!
//! Plain code on pairs, which the compiler turns into vector instructions. A choice is a mask, all ones or all zeros:
//! written as `if`, it would become a branch, which costs more than the arithmetic where it is guessed wrong.

use ombra_math::glam::DVec2;

/// For each lane, all ones for yes, zeros for no.
pub(crate) type Mask = [u64; 2];

#[inline]
fn all_ones(yes: bool) -> u64 {
    u64::from(yes).wrapping_neg()
}

/// a < b, lane by lane; not for NaN.
#[inline]
pub(crate) fn less(a: DVec2, b: DVec2) -> Mask {
    [all_ones(a.x < b.x), all_ones(a.y < b.y)]
}

/// a ≤ b, lane by lane; not for NaN.
#[inline]
pub(crate) fn at_most(a: DVec2, b: DVec2) -> Mask {
    [all_ones(a.x <= b.x), all_ones(a.y <= b.y)]
}

/// a = b, lane by lane; not for NaN.
#[inline]
pub(crate) fn equal(a: DVec2, b: DVec2) -> Mask {
    [all_ones(a.x == b.x), all_ones(a.y == b.y)]
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

/// The first `N` bits of each number, zeros after them.
#[inline]
pub(crate) fn first_bits<const N: u32>(a: DVec2) -> DVec2 {
    let first = |x: f64| f64::from_bits(x.to_bits() & (u64::MAX << (53 - N)));
    DVec2::new(first(a.x), first(a.y))
}
