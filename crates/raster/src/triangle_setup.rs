//! A triangle set up for its pixels: edge functions in integers, and depth as a sum of them.
//!
//! Corners lie on a grid of 2⁻⁸ of a pixel, as hardware keeps them, so an edge function is an integer and what it
//! decides is exact. [`triangle`](crate::triangle) and [`attributes`](crate::attributes) tell the same of corners
//! anywhere; this is the form for millions of triangles, as the z-buffer draws them.

use core::ops::Range;

use ombra_math::glam::DVec2;

/// Corners are moved to multiples of 2⁻⁸ of a pixel.
pub const SUBPIXEL_BITS: u32 = 8;
/// Sub-pixels in a pixel.
pub const SUBPIXELS: i32 = 1 << SUBPIXEL_BITS;

/// A triangle with its corners in the order in which its edge functions are positive inside.
///
/// # Formula
///
/// ```text
/// Eᵢ(P) = twice the area of P and the side opposite corner i, in sub-pixels²: an integer
/// E₀ + E₁ + E₂ = E,  the triangle's
/// depth(P) = E₀ (d₀ / E) + E₁ (d₁ / E) + E₂ (d₂ / E),
///            kept between the least and the greatest dᵢ
/// ```
///
/// # Properties
///
/// Where the corners and the picture lie in a square of 2¹⁷ pixels, the Eᵢ have 52 bits at most and are exact, in a
/// double too. Farther away they are some numbers.
///
/// # Examples
///
/// ```
/// use ombra_math::glam::DVec2;
/// use ombra_raster::triangle_setup::{Corner, Cull, Setup};
///
/// let corner = |x, y, depth| Corner::snapped(DVec2::new(x, y), depth, 1.0);
/// let corners = [corner(0.0, 0.0, 0.5), corner(2.0, 0.0, 0.5), corner(0.0, 2.0, 0.25)];
/// let setup = Setup::new(corners.each_ref(), Cull::Nothing).unwrap();
/// let depths: Vec<_> = setup.pixels(8, 8).map(|(x, y, edges)| (x, y, setup.value(edges))).collect();
/// // The slanted side runs through the centres (1, 0) and (0, 1), and is no top or left one.
/// assert_eq!(depths, [(0, 0, 0.4375)]);
/// ```
///
/// # References
///
/// Grafica 3, «Algoritmo Z-Buffer»: the depth of the primitive at each of its pixels. J. Pineda, «A parallel algorithm
/// for polygon rasterization», 1988.
#[derive(Clone, Copy, Debug)]
pub struct Setup<'a> {
    /// The corners, clockwise in the picture.
    pub corners: [&'a Corner; 3],
    /// Which of the given corners each is.
    pub order: [usize; 3],
    /// dᵢ / E.
    pub values: [f64; 3],
    /// The least dᵢ.
    pub least: f64,
    /// The greatest dᵢ.
    pub greatest: f64,
}

impl<'a> Setup<'a> {
    /// `None` for a triangle without area, or culled.
    #[inline(always)]
    #[must_use]
    pub fn new([a, b, c]: [&'a Corner; 3], cull: Cull) -> Option<Self> {
        let area = twice_area(a, b, c);
        // y runs down: counter-clockwise, as a front face is seen, is negative.
        let kept = match cull {
            Cull::Nothing => area != 0,
            Cull::Back => area < 0,
            Cull::Front => area > 0,
        };
        if !kept {
            return None;
        }
        let (corners, order) = if area > 0 {
            ([a, b, c], [0, 1, 2])
        } else {
            ([a, c, b], [0, 2, 1])
        };
        let inverse = 1.0 / (area as f64).abs();
        let [d0, d1, d2] = corners.map(|corner| corner.value);
        Some(Self {
            corners,
            order,
            values: [d0 * inverse, d1 * inverse, d2 * inverse],
            least: lesser(lesser(d0, d1), d2),
            greatest: greater(greater(d0, d1), d2),
        })
    }

    /// The pixels that the triangle owns in a picture of `width` × `height`, (x, y), row after row, and the edge
    /// functions at the centre of each.
    ///
    /// # Properties
    ///
    /// - Error: 0
    pub fn pixels(&self, width: u32, height: u32) -> impl Iterator<Item = (u32, u32, [f64; 3])> {
        let [columns, rows] = self.bounds(width, height);
        let owned = move |x, y| Some((x, y, self.edges_at(x, y)?));
        rows.flat_map(move |y| columns.clone().filter_map(move |x| owned(x, y)))
    }

    /// The columns and rows with centres between the least and the greatest coordinate.
    #[inline(always)]
    #[must_use]
    pub fn bounds(&self, width: u32, height: u32) -> [Range<u32>; 2] {
        let [a, b, c] = self.corners;
        [
            centres(a.x.min(b.x).min(c.x), a.x.max(b.x).max(c.x), width),
            centres(a.y.min(b.y).min(c.y), a.y.max(b.y).max(c.y), height),
        ]
    }

    /// The edge functions at a pixel's centre if the triangle owns it, by the top-left rule.
    ///
    /// # Properties
    ///
    /// - Error: 0
    #[inline]
    #[must_use]
    pub fn edges_at(&self, x: u32, y: u32) -> Option<[f64; 3]> {
        let centre = Corner {
            x: centre(x),
            y: centre(y),
            ..Corner::default()
        };
        let mut edges = [0.0; 3];
        for (edge, (a, b)) in edges.iter_mut().zip(self.sides()) {
            let e = twice_area(a, b, &centre);
            if e < 0 || (e == 0 && !is_top_left(a, b)) {
                return None;
            }
            *edge = e as f64;
        }
        Some(edges)
    }

    /// The edge functions from pixel (x, y) on, for stepping along rows and down columns.
    ///
    /// # Properties
    ///
    /// - Error: 0, also of what is stepped to
    #[inline(always)]
    #[must_use]
    pub fn lines(&self, x: u32, y: u32) -> [Line; 3] {
        let [x, y] = [x, y].map(|i| f64::from(centre(i)));
        self.sides().map(|(a, b)| {
            let (dx, dy) = (
                f64::from(b.x.wrapping_sub(a.x)),
                f64::from(b.y.wrapping_sub(a.y)),
            );
            Line {
                first: dx * (y - f64::from(a.y)) - dy * (x - f64::from(a.x)),
                across: -dy * f64::from(SUBPIXELS),
                down: dx * f64::from(SUBPIXELS),
                least: if is_top_left(a, b) { 0.0 } else { 1.0 },
            }
        })
    }

    /// The depth where the edge functions have these values.
    ///
    /// # Properties
    ///
    /// However thin the triangle: all terms are positive or zero, and the edge functions exact.
    ///
    /// - Error: 2½ ε of itself, short of underflow
    #[inline(always)]
    #[must_use]
    pub fn value(&self, [e0, e1, e2]: [f64; 3]) -> f64 {
        let [v0, v1, v2] = self.values;
        let sum = e0 * v0 + e1 * v1 + e2 * v2;
        lesser(greater(sum, self.least), self.greatest)
    }

    /// The side opposite each corner.
    #[inline(always)]
    fn sides(&self) -> [(&'a Corner, &'a Corner); 3] {
        let [a, b, c] = self.corners;
        [(b, c), (c, a), (a, b)]
    }
}

/// A corner in the picture.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Corner {
    /// Its column, in sub-pixels.
    pub x: i32,
    /// Its row, in sub-pixels, downwards.
    pub y: i32,
    /// What is linear in the picture: a depth, 0 … 1.
    pub value: f64,
    /// The w of its clip coordinates.
    pub w: f64,
}

