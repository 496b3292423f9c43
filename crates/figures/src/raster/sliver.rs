//! A long thin triangle: pixels found against area.

use ombra_math::glam::{DVec2, IVec2};
use ombra_raster::triangle::{cover, edge_function};

use super::columns::pixels;
use crate::colour::Role;
use crate::error::FigureError;
use crate::figure::{About, Figure, Takes};
use crate::number::exact;
use crate::path::Rect;
use crate::pixels::{Grid, Orientation};
use crate::sheet::{Align, Sheet};
use crate::text::LABEL;
use crate::words::{PIXELS_OF, words};

pub(super) const FIGURE: Figure = Figure {
    id: "raster/sliver",
    takes: Takes::Nothing(crate::words::FIXED),
    words: WORDS,
    about: |_, language| About::new(language, SUMMARY, CAPTION),
    drawn: |sheet, _| draw(sheet),
};

words! {
    SUMMARY {
        en: "A long thin triangle: pixels found against area",
        it: "Un triangolo stretto e lungo: pixel trovati e area",
        cs: "Dlouhý úzký trojúhelník: nalezené pixely a obsah",
        hr: "Dug i uzak trokut: nađeni pikseli i površina",
    }

    CAPTION {
        en: "The same triangle three times, each time an eighth of a pixel lower. Only centres count, so its pixels depend on where it lies.",
        it: "Lo stesso triangolo tre volte, ogni volta un ottavo di pixel più in basso. Contano solo i centri: i pixel dipendono da dove sta.",
        cs: "Týž trojúhelník třikrát, pokaždé o osminu pixelu níž. Počítají se jen středy, a tak pixely závisejí na jeho poloze.",
        hr: "Isti trokut tri puta, svaki put za osminu piksela niže. Broje se samo središta, pa pikseli ovise o tome gdje leži.",
    }

    /// Before an area.
    AREA {
        en: "area",
        it: "area",
        cs: "obsah",
        hr: "površina",
    }
}

/// Pixels across and down.
const SIZE: (u32, u32) = (20, 3);
/// 18 long and half a pixel wide, so 9/2 in area.
const SLIVER: [(f64, f64); 3] = [(1.0, 1.25), (19.0, 1.5), (19.0, 2.0)];
/// How far it is moved down.
const MOVED: [f64; 3] = [0.0, 0.125, 0.25];
/// The line above each picture.
const HEADING: f64 = 2.2 * LABEL;
const GAP: f64 = 16.0;

fn draw(sheet: &mut Sheet) -> Result<(), FigureError> {
    let language = sheet.style().language;
    let frame = sheet.frame();
    let (width, height) = SIZE;
    let last = IVec2::new(width as i32 - 1, height as i32 - 1);
    let count = MOVED.len() as f64;
    // As high as three fit, or as wide as one does.
    let strip = (frame.size().y - GAP * (count - 1.0)) / count;
    let cell = ((strip - HEADING) / f64::from(height)).min(frame.size().x / f64::from(width));
    let strip = HEADING + cell * f64::from(height);
    let mut top = frame.centre().y - 0.5 * (count * strip + GAP * (count - 1.0));
    for down in MOVED {
        let sliver = SLIVER.map(|p| DVec2::from(p) + DVec2::new(0.0, down));
        let on = cover(sliver, width, height).map_or(Vec::new(), pixels);
        let picture = Rect::new(
            DVec2::new(frame.min.x, top + HEADING),
            DVec2::new(frame.max.x, top + strip),
        );
        let grid = Grid::fit(IVec2::ZERO, last, Orientation::Picture, picture);
        let words = format!(
            "{} {}: {} {}",
            AREA.text(language),
            exact(area(sliver)),
            on.len(),
            PIXELS_OF.text(language),
        );
        let at = DVec2::new(grid.bounds().min.x, top + 0.5 * HEADING);
        sheet.text(at, Align::Left, &words, LABEL, Role::Text)?;
        grid.draw(sheet, &[(Role::Chosen.into(), &on)]);
        grid.polygon(sheet, &sliver);
        top += strip + GAP;
    }
    Ok(())
}

fn area([a, b, c]: [DVec2; 3]) -> f64 {
    0.5 * edge_function(a, b, c).abs()
}
