//! The painter's algorithm: each primitive over those behind it.

use core::cmp::Ordering;

use ombra_hsr::painter::order;
use ombra_hsr::polygon::Polygon;
use ombra_math::glam::{DVec2, DVec3};

use super::primitives::PRIMITIVES;
use super::stage::{EYE, Stage, section};
use crate::colour::Role;
use crate::drawing::{EMPHASIS, NORMAL, Pen, THIN};
use crate::error::FigureError;
use crate::figure::{About, Figure, Takes};
use crate::input::{Ask, Kind};
use crate::number::decimal;
use crate::panels::panels;
use crate::sheet::{Align, Label, Sheet};
use crate::text::LABEL;
use crate::words::words;

pub(super) const FIGURE: Figure = Figure {
    id: "hsr/painter-steps",
    takes: Takes::These(&[
        DISTANCES[0].input,
        DISTANCES[1].input,
        DISTANCES[2].input,
        DISTANCES[3].input,
    ]),
    words: WORDS,
    about: |_, language| About::new(language, SUMMARY, CAPTION),
    drawn: |sheet, inputs| draw(sheet, &scene(&DISTANCES.map(|ask| inputs.get(&ask)))),
};

words! {
    SUMMARY {
        en: "The painter’s algorithm: four primitives from back to front",
        it: "L’algoritmo del pittore: quattro primitive dalla più lontana alla più vicina",
        cs: "Malířův algoritmus: čtyři plochy odzadu dopředu",
        hr: "Slikarev algoritam: četiri poligona odostraga prema naprijed",
    }

    CAPTION {
        en: "From back to front; each covers what it hides of those painted before.",
        it: "Dal fondo in avanti; ognuna copre ciò che oscura di quelle già dipinte.",
        cs: "Odzadu dopředu; každá překryje, co zakrývá z dříve namalovaných.",
        hr: "Odostraga prema naprijed; svaki prekriva ono što zaklanja od već naslikanih.",
    }

    /// Before the name of the first that is painted.
    FIRST {
        en: "first",
        it: "prima",
        cs: "nejprve",
        hr: "najprije",
    }

    /// Before the name of one in between.
    THEN {
        en: "then",
        it: "poi",
        cs: "pak",
        hr: "zatim",
    }

    /// Before the name of the last.
    LAST {
        en: "last",
        it: "infine",
        cs: "nakonec",
        hr: "na kraju",
    }

    /// An input.
    DISTANCE {
        en: "distance of this primitive, which keeps its outline in the picture",
        it: "distanza di questa primitiva, che nell’immagine mantiene il suo contorno",
        cs: "vzdálenost této plochy, která si v obrazu ponechá svůj obrys",
        hr: "udaljenost ovog poligona, koji na slici zadržava svoj obris",
    }
}

/// Distances of *A* to *D*: the picture shows the same outlines, and what hides what changes.
const DISTANCES: [Ask<f64>; 4] = [
    distance("za", "*z*_{*A*}", 7.0),
    distance("zb", "*z*_{*B*}", 4.0),
    distance("zc", "*z*_{*C*}", 9.0),
    distance("zd", "*z*_{*D*}", 6.0),
];

const fn distance(name: &'static str, symbol: &'static str, default: f64) -> Ask<f64> {
    Ask::number(name, symbol, DISTANCE, default, [2.0, 9.0])
}

/// *A* to *D*, as they are submitted, at their own distances.
const SCENE: [&[(f64, f64, f64)]; 4] = [
    &[(-3.4, -1.2, -7.4), (0.9, -1.4, -6.6), (-1.5, 1.9, -7.0)],
    &[
        (-1.2, -1.0, -3.7),
        (0.7, -1.1, -4.3),
        (0.7, 0.4, -4.3),
        (-1.2, 0.35, -3.7),
    ],
    &[
        (-4.2, -2.3, -8.8),
        (3.4, -2.4, -9.2),
        (3.4, 2.3, -9.2),
        (-4.2, 2.5, -8.8),
    ],
    &[
        (-0.5, -1.3, -5.6),
        (2.7, -1.6, -6.4),
        (2.7, 0.5, -6.4),
        (1.1, 1.5, -6.0),
        (-0.5, 0.6, -5.6),
    ],
];

/// Each moved along its sight lines to its distance.
fn scene(distances: &[f64; 4]) -> [Polygon; 4] {
    let mut scene = SCENE.map(|corners| Polygon {
        vertices: corners.iter().map(|&corner| DVec3::from(corner)).collect(),
    });
    for ((polygon, ask), distance) in scene.iter_mut().zip(DISTANCES).zip(distances) {
        let Kind::Number { default, .. } = ask.input.kind else {
            continue;
        };
        // At their own distances they keep every digit.
        let share = distance / default;
        for p in &mut polygon.vertices {
            *p *= share;
        }
    }
    scene
}

