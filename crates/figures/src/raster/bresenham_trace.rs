//! A whole segment with the decision of every move.

use ombra_math::glam::{DVec2, IVec2};
use ombra_raster::bresenham::{segment, trace};

use super::{Columns, SEGMENT};
use crate::colour::Role;
use crate::error::FigureError;
use crate::figure::{Figure, Takes, Words};
use crate::labels::Key;
use crate::marks;
use crate::number::exact;
use crate::pixels::NUMBERS;
use crate::sheet::{Label, Sheet};

pub(super) const FIGURE: Figure = Figure {
    id: "raster/bresenham-trace",
    takes: Takes {
        light: false,
        plane: false,
        mesh: false,
    },
    words: |_| Words {
        summary: Key::BRESENHAM_TRACE_SUMMARY,
        caption: Key::BRESENHAM_TRACE_CAPTION,
    },
    drawn: |sheet, _| draw(sheet),
};

fn draw(sheet: &mut Sheet) -> Result<(), FigureError> {
    let (a, b) = SEGMENT;
    let on: Vec<IVec2> = segment(a, b).collect();
    let columns = Columns::new(sheet, NUMBERS, 2.0, &on)?;
    let grid = &columns.grid;
    for end in [a, b] {
        marks::point(sheet, grid.centre(end), Role::Text);
    }
    // What is below a column has chosen its pixel; the first is given.
    columns.word(sheet, (0, 0.0), "2*F*(*M*)", Role::Text)?;
    for (i, step) in trace(a, b).enumerate() {
        let next = step.pixel.x + 1;
        let m = grid.at(step.pixel.as_dvec2() + DVec2::new(1.0, 0.5));
        marks::hollow_point(sheet, m, Role::Undecided);
        if i == 0 {
            sheet.label(Label::new(m, "*M*").towards(DVec2::NEG_Y).beside());
        }
        let choice = step.choice.to_string();
        columns.word(sheet, (next, 0.0), &exact(step.decision as f64), Role::Text)?;
        columns.word(sheet, (next, 1.0), &choice, Role::Chosen)?;
    }
    Ok(())
}
