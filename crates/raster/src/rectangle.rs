//! A rectangle with sides along the axes: its outline, four segments; its inside, a double loop.
#![cfg_attr(doc, doc = "")]
#![cfg_attr(doc, doc = include_str!("../figures/rectangle.svg"))]
//!
//! # A pixel is a sample
//!
//! `min` and `max` are pixels of the rectangle, both. A pixel is a coordinate at which the picture is sampled; it has
//! no shape and no area. So one counts positions, not lengths: from column 2 to column 6 there are 5, though
//! 6 − 2 = 4, and the rectangle from a pixel to itself, which has no area, is that one pixel.

use core::iter::FusedIterator;

use ombra_math::glam::IVec2;

use crate::bresenham;

/// The pixels on the sides of the rectangle from `min` to `max`, each once; nothing where `min` exceeds `max`.
///
/// # Formula
///
/// ```text
/// (x₀, y₀) → (x₁, y₀) → (x₁, y₁) → (x₀, y₁) → (x₀, y₀)        four segments
/// ```
///
/// # Properties
///
/// - 2(w + h) − 4 pixels for w columns and h rows, w and h at least 2; w h when one of them is 1.
/// - The order is that of the formula, from `min` on and round.
///
/// # Pitfalls
///
/// Four whole segments draw each corner twice. That shows as soon as a pixel is not simply set, but blended or
/// inverted; so each segment leaves its last pixel to the next.
///
/// # Examples
///
/// ```
/// use ombra_math::glam::IVec2;
/// use ombra_raster::rectangle;
///
/// assert_eq!(rectangle::outline(IVec2::new(2, 1), IVec2::new(6, 4)).count(), 14);
/// ```
///
/// # References
///
/// Grafica 3, «Rasterizzazione di Poligoni».
pub fn outline(min: IVec2, max: IVec2) -> impl Iterator<Item = IVec2> + Clone {
    let (right, left) = (IVec2::new(max.x, min.y), IVec2::new(min.x, max.y));
    let empty = min.x > max.x || min.y > max.y;
    let line = min.x == max.x || min.y == max.y;
    // A rectangle of one row or one column is one segment, with both its ends.
    let sides = if empty {
        [(0, min, min); 4]
    } else if line {
        [(1, min, max), (0, max, max), (0, max, max), (0, max, max)]
    } else {
        [
            (0, min, right),
            (0, right, max),
            (0, max, left),
            (0, left, min),
        ]
    };
    let [top, east, bottom, west] = sides.map(|(ends, from, to)| {
        let moves = from.x.abs_diff(to.x).max(from.y.abs_diff(to.y));
        bresenham::segment(from, to).first(u64::from(moves) + ends)
    });
    top.chain(east).chain(bottom).chain(west)
}

/// The pixels of the rectangle from `min` to `max`, row after row; nothing where `min` exceeds `max`.
///
/// # Formula
///
/// ```text
/// for y in y₀ … y₁
///     for x in x₀ … x₁
///         light (x, y)
/// ```
///
/// # Properties
///
/// - w h pixels for w columns and h rows, each once.
/// - Lazy, a few words of state; `nth`, `last` and `count` jump.
/// - All of `i32` × `i32` would be 2⁶⁴ pixels, one more than a `usize` holds: `size_hint` then has no upper bound,
///   `count` stops at `usize::MAX`, and the length is not exact for every rectangle.
///
/// # Pitfalls
///
/// A loop to `x < max.x` forgets the last column: both ends belong to the rectangle.
///
/// # Examples
///
/// ```
/// use ombra_math::glam::IVec2;
/// use ombra_raster::rectangle;
///
/// assert_eq!(rectangle::fill(IVec2::new(2, 1), IVec2::new(6, 4)).count(), 20);
/// assert_eq!(rectangle::fill(IVec2::ZERO, IVec2::ZERO).count(), 1);
/// ```
///
/// # References
///
/// Grafica 3, «Rasterizzazione di Poligoni».
pub fn fill(min: IVec2, max: IVec2) -> Fill {
    let empty = min.x > max.x || min.y > max.y;
    Fill {
        next: (!empty).then_some(min),
        start: min.x,
        max,
    }
}

/// The pixels of [`fill`].
#[derive(Clone, Debug)]
pub struct Fill {
    next: Option<IVec2>,
    /// The first column.
    start: i32,
    max: IVec2,
}

impl Fill {
    /// How many pixels are still to come.
    fn left(&self) -> u128 {
        self.next.map_or(0, |pixel| {
            let columns = u128::from(self.start.abs_diff(self.max.x)) + 1;
            let rows_below = u128::from(pixel.y.abs_diff(self.max.y));
            rows_below * columns + u128::from(pixel.x.abs_diff(self.max.x)) + 1
        })
    }
}

impl Iterator for Fill {
    type Item = IVec2;

    #[inline]
    fn next(&mut self) -> Option<IVec2> {
        let pixel = self.next?;
        self.next = if pixel.x < self.max.x {
            Some(IVec2::new(pixel.x + 1, pixel.y))
        } else if pixel.y < self.max.y {
            Some(IVec2::new(self.start, pixel.y + 1))
        } else {
            None
        };
        Some(pixel)
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        usize::try_from(self.left()).map_or((usize::MAX, None), |n| (n, Some(n)))
    }

    fn nth(&mut self, n: usize) -> Option<IVec2> {
        let from = self.next.take()?;
        // Columns are counted from the left side: n pixels on, whole rows and what is over.
        let columns = u64::from(self.start.abs_diff(self.max.x)) + 1;
        let (mut rows, mut column) = (n as u64 / columns, n as u64 % columns);
        column += u64::from(self.start.abs_diff(from.x));
        if column >= columns {
            column -= columns;
            rows += 1;
        }
        if rows > u64::from(from.y.abs_diff(self.max.y)) {
            return None;
        }
        // Both are below 2³² and lead to a pixel of the rectangle.
        self.next = Some(IVec2::new(
            self.start.wrapping_add_unsigned(column as u32),
            from.y.wrapping_add_unsigned(rows as u32),
        ));
        self.next()
    }

    fn last(self) -> Option<IVec2> {
        self.next.map(|_| self.max)
    }

    fn count(self) -> usize {
        usize::try_from(self.left()).unwrap_or(usize::MAX)
    }

    #[inline]
    fn fold<B, F: FnMut(B, IVec2) -> B>(self, init: B, mut f: F) -> B {
        let mut all = init;
        if let Some(first) = self.next {
            for y in first.y..=self.max.y {
                let left = if y == first.y { first.x } else { self.start };
                for x in left..=self.max.x {
                    all = f(all, IVec2::new(x, y));
                }
            }
        }
        all
    }
}

impl FusedIterator for Fill {}

#[cfg(test)]
mod tests;
