//! Three sticks, each over the next: no order, until one of them is cut.

use ombra_hsr::object_space::visible_parts;
use ombra_hsr::painter::{Cycle, hiding_pairs, order, order_by_cutting};
use ombra_hsr::polygon::Polygon;
use ombra_math::glam::{DVec2, DVec3, DVec4};

use super::primitives::{AREA, PRIMITIVES};
use crate::colour::{Ink, Role};
use crate::drawing::{EMPHASIS, NORMAL, Pen};
use crate::error::FigureError;
use crate::figure::{About, Figure, Takes};
use crate::input::{Ask, Inputs};
use crate::panels::panels;
use crate::path::{Path, Rect};
use crate::section::Section;
use crate::sheet::{Align, Label, Sheet};
use crate::text::LABEL;
use crate::words::words;

pub(super) const FIGURE: Figure = Figure {
    id: "hsr/painter-cycle",
    takes: Takes::These(&[SLOPE.input, HEIGHT.input, CUT_STICK.input]),
    words: WORDS,
    about: |inputs, language| match order(&sticks(inputs), EYE) {
        Ok(_) => About::new(language, SUMMARY_ORDER, CAPTION_ORDER),
        Err(_) => About::new(language, SUMMARY, CAPTION),
    },
    drawn: |sheet, inputs| draw(sheet, &sticks(inputs), wanted(inputs)),
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

    /// Where they have an order.
    SUMMARY_ORDER {
        en: "Three sticks that lie over each other, in the order in which they are painted",
        it: "Tre aste una sopra l’altra, nell’ordine in cui si dipingono",
        cs: "Tři tyče přes sebe, v pořadí, v němž se malují",
        hr: "Tri štapa jedan preko drugoga, redom kojim se slikaju",
    }

    /// Where they have an order.
    CAPTION_ORDER {
        en: "There is no ring: each can be painted after all that it hides, and none need be cut.",
        it: "Non c’è un ciclo: ognuna si può dipingere dopo tutte quelle che oscura, e nessuna va tagliata.",
        cs: "Není tu kruh: každou lze namalovat po všech, které zakrývá, a žádnou není třeba rozříznout.",
        hr: "Nema kruga: svaki se može naslikati nakon svih koje zaklanja i nijedan ne treba rezati.",
    }

    /// Before the numbers of the sticks in order.
    NO_RING {
        en: "no ring; order",
        it: "nessun ciclo; ordine",
        cs: "žádný kruh; pořadí",
        hr: "nema kruga; poredak",
    }

    /// An input.
    SLOPE_OF {
        en: "how steeply each stick rises on its way round",
        it: "quanto sale ogni asta lungo il giro",
        cs: "jak strmě každá tyč stoupá v oběhu",
        hr: "koliko se strmo svaki štap diže u krugu",
    }

    /// An input.
    HEIGHT_OF {
        en: "how far *A* is raised towards the eye",
        it: "di quanto *A* è alzata verso l’osservatore",
        cs: "o kolik je *A* zdvižena k pozorovateli",
        hr: "koliko je *A* podignut prema oku",
    }

    /// An input.
    CUT_OF {
        en: "the stick that is cut",
        it: "l’asta che si taglia",
        cs: "tyč, která se rozřízne",
        hr: "štap koji se reže",
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
/// How steeply the sticks rise, how far the first is raised, and which is cut.
const SLOPE: Ask<f64> = Ask::number("slope", "", SLOPE_OF, 0.4, [-1.0, 1.0]);
const HEIGHT: Ask<f64> = Ask::number("height", "", HEIGHT_OF, 0.0, [-3.0, 3.0]);
const CUT_STICK: Ask<&str> = Ask::choice("cut", "", CUT_OF, "a", &["a", "b", "c"]);
/// Half the length and width of a stick, and how far its middle is from the centre.
const HALF: DVec2 = DVec2::new(2.6, 0.34);
const AWAY: f64 = 1.0;
/// Directions of the sticks, thirds of a turn apart.
const DIRECTIONS: [(f64, f64); 3] = [(1.0, 0.0), (-0.5, SIN_120), (-0.5, -SIN_120)];
const SIN_120: f64 = 0.866_025_403_784_438_6;

/// Three sticks that rise on their way round, the first of them raised.
fn sticks(inputs: &Inputs) -> [Polygon; 3] {
    let slope = inputs.get(&SLOPE);
    let mut sticks = DIRECTIONS.map(|direction| {
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
    });
    let [a, ..] = &mut sticks;
    for p in &mut a.vertices {
        p.z += inputs.get(&HEIGHT);
    }
    sticks
}

/// The stick to cut.
fn wanted(inputs: &Inputs) -> usize {
    match inputs.get(&CUT_STICK) {
        "b" => 1,
        "c" => 2,
        _ => 0,
    }
}

/// How many pieces there are of a stick.
fn count(pieces: &[(usize, Polygon)], stick: usize) -> usize {
    pieces.iter().filter(|(of, _)| *of == stick).count()
}

/// The pieces back to front, with `wanted` cut if any must be. Which one of a ring is cut depends on the order in which
/// they are submitted.
fn pieces(sticks: &[Polygon; 3], wanted: usize) -> Option<Vec<(usize, Polygon)>> {
    let submitted = [
        [0, 1, 2],
        [1, 2, 0],
        [2, 0, 1],
        [0, 2, 1],
        [2, 1, 0],
        [1, 0, 2],
    ];
    let mut cut = submitted.into_iter().map(|order| {
        let given: Vec<Polygon> = order
            .iter()
            .filter_map(|&i| sticks.get(i).cloned())
            .collect();
        let pieces = order_by_cutting(&given, EYE);
        let named = |(i, piece): (usize, Polygon)| Some((*order.get(i)?, piece));
        pieces.into_iter().filter_map(named).collect::<Vec<_>>()
    });
    let is_wanted = |pieces: &Vec<(usize, Polygon)>| {
        (0..sticks.len()).all(|i| (count(pieces, i) > 1) == (i == wanted))
    };
    cut.find(is_wanted)
}

fn draw(sheet: &mut Sheet, sticks: &[Polygon; 3], wanted: usize) -> Result<(), FigureError> {
    let language = sheet.style().language;
    let cycle = order(sticks, EYE).err();
    let pieces = match &cycle {
        None => order_by_cutting(sticks, EYE),
        Some(_) => pieces(sticks, wanted).ok_or_else(|| FigureError::Scene {
            reason: format!(
                "cut = {}: no cut of this stick alone leaves an order of these sticks",
                ["a", "b", "c"].get(wanted).unwrap_or(&"")
            ),
        })?,
    };

    let name = |i: &usize| PRIMITIVES.get(*i).map_or("", |&(name, _)| name);
    let hiding: Vec<[usize; 2]> = match &cycle {
        None => hiding_pairs(sticks, EYE),
        Some(Cycle { primitives: ring }) => {
            let next = ring.iter().cycle().skip(1);
            ring.iter().zip(next).map(|(&a, &b)| [a, b]).collect()
        }
    };
    let verb = HIDES.text(language);
    let hides: Vec<String> = hiding
        .iter()
        .map(|[a, b]| format!("{}\u{a0}{verb}\u{a0}{}", name(a), name(b)))
        .collect();
    let numbers: Vec<String> = (1..=pieces.len()).map(|i| i.to_string()).collect();
    let what = match &cycle {
        None => NO_RING.text(language).to_owned(),
        Some(_) => format!("{} {}", name(&wanted), CUT.text(language)),
    };
    let after = format!("{what}: {}", numbers.join(", "));
    let lines = [&*hides.join(", "), &*after];
    let [before, after] = panels(sheet, &lines, 1.1)?[..] else {
        return Ok(());
    };
    for (i, (panel, is_cut)) in [(before, false), (after, true)].into_iter().enumerate() {
        sheet.panel(i, panel);
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

/// Cutting rounds coordinates, which are below 8, to a few ε of them.
const ROUNDING: f64 = 64.0 * f64::EPSILON * 8.0;

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

    fn moved(typed: &[(&crate::input::Input, &str)]) -> [Polygon; 3] {
        let with = |inputs: Inputs, (input, text): &(&crate::input::Input, &str)| {
            inputs.with(input, text).unwrap()
        };
        sticks(&typed.iter().fold(Inputs::default(), with))
    }

    fn usual() -> [Polygon; 3] {
        moved(&[])
    }

    /// Any of the three opens the ring; the pieces of all hide nothing that is painted later.
    #[test]
    fn each_stick_can_be_the_one_that_is_cut() {
        for slope in ["0.4", "-0.4", "1"] {
            let sticks = moved(&[(&SLOPE.input, slope)]);
            for wanted in 0..3 {
                let pieces = pieces(&sticks, wanted).unwrap();
                assert_eq!(pieces.len(), 4, "{slope} {wanted}");
                assert_eq!(count(&pieces, wanted), 2, "{slope} {wanted}");
                let polygons: Vec<Polygon> = pieces.into_iter().map(|(_, piece)| piece).collect();
                let hiding = hiding_pairs(&polygons, EYE);
                assert!(
                    hiding.iter().all(|[over, under]| under < over),
                    "{slope} {wanted}"
                );
            }
        }
    }

    #[test]
    fn the_words_name_the_ring_and_the_stick_that_is_cut() {
        let usual = drawn(|sheet| draw(sheet, &usual(), 0));
        assert!(says(&usual, "A hides B, B hides C, C hides A"));
        assert!(says(&usual, "A is cut in two; order: 1, 2, 3, 4"));
        // The sticks tilted the other way: the ring turns round.
        let turned_sticks = moved(&[(&SLOPE.input, "-0.4")]);
        let turned = drawn(|sheet| draw(sheet, &turned_sticks, 0));
        assert!(says(&turned, "A hides C, C hides B, B hides A"));
        assert_ne!(shapes(&usual), shapes(&turned));
        // Of level sticks the one submitted first hides the other; raised, A hides both others: there is an order.
        let level = moved(&[(&SLOPE.input, "0")]);
        assert!(says(
            &drawn(|sheet| draw(sheet, &level, 0)),
            "A hides B, A hides C, B hides C"
        ));
        let raised = moved(&[(&HEIGHT.input, "3")]);
        let drawing = drawn(|sheet| draw(sheet, &raised, 0));
        assert!(says(&drawing, "no ring; order: 1, 2, 3"));
        let label = |text: &str| drawing.labels.iter().any(|label| label.text.contains(text));
        assert!(label("A\u{a0}hides\u{a0}C") && !label("C\u{a0}hides\u{a0}A"));
    }

    /// Painted one over the other, the pieces show at every place the stick that a ray finds nearest.
    #[test]
    fn the_painted_pieces_are_what_is_seen() {
        let sticks = usual();
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
        let drawing = drawn(|sheet| draw(sheet, &usual(), 0));
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
        let sticks = usual();
        let drawing = drawn(|sheet| draw(sheet, &sticks, 0));
        let ink = |i: usize| Ink::of(PRIMITIVES[i].1).tint(AREA);
        let painted: Vec<Ink> = fills(&drawing).into_iter().map(|(ink, _)| ink).collect();
        let pieces = order_by_cutting(&sticks, EYE);
        let inks: Vec<Ink> = pieces.iter().map(|(source, _)| ink(*source)).collect();
        assert_eq!(painted, [inks.clone(), inks].concat());
        // A under C, C under B, B under A.
        assert_eq!(painted[..4], [0, 2, 1, 0].map(ink));
    }
}