impl Corner {
    /// The corner at `p`, in pixels, moved to the nearest sub-pixel, as [`snap`](crate::triangle::snap) has it.
    ///
    /// # Properties
    ///
    /// For coordinates below 2¹⁸; any other gets some place.
    #[inline(always)]
    #[must_use]
    pub fn snapped(p: DVec2, value: f64, w: f64) -> Self {
        Self {
            x: nearest_subpixel(p.x),
            y: nearest_subpixel(p.y),
            value,
            w,
        }
    }
}

/// Which triangles are left out, by the side from which they are seen.
#[doc(alias = "face culling")]
#[doc(alias = "glCullFace")]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Cull {
    /// None.
    #[default]
    Nothing,
    /// Those seen from behind: their corners run clockwise in the picture.
    Back,
    /// Those seen from the front.
    Front,
}

/// An edge function, from pixel to pixel.
#[derive(Clone, Copy, Debug)]
pub struct Line {
    /// At the first pixel's centre.
    pub first: f64,
    /// What it changes by from column to column.
    pub across: f64,
    /// What it changes by from row to row.
    pub down: f64,
    /// The least value with which a pixel is in: 0 on a top or a left side, 1 otherwise.
    pub least: f64,
}

/// The pixels, of `side` in a row or a column, whose centres are between two coordinates in sub-pixels.
#[inline(always)]
#[must_use]
pub fn centres(least: i32, greatest: i32, side: u32) -> Range<u32> {
    const HALF: i32 = SUBPIXELS / 2;
    // ⌈x − ½⌉ to ⌊x − ½⌋, in pixels.
    let first = (least.wrapping_add(HALF - 1) >> SUBPIXEL_BITS).max(0) as u32;
    let end = (greatest.wrapping_add(HALF) >> SUBPIXEL_BITS).max(0) as u32;
    first..end.min(side)
}

/// The centre of a pixel's column or row, in sub-pixels.
#[inline(always)]
fn centre(i: u32) -> i32 {
    (i as i32)
        .wrapping_mul(SUBPIXELS)
        .wrapping_add(SUBPIXELS / 2)
}

/// ⌊x · 2⁸ + ½⌋ for |x| < 2¹⁸.
#[inline(always)]
fn nearest_subpixel(x: f64) -> i32 {
    // All sums are far from 2⁵², where a half would be lost.
    let floor = (x * f64::from(SUBPIXELS) + 0.5).floor();
    // Of what is in range, the integer is in the last digits, below 2⁵² + 2⁵¹.
    const INTEGERS: f64 = (3u64 << 51) as f64;
    (floor + INTEGERS).to_bits() as i32
}

/// Twice the area of a triangle in sub-pixels², positive where it is clockwise in the picture.
#[inline(always)]
fn twice_area(a: &Corner, b: &Corner, c: &Corner) -> i64 {
    let product = |p: i32, q: i32| i64::from(p) * i64::from(q);
    let across = |p: &Corner, q: &Corner| q.x.wrapping_sub(p.x);
    let down = |p: &Corner, q: &Corner| q.y.wrapping_sub(p.y);
    product(across(a, b), down(a, c)).wrapping_sub(product(down(a, b), across(a, c)))
}

/// The greater of two numbers: one instruction, as NaN need not be thought of.
#[inline(always)]
fn greater(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

#[inline(always)]
fn lesser(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}

/// Whether a b is a top or a left side of the triangle to its right.
#[inline(always)]
fn is_top_left(a: &Corner, b: &Corner) -> bool {
    b.y < a.y || (b.y == a.y && b.x > a.x)
}

#[cfg(test)]
mod tests;
