//! Cohen–Sutherland: a segment cut twice, with the codes at every step.

use ombra_clip::cohen_sutherland::{Decision, Step, trace};
use ombra_clip::window::Side;
use ombra_clip::{Segment, Window};
use ombra_math::glam::DVec2;

use super::board::{Board, NAMES, window};
use crate::colour::Role;
use crate::drawing::{EMPHASIS, NORMAL, Pen, THIN};
use crate::error::FigureError;
use crate::figure::{About, Figure, Takes};
use crate::marks;
use crate::panels::panels;
use crate::path::Rect;
use crate::sheet::{Align, Sheet};
use crate::style::Language;
use crate::text::LABEL;
use crate::words::words;

pub(super) const FIGURE: Figure = Figure {
    id: "clip/cohen-sutherland-steps",
    takes: Takes::NOTHING,
    words: WORDS,
    about: |_| About::new(SUMMARY, CAPTION),
    drawn: |sheet, _| draw(sheet),
};

words! {
    SUMMARY {
        en: "Cohen–Sutherland: a segment cut twice, with its codes at every step",
        it: "Cohen–Sutherland: un segmento tagliato due volte, con i codici a ogni passo",
        cs: "Cohen–Sutherland: úsečka dvakrát oříznutá, s kódy v každém kroku",
        hr: "Cohen–Sutherland: dužina dvaput odsječena, s kodovima u svakom koraku",
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

const WINDOW: Window = window(0.0, 0.0, 10.0, 10.0);
const SHOWN: Window = window(-4.0, -5.2, 14.0, 15.2);
/// Cut above, then below.
const SEGMENT: Segment = Segment::new(DVec2::new(2.0, 14.0), DVec2::new(8.0, -4.0));

fn draw(sheet: &mut Sheet) -> Result<(), FigureError> {
    let language = sheet.style().language;
    let steps = trace(&WINDOW, SEGMENT);
    let lines: Vec<String> = steps.iter().map(|step| decision(step, language)).collect();
    let lines: Vec<&str> = lines.iter().map(String::as_str).collect();
    let panels = panels(sheet, &lines, 1.5)?;
    for (panel, step) in panels.into_iter().zip(&steps) {
        draw_step(sheet, panel, step)?;
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
            // Unbreakable spaces keep the cut on one line.
            let cut = format!("{} *{axis}* = {at}", CUT_AT.text(language)).replace(' ', "\u{a0}");
            format!("OR {either}, AND {both}: {cut}")
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

fn draw_step(sheet: &mut Sheet, panel: Rect, step: &Step) -> Result<(), FigureError> {
    let board = Board::fit(WINDOW, SHOWN, panel)?;
    board.draw_window(sheet);
    let [above, below, ..] = board.lines();
    for ([a, b], name) in [above, below].into_iter().zip(NAMES) {
        let [a, b] = [a, b].map(|p| board.at(p));
        sheet.line(a, b, Pen::new(Role::Receiver, THIN).dashed());
        let place = a - DVec2::new(0.0, 0.8 * LABEL);
        sheet.text(place, Align::Left, name, LABEL, Role::Text)?;
    }

    let all = [SEGMENT.a, SEGMENT.b].map(|p| board.at(p));
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
        ("A", step.segment.a, SEGMENT.a),
        ("B", step.segment.b, SEGMENT.b),
    ];
    for ((name, end, start), code) in ends.into_iter().zip(step.codes) {
        let prime = if end == start { "" } else { "′" };
        let label = format!("*{name}*{prime} {code}");
        if code.is_inside() {
            marks::point(sheet, board.at(end), Role::Chosen);
        } else {
            marks::hollow_point(sheet, board.at(end), Role::Undecided);
        }
        // Where the segment leaves the most room.
        let aside = if name == "A" { DVec2::X } else { DVec2::NEG_X };
        board.name(sheet, end, label, aside);
    }
    Ok(())
}
