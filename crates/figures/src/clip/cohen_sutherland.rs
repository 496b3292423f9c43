//! Cohen–Sutherland: a segment cut twice, with the codes at every step.

use ombra_clip::Segment;
use ombra_clip::cohen_sutherland::{Decision, Step, trace};
use ombra_clip::window::Side;
use ombra_math::glam::DVec2;

use super::board::{Board, FIRST_END, LAST_END, NAMES, RANGE, asked, between, shown};
use crate::colour::Role;
use crate::drawing::{EMPHASIS, NORMAL, Pen, THIN};
use crate::error::FigureError;
use crate::figure::{About, Figure, Takes};
use crate::input::{Ask, Inputs};
use crate::marks;
use crate::panels::panels;
use crate::sheet::{Label, Sheet};
use crate::style::Language;
use crate::words::words;

pub(super) const FIGURE: Figure = Figure {
    id: "clip/cohen-sutherland-steps",
    takes: Takes::These(&[A.input, B.input, WINDOW.input]),
    words: WORDS,
    about: |_, language| About::new(language, SUMMARY, CAPTION),
    drawn: draw,
};

words! {
    SUMMARY {
        en: "Cohen–Sutherland: a segment cut at one line after another, with its codes",
        it: "Cohen–Sutherland: un segmento tagliato a una retta dopo l’altra, con i codici",
        cs: "Cohen–Sutherland: úsečka řezaná jednou přímkou po druhé, s kódy",
        hr: "Cohen–Sutherland: dužina odsijecana pravac po pravac, s kodovima",
    }

    CAPTION {
        en: "OR = 0000 accepts, AND ≠ 0000 rejects. Otherwise the first bit that differs says where to cut, and both are tested again.",
        it: "OR = 0000 accetta, AND ≠ 0000 rifiuta. Altrimenti il primo bit discordante dice dove tagliare, e si ripetono i due test.",
        cs: "OR = 0000 přijímá, AND ≠ 0000 zamítá. Jinak první odlišný bit určí řez a oba testy se opakují.",
        hr: "OR = 0000 prihvaća, AND ≠ 0000 odbacuje. Inače prvi različiti bit kaže gdje rezati i obje se provjere ponavljaju.",
    }

    /// Cohen–Sutherland: the segment is inside.
    ACCEPT {
        en: "accepted",
        it: "accettato",
        cs: "přijato",
        hr: "prihvaćeno",
    }

    /// Cohen–Sutherland: the segment is outside.
    REJECT {
        en: "rejected",
        it: "rifiutato",
        cs: "zamítnuto",
        hr: "odbačeno",
    }

    /// Cohen–Sutherland: before the line that cuts.
    CUT_AT {
        en: "cut at",
        it: "taglio a",
        cs: "řez na",
        hr: "rez na",
    }
}

/// Cut above, below and on the right; each of the four bits occurs.
const A: Ask<DVec2> = Ask::point("a", "*A*", FIRST_END, [-2.0, 13.0], RANGE);
const B: Ask<DVec2> = Ask::point("b", "*B*", LAST_END, [14.0, -3.0], RANGE);
const WINDOW: Ask<Vec<DVec2>> = asked(&[[0.0, 0.0], [10.0, 10.0]]);
/// Free around window and segment.
const AROUND: f64 = 0.12;

fn draw(sheet: &mut Sheet, inputs: &Inputs) -> Result<(), FigureError> {
    let language = sheet.style().language;
    let segment = Segment::new(inputs.get(&A), inputs.get(&B));
    let window = between(&inputs.get(&WINDOW));
    let shown = shown(&window, &[segment.a, segment.b], AROUND);
    let steps = trace(&window, segment);
    let lines: Vec<String> = steps.iter().map(|step| decision(step, language)).collect();
    let lines: Vec<&str> = lines.iter().map(String::as_str).collect();
    let size = shown.max - shown.min;
    let panels = panels(sheet, &lines, (size.y / size.x).clamp(0.5, 2.0))?;
    for (i, (panel, step)) in panels.into_iter().zip(&steps).enumerate() {
        sheet.panel(i, panel);
        draw_step(sheet, Board::fit(window, shown, panel)?, segment, step)?;
    }
    Ok(())
}

