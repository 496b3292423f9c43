//! A pixel a column for gentle segments, a pixel a row for steep ones.

use ombra_math::glam::{DVec2, IVec2};
use ombra_raster::bresenham::segment;

use super::columns::{A, B, Ends};
use crate::colour::Role;
use crate::drawing::{NORMAL, Pen};
use crate::error::FigureError;
use crate::figure::{About, Figure, Takes};
use crate::input::Inputs;
use crate::marks;
use crate::panels::panels;
use crate::path::Rect;
use crate::pixels::{BESIDE, Grid, NUMBERS, Orientation};
use crate::sheet::Sheet;
use crate::words::words;

pub(super) const FIGURE: Figure = Figure {
    id: "raster/segment-slopes",
    takes: Takes::These(&[A.input, B.input]),
    words: WORDS,
    about: |_, language| About::new(language, SUMMARY, CAPTION),
    drawn: draw,
};

words! {
    SUMMARY {
        en: "Gentle segments have a pixel a column, steep ones a pixel a row",
        it: "Un pixel per colonna nei segmenti poco inclinati, uno per riga in quelli ripidi",
        cs: "Pozvolné úsečky mají pixel v každém sloupci, strmé v každém řádku",
        hr: "Blage dužine imaju piksel u svakom stupcu, strme u svakom retku",
    }

    CAPTION {
        en: "One step along the longer axis, one pixel: no gaps and no doubles. A pixel a column leaves holes in a steep segment.",
        it: "Un passo lungo l’asse maggiore, un pixel: niente buchi né doppioni. Un pixel per colonna bucherebbe un segmento ripido.",
        cs: "Jeden krok podél delší osy, jeden pixel: žádné mezery ani dvojice. Pixel v každém sloupci nechá ve strmé úsečce mezery.",
        hr: "Jedan korak uzduž dulje osi, jedan piksel: bez rupa i bez dvostrukih. Piksel u svakom stupcu ostavlja rupe u strmoj dužini.",
    }

    /// The first picture; %1 is a relation.
    COLUMNS {
        en: "%1: a pixel a column",
        it: "%1: un pixel per colonna",
        cs: "%1: pixel na sloupec",
        hr: "%1: piksel po stupcu",
    }

    /// The second picture.
    HOLES {
        en: "a pixel a column: holes",
        it: "uno per colonna: buchi",
        cs: "pixel na sloupec: mezery",
        hr: "piksel po stupcu: rupe",
    }

    /// The third picture.
    ROWS {
        en: "%1: a pixel a row",
        it: "%1: un pixel per riga",
        cs: "%1: pixel na řádek",
        hr: "%1: piksel po retku",
    }
}

fn draw(sheet: &mut Sheet, inputs: &Inputs) -> Result<(), FigureError> {
    let language = sheet.style().language;
    // The segment asked for and the one with x and y exchanged: the gentler, then the steeper.
    let ends = Ends::of(inputs);
    let exchanged = Ends {
        a: IVec2::new(ends.a.y, ends.a.x),
        b: IVec2::new(ends.b.y, ends.b.x),
    };
    let (gentle, steep) = if ends.is_steep() {
        (exchanged, ends)
    } else {
        (ends, exchanged)
    };
    let all = |ends: Ends| segment(ends.a, ends.b).collect::<Vec<IVec2>>();
    let a_column = a_column(steep);
    let mut holes = all(steep);
    holes.retain(|pixel| !a_column.contains(pixel));

    let relation = |sign: &str| format!("\\|*m*\\|\u{a0}{sign}\u{a0}1");
    let (below, above) = if steep.is_steep() {
        ("≤", ">")
    } else {
        ("=", "=")
    };
    let lines = [(COLUMNS, below), (HOLES, above), (ROWS, above)]
        .map(|(word, sign)| word.text(language).replace("%1", &relation(sign)));
    let pictures = [
        (gentle, false, all(gentle)),
        (steep, false, a_column),
        (steep, true, all(steep)),
    ];
    // Segments without a slope of their own show no holes.
    let shown = |i: &usize| *i == 0 || steep.is_steep();
    let kept: Vec<usize> = (0..3).filter(shown).collect();
    let lines: Vec<&str> = kept.iter().map(|&i| lines[i].as_str()).collect();
    let panels = panels(sheet, &lines, 1.5)?;
    for (n, (panel, &i)) in panels.into_iter().zip(&kept).enumerate() {
        let (ends, rows, on) = &pictures[i];
        sheet.panel(n, panel);
        let grid = draw_pixels(sheet, panel, *ends, *rows, on)?;
        if i == 1 {
            let cells = grid.cells(&holes);
            sheet.stroke_unmarked(cells, Pen::new(Role::Rejected, NORMAL).dashed());
            grid.cross(sheet, &holes, Pen::new(Role::Undecided, NORMAL));
        }
    }
    Ok(())
}

