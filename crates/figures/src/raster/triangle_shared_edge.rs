//! Two triangles with a common edge through pixel centres, under three rules.

use core::cmp::Ordering;

use ombra_math::glam::{DVec2, IVec2};
use ombra_math::predicates::orient_2d;
use ombra_raster::rectangle::fill;
use ombra_raster::triangle::{EdgeRule, cover_plain};

use crate::colour::{Ink, Role};
use crate::drawing::{Pen, THIN};
use crate::error::FigureError;
use crate::figure::{About, Figure, Takes};
use crate::marks;
use crate::panels::panels;
use crate::path::Rect;
use crate::pixels::{Grid, Orientation};
use crate::sheet::{Align, Sheet};
use crate::text::LABEL;
use crate::words::words;

pub(super) const FIGURE: Figure = Figure {
    id: "raster/triangle-shared-edge",
    takes: Takes::Nothing(crate::words::FIXED),
    words: WORDS,
    about: |_, language| About::new(language, SUMMARY, CAPTION),
    drawn: |sheet, _| draw(sheet),
};

words! {
    SUMMARY {
        en: "Two triangles with a common edge: one owner a pixel, and what comes without the rule",
        it: "Due triangoli con un lato comune: un solo proprietario per pixel, e che cosa succede senza regola",
        cs: "Dva trojúhelníky se společnou hranou: každý pixel má jednoho vlastníka, a co nastane bez pravidla",
        hr: "Dva trokuta sa zajedničkim bridom: svaki piksel ima jednog vlasnika, i što biva bez pravila",
    }

    CAPTION {
        en: "The edge runs through six centres. A centre on an edge belongs to the triangle for which the edge is a top or a left one.",
        it: "Il lato passa per sei centri. Un centro su un lato appartiene al triangolo per cui quel lato è in alto o a sinistra.",
        cs: "Hrana prochází šesti středy. Střed na hraně patří trojúhelníku, pro který je hrana horní nebo levá.",
        hr: "Brid prolazi kroz šest središta. Središte na bridu pripada trokutu kojemu je taj brid gornji ili lijevi.",
    }

    /// The first picture.
    TOP_LEFT {
        en: "top-left rule: one owner each",
        it: "alto-sinistra: un solo proprietario",
        cs: "vlevo-nahoře: jeden vlastník",
        hr: "gore-lijevo: jedan vlasnik",
    }

    /// The second picture.
    CLOSED {
        en: "edges inside: drawn twice",
        it: "lati compresi: disegnati due volte",
        cs: "hrany uvnitř: kresleno dvakrát",
        hr: "bridovi unutra: crtano dvaput",
    }

    /// The third picture.
    OPEN {
        en: "edges outside: gaps",
        it: "lati esclusi: buchi",
        cs: "hrany venku: mezery",
        hr: "bridovi izvan: rupe",
    }
}

const SIZE: u32 = 8;
/// The shared edge runs through six centres, the others through none.
const SHARED: [(f64, f64); 2] = [(1.0, 1.0), (7.0, 7.0)];
const A: (f64, f64) = (7.3, 0.7);
const B: (f64, f64) = (0.7, 7.3);

fn draw(sheet: &mut Sheet) -> Result<(), FigureError> {
    let language = sheet.style().language;
    let rules = [
        (TOP_LEFT, EdgeRule::TopLeft),
        (CLOSED, EdgeRule::Closed),
        (OPEN, EdgeRule::Open),
    ];
    let lines = rules.map(|(word, _)| word.text(language));
    for (panel, (_, rule)) in panels(sheet, &lines, 1.0)?.into_iter().zip(rules) {
        draw_rule(sheet, panel, rule)?;
    }
    Ok(())
}

/// The two triangles.
fn triangles() -> [[DVec2; 3]; 2] {
    let [from, to] = SHARED.map(DVec2::from);
    [[from, A.into(), to], [from, to, B.into()]]
}

/// The pixels of the triangle by `rule`; none where it is not finite.
fn pixels(triangle: [DVec2; 3], rule: EdgeRule) -> Vec<IVec2> {
    let mut pixels = Vec::new();
    let _ = cover_plain(triangle, rule, SIZE, SIZE, &mut (), |pixel| {
        pixels.push(pixel.as_ivec2());
    });
    pixels
}

