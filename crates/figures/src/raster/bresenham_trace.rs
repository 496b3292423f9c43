//! A whole segment with the decision of every move.

use ombra_math::glam::IVec2;
use ombra_raster::bresenham::{Choice, Step, trace};

use super::columns::{A, B, Cell, Ends, Row, columns, filled};
use crate::colour::Role;
use crate::error::FigureError;
use crate::figure::{About, Figure, Takes};
use crate::input::Inputs;
use crate::marks;
use crate::number::exact;
use crate::sheet::{Label, Sheet};
use crate::style::Language;
use crate::words::words;

pub(super) const FIGURE: Figure = Figure {
    id: "raster/bresenham-trace",
    takes: Takes::These(&[A.input, B.input]),
    words: WORDS,
    about,
    drawn: draw,
};

words! {
    SUMMARY {
        en: "Bresenham: a whole segment with the decision of every move",
        it: "Bresenham: un intero segmento con la decisione di ogni passo",
        cs: "Bresenham: celá úsečka s rozhodnutím v každém kroku",
        hr: "Bresenham: cijela dužina s odlukom u svakom koraku",
    }

    CAPTION {
        en: "2*F* is an integer: 2*dy* − *dx* = %1 at the start, %2 after E, %3 after NE. Above 0 the next pixel is NE, else E.",
        it: "2*F* è intero: 2*dy* − *dx* = %1 all’inizio, %2 dopo E, %3 dopo NE. Se è positivo si va a NE, altrimenti a E.",
        cs: "2*F* je celé číslo: na začátku 2*dy* − *dx* = %1, %2 po E, %3 po NE. Je-li kladné, následuje NE, jinak E.",
        hr: "2*F* je cijeli broj: na početku 2*dy* − *dx* = %1, %2 nakon E, %3 nakon NE. Ako je pozitivan, slijedi NE, inače E.",
    }

    /// Heading: E or NE.
    MOVE {
        en: "move",
        it: "passo",
        cs: "krok",
        hr: "korak",
    }

    /// Heading: what is added for the next decision.
    ADDED {
        en: "added",
        it: "si somma",
        cs: "přičte se",
        hr: "dodaje se",
    }
}

/// What the decision gains with a move, twice: by its sign.
pub(super) fn gain(ends: Ends, choice: Choice) -> String {
    let [dx, dy] = ends.extent();
    let gain = match choice {
        Choice::E => 2 * dy,
        Choice::NE => 2 * dy - 2 * dx,
    };
    let sign = if gain < 0 { '−' } else { '+' };
    format!("{sign}{}", gain.abs())
}

fn about(inputs: &Inputs, language: Language) -> About {
    let ends = Ends::of(inputs);
    let [dx, dy] = ends.extent();
    let start = exact(f64::from(2 * dy - dx));
    let gains = [Choice::E, Choice::NE].map(|choice| gain(ends, choice));
    let caption = filled(CAPTION, language, &[&start, &gains[0], &gains[1]]);
    let summary = SUMMARY.text(language).to_owned();
    ends.about(About { summary, caption }, language)
}

fn draw(sheet: &mut Sheet, inputs: &Inputs) -> Result<(), FigureError> {
    let language = sheet.style().language;
    let ends = Ends::of(inputs);
    let [east, north] = ends.moves();
    let steps: Vec<Step> = trace(ends.a, ends.b).collect();
    // What is beside a pixel has chosen it; the first is given.
    let chosen = |step: &Step| -> IVec2 {
        match step.choice {
            Choice::E => step.pixel + east,
            Choice::NE => step.pixel + east + north,
        }
    };
    let row = |heading: &str, role: Role, words: &dyn Fn(&Step) -> String| Row {
        heading: heading.to_owned(),
        role,
        cells: (1..)
            .zip(&steps)
            .map(|(i, step)| Cell {
                pixel: chosen(step),
                words: words(step),
                step: i,
            })
            .collect(),
    };
    let table = [
        row("2*F*(*M*)", Role::Text, &|step| exact(step.decision as f64)),
        row(MOVE.text(language), Role::Chosen, &|step| {
            step.choice.to_string()
        }),
        row(ADDED.text(language), Role::Note, &|step| {
            gain(ends, step.choice)
        }),
    ];
    let grid = columns(sheet, ends, &table)?;
    grid.fill(sheet, &[ends.a], Role::Chosen.into());
    for (i, step) in (1..).zip(&steps) {
        sheet.step(i);
        grid.fill(sheet, &[chosen(step)], Role::Chosen.into());
    }
    sheet.step(0);
    grid.draw_centres(sheet);
    grid.line(sheet, ends.a.as_dvec2(), ends.b.as_dvec2());
    for end in [ends.a, ends.b] {
        marks::point(sheet, grid.centre(end), Role::Text);
    }
    for (i, step) in (1..).zip(&steps) {
        sheet.step(i);
        let m = grid.at((step.pixel + east).as_dvec2() + 0.5 * north.as_dvec2());
        // The last midpoint of a level segment lies beside all pixels shown.
        if grid
            .bounds()
            .grown(1.0)
            .contains(&crate::path::Rect::new(m, m))
        {
            marks::hollow_point(sheet, m, Role::Undecided);
            if i == 1 {
                let off = grid.at((step.pixel + east + north).as_dvec2()) - m;
                sheet.label(Label::new(m, "*M*").towards(off).beside());
            }
        }
    }
    Ok(())
}
