//! A segment and a polygon, and the pixels that stand for them.

use ombra_math::glam::{DVec2, IVec2};
use ombra_raster::bresenham;
use ombra_raster::polygon::{FillRule, fill};

use super::columns::pixels;
use crate::colour::{Ink, Role};
use crate::drawing::{NORMAL, Pen, THIN};
use crate::error::FigureError;
use crate::figure::{About, Figure, Takes};
use crate::panels::panels;
use crate::path::Path;
use crate::pixels::{Grid, Orientation};
use crate::sheet::Sheet;
use crate::words::words;

pub(super) const FIGURE: Figure = Figure {
    id: "raster/continuous-to-discrete",
    takes: Takes::Nothing(crate::words::FIXED),
    words: WORDS,
    about: |_, language| About::new(language, SUMMARY, CAPTION),
    drawn: |sheet, _| draw(sheet),
};

words! {
    SUMMARY {
        en: "A segment and a polygon, and the pixels that stand for them",
        it: "Un segmento e un poligono, e i pixel che li rappresentano",
        cs: "Úsečka a polygon a pixely, které je zastupují",
        hr: "Dužina i poligon te pikseli koji ih predstavljaju",
    }

    CAPTION {
        en: "On the left, points of the plane; on the right, pixels: samples at whole places, without a size of their own.",
        it: "A sinistra punti del piano, a destra pixel: campioni in posizioni intere, senza dimensione propria.",
        cs: "Vlevo body roviny, vpravo pixely: vzorky v celočíselných místech, bez vlastní velikosti.",
        hr: "Lijevo točke ravnine, desno pikseli: uzorci na cjelobrojnim mjestima, bez vlastite veličine.",
    }

    /// The first picture.
    CONTINUOUS {
        en: "continuous",
        it: "continuo",
        cs: "spojité",
        hr: "kontinuirano",
    }

    /// The second picture.
    DISCRETE {
        en: "discrete: pixels",
        it: "discreto: pixel",
        cs: "diskrétní: pixely",
        hr: "diskretno: pikseli",
    }
}

const SIZE: (u32, u32) = (16, 14);
const SEGMENT: (IVec2, IVec2) = (IVec2::new(1, 12), IVec2::new(14, 7));
const POLYGON: [(f64, f64); 5] = [(4.3, 0.8), (11.6, 1.7), (14.2, 5.3), (7.4, 8.2), (1.6, 6.1)];

fn draw(sheet: &mut Sheet) -> Result<(), FigureError> {
    let language = sheet.style().language;
    let lines = [CONTINUOUS, DISCRETE].map(|word| word.text(language));
    let polygon = POLYGON.map(DVec2::from);
    let (width, height) = SIZE;
    let mut on: Vec<IVec2> = bresenham::segment(SEGMENT.0, SEGMENT.1).collect();
    if let Ok(spans) = fill(&[polygon.to_vec()], FillRule::EvenOdd, width, height) {
        on.extend(pixels(spans));
    }
    let last = IVec2::new(width as i32 - 1, height as i32 - 1);
    for (i, panel) in panels(sheet, &lines, 1.0)?.into_iter().enumerate() {
        let grid = Grid::fit(IVec2::ZERO, last, Orientation::Picture, panel);
        let outline = Path::polygon(&grid.contour(&polygon));
        let [a, b] = [SEGMENT.0, SEGMENT.1].map(|end| grid.centre(end));
        if i == 0 {
            sheet.fill(outline.clone(), Ink::of(Role::Occluder).tint(0.25));
            sheet.stroke(outline, Pen::new(Role::Occluder, NORMAL));
            sheet.line(a, b, Pen::new(Role::Occluder, NORMAL));
        } else {
            grid.draw(sheet, &[(Role::Chosen.into(), &on)]);
            grid.polygon(sheet, &polygon);
            sheet.line(a, b, Pen::new(Role::Text, THIN));
        }
    }
    Ok(())
}
