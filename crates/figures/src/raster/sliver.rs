//! A long thin triangle: pixels found against area.

use ombra_math::glam::DVec2;
use ombra_raster::triangle::{cover, edge_function};

use super::columns::{counted, pixels};
use crate::colour::Role;
use crate::drawing::{NORMAL, Pen};
use crate::error::FigureError;
use crate::figure::{About, Figure, Takes};
use crate::input::{Ask, Inputs};
use crate::number::exact;
use crate::path::{Path, Rect};
use crate::pixels::{Grid, Orientation};
use crate::sheet::{Align, Sheet};
use crate::text::LABEL;
use crate::words::words;

pub(super) const FIGURE: Figure = Figure {
    id: "raster/sliver",
    takes: Takes::These(&[TRIANGLE.input]),
    words: WORDS,
    about: |_, language| About::new(language, SUMMARY, CAPTION),
    drawn: draw,
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

    /// An input.
    CORNERS {
        en: "the three corners of the triangle",
        it: "i tre vertici del triangolo",
        cs: "tři vrcholy trojúhelníku",
        hr: "tri vrha trokuta",
    }

    /// Before an area.
    AREA {
        en: "area",
        it: "area",
        cs: "obsah",
        hr: "površina",
    }
}

/// 18 long and half a pixel wide, so 9/2 in area.
const TRIANGLE: Ask<Vec<DVec2>> = Ask::polygon(
    "triangle",
    "",
    CORNERS,
    &[[1.0, 1.25], [19.0, 1.5], [19.0, 2.0]],
    [3, 3],
    [[0.0, 0.0], [20.0, 4.0]],
);
/// Pixels across and down, lower places included.
const SIZE: (u32, u32) = (20, 5);
/// How far it is moved down.
const MOVED: [f64; 3] = [0.0, 0.125, 0.25];
/// The line above each picture.
const HEADING: f64 = 2.0 * LABEL;
const GAP: f64 = 16.0;

fn draw(sheet: &mut Sheet, inputs: &Inputs) -> Result<(), FigureError> {
    let language = sheet.style().language;
    let frame = sheet.frame();
    let corners = inputs.get(&TRIANGLE);
    let &[a, b, c] = corners.as_slice() else {
        return Ok(());
    };
    // The pixels that it touches, wherever it is moved.
    let lowest = MOVED.into_iter().fold(0.0, f64::max);
    let least = a.min(b).min(c).floor().as_ivec2();
    let most = a.max(b).max(c) + DVec2::new(0.0, lowest);
    let last = (most.ceil().as_ivec2() - 1).max(least);
    let pixels_shown = (last - least + 1).as_dvec2();

    let count = MOVED.len() as f64;
    // As high as three fit, or as wide as one does.
    let strip = (frame.size().y - GAP * (count - 1.0)) / count;
    let cell = ((strip - HEADING) / pixels_shown.y).min(frame.size().x / pixels_shown.x);
    let strip = HEADING + cell * pixels_shown.y;
    let mut top = frame.centre().y - 0.5 * (count * strip + GAP * (count - 1.0));
    for (i, down) in (1..).zip(MOVED) {
        sheet.step(i);
        let sliver = [a, b, c].map(|p| p + DVec2::new(0.0, down));
        let on = cover(sliver, SIZE.0, SIZE.1).map_or(Vec::new(), pixels);
        let picture = Rect::new(
            DVec2::new(frame.min.x, top + HEADING),
            DVec2::new(frame.max.x, top + strip),
        );
        let grid = Grid::fit(least, last, Orientation::Picture, picture);
        let (area, word) = (exact(area(sliver)), AREA.text(language));
        let words = format!("{word} {area}: {}", counted(on.len(), language));
        let at = DVec2::new(grid.bounds().min.x, top + 0.5 * HEADING);
        sheet.text(at, Align::Left, &words, LABEL, Role::Text)?;
        grid.draw(sheet, &[(Role::Chosen.into(), &on)]);
        let outline = Path::polygon(&grid.contour(&sliver));
        sheet.stroke(outline, Pen::new(Role::Text, NORMAL));
        top += strip + GAP;
    }
    Ok(())
}

fn area([a, b, c]: [DVec2; 3]) -> f64 {
    0.5 * edge_function(a, b, c).abs()
}
