//! A segment and a polygon, and the pixels that stand for them.

use ombra_math::glam::{DVec2, IVec2};
use ombra_raster::bresenham;
use ombra_raster::polygon::{FillRule, fill};

use super::columns::{FIRST_END, LAST_END, pixels};
use super::scanline::POLYGON_WORD;
use crate::colour::{Ink, Role};
use crate::drawing::{EMPHASIS, NORMAL, Pen};
use crate::error::FigureError;
use crate::figure::{About, Figure, Takes};
use crate::input::{Ask, Inputs};
use crate::panels::panels;
use crate::path::Path;
use crate::pixels::{Grid, Orientation};
use crate::sheet::Sheet;
use crate::words::words;

pub(super) const FIGURE: Figure = Figure {
    id: "raster/continuous-to-discrete",
    takes: Takes::These(&[A.input, B.input, POLYGON.input]),
    words: WORDS,
    about: |_, language| About::new(language, SUMMARY, CAPTION),
    drawn: draw,
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

/// Pixels across and down.
const SIZE: (u32, u32) = (13, 10);
const ENDS: [[i32; 2]; 2] = [[0, 0], [12, 9]];
const A: Ask<IVec2> = Ask::pixel("a", "*A*", FIRST_END, [1, 0], ENDS);
const B: Ask<IVec2> = Ask::pixel("b", "*B*", LAST_END, [11, 2], ENDS);
const POLYGON: Ask<Vec<DVec2>> = Ask::polygon(
    "polygon",
    "",
    POLYGON_WORD,
    &[[3.3, 9.4], [9.6, 8.6], [12.4, 5.7], [6.4, 3.4], [0.7, 5.4]],
    [3, 12],
    [[0.0, 0.0], [13.0, 10.0]],
);

fn draw(sheet: &mut Sheet, inputs: &Inputs) -> Result<(), FigureError> {
    let language = sheet.style().language;
    let lines = [CONTINUOUS, DISCRETE].map(|word| word.text(language));
    let (a, b, polygon) = (inputs.get(&A), inputs.get(&B), inputs.get(&POLYGON));
    let (width, height) = SIZE;
    let mut on: Vec<IVec2> = bresenham::segment(a, b).collect();
    if let Ok(spans) = fill(
        core::slice::from_ref(&polygon),
        FillRule::EvenOdd,
        width,
        height,
    ) {
        on.extend(
            pixels(spans)
                .into_iter()
                .filter(|pixel| !on.contains(pixel))
                .collect::<Vec<_>>(),
        );
    }
    let last = IVec2::new(width as i32 - 1, height as i32 - 1);
    let ratio = f64::from(height) / f64::from(width);
    for (i, panel) in panels(sheet, &lines, ratio)?.into_iter().enumerate() {
        sheet.panel(i, panel);
        let grid = Grid::fit(IVec2::ZERO, last, Orientation::Raised, panel);
        let outline = Path::polygon(&grid.contour(&polygon));
        let [a, b] = [a, b].map(|end| grid.centre(end));
        if i == 0 {
            let area = (
                Ink::of(Role::Occluder).tint(0.25).into(),
                crate::drawing::FillRule::EvenOdd,
            );
            sheet.shape(outline, Some(area), Some(Pen::new(Role::Occluder, NORMAL)));
            sheet.line(a, b, Pen::new(Role::Occluder, EMPHASIS));
        } else {
            grid.draw(sheet, &[(Role::Chosen.into(), &on)]);
            sheet.stroke(outline, Pen::new(Role::Text, NORMAL));
            sheet.line(a, b, Pen::new(Role::Text, NORMAL));
        }
    }
    Ok(())
}
