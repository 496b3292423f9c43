//! Sutherland–Hodgman: a polygon after each of the four lines.

use ombra_clip::Window;
use ombra_clip::sutherland_hodgman::{HalfPlane, clip_against_line};
use ombra_math::glam::DVec2;

use super::board::{Board, NAMES, POLYGON_WORD, RANGE, asked, between, shown};
use crate::colour::Role;
use crate::drawing::{NORMAL, Pen};
use crate::error::FigureError;
use crate::figure::{About, Figure, Takes};
use crate::input::{Ask, Inputs};
use crate::marks;
use crate::panels::panels;
use crate::path::Path;
use crate::sheet::Sheet;
use crate::words::words;

pub(super) const FIGURE: Figure = Figure {
    id: "clip/sutherland-hodgman-steps",
    takes: Takes::These(&[POLYGON.input, WINDOW.input]),
    words: WORDS,
    about: |_, language| About::new(language, SUMMARY, CAPTION),
    drawn: draw,
};

words! {
    SUMMARY {
        en: "Sutherland–Hodgman: a polygon after each of the four lines",
        it: "Sutherland–Hodgman: un poligono dopo ognuna delle quattro rette",
        cs: "Sutherland–Hodgman: polygon po každé ze čtyř přímek",
        hr: "Sutherland–Hodgman: poligon nakon svakog od četiri pravca",
    }

    CAPTION {
        en: "Each line keeps what lies on its inner side; what is left goes on to the next.",
        it: "Ogni retta conserva ciò che sta dalla sua parte interna; ciò che resta passa alla successiva.",
        cs: "Každá přímka ponechá, co leží na její vnitřní straně; zbytek jde k další.",
        hr: "Svaki pravac zadržava što je na njegovoj unutarnjoj strani; ostatak ide na sljedeći.",
    }

    /// The first picture.
    GIVEN {
        en: "the polygon",
        it: "il poligono",
        cs: "polygon",
        hr: "poligon",
    }

    /// After a line, where it leaves nothing.
    NOTHING {
        en: "nothing is left",
        it: "non resta nulla",
        cs: "nic nezbývá",
        hr: "ništa ne ostaje",
    }
}

/// A star with a tip beyond each side.
const POLYGON: Ask<Vec<DVec2>> = Ask::polygon(
    "polygon",
    "",
    POLYGON_WORD,
    &[
        [4.0, 13.2],
        [3.2, 7.0],
        [-3.2, 6.0],
        [3.2, 3.4],
        [5.8, -3.2],
        [6.8, 3.0],
        [13.2, 4.4],
        [6.6, 6.8],
    ],
    [3, 24],
    RANGE,
);
const WINDOW: Ask<Vec<DVec2>> = asked(&[[0.0, 0.0], [10.0, 10.0]]);
/// Free around window and polygon.
const AROUND: f64 = 0.05;
/// What holds on the inner side of each line.
const HOLDS: [&str; 4] = ["*y* ≤ ", "*y* ≥ ", "*x* ≤ ", "*x* ≥ "];

fn draw(sheet: &mut Sheet, inputs: &Inputs) -> Result<(), FigureError> {
    let language = sheet.style().language;
    let window = between(&inputs.get(&WINDOW));
    let given = inputs.get(&POLYGON);
    let left = after_each_line(&window, &given);
    let mut lines = vec![GIVEN.text(language).to_owned()];
    for ((holds, name), kept) in HOLDS.into_iter().zip(NAMES).zip(&left) {
        let mut line = format!("{holds}{name}");
        if kept.is_empty() {
            line = format!("{line}: {}", NOTHING.text(language));
        }
        lines.push(line);
    }
    let lines: Vec<&str> = lines.iter().map(String::as_str).collect();
    let shown = shown(&window, &given, AROUND);
    let size = shown.max - shown.min;
    let panels = panels(sheet, &lines, (size.y / size.x).clamp(0.5, 2.0))?;

    let mut before = &given;
    for (i, panel) in panels.into_iter().enumerate() {
        sheet.panel(i, panel);
        let board = Board::fit(window, shown, panel)?;
        board.draw_window(sheet);
        let Some((line, kept)) = i.checked_sub(1).and_then(|i| Some((i, left.get(i)?))) else {
            let outline = Path::polygon(&board.contour(&given));
            sheet.stroke(outline, Pen::new(Role::Undecided, NORMAL));
            continue;
        };
        if !before.is_empty() {
            board.draw_cut_off(sheet, before);
        }
        board.draw_kept(sheet, kept);
        board.draw_beyond(sheet, line);
        for &p in kept.iter().filter(|p| !before.contains(p)) {
            marks::point(sheet, board.at(p), Role::Chosen);
        }
        before = kept;
    }
    Ok(())
}

/// What each of the window's lines in turn leaves of a polygon.
fn after_each_line(window: &Window, polygon: &[DVec2]) -> [Vec<DVec2>; 4] {
    let mut left = polygon.to_vec();
    halves(window).map(|half| {
        left = clip_against_line(&left, half);
        left.clone()
    })
}

/// The inner sides of the window's lines, in the order of [`Board::lines`].
fn halves(window: &Window) -> [HalfPlane; 4] {
    [
        (DVec2::NEG_Y, -window.max.y),
        (DVec2::Y, window.min.y),
        (DVec2::NEG_X, -window.max.x),
        (DVec2::X, window.min.x),
    ]
    .map(|(normal, offset)| HalfPlane { normal, offset })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_line_cuts_one_tip_and_the_last_picture_is_the_clipped_polygon() {
        let inputs = Inputs::default();
        let (window, star) = (between(&inputs.get(&WINDOW)), inputs.get(&POLYGON));
        let mut polygon = star.clone();
        for (half, kept) in halves(&window)
            .into_iter()
            .zip(after_each_line(&window, &star))
        {
            // A tip goes, two crossings come.
            assert_eq!(kept.len(), polygon.len() + 1);
            let new: Vec<&DVec2> = kept.iter().filter(|p| !polygon.contains(p)).collect();
            assert_eq!(new.len(), 2);
            assert!(new.iter().all(|p| half.normal.dot(**p) == half.offset));
            polygon = kept;
        }
        let at_once = ombra_clip::sutherland_hodgman::clip_polygon(&window, &star);
        assert_eq!(at_once.len(), polygon.len());
        assert!(at_once.iter().all(|p| polygon.contains(p)));
    }

    #[test]
    fn a_polygon_outside_ends_with_nothing() {
        let inputs = Inputs::default();
        let outside = inputs.with(&POLYGON.input, "0,12 3,12 2,15").unwrap();
        let drawing = FIGURE
            .draw(&crate::style::Style::default(), &outside)
            .unwrap();
        let said: Vec<String> = drawing.labels.into_iter().map(|label| label.text).collect();
        let said = said.join(" ").replace('\u{a0}', " ");
        assert_eq!(said.matches("nothing").count(), 4, "{said}");
    }
}
