//! Bresenham's segment, also called the midpoint algorithm: integers alone, so no error to propagate.
//!
//! From each pixel there are two ways on: E, along the longer axis, and NE, along both. Which one is nearer to the
//! line is the sign of F at the midpoint between them, and F at the next midpoint is an addition away. A segment
//! in another octant is turned and mirrored into the slide's, 0 ≤ m ≤ 1, and its moves back out.
#![cfg_attr(doc, doc = "")]
#![cfg_attr(doc, doc = include_str!("../figures/bresenham-choice.svg"))]
#![cfg_attr(doc, doc = "")]
#![cfg_attr(doc, doc = include_str!("../figures/bresenham-increments.svg"))]
#![cfg_attr(doc, doc = "")]
#![cfg_attr(doc, doc = include_str!("../figures/bresenham-trace.svg"))]
//!
//! # Reversing
//!
//! A tie goes to the pixel nearer the start, so from `b` to `a` exactly the ties change their pixel, each for the
//! other one beside the line. With dx the larger of |b.x − a.x| and |b.y − a.y|, dy the smaller and g their greatest
//! common divisor, the line meets a midpoint g times if dx/g is even, else never. That is at most dx/2 times, as on
//! (0, 0)→(8, 4), and never if dx is odd.
#![doc(alias = "line drawing")]
#![doc(alias = "midpoint")]
#![doc(alias = "midpoint line algorithm")]

mod clipped;
mod draw;
mod fast;
mod trace;

use ombra_math::glam::IVec2;
use ombra_math::work::{Count, Counter};

use crate::octant::Octant;

pub use clipped::clipped;
pub use draw::draw;
pub use fast::Pixels;
pub use trace::{Choice, Step, Trace, trace};

/// [`segment`] as the lecture tells it: `plot` gets the pixels, one after another.
///
/// # Formula
///
/// As [`segment`].
///
/// # Properties
///
/// Equal to [`segment`]. Its work: an integer addition a move.
///
/// # Examples
///
/// ```
/// use ombra_math::glam::IVec2;
/// use ombra_raster::bresenham;
///
/// let mut y = Vec::new();
/// bresenham::segment_plain(IVec2::ZERO, IVec2::new(8, 3), &mut (), |p| y.push(p.y));
/// assert_eq!(y, [0, 0, 1, 1, 1, 2, 2, 3, 3]);
/// ```
///
/// # References
///
/// As [`segment`].
pub fn segment_plain(a: IVec2, b: IVec2, work: &mut impl Count, mut plot: impl FnMut(IVec2)) {
    // Turn and mirror the segment into the slide's octant, 0 ≤ dy ≤ dx; E and NE are moves of its pixels.
    let octant = Octant::of(a, b);
    let (dx, dy) = (i64::from(octant.run), i64::from(octant.rise));
    let (e, ne) = (octant.east, octant.east + octant.north);
    // d = F(M) at the first midpoint, and what each choice adds to it: all doubled, so that the ½ is an integer.
    let mut d = 2 * dy - dx;
    let (delta_e, delta_ne) = (2 * dy, 2 * (dy - dx));
    let mut p = a;
    plot(p);
    while p != b {
        // The sign of F says on which side of the line the midpoint M between E and NE lies; on it, take E.
        if d <= 0 {
            p += e;
            d += delta_e;
        } else {
            p += ne;
            d += delta_ne;
        }
        plot(p);
    }
    work.add(Counter::Additions, dx as u64);
}

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
/// - The slide's d has a ½ inside and no start value: it is kept doubled, start and both steps (errata [E15](crate#e15)).
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

/// The same pixels, with the work of finding them in `work`: an integer addition a move. A jump (`nth`, `last`) is a
/// division and two multiplications, and `count` nothing at all.
pub mod counted {
    use super::{Count, IVec2, Octant, Pixels};

    pub use super::clipped::counted as clipped;

    /// [`segment`](super::segment), counted.
    ///
    /// # Examples
    ///
    /// ```
    /// use ombra_math::glam::IVec2;
    /// use ombra_math::work::Work;
    /// use ombra_raster::bresenham::counted;
    ///
    /// let mut work = Work::default();
    /// counted::segment(IVec2::ZERO, IVec2::new(8, 3), &mut work).for_each(|_| {});
    /// assert_eq!(work.to_string(), "8 additions");
    /// ```
    pub fn segment<C: Count>(a: IVec2, b: IVec2, work: &mut C) -> Pixels<&mut C> {
        Pixels::of(&Octant::of(a, b), work)
    }
}

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
        let one_by_one = counted::segment(a, b, &mut work)
            .map(Some)
            .fold(0, |n, _| n + 1);
        assert_eq!((one_by_one, work.additions), (92, 91));
        for _ in counted::segment(a, b, &mut work) {}
        assert_eq!((work.additions, work.multiplications), (182, 0));
    }
}
