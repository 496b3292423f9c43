//! The nine regions around a window and their codes.

use ombra_clip::Window;
use ombra_clip::cohen_sutherland::outcode;
use ombra_math::glam::DVec2;

use super::board::{Board, window};
use crate::colour::{Ink, Role};
use crate::drawing::{NORMAL, Pen};
use crate::error::FigureError;
use crate::figure::{About, Figure, Takes};
use crate::input::{Ask, Inputs};
use crate::marks;
use crate::path::{Path, Rect};
use crate::sheet::{Align, Label, Sheet};
use crate::text::LABEL;
use crate::words::words;

pub(super) const FIGURE: Figure = Figure {
    id: "clip/outcodes",
    takes: Takes::These(&[P.input]),
    words: WORDS,
    about: |inputs, language| {
        let code = outcode(&WINDOW, inputs.get(&P)).to_string();
        let point = CODE_OF_P.text(language).replace("%1", &code);
        About::new(language, SUMMARY, CAPTION).and(Some(point))
    },
    drawn: draw,
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

    /// On the point.
    CODE_OF_P {
        en: "Here *P* has the code %1.",
        it: "Qui *P* ha il codice %1.",
        cs: "Zde má *P* kód %1.",
        hr: "Ovdje *P* ima kod %1.",
    }

    /// An input.
    POINT {
        en: "the point whose code is shown",
        it: "il punto di cui si mostra il codice",
        cs: "bod, jehož kód se ukazuje",
        hr: "točka čiji se kod prikazuje",
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
const P: Ask<DVec2> = Ask::point(
    "p",
    "*P*",
    POINT,
    [17.2, 10.0],
    [[-9.0, -5.4], [19.0, 11.4]],
);
/// Letters of a code, and from one of its digits to the next.
const LARGE: f64 = 2.0 * LABEL;
const DIGIT: f64 = 0.68 * LARGE;

fn draw(sheet: &mut Sheet, inputs: &Inputs) -> Result<(), FigureError> {
    let bit = BIT.text(sheet.style().language);
    let frame = sheet.frame();
    // Rows are named on the left, columns below.
    let names = DVec2::new(5.4 * LABEL, 3.0 * LABEL);
    let board = Board::fit(
        WINDOW,
        SHOWN,
        Rect::new(
            frame.min + DVec2::new(names.x, 0.0),
            frame.max - DVec2::new(0.0, names.y),
        ),
    )?;
    board.draw_window(sheet);
    // The region of the point, and the point, come last.
    let p = inputs.get(&P);
    sheet.step(5);
    let region = board.contour(&super::board::corners(&region(p)));
    sheet.fill(Path::polygon(&region), Ink::of(Role::Chosen).alpha(0.14));
    sheet.step(0);
    board.draw_lines(sheet);
    sheet.step(5);
    sheet.stroke(Path::polygon(&region), Pen::new(Role::Chosen, NORMAL));

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
            let places = [-1.5, -0.5, 0.5, 1.5].into_iter().enumerate();
            for (digit, (i, place)) in code.chars().zip(places) {
                // Bit by bit.
                sheet.step(i + 1);
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
        sheet.step(number);
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
        sheet.step(number);
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
    sheet.step(5);
    marks::point(sheet, board.at(p), Role::Chosen);
    let label = Label::new(board.at(p), "*P*").ink(Role::Chosen);
    sheet.label(label.beside());
    Ok(())
}

/// The region of a point: the part of what is shown where all have its code.
fn region(p: DVec2) -> Window {
    let along = |x: f64, [start, low, high, end]: [f64; 4]| {
        if x < low {
            [start, low]
        } else if x > high {
            [high, end]
        } else {
            [low, high]
        }
    };
    let [left, right] = along(p.x, [SHOWN.min.x, WINDOW.min.x, WINDOW.max.x, SHOWN.max.x]);
    let [below, above] = along(p.y, [SHOWN.min.y, WINDOW.min.y, WINDOW.max.y, SHOWN.max.y]);
    window(left, below, right, above)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_region_is_where_the_code_is_one() {
        for (x, y) in [
            (-9.0, -5.4),
            (0.0, 6.0),
            (10.0, 6.1),
            (-0.1, 3.0),
            (19.0, 11.4),
            (4.0, 3.0),
        ] {
            let p = DVec2::new(x, y);
            let region = region(p);
            assert!(region.contains(p));
            let middle = 0.5 * (region.min + region.max);
            assert_eq!(outcode(&WINDOW, middle), outcode(&WINDOW, p), "{p}");
        }
    }
}
