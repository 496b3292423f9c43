//! Where a segment's ends can lie.

use ombra_clip::{Segment, Window, crossing, direct};
use ombra_math::glam::DVec2;

use super::board::{Board, window};
use crate::colour::Role;
use crate::drawing::{EMPHASIS, Pen, THIN};
use crate::error::FigureError;
use crate::figure::{About, Figure, Takes};
use crate::marks;
use crate::sheet::Sheet;
use crate::words::words;

/// AB … IJ as in Grafica 3, Clipping di un segmento.
pub(super) const FIGURE: Figure = Figure {
    id: "clip/segment-cases",
    takes: Takes::Nothing(crate::words::FIXED),
    words: WORDS,
    about: |_, language| About::new(language, SUMMARY, CAPTION),
    drawn: |sheet, _| draw(sheet),
};

words! {
    SUMMARY {
        en: "Where the ends of a segment can lie, and what is kept of it",
        it: "Dove possono stare gli estremi di un segmento e che cosa ne resta",
        cs: "Kde mohou ležet konce úsečky a co z ní zůstane",
        hr: "Gdje mogu ležati krajevi dužine i što od nje ostaje",
    }

    CAPTION {
        en: "*G*′ and *H*′ lie on sides of the window; *I*′ and *J*′ only on the lines through them: nothing of *IJ* is kept.",
        it: "*G*′ e *H*′ stanno sui lati del rettangolo; *I*′ e *J*′ solo sulle rette su cui giacciono i lati: di *IJ* non resta nulla.",
        cs: "*G*′ a *H*′ leží na stranách okna; *I*′ a *J*′ jen na přímkách stran: z *IJ* nezůstane nic.",
        hr: "*G*′ i *H*′ leže na stranicama prozora; *I*′ i *J*′ samo na pravcima stranica: od *IJ* ne ostaje ništa.",
    }
}

const WINDOW: Window = window(0.0, 0.0, 10.0, 6.0);
const SHOWN: Window = window(-4.0, -2.2, 14.0, 8.2);
const fn segment(ax: f64, ay: f64, bx: f64, by: f64) -> Segment {
    Segment::new(DVec2::new(ax, ay), DVec2::new(bx, by))
}
/// Two ends inside; one; none and beyond one side; none and across the window; none and past its corner.
const SEGMENTS: [(&str, &str, Segment); 5] = [
    ("A", "B", segment(1.6, 2.2, 4.0, 4.8)),
    ("C", "D", segment(5.8, 3.2, 12.6, 5.4)),
    ("E", "F", segment(-2.9, 0.9, -1.5, 4.0)),
    ("G", "H", segment(2.0, -1.4, 12.4, 2.8)),
    ("I", "J", segment(-2.6, 5.0, 2.2, 7.7)),
];

fn draw(sheet: &mut Sheet) -> Result<(), FigureError> {
    let board = Board::fit(WINDOW, SHOWN, sheet.frame())?;
    board.draw_window(sheet);
    board.draw_lines(sheet);
    for (first, second, segment) in SEGMENTS {
        let [a, b] = [segment.a, segment.b].map(|p| board.at(p));
        let kept = direct::clip_segment(&WINDOW, segment);
        if kept != Some(segment) {
            sheet.line(a, b, Pen::new(Role::Rejected, THIN).dashed());
        }
        let along = (segment.b - segment.a).normalize_or_zero();
        if let Some(kept) = kept {
            let [from, to] = [kept.a, kept.b].map(|p| board.at(p));
            sheet.line(from, to, Pen::new(Role::Chosen, EMPHASIS));
        }
        for (end, name, towards) in [(segment.a, first, -along), (segment.b, second, along)] {
            if WINDOW.contains(end) {
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
            // Crossings with the lines, beyond the sides.
            None => {
                let crossings = line_crossings(segment);
                for (p, name) in crossings.into_iter().zip([first, second]) {
                    marks::hollow_point(sheet, board.at(p), Role::Rejected);
                    board.name(sheet, p, format!("*{name}*′"), along.perp());
                }
            }
        }
    }
    Ok(())
}

/// Where a segment crosses the lines of the window's sides, from a to b.
fn line_crossings(segment: Segment) -> Vec<DVec2> {
    let uprights = [WINDOW.min.x, WINDOW.max.x]
        .into_iter()
        .filter_map(|x| Some(DVec2::new(x, crossing::at_x(segment, x)?)));
    let levels = [WINDOW.min.y, WINDOW.max.y]
        .into_iter()
        .filter_map(|y| Some(DVec2::new(crossing::at_y(segment, y)?, y)));
    let mut all: Vec<DVec2> = uprights.chain(levels).collect();
    all.sort_by(|p, q| p.distance(segment.a).total_cmp(&q.distance(segment.a)));
    all
}
