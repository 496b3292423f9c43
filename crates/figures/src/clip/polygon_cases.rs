//! What becomes of a polygon: one polygon, several, and always closed.

use ombra_clip::{Segment, Window, cohen_sutherland, pieces, sutherland_hodgman};
use ombra_math::glam::DVec2;

use super::board::{Board, POLYGON_WORD, RANGE, asked, between, shown};
use crate::colour::Role;
use crate::drawing::{EMPHASIS, NORMAL, Pen};
use crate::error::FigureError;
use crate::figure::{About, Figure, Takes};
use crate::input::{Ask, Inputs};
use crate::marks;
use crate::panels::panels;
use crate::sheet::{Align, Label, Sheet};
use crate::text::LABEL;
use crate::words::words;

/// A, B and C of Grafica 3, Clipping di un poligono.
pub(super) const FIGURE: Figure = Figure {
    id: "clip/polygon-cases",
    takes: Takes::These(&[CONVEX.input, POLYGON.input, CORNER.input, WINDOW.input]),
    words: WORDS,
    about: |_, language| About::new(language, SUMMARY, CAPTION),
    drawn: draw,
};

words! {
    SUMMARY {
        en: "What clipping makes of a polygon: one, several pieces, always closed",
        it: "Che cosa diventa un poligono: uno, più componenti, sempre chiusi",
        cs: "Co se stane s polygonem: jeden, více částí, vždy uzavřené",
        hr: "Što postaje od poligona: jedan, više dijelova, uvijek zatvoreni",
    }

    CAPTION {
        en: "Sutherland–Hodgman leaves one polygon, with bridge edges along the border where it should be several. Edges clipped one by one are loose; the border closes them.",
        it: "Sutherland–Hodgman lascia un solo poligono, con lati ponte lungo il bordo dove dovrebbero essercene più d’uno. I lati tagliati uno per uno sono sconnessi; il bordo li chiude.",
        cs: "Sutherland–Hodgman nechá jeden polygon, se spojovacími hranami podél hranice, kde by jich mělo být více. Hrany ořezané po jedné jsou volné; uzavírá je hranice.",
        hr: "Sutherland–Hodgman ostavlja jedan poligon, sa spojnim bridovima uz rub gdje bi ih trebalo biti više. Bridovi odsječeni jedan po jedan slobodni su; rub ih zatvara.",
    }

    /// The first picture.
    CASE_CONVEX {
        en: "convex *A*: one",
        it: "*A* convesso: uno",
        cs: "*A* konvexní: jeden",
        hr: "*A* konveksan: jedan",
    }

    /// The first picture, of another polygon.
    CASE_ONE {
        en: "*A* clipped",
        it: "*A* tagliato",
        cs: "*A* oříznutý",
        hr: "*A* odsječen",
    }

    /// The second picture.
    CASE_BRIDGES {
        en: "*B* as one: a bridge",
        it: "*B* come uno: un ponte",
        cs: "*B* jako jeden: most",
        hr: "*B* kao jedan: most",
    }

    /// The second picture, of another polygon.
    CASE_NO_BRIDGE {
        en: "*B* as one: no bridge",
        it: "*B* come uno: nessun ponte",
        cs: "*B* jako jeden: bez mostu",
        hr: "*B* kao jedan: bez mosta",
    }

    /// The third picture, with the number of pieces.
    CASE_PIECES {
        en: "*B* in pieces: %1",
        it: "*B* in componenti: %1",
        cs: "*B* po částech: %1",
        hr: "*B* u dijelovima: %1",
    }

    /// The fourth picture.
    CASE_LOOSE {
        en: "edges of *C*: loose",
        it: "lati di *C*: aperti",
        cs: "hrany *C*: volné",
        hr: "bridovi *C*: slobodni",
    }

    /// The last picture.
    CASE_CLOSED {
        en: "polygon *C*: closed",
        it: "poligono *C*: chiuso",
        cs: "polygon *C*: uzavřený",
        hr: "poligon *C*: zatvoren",
    }

    /// Beside a bridge edge.
    BRIDGE {
        en: "bridge",
        it: "ponte",
        cs: "most",
        hr: "most",
    }

    /// An input.
    FIRST_WORD {
        en: "corners of the polygon A",
        it: "vertici del poligono A",
        cs: "vrcholy polygonu A",
        hr: "vrhovi poligona A",
    }

    /// An input.
    LAST_WORD {
        en: "corners of the polygon C",
        it: "vertici del poligono C",
        cs: "vrcholy polygonu C",
        hr: "vrhovi poligona C",
    }
}

