//! The four inequalities of a point in the window.

use ombra_clip::Window;
use ombra_math::glam::DVec2;

use super::board::{Board, NAMES, window};
use crate::colour::Role;
use crate::error::FigureError;
use crate::figure::{About, Figure, Takes};
use crate::marks;
use crate::path::Rect;
use crate::sheet::{Align, Label, Sheet};
use crate::text::LABEL;
use crate::words::words;

pub(super) const FIGURE: Figure = Figure {
    id: "clip/point-window",
    takes: Takes::Nothing(crate::words::FIXED),
    words: WORDS,
    about: |_, language| About::new(language, SUMMARY, CAPTION),
    drawn: |sheet, _| draw(sheet),
};

words! {
    SUMMARY {
        en: "A point and the window: four inequalities",
        it: "Un punto e il rettangolo di clipping: quattro disuguaglianze",
        cs: "Bod a okno: čtyři nerovnosti",
        hr: "Točka i prozor: četiri nejednakosti",
    }

    CAPTION {
        en: "A point is inside when all four hold; the border belongs to the window.",
        it: "Un punto è interno se valgono tutte e quattro; il bordo appartiene al rettangolo.",
        cs: "Bod leží uvnitř, platí-li všechny čtyři; hranice patří k oknu.",
        hr: "Točka je unutra ako vrijede sve četiri; rub pripada prozoru.",
    }
}

const WINDOW: Window = window(0.0, 0.0, 10.0, 6.0);
const SHOWN: Window = window(-4.5, -1.8, 14.5, 8.2);
/// Inside, on the border, and beyond one side or two.
const POINTS: [(f64, f64); 5] = [
    (3.0, 3.6),
    (10.0, 2.2),
    (12.0, 4.4),
    (6.5, -1.0),
    (-2.3, 7.1),
];
/// Letters of the four inequalities.
const LARGE: f64 = 1.25 * LABEL;

fn draw(sheet: &mut Sheet) -> Result<(), FigureError> {
    let frame = sheet.frame();
    let left = 2.6 * LABEL;
    let below = 3.6 * LARGE;
    let board = Board::fit(
        WINDOW,
        SHOWN,
        Rect::new(
            frame.min + DVec2::new(left, 0.0),
            frame.max - DVec2::new(left, below),
        ),
    )?;
    board.draw_window(sheet);
    board.draw_lines(sheet);
    for (i, ([a, _], name)) in board.lines().into_iter().zip(NAMES).enumerate() {
        // Levels are named on their left, uprights below.
        let (align, off) = if i < 2 {
            (Align::Right, DVec2::new(-12.0, 0.0))
        } else {
            (Align::Below, DVec2::new(0.0, 10.0))
        };
        sheet.text(board.at(a) + off, align, name, LABEL, Role::Text)?;
    }

    for (x, y) in POINTS {
        let p = DVec2::new(x, y);
        let at = board.at(p);
        if WINDOW.contains(p) {
            marks::point(sheet, at, Role::Chosen);
        } else {
            marks::hollow_point(sheet, at, Role::Rejected);
            for (inequality, towards) in broken(p).into_iter().zip([DVec2::Y, DVec2::NEG_Y]) {
                let label = Label::new(at, inequality).towards(towards);
                sheet.label(label.ink(Role::Rejected));
            }
        }
    }
    let inequalities = "*x*_{min} ≤ *x* ≤ *x*_{max}      *y*_{min} ≤ *y* ≤ *y*_{max}";
    let at = DVec2::new(frame.centre().x, frame.max.y - 0.5 * LARGE);
    sheet.text(at, Align::Above, inequalities, LARGE, Role::Chosen)?;
    Ok(())
}

/// The inequalities that do not hold, turned round.
fn broken(p: DVec2) -> Vec<&'static str> {
    [
        (p.x < WINDOW.min.x, "*x* < *x*_{min}"),
        (p.x > WINDOW.max.x, "*x* > *x*_{max}"),
        (p.y < WINDOW.min.y, "*y* < *y*_{min}"),
        (p.y > WINDOW.max.y, "*y* > *y*_{max}"),
    ]
    .into_iter()
    .filter_map(|(is_broken, name)| is_broken.then_some(name))
    .collect()
}
