//! A pixel a column for gentle segments, a pixel a row for steep ones.

use ombra_math::glam::{DVec2, IVec2};
use ombra_raster::bresenham::segment;

use super::SEGMENT;
use crate::colour::Role;
use crate::error::FigureError;
use crate::figure::{Figure, Takes, Words};
use crate::labels::Key;
use crate::marks;
use crate::panels::panels;
use crate::path::Rect;
use crate::pixels::{Grid, NUMBERS, Orientation};
use crate::sheet::Sheet;

pub(super) const FIGURE: Figure = Figure {
    id: "raster/segment-slopes",
    takes: Takes {
        light: false,
        plane: false,
        mesh: false,
    },
    words: |_| Words {
        summary: Key::SEGMENT_SLOPES_SUMMARY,
        caption: Key::SEGMENT_SLOPES_CAPTION,
    },
    drawn: |sheet, _| draw(sheet),
};

fn draw(sheet: &mut Sheet) -> Result<(), FigureError> {
    let language = sheet.style().language;
    let lines = [Key::SLOPE_COLUMNS, Key::SLOPE_ROWS].map(|key| key.text(language));
    let (a, b) = SEGMENT;
    let corner = IVec2::splat(b.x);
    for (i, panel) in panels(sheet, &lines, 1.0)?.into_iter().enumerate() {
        let steep = i == 1;
        let end = if steep { IVec2::new(b.y, b.x) } else { b };
        let frame = Rect::new(
            panel.min + DVec2::new(NUMBERS, 0.0),
            panel.max - DVec2::new(0.0, NUMBERS),
        );
        let grid = Grid::fit(a, corner, Orientation::Mathematical, frame);
        // Every other column, or row, on darker ground.
        let every = (0..=corner.x).flat_map(|x| (0..=corner.y).map(move |y| IVec2::new(x, y)));
        let striped = |p: &IVec2| (if steep { p.y } else { p.x }) % 2 == 0;
        let stripes: Vec<IVec2> = every.filter(striped).collect();
        sheet.fill(grid.cells(&stripes), Role::Ground);
        let on: Vec<IVec2> = segment(a, end).collect();
        grid.draw(sheet, &[(Role::Chosen.into(), &on)]);
        if steep {
            grid.number_rows(sheet)?;
        } else {
            grid.number_columns(sheet)?;
        }
        grid.line(sheet, a.as_dvec2(), end.as_dvec2());
        for end in [a, end] {
            marks::point(sheet, grid.centre(end), Role::Text);
        }
    }
    Ok(())
}
