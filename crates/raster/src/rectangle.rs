//! A rectangle with sides along the axes: its outline, four segments; its inside, a double loop.
#![cfg_attr(doc, doc = "")]
#![cfg_attr(doc, doc = include_str!("../figures/rectangle.svg"))]
//!
//! # A pixel is a sample
//!
//! `min` and `max` are pixels of the rectangle, both. A pixel is a coordinate at which the picture is sampled; it has
//! no shape and no area. So one counts positions, not lengths: from column 2 to column 6 there are 5, though
//! 6 − 2 = 4, and the rectangle from a pixel to itself, which has no area, is that one pixel.

mod fast;

use ombra_math::glam::IVec2;
use ombra_math::work::{Count, Counter};

use crate::bresenham;

pub use fast::Fill;

/// [`outline`] as the lecture tells it: four segments; `plot` gets the pixels.
///
/// # Properties
///
/// Equal to [`outline`]. Its work: that of [`bresenham::segment_plain`] for each side.
///
/// # References
///
/// As [`outline`].
pub fn outline_plain(min: IVec2, max: IVec2, work: &mut impl Count, mut plot: impl FnMut(IVec2)) {
    if min.x > max.x || min.y > max.y {
        return;
    }
    // One row or one column is one segment, with both its ends.
    if min.x == max.x || min.y == max.y {
        return bresenham::segment_plain(min, max, work, plot);
    }
    // Four segments, from corner to corner; each leaves its last pixel to the next.
    let corners = [min, IVec2::new(max.x, min.y), max, IVec2::new(min.x, max.y)];
    for (from, to) in corners.into_iter().zip(corners.into_iter().cycle().skip(1)) {
        bresenham::segment_plain(from, to, work, |p| {
            if p != to {
                plot(p);
            }
        });
    }
}

/// [`fill`] as the lecture tells it: a double loop; `plot` gets the pixels.
///
/// # Properties
///
/// Equal to [`fill`]. Its work: a fragment a pixel.
///
/// # References
///
/// As [`fill`].
pub fn fill_plain(min: IVec2, max: IVec2, work: &mut impl Count, mut plot: impl FnMut(IVec2)) {
    for y in min.y..=max.y {
        for x in min.x..=max.x {
            plot(IVec2::new(x, y));
            work.add(Counter::Fragments, 1);
        }
    }
}

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
    fast::outline(min, max)
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
    Fill::new(min, max)
}

#[cfg(test)]
mod tests;
