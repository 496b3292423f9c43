//! The digital differential analyser (DDA): the analytic segment, a sum instead of a product.
//!
//! Each y comes from the one before, y + m. That saves the multiplication and lets every rounding error stay in
//! all later sums: the same segment in `f64` and in `f32` shows how far that goes.
#![cfg_attr(doc, doc = "")]
#![cfg_attr(doc, doc = include_str!("../figures/dda-rounding.svg"))]
#![doc(alias = "digital differential analyzer")]

use ombra_math::glam::IVec2;
use ombra_math::work::{Count, Counter};

use crate::octant::Octant;

/// The slide's loop, a step of it for each pixel that is asked for.
fn in_f64<C: Count>(a: IVec2, b: IVec2, mut work: C) -> impl Iterator<Item = IVec2> {
    // Turn and mirror the segment into 0 ≤ m ≤ 1. A single point has no slope; any will do for its one column.
    let octant = Octant::of(a, b);
    let (dx, dy) = (f64::from(octant.run.max(1)), f64::from(octant.rise));
    let m = dy / dx;
    let mut y = 0.5 - 0.25 / dx;
    work.add(Counter::Divisions, 2);
    (0..=octant.run).map(move |x| {
        // Cut off, y is the nearest pixel's, for the ½ in it; the next one is an addition away.
        let pixel = octant.pixel(x, y as u32);
        y += m;
        work.add(Counter::Additions, 1);
        work.add(Counter::Roundings, 1);
        pixel
    })
}

/// The same again, every number an `f32`.
fn in_f32<C: Count>(a: IVec2, b: IVec2, mut work: C) -> impl Iterator<Item = IVec2> {
    let octant = Octant::of(a, b);
    let (dx, dy) = (octant.run.max(1) as f32, octant.rise as f32);
    let m = dy / dx;
    let mut y = 0.5 - 0.25 / dx;
    work.add(Counter::Divisions, 2);
    (0..=octant.run).map(move |x| {
        let pixel = octant.pixel(x, y as u32);
        y += m;
        work.add(Counter::Additions, 1);
        work.add(Counter::Roundings, 1);
        pixel
    })
}

/// The pixels of the segment from `a` to `b`, each by an addition and a rounding, in `f64`.
///
/// # Formula
///
/// ```text
/// xᵢ₊₁ = xᵢ + 1   ⇒   yᵢ₊₁ = yᵢ + m        m = dy / dx,  y₀ = ½ − 1/(4dx),  pixel ⌊yᵢ⌋
/// ```
///
/// dx is the larger of |b.x − a.x| and |b.y − a.y|, dy the smaller; x and y are counted from `a`. The start is
/// the B of [`analytic::segment`](crate::analytic::segment): it makes the floor round to the nearest, ties to
/// the start.
///
/// # Properties
///
/// - max(|dx|, |dy|) + 1 pixels, the first `a`.
/// - The pixels are those of [`bresenham::segment`](crate::bresenham::segment), ties included, for all segments
///   of up to 165 000 moves. With u = 2⁻⁵³, m is off by at most u m and the i-th sum by another u yᵢ, together
///   at most u (dy (dx + 3) + dx + 1) / 2, which stays below the 1/(4dx) to the next boundary while
///   2dx³ (1 + 3/dx) < 2⁵³. The shortest that was found to fail, among 10⁶ random ones, is (0, 0)→(222240, 209800).
/// - The last pixel is `b` for all segments of up to 90 million moves: an integer is ½ away from the boundary.
///   Beyond, the last pixel is where the sum has drifted; a coordinate that drifts out of `i32` stays at its end.
///
/// # Pitfalls
///
/// The error grows with the square of the length, not with the length: there are more sums, and larger ones.
///
/// # Examples
///
/// ```
/// use ombra_math::glam::IVec2;
/// use ombra_raster::dda;
///
/// let y: Vec<i32> = dda::segment(IVec2::ZERO, IVec2::new(8, 3)).map(|p| p.y).collect();
/// assert_eq!(y, [0, 0, 1, 1, 1, 2, 2, 3, 3]);
/// ```
///
/// # References
///
/// Grafica 3, «Soluzione analitica».
pub fn segment(a: IVec2, b: IVec2) -> impl Iterator<Item = IVec2> {
    in_f64(a, b, ())
}

