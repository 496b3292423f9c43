//! Three sticks, each over the next: no order, until one of them is cut.

use ombra_hsr::object_space::visible_parts;
use ombra_hsr::painter::{order, order_by_cutting};
use ombra_hsr::polygon::Polygon;
use ombra_math::glam::{DVec2, DVec3, DVec4};

use super::primitives::{AREA, PRIMITIVES};
use crate::colour::{Ink, Role};
use crate::drawing::{EMPHASIS, NORMAL, Pen};
use crate::error::FigureError;
use crate::figure::{About, Figure, Takes};
use crate::panels::panels;
use crate::path::{Path, Rect};
use crate::section::Section;
use crate::sheet::{Align, Label, Sheet};
use crate::text::LABEL;
use crate::words::words;

pub(super) const FIGURE: Figure = Figure {
    id: "hsr/painter-cycle",
    takes: Takes::Nothing(crate::words::FIXED),
    words: WORDS,
    about: |_, language| About::new(language, SUMMARY, CAPTION),
    drawn: |sheet, _| draw(sheet, &sticks(SLOPE)),
};

words! {
    SUMMARY {
        en: "Three sticks, each over the next: no order, and an order after cutting one of them",
        it: "Tre aste, ognuna sopra la seguente: nessun ordine, e un ordine dopo averne tagliata una",
        cs: "Tři tyče, každá přes další: žádné pořadí, a pořadí po rozříznutí jedné z nich",
        hr: "Tri štapa, svaki preko sljedećeg: nema poretka, a ima ga kad se jedan prereže",
    }

    CAPTION {
        en: "Whichever is painted first hides nothing, yet each must hide one. One is cut by the plane of another, and its two pieces find their places.",
        it: "La prima dipinta non copre nulla, eppure ognuna deve coprirne una. Una si taglia con il piano di un’altra, e i suoi due pezzi trovano posto.",
        cs: "Tyč namalovaná jako první nezakryje nic, a přece má každá jednu zakrýt. Jedna se rozřízne rovinou jiné a její dva díly najdou své místo.",
        hr: "Štap naslikan prvi ne zaklanja ništa, a svaki mora zakloniti jedan. Jedan se reže ravninom drugoga i njegova dva dijela nađu svoje mjesto.",
    }

    /// One stick hides part of another.
    HIDES {
        en: "hides",
        it: "oscura",
        cs: "zakrývá",
        hr: "zaklanja",
    }

    /// What happens to a stick, before the numbers of the pieces in order.
    CUT {
        en: "is cut in two; order",
        it: "tagliata in due; ordine",
        cs: "rozříznuta na dvě; pořadí",
        hr: "prerezan nadvoje; poredak",
    }
}

/// A parallel view from above.
const EYE: DVec4 = DVec4::Z;
/// Half the length and width of a stick, how far its middle is from the centre, and how steeply it rises.
const HALF: DVec2 = DVec2::new(2.6, 0.34);
const AWAY: f64 = 1.0;
const SLOPE: f64 = 0.4;
/// Directions of the sticks, thirds of a turn apart.
const DIRECTIONS: [(f64, f64); 3] = [(1.0, 0.0), (-0.5, SIN_120), (-0.5, -SIN_120)];
const SIN_120: f64 = 0.866_025_403_784_438_6;

/// Three sticks that rise by `slope` on their way round.
fn sticks(slope: f64) -> [Polygon; 3] {
    DIRECTIONS.map(|direction| {
        let along = DVec2::from(direction);
        let across = along.perp();
        let corner = |x: f64, y: f64| {
            let flat = along * (HALF.x * x) + across * (HALF.y * y - AWAY);
            flat.extend(slope * HALF.x * x)
        };
        let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
        Polygon {
            vertices: corners.map(|(x, y)| corner(x, y)).to_vec(),
        }
    })
}

