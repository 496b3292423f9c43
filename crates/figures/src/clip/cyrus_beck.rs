//! Cyrus–Beck: a segment against the edges of a convex polygon, by the signs of their normals.

use ombra_clip::{Segment, cyrus_beck};
use ombra_math::glam::DVec2;

use super::bars::{Row, divided, draw as draw_bars, in_common, not_negative};
use super::board::{FIRST_END, LAST_END, POLYGON_WORD, RANGE};
use super::liang_barsky::{ALL, NONE, draw_crossings};
use crate::colour::Role;
use crate::drawing::{NORMAL, Pen, THIN};
use crate::error::FigureError;
use crate::figure::{About, Figure, Takes};
use crate::input::{Ask, Inputs};
use crate::marks;
use crate::number::{as_typed, inline};
use crate::path::{Path, Rect};
use crate::section::Section;
use crate::sheet::{Label, Sheet};
use crate::words::words;

pub(super) const FIGURE: Figure = Figure {
    id: "clip/cyrus-beck",
    takes: Takes::These(&[A.input, B.input, CONVEX.input]),
    words: WORDS,
    about: |inputs, language| {
        let segment = Segment::new(inputs.get(&A), inputs.get(&B));
        let convex = inputs.get(&CONVEX);
        let [from, to] = in_common(&rows(&convex, segment)).map(inline);
        let left = match cyrus_beck::clip_segment(&convex, segment) {
            Some(_) => LEFT.text(language).replace("%1", &from).replace("%2", &to),
            None => NOTHING.text(language).to_owned(),
        };
        About::new(language, SUMMARY, CAPTION).and(Some(left))
    },
    drawn: draw,
};

words! {
    SUMMARY {
        en: "Cyrus–Beck: a segment enters and leaves a convex polygon by the signs of *N*·*D*",
        it: "Cyrus–Beck: un segmento entra in un poligono convesso ed esce secondo il segno di *N*·*D*",
        cs: "Cyrus–Beck: úsečka vstupuje do konvexního polygonu a vystupuje podle znaménka *N*·*D*",
        hr: "Cyrus–Beck: dužina ulazi u konveksan poligon i izlazi prema predznaku *N*·*D*",
    }

    CAPTION {
        en: "Inside *N*·(*P* − *Q*) ≥ 0 for each edge with the inner normal *N* and a corner *Q*. With *D* = *B* − *A*: *N*·*D* > 0 enters, *N*·*D* < 0 leaves.",
        it: "All’interno *N*·(*P* − *Q*) ≥ 0 per ogni lato con la normale interna *N* e un vertice *Q*. Con *D* = *B* − *A*: *N*·*D* > 0 entra, *N*·*D* < 0 esce.",
        cs: "Uvnitř je *N*·(*P* − *Q*) ≥ 0 pro každou hranu s vnitřní normálou *N* a vrcholem *Q*. S *D* = *B* − *A*: *N*·*D* > 0 vstupuje, *N*·*D* < 0 vystupuje.",
        hr: "Unutra je *N*·(*P* − *Q*) ≥ 0 za svaki brid s unutarnjom normalom *N* i vrhom *Q*. Uz *D* = *B* − *A*: *N*·*D* > 0 ulazi, *N*·*D* < 0 izlazi.",
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
        en: "Here nothing is left.",
        it: "Qui non resta nulla.",
        cs: "Zde nic nezůstane.",
        hr: "Ovdje ništa ne ostaje.",
    }
}

const A: Ask<DVec2> = Ask::point("a", "*A*", FIRST_END, [-4.0, 2.0], RANGE);
const B: Ask<DVec2> = Ask::point("b", "*B*", LAST_END, [12.0, 6.0], RANGE);
const CONVEX: Ask<Vec<DVec2>> = Ask::polygon(
    "convex",
    "",
    POLYGON_WORD,
    &[[2.0, 0.0], [8.0, 0.0], [10.0, 4.0], [5.0, 9.0], [0.0, 4.0]],
    [3, 7],
    RANGE,
);
/// Share of the segment's picture.
const SHARE: f64 = 0.47;
/// Length of a normal on the canvas.
const ARROW: f64 = 80.0;

/// Twice the signed area.
fn turn(convex: &[DVec2]) -> f64 {
    edges(convex).map(|[p, q]| p.perp_dot(q)).sum()
}

fn edges(convex: &[DVec2]) -> impl Iterator<Item = [DVec2; 2]> {
    let next = convex.iter().cycle().skip(1);
    convex.iter().zip(next).map(|(&p, &q)| [p, q])
}

/// The inner normal of an edge of a polygon that turns to this side.
fn normal([p, q]: [DVec2; 2], turn: f64) -> DVec2 {
    (q - p).perp() * if turn < 0.0 { -1.0 } else { 1.0 }
}

