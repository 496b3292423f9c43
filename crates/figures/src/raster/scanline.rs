//! One scan line: the edge table, the active edges, the spans between them.

use core::cmp::Ordering;

use ombra_math::glam::{DVec2, IVec2};
use ombra_raster::polygon::{Crossing, Edge, FillRule, active_edges, edge_table, fill};

use super::columns::pixels;
use crate::colour::{Ink, Role};
use crate::drawing::{NORMAL, Pen, THIN};
use crate::error::FigureError;
use crate::figure::{About, Figure, Takes};
use crate::marks;
use crate::number::decimal;
use crate::path::Rect;
use crate::pixels::{Grid, NUMBERS, Orientation};
use crate::sheet::{Align, Label, Sheet};
use crate::text::{LABEL, Line, NOTE};
use crate::words::words;

pub(super) const FIGURE: Figure = Figure {
    id: "raster/scanline",
    takes: Takes::Nothing(crate::words::FIXED),
    words: WORDS,
    about: |_, language| About::new(language, SUMMARY, CAPTION),
    drawn: |sheet, _| draw(sheet),
};

words! {
    SUMMARY {
        en: "One scan line: edge table, active edges and the spans between them",
        it: "Una scan-line: tabella dei lati, lati attivi e gli intervalli tra loro",
        cs: "Jeden řádek: tabulka hran, aktivní hrany a úseky mezi nimi",
        hr: "Jedan redak: tablica bridova, aktivni bridovi i rasponi među njima",
    }

    CAPTION {
        en: "The active edges cross the row at the places *X*. Between the first and the second, the third and the fourth, centres are inside.",
        it: "I lati attivi incrociano la riga nei punti *X*. Tra il primo e il secondo, tra il terzo e il quarto, i centri sono interni.",
        cs: "Aktivní hrany protínají řádek v místech *X*. Mezi prvním a druhým, třetím a čtvrtým leží středy uvnitř.",
        hr: "Aktivni bridovi sijeku redak na mjestima *X*. Između prvog i drugog, trećeg i četvrtog središta su unutra.",
    }

    /// Heading of the edge table.
    EDGE {
        en: "edge",
        it: "lato",
        cs: "hrana",
        hr: "brid",
    }

    /// Heading of the edge table: where an edge begins and ends.
    ROWS {
        en: "rows",
        it: "righe",
        cs: "řádky",
        hr: "redci",
    }
}

/// Pixels across and down, and the row looked at.
const SIZE: (u32, u32) = (14, 12);
const ROW: u32 = 6;
/// Concave: the row crosses it four times.
const POLYGON: [(f64, f64); 7] = [
    (1.2, 2.0),
    (4.6, 0.8),
    (7.4, 8.2),
    (10.5, 1.0),
    (13.0, 4.0),
    (11.2, 11.2),
    (2.6, 10.4),
];
/// Between the picture and the table, and from one of its columns to the next.
const GAP: f64 = 70.0;
const GUTTER: f64 = 40.0;
const LEADING: f64 = 2.0 * LABEL;

fn draw(sheet: &mut Sheet) -> Result<(), FigureError> {
    let language = sheet.style().language;
    let polygon = POLYGON.map(DVec2::from).to_vec();
    let contours = [polygon.clone()];
    let (width, height) = SIZE;
    let (Ok(table), Ok(spans)) = (
        edge_table(&contours, height),
        fill(&contours, FillRule::EvenOdd, width, height),
    ) else {
        return Ok(());
    };
    let active = active_edges(&table, ROW, width);

    // The edge table: names, rows, and where the row is crossed.
    let mut columns = [
        vec![EDGE.text(language).to_owned()],
        vec![ROWS.text(language).to_owned()],
        vec!["*X*".to_owned()],
    ];
    for (i, edge) in table.iter().enumerate() {
        let x = active.iter().find(|crossing| crossing.edge == i);
        let cells = [
            format!("*e*_{i}"),
            rows(edge),
            x.map_or(String::new(), |crossing| decimal(crossing.x)),
        ];
        for (column, cell) in columns.iter_mut().zip(cells) {
            column.push(cell);
        }
    }
    let lines: Vec<Vec<Line>> = columns
        .iter()
        .map(|column| {
            column
                .iter()
                .map(|cell| sheet.lay_out(cell, LABEL))
                .collect()
        })
        .collect::<Result<_, _>>()?;
    let widths: Vec<f64> = lines
        .iter()
        .map(|column| column.iter().map(|line| line.width).fold(0.0, f64::max))
        .collect();
    let table_width = widths.iter().sum::<f64>() + GUTTER * (widths.len() as f64 - 1.0);

    let frame = sheet.frame();
    let room = Rect::new(
        frame.min + DVec2::new(NUMBERS, 0.0),
        frame.max - DVec2::new(table_width + GAP, 0.0),
    );
    let last = IVec2::new(width as i32 - 1, height as i32 - 1);
    let grid = Grid::fit(IVec2::ZERO, last, Orientation::Picture, room);
    draw_picture(sheet, &grid, &pixels(spans), &table, &active)?;

    let rows = table.len() + 1;
    let top = frame.centre().y - 0.5 * LEADING * (rows as f64 - 1.0);
    let mut left = frame.max.x - table_width;
    for (column, width) in lines.into_iter().zip(widths) {
        for (row, line) in column.into_iter().enumerate() {
            let is_active = row
                .checked_sub(1)
                .is_none_or(|edge| active.iter().any(|crossing| crossing.edge == edge));
            let role = match (row, is_active) {
                (0, _) => Role::Text,
                (_, true) => Role::Chosen,
                (_, false) => Role::Note,
            };
            let start = DVec2::new(left, top + LEADING * row as f64);
            sheet.set_line(line, start, role);
        }
        left += width + GUTTER;
    }
    let rule = top + 0.5 * LEADING;
    sheet.line(
        DVec2::new(frame.max.x - table_width, rule),
        DVec2::new(frame.max.x, rule),
        Pen::new(Role::Grid, THIN),
    );
    Ok(())
}

