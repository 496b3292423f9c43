//! A rectangle along the axes: its outline and its inside.

use ombra_math::glam::{DVec2, IVec2};
use ombra_raster::rectangle::{fill, outline};

use crate::colour::Role;
use crate::error::FigureError;
use crate::figure::{Figure, Takes, Words};
use crate::labels::Key;
use crate::marks;
use crate::panels::panels;
use crate::path::Rect;
use crate::pixels::{Grid, NUMBERS, Orientation};
use crate::sheet::{Label, Sheet};

pub(super) const FIGURE: Figure = Figure {
    id: "raster/rectangle",
    takes: Takes {
        light: false,
        plane: false,
        mesh: false,
    },
    words: |_| Words {
        summary: Key::RECTANGLE_SUMMARY,
        caption: Key::RECTANGLE_CAPTION,
    },
    drawn: |sheet, _| draw(sheet),
};

const MIN: IVec2 = IVec2::new(1, 1);
const MAX: IVec2 = IVec2::new(5, 4);

fn draw(sheet: &mut Sheet) -> Result<(), FigureError> {
    let language = sheet.style().language;
    let kinds: [(Key, Vec<IVec2>); 2] = [
        (Key::RECTANGLE_OUTLINE, outline(MIN, MAX).collect()),
        (Key::RECTANGLE_FILLED, fill(MIN, MAX).collect()),
    ];
    let pixels = Key::PIXELS_OF.text(language);
    let lines = kinds
        .each_ref()
        .map(|(key, on)| format!("{}: {}\u{a0}{pixels}", key.text(language), on.len()));
    let lines = lines.each_ref().map(String::as_str);
    for (panel, (_, on)) in panels(sheet, &lines, 1.0)?.into_iter().zip(&kinds) {
        let frame = Rect::new(
            panel.min + DVec2::new(NUMBERS, 0.0),
            panel.max - DVec2::new(0.0, NUMBERS),
        );
        let grid = Grid::fit(IVec2::ZERO, MAX + 1, Orientation::Mathematical, frame);
        grid.draw(sheet, &[(Role::Chosen.into(), on)]);
        grid.number_columns(sheet)?;
        grid.number_rows(sheet)?;
        let (min, max) = (MIN.as_dvec2(), MAX.as_dvec2());
        grid.polygon(
            sheet,
            &[min, DVec2::new(max.x, min.y), max, DVec2::new(min.x, max.y)],
        );
        for (corner, towards) in [(MIN, DVec2::new(-1.0, 1.0)), (MAX, DVec2::new(1.0, -1.0))] {
            let at = grid.centre(corner);
            marks::point(sheet, at, Role::Text);
            let label = Label::new(at, format!("({}, {})", corner.x, corner.y));
            sheet.label(label.towards(towards).beside());
        }
    }
    Ok(())
}
