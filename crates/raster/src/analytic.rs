//! The analytic segment: y = m x + B at every column, rounded.
//!
//! The first of the lecture's three answers, and the one that says what a segment's pixels are: in every column
//! the pixel nearest to the ideal line. [`dda`](crate::dda) saves the multiplication, [`bresenham`](crate::bresenham)
//! the floating point.
//!
//! All three count x and y from the start `a`, x along the longer axis, so that 0 ≤ m ≤ 1: a pixel a column for
//! |dx| ≥ |dy|, a pixel a row otherwise. Moving a segment therefore moves its pixels and nothing else.
#![cfg_attr(doc, doc = "")]
#![cfg_attr(doc, doc = include_str!("../figures/segment-slopes.svg"))]

use core::iter::FusedIterator;
use core::ops::RangeInclusive;

use ombra_math::glam::IVec2;
use ombra_math::work::{Count, Counter};

use crate::octant::Octant;

/// [`segment`] as the lecture tells it; `plot` gets the pixels, one column after another.
///
/// # Properties
///
/// Equal to [`segment`]. Its work: a multiplication, an addition and a rounding a pixel, two divisions a segment.
///
/// # References
///
/// As [`segment`].
pub fn segment_plain(a: IVec2, b: IVec2, work: &mut impl Count, mut plot: impl FnMut(IVec2)) {
    // Turn and mirror the segment into 0 ≤ m ≤ 1. A single point has no slope; any will do for its one column.
    let octant = Octant::of(a, b);
    let (dx, dy) = (f64::from(octant.run.max(1)), f64::from(octant.rise));
    // The slope, and B with the ½ that makes the floor round to the nearest.
    let m = dy / dx;
    let intercept = 0.5 - 0.25 / dx;
    work.add(Counter::Divisions, 2);
    for x in 0..=octant.run {
        // A multiplication and an addition give the line's y at x; cut off, it is the nearest pixel's.
        let y = m * f64::from(x) + intercept;
        plot(octant.pixel(x, y as u32));
    }
    let columns = u64::from(octant.run) + 1;
    work.add(Counter::Multiplications, columns);
    work.add(Counter::Additions, columns);
    work.add(Counter::Roundings, columns);
}

/// The slide's line in its octant, and the columns still to come.
#[derive(Clone, Debug)]
pub struct Pixels<C = ()> {
    octant: Octant,
    columns: RangeInclusive<u32>,
    m: f64,
    b: f64,
    work: C,
}

impl<C: Count> Pixels<C> {
    fn of(a: IVec2, b: IVec2, mut work: C) -> Self {
        let octant = Octant::of(a, b);
        let (dx, dy) = (f64::from(octant.run.max(1)), f64::from(octant.rise));
        work.add(Counter::Divisions, 2);
        Self {
            octant,
            columns: 0..=octant.run,
            m: dy / dx,
            b: 0.5 - 0.25 / dx,
            work,
        }
    }

    /// The pixel of column `x`.
    #[inline]
    fn at(&mut self, x: u32) -> IVec2 {
        let y = self.m * f64::from(x) + self.b;
        self.work.add(Counter::Multiplications, 1);
        self.work.add(Counter::Additions, 1);
        self.work.add(Counter::Roundings, 1);
        self.octant.pixel(x, y as u32)
    }
}

/// The pixels of the segment from `a` to `b`, each by a multiplication, an addition and a rounding.
///
/// # Formula
///
/// ```text
/// m = dy / dx        y = m x + B,  rounded to the nearest integer        x = 0, 1, …, dx
///
/// ⌊m x + B⌋          with B = ½ − 1/(4dx)
/// ```
///
/// dx is the larger of |b.x − a.x| and |b.y − a.y|, dy the smaller; x and y are counted from `a`, so the line's
/// own intercept is 0. The ½ makes the floor round to the nearest. What is taken from it decides the ties:
/// m x is a multiple of 1/dx, so it lies on a tie or at least 1/(2dx) away from one, and half of that distance
/// brings the ties, and only them, to the lower side, nearer the start.
///
/// # Properties
///
/// - max(|dx|, |dy|) + 1 pixels, the first `a`, the last `b`, one a column (|m| ≤ 1) or one a row (|m| > 1).
/// - The pixels are those of [`bresenham::segment`](crate::bresenham::segment), ties included, for all segments
///   of up to 27 million moves: m, m x and the sum are each rounded once, u = 2⁻⁵³, so y is off by at most
///   u (3dy + 1), which stays below the 1/(4dx) to the next boundary while 12dx² < 2⁵³. The shortest that was found
///   to fail, among 3·10⁸ tried next to a boundary, is (0, 0)→(67111622, 67110111), at a tie.
/// - `nth` and `last` jump: a pixel needs none of those before it.
/// - From `b` to `a` the pixels are the same but for ties: see [`bresenham`](crate::bresenham#reversing).
///
/// # Pitfalls
///
/// - `f64::round` takes a tie away from zero: (0, 0)→(8, 3) has one at x = 4, y = 3/2, where the pixel nearer the
///   start is 1, not 2.
/// - Columns alone leave gaps where |m| > 1: (0, 0)→(1, 4) has two columns, but five pixels.
/// - B as an absolute ordinate loses digits far from the origin, and the pixels depend on where the segment is.
///
/// # Examples
///
/// ```
/// use ombra_math::glam::IVec2;
/// use ombra_raster::analytic;
///
/// let y: Vec<i32> = analytic::segment(IVec2::ZERO, IVec2::new(8, 3)).map(|p| p.y).collect();
/// assert_eq!(y, [0, 0, 1, 1, 1, 2, 2, 3, 3]);
/// ```
///
/// # References
///
/// Grafica 3, «Rasterizzazione di Segmenti» and «Soluzione analitica».
pub fn segment(a: IVec2, b: IVec2) -> Pixels {
    Pixels::of(a, b, ())
}