/// Each edge's inequality, and that of the segment.
fn rows(convex: &[DVec2], segment: Segment) -> Vec<Row> {
    let turn = turn(convex);
    let direction = segment.b - segment.a;
    let of_edge = |(i, edge): (usize, [DVec2; 2])| {
        let n = normal(edge, turn);
        let slope = n.dot(direction);
        let sign = match slope {
            _ if slope > 0.0 => ">",
            _ if slope < 0.0 => "<",
            _ => "=",
        };
        Row {
            name: format!("*N*_{{{}}}·*D* {sign} 0", i + 1),
            holds: not_negative(n.dot(segment.a - edge[0]), slope),
        }
    };
    let mut rows: Vec<Row> = edges(convex).enumerate().map(of_edge).collect();
    rows.push(Row {
        name: "0 ≤ *t* ≤ 1".to_owned(),
        holds: [0.0, 1.0],
    });
    rows
}

/// Whether each corner lies on the inner side of each edge, and the edges go round once.
fn is_convex(convex: &[DVec2]) -> bool {
    let turn = turn(convex);
    let inside = |edge: [DVec2; 2]| {
        let n = normal(edge, turn);
        n != DVec2::ZERO && convex.iter().all(|&p| n.dot(p - edge[0]) >= 0.0)
    };
    turn != 0.0 && edges(convex).all(inside)
}

fn draw(sheet: &mut Sheet, inputs: &Inputs) -> Result<(), FigureError> {
    let language = sheet.style().language;
    let segment = Segment::new(inputs.get(&A), inputs.get(&B));
    let convex = inputs.get(&CONVEX);
    if !is_convex(&convex) {
        let corners: Vec<String> = convex.iter().map(|p| as_typed(&p.to_array())).collect();
        return Err(FigureError::Scene {
            reason: format!("the polygon {} is not convex", corners.join(" ")),
        });
    }
    let rows = rows(&convex, segment);
    let kept = cyrus_beck::clip_segment(&convex, segment);
    let [picture, bars] = divided(sheet.frame(), SHARE);
    let mut shown = convex.clone();
    shown.extend([segment.a, segment.b]);
    let inner = Rect::new(picture.min + 30.0, picture.max - 30.0);
    let section = Section::fit(&shown, inner)?;

    let outline: Vec<DVec2> = convex.iter().map(|&p| section.at(p)).collect();
    sheet.fill(Path::polygon(&outline), Role::Ground);
    sheet.stroke(Path::polygon(&outline), Pen::new(Role::Receiver, NORMAL));
    let turn = turn(&convex);
    for (i, edge) in edges(&convex).enumerate() {
        sheet.step(i + 1);
        let [p, q] = edge.map(|p| section.at(p));
        // The line of the edge, as far as there is room.
        let along = (q - p).normalize_or_zero() * 3000.0;
        if let Some((from, to)) = picture.cut(p - along, q + along) {
            sheet.line(from, to, Pen::new(Role::Receiver, THIN).dashed());
        }
        let n = normal(edge, turn).normalize_or_zero();
        let n = DVec2::new(n.x, -n.y);
        let middle = (p + q) * 0.5;
        let length = ARROW.min(0.4 * p.distance(q).max(ARROW));
        marks::normal(sheet, middle, middle + n * length);
        let label = Label::new(middle + n * length, format!("*N*_{{{}}}", i + 1));
        sheet.label(label.towards(n).ink(Role::Normal).within(picture).beside());
    }
    let sides = rows.iter().take(convex.len()).map(|row| row.holds);
    draw_crossings(sheet, picture, |p| section.at(p), segment, kept, sides);
    let all = if kept.is_some() { ALL } else { NONE };
    draw_bars(sheet, bars, &rows, all.text(language), kept.is_some())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::style::Style;

    #[test]
    fn entries_and_exits_are_the_librarys_whichever_way_the_polygon_turns() {
        let inputs = Inputs::default();
        let segment = Segment::new(inputs.get(&A), inputs.get(&B));
        let mut convex = inputs.get(&CONVEX);
        for _ in 0..2 {
            let [from, to] = in_common(&rows(&convex, segment));
            let kept = cyrus_beck::clip_segment(&convex, segment).unwrap();
            let at = |t: f64| segment.a + (segment.b - segment.a) * t;
            assert!(at(from).distance(kept.a) < 1e-14 && at(to).distance(kept.b) < 1e-14);
            // Before it, only what leaves holds; in it, all does.
            let middle = 0.5 * (from + to);
            let holds = |t: f64| {
                rows(&convex, segment)
                    .iter()
                    .all(|row| row.holds[0] <= t && t <= row.holds[1])
            };
            assert!(holds(middle) && !holds(from - 0.01) && !holds(to + 0.01));
            convex.reverse();
        }
    }

    #[test]
    fn what_is_not_convex_is_said() {
        for polygon in [
            "0,0 4,0 1,1 0,4",
            "0,0 1,1 2,2",
            "0,0 4,4 4,0 0,4",
            "1,1 1,1 1,1",
        ] {
            let inputs = Inputs::default().with(&CONVEX.input, polygon).unwrap();
            let error = FIGURE.draw(&Style::default(), &inputs).unwrap_err();
            assert_eq!(
                error.to_string(),
                format!("the polygon {polygon} is not convex")
            );
        }
    }
}
