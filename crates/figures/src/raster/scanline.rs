//! One scan line: the edge table, the active edges, the spans between them.

use core::cmp::Ordering;

use ombra_math::glam::{DVec2, IVec2};
use ombra_raster::polygon::{Crossing, Edge, FillRule, active_edges, edge_table, fill};

use super::columns::pixels;
use crate::colour::{Ink, Role};
use crate::drawing::{NORMAL, Pen, THIN};
use crate::error::FigureError;
use crate::figure::{About, Figure, Takes};
use crate::input::{Ask, Inputs};
use crate::marks;
use crate::number::decimal;
use crate::path::{Path, Rect};
use crate::pixels::{BESIDE, Grid, NUMBERS, Orientation};
use crate::sheet::{Align, Label, Sheet};
use crate::text::{LABEL, Line, NOTE};
use crate::words::words;

pub(super) const FIGURE: Figure = Figure {
    id: "raster/scanline",
    takes: Takes::These(&[POLYGON.input, RULE.input, ROW.input]),
    words: WORDS,
    about: |inputs, language| {
        let caption = match rule(inputs) {
            FillRule::EvenOdd => CAPTION,
            FillRule::NonZero => NON_ZERO_CAPTION,
        };
        About::new(language, SUMMARY, caption)
    },
    drawn: draw,
};

