//! Two triangles with a common edge through pixel centres, under three rules.

use core::cmp::Ordering;

use ombra_math::glam::{DVec2, IVec2};
use ombra_math::predicates::orient_2d;
use ombra_raster::rectangle::fill;
use ombra_raster::triangle::{EdgeRule, cover_plain};

use super::columns::filled;
use crate::colour::{Ink, Role};
use crate::drawing::{NORMAL, Pen, THIN};
use crate::error::FigureError;
use crate::figure::{About, Figure, Takes};
use crate::input::{Ask, Inputs};
use crate::marks;
use crate::panels::panels;
use crate::path::Rect;
use crate::pixels::{Grid, Orientation};
use crate::sheet::{Align, Label, Sheet};
use crate::style::Language;
use crate::text::{LABEL, NOTE};
use crate::words::{Word, words};

pub(super) const FIGURE: Figure = Figure {
    id: "raster/triangle-shared-edge",
    takes: Takes::These(&[P.input, Q.input, A.input, B.input]),
    words: WORDS,
    about: |_, language| About::new(language, SUMMARY, CAPTION),
    drawn: draw,
};

words! {
    SUMMARY {
        en: "Two triangles with a common edge: one owner a pixel, and what comes without the rule",
        it: "Due triangoli con un lato comune: un solo proprietario per pixel, e che cosa succede senza regola",
        cs: "Dva trojúhelníky se společnou hranou: každý pixel má jednoho vlastníka, a co nastane bez pravidla",
        hr: "Dva trokuta sa zajedničkim bridom: svaki piksel ima jednog vlasnika, i što biva bez pravila",
    }

    CAPTION {
        en: "A centre on an edge belongs to the triangle for which the edge is a top or a left one. The numbers say how often a pixel on the edge is drawn.",
        it: "Un centro su un lato appartiene al triangolo per cui quel lato è in alto o a sinistra. I numeri dicono quante volte si disegna un pixel del lato.",
        cs: "Střed na hraně patří trojúhelníku, pro který je hrana horní nebo levá. Čísla říkají, kolikrát je pixel na hraně kreslen.",
        hr: "Središte na bridu pripada trokutu kojemu je taj brid gornji ili lijevi. Brojevi kažu koliko se puta crta piksel na bridu.",
    }

    /// The first picture.
    TOP_LEFT {
        en: "top-left rule",
        it: "alto-sinistra",
        cs: "vlevo-nahoře",
        hr: "gore-lijevo",
    }

    /// The second picture.
    CLOSED {
        en: "edges inside",
        it: "lati compresi",
        cs: "hrany uvnitř",
        hr: "bridovi unutra",
    }

    /// The third picture.
    OPEN {
        en: "edges outside",
        it: "lati esclusi",
        cs: "hrany venku",
        hr: "bridovi izvan",
    }

    /// Every pixel has one owner.
    ONCE {
        en: "each once",
        it: "ognuno una volta",
        cs: "každý jednou",
        hr: "svaki jednom",
    }

    /// After a number of pixels.
    TWICE {
        en: "%1 twice",
        it: "%1 due volte",
        cs: "%1 dvakrát",
        hr: "%1 dvaput",
    }

    /// After a number of pixels.
    MISSING {
        en: "%1 missing",
        it: "%1 mancanti",
        cs: "%1 chybí",
        hr: "%1 nedostaje",
    }

    /// An input.
    FROM {
        en: "the first end of the common edge",
        it: "il primo estremo del lato comune",
        cs: "první konec společné hrany",
        hr: "prvi kraj zajedničkog brida",
    }

    /// An input.
    TO {
        en: "the last end of the common edge",
        it: "il secondo estremo del lato comune",
        cs: "poslední konec společné hrany",
        hr: "drugi kraj zajedničkog brida",
    }

    /// An input.
    CORNER_A {
        en: "the third corner of the triangle A",
        it: "il terzo vertice del triangolo A",
        cs: "třetí vrchol trojúhelníku A",
        hr: "treći vrh trokuta A",
    }

    /// An input.
    CORNER_B {
        en: "the third corner of the triangle B",
        it: "il terzo vertice del triangolo B",
        cs: "třetí vrchol trojúhelníku B",
        hr: "treći vrh trokuta B",
    }
}

