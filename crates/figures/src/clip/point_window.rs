//! The four inequalities of a point in the window: four half-planes and what they have in common.

use ombra_clip::Window;
use ombra_math::glam::DVec2;

use super::board::{Board, NAMES, RANGE, asked, between, corners, shown};
use crate::colour::{Ink, Role};
use crate::drawing::{EMPHASIS, NORMAL, Pen, THIN};
use crate::error::FigureError;
use crate::figure::{About, Figure, Takes};
use crate::input::{Ask, Inputs};
use crate::marks;
use crate::panels::panels;
use crate::path::{Path, Rect};
use crate::sheet::{Align, Label, Sheet};
use crate::text::LABEL;
use crate::words::words;

pub(super) const FIGURE: Figure = Figure {
    id: "clip/point-window",
    takes: Takes::These(&[P.input, Q.input, R.input, WINDOW.input]),
    words: WORDS,
    about: |_, language| About::new(language, SUMMARY, CAPTION),
    drawn: draw,
};

words! {
    SUMMARY {
        en: "A point and the window: four inequalities",
        it: "Un punto e il rettangolo di clipping: quattro disuguaglianze",
        cs: "Bod a okno: čtyři nerovnosti",
        hr: "Točka i prozor: četiri nejednakosti",
    }

    CAPTION {
        en: "Each inequality holds in a half-plane; a point is inside when all four hold. The border belongs to the window.",
        it: "Ogni disuguaglianza vale in un semipiano; un punto è interno se valgono tutte e quattro. Il bordo appartiene al rettangolo.",
        cs: "Každá nerovnost platí v polorovině; bod leží uvnitř, platí-li všechny čtyři. Hranice patří k oknu.",
        hr: "Svaka nejednakost vrijedi u poluravnini; točka je unutra ako vrijede sve četiri. Rub pripada prozoru.",
    }

    /// The last picture.
    ALL_FOUR {
        en: "all four: the window",
        it: "tutte e quattro: il rettangolo",
        cs: "všechny čtyři: okno",
        hr: "sve četiri: prozor",
    }

    /// An input.
    A_POINT {
        en: "a point to be tested",
        it: "un punto da esaminare",
        cs: "zkoumaný bod",
        hr: "ispitana točka",
    }
}

const P: Ask<DVec2> = Ask::point("p", "*P*", A_POINT, [3.0, 2.4], RANGE);
const Q: Ask<DVec2> = Ask::point("q", "*Q*", A_POINT, [12.6, 3.6], RANGE);
const R: Ask<DVec2> = Ask::point("r", "*R*", A_POINT, [-2.6, 7.4], RANGE);
const WINDOW: Ask<Vec<DVec2>> = asked(&[[0.0, 0.0], [10.0, 6.0]]);
/// Free around window and points.
const AROUND: f64 = 0.13;

/// From one line of text to the next.
const LEADING: f64 = 1.3 * LABEL;

/// The sides in the order in which they are told, as numbers of [`Board::lines`].
const ORDER: [usize; 4] = [3, 2, 1, 0];
/// What holds on the inner side of each line, and beyond it.
const HOLDS: [&str; 4] = ["*y* ≤ ", "*y* ≥ ", "*x* ≤ ", "*x* ≥ "];
const FAILS: [&str; 4] = ["*y* > ", "*y* < ", "*x* > ", "*x* < "];

