//! A rectangle along the axes: its outline and its inside.

use ombra_math::glam::{DVec2, IVec2};
use ombra_raster::rectangle::{fill, outline};

use crate::colour::Role;
use crate::error::FigureError;
use crate::figure::{About, Figure, Takes};
use crate::marks;
use crate::panels::panels;
use crate::path::Rect;
use crate::pixels::{Grid, NUMBERS, Orientation};
use crate::sheet::{Label, Sheet};
use crate::words::{PIXELS_OF, Word, words};

pub(super) const FIGURE: Figure = Figure {
    id: "raster/rectangle",
    takes: Takes::Nothing(crate::words::FIXED),
    words: WORDS,
    about: |_, language| About::new(language, SUMMARY, CAPTION),
    drawn: |sheet, _| draw(sheet),
};

words! {
    SUMMARY {
        en: "A rectangle along the axes, its outline and filled",
        it: "Un rettangolo parallelo agli assi, vuoto e pieno",
        cs: "Obdélník rovnoběžný s osami, obrys a výplň",
        hr: "Pravokutnik usporedan s osima, obris i ispuna",
    }

    CAPTION {
        en: "Both corners are pixels of the rectangle: columns 1 to 5 are five columns, not four.",
        it: "I due vertici sono pixel del rettangolo: le colonne da 1 a 5 sono cinque, non quattro.",
        cs: "Oba rohy jsou pixely obdélníku: sloupce 1 až 5 jsou pět sloupců, ne čtyři.",
        hr: "Oba su kuta pikseli pravokutnika: od stupca 1 do 5 ima ih pet, a ne četiri.",
    }

    /// The first picture.
    OUTLINE {
        en: "outline",
        it: "vuoto",
        cs: "obrys",
        hr: "obris",
    }

    /// The second picture.
    FILLED {
        en: "filled",
        it: "pieno",
        cs: "výplň",
        hr: "ispuna",
    }
}

const MIN: IVec2 = IVec2::new(1, 1);
const MAX: IVec2 = IVec2::new(5, 4);

fn draw(sheet: &mut Sheet) -> Result<(), FigureError> {
    let language = sheet.style().language;
    let kinds: [(Word, Vec<IVec2>); 2] = [
        (OUTLINE, outline(MIN, MAX).collect()),
        (FILLED, fill(MIN, MAX).collect()),
    ];
    let pixels = PIXELS_OF.text(language);
    let lines = kinds
        .each_ref()
        .map(|(word, on)| format!("{}: {}\u{a0}{pixels}", word.text(language), on.len()));
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