const CONVEX: Ask<Vec<DVec2>> = Ask::polygon(
    "convex",
    "*A*",
    FIRST_WORD,
    &[[3.4, 1.2], [10.6, 0.8], [13.4, 5.4], [9.6, 9.2], [1.6, 6.4]],
    [3, 24],
    RANGE,
);
/// A comb whose back lies beyond the window.
const POLYGON: Ask<Vec<DVec2>> = Ask::polygon(
    "polygon",
    "*B*",
    POLYGON_WORD,
    &[
        [13.6, 0.6],
        [13.6, 9.4],
        [1.6, 9.0],
        [1.6, 6.8],
        [11.8, 7.0],
        [11.8, 3.0],
        [1.6, 3.2],
        [1.6, 1.0],
    ],
    [3, 24],
    RANGE,
);
/// Around a corner of the window.
const CORNER: Ask<Vec<DVec2>> = Ask::polygon(
    "corner",
    "*C*",
    LAST_WORD,
    &[[1.6, 3.6], [13.6, 1.6], [7.0, 12.6]],
    [3, 24],
    RANGE,
);
const WINDOW: Ask<Vec<DVec2>> = asked(&[[0.0, 0.0], [10.0, 10.0]]);
/// Free around window and polygons.
const AROUND: f64 = 0.04;

fn draw(sheet: &mut Sheet, inputs: &Inputs) -> Result<(), FigureError> {
    let language = sheet.style().language;
    let window = between(&inputs.get(&WINDOW));
    let [a, b, c] = [&CONVEX, &POLYGON, &CORNER].map(|ask| inputs.get(ask));
    let one = sutherland_hodgman::clip_polygon(&window, &b);
    let parts = pieces::clip_polygon(&window, &b);
    let bridges = bridge_edges(&window, &one, &parts);
    let first = match (inputs.has(&CONVEX), inputs.has(&WINDOW)) {
        (false, false) => CASE_CONVEX,
        _ => CASE_ONE,
    };
    let second = if bridges.is_empty() {
        CASE_NO_BRIDGE
    } else {
        CASE_BRIDGES
    };
    let third = CASE_PIECES
        .text(language)
        .replace("%1", &parts.len().to_string());
    let [first, second, fourth, fifth] =
        [first, second, CASE_LOOSE, CASE_CLOSED].map(|word| word.text(language));
    let lines = [first, second, &third, fourth, fifth];
    let shown = shown(&window, &[a.clone(), b.clone(), c.clone()].concat(), AROUND);
    let size = shown.max - shown.min;
    let panels = panels(sheet, &lines, (size.y / size.x).clamp(0.5, 2.0))?;

    for (i, panel) in panels.into_iter().enumerate() {
        sheet.panel(i, panel);
        let board = Board::fit(window, shown, panel)?;
        board.draw_window(sheet);
        match i {
            0 => board.draw_pieces(sheet, &a, &pieces::clip_polygon(&window, &a), "*A*")?,
            1 => {
                board.draw_pieces(sheet, &b, core::slice::from_ref(&one), "*B*")?;
                // One that should not be there is in no colour of what is chosen.
                for ends in &bridges {
                    let [from, to] = ends.map(|p| board.at(p));
                    sheet.line(from, to, Pen::new(Role::Undecided, 1.6 * EMPHASIS));
                }
                if let Some(&[from, to]) = bridges.first() {
                    let middle = board.at(0.5 * (from + to));
                    let label = Label::new(middle, BRIDGE.text(language));
                    sheet.label(label.towards(DVec2::NEG_X).reach(12.0).beside());
                }
            }
            2 => board.draw_pieces(sheet, &b, &parts, "*B*")?,
            3 => board.draw_loose(sheet, &c),
            _ => board.draw_pieces(sheet, &c, &pieces::clip_polygon(&window, &c), "*C*")?,
        }
    }
    Ok(())
}

