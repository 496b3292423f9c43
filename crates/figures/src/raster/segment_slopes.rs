//! A pixel a column for gentle segments, a pixel a row for steep ones.

use ombra_math::glam::{DVec2, IVec2};
use ombra_raster::bresenham::segment;

use super::columns::SEGMENT;
use crate::colour::Role;
use crate::error::FigureError;
use crate::figure::{About, Figure, Takes};
use crate::marks;
use crate::panels::panels;
use crate::path::Rect;
use crate::pixels::{Grid, NUMBERS, Orientation};
use crate::sheet::Sheet;
use crate::words::words;

pub(super) const FIGURE: Figure = Figure {
    id: "raster/segment-slopes",
    takes: Takes::Nothing(crate::words::FIXED),
    words: WORDS,
    about: |_, language| About::new(language, SUMMARY, CAPTION),
    drawn: |sheet, _| draw(sheet),
};

words! {
    SUMMARY {
        en: "Gentle segments have a pixel a column, steep ones a pixel a row",
        it: "Un pixel per colonna nei segmenti poco inclinati, uno per riga in quelli ripidi",
        cs: "Pozvolné úsečky mají pixel v každém sloupci, strmé v každém řádku",
        hr: "Blage dužine imaju piksel u svakom stupcu, strme u svakom retku",
    }

    CAPTION {
        en: "One step along the longer axis, one pixel: no gaps and no doubles.",
        it: "Un passo lungo l’asse maggiore, un pixel: niente buchi né doppioni.",
        cs: "Jeden krok podél delší osy, jeden pixel: žádné mezery ani dvojice.",
        hr: "Jedan korak uzduž dulje osi, jedan piksel: bez rupa i bez dvostrukih.",
    }

    /// The first picture.
    COLUMNS {
        en: "\\|*m*\\|\u{a0}≤\u{a0}1: a pixel a column",
        it: "\\|*m*\\|\u{a0}≤\u{a0}1: un pixel per colonna",
        cs: "\\|*m*\\|\u{a0}≤\u{a0}1: pixel v každém sloupci",
        hr: "\\|*m*\\|\u{a0}≤\u{a0}1: piksel u svakom stupcu",
    }

    /// The second picture.
    ROWS {
        en: "\\|*m*\\|\u{a0}>\u{a0}1: a pixel a row",
        it: "\\|*m*\\|\u{a0}>\u{a0}1: un pixel per riga",
        cs: "\\|*m*\\|\u{a0}>\u{a0}1: pixel v každém řádku",
        hr: "\\|*m*\\|\u{a0}>\u{a0}1: piksel u svakom retku",
    }
}

fn draw(sheet: &mut Sheet) -> Result<(), FigureError> {
    let language = sheet.style().language;
    let lines = [COLUMNS, ROWS].map(|word| word.text(language));
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
