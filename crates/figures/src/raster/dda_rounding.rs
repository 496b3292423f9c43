//! The points of the line, and the pixels they are rounded to.

use ombra_math::glam::{DVec2, IVec2};
use ombra_raster::dda::segment;

use super::{Columns, SEGMENT};
use crate::colour::Role;
use crate::drawing::NORMAL;
use crate::error::FigureError;
use crate::figure::{Figure, Takes, Words};
use crate::labels::Key;
use crate::marks;
use crate::number::exact;
use crate::sheet::{Align, Sheet};
use crate::text::LABEL;

pub(super) const FIGURE: Figure = Figure {
    id: "raster/dda-rounding",
    takes: Takes {
        light: false,
        plane: false,
        mesh: false,
    },
    words: |_| Words {
        summary: Key::DDA_ROUNDING_SUMMARY,
        caption: Key::DDA_ROUNDING_CAPTION,
    },
    drawn: |sheet, _| draw(sheet),
};

/// Room for the names of the rows.
const LEFT: f64 = 3.9 * LABEL;
/// The rows of the table; fractions are tall.
const Y: f64 = 0.55;
const PIXEL: f64 = 1.9;

fn draw(sheet: &mut Sheet) -> Result<(), FigureError> {
    let (a, b) = SEGMENT;
    let on: Vec<IVec2> = segment(a, b).collect();
    let columns = Columns::new(sheet, LEFT, 2.4, &on)?;
    let grid = &columns.grid;
    let word = Key::PIXEL.text(sheet.style().language);
    let left = sheet.frame().min.x.max(grid.bounds().min.x - LEFT);
    for (name, row) in [("*y*_i", Y), (word, PIXEL)] {
        let at = DVec2::new(left, columns.height(row));
        sheet.text(at, Align::Left, name, LABEL, Role::Text)?;
    }
    let m = f64::from(b.y) / f64::from(b.x);
    for &pixel in &on {
        let y = m * f64::from(pixel.x);
        let place = grid.at(DVec2::new(f64::from(pixel.x), y));
        if place != grid.centre(pixel) {
            marks::arrow(sheet, place, grid.centre(pixel), Role::Text, NORMAL);
        }
        marks::hollow_point(sheet, place, Role::Undecided);
        columns.word(sheet, (pixel.x, Y), &exact(y), Role::Text)?;
        columns.word(sheet, (pixel.x, PIXEL), &pixel.y.to_string(), Role::Chosen)?;
    }
    Ok(())
}
