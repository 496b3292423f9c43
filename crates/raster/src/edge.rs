//! One edge of a polygon or a triangle, and the rows and columns where it is crossed.

use core::cmp::Ordering;
use core::ops::Range;

use ombra_math::exact::Sum;
use ombra_math::glam::DVec2;
use ombra_math::predicates::orient_2d;

/// An edge that at least one row of pixel centres crosses: a record of the edge table.
#[derive(Clone, Debug, PartialEq)]
pub struct Edge {
    /// The end with the smaller y (y down).
    pub top: DVec2,
    /// The end with the larger y.
    pub bottom: DVec2,
    /// +1 where the contour runs down along the edge, −1 where it runs up.
    pub winding: i32,
    /// The rows j of the picture with top.y ≤ j + ½ < bottom.y.
    pub rows: Range<u32>,
}

impl Edge {
    /// The record of the edge that runs from `from` to `to`, in a picture of `height` rows.
    ///
    /// # Formula
    ///
    /// ```text
    /// rows: top.y ≤ j + ½ < bottom.y,  so  ⌈top.y − ½⌉ ≤ j < ⌈bottom.y − ½⌉
    /// ```
    ///
    /// # Properties
    ///
    /// Exact: y − ½ is rounded only where its ceiling cannot change. A vertex on a row of centres belongs to the
    /// edge below it, so two edges of a chain that runs on down are crossed once there, not twice.
    ///
    /// # Errors
    ///
    /// `None` for an edge that no row of centres crosses: horizontal, between two rows, above or below the
    /// picture, or with an end that is not finite.
    ///
    /// # Examples
    ///
    /// ```
    /// use ombra_math::glam::DVec2;
    /// use ombra_raster::polygon::Edge;
    ///
    /// let edge = Edge::new(DVec2::new(3.0, 4.5), DVec2::new(1.0, 0.5), 100).unwrap();
    /// assert_eq!((edge.rows, edge.winding), (0..4, -1));
    /// assert_eq!(Edge::new(DVec2::ZERO, DVec2::X, 100), None);
    /// ```
    #[must_use]
    #[inline]
    pub fn new(from: DVec2, to: DVec2, height: u32) -> Option<Self> {
        if !from.is_finite() || !to.is_finite() {
            return None;
        }
        let below = [from, to].map(|end| first_centre(end.y, height));
        Self::between(from, to, below)
    }

    /// The same, given for either end the first row whose centres do not lie above it.
    #[inline]
    pub(crate) fn between(from: DVec2, to: DVec2, [from_row, to_row]: [u32; 2]) -> Option<Self> {
        let (top, bottom, winding, rows) = match from_row.cmp(&to_row) {
            Ordering::Less => (from, to, 1, from_row..to_row),
            Ordering::Greater => (to, from, -1, to_row..from_row),
            Ordering::Equal => return None,
        };
        Some(Self {
            top,
            bottom,
            winding,
            rows,
        })
    }

    /// Whether the centre of pixel (`column`, `row`) lies to the left of the edge; exact.
    ///
    /// # Formula
    ///
    /// ```text
    /// left:  (bottom.x − top.x)(j + ½ − top.y) − (bottom.y − top.y)(i + ½ − top.x) > 0
    /// ```
    ///
    /// A centre exactly on the edge is not left of it: it belongs to what lies right of the edge.
    #[must_use]
    pub fn has_on_left(&self, column: u32, row: u32) -> bool {
        let centre = DVec2::new(f64::from(column) + 0.5, f64::from(row) + 0.5);
        orient_2d(self.top, self.bottom, centre) == Some(Ordering::Greater)
    }

    /// The first column whose centre is not left of the edge in `row`; `width` where there is none.
    ///
    /// # Formula
    ///
    /// ```text
    /// ⌈X − ½⌉,  X the crossing of the edge with y = row + ½,  kept within 0 … width
    /// ```
    ///
    /// # Properties
    ///
    /// Exact for all finite ends: a binary search that asks [`Edge::has_on_left`]. Outside the edge's rows it is
    /// the crossing of the line through the edge.
    #[must_use]
    pub fn column(&self, row: u32, width: u32) -> u32 {
        first(0..width, |column| !self.has_on_left(column, row))
    }

    /// The crossing X with y = `row` + ½, as the double nearest to it.
    ///
    /// # Formula
    ///
    /// ```text
    ///     top.x (bottom.y − y) + bottom.x (y − top.y)
    /// X = ───────────────────────────────────────────
    ///                 bottom.y − top.y
    /// ```
    ///
    /// # Properties
    ///
    /// - Error: none: the nearest double.
    #[must_use]
    pub fn x(&self, row: u32) -> f64 {
        let (a, b, y) = (self.top, self.bottom, f64::from(row) + 0.5);
        let numerator = [
            [a.x, b.y, 1.0],
            [-a.x, y, 1.0],
            [b.x, y, 1.0],
            [-b.x, a.y, 1.0],
        ];
        Sum::of(&numerator).quotient(&Sum::of(&[[b.y, 1.0, 1.0], [-a.y, 1.0, 1.0]]))
    }
}

/// ⌈t − ½⌉ within 0 … `count`: the first row, or column, whose centre does not come before `t`.
#[inline]
pub(crate) fn first_centre(t: f64, count: u32) -> u32 {
    // The ceiling by conversion, which rounds towards 0 and keeps within 0 … u32::MAX.
    let t = t - 0.5;
    let k = t as u32;
    k.saturating_add(u32::from(f64::from(k) < t)).min(count)
}

/// The first member of `range` that `holds`, given that all after it do; the end if none does.
pub(crate) fn first(range: Range<u32>, holds: impl Fn(u32) -> bool) -> u32 {
    let (mut low, mut high) = (range.start, range.end.max(range.start));
    while low < high {
        let middle = low + (high - low) / 2;
        if holds(middle) {
            high = middle;
        } else {
            low = middle + 1;
        }
    }
    low
}