/// What the codes decide, in one line.
fn decision(step: &Step, language: Language) -> String {
    let [a, b] = step.codes;
    let (either, both) = (a | b, a & b);
    match step.decision {
        Decision::Accept => format!("OR {either}: {}", ACCEPT.text(language)),
        Decision::Reject => format!("AND {both}: {}", REJECT.text(language)),
        Decision::Cut { side, .. } => {
            let (axis, at) = line(side);
            // Unbreakable spaces keep each part on one line.
            let cut = CUT_AT.text(language);
            format!("OR {either}, AND\u{a0}{both}: {cut} *{axis}*\u{a0}=\u{a0}{at}")
        }
    }
}

/// A side's line: its axis and the name of its place.
fn line(side: Side) -> (&'static str, &'static str) {
    let [above, below, right, left] = NAMES;
    match side {
        Side::Above => ("y", above),
        Side::Below => ("y", below),
        Side::Right => ("x", right),
        Side::Left => ("x", left),
    }
}

fn draw_step(
    sheet: &mut Sheet,
    board: Board,
    segment: Segment,
    step: &Step,
) -> Result<(), FigureError> {
    board.draw_window(sheet);
    let cut = match step.decision {
        Decision::Cut { side, .. } => Some(side),
        _ => None,
    };
    // The line that cuts, with its name.
    let sides = [Side::Above, Side::Below, Side::Right, Side::Left];
    for ((line, name), side) in board.lines().into_iter().zip(NAMES).zip(sides) {
        if cut == Some(side) {
            let [a, b] = line.map(|p| board.at(p));
            sheet.line(a, b, Pen::new(Role::Receiver, THIN).dashed());
            // At the end that is farther from the segment.
            let free = |end: DVec2| {
                let (from, to) = (board.at(step.segment.a), board.at(step.segment.b));
                let along = (to - from) / 16.0;
                let places = (0..=16).map(|k| (from + along * f64::from(k)).distance(end));
                places.fold(f64::INFINITY, f64::min)
            };
            let end = if free(a) > free(b) { a } else { b };
            let aside = if a.y == b.y { DVec2::NEG_Y } else { DVec2::X };
            let label = Label::new(end, name).towards(aside);
            sheet.label(label.reach(4.0).beside());
        }
    }

    let all = [segment.a, segment.b].map(|p| board.at(p));
    sheet.line(all[0], all[1], Pen::new(Role::Rejected, THIN).dashed());
    let done = step.decision == Decision::Accept;
    let [a, b] = [step.segment.a, step.segment.b].map(|p| board.at(p));
    let pen = if done {
        Pen::new(Role::Chosen, EMPHASIS)
    } else {
        Pen::new(Role::Undecided, NORMAL)
    };
    sheet.line(a, b, pen);
    let ends = [
        ("A", step.segment.a, segment.a),
        ("B", step.segment.b, segment.b),
    ];
    for ((name, end, start), code) in ends.into_iter().zip(step.codes) {
        let prime = if end == start { "" } else { "′" };
        let label = format!("*{name}*{prime} {code}");
        if code.is_inside() {
            marks::point(sheet, board.at(end), Role::Chosen);
        } else {
            marks::hollow_point(sheet, board.at(end), Role::Undecided);
        }
        // An end that is given: away from the other. A new one: off the line, away from the window.
        let along = step.segment.b - step.segment.a;
        let aside = if end != start {
            let middle = 0.5 * (board.window.min + board.window.max);
            along.perp() * (end - middle).dot(along.perp())
        } else if name == "A" {
            -along
        } else {
            along
        };
        let aside = DVec2::new(aside.x, -aside.y);
        let ink = if code.is_inside() {
            Role::Chosen
        } else {
            Role::Text
        };
        let label = Label::new(board.at(end), label).towards(aside).ink(ink);
        sheet.label(label.beside());
    }
    Ok(())
}