impl Board {
    /// What is kept of a polygon, each piece with its name.
    fn draw_pieces(
        &self,
        sheet: &mut Sheet,
        polygon: &[DVec2],
        kept: &[Vec<DVec2>],
        name: &str,
    ) -> Result<(), FigureError> {
        self.draw_cut_off(sheet, polygon);
        for (i, piece) in kept.iter().enumerate() {
            self.draw_kept(sheet, piece);
            if let Some(inside) = within(piece) {
                let mut name = name.to_owned();
                if kept.len() > 1 {
                    name = format!("{name}_{{{}}}", i + 1);
                }
                sheet.text(self.at(inside), Align::Centre, &name, LABEL, Role::Text)?;
            }
        }
        Ok(())
    }

    /// The edges of a polygon, each clipped for itself.
    fn draw_loose(&self, sheet: &mut Sheet, polygon: &[DVec2]) {
        self.draw_cut_off(sheet, polygon);
        for (&from, &to) in polygon.iter().zip(polygon.iter().cycle().skip(1)) {
            let kept = cohen_sutherland::clip_segment(&self.window, Segment::new(from, to));
            if let Some(Segment { a, b }) = kept {
                sheet.line(self.at(a), self.at(b), Pen::new(Role::Undecided, NORMAL));
                for (end, given) in [(a, from), (b, to)] {
                    if end != given {
                        marks::hollow_point(sheet, self.at(end), Role::Undecided);
                    }
                }
            }
        }
    }
}

/// A place well inside a polygon: the middle of the widest stretch at one of several heights; none where it is flat.
fn within(polygon: &[DVec2]) -> Option<DVec2> {
    let ys = polygon.iter().map(|p| p.y);
    let (low, high) = ys.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), y| {
        (low.min(y), high.max(y))
    });
    let mut best: Option<(f64, DVec2)> = None;
    for share in [0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8] {
        let y = low + (high - low) * share;
        let mut crossings: Vec<f64> = Vec::new();
        for (a, b) in polygon.iter().zip(polygon.iter().cycle().skip(1)) {
            if (a.y < y) != (b.y < y) {
                crossings.push(a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y)));
            }
        }
        crossings.sort_by(f64::total_cmp);
        for &[from, to] in crossings.as_chunks::<2>().0 {
            // The middle height has the first choice.
            if best.is_none_or(|(width, _)| to - from > 1.25 * width) {
                best = Some((to - from, DVec2::new(0.5 * (from + to), y)));
            }
        }
    }
    best.filter(|(width, _)| *width > 0.0)
        .map(|(_, place)| place)
}

/// The parts of the window's sides that the edges of `one` run along and no edge of `parts` does.
fn bridge_edges(window: &Window, one: &[DVec2], parts: &[Vec<DVec2>]) -> Vec<[DVec2; 2]> {
    let upright = |p: DVec2| p;
    let level = |p: DVec2| DVec2::new(p.y, p.x);
    let mut found = Vec::new();
    for (side, turn) in [
        (window.max.x, upright as fn(DVec2) -> DVec2),
        (window.min.x, upright),
        (window.max.y, level),
        (window.min.y, level),
    ] {
        let turned = |polygon: &[DVec2]| polygon.iter().map(|&p| turn(p)).collect::<Vec<_>>();
        let parts: Vec<Vec<DVec2>> = parts.iter().map(|part| turned(part)).collect();
        let bridges = bridges_along(side, &turned(one), &parts);
        found.extend(bridges.into_iter().map(|ends| ends.map(turn)));
    }
    found
}