/// [`segment`] in `f32`, which is too short for it: to be looked at, not to be used.
///
/// # Properties
///
/// - The pixels are those of [`bresenham::segment`](crate::bresenham::segment), ties included, for all segments
///   of up to 298 moves, which are few enough to try each; with 299, (0, 0)→(299, 231) goes wrong at x = 288.
/// - The last pixel is `b` for all segments of up to 4000 moves.
/// - From y = 2²³ on, y + m is y or y + 1: the sum has no digits left for a fraction.
///
/// # Examples
///
/// After a million sums the segment ends beside its end:
///
/// ```
/// use ombra_math::glam::IVec2;
/// use ombra_raster::dda;
///
/// let b = IVec2::new(1_000_000, 333_333);
/// assert_eq!(dda::segment(IVec2::ZERO, b).last(), Some(b));
/// assert_ne!(dda::segment_f32(IVec2::ZERO, b).last(), Some(b));
/// ```
///
/// # References
///
/// Grafica 3, «Soluzione analitica».
pub fn segment_f32(a: IVec2, b: IVec2) -> impl Iterator<Item = IVec2> {
    in_f32(a, b, ())
}

/// The same pixels, with the work of finding them in `work`: an addition and a rounding a pixel, two divisions a segment.
pub mod counted {
    use super::{Count, IVec2, in_f32, in_f64};

    /// [`segment`](super::segment), counted.
    ///
    /// # Examples
    ///
    /// ```
    /// use ombra_math::glam::IVec2;
    /// use ombra_math::work::Work;
    /// use ombra_raster::dda::counted;
    ///
    /// let mut work = Work::default();
    /// assert_eq!(counted::segment(IVec2::ZERO, IVec2::new(8, 3), &mut work).count(), 9);
    /// assert_eq!(work.to_string(), "9 additions, 2 divisions, 9 roundings");
    /// ```
    pub fn segment<C: Count>(a: IVec2, b: IVec2, work: &mut C) -> impl Iterator<Item = IVec2> {
        in_f64(a, b, work)
    }

    /// [`segment_f32`](super::segment_f32), counted.
    pub fn segment_f32<C: Count>(a: IVec2, b: IVec2, work: &mut C) -> impl Iterator<Item = IVec2> {
        in_f32(a, b, work)
    }
}

#[cfg(test)]
mod tests {
    use ombra_math::work::Work;

    use super::*;

    #[test]
    fn the_lectures_segment() {
        let (a, b) = (IVec2::ZERO, IVec2::new(8, 3));
        let expected = (0..).zip([0, 0, 1, 1, 1, 2, 2, 3, 3]).map(IVec2::from);
        assert!(segment(a, b).eq(expected.clone()));
        assert!(segment_f32(a, b).eq(expected));
    }

    /// m = 1/10 is no double, and ten of it are not 1; the tie at 5 and the end are where they belong.
    #[test]
    fn a_tie_whose_slope_is_no_double() {
        let y = segment(IVec2::ZERO, IVec2::new(10, 1)).map(|p| p.y);
        assert!(y.eq([0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1]));
    }

    #[test]
    fn work_is_a_sum_a_pixel() {
        let (a, b) = (IVec2::ZERO, IVec2::new(7, -100));
        let (mut work, mut work_f32) = (Work::default(), Work::default());
        for _ in counted::segment(a, b, &mut work) {}
        for _ in counted::segment_f32(a, b, &mut work_f32) {}
        assert_eq!(
            (work.multiplications, work.additions, work.divisions),
            (0, 101, 2)
        );
        assert_eq!(work.roundings, 101);
        assert_eq!(work_f32, work);
    }
}
