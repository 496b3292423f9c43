//! The nine regions around a window and their codes.

use ombra_clip::Window;
use ombra_clip::cohen_sutherland::outcode;
use ombra_math::glam::DVec2;

use super::board::{Board, window};
use crate::colour::Role;
use crate::error::FigureError;
use crate::figure::{About, Figure, Takes};
use crate::path::Rect;
use crate::sheet::{Align, Sheet};
use crate::text::LABEL;
use crate::words::words;

pub(super) const FIGURE: Figure = Figure {
    id: "clip/outcodes",
    takes: Takes::Nothing(crate::words::FIXED),
    words: WORDS,
    about: |_, language| About::new(language, SUMMARY, CAPTION),
    drawn: |sheet, _| draw(sheet),
};

words! {
    SUMMARY {
        en: "The nine regions around a window and their codes",
        it: "Le nove regioni intorno al rettangolo di clipping e i loro codici",
        cs: "Devět oblastí kolem okna a jejich kódy",
        hr: "Devet područja oko prozora i njihovi kodovi",
    }

    CAPTION {
        en: "Each bit stands for one side: 1 where a point lies beyond it. Inside all are 0.",
        it: "Ogni bit sta per un lato: 1 dove il punto è oltre. All’interno sono tutti 0.",
        cs: "Každý bit patří jedné straně: 1, leží-li bod za ní. Uvnitř jsou všechny 0.",
        hr: "Svaki bit pripada jednoj stranici: 1 ako je točka iza nje. Unutra su svi 0.",
    }

    /// A digit of an outcode.
    BIT {
        en: "bit",
        it: "bit",
        cs: "bit",
        hr: "bit",
    }
}

const WINDOW: Window = window(0.0, 0.0, 10.0, 6.0);
const SHOWN: Window = window(-9.0, -5.4, 19.0, 11.4);
/// Letters of a code, and from one of its digits to the next.
const LARGE: f64 = 2.0 * LABEL;
const DIGIT: f64 = 0.68 * LARGE;

fn draw(sheet: &mut Sheet) -> Result<(), FigureError> {
    let bit = BIT.text(sheet.style().language);
    let frame = sheet.frame();
    // Rows are named on the left, columns below.
    let names = DVec2::new(5.4 * LABEL, 2.7 * LABEL);
    let board = Board::fit(
        WINDOW,
        SHOWN,
        Rect::new(
            frame.min + DVec2::new(names.x, 0.0),
            frame.max - DVec2::new(0.0, names.y),
        ),
    )?;
    board.draw_window(sheet);
    board.draw_lines(sheet);

    let middle = |low: f64, high: f64| 0.5 * (low + high);
    let columns = [
        middle(SHOWN.min.x, WINDOW.min.x),
        middle(WINDOW.min.x, WINDOW.max.x),
        middle(WINDOW.max.x, SHOWN.max.x),
    ];
    let rows = [
        middle(SHOWN.min.y, WINDOW.min.y),
        middle(WINDOW.min.y, WINDOW.max.y),
        middle(WINDOW.max.y, SHOWN.max.y),
    ];
    for y in rows {
        for x in columns {
            let p = DVec2::new(x, y);
            let code = outcode(&WINDOW, p).to_string();
            for (digit, place) in code.chars().zip([-1.5, -0.5, 0.5, 1.5]) {
                let ink = if digit == '1' {
                    Role::Chosen
                } else {
                    Role::Note
                };
                let at = board.at(p) + DVec2::new(DIGIT * place, 0.0);
                sheet.text(at, Align::Centre, &digit.to_string(), LARGE, ink)?;
            }
        }
    }

    let [left, _, right] = columns;
    let [below, _, above] = rows;
    let side = board.at(SHOWN.min);
    for (number, condition, y) in [(1, "*y* > *y*_{max}", above), (2, "*y* < *y*_{min}", below)] {
        let at = DVec2::new(side.x - 0.6 * LABEL, board.at(DVec2::new(0.0, y)).y);
        let half = DVec2::new(0.0, 0.65 * LABEL);
        sheet.text(
            at - half,
            Align::Right,
            &format!("{bit} {number}"),
            LABEL,
            Role::Chosen,
        )?;
        sheet.text(at + half, Align::Right, condition, LABEL, Role::Text)?;
    }
    for (number, condition, x) in [(3, "*x* > *x*_{max}", right), (4, "*x* < *x*_{min}", left)] {
        let at = DVec2::new(board.at(DVec2::new(x, 0.0)).x, side.y + 0.9 * LABEL);
        sheet.text(
            at,
            Align::Centre,
            &format!("{bit} {number}"),
            LABEL,
            Role::Chosen,
        )?;
        let below = DVec2::new(0.0, 1.3 * LABEL);
        sheet.text(at + below, Align::Centre, condition, LABEL, Role::Text)?;
    }
    Ok(())
}