/// The first row of an edge and the last.
fn rows(edge: &Edge) -> String {
    let (first, last) = (edge.rows.start, edge.rows.end.saturating_sub(1));
    if first == last {
        first.to_string()
    } else {
        format!("{first} … {last}")
    }
}

fn draw_picture(
    sheet: &mut Sheet,
    grid: &Grid,
    on: &[IVec2],
    table: &[Edge],
    active: &[Crossing],
) -> Result<(), FigureError> {
    // Rows above are done; those below are still to come.
    let row = ROW as i32;
    let of = |which: Ordering| -> Vec<IVec2> {
        let pixels = on.iter().filter(|p| p.y.cmp(&row) == which);
        pixels.copied().collect()
    };
    grid.draw_cells(sheet);
    grid.fill(sheet, &of(Ordering::Less), Ink::of(Role::Chosen).tint(0.35));
    grid.fill(sheet, &of(Ordering::Equal), Role::Chosen.into());
    grid.draw_centres(sheet);

    let y = f64::from(ROW) + 0.5;
    let Rect { min, max } = grid.bounds();
    let level = grid.at(DVec2::new(0.0, y)).y;
    sheet.line(
        DVec2::new(min.x, level),
        DVec2::new(max.x, level),
        Pen::new(Role::Note, THIN).dashed(),
    );
    let number = DVec2::new(min.x - 0.6 * NOTE, level);
    sheet.text(number, Align::Right, &ROW.to_string(), LABEL, Role::Chosen)?;

    for (i, edge) in table.iter().enumerate() {
        let is_active = active.iter().any(|crossing| crossing.edge == i);
        let [a, b] = [edge.top, edge.bottom].map(|p| grid.at(p));
        let (role, width) = if is_active {
            (Role::Chosen, NORMAL)
        } else {
            (Role::Text, THIN)
        };
        sheet.line(a, b, Pen::new(role, width));
        let label = Label::new(a.lerp(b, 0.3), format!("*e*_{i}"));
        let aside = if edge.winding > 0 {
            (b - a).perp()
        } else {
            -(b - a).perp()
        };
        sheet.label(label.towards(-aside.normalize_or_zero()).beside());
    }
    for crossing in active {
        marks::point(sheet, grid.at(DVec2::new(crossing.x, y)), Role::Text);
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The crossings by hand: 1.95, 6.757, 8.132, 12.375. Centres between the first two: 5/2 … 13/2; between the others:
    /// 17/2 … 23/2.
    #[test]
    fn the_row_has_two_spans() {
        let contours = [POLYGON.map(DVec2::from).to_vec()];
        let (width, height) = SIZE;
        let table = edge_table(&contours, height).unwrap();
        let edges: Vec<usize> = active_edges(&table, ROW, width)
            .iter()
            .map(|crossing| crossing.edge)
            .collect();
        assert_eq!(edges, [4, 1, 2, 5]);
        let on = pixels(fill(&contours, FillRule::EvenOdd, width, height).unwrap());
        let row = on.iter().filter(|p| p.y == ROW as i32).map(|p| p.x);
        assert!(row.eq((2..=6).chain(8..=11)));
    }
}
