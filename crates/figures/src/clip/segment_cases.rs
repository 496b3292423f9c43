//! Where a segment's ends can lie.

use ombra_clip::{Segment, Window, crossing, direct};
use ombra_math::glam::DVec2;

use super::board::{Board, FIRST_END, LAST_END, RANGE, asked, between, shown};
use crate::colour::Role;
use crate::drawing::{EMPHASIS, Pen, THIN};
use crate::error::FigureError;
use crate::figure::{About, Figure, Takes};
use crate::input::{Ask, Inputs};
use crate::marks;
use crate::sheet::Sheet;
use crate::style::Language;
use crate::words::{Word, words};

/// AB … IJ as in Grafica 3, Clipping di un segmento.
pub(super) const FIGURE: Figure = Figure {
    id: "clip/segment-cases",
    takes: Takes::These(&[
        A.input,
        B.input,
        C.input,
        D.input,
        E.input,
        F.input,
        G.input,
        H.input,
        I.input,
        J.input,
        WINDOW.input,
    ]),
    words: WORDS,
    about,
    drawn: draw,
};

words! {
    SUMMARY {
        en: "Where the ends of a segment can lie, and what is kept of it",
        it: "Dove possono stare gli estremi di un segmento e che cosa ne resta",
        cs: "Kde mohou ležet konce úsečky a co z ní zůstane",
        hr: "Gdje mogu ležati krajevi dužine i što od nje ostaje",
    }

    /// What stays as it is.
    WHOLE {
        en: "Kept whole: %1.",
        it: "Restano interi: %1.",
        cs: "Celé zůstávají: %1.",
        hr: "Cijele ostaju: %1.",
    }

    /// What gets new ends.
    CUT {
        en: "Cut, with new ends on sides of the window: %1.",
        it: "Tagliati, con nuovi estremi sui lati del rettangolo: %1.",
        cs: "Oříznuté, s novými konci na stranách okna: %1.",
        hr: "Odsječene, s novim krajevima na stranicama prozora: %1.",
    }

    /// What is gone.
    GONE {
        en: "Nothing is kept of %1.",
        it: "Non resta nulla di %1.",
        cs: "Nic nezůstane z %1.",
        hr: "Ništa ne ostaje od %1.",
    }

    /// What meets only lines of sides.
    BESIDE {
        en: "Only the lines through the sides are met by %1.",
        it: "Solo le rette su cui giacciono i lati incontrano %1.",
        cs: "Jen přímky stran protíná %1.",
        hr: "Samo pravce stranica siječe %1.",
    }
}

const A: Ask<DVec2> = Ask::point("a", "*A*", FIRST_END, [1.6, 2.2], RANGE);
const B: Ask<DVec2> = Ask::point("b", "*B*", LAST_END, [4.0, 4.8], RANGE);
const C: Ask<DVec2> = Ask::point("c", "*C*", FIRST_END, [5.8, 3.2], RANGE);
const D: Ask<DVec2> = Ask::point("d", "*D*", LAST_END, [12.6, 5.4], RANGE);
const E: Ask<DVec2> = Ask::point("e", "*E*", FIRST_END, [-2.9, 0.9], RANGE);
const F: Ask<DVec2> = Ask::point("f", "*F*", LAST_END, [-1.5, 4.0], RANGE);
const G: Ask<DVec2> = Ask::point("g", "*G*", FIRST_END, [2.0, -1.4], RANGE);
const H: Ask<DVec2> = Ask::point("h", "*H*", LAST_END, [12.4, 2.8], RANGE);
const I: Ask<DVec2> = Ask::point("i", "*I*", FIRST_END, [-2.6, 5.0], RANGE);
const J: Ask<DVec2> = Ask::point("j", "*J*", LAST_END, [2.2, 7.7], RANGE);
const WINDOW: Ask<Vec<DVec2>> = asked(&[[0.0, 0.0], [10.0, 6.0]]);
/// Free around window and segments.
const AROUND: f64 = 0.06;

/// Two ends inside; one; none and beyond one side; none and across the window; none and past its corner.
fn segments(inputs: &Inputs) -> [(&'static str, &'static str, Segment); 5] {
    let pairs = [
        ("A", "B", &A, &B),
        ("C", "D", &C, &D),
        ("E", "F", &E, &F),
        ("G", "H", &G, &H),
        ("I", "J", &I, &J),
    ];
    pairs.map(|(first, second, a, b)| {
        let segment = Segment::new(inputs.get(a), inputs.get(b));
        (first, second, segment)
    })
}

