//! The points of the line, and the pixels they are rounded to.

use ombra_math::glam::{DVec2, IVec2};
use ombra_raster::dda::segment;

use super::columns::{Columns, SEGMENT};
use crate::colour::Role;
use crate::drawing::NORMAL;
use crate::error::FigureError;
use crate::figure::{About, Figure, Takes};
use crate::marks;
use crate::number::exact;
use crate::sheet::{Align, Sheet};
use crate::text::LABEL;
use crate::words::words;

pub(super) const FIGURE: Figure = Figure {
    id: "raster/dda-rounding",
    takes: Takes::Nothing(crate::words::FIXED),
    words: WORDS,
    about: |_, language| About::new(language, SUMMARY, CAPTION),
    drawn: |sheet, _| draw(sheet),
};

words! {
    SUMMARY {
        en: "DDA: the points of the line and the pixels they are rounded to",
        it: "DDA: i punti della retta e i pixel a cui si arrotondano",
        cs: "DDA: body přímky a pixely, na které se zaokrouhlí",
        hr: "DDA: točke pravca i pikseli na koje se zaokružuju",
    }

    CAPTION {
        en: "*y*_{*i*+1} = *y*_i + *m* with *m* = 3/8. The nearest pixel is lit; the tie 3/2 goes to the lower one.",
        it: "*y*_{*i*+1} = *y*_i + *m* con *m* = 3/8. Si accende il pixel più vicino; la parità 3/2 va al più basso.",
        cs: "*y*_{*i*+1} = *y*_i + *m*, *m* = 3/8. Rozsvítí se nejbližší pixel; shoda 3/2 patří nižšímu.",
        hr: "*y*_{*i*+1} = *y*_i + *m*, *m* = 3/8. Pali se najbliži piksel; jednakost 3/2 ide nižem.",
    }

    /// One pixel.
    PIXEL_WORD {
        en: "pixel",
        it: "pixel",
        cs: "pixel",
        hr: "piksel",
    }
}

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
    let word = PIXEL_WORD.text(sheet.style().language);
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
