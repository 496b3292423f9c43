//! What becomes of a polygon: one polygon, several, and always closed.

use ombra_clip::{Segment, Window, cohen_sutherland, pieces, sutherland_hodgman};
use ombra_math::glam::DVec2;

use super::board::{Board, window};
use crate::colour::Role;
use crate::drawing::{EMPHASIS, Pen};
use crate::error::FigureError;
use crate::figure::{About, Figure, Takes};
use crate::panels::panels;
use crate::sheet::Sheet;
use crate::words::words;

/// A, B and C of Grafica 3, Clipping di un poligono.
pub(super) const FIGURE: Figure = Figure {
    id: "clip/polygon-cases",
    takes: Takes::Nothing(crate::words::FIXED),
    words: WORDS,
    about: |_, language| About::new(language, SUMMARY, CAPTION),
    drawn: |sheet, _| draw(sheet),
};

words! {
    SUMMARY {
        en: "What clipping makes of a polygon: one, several pieces, always closed",
        it: "Che cosa diventa un poligono: uno, più componenti, sempre chiusi",
        cs: "Co se stane s polygonem: jeden, více částí, vždy uzavřené",
        hr: "Što postaje od poligona: jedan, više dijelova, uvijek zatvoreni",
    }

    CAPTION {
        en: "A bridge edge runs back and forth along the border between two pieces. In C the thick edges alone would be loose; the border closes them.",
        it: "Un lato ponte percorre il bordo avanti e indietro tra due componenti. In C i lati spessi da soli sarebbero sconnessi; il bordo li chiude.",
        cs: "Spojovací hrana běží mezi dvěma částmi po hranici tam a zpět. V C by samy tlusté hrany byly volné; uzavírá je hranice.",
        hr: "Spojni brid ide rubom između dvaju dijelova naprijed i natrag. U C bi sami debeli bridovi bili slobodni; rub ih zatvara.",
    }

    /// The first picture.
    CASE_CONVEX {
        en: "A convex: one polygon",
        it: "A convesso: un poligono",
        cs: "A konvexní: jeden polygon",
        hr: "A konveksan: jedan poligon",
    }

    /// The second picture.
    CASE_BRIDGES {
        en: "B concave: a bridge edge",
        it: "B concavo: un lato ponte",
        cs: "B nekonvexní: spojovací hrana",
        hr: "B konkavan: spojni brid",
    }

    /// The third picture.
    CASE_PIECES {
        en: "B: separate pieces",
        it: "B: componenti separate",
        cs: "B: oddělené části",
        hr: "B: odvojeni dijelovi",
    }

    /// The fourth picture.
    CASE_CLOSED {
        en: "C: a closed polygon",
        it: "C: un poligono chiuso",
        cs: "C: uzavřený obrys",
        hr: "C: zatvoren poligon",
    }
}

const WINDOW: Window = window(0.0, 0.0, 10.0, 18.0);
const SHOWN: Window = window(-0.6, -2.4, 15.6, 22.4);
const CONVEX: [(f64, f64); 5] = [
    (4.4, 2.8),
    (12.0, 2.0),
    (15.0, 9.6),
    (10.6, 16.0),
    (2.4, 10.8),
];
/// A comb whose back lies beyond the window.
const CONCAVE: [(f64, f64); 8] = [
    (15.0, 1.4),
    (15.0, 16.6),
    (2.0, 15.8),
    (2.0, 11.2),
    (12.6, 11.8),
    (12.6, 6.2),
    (2.0, 6.8),
    (2.0, 2.2),
];
/// Around a corner of the window.
const CORNER: [(f64, f64); 3] = [(2.0, 6.8), (15.0, 3.4), (8.0, 22.0)];

fn draw(sheet: &mut Sheet) -> Result<(), FigureError> {
    let language = sheet.style().language;
    let lines =
        [CASE_CONVEX, CASE_BRIDGES, CASE_PIECES, CASE_CLOSED].map(|word| word.text(language));
    let boards: Vec<Board> = panels(sheet, &lines, 1.55)?
        .into_iter()
        .map(|panel| Board::fit(WINDOW, SHOWN, panel))
        .collect::<Result<_, _>>()?;
    let [convex, bridges, separate, closed] = &boards[..] else {
        return Ok(());
    };
    let [a, c] = [
        CONVEX.map(DVec2::from).to_vec(),
        CORNER.map(DVec2::from).to_vec(),
    ];
    let b = CONCAVE.map(DVec2::from);

    convex.draw(sheet, &a, &pieces::clip_polygon(&WINDOW, &a));

    let one = sutherland_hodgman::clip_polygon(&WINDOW, &b);
    let parts = pieces::clip_polygon(&WINDOW, &b);
    bridges.draw(sheet, &b, core::slice::from_ref(&one));
    for [from, to] in bridge_edges(&one, &parts) {
        let [from, to] = [from, to].map(|p| bridges.at(p));
        sheet.line(from, to, Pen::new(Role::Chosen, 1.6 * EMPHASIS));
    }
    separate.draw(sheet, &b, &parts);

    closed.draw(sheet, &c, &pieces::clip_polygon(&WINDOW, &c));
    for (&from, &to) in c.iter().zip(c.iter().cycle().skip(1)) {
        if let Some(kept) = cohen_sutherland::clip_segment(&WINDOW, Segment::new(from, to)) {
            let [from, to] = [kept.a, kept.b].map(|p| closed.at(p));
            sheet.line(from, to, Pen::new(Role::Text, EMPHASIS));
        }
    }
    Ok(())
}