fn draw(sheet: &mut Sheet, sticks: &[Polygon; 3]) -> Result<(), FigureError> {
    let language = sheet.style().language;
    let Err(cycle) = order(sticks, EYE) else {
        return Err(FigureError::Scene {
            reason: "the sticks have an order".to_owned(),
        });
    };
    let pieces = order_by_cutting(sticks, EYE);

    let name = |i: &usize| PRIMITIVES.get(*i).map_or("", |&(name, _)| name);
    let ring = &cycle.primitives;
    let verb = HIDES.text(language);
    let hides: Vec<String> = ring
        .iter()
        .zip(ring.iter().cycle().skip(1))
        .map(|(a, b)| format!("{}\u{a0}{verb}\u{a0}{}", name(a), name(b)))
        .collect();
    let cut = (0..sticks.len()).filter(|i| pieces.iter().filter(|(of, _)| of == i).count() > 1);
    let cut: Vec<&str> = cut.map(|i| name(&i)).collect();
    let numbers: Vec<String> = (1..=pieces.len()).map(|i| i.to_string()).collect();
    let after = format!(
        "{} {}: {}",
        cut.join(", "),
        CUT.text(language),
        numbers.join(", ")
    );
    let lines = [&*hides.join(", "), &*after];
    let [before, after] = panels(sheet, &lines, 1.1)?[..] else {
        return Ok(());
    };
    for (panel, is_cut) in [(before, false), (after, true)] {
        let room = Rect::new(panel.min + 30.0, panel.max - 30.0);
        let corners: Vec<DVec2> = sticks
            .iter()
            .flat_map(|stick| stick.vertices.iter().map(|p| p.truncate()))
            .collect();
        let section = Section::fit(&corners, room)?;
        paint(sheet, &section, sticks, &pieces, is_cut);
        if is_cut {
            number(sheet, &section, &pieces)?;
        } else {
            for (stick, (name, role)) in sticks.iter().zip(PRIMITIVES) {
                if let [_, b, c, _] = stick.vertices[..] {
                    let end = section.at(((b + c) * 0.5).truncate());
                    let centre = section.at(stick.centroid().unwrap_or_default().truncate());
                    let label = Label::new(end, name).towards(end - centre).ink(role);
                    sheet.label(label.beside());
                }
            }
        }
    }
    Ok(())
}

/// The pieces in their order, each over those before it: what the eye sees of the sticks, too.
fn paint(
    sheet: &mut Sheet,
    section: &Section,
    sticks: &[Polygon],
    pieces: &[(usize, Polygon)],
    is_cut: bool,
) {
    for (source, piece) in pieces {
        let (Some(&(_, role)), Some(stick)) = (PRIMITIVES.get(*source), sticks.get(*source)) else {
            continue;
        };
        let at = |p: &DVec3| section.at(p.truncate());
        let outline: Vec<DVec2> = piece.vertices.iter().map(at).collect();
        let ink = Ink::of(role).tint(AREA);
        sheet.fill_unmarked(Path::polygon(&outline), ink, Pen::new(ink, 1.0));
        let ends = piece.vertices.iter().cycle().skip(1);
        for (a, b) in piece.vertices.iter().zip(ends) {
            let whole = is_side(stick, *a, *b);
            if whole {
                sheet.line(at(a), at(b), Pen::new(role, NORMAL));
            } else if is_cut {
                sheet.line(at(a), at(b), Pen::new(Role::Chosen, EMPHASIS));
            }
        }
    }
}

/// Cutting rounds coordinates, which are below 4, to a few ε of them.
const ROUNDING: f64 = 64.0 * f64::EPSILON * 4.0;

/// Whether a−b lies on a side of the polygon: cuts do not.
fn is_side(polygon: &Polygon, a: DVec3, b: DVec3) -> bool {
    let vertices = &polygon.vertices;
    let mut sides = vertices.iter().zip(vertices.iter().cycle().skip(1));
    sides.any(|(&p, &q)| {
        let along = (q - p).normalize_or_zero();
        let on_line = |v: DVec3| (v - p).cross(along).length() <= ROUNDING;
        on_line(a) && on_line(b)
    })
}

