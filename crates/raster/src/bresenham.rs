//! Bresenham's segment, also called the midpoint algorithm: integers alone, so no error to propagate.
//!
//! From each pixel there are two ways on: E, along the longer axis, and NE, along both. Which one is nearer to the
//! line is the sign of F at the midpoint between them, and F at the next midpoint is an addition away. A segment
//! in another octant is turned and mirrored into the slide's, 0 ≤ m ≤ 1, and its moves back out.
#![cfg_attr(doc, doc = "")]
#![cfg_attr(doc, doc = include_str!("../figures/bresenham-trace.svg"))]
//!
//! # Reversing
//!
//! A tie goes to the pixel nearer the start, so from `b` to `a` exactly the ties change their pixel, each for the
//! other one beside the line. With dx the larger of |b.x − a.x| and |b.y − a.y|, dy the smaller and g their greatest
//! common divisor, the line meets a midpoint g times if dx/g is even, else never. That is at most dx/2 times, as on
//! (0, 0)→(8, 4), and never if dx is odd.

mod clipped;
mod draw;
mod octant;
mod trace;

use core::iter::FusedIterator;

use ombra_math::glam::IVec2;
use ombra_math::work::{Count, Counter};

pub use clipped::{clipped, clipped_counted};
pub use draw::draw;
pub(crate) use octant::Octant;
pub use trace::{Choice, Step, Trace, trace};

/// The pixels of the segment from `a` to `b`, by integers alone.
///
/// # Formula
///
/// ```text
/// F(x, y) = dy x − dx y                       0 on the line, > 0 below it, < 0 above
/// d = F(M) = F(x_P + 1, y_P + ½)              M: the midpoint between E and NE
///
/// 2d, an integer:   2dy − dx at the start
/// 2d ≤ 0:  E        2d + 2dy
/// 2d > 0:  NE       2d + 2dy − 2dx
/// ```
///
/// dx is the larger of |b.x − a.x| and |b.y − a.y|, dy the smaller; x and y are counted from `a`, where c = 0.
///
/// # Properties
///
/// - max(|dx|, |dy|) + 1 pixels, the first `a`, the last `b`, one a column (|m| ≤ 1) or one a row (|m| > 1).
/// - Each is the nearest to the line in its column or row; of two equally near ones (d = 0), the one nearer `a`.
/// - Any two points of `i32`: 2d stays between −2dx and 2dx, below 2³³.
/// - Lazy, a few words of state; `nth`, `last` and `count` jump.
///
/// # Pitfalls
///
/// - The slide's d has a ½ inside and no start value: it is kept doubled, start and both steps (errata E15).
/// - dx and dy of two `i32` need a bit more than `i32`, and doubled, two.
/// - dy − dx as the start, with steps dy and dy − dx, drops the ½: it cuts off instead of rounding, and (0, 0)→(3, 1)
///   gets y = 0 0 0 1 where 0 0 1 1 is right.
///
/// # Examples
///
/// ```
/// use ombra_math::glam::IVec2;
/// use ombra_raster::bresenham;
///
/// let y: Vec<i32> = bresenham::segment(IVec2::ZERO, IVec2::new(8, 3)).map(|p| p.y).collect();
/// assert_eq!(y, [0, 0, 1, 1, 1, 2, 2, 3, 3]);
/// ```
///
/// # References
///
/// Grafica 3, «Algoritmo di Bresenham». J. E. Bresenham, Algorithm for computer control of a digital plotter,
/// IBM Systems Journal 4 (1965).
#[inline]
pub fn segment(a: IVec2, b: IVec2) -> Pixels {
    Pixels::of(&Octant::of(a, b), ())
}

/// [`segment`], with its work in `count`: an integer addition a move. A jump (`nth`, `last`) is a division
/// and two multiplications, and `count` nothing at all.
///
/// # Examples
///
/// ```
/// use ombra_math::glam::IVec2;
/// use ombra_math::work::Work;
/// use ombra_raster::bresenham;
///
/// let mut work = Work::default();
/// bresenham::segment_counted(IVec2::ZERO, IVec2::new(8, 3), &mut work).for_each(|_| {});
/// assert_eq!(work.to_string(), "8 additions");
/// ```
pub fn segment_counted<C: Count>(a: IVec2, b: IVec2, count: &mut C) -> Pixels<&mut C> {
    Pixels::of(&Octant::of(a, b), count)
}

/// The pixels of [`segment`] or [`clipped`], one after another.
#[derive(Clone, Debug)]
pub struct Pixels<C = ()> {
    /// The next pixel.
    pixel: IVec2,
    /// −2d at the midpoint after it: a number whose sign bit says NE.
    negated: i64,
    /// 2ΔE = 2dy and 2ΔNE = 2dy − 2dx.
    after_e: i64,
    after_ne: i64,
    east: IVec2,
    north: IVec2,
    /// How many pixels are still to come.
    left: u64,
    count: C,
}

impl<C: Count> Pixels<C> {
    #[inline]
    fn of(octant: &Octant, count: C) -> Self {
        let (dx, dy) = (i64::from(octant.run), i64::from(octant.rise));
        Self {
            pixel: octant.start,
            negated: dx - 2 * dy,
            after_e: 2 * dy,
            after_ne: 2 * dy - 2 * dx,
            east: octant.east,
            north: octant.north,
            left: u64::from(octant.run) + 1,
            count,
        }
    }

    /// Only the first `pixels` of them, which are no more than there are.
    pub(crate) fn first(mut self, pixels: u64) -> Self {
        self.left = pixels;
        self
    }

    /// 2d.
    #[inline]
    fn decision(&self) -> i64 {
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
        self.count.add(Counter::Additions, 1);
    }

    /// Makes `moves` moves at once; fewer than the pixels left.
    fn skip_moves(&mut self, moves: u64) {
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
        self.count.add(Counter::Multiplications, 2);
        self.count.add(Counter::Divisions, 1);
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

#[cfg(test)]
mod tests {
    use super::*;

    fn y(a: [i32; 2], b: [i32; 2]) -> Vec<i32> {
        segment(a.into(), b.into()).map(|p| p.y).collect()
    }

    #[test]
    fn the_lectures_segment() {
        assert_eq!(y([0, 0], [8, 3]), [0, 0, 1, 1, 1, 2, 2, 3, 3]);
        let x = segment(IVec2::ZERO, IVec2::new(8, 3)).map(|p| p.x);
        assert!(x.eq(0..=8));
    }

    /// At x = 2 the line is 2/3 up, at x = 1 it is 1/3.
    #[test]
    fn the_half_is_in_the_start_value() {
        assert_eq!(y([0, 0], [3, 1]), [0, 0, 1, 1]);
    }

    #[test]
    fn work_is_an_addition_a_move() {
        let mut work = ombra_math::work::Work::default();
        let (a, b) = (IVec2::new(-5, 9), IVec2::new(7, 100));
        let one_by_one = segment_counted(a, b, &mut work)
            .map(Some)
            .fold(0, |n, _| n + 1);
        assert_eq!((one_by_one, work.additions), (92, 91));
        for _ in segment_counted(a, b, &mut work) {}
        assert_eq!((work.additions, work.multiplications), (182, 0));
    }
}
