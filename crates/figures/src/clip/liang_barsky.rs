//! Liang–Barsky: where along the segment each inequality holds, and where all do.

use ombra_clip::{Segment, Window, liang_barsky};
use ombra_math::glam::DVec2;

use super::bars::{Row, divided, draw as draw_bars, in_common, not_negative};
use super::board::{Board, FIRST_END, LAST_END, NAMES, RANGE, asked, between, shown};
use crate::colour::Role;
use crate::drawing::{EMPHASIS, NORMAL, Pen, THIN};
use crate::error::FigureError;
use crate::figure::{About, Figure, Takes};
use crate::input::{Ask, Inputs};
use crate::marks;
use crate::number::{exact, inline};
use crate::path::Rect;
use crate::sheet::{Label, Sheet};
use crate::words::words;

pub(super) const FIGURE: Figure = Figure {
    id: "clip/liang-barsky",
    takes: Takes::These(&[A.input, B.input, WINDOW.input]),
    words: WORDS,
    about: |inputs, language| {
        let (window, segment) = given(inputs);
        let [from, to] = in_common(&rows(&window, segment)).map(inline);
        let left = match liang_barsky::clip_segment(&window, segment) {
            Some(_) => LEFT.text(language).replace("%1", &from).replace("%2", &to),
            None => NOTHING.text(language).to_owned(),
        };
        About::new(language, SUMMARY, CAPTION).and(Some(left))
    },
    drawn: draw,
};

words! {
    SUMMARY {
        en: "Liang–Barsky: where along the segment each inequality holds, and where all do",
        it: "Liang–Barsky: dove vale lungo il segmento ogni disuguaglianza, e dove tutte",
        cs: "Liang–Barsky: kde podél úsečky platí každá nerovnost a kde všechny",
        hr: "Liang–Barsky: gdje duž dužine vrijedi svaka nejednakost, a gdje sve",
    }

    CAPTION {
        en: "*P* = *A* + *t* (*B* − *A*). A bar that begins at *t* enters there, one that ends leaves there; the largest entering and the smallest leaving *t* count.",
        it: "*P* = *A* + *t* (*B* − *A*). Una barra che inizia a *t* vi entra, una che finisce vi esce; contano il massimo *t* d’entrata e il minimo d’uscita.",
        cs: "*P* = *A* + *t* (*B* − *A*). Kde pruh začíná, tam úsečka vstupuje, kde končí, vystupuje; platí největší vstupní a nejmenší výstupní *t*.",
        hr: "*P* = *A* + *t* (*B* − *A*). Gdje traka počinje, dužina ulazi, gdje završava, izlazi; vrijede najveći ulazni i najmanji izlazni *t*.",
    }

    /// What is left.
    LEFT {
        en: "Kept: %1 ≤ *t* ≤ %2.",
        it: "Resta: %1 ≤ *t* ≤ %2.",
        cs: "Zůstane: %1 ≤ *t* ≤ %2.",
        hr: "Ostaje: %1 ≤ *t* ≤ %2.",
    }

    /// Where nothing is left.
    NOTHING {
        en: "Here they leave nothing.",
        it: "Qui non lasciano nulla.",
        cs: "Zde nic nezůstane.",
        hr: "Ovdje ništa ne ostaje.",
    }

    /// The last bar.
    pub(super) ALL {
        en: "all",
        it: "tutte",
        cs: "všechny",
        hr: "sve",
    }

    /// The last bar, where there is none.
    pub(super) NONE {
        en: "all: never",
        it: "tutte: mai",
        cs: "všechny: nikde",
        hr: "sve: nigdje",
    }
}

const A: Ask<DVec2> = Ask::point("a", "*A*", FIRST_END, [-4.0, 9.0], RANGE);
const B: Ask<DVec2> = Ask::point("b", "*B*", LAST_END, [12.0, 1.0], RANGE);
const WINDOW: Ask<Vec<DVec2>> = asked(&[[0.0, 0.0], [10.0, 6.0]]);
/// Free around window and segment.
const AROUND: f64 = 0.1;
/// Share of the segment's picture.
const SHARE: f64 = 0.5;

fn given(inputs: &Inputs) -> (Window, Segment) {
    let segment = Segment::new(inputs.get(&A), inputs.get(&B));
    (between(&inputs.get(&WINDOW)), segment)
}

/// Each side's inequality, in the order of [`Board::lines`], and that of the segment.
fn rows(window: &Window, segment: Segment) -> Vec<Row> {
    let (a, d) = (segment.a, segment.b - segment.a);
    let [above, below, right, left] = NAMES;
    let row = |name: String, holds| Row { name, holds };
    vec![
        row(
            format!("*y* ≤ {above}"),
            not_negative(window.max.y - a.y, -d.y),
        ),
        row(
            format!("*y* ≥ {below}"),
            not_negative(a.y - window.min.y, d.y),
        ),
        row(
            format!("*x* ≤ {right}"),
            not_negative(window.max.x - a.x, -d.x),
        ),
        row(
            format!("*x* ≥ {left}"),
            not_negative(a.x - window.min.x, d.x),
        ),
        row("0 ≤ *t* ≤ 1".to_owned(), [0.0, 1.0]),
    ]
}