/// What becomes of each segment, and which of those that go meet the lines of the sides.
fn about(inputs: &Inputs, language: Language) -> About {
    let window = between(&inputs.get(&WINDOW));
    let mut named: [(Word, Vec<String>); 4] =
        [WHOLE, CUT, GONE, BESIDE].map(|word| (word, Vec::new()));
    for (first, second, segment) in segments(inputs) {
        let name = format!("*{first}{second}*");
        let kept = direct::clip_segment(&window, segment);
        let case = match kept {
            Some(kept) if kept == segment => 0,
            Some(_) => 1,
            None => 2,
        };
        if kept.is_none() && !line_crossings(&window, segment).is_empty() {
            named[3].1.push(name.clone());
        }
        named[case].1.push(name);
    }
    let said: Vec<String> = named
        .into_iter()
        .filter(|(_, names)| !names.is_empty())
        .map(|(word, names)| word.text(language).replace("%1", &names.join(", ")))
        .collect();
    About {
        summary: SUMMARY.text(language).to_owned(),
        caption: said.join(" "),
    }
}

fn draw(sheet: &mut Sheet, inputs: &Inputs) -> Result<(), FigureError> {
    let window = between(&inputs.get(&WINDOW));
    let segments = segments(inputs);
    let ends = segments.map(|(_, _, segment)| [segment.a, segment.b]);
    let shown = shown(&window, &ends.concat(), AROUND);
    let board = Board::fit(window, shown, sheet.frame())?;
    board.draw_window(sheet);
    board.draw_lines(sheet);
    for (i, (first, second, segment)) in segments.into_iter().enumerate() {
        sheet.step(i + 1);
        let [a, b] = [segment.a, segment.b].map(|p| board.at(p));
        let kept = direct::clip_segment(&window, segment);
        if kept != Some(segment) {
            sheet.line(a, b, Pen::new(Role::Rejected, THIN).dashed());
        }
        let along = (segment.b - segment.a).normalize_or_zero();
        if let Some(kept) = kept {
            let [from, to] = [kept.a, kept.b].map(|p| board.at(p));
            sheet.line(from, to, Pen::new(Role::Chosen, EMPHASIS));
        }
        for (end, name, towards) in [(segment.a, first, -along), (segment.b, second, along)] {
            if window.contains(end) {
                marks::point(sheet, board.at(end), Role::Chosen);
            } else {
                marks::hollow_point(sheet, board.at(end), Role::Rejected);
            }
            board.name(sheet, end, format!("*{name}*"), towards);
        }
        match kept {
            // New ends, on the border.
            Some(kept) => {
                for (old, new, name) in [(segment.a, kept.a, first), (segment.b, kept.b, second)] {
                    if old != new {
                        marks::point(sheet, board.at(new), Role::Chosen);
                        board.name(sheet, new, format!("*{name}*′"), along.perp());
                    }
                }
            }
            // Crossings with the lines, beyond the sides: the first from each end has its name.
            None => {
                let crossings = line_crossings(&window, segment);
                for &p in &crossings {
                    marks::hollow_point(sheet, board.at(p), Role::Rejected);
                }
                let ends = match crossings[..] {
                    [] => Vec::new(),
                    [only] => vec![(only, first)],
                    [from, .., to] => vec![(from, first), (to, second)],
                };
                for (p, name) in ends {
                    board.name(sheet, p, format!("*{name}*′"), along.perp());
                }
            }
        }
    }
    Ok(())
}

/// Where a segment crosses the lines of the window's sides, from a to b.
fn line_crossings(window: &Window, segment: Segment) -> Vec<DVec2> {
    let uprights = [window.min.x, window.max.x]
        .into_iter()
        .filter_map(|x| Some(DVec2::new(x, crossing::at_x(segment, x)?)));
    let levels = [window.min.y, window.max.y]
        .into_iter()
        .filter_map(|y| Some(DVec2::new(crossing::at_y(segment, y)?, y)));
    let mut all: Vec<DVec2> = uprights.chain(levels).collect();
    all.sort_by(|p, q| p.distance(segment.a).total_cmp(&q.distance(segment.a)));
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_caption_says_what_becomes_of_each_segment() {
        let said = about(&Inputs::default(), Language::En).caption;
        assert_eq!(
            said,
            "Kept whole: *AB*. Cut, with new ends on sides of the window: *CD*, *GH*. Nothing is kept of *EF*, *IJ*. \
             Only the lines through the sides are met by *IJ*."
        );
        // D comes inside, so CD stays; a point outside is a segment too.
        let moved = Inputs::default()
            .with(&D.input, "9,5")
            .and_then(|inputs| inputs.with(&A.input, "20,20"))
            .and_then(|inputs| inputs.with(&B.input, "20,20"));
        let said = about(&moved.unwrap(), Language::En).caption;
        assert!(said.starts_with("Kept whole: *CD*. Cut, with new ends on sides of the window: *GH*. Nothing is kept of *AB*, *EF*, *IJ*."));
    }
}