impl Board {
    fn draw(&self, sheet: &mut Sheet, polygon: &[DVec2], kept: &[Vec<DVec2>]) {
        self.draw_window(sheet);
        self.draw_cut_off(sheet, polygon);
        for piece in kept {
            self.draw_kept(sheet, piece);
        }
    }
}

/// The parts of the right side that the edges of `one` run along and no edge of `parts` does.
fn bridge_edges(one: &[DVec2], parts: &[Vec<DVec2>]) -> Vec<[DVec2; 2]> {
    let side = WINDOW.max.x;
    let mut ends: Vec<f64> = one.iter().filter(|p| p.x == side).map(|p| p.y).collect();
    ends.sort_by(f64::total_cmp);
    ends.dedup();
    let runs_along = |polygon: &[DVec2], y: f64| {
        let next = polygon.iter().cycle().skip(1);
        let mut edges = polygon.iter().zip(next);
        edges.any(|(a, b)| a.x == side && b.x == side && (a.y < y) != (b.y < y))
    };
    ends.windows(2)
        .filter_map(|pair| {
            let &[low, high] = pair else { return None };
            let middle = 0.5 * (low + high);
            let is_bridge =
                runs_along(one, middle) && !parts.iter().any(|part| runs_along(part, middle));
            is_bridge.then_some([low, high].map(|y| DVec2::new(side, y)))
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_comb_falls_into_two_pieces_and_one_edge_bridges_them() {
        let comb = CONCAVE.map(DVec2::from);
        let one = sutherland_hodgman::clip_polygon(&WINDOW, &comb);
        let parts = pieces::clip_polygon(&WINDOW, &comb);
        assert_eq!(parts.iter().map(Vec::len).collect::<Vec<_>>(), [4, 4]);
        let [[low, high]] = bridge_edges(&one, &parts)[..] else {
            panic!("{one:?} {parts:?}");
        };
        // The gap between the teeth at x = 10: 0.6 up or down over 10.6, of which 8 lie inside.
        let slope = 0.6 * 8.0 / 10.6;
        assert!((low - DVec2::new(10.0, 6.8 - slope)).length() <= 8.0 * f64::EPSILON);
        assert!((high - DVec2::new(10.0, 11.2 + slope)).length() <= 16.0 * f64::EPSILON);
        // Where no edge runs there is no bridge, whatever lies above and below.
        let notched = [
            (10.0, 1.0),
            (10.0, 4.0),
            (5.0, 5.0),
            (10.0, 6.0),
            (10.0, 9.0),
            (2.0, 5.0),
        ];
        let found = bridge_edges(&notched.map(DVec2::from), &[]);
        assert_eq!(
            found.iter().map(|[low, _]| low.y).collect::<Vec<_>>(),
            [1.0, 6.0]
        );
        // Separate pieces need none, nor does what is in one piece anyway.
        assert_eq!(
            bridge_edges(&parts.concat(), &[one]),
            Vec::<[DVec2; 2]>::new()
        );
        let convex = CONVEX.map(DVec2::from);
        let one = sutherland_hodgman::clip_polygon(&WINDOW, &convex);
        let parts = pieces::clip_polygon(&WINDOW, &convex);
        assert_eq!(parts.len(), 1);
        assert_eq!(bridge_edges(&one, &parts), Vec::<[DVec2; 2]>::new());
    }

    #[test]
    fn the_edges_of_c_are_loose_without_the_border() {
        let polygon = CORNER.map(DVec2::from);
        let kept = pieces::clip_polygon(&WINDOW, &polygon);
        // Three edges leave three segments with four ends on the border; two edges along it close them.
        assert_eq!(kept.iter().map(Vec::len).collect::<Vec<_>>(), [5]);
        let on_border = |p: &DVec2| p.x == WINDOW.max.x || p.y == WINDOW.max.y;
        assert_eq!(kept.concat().iter().filter(|p| on_border(p)).count(), 4);
    }
}