/// Pixels across and down.
const SIZE: u32 = 6;
const RANGE: [[f64; 2]; 2] = [[0.0; 2], [6.0; 2]];
// The common edge runs through four centres, the others through none.
const P: Ask<DVec2> = Ask::point("p", "*P*", FROM, [1.0, 1.0], RANGE);
const Q: Ask<DVec2> = Ask::point("q", "*Q*", TO, [5.0, 5.0], RANGE);
const A: Ask<DVec2> = Ask::point("a", "*A*", CORNER_A, [5.3, 0.7], RANGE);
const B: Ask<DVec2> = Ask::point("b", "*B*", CORNER_B, [0.7, 5.3], RANGE);

/// Two triangles with a common edge.
struct Pair {
    edge: [DVec2; 2],
    triangles: [[DVec2; 3]; 2],
}

impl Pair {
    fn of(inputs: &Inputs) -> Pair {
        let [p, q] = [P, Q].map(|ask| inputs.get(&ask));
        let [a, b] = [A, B].map(|ask| inputs.get(&ask));
        Pair {
            edge: [p, q],
            triangles: [[p, a, q], [p, q, b]],
        }
    }

    /// The pixels whose centres lie on the common edge, between its ends.
    fn centres_on_edge(&self) -> Vec<IVec2> {
        let [from, to] = self.edge;
        let last = IVec2::splat(SIZE as i32 - 1);
        let on_edge = |pixel: &IVec2| {
            let centre = pixel.as_dvec2() + 0.5;
            orient_2d(from, to, centre) == Some(Ordering::Equal)
                && centre != from
                && centre != to
                && centre.cmpge(from.min(to)).all()
                && centre.cmple(from.max(to)).all()
        };
        fill(IVec2::ZERO, last).filter(on_edge).collect()
    }

    fn drawn(&self, rule: EdgeRule) -> Drawn {
        let [of_a, of_b] = self.triangles.map(|triangle| pixels(triangle, rule));
        let (both, only_a): (Vec<IVec2>, Vec<IVec2>) = of_a.iter().partition(|p| of_b.contains(p));
        let only_b = of_b.iter().copied().filter(|p| !both.contains(p)).collect();
        let mut none = self.centres_on_edge();
        none.retain(|p| !of_a.contains(p) && !of_b.contains(p));
        Drawn {
            only_a,
            only_b,
            both,
            none,
        }
    }
}

/// Who owns what.
struct Drawn {
    only_a: Vec<IVec2>,
    only_b: Vec<IVec2>,
    both: Vec<IVec2>,
    /// On the common edge and in neither.
    none: Vec<IVec2>,
}

impl Drawn {
    /// In words.
    fn said(&self, language: Language) -> String {
        let count = |word: Word, of: &[IVec2]| {
            (!of.is_empty()).then(|| filled(word, language, &[&of.len().to_string()]))
        };
        let said = [count(TWICE, &self.both), count(MISSING, &self.none)];
        let said: Vec<String> = said.into_iter().flatten().collect();
        if said.is_empty() {
            return ONCE.text(language).to_owned();
        }
        said.join(", ")
    }
}

fn draw(sheet: &mut Sheet, inputs: &Inputs) -> Result<(), FigureError> {
    let language = sheet.style().language;
    let pair = Pair::of(inputs);
    let rules = [
        (TOP_LEFT, EdgeRule::TopLeft),
        (CLOSED, EdgeRule::Closed),
        (OPEN, EdgeRule::Open),
    ];
    let pictures = rules.map(|(word, rule)| (word, pair.drawn(rule)));
    let lines = pictures
        .each_ref()
        .map(|(word, drawn)| format!("{}: {}", word.text(language), drawn.said(language)));
    let lines = lines.each_ref().map(String::as_str);
    let panels = panels(sheet, &lines, 1.0)?;
    for (i, (panel, (_, drawn))) in panels.into_iter().zip(&pictures).enumerate() {
        sheet.panel(i, panel);
        draw_pixels(sheet, panel, &pair, drawn)?;
    }
    Ok(())
}

/// The pixels of the triangle by `rule`; none where it is not finite.
fn pixels(triangle: [DVec2; 3], rule: EdgeRule) -> Vec<IVec2> {
    let mut pixels = Vec::new();
    let _ = cover_plain(triangle, rule, SIZE, SIZE, &mut (), |pixel| {
        pixels.push(pixel.as_ivec2());
    });
    pixels
}