fn draw(sheet: &mut Sheet, scene: &[Polygon; 4]) -> Result<(), FigureError> {
    let order = order(scene, EYE).map_err(|cycle| {
        let said = |&i: &usize| {
            let ask = DISTANCES.get(i)?;
            let middle = scene.get(i)?.centroid()?;
            Some(format!("{} about {}", ask.input.name, decimal(-middle.z)))
        };
        let ring: Vec<String> = cycle.primitives.iter().filter_map(said).collect();
        FigureError::Scene {
            reason: format!(
                "the painter has no order for these distances: with {} each hides some of the next, and the last some of the first",
                ring.join(", ")
            ),
        }
    })?;
    let painted: Vec<(&Polygon, &str, Role)> = order
        .iter()
        .filter_map(|&i| {
            let &(name, role) = PRIMITIVES.get(i)?;
            Some((scene.get(i)?, name, role))
        })
        .collect();
    let language = sheet.style().language;
    let last = painted.len().saturating_sub(1);
    let lines: Vec<String> = painted
        .iter()
        .enumerate()
        .map(|(i, (_, name, _))| match i {
            0 => format!("{} {name}", FIRST.text(language)),
            _ if i == last => format!("{} {name}", LAST.text(language)),
            _ => format!("{} {name}", THEN.text(language)),
        })
        .collect();
    let lines: Vec<&str> = lines.iter().map(String::as_str).collect();
    for (i, panel) in panels(sheet, &lines, Stage::TALLEST)?
        .into_iter()
        .enumerate()
    {
        let stage = Stage::fit(panel);
        sheet.panel(i, panel);
        stage.draw_frame(sheet);
        for (j, &(polygon, name, role)) in painted.iter().enumerate() {
            let (pen, ink) = match j.cmp(&i) {
                Ordering::Less => (Pen::new(role, NORMAL), role),
                Ordering::Equal => (Pen::new(Role::Chosen, EMPHASIS), Role::Chosen),
                Ordering::Greater => (Pen::new(Role::Rejected, THIN).dashed(), Role::Note),
            };
            stage.draw_section(sheet, polygon, pen);
            if let Some([_, right]) = section(polygon) {
                let label = Label::new(stage.above(right), name)
                    .towards(DVec2::X)
                    .ink(ink);
                sheet.label(label.beside());
            }
            if j <= i {
                stage.paint(sheet, polygon, role);
            }
        }
        if let Some((polygon, name, _)) = painted.get(i) {
            sheet.stroke(stage.outline(polygon), Pen::new(Role::Chosen, EMPHASIS));
            if let Some(centre) = polygon.centroid() {
                sheet.text(stage.seen(centre), Align::Centre, name, LABEL, Role::Text)?;
            }
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::super::drawn::{areas, drawn, shapes};
    use super::super::primitives::AREA;
    use super::*;
    use crate::colour::Ink;
    use crate::drawing::Drawing;
    use ombra_hsr::pair::{Pair, compare};

    const OWN: [f64; 4] = [7.0, 4.0, 9.0, 6.0];

    #[test]
    fn a_moved_primitive_keeps_its_outline_and_crossing_ones_are_named() {
        let stage = Stage::fit(crate::path::Rect::new(
            DVec2::splat(100.0),
            DVec2::splat(900.0),
        ));
        for (own, moved) in scene(&OWN).iter().zip(&scene(&[2.0, 9.0, 3.0, 8.5])) {
            for (p, q) in own.vertices.iter().zip(&moved.vertices) {
                assert!(stage.seen(*p).distance(stage.seen(*q)) < 1e-9);
            }
        }
        // D reaches from 5.6 to 6.4, A from 6.6 to 7.4: at one distance they cross.
        let mut sheet = Sheet::new(&crate::style::Style::default(), "").unwrap();
        let error = draw(&mut sheet, &scene(&[6.0, 4.0, 9.0, 6.0]))
            .unwrap_err()
            .to_string();
        assert!(
            error.contains("za about 6") && error.contains("zd about"),
            "{error}"
        );
    }

    /// How often each is painted: in its own panel and in all that follow.
    fn times(drawing: &Drawing) -> [usize; 4] {
        PRIMITIVES.map(|(_, role)| areas(drawing, Ink::of(role).tint(AREA)))
    }

    fn lines(drawing: &Drawing) -> Vec<&str> {
        let text = drawing.labels.iter().map(|label| label.text.as_str());
        text.filter(|text| text.len() > 1).collect()
    }

    #[test]
    fn the_farthest_is_painted_first() {
        let scene = scene(&OWN);
        let usual = drawn(|sheet| draw(sheet, &scene));
        assert_eq!(lines(&usual), ["first C", "then A", "then D", "last B"]);
        assert_eq!(times(&usual), [3, 1, 4, 2]);
        // Each hides some of the one before it, so that the order is the only one.
        for (far, near) in [(2, 0), (0, 3), (3, 1)] {
            assert_eq!(compare(&scene[far], &scene[near], EYE), Pair::SecondNearer);
        }
    }

    #[test]
    fn one_moved_away_is_painted_earlier() {
        let usual = drawn(|sheet| draw(sheet, &scene(&OWN)));
        // D farther and larger, the same in the picture: now behind A.
        let moved = scene(&[7.0, 4.0, 9.0, 8.4]);
        let drawing = drawn(|sheet| draw(sheet, &moved));
        assert_eq!(lines(&drawing), ["first C", "then D", "then A", "last B"]);
        assert_eq!(times(&drawing), [2, 1, 4, 3]);
        assert_ne!(shapes(&usual), shapes(&drawing));
    }
}
