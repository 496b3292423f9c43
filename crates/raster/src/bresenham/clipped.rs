//! A window of pixels, entered with the decision that the whole segment has there.

use ombra_math::glam::IVec2;
use ombra_math::work::{Count, Counter};

use super::Pixels;
use crate::octant::Octant;

/// The pixels of the segment from `a` to `b` that lie in the window from `min` to `max`, both inclusive; nothing where
/// `min` exceeds `max`.
///
/// # Formula
///
/// ```text
/// yᵢ ≥ k   ⇔   dy i > dx (k − ½)   ⇔   i > dx (2k − 1) / 2dy        first column in row k
/// yᵢ ≤ k   ⇔   dy i ≤ dx (k + ½)   ⇔   i ≤ dx (2k + 1) / 2dy        last column in row k
/// ```
///
/// in the slide's octant, counted from `a`: > and ≤ because a tie belongs to the lower row.
///
/// # Properties
///
/// - Exactly the pixels of [`segment`](super::segment) that are inside, in its order.
/// - At most three divisions, however much lies outside: one for each side that cuts rows away, one for the decision
///   at the entry. `nth` and `trace` work as on a whole segment.
/// - Any points and any window of `i32`.
///
/// # Pitfalls
///
/// Cutting the end points first draws another line. The cut point is seldom a pixel, and once it is rounded the slope
/// is no longer the segment's: (0, 0)→(8, 3) passes (2, 1); cut at x = 1 and rounded it is (1, 0)→(8, 3), which passes
/// (2, 0). A picture drawn in tiles then shows seams.
///
/// # Examples
///
/// ```
/// use ombra_math::glam::IVec2;
/// use ombra_raster::bresenham::{clipped, segment};
///
/// let (a, b) = (IVec2::ZERO, IVec2::new(8, 3));
/// let (min, max) = (IVec2::new(1, 0), IVec2::new(8, 3));
/// assert_eq!(clipped(a, b, min, max).nth(1), Some(IVec2::new(2, 1)));
/// assert_eq!(segment(min, b).nth(1), Some(IVec2::new(2, 0))); // another line
/// ```
///
/// # References
///
/// Grafica 3, «Algoritmo di Bresenham» and «Clipping di un segmento». Y. P. Kuzmin, Bresenham's line generation
/// algorithm with built-in clipping, Computer Graphics Forum 14 (1995).
#[inline]
pub fn clipped(a: IVec2, b: IVec2, min: IVec2, max: IVec2) -> Pixels {
    enter(a, b, min, max, ())
}

/// [`clipped`], counted: for the entry at most three divisions and four multiplications.
///
/// # Examples
///
/// ```
/// use ombra_math::glam::IVec2;
/// use ombra_math::work::Work;
/// use ombra_raster::bresenham::counted;
///
/// let mut work = Work::default();
/// let (a, b) = (IVec2::MIN, IVec2::new(i32::MAX, i32::MAX - 3));
/// let inside = counted::clipped(a, b, IVec2::ZERO, IVec2::splat(9), &mut work);
/// assert_eq!(inside.count(), 8); // about (0, −1.5) → (9, 7.5)
/// assert_eq!(work.divisions, 3);
/// ```
pub fn counted<C: Count>(
    a: IVec2,
    b: IVec2,
    min: IVec2,
    max: IVec2,
    work: &mut C,
) -> Pixels<&mut C> {
    enter(a, b, min, max, work)
}

#[inline]
fn enter<C: Count>(a: IVec2, b: IVec2, min: IVec2, max: IVec2, work: C) -> Pixels<C> {
    let octant = Octant::of(a, b);
    let mut pixels = Pixels::of(&octant, work);
    match columns_inside(&octant, min, max, &mut pixels.work) {
        Some((first, last)) => {
            pixels.skip_moves(first);
            pixels.left = last - first + 1;
        }
        None => pixels.left = 0,
    }
    pixels
}

/// The first and the last column of the octant whose pixel is in the window.
fn columns_inside(
    octant: &Octant,
    min: IVec2,
    max: IVec2,
    work: &mut impl Count,
) -> Option<(u64, u64)> {
    let along_x = |step: i32| from_start(octant.start.x, step, min.x, max.x);
    let along_y = |step: i32| from_start(octant.start.y, step, min.y, max.y);
    let ((left, right), (bottom, top)) = if octant.east.y == 0 {
        (along_x(octant.east.x), along_y(octant.north.y))
    } else {
        (along_y(octant.east.y), along_x(octant.north.x))
    };
    let (dx, dy) = (i64::from(octant.run), i64::from(octant.rise));
    if bottom > dy || top < 0 {
        return None;
    }
    let (mut first, mut last) = (left.max(0), right.min(dx));
    // dx (2k ± 1) needs 66 bits. Where a division is due, dy > 0, and the result lies between 0 and dx.
    let mut crossing = |twice_y: i64| {
        work.add(Counter::Multiplications, 1);
        work.add(Counter::Divisions, 1);
        (i128::from(dx) * i128::from(twice_y) / i128::from(2 * dy)) as i64
    };
    if bottom > 0 {
        first = first.max(crossing(2 * bottom - 1) + 1);
    }
    if top < dy {
        last = last.min(crossing(2 * top + 1));
    }
    // An empty window comes out as first > last, whichever way it is empty.
    (first <= last).then_some((first as u64, last as u64))
}

/// `min` to `max`, counted from `start` in the direction of `step`.
#[inline]
fn from_start(start: i32, step: i32, min: i32, max: i32) -> (i64, i64) {
    let (start, min, max) = (i64::from(start), i64::from(min), i64::from(max));
    if step > 0 {
        (min - start, max - start)
    } else {
        (start - max, start - min)
    }
}