/// The same for the side whose points have the one x.
fn bridges_along(side: f64, one: &[DVec2], parts: &[Vec<DVec2>]) -> Vec<[DVec2; 2]> {
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
        let (window, comb) = (
            between(&Inputs::default().get(&WINDOW)),
            Inputs::default().get(&POLYGON),
        );
        let one = sutherland_hodgman::clip_polygon(&window, &comb);
        let parts = pieces::clip_polygon(&window, &comb);
        assert_eq!(parts.iter().map(Vec::len).collect::<Vec<_>>(), [4, 4]);
        let [[low, high]] = bridge_edges(&window, &one, &parts)[..] else {
            panic!("{one:?} {parts:?}");
        };
        // The gap between the teeth at x = 10: 0.2 up or down over 10.2, of which 8.4 lie inside.
        let slope = 0.2 * 8.4 / 10.2;
        assert!((low - DVec2::new(10.0, 3.2 - slope)).length() <= 8.0 * f64::EPSILON);
        assert!((high - DVec2::new(10.0, 6.8 + slope)).length() <= 16.0 * f64::EPSILON);
        // Where no edge runs there is no bridge, whatever lies above and below.
        let notched = [
            (10.0, 1.0),
            (10.0, 4.0),
            (5.0, 5.0),
            (10.0, 6.0),
            (10.0, 9.0),
            (2.0, 5.0),
        ];
        let found = bridge_edges(&window, &notched.map(DVec2::from), &[]);
        assert_eq!(
            found.iter().map(|[low, _]| low.y).collect::<Vec<_>>(),
            [1.0, 6.0]
        );
        // Separate pieces need none, nor does what is in one piece anyway.
        assert_eq!(
            bridge_edges(&window, &parts.concat(), &[one]),
            Vec::<[DVec2; 2]>::new()
        );
        let convex = Inputs::default().get(&CONVEX);
        let one = sutherland_hodgman::clip_polygon(&window, &convex);
        let parts = pieces::clip_polygon(&window, &convex);
        assert_eq!(parts.len(), 1);
        assert_eq!(
            bridge_edges(&window, &one, &parts),
            Vec::<[DVec2; 2]>::new()
        );
    }

    #[test]
    fn the_edges_of_c_are_loose_without_the_border() {
        let inputs = Inputs::default();
        let (window, polygon) = (between(&inputs.get(&WINDOW)), inputs.get(&CORNER));
        let kept = pieces::clip_polygon(&window, &polygon);
        // Three edges leave three segments with four ends on the border; two edges along it close them.
        assert_eq!(kept.iter().map(Vec::len).collect::<Vec<_>>(), [5]);
        let on_border = |p: &DVec2| p.x == window.max.x || p.y == window.max.y;
        assert_eq!(kept.concat().iter().filter(|p| on_border(p)).count(), 4);
    }

    #[test]
    fn a_name_stands_inside() {
        let horseshoe = [
            (0.0, 0.0),
            (9.0, 0.0),
            (9.0, 9.0),
            (6.0, 9.0),
            (6.0, 3.0),
            (3.0, 3.0),
            (3.0, 9.0),
            (0.0, 9.0),
        ];
        let place = within(&horseshoe.map(DVec2::from)).unwrap();
        let inside = place.y < 3.0 || place.x < 3.0 || place.x > 6.0;
        assert!(inside && 0.0 < place.x && place.x < 9.0, "{place}");
        assert_eq!(within(&[DVec2::ZERO, DVec2::X, DVec2::X * 2.0]), None);
        assert_eq!(within(&[]), None);
    }

    #[test]
    fn bridges_are_found_on_every_side() {
        let window = super::super::board::window(0.0, 0.0, 10.0, 10.0);
        let comb = Inputs::default().get(&POLYGON);
        for turn in [
            |p: DVec2| p,
            |p: DVec2| DVec2::new(10.0 - p.x, p.y),
            |p: DVec2| DVec2::new(p.y, p.x),
            |p: DVec2| DVec2::new(p.y, 10.0 - p.x),
        ] {
            let comb: Vec<DVec2> = comb.iter().map(|&p| turn(p)).collect();
            let one = sutherland_hodgman::clip_polygon(&window, &comb);
            let parts = pieces::clip_polygon(&window, &comb);
            assert_eq!(
                (bridge_edges(&window, &one, &parts).len(), parts.len()),
                (1, 2),
                "{one:?}"
            );
        }
    }
}
