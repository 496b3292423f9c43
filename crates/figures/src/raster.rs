//! Figures of the rasterization lecture: pixels that are on are vermilion, the ideal line or edge runs thin above.

mod bresenham_choice;
mod bresenham_increments;
mod bresenham_trace;
mod continuous_to_discrete;
mod dda_rounding;
mod polygon_kinds;
mod rectangle;
mod scanline;
mod segment_slopes;
mod sliver;
mod triangle_shared_edge;

use ombra_math::glam::{DVec2, IVec2};
use ombra_raster::span::Span;

use crate::colour::Role;
use crate::error::FigureError;
use crate::figure::Figure;
use crate::pixels::{Grid, NUMBERS, Orientation};
use crate::sheet::{Align, Sheet};
use crate::text::LABEL;

/// In the order of the lecture.
pub(crate) const FIGURES: &[Figure] = &[
    continuous_to_discrete::FIGURE,
    segment_slopes::FIGURE,
    dda_rounding::FIGURE,
    bresenham_choice::FIGURE,
    bresenham_increments::FIGURE,
    bresenham_trace::FIGURE,
    rectangle::FIGURE,
    polygon_kinds::FIGURE,
    scanline::FIGURE,
    triangle_shared_edge::FIGURE,
    sliver::FIGURE,
];

/// The segment of all figures, as in Grafica 3, «Algoritmo di Bresenham».
const SEGMENT: (IVec2, IVec2) = (IVec2::ZERO, IVec2::new(8, 3));

/// The pixels of spans.
fn pixels(spans: impl IntoIterator<Item = Span>) -> Vec<IVec2> {
    let pixels = spans.into_iter().flat_map(|span| span.pixels());
    pixels.map(|pixel| pixel.as_ivec2()).collect()
}

/// From one row of a table below columns to the next.
const ROW: f64 = 1.55 * LABEL;

/// Columns of pixels with their numbers and a table of rows below.
struct Columns {
    grid: Grid,
    /// Where the first row of the table has its middle.
    first: f64,
}

impl Columns {
    /// The pixels of [`SEGMENT`], `left` free on their left, below them `rows` rows.
    ///
    /// # Errors
    ///
    /// Those of text.
    fn new(sheet: &mut Sheet, left: f64, rows: f64, on: &[IVec2]) -> Result<Columns, FigureError> {
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
    fn word(
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
    fn height(&self, row: f64) -> f64 {
        self.first + ROW * row
    }
}