/// The pixels whose centres lie on the shared edge.
fn centres_on_edge() -> Vec<IVec2> {
    let [from, to] = SHARED.map(DVec2::from);
    let last = IVec2::splat(SIZE as i32 - 1);
    let on_edge = |pixel: &IVec2| {
        let centre = pixel.as_dvec2() + 0.5;
        orient_2d(from, to, centre) == Some(Ordering::Equal)
            && centre.cmpge(from.min(to)).all()
            && centre.cmple(from.max(to)).all()
    };
    fill(IVec2::ZERO, last).filter(on_edge).collect()
}

fn draw_rule(sheet: &mut Sheet, panel: Rect, rule: EdgeRule) -> Result<(), FigureError> {
    let last = IVec2::splat(SIZE as i32 - 1);
    let grid = Grid::fit(IVec2::ZERO, last, Orientation::Picture, panel);
    let [a, b] = triangles();
    let [of_a, of_b] = [a, b].map(|triangle| pixels(triangle, rule));
    let (both, only_a): (Vec<IVec2>, Vec<IVec2>) = of_a.iter().partition(|p| of_b.contains(p));
    let on = [
        (Ink::of(Role::Curve(0)), &only_a[..]),
        (Ink::of(Role::Curve(2)), &of_b[..]),
    ];
    grid.draw(sheet, &on);
    sheet.fill_unmarked(
        grid.cells(&both),
        Ink::of(Role::Chosen),
        Pen::new(Role::Chosen, THIN),
    );
    for triangle in [a, b] {
        grid.polygon(sheet, &triangle);
    }
    for pixel in centres_on_edge() {
        sheet.dot(grid.centre(pixel), 0.8 * marks::DOT, Role::Text);
    }
    for (triangle, name) in [(a, "*A*"), (b, "*B*")] {
        let middle = (triangle[0] + triangle[1] + triangle[2]) / 3.0;
        let at = grid.centre(middle.floor().as_ivec2());
        sheet.text(at, Align::Centre, name, 1.25 * LABEL, Role::Text)?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By the exact predicate alone: on the left of all three sides, or on the right, with the sides or without.
    fn owners(pixel: IVec2, on_sides: bool) -> usize {
        let p = pixel.as_dvec2() + 0.5;
        let holds = |[a, b, c]: &[DVec2; 3]| {
            let sides = [(a, b), (b, c), (c, a)].map(|(a, b)| orient_2d(*a, *b, p).unwrap());
            let whole = orient_2d(*a, *b, *c).unwrap();
            sides
                .iter()
                .all(|&side| side == whole || (on_sides && side == Ordering::Equal))
        };
        triangles()
            .iter()
            .filter(|triangle| holds(triangle))
            .count()
    }

    #[test]
    fn pixels_of_the_edge_are_drawn_once_twice_and_never() {
        let on_edge = centres_on_edge();
        assert_eq!(
            on_edge,
            [1, 2, 3, 4, 5, 6].map(IVec2::splat),
            "the edge y = x from 1 to 7"
        );
        let last = IVec2::splat(SIZE as i32 - 1);
        for (rule, times) in [
            (EdgeRule::TopLeft, 1),
            (EdgeRule::Closed, 2),
            (EdgeRule::Open, 0),
        ] {
            let drawn = triangles().map(|triangle| pixels(triangle, rule));
            for pixel in fill(IVec2::ZERO, last) {
                let count = drawn.iter().filter(|of| of.contains(&pixel)).count();
                if on_edge.contains(&pixel) {
                    assert_eq!(count, times, "{rule:?} {pixel}");
                } else {
                    // No other side meets a centre.
                    assert_eq!(owners(pixel, true), owners(pixel, false));
                    assert_eq!(count, owners(pixel, true), "{rule:?} {pixel}");
                }
                if rule != EdgeRule::TopLeft {
                    assert_eq!(count, owners(pixel, rule == EdgeRule::Closed));
                }
            }
        }
    }
}