fn draw_pixels(
    sheet: &mut Sheet,
    panel: Rect,
    pair: &Pair,
    drawn: &Drawn,
) -> Result<(), FigureError> {
    let last = IVec2::splat(SIZE as i32 - 1);
    let grid = Grid::fit(IVec2::ZERO, last, Orientation::Picture, panel);
    let (blue, green) = (Ink::of(Role::Curve(0)), Ink::of(Role::Curve(2)));
    grid.draw_cells(sheet);
    grid.fill(sheet, &drawn.only_a, blue);
    grid.fill(sheet, &drawn.only_b, green.tint(0.5));
    grid.hatch(sheet, &drawn.only_b, Pen::new(green, THIN));
    // A mistake has a border of its own.
    grid.fill(sheet, &drawn.both, Ink::of(Role::Undecided).tint(0.9));
    for wrong in [&drawn.both, &drawn.none] {
        sheet.stroke_unmarked(grid.cells(wrong), Pen::new(Role::Undecided, NORMAL));
    }
    grid.draw_centres(sheet);
    for triangle in pair.triangles {
        grid.polygon(sheet, &triangle);
    }
    for pixel in pair.centres_on_edge() {
        sheet.dot(grid.centre(pixel), 0.8 * marks::DOT, Role::Text);
    }
    // How often each pixel of the edge is drawn, off the edge.
    let [from, to] = pair.edge;
    let aside = (grid.at(to) - grid.at(from)).normalize_or_zero().perp();
    for pixel in pair.centres_on_edge() {
        let times = if drawn.none.contains(&pixel) {
            "0"
        } else if drawn.both.contains(&pixel) {
            "2"
        } else {
            "1"
        };
        let at = grid.centre(pixel) + 0.36 * grid.cell() * aside;
        sheet.text(at, Align::Centre, times, NOTE, Role::Text)?;
    }
    for (triangle, name) in pair.triangles.into_iter().zip(["*A*", "*B*"]) {
        let middle = grid.at((triangle[0] + triangle[1] + triangle[2]) / 3.0);
        let label = Label::new(middle, name).reach(0.0).size(1.25 * LABEL);
        sheet.label(label.beside());
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By the exact predicate alone: on the left of all three sides, or on the right, with the sides or without.
    fn owners(pair: &Pair, pixel: IVec2, on_sides: bool) -> usize {
        let p = pixel.as_dvec2() + 0.5;
        let holds = |[a, b, c]: &[DVec2; 3]| {
            let sides = [(a, b), (b, c), (c, a)].map(|(a, b)| orient_2d(*a, *b, p).unwrap());
            let whole = orient_2d(*a, *b, *c).unwrap();
            sides
                .iter()
                .all(|&side| side == whole || (on_sides && side == Ordering::Equal))
        };
        pair.triangles
            .iter()
            .filter(|triangle| holds(triangle))
            .count()
    }

    #[test]
    fn pixels_of_the_edge_are_drawn_once_twice_and_never() {
        let pair = Pair::of(&Inputs::default());
        let on_edge = pair.centres_on_edge();
        assert_eq!(
            on_edge,
            [1, 2, 3, 4].map(IVec2::splat),
            "the edge y = x from 1 to 5"
        );
        let last = IVec2::splat(SIZE as i32 - 1);
        for (rule, times) in [
            (EdgeRule::TopLeft, 1),
            (EdgeRule::Closed, 2),
            (EdgeRule::Open, 0),
        ] {
            let drawn = pair.triangles.map(|triangle| pixels(triangle, rule));
            for pixel in fill(IVec2::ZERO, last) {
                let count = drawn.iter().filter(|of| of.contains(&pixel)).count();
                if on_edge.contains(&pixel) {
                    assert_eq!(count, times, "{rule:?} {pixel}");
                } else {
                    // No other side meets a centre.
                    assert_eq!(owners(&pair, pixel, true), owners(&pair, pixel, false));
                    assert_eq!(count, owners(&pair, pixel, true), "{rule:?} {pixel}");
                }
                if rule != EdgeRule::TopLeft {
                    assert_eq!(count, owners(&pair, pixel, rule == EdgeRule::Closed));
                }
            }
            let Drawn { both, none, .. } = pair.drawn(rule);
            assert_eq!(
                [both.len(), none.len()],
                [times / 2, usize::from(times == 0)].map(|n| 4 * n)
            );
        }
    }
}