/// The same pixels, with the work of finding them in `work`: a multiplication, an addition and a rounding a pixel, two
/// divisions a segment.
pub mod counted {
    use super::{Count, IVec2, Pixels};

    /// [`segment`](super::segment), counted.
    ///
    /// # Examples
    ///
    /// ```
    /// use ombra_math::glam::IVec2;
    /// use ombra_math::work::Work;
    /// use ombra_raster::analytic::counted;
    ///
    /// let mut work = Work::default();
    /// assert_eq!(counted::segment(IVec2::ZERO, IVec2::new(8, 3), &mut work).count(), 9);
    /// assert_eq!(work.to_string(), "9 multiplications, 9 additions, 2 divisions, 9 roundings");
    /// ```
    pub fn segment<C: Count>(a: IVec2, b: IVec2, work: &mut C) -> Pixels<&mut C> {
        Pixels::of(a, b, work)
    }
}

impl<C: Count> Iterator for Pixels<C> {
    type Item = IVec2;

    #[inline]
    fn next(&mut self) -> Option<IVec2> {
        self.columns.next().map(|x| self.at(x))
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        self.columns.size_hint()
    }

    fn nth(&mut self, n: usize) -> Option<IVec2> {
        self.columns.nth(n).map(|x| self.at(x))
    }

    fn last(mut self) -> Option<IVec2> {
        self.columns.next_back().map(|x| self.at(x))
    }
}

impl<C: Count> FusedIterator for Pixels<C> {}

/// Not on 32-bit machines: the longest segments have 2³² pixels.
#[cfg(target_pointer_width = "64")]
impl<C: Count> ExactSizeIterator for Pixels<C> {}

#[cfg(test)]
mod tests {
    use ombra_math::work::Work;

    use super::*;

    #[test]
    fn the_lectures_segment() {
        let pixels = segment(IVec2::ZERO, IVec2::new(8, 3));
        let expected = [0, 0, 1, 1, 1, 2, 2, 3, 3];
        assert!(pixels.eq((0..).zip(expected).map(IVec2::from)));
    }

    #[test]
    fn a_pixel_a_row_where_the_segment_is_steep() {
        let pixels = segment(IVec2::ZERO, IVec2::new(-3, 8));
        let expected = [0, 0, -1, -1, -1, -2, -2, -3, -3];
        assert!(pixels.eq(expected.into_iter().zip(0..).map(IVec2::from)));
    }

    #[test]
    fn the_last_pixel_and_the_number_are_known_at_once() {
        let (a, b) = (IVec2::MIN, IVec2::new(i32::MAX, 5));
        let mut work = Work::default();
        assert_eq!(counted::segment(a, b, &mut work).last(), Some(b));
        assert_eq!(work.multiplications, 1);
        let mut short = segment(IVec2::ZERO, IVec2::new(8, 3));
        assert_eq!(short.nth(6), Some(IVec2::new(6, 2)));
        assert_eq!(short.size_hint(), (2, Some(2)));
        assert_eq!(short.clone().last(), Some(IVec2::new(8, 3)));
        assert_eq!(
            (short.nth(2), short.clone().next(), short.last()),
            (None, None, None)
        );
        #[cfg(target_pointer_width = "64")]
        assert_eq!(segment(a, b).len(), 1 << 32);
    }

    #[test]
    fn the_plain_form_gives_the_same_pixels_for_the_same_work() {
        for (x, y) in (-9..10).flat_map(|x| (-9..10).map(move |y| (x, y))) {
            let (a, b) = (IVec2::new(3, -4), IVec2::new(x, y));
            let (mut pixels, mut of_plain, mut work) = (vec![], Work::default(), Work::default());
            segment_plain(a, b, &mut of_plain, |p| pixels.push(p));
            assert!(counted::segment(a, b, &mut work).eq(pixels), "{b}");
            assert_eq!(of_plain, work, "{b}");
        }
    }

    #[test]
    fn work_is_a_product_and_a_sum_a_pixel() {
        let mut work = Work::default();
        for _ in counted::segment(IVec2::ZERO, IVec2::new(7, -100), &mut work) {}
        assert_eq!(
            (work.multiplications, work.additions, work.divisions),
            (101, 101, 2)
        );
        assert_eq!(work.roundings, 101);
    }
}
