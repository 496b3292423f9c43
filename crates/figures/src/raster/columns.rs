//! What the figures of rasterization share: one segment, and its pixels in columns over a table.

use ombra_math::glam::{DVec2, IVec2};
use ombra_raster::span::Span;

use crate::colour::Role;
use crate::error::FigureError;
use crate::pixels::{Grid, NUMBERS, Orientation};
use crate::sheet::{Align, Sheet};
use crate::text::LABEL;

/// The segment of all figures, as in Grafica 3, «Algoritmo di Bresenham».
pub(super) const SEGMENT: (IVec2, IVec2) = (IVec2::ZERO, IVec2::new(8, 3));

/// The pixels of spans.
pub(super) fn pixels(spans: impl IntoIterator<Item = Span>) -> Vec<IVec2> {
    let pixels = spans.into_iter().flat_map(|span| span.pixels());
    pixels.map(|pixel| pixel.as_ivec2()).collect()
}

/// From one row of a table below columns to the next.
pub(super) const ROW: f64 = 1.55 * LABEL;

/// Columns of pixels with their numbers and a table of rows below.
pub(super) struct Columns {
    pub(super) grid: Grid,
    /// Where the first row of the table has its middle.
    pub(super) first: f64,
}

impl Columns {
    /// The pixels of [`SEGMENT`], `left` free on their left, below them `rows` rows.
    ///
    /// # Errors
    ///
    /// Those of text.
    pub(super) fn new(
        sheet: &mut Sheet,
        left: f64,
        rows: f64,
        on: &[IVec2],
    ) -> Result<Columns, FigureError> {
        let mut frame = sheet.frame();
        frame.min.x += left;
        frame.max.y -= NUMBERS + ROW * rows;
        let (a, b) = SEGMENT;
        let grid = Grid::fit(a, b, Orientation::Mathematical, frame);
        grid.draw(sheet, &[(Role::Chosen.into(), on)]);
        grid.number_columns(sheet)?;
        grid.number_rows(sheet)?;
        grid.line(sheet, a.as_dvec2(), b.as_dvec2());
        let first = grid.bounds().max.y + NUMBERS + 0.5 * ROW;
        Ok(Columns { grid, first })
    }

    /// A word of the table below column `x`.
    pub(super) fn word(
        &self,
        sheet: &mut Sheet,
        (x, row): (i32, f64),
        markup: &str,
        role: Role,
    ) -> Result<(), FigureError> {
        let x = self.grid.centre(IVec2::new(x, 0)).x;
        let at = DVec2::new(x, self.height(row));
        sheet.text(at, Align::Centre, markup, LABEL, role)?;
        Ok(())
    }

    /// The middle of a row of the table.
    pub(super) fn height(&self, row: f64) -> f64 {
        self.first + ROW * row
    }
}
