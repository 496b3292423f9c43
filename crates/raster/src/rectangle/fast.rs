//! The pixels of a rectangle one by one, and any number of them skipped at once.

use core::iter::FusedIterator;

use ombra_math::glam::IVec2;

use crate::bresenham;

/// The body of [`outline`](super::outline).
pub(super) fn outline(min: IVec2, max: IVec2) -> impl Iterator<Item = IVec2> + Clone {
    let (right, left) = (IVec2::new(max.x, min.y), IVec2::new(min.x, max.y));
    // A side leaves its last pixel to the next; one row or one column is one segment, with both its ends.
    let sides = if min.x > max.x || min.y > max.y {
        [(min, min, 1); 4]
    } else if min.x == max.x || min.y == max.y {
        [(min, max, 0), (max, max, 1), (max, max, 1), (max, max, 1)]
    } else {
        [
            (min, right, 1),
            (right, max, 1),
            (max, left, 1),
            (left, min, 1),
        ]
    };
    let [top, east, bottom, west] =
        sides.map(|(from, to, left_out)| bresenham::segment(from, to).but_last(left_out));
    top.chain(east).chain(bottom).chain(west)
}

/// The pixels of [`fill`](super::fill).
#[derive(Clone, Debug)]
pub struct Fill {
    next: Option<IVec2>,
    /// The first column.
    start: i32,
    max: IVec2,
}

impl Fill {
    pub(super) fn new(min: IVec2, max: IVec2) -> Self {
        let empty = min.x > max.x || min.y > max.y;
        Self {
            next: (!empty).then_some(min),
            start: min.x,
            max,
        }
    }

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