/// Pixels shown across and down, at least.
const LEAST: i32 = 5;

/// What a pixel a column gives: the nearest to the line, of two equally near the one before.
fn a_column(ends: Ends) -> Vec<IVec2> {
    let d = ends.b - ends.a;
    let length = d.x.abs();
    let nearest = |i: i32| {
        // The greatest integer not above dy i / dx + ½, in size; at a half the one below.
        let up = (2 * d.y.abs() * i + length - 1)
            .checked_div(2 * length)
            .unwrap_or(0);
        ends.a + IVec2::new(d.x.signum() * i, d.y.signum() * up)
    };
    (0..=length).map(nearest).collect()
}

fn draw_pixels(
    sheet: &mut Sheet,
    panel: Rect,
    ends: Ends,
    rows: bool,
    on: &[IVec2],
) -> Result<Grid, FigureError> {
    let frame = Rect::new(
        panel.min + DVec2::new(BESIDE, 0.0),
        panel.max - DVec2::new(0.0, NUMBERS),
    );
    // A little room beside the segment.
    let (min, max) = (ends.a.min(ends.b), ends.a.max(ends.b));
    let corner = max.max(min + LEAST - 1);
    let grid = Grid::fit(min, corner, Orientation::Mathematical, frame);
    // Every other column, or row, on darker ground.
    let every = (min.x..=corner.x).flat_map(|x| (min.y..=corner.y).map(move |y| IVec2::new(x, y)));
    let striped = |p: &IVec2| (if rows { p.y } else { p.x }) % 2 == 0;
    let stripes: Vec<IVec2> = every.filter(striped).collect();
    sheet.fill(grid.cells(&stripes), Role::Ground);
    grid.draw(sheet, &[(Role::Chosen.into(), on)]);
    if rows {
        grid.number_rows(sheet)?;
    } else {
        grid.number_columns(sheet)?;
    }
    grid.line(sheet, ends.a.as_dvec2(), ends.b.as_dvec2());
    for end in [ends.a, ends.b] {
        marks::point(sheet, grid.centre(end), Role::Text);
    }
    Ok(grid)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// y = 8x/3 by hand: 0, 8/3, 16/3, 8.
    #[test]
    fn a_pixel_a_column_leaves_holes_in_a_steep_segment() {
        let ends = |x, y| Ends {
            a: IVec2::ZERO,
            b: IVec2::new(x, y),
        };
        let pixels = [(0, 0), (1, 3), (2, 5), (3, 8)].map(|(x, y)| IVec2::new(x, y));
        assert_eq!(a_column(ends(3, 8)), pixels);
        // Where the segment is gentle it is what the library gives, whatever the direction.
        for (x, y) in [(8, 3), (-8, 3), (8, -3), (-7, -7), (12, 6), (5, 0), (0, 0)] {
            let all: Vec<IVec2> = segment(IVec2::ZERO, IVec2::new(x, y)).collect();
            assert_eq!(a_column(ends(x, y)), all);
        }
        assert_eq!(a_column(ends(0, 9)), [IVec2::ZERO]);
    }
}