fn draw(sheet: &mut Sheet, inputs: &Inputs) -> Result<(), FigureError> {
    let language = sheet.style().language;
    let (window, segment) = given(inputs);
    let rows = rows(&window, segment);
    let kept = liang_barsky::clip_segment(&window, segment);
    let [picture, bars] = divided(sheet.frame(), SHARE);
    let shown = shown(&window, &[segment.a, segment.b], AROUND);
    let board = Board::fit(window, shown, picture)?;
    board.draw_window(sheet);
    let lines = board.lines();
    for (i, line) in lines.into_iter().enumerate() {
        sheet.step(i + 1);
        let [from, to] = line.map(|p| board.at(p));
        sheet.line(from, to, Pen::new(Role::Receiver, THIN).dashed());
    }
    let sides = rows.iter().take(lines.len()).map(|row| row.holds);
    draw_crossings(sheet, picture, |p| board.at(p), segment, kept, sides);
    let all = if kept.is_some() { ALL } else { NONE };
    draw_bars(sheet, bars, &rows, all.text(language), kept.is_some())
}

/// The segment, where it meets each line in `picture`, a step a line, and then what is kept of it.
pub(super) fn draw_crossings(
    sheet: &mut Sheet,
    picture: Rect,
    at: impl Fn(DVec2) -> DVec2,
    segment: Segment,
    kept: Option<Segment>,
    sides: impl Iterator<Item = [f64; 2]>,
) {
    let [a, b] = [segment.a, segment.b].map(&at);
    sheet.step(0);
    sheet.line(a, b, Pen::new(Role::Undecided, NORMAL));
    let along = (b - a).normalize_or(DVec2::X);
    let mut last = 0;
    for (i, holds) in sides.enumerate() {
        last = i + 1;
        sheet.step(last);
        let Some(t) = holds.into_iter().find(|t| t.is_finite()) else {
            continue;
        };
        let place = at(segment.a + (segment.b - segment.a) * t);
        if !picture.contains(&Rect::new(place, place)) {
            continue;
        }
        // Beyond its ends the segment is a line that only would go on.
        let end = if t < 0.0 { a } else { b };
        if !(0.0..=1.0).contains(&t) {
            sheet.line(end, place, Pen::new(Role::Rejected, THIN).dashed());
        }
        marks::hollow_point(sheet, place, Role::Undecided);
        let enters = holds[0].is_finite();
        let aside = if enters { along.perp() } else { -along.perp() };
        let label = Label::new(place, exact(t));
        sheet.label(label.towards(aside).within(picture).beside());
    }
    sheet.step(0);
    for (end, name, out) in [(a, "*A*", -along), (b, "*B*", along)] {
        marks::point(sheet, end, Role::Undecided);
        sheet.label(Label::new(end, name).towards(out).within(picture).beside());
    }
    sheet.step(last + 2);
    if let Some(kept) = kept {
        let [from, to] = [kept.a, kept.b].map(&at);
        sheet.line(from, to, Pen::new(Role::Chosen, EMPHASIS));
        marks::point(sheet, from, Role::Chosen);
        marks::point(sheet, to, Role::Chosen);
    }
    sheet.whole();
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::style::Language;

    /// x = −4 + 16t, y = 9 − 8t in the window from (0, 0) to (10, 6).
    #[test]
    fn the_largest_entry_and_the_smallest_exit_are_the_librarys() {
        let inputs = Inputs::default();
        let (window, segment) = given(&inputs);
        let rows = rows(&window, segment);
        let infinity = f64::INFINITY;
        let expected = [
            [0.375, infinity],
            [-infinity, 1.125],
            [-infinity, 0.875],
            [0.25, infinity],
            [0.0, 1.0],
        ];
        assert_eq!(
            rows.iter().map(|row| row.holds).collect::<Vec<_>>(),
            expected
        );
        let kept = liang_barsky::clip_segment(&window, segment).unwrap();
        assert_eq!(
            (kept.a, kept.b),
            (DVec2::new(2.0, 6.0), DVec2::new(10.0, 2.0))
        );
        let caption = FIGURE.caption(&inputs, Language::En);
        assert!(caption.contains("Kept: 3/8 ≤ *t* ≤ 7/8."), "{caption}");
        let moved = inputs.with(&B.input, "-4,-9").unwrap();
        assert!(FIGURE.caption(&moved, Language::En).contains("nothing"));
    }
}
