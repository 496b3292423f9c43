//! A span: consecutive pixels of one row.
//!
//! Polygons and triangles come out as spans, because a run of pixels is written, counted and stepped along
//! faster than pixels one by one.

use core::ops::Range;

use ombra_math::glam::UVec2;

/// The pixels (x.start, y) … (x.end − 1, y).
///
/// # Examples
///
/// ```
/// use ombra_raster::span::Span;
///
/// let span = Span { y: 2, x: 5..8 };
/// assert_eq!(span.len(), 3);
/// assert_eq!(span.pixels().map(|p| p.x).collect::<Vec<_>>(), [5, 6, 7]);
/// ```
///
/// # References
///
/// Grafica 3, «Rasterizzazione»: scan-conversion, after the lines of pixels of a raster device.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
pub struct Span {
    /// The row, 0 at the top.
    pub y: u32,
    /// The columns, 0 on the left.
    pub x: Range<u32>,
}

impl Span {
    /// Number of pixels; 0 where `x` ends before it starts.
    #[must_use]
    pub fn len(&self) -> u32 {
        self.x.end.saturating_sub(self.x.start)
    }

    /// Whether there is no pixel.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.x.is_empty()
    }

    /// The pixels, left to right.
    pub fn pixels(&self) -> impl Iterator<Item = UVec2> + use<> {
        let y = self.y;
        self.x.clone().map(move |x| UVec2::new(x, y))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    #[allow(clippy::reversed_empty_ranges)]
    fn degenerate() {
        for (x, len) in [(0..0, 0), (5..5, 0), (7..5, 0), (0..u32::MAX, u32::MAX)] {
            let span = Span { y: u32::MAX, x };
            assert_eq!((span.len(), span.is_empty()), (len, len == 0), "{span:?}");
            assert_eq!(span.pixels().next().is_none(), len == 0);
        }
    }
}
