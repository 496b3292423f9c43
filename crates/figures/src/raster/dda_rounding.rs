//! The points of the line, and the pixels they are rounded to.

use ombra_math::glam::IVec2;
use ombra_raster::dda::segment;

use super::columns::{A, B, Cell, Ends, Row, SINGLE, columns, filled, inline};
use crate::colour::Role;
use crate::drawing::NORMAL;
use crate::error::FigureError;
use crate::figure::{About, Figure, Takes};
use crate::input::Inputs;
use crate::marks;
use crate::number::exact;
use crate::sheet::Sheet;
use crate::style::Language;
use crate::words::words;

pub(super) const FIGURE: Figure = Figure {
    id: "raster/dda-rounding",
    takes: Takes::These(&[A.input, B.input]),
    words: WORDS,
    about,
    drawn: draw,
};

words! {
    SUMMARY {
        en: "DDA: the points of the line and the pixels they are rounded to",
        it: "DDA: i punti della retta e i pixel a cui si arrotondano",
        cs: "DDA: body přímky a pixely, na které se zaokrouhlí",
        hr: "DDA: točke pravca i pikseli na koje se zaokružuju",
    }

    CAPTION {
        en: "*%1*_{*i*+1} = *%1*_i + *m* with *m* = %2. The nearest pixel is lit.",
        it: "*%1*_{*i*+1} = *%1*_i + *m* con *m* = %2. Si accende il pixel più vicino.",
        cs: "*%1*_{*i*+1} = *%1*_i + *m*, *m* = %2. Rozsvítí se nejbližší pixel.",
        hr: "*%1*_{*i*+1} = *%1*_i + *m*, *m* = %2. Pali se najbliži piksel.",
    }

    /// Where a point of the line lies half-way between two pixels.
    TIE {
        en: "Half-way, as at %1, the pixel before is kept.",
        it: "A metà strada, come in %1, resta il pixel precedente.",
        cs: "V polovině, jako u %1, zůstane předchozí pixel.",
        hr: "Na pola puta, kao kod %1, ostaje prethodni piksel.",
    }

    /// One pixel.
    PIXEL_WORD {
        en: "pixel",
        it: "pixel",
        cs: "pixel",
        hr: "piksel",
    }
}

/// The other coordinate of the i-th point: the double nearest to it, and whether it is a half.
fn other(ends: Ends, i: i32) -> (f64, bool) {
    let d = ends.b - ends.a;
    let (start, gain, length) = if ends.is_steep() {
        (ends.a.x, d.x, d.y.abs())
    } else {
        (ends.a.y, d.y, d.x.abs())
    };
    if length == 0 {
        return (f64::from(start), false);
    }
    // One division of integers, so that a fraction is what is nearest to it.
    let value = f64::from(start * length + gain * i) / f64::from(length);
    (
        value,
        (2 * gain * i) % length == 0 && (gain * i) % length != 0,
    )
}

fn about(inputs: &Inputs, language: Language) -> About {
    let ends = Ends::of(inputs);
    let summary = SUMMARY.text(language).to_owned();
    let [longer, _] = ends.extent();
    if longer == 0 {
        let caption = SINGLE.text(language).to_owned();
        return About { summary, caption };
    }
    let d = ends.b - ends.a;
    let gain = if ends.is_steep() { d.x } else { d.y };
    let m = inline(&exact(f64::from(gain) / f64::from(longer)));
    let axis = if ends.is_steep() { "x" } else { "y" };
    let caption = filled(CAPTION, language, &[axis, &m]);
    let mut points = (0..=longer).map(|i| other(ends, i));
    let tie = points.find(|(_, tie)| *tie);
    let tie = tie.map(|(y, _)| filled(TIE, language, &[&inline(&exact(y))]));
    About { summary, caption }.and(tie)
}

fn draw(sheet: &mut Sheet, inputs: &Inputs) -> Result<(), FigureError> {
    let ends = Ends::of(inputs);
    let on: Vec<IVec2> = segment(ends.a, ends.b).collect();
    let points: Vec<f64> = (0..).zip(&on).map(|(i, _)| other(ends, i).0).collect();
    let (axis, steep) = if ends.is_steep() {
        ("*x*_i", true)
    } else {
        ("*y*_i", false)
    };
    let row = |heading: &str, role: Role, words: Vec<String>| Row {
        heading: heading.to_owned(),
        role,
        cells: (1..)
            .zip(on.iter().zip(words))
            .map(|(step, (&pixel, words))| Cell { pixel, words, step })
            .collect(),
    };
    let fraction = |&y: &f64| if steep { inline(&exact(y)) } else { exact(y) };
    let lit = |pixel: &IVec2| exact(f64::from(if steep { pixel.x } else { pixel.y }));
    let table = [
        row(axis, Role::Text, points.iter().map(fraction).collect()),
        row(
            PIXEL_WORD.text(sheet.style().language),
            Role::Chosen,
            on.iter().map(lit).collect(),
        ),
    ];
    let grid = columns(sheet, ends, &table)?;
    for (i, &pixel) in (1..).zip(&on) {
        sheet.step(i);
        grid.fill(sheet, &[pixel], Role::Chosen.into());
    }
    sheet.step(0);
    grid.draw_centres(sheet);
    grid.line(sheet, ends.a.as_dvec2(), ends.b.as_dvec2());
    for (i, (&pixel, &y)) in (1..).zip(on.iter().zip(&points)) {
        sheet.step(i);
        let mut place = pixel.as_dvec2();
        if steep {
            place.x = y;
        } else {
            place.y = y;
        }
        let place = grid.at(place);
        if place != grid.centre(pixel) {
            marks::arrow(sheet, place, grid.centre(pixel), Role::Text, NORMAL);
        }
        marks::hollow_point(sheet, place, Role::Undecided);
    }
    sheet.step(0);
    Ok(())
}
