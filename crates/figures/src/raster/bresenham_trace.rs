//! A whole segment with the decision of every move.

use ombra_math::glam::{DVec2, IVec2};
use ombra_raster::bresenham::{segment, trace};

use super::columns::{Columns, SEGMENT};
use crate::colour::Role;
use crate::error::FigureError;
use crate::figure::{About, Figure, Takes};
use crate::marks;
use crate::number::exact;
use crate::pixels::NUMBERS;
use crate::sheet::{Label, Sheet};
use crate::words::words;

pub(super) const FIGURE: Figure = Figure {
    id: "raster/bresenham-trace",
    takes: Takes::Nothing(crate::words::FIXED),
    words: WORDS,
    about: |_, language| About::new(language, SUMMARY, CAPTION),
    drawn: |sheet, _| draw(sheet),
};

words! {
    SUMMARY {
        en: "Bresenham: a whole segment with the decision of every move",
        it: "Bresenham: un intero segmento con la decisione di ogni passo",
        cs: "Bresenham: celá úsečka s rozhodnutím v každém kroku",
        hr: "Bresenham: cijela dužina s odlukom u svakom koraku",
    }

    CAPTION {
        en: "2*F* is an integer: 2*dy* − *dx* = −2 at the start, + 6 after E, − 10 after NE. Above 0 the next pixel is NE, else E.",
        it: "2*F* è intero: 2*dy* − *dx* = −2 all’inizio, + 6 dopo E, − 10 dopo NE. Se è positivo si va a NE, altrimenti a E.",
        cs: "2*F* je celé číslo: na začátku 2*dy* − *dx* = −2, + 6 po E, − 10 po NE. Je-li kladné, následuje NE, jinak E.",
        hr: "2*F* je cijeli broj: na početku 2*dy* − *dx* = −2, + 6 nakon E, − 10 nakon NE. Ako je pozitivan, slijedi NE, inače E.",
    }
}

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
