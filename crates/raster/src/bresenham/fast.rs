//! The iterator of a segment's pixels: no jump in a move, and any number of moves at once.

use core::iter::FusedIterator;

use ombra_math::glam::IVec2;
use ombra_math::work::{Count, Counter};

use crate::octant::Octant;

/// The pixels of [`segment`](super::segment) or [`clipped`](super::clipped()), one after another.
#[derive(Clone, Debug)]
pub struct Pixels<C = ()> {
    /// The next pixel.
    pub(super) pixel: IVec2,
    /// −2d at the midpoint after it: a number whose sign bit says NE.
    negated: i64,
    /// 2ΔE = 2dy and 2ΔNE = 2dy − 2dx.
    pub(super) after_e: i64,
    pub(super) after_ne: i64,
    pub(super) east: IVec2,
    pub(super) north: IVec2,
    /// How many pixels are still to come.
    pub(super) left: u64,
    pub(super) work: C,
}

impl<C: Count> Pixels<C> {
    #[inline]
    pub(super) fn of(octant: &Octant, work: C) -> Self {
        let (dx, dy) = (i64::from(octant.run), i64::from(octant.rise));
        Self {
            pixel: octant.start,
            negated: dx - 2 * dy,
            after_e: 2 * dy,
            after_ne: 2 * dy - 2 * dx,
            east: octant.east,
            north: octant.north,
            left: u64::from(octant.run) + 1,
            work,
        }
    }

    /// All but the last `pixels` of them.
    pub(crate) fn but_last(mut self, pixels: u64) -> Self {
        self.left = self.left.saturating_sub(pixels);
        self
    }

    /// 2d.
    #[inline]
    pub(super) fn decision(&self) -> i64 {
        -self.negated
    }

    /// Takes the decision at the midpoint and makes the move.
    #[inline(always)]
    fn step(&mut self) {
        // The sign, spread over all bits, selects what NE adds to E: a jump would be guessed wrong too often.
        let north = self.negated >> 63;
        let (e, n) = (self.east, self.north);
        self.negated += ((self.after_e - self.after_ne) & north) - self.after_e;
        // No overflow: while a pixel is left, the move ends on a pixel of the segment.
        self.pixel.x = self.pixel.x.wrapping_add(e.x + (n.x & north as i32));
        self.pixel.y = self.pixel.y.wrapping_add(e.y + (n.y & north as i32));
        self.work.add(Counter::Additions, 1);
    }

    /// Makes `moves` moves at once; fewer than the pixels left.
    pub(super) fn skip_moves(&mut self, moves: u64) {
        if moves == 0 {
            return;
        }
        // After k moves of which s went NE, 2d = D + 2dy k − 2dx s. Every decision lies in (2dy − 2dx, 2dy], an
        // interval as long as one NE takes away, so s is the only integer that brings it there.
        let dy2 = i128::from(self.after_e);
        let dx2 = i128::from(self.after_e - self.after_ne);
        let all_e = i128::from(self.decision()) + dy2 * i128::from(moves);
        let north = (all_e - dy2 + dx2 - 1).div_euclid(dx2);
        self.negated = (dx2 * north - all_e) as i64;
        // Both counts are below 2³², and positions are exact modulo 2³².
        let (e, n) = (IVec2::splat(moves as i32), IVec2::splat(north as i32));
        self.pixel = (self.pixel)
            .wrapping_add(self.east.wrapping_mul(e))
            .wrapping_add(self.north.wrapping_mul(n));
        self.left -= moves;
        self.work.add(Counter::Multiplications, 2);
        self.work.add(Counter::Divisions, 1);
    }
}

impl<C: Count> Iterator for Pixels<C> {
    type Item = IVec2;

    #[inline]
    fn next(&mut self) -> Option<IVec2> {
        let left = self.left.checked_sub(1)?;
        let pixel = self.pixel;
        self.left = left;
        if left > 0 {
            self.step();
        }
        Some(pixel)
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        usize::try_from(self.left).map_or((usize::MAX, None), |n| (n, Some(n)))
    }

    fn nth(&mut self, n: usize) -> Option<IVec2> {
        let n = n as u64;
        if n >= self.left {
            self.left = 0;
            return None;
        }
        self.skip_moves(n);
        self.next()
    }

    fn last(mut self) -> Option<IVec2> {
        self.skip_moves(self.left.saturating_sub(1));
        self.next()
    }

    fn count(self) -> usize {
        usize::try_from(self.left).unwrap_or(usize::MAX)
    }

    #[inline]
    fn fold<B, F: FnMut(B, IVec2) -> B>(mut self, init: B, mut f: F) -> B {
        let mut all = init;
        if self.left > 0 {
            for _ in 1..self.left {
                all = f(all, self.pixel);
                self.step();
            }
            all = f(all, self.pixel);
        }
        all
    }
}

impl<C: Count> FusedIterator for Pixels<C> {}

/// Not on 32-bit machines: the longest segments have 2³² pixels.
#[cfg(target_pointer_width = "64")]
impl<C: Count> ExactSizeIterator for Pixels<C> {}