words! {
    SUMMARY {
        en: "One scan line: edge table, active edges and the spans between them",
        it: "Una scan-line: tabella dei lati, lati attivi e gli intervalli tra loro",
        cs: "Jeden řádek: tabulka hran, aktivní hrany a úseky mezi nimi",
        hr: "Jedan redak: tablica bridova, aktivni bridovi i rasponi među njima",
    }

    CAPTION {
        en: "The active edges cross the row at the places *X*. Behind an odd number of them, from the left, centres are inside. Rows below are done.",
        it: "I lati attivi incrociano la riga nei punti *X*. Dopo un numero dispari di incroci, da sinistra, i centri sono interni. Le righe sotto sono fatte.",
        cs: "Aktivní hrany protínají řádek v místech *X*. Za lichým počtem z nich, zleva, leží středy uvnitř. Řádky pod ním jsou hotové.",
        hr: "Aktivni bridovi sijeku redak na mjestima *X*. Iza neparnog broja njih, slijeva, središta su unutra. Redci ispod su gotovi.",
    }

    /// The caption under the other rule.
    NON_ZERO_CAPTION {
        en: "The active edges cross the row at the places *X*, up (+1) or down (−1). Where those on the left do not add up to 0, centres are inside. Rows below are done.",
        it: "I lati attivi incrociano la riga nei punti *X*, in su (+1) o in giù (−1). Dove quelli a sinistra non danno somma 0, i centri sono interni. Le righe sotto sono fatte.",
        cs: "Aktivní hrany protínají řádek v místech *X*, nahoru (+1) nebo dolů (−1). Kde součet těch nalevo není 0, leží středy uvnitř. Řádky pod ním jsou hotové.",
        hr: "Aktivni bridovi sijeku redak na mjestima *X*, gore (+1) ili dolje (−1). Gdje zbroj onih slijeva nije 0, središta su unutra. Redci ispod su gotovi.",
    }

    /// An input.
    pub(super) POLYGON_WORD {
        en: "the corners of the polygon, in order",
        it: "i vertici del poligono, in ordine",
        cs: "vrcholy polygonu v pořadí",
        hr: "vrhovi poligona, redom",
    }

    /// An input.
    pub(super) RULE_WORD {
        en: "the rule for what is inside",
        it: "la regola per l’interno",
        cs: "pravidlo pro vnitřek",
        hr: "pravilo za unutrašnjost",
    }

    /// An input.
    ROW_WORD {
        en: "the row looked at",
        it: "la riga considerata",
        cs: "zkoumaný řádek",
        hr: "promatrani redak",
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

/// Pixels across and down.
const SIZE: (u32, u32) = (14, 12);
/// Concave: the row crosses it four times.
const POLYGON: Ask<Vec<DVec2>> = Ask::polygon(
    "polygon",
    "",
    POLYGON_WORD,
    &[
        [1.2, 2.0],
        [4.6, 0.8],
        [7.4, 8.2],
        [10.5, 1.0],
        [13.0, 4.0],
        [11.2, 11.2],
        [2.6, 10.4],
    ],
    [3, 12],
    [[0.0, 0.0], [14.0, 12.0]],
);
const RULE: Ask<&'static str> =
    Ask::choice("rule", "", RULE_WORD, "even-odd", &["even-odd", "non-zero"]);
const ROW: Ask<i32> = Ask::whole("row", "", ROW_WORD, 6, [0, 11]);
/// Between the picture and the table, and from one of its columns to the next.
const GAP: f64 = 70.0;
const GUTTER: f64 = 40.0;
/// From one of its rows to the next: at most, and below the picture.
const LOOSE: f64 = 2.0 * LABEL;
const TIGHT: f64 = 1.35 * LABEL;

/// The rule asked for.
fn rule(inputs: &Inputs) -> FillRule {
    match inputs.get(&RULE) {
        "non-zero" => FillRule::NonZero,
        _ => FillRule::EvenOdd,
    }
}

/// A scan line of a polygon.
struct Scan {
    rule: FillRule,
    row: u32,
    table: Vec<Edge>,
    active: Vec<Crossing>,
    on: Vec<IVec2>,
}

impl Scan {
    fn of(inputs: &Inputs) -> Option<Scan> {
        let contours = [inputs.get(&POLYGON)];
        let (width, height) = SIZE;
        let (rule, row) = (rule(inputs), inputs.get(&ROW).unsigned_abs());
        let table = edge_table(&contours, height).ok()?;
        let on = pixels(fill(&contours, rule, width, height).ok()?);
        let active = active_edges(&table, row, width);
        Some(Scan {
            rule,
            row,
            table,
            active,
            on,
        })
    }
}

fn draw(sheet: &mut Sheet, inputs: &Inputs) -> Result<(), FigureError> {
    let language = sheet.style().language;
    let Some(scan) = Scan::of(inputs) else {
        return Ok(());
    };
    let Scan { table, active, .. } = &scan;

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

    // Beside the picture where the sheet is wide, else below it.
    let frame = sheet.frame();
    let rows = table.len() as f64 + 1.0;
    let is_wide = frame.size().x > 1.2 * frame.size().y;
    let mut room = Rect::new(
        frame.min + DVec2::new(BESIDE, 0.0),
        frame.max - DVec2::new(0.0, NUMBERS),
    );
    if is_wide {
        room.max.x -= table_width + GAP;
    } else {
        room.max.y -= TIGHT * rows;
    }
    let last = IVec2::new(SIZE.0 as i32 - 1, SIZE.1 as i32 - 1);
    let grid = Grid::fit(IVec2::ZERO, last, Orientation::Raised, room);
    draw_picture(sheet, &grid, &scan, &inputs.get(&POLYGON))?;

    let bounds = grid.bounds();
    let (leading, top, mut left) = if is_wide {
        let leading = LOOSE.min(frame.size().y / rows);
        (
            leading,
            frame.centre().y - 0.5 * leading * (rows - 1.0),
            bounds.max.x + GAP,
        )
    } else {
        (
            TIGHT,
            bounds.max.y + NUMBERS + 0.5 * TIGHT,
            frame.centre().x - 0.5 * table_width,
        )
    };
    let line = top + 0.5 * leading;
    sheet.step(1);
    sheet.stroke_unmarked(
        Path::line(DVec2::new(left, line), DVec2::new(left + table_width, line)),
        Pen::new(Role::Grid, THIN),
    );
    for (i, (column, width)) in lines.into_iter().zip(widths).enumerate() {
        // The crossings come with the second step.
        let (step, role) = if i == 2 {
            (2, Role::Chosen)
        } else {
            (1, Role::Text)
        };
        sheet.step(step);
        for (row, line) in (0_u32..).zip(column) {
            let start = DVec2::new(left, top + leading * f64::from(row));
            sheet.set_line(line, start, if row == 0 { Role::Text } else { role });
        }
        left += width + GUTTER;
    }
    sheet.step(0);
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
    scan: &Scan,
    polygon: &[DVec2],
) -> Result<(), FigureError> {
    // Rows below are done; those above are still to come.
    let row = scan.row as i32;
    let of = |which: Ordering| -> Vec<IVec2> {
        let pixels = scan.on.iter().filter(|p| p.y.cmp(&row) == which);
        pixels.copied().collect()
    };
    let y = f64::from(scan.row) + 0.5;
    let Rect { min, max } = grid.bounds();
    let level = grid.at(DVec2::new(0.0, y)).y;
    grid.draw_cells(sheet);
    grid.fill(sheet, &of(Ordering::Less), Ink::of(Role::Chosen).tint(0.3));
    sheet.step(3);
    grid.fill(sheet, &of(Ordering::Equal), Ink::of(Role::Chosen).tint(1.4));
    sheet.step(0);
    grid.draw_centres(sheet);
    grid.number_columns(sheet)?;
    for row in 0..SIZE.1 {
        let number = DVec2::new(min.x - 0.6 * NOTE, grid.centre(IVec2::new(0, row as i32)).y);
        let (size, role) = if row == scan.row {
            (LABEL, Role::Chosen)
        } else {
            (NOTE, Role::Note)
        };
        sheet.text(number, Align::Right, &row.to_string(), size, role)?;
    }
    sheet.line(
        DVec2::new(min.x, level),
        DVec2::new(max.x, level),
        Pen::new(Role::Note, THIN).dashed(),
    );
    grid.polygon(sheet, polygon);
    for (i, edge) in scan.table.iter().enumerate() {
        let [a, b] = [edge.top, edge.bottom].map(|p| grid.at(p));
        if scan.active.iter().any(|crossing| crossing.edge == i) {
            sheet.step(2);
            sheet.line(a, b, Pen::new(Role::Chosen, NORMAL));
        }
        sheet.step(1);
        let label = Label::new(a.lerp(b, 0.3), format!("*e*_{i}"));
        let aside = f64::from(edge.winding.signum()) * (b - a).perp();
        sheet.label(label.towards(aside.normalize_or_zero()).beside());
    }
    sheet.step(2);
    for (i, crossing) in (1..).zip(&scan.active) {
        let at = grid.at(DVec2::new(crossing.x.clamp(0.0, f64::from(SIZE.0)), y));
        marks::point(sheet, at, Role::Text);
        let order = match scan.rule {
            FillRule::EvenOdd => i.to_string(),
            FillRule::NonZero if crossing.winding > 0 => "+1".to_owned(),
            FillRule::NonZero => "−1".to_owned(),
        };
        sheet.label(
            Label::new(at, order)
                .towards(DVec2::NEG_Y)
                .beside()
                .optional(),
        );
    }
    sheet.step(0);
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The crossings by hand: 1.95, 6.757, 8.132, 12.375. Centres between the first two: 5/2 … 13/2; between the others:
    /// 17/2 … 23/2.
    #[test]
    fn the_row_has_two_spans() {
        let scan = Scan::of(&Inputs::default()).unwrap();
        let edges = scan.active.iter().map(|crossing| crossing.edge);
        assert!(edges.eq([4, 1, 2, 5]));
        let row = scan.on.iter().filter(|p| p.y == 6).map(|p| p.x);
        assert!(row.eq((2..=6).chain(8..=11)));
    }
}
