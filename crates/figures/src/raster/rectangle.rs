//! A rectangle along the axes: its outline and its inside.

use ombra_math::glam::{DVec2, IVec2};
use ombra_raster::rectangle::{fill, outline};

use super::columns::{counted, filled};
use crate::colour::Role;
use crate::error::FigureError;
use crate::figure::{About, Figure, Takes};
use crate::input::{Ask, Inputs};
use crate::marks;
use crate::panels::panels;
use crate::path::Rect;
use crate::pixels::{BESIDE, Grid, NUMBERS, Orientation};
use crate::sheet::{Align, Label, Sheet};
use crate::style::Language;
use crate::text::LABEL;
use crate::words::{Word, words};

pub(super) const FIGURE: Figure = Figure {
    id: "raster/rectangle",
    takes: Takes::These(&[A.input, B.input]),
    words: WORDS,
    about,
    drawn: draw,
};

words! {
    SUMMARY {
        en: "A rectangle along the axes, its outline and filled",
        it: "Un rettangolo parallelo agli assi, vuoto e pieno",
        cs: "Obdélník rovnoběžný s osami, obrys a výplň",
        hr: "Pravokutnik usporedan s osima, obris i ispuna",
    }

    CAPTION {
        en: "Both corners are pixels of the rectangle: the columns from %1 to %2 are %2 − %1 + 1 = %3.",
        it: "I due vertici sono pixel del rettangolo: le colonne da %1 a %2 sono %2 − %1 + 1 = %3.",
        cs: "Oba rohy jsou pixely obdélníku: sloupců od %1 do %2 je %2 − %1 + 1 = %3.",
        hr: "Oba su kuta pikseli pravokutnika: stupaca od %1 do %2 ima %2 − %1 + 1 = %3.",
    }

    /// An input.
    CORNER {
        en: "a corner of the rectangle",
        it: "un vertice del rettangolo",
        cs: "roh obdélníku",
        hr: "vrh pravokutnika",
    }

    /// An input.
    OPPOSITE {
        en: "the opposite corner",
        it: "il vertice opposto",
        cs: "protilehlý roh",
        hr: "nasuprotni vrh",
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

/// Where corners may lie: with a row and a column free around.
const RANGE: [[i32; 2]; 2] = [[1, 1], [12, 9]];
const A: Ask<IVec2> = Ask::pixel("a", "*A*", CORNER, [1, 1], RANGE);
const B: Ask<IVec2> = Ask::pixel("b", "*B*", OPPOSITE, [5, 4], RANGE);

fn about(inputs: &Inputs, language: Language) -> About {
    let (a, b) = (inputs.get(&A), inputs.get(&B));
    let (from, to) = (a.x.min(b.x), a.x.max(b.x));
    let values = [from, to, to - from + 1].map(|x| x.to_string());
    let values = values.each_ref().map(String::as_str);
    About {
        summary: SUMMARY.text(language).to_owned(),
        caption: filled(CAPTION, language, &values),
    }
}

fn draw(sheet: &mut Sheet, inputs: &Inputs) -> Result<(), FigureError> {
    let language = sheet.style().language;
    let (a, b) = (inputs.get(&A), inputs.get(&B));
    let (min, max) = (a.min(b), a.max(b));
    let kinds: [(Word, Vec<IVec2>); 2] = [
        (OUTLINE, outline(min, max).collect()),
        (FILLED, fill(min, max).collect()),
    ];
    let lines = kinds
        .each_ref()
        .map(|(word, on)| format!("{}: {}", word.text(language), counted(on.len(), language)));
    let lines = lines.each_ref().map(String::as_str);
    let count = max - min + 1;
    let ratio = f64::from(count.y + 2) / f64::from(count.x + 2);
    let panels = panels(sheet, &lines, ratio.clamp(0.5, 1.2))?;
    for (i, (panel, (_, on))) in panels.into_iter().zip(&kinds).enumerate() {
        sheet.panel(i, panel);
        let frame = Rect::new(
            panel.min + DVec2::new(BESIDE, 0.0),
            panel.max - DVec2::new(0.0, NUMBERS),
        );
        let grid = Grid::fit(min - 1, max + 1, Orientation::Mathematical, frame);
        grid.draw(sheet, &[(Role::Chosen.into(), on)]);
        grid.number_columns(sheet)?;
        grid.number_rows(sheet)?;
        let [low, high] = [min, max].map(|corner| corner.as_dvec2());
        let corners = [
            low,
            DVec2::new(high.x, low.y),
            high,
            DVec2::new(low.x, high.y),
        ];
        grid.polygon(sheet, &corners);
        // Each name in the free cell beyond its corner.
        for (corner, other, name) in [(a, b, "*A*"), (b, a, "*B*")] {
            marks::point(sheet, grid.centre(corner), Role::Text);
            let away =
                |from: i32, to: i32, or: i32| if from == to { or } else { (from - to).signum() };
            let or = if name == "*A*" { -1 } else { 1 };
            let beyond =
                corner + IVec2::new(away(corner.x, other.x, or), away(corner.y, other.y, or));
            sheet.text(grid.centre(beyond), Align::Centre, name, LABEL, Role::Text)?;
        }
        if i == 1 {
            // From border to border: the columns and rows that are counted.
            let at = |x: f64, y: f64| grid.at(DVec2::new(x, y));
            let above = [
                at(low.x - 0.5, high.y + 0.75),
                at(high.x + 0.5, high.y + 0.75),
            ];
            let beside = [
                at(low.x - 0.75, low.y - 0.5),
                at(low.x - 0.75, high.y + 0.5),
            ];
            for (ends, count, towards) in [
                (above, count.x, DVec2::NEG_Y),
                (beside, count.y, DVec2::NEG_X),
            ] {
                let middle = marks::dimension(sheet, ends[0], ends[1], DVec2::ZERO);
                let label = Label::new(middle, count.to_string()).towards(towards);
                sheet.label(label.beside());
            }
        }
    }
    Ok(())
}