/// When each piece is painted, in the middle of the largest part of it that stays visible.
fn number(
    sheet: &mut Sheet,
    section: &Section,
    pieces: &[(usize, Polygon)],
) -> Result<(), FigureError> {
    let polygons: Vec<Polygon> = pieces.iter().map(|(_, piece)| piece.clone()).collect();
    let parts = visible_parts(&polygons, EYE);
    for i in 0..pieces.len() {
        let of_piece = parts.iter().filter(|(piece, _)| *piece == i);
        let largest = of_piece.max_by(|(_, a), (_, b)| a.area().total_cmp(&b.area()));
        if let Some(middle) = largest.and_then(|(_, part)| part.centroid()) {
            let at = section.at(middle.truncate());
            let words = (i + 1).to_string();
            sheet.text(at, Align::Centre, &words, LABEL, Role::Text)?;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::super::drawn::{drawn, fills, shapes};
    use super::*;
    use crate::drawing::{Drawing, Item};
    use ombra_hsr::image_space::hits;
    use ombra_math::camera::SightLine;

    fn says(drawing: &Drawing, line: &str) -> bool {
        let texts = drawing.labels.iter();
        texts
            .map(|label| label.text.replace('\u{a0}', " "))
            .any(|text| text == line)
    }

    #[test]
    fn the_words_name_the_ring_and_the_stick_that_is_cut() {
        let usual = drawn(|sheet| draw(sheet, &sticks(SLOPE)));
        assert!(says(&usual, "A hides B, B hides C, C hides A"));
        assert!(says(&usual, "A is cut in two; order: 1, 2, 3, 4"));
        // The sticks tilted the other way: the ring turns round.
        let turned = drawn(|sheet| draw(sheet, &sticks(-SLOPE)));
        assert!(says(&turned, "A hides C, C hides B, B hides A"));
        assert_ne!(shapes(&usual), shapes(&turned));
        // Level sticks touch; one after the other is an order, and no figure.
        let mut sheet = Sheet::new(&crate::style::Style::default(), "").unwrap();
        assert!(draw(&mut sheet, &sticks(0.0)).is_err());
    }

    /// Painted one over the other, the pieces show at every place the stick that a ray finds nearest.
    #[test]
    fn the_painted_pieces_are_what_is_seen() {
        let sticks = sticks(SLOPE);
        let pieces = order_by_cutting(&sticks, EYE);
        assert_eq!(pieces.len(), 4);
        let mut seen = [0; 3];
        for i in -40..=40 {
            for j in -40..=40 {
                // Off the lines of symmetry.
                let p = DVec2::new(f64::from(i) * 0.0731 + 0.011, f64::from(j) * 0.0717 + 0.007);
                let down = SightLine {
                    origin: p.extend(9.0),
                    direction: DVec3::NEG_Z,
                };
                let nearest = hits(&sticks, down).first().map(|hit| hit.primitive);
                let covers = |(_, piece): &&(usize, Polygon)| {
                    !hits(core::slice::from_ref(piece), down).is_empty()
                };
                let painted = pieces.iter().rfind(covers).map(|(source, _)| *source);
                assert_eq!(painted, nearest, "{p}");
                if let Some(source) = painted {
                    seen[source] += 1;
                }
            }
        }
        assert!(seen.iter().all(|&count| count > 100), "{seen:?}");
    }

    /// Three sticks have twelve sides; the cut adds two halves of two sides, and one line seen from both pieces.
    #[test]
    fn only_the_second_panel_shows_the_cut() {
        let drawing = drawn(|sheet| draw(sheet, &sticks(SLOPE)));
        let cuts = drawing.items.iter().filter(|item| match item {
            Item::Shape {
                stroke: Some(pen), ..
            } => pen.width == EMPHASIS,
            _ => false,
        });
        let middle = drawing.canvas.x * 0.5;
        let mut count = 0;
        for item in cuts {
            let Item::Shape { path, .. } = item else {
                continue;
            };
            assert!(path.points().all(|p| p.x > middle));
            count += 1;
        }
        assert_eq!(count, 2);
    }

    #[test]
    fn both_panels_are_painted_in_the_order_of_the_pieces() {
        let sticks = sticks(SLOPE);
        let drawing = drawn(|sheet| draw(sheet, &sticks));
        let ink = |i: usize| Ink::of(PRIMITIVES[i].1).tint(AREA);
        let painted: Vec<Ink> = fills(&drawing).into_iter().map(|(ink, _)| ink).collect();
        let pieces = order_by_cutting(&sticks, EYE);
        let inks: Vec<Ink> = pieces.iter().map(|(source, _)| ink(*source)).collect();
        assert_eq!(painted, [inks.clone(), inks].concat());
        // A under C, C under B, B under A.
        assert_eq!(painted[..4], [0, 2, 1, 0].map(ink));
    }
}
