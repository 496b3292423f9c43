//! A triangle ready to be drawn: its edge functions, and depth as a sum of them.

use core::ops::Range;

use super::Cull;
use super::screen::{Corner, SUBPIXELS, centres};

/// A triangle with its corners in the order in which its edge functions are positive inside.
///
/// ```text
/// Eᵢ(P) = twice the area of P and the side opposite corner i, in sub-pixels²:  integers of at most 52 bits
/// E₀ + E₁ + E₂ = E,  the triangle's
/// depth(P) = E₀ (d₀ / E) + E₁ (d₁ / E) + E₂ (d₂ / E),  kept between the least and the greatest dᵢ
/// ```
///
/// All terms are positive or zero and the Eᵢ exact, so however thin the triangle the sum is within 5 roundings of the
/// true depth, relative to the depth itself.
#[derive(Clone, Copy, Debug)]
pub(super) struct Setup<'a> {
    pub(super) corners: [&'a Corner; 3],
    /// Which corner of the piece each is.
    pub(super) order: [usize; 3],
    /// dᵢ / E.
    pub(super) values: [f64; 3],
    pub(super) least: f64,
    pub(super) greatest: f64,
}

impl<'a> Setup<'a> {
    /// `None` for a triangle without area, or culled.
    #[inline(always)]
    pub(super) fn new([a, b, c]: [&'a Corner; 3], cull: Cull) -> Option<Self> {
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
        let inverse = 1.0 / (area.abs() as f64);
        let [d0, d1, d2] = corners.map(|corner| corner.value);
        Some(Self {
            corners,
            order,
            values: [d0 * inverse, d1 * inverse, d2 * inverse],
            least: lesser(lesser(d0, d1), d2),
            greatest: greater(greater(d0, d1), d2),
        })
    }

    /// The columns and rows with centres between the least and the greatest coordinate.
    #[inline(always)]
    pub(super) fn bounds(&self, width: u32, height: u32) -> [Range<u32>; 2] {
        let [a, b, c] = self.corners;
        [
            centres(a.x.min(b.x).min(c.x), a.x.max(b.x).max(c.x), width),
            centres(a.y.min(b.y).min(c.y), a.y.max(b.y).max(c.y), height),
        ]
    }

    /// The edge functions at a pixel's centre if the triangle owns it, by the top-left rule.
    pub(super) fn edges_at(&self, x: u32, y: u32) -> Option<[f64; 3]> {
        let centre = Corner {
            x: x as i32 * SUBPIXELS + SUBPIXELS / 2,
            y: y as i32 * SUBPIXELS + SUBPIXELS / 2,
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

    /// The edge functions from pixel (x, y) on. All sums are of integers of at most 53 bits, so exact.
    #[inline(always)]
    pub(super) fn lines(&self, x: u32, y: u32) -> [Line; 3] {
        let centre = |i: u32| f64::from(i as i32 * SUBPIXELS + SUBPIXELS / 2);
        let (x, y) = (centre(x), centre(y));
        self.sides().map(|(a, b)| {
            let (dx, dy) = (f64::from(b.x - a.x), f64::from(b.y - a.y));
            Line {
                first: dx * (y - f64::from(a.y)) - dy * (x - f64::from(a.x)),
                across: -dy * f64::from(SUBPIXELS),
                down: dx * f64::from(SUBPIXELS),
                least: if is_top_left(a, b) { 0.0 } else { 1.0 },
            }
        })
    }

    /// The side opposite each corner.
    #[inline(always)]
    pub(super) fn sides(&self) -> [(&'a Corner, &'a Corner); 3] {
        let [a, b, c] = self.corners;
        [(b, c), (c, a), (a, b)]
    }

    /// The depth where the edge functions have these values.
    #[inline(always)]
    pub(super) fn value(&self, [e0, e1, e2]: [f64; 3]) -> f64 {
        let [v0, v1, v2] = self.values;
        let sum = e0 * v0 + e1 * v1 + e2 * v2;
        lesser(greater(sum, self.least), self.greatest)
    }
}

/// An edge function, from pixel to pixel.
#[derive(Clone, Copy, Debug)]
pub(super) struct Line {
    /// At the first pixel's centre.
    pub(super) first: f64,
    /// What it changes by from column to column and from row to row.
    pub(super) across: f64,
    pub(super) down: f64,
    /// The least value with which a pixel is in: 0 on a top or a left side, 1 otherwise.
    pub(super) least: f64,
}

/// Twice the area of a triangle in sub-pixels², positive where it is clockwise in the picture.
#[inline(always)]
fn twice_area(a: &Corner, b: &Corner, c: &Corner) -> i64 {
    let product = |p: i32, q: i32| i64::from(p) * i64::from(q);
    product(b.x - a.x, c.y - a.y) - product(b.y - a.y, c.x - a.x)
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
pub(super) fn is_top_left(a: &Corner, b: &Corner) -> bool {
    b.y < a.y || (b.y == a.y && b.x > a.x)
}
