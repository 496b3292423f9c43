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
/// w h pixels for w columns and h rows, each once. All of `i32` × `i32` would be 2⁶⁴: `size_hint` then has no
/// upper bound.
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
        left: min.x,
        max,
    }
}

/// The pixels of [`fill`].
#[derive(Clone, Debug)]
pub struct Fill {
    next: Option<IVec2>,
    left: i32,
    max: IVec2,
}

impl Iterator for Fill {
    type Item = IVec2;

    #[inline]
    fn next(&mut self) -> Option<IVec2> {
        let pixel = self.next?;
        self.next = if pixel.x < self.max.x {
            Some(IVec2::new(pixel.x + 1, pixel.y))
        } else if pixel.y < self.max.y {
            Some(IVec2::new(self.left, pixel.y + 1))
        } else {
            None
        };
        Some(pixel)
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        let left = self.next.map_or(0, |pixel| {
            let columns = u128::from(self.left.abs_diff(self.max.x)) + 1;
            let rows_below = u128::from(pixel.y.abs_diff(self.max.y));
            rows_below * columns + u128::from(pixel.x.abs_diff(self.max.x)) + 1
        });
        usize::try_from(left).map_or((usize::MAX, None), |n| (n, Some(n)))
    }

    #[inline]
    fn fold<B, F: FnMut(B, IVec2) -> B>(self, init: B, mut f: F) -> B {
        let mut all = init;
        if let Some(first) = self.next {
            for y in first.y..=self.max.y {
                let left = if y == first.y { first.x } else { self.left };
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
mod tests {
    use std::collections::HashSet;

    use proptest::prelude::*;

    use super::*;

    fn grid(pixels: impl Iterator<Item = IVec2>, width: usize, height: usize) -> Vec<String> {
        let mut rows = vec![vec!['.'; width]; height];
        for p in pixels {
            let cell = &mut rows[p.y as usize][p.x as usize];
            assert_eq!(*cell, '.', "{p} twice");
            *cell = '#';
        }
        rows.into_iter()
            .map(|row| row.into_iter().collect())
            .collect()
    }

    #[test]
    fn the_outline_has_14_pixels_and_the_inside_20() {
        let (min, max) = (IVec2::new(2, 1), IVec2::new(6, 4));
        assert_eq!(outline(min, max).count(), 14);
        assert_eq!(fill(min, max).count(), 20);
        assert_eq!(
            grid(outline(min, max), 8, 6),
            [
                "........", "..#####.", "..#...#.", "..#...#.", "..#####.", "........"
            ]
        );
        assert_eq!(
            grid(fill(min, max), 8, 6),
            [
                "........", "..#####.", "..#####.", "..#####.", "..#####.", "........"
            ]
        );
    }

    #[test]
    fn the_outline_goes_round_from_min() {
        let round: Vec<_> = outline(IVec2::ZERO, IVec2::new(2, 2))
            .map(|p| (p.x, p.y))
            .collect();
        let expected = [
            (0, 0),
            (1, 0),
            (2, 0),
            (2, 1),
            (2, 2),
            (1, 2),
            (0, 2),
            (0, 1),
        ];
        assert_eq!(round, expected);
    }

    #[test]
    fn a_pixel_is_a_position_and_has_no_size() {
        let p = IVec2::new(-3, 7);
        assert_eq!(fill(p, p).collect::<Vec<_>>(), [p]);
        assert_eq!(outline(p, p).collect::<Vec<_>>(), [p]);
    }

    #[test]
    fn every_small_rectangle_has_its_pixels_once() {
        for (x0, y0, x1, y1) in (0..5 * 5 * 5 * 5).map(|i| (i % 5, i / 5 % 5, i / 25 % 5, i / 125))
        {
            let (min, max) = (IVec2::new(x0, y0), IVec2::new(x1, y1));
            let inside = |p: IVec2| x0 <= p.x && p.x <= x1 && y0 <= p.y && p.y <= y1;
            let on_side =
                |p: IVec2| inside(p) && (p.x == x0 || p.x == x1 || p.y == y0 || p.y == y1);
            let all = (0..25).map(|i| IVec2::new(i % 5, i / 5));
            let filled: Vec<_> = fill(min, max).collect();
            assert_eq!(
                filled,
                all.clone().filter(|&p| inside(p)).collect::<Vec<_>>()
            );
            let sides: Vec<_> = outline(min, max).collect();
            assert_eq!(
                sides.iter().copied().collect::<HashSet<_>>().len(),
                sides.len()
            );
            assert_eq!(
                sides.iter().copied().collect::<HashSet<_>>(),
                all.filter(|&p| on_side(p)).collect(),
                "{min} {max}"
            );
            assert_eq!(
                outline(min, max).size_hint(),
                (sides.len(), Some(sides.len()))
            );
        }
    }

    /// A step is lazy, so the whole of i32 × i32 can be begun.
    #[test]
    fn extremes() {
        let (lowest, highest) = (IVec2::MIN, IVec2::MAX);
        let mut all = fill(lowest, highest);
        assert_eq!(all.size_hint(), (usize::MAX, None));
        assert_eq!(all.next(), Some(lowest));
        if let Ok(left) = usize::try_from(u64::MAX) {
            assert_eq!(all.size_hint(), (left, Some(left)));
        }
        let round = outline(lowest, highest);
        assert_eq!(round.clone().next(), Some(lowest));
        if usize::BITS == 64 {
            let pixels = ((1 << 32) - 1) * 4;
            assert_eq!(round.size_hint(), (pixels, Some(pixels)));
        }
        assert_eq!(round.last(), Some(IVec2::new(i32::MIN, i32::MIN + 1)));
        assert_eq!(outline(highest, lowest).next(), None);
        assert_eq!(fill(highest, lowest).next(), None);
        assert_eq!(fill(highest, highest).collect::<Vec<_>>(), [highest]);
        assert_eq!(outline(highest, highest).collect::<Vec<_>>(), [highest]);
        let last_row = fill(IVec2::new(i32::MAX - 2, i32::MAX), highest);
        assert_eq!(
            last_row.map(|p| p.x).collect::<Vec<_>>(),
            [i32::MAX - 2, i32::MAX - 1, i32::MAX]
        );
    }

    proptest! {
        /// One by one, all at once, and some of each.
        #[test]
        fn fold_and_size_agree_with_next(min in prop::array::uniform2(-9..9i32), size in prop::array::uniform2(0..9i32), taken in 0..100usize) {
            let min = IVec2::from(min);
            let max = min + IVec2::from(size);
            let mut pixels = fill(min, max);
            for _ in 0..taken {
                pixels.next();
            }
            let mut one_by_one = vec![];
            let mut rest = pixels.clone();
            for p in rest.by_ref() {
                one_by_one.push(p);
            }
            prop_assert_eq!(pixels.size_hint(), (one_by_one.len(), Some(one_by_one.len())));
            let at_once = pixels.fold(vec![], |mut all, p| { all.push(p); all });
            prop_assert_eq!(at_once, one_by_one);
        }
    }
}