fn draw(sheet: &mut Sheet, inputs: &Inputs) -> Result<(), FigureError> {
    let window = between(&inputs.get(&WINDOW));
    let points = [("P", &P), ("Q", &Q), ("R", &R)].map(|(name, ask)| (name, inputs.get(ask)));
    let shown = shown(&window, &points.map(|(_, p)| p), AROUND);
    let mut lines = ORDER
        .map(|side| format!("{}{}", HOLDS[side], NAMES[side]))
        .to_vec();
    lines.push(ALL_FOUR.text(sheet.style().language).to_owned());
    let lines: Vec<&str> = lines.iter().map(String::as_str).collect();
    let size = shown.max - shown.min;
    let cells = panels(sheet, &lines, (size.y / size.x).clamp(0.4, 2.0))?;

    for (i, &panel) in cells.iter().enumerate() {
        sheet.panel(i, panel);
        let board = Board::fit(window, shown, panel)?;
        let kept = ORDER
            .get(i)
            .map_or(window, |&side| half_plane(&board, side));
        tinted(sheet, &board.contour(&corners(&kept)));
        match ORDER
            .get(i)
            .and_then(|&side| board.lines().get(side).copied())
        {
            Some(line) => {
                board.draw_border(sheet);
                let [a, b] = line.map(|p| board.at(p));
                sheet.line(a, b, Pen::new(Role::Text, NORMAL));
            }
            None => {
                board.draw_lines(sheet);
                let border = Path::polygon(&board.contour(&corners(&window)));
                sheet.stroke(border, Pen::new(Role::Chosen, EMPHASIS));
            }
        }
        for (name, p) in points {
            let at = board.at(p);
            let holds = kept.contains(p);
            if holds {
                marks::point(sheet, at, Role::Chosen);
            } else {
                marks::hollow_point(sheet, at, Role::Rejected);
            }
            let ink = if holds { Role::Chosen } else { Role::Note };
            let label = Label::new(at, format!("*{name}*")).towards(DVec2::NEG_Y);
            sheet.label(label.ink(ink).beside());
        }
    }
    sheet.whole();

    // Why each point outside is there: in the place that is left, if one is.
    sheet.step(5);
    let Some(cell) = free_cell(&cells) else {
        return Ok(());
    };
    let why = points.iter().flat_map(|&(name, p)| {
        let broken = broken(&window, p).into_iter();
        broken.map(move |line| format!("*{name}*: {line}"))
    });
    let why: Vec<String> = why.collect();
    let first = cell.centre().y - 0.5 * LEADING * (why.len() as f64 - 1.0);
    for (i, line) in why.iter().enumerate() {
        let at = DVec2::new(cell.min.x + 0.2 * cell.size().x, first + LEADING * i as f64);
        sheet.text(at, Align::Left, line, LABEL, Role::Text)?;
    }
    Ok(())
}

/// The place beside the last of several rows of panels; none where the last row is full.
fn free_cell(cells: &[Rect]) -> Option<Rect> {
    let (first, last) = (cells.first()?, cells.last()?);
    let columns = cells
        .iter()
        .filter(|cell| cell.min.y == first.min.y)
        .count();
    let next = cells.get(cells.len() % columns)?;
    let min = DVec2::new(next.min.x, last.min.y);
    (!cells.len().is_multiple_of(columns)).then(|| Rect::new(min, min + last.size()))
}

/// The part of what is shown on the inner side of a line.
fn half_plane(board: &Board, side: usize) -> Window {
    let Board { window, shown, .. } = board;
    let mut half = *shown;
    match side {
        0 => half.max.y = window.max.y,
        1 => half.min.y = window.min.y,
        2 => half.max.x = window.max.x,
        _ => half.min.x = window.min.x,
    }
    half
}

/// An area in which an inequality holds: tinted and hatched.
fn tinted(sheet: &mut Sheet, area: &[DVec2]) {
    sheet.fill(Path::polygon(area), Ink::of(Role::Chosen).alpha(0.14));
    let pen = Pen::new(Ink::of(Role::Chosen).tint(0.35), THIN);
    sheet.stroke_unmarked(Path::hatching(area, 22.0), pen);
}

/// The inequalities that do not hold, turned round.
fn broken(window: &Window, p: DVec2) -> Vec<String> {
    let beyond = [
        p.y > window.max.y,
        p.y < window.min.y,
        p.x > window.max.x,
        p.x < window.min.x,
    ];
    ORDER
        .into_iter()
        .filter(|&side| beyond[side])
        .map(|side| format!("{}{}", FAILS[side], NAMES[side]))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::style::Style;

    fn said(inputs: &Inputs) -> Vec<String> {
        let drawing = FIGURE.draw(&Style::default(), inputs).unwrap();
        drawing.labels.into_iter().map(|label| label.text).collect()
    }

    #[test]
    fn a_point_that_moves_fails_other_inequalities() {
        let inputs = Inputs::default().with(&P.input, "11,-1").unwrap();
        let said = said(&inputs);
        for (line, times) in [
            ("P: x > xmax", 1),
            ("P: y < ymin", 1),
            ("Q: x > xmax", 1),
            ("R: x < xmin", 1),
            ("R: y > ymax", 1),
        ] {
            let found = said.iter().filter(|text| *text == line).count();
            assert_eq!(found, times, "{line}");
        }
    }

    #[test]
    fn the_window_is_where_all_four_half_planes_meet() {
        let window = super::super::board::window(0.0, 0.0, 10.0, 6.0);
        let shown = super::super::board::window(-5.0, -4.0, 15.0, 9.0);
        let frame = Rect::new(DVec2::ZERO, DVec2::new(500.0, 300.0));
        let board = Board::fit(window, shown, frame).unwrap();
        for x in -5..=15 {
            for y in -4..=9 {
                let p = DVec2::new(f64::from(x), f64::from(y));
                let outside = (0..4)
                    .filter(|&side| !half_plane(&board, side).contains(p))
                    .count();
                assert_eq!(broken(&window, p).len(), outside, "{p}");
                assert_eq!(outside == 0, window.contains(p), "{p}");
            }
        }
    }
}
