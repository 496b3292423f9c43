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
use crate::panels::panels;
use crate::sheet::{Align, Label, Sheet};
use crate::text::LABEL;
use crate::words::words;

pub(super) const FIGURE: Figure = Figure {
    id: "hsr/painter-steps",
    takes: Takes::Nothing(crate::words::FIXED),
    words: WORDS,
    about: |_, language| About::new(language, SUMMARY, CAPTION),
    drawn: |sheet, _| draw(sheet, &scene()),
};

words! {
    SUMMARY {
        en: "The painter’s algorithm: four primitives from back to front",
        it: "L’algoritmo del pittore: quattro primitive dalla più lontana alla più vicina",
        cs: "Malířův algoritmus: čtyři plochy odzadu dopředu",
        hr: "Slikarev algoritam: četiri poligona odostraga prema naprijed",
    }

    CAPTION {
        en: "The farthest first; each covers what it hides of those painted before.",
        it: "Prima la più lontana; ognuna copre ciò che oscura di quelle già dipinte.",
        cs: "Nejdřív nejvzdálenější; každá překryje, co zakrývá z dříve namalovaných.",
        hr: "Najprije najdalji; svaki prekriva ono što zaklanja od već naslikanih.",
    }

    /// After the name of the first that is painted.
    FARTHEST {
        en: ", the farthest",
        it: ", la più lontana",
        cs: ", nejvzdálenější",
        hr: ", najdalji",
    }

    /// Before the name of one in between.
    THEN {
        en: "then",
        it: "poi",
        cs: "pak",
        hr: "zatim",
    }

    /// After the name of the last.
    NEAREST {
        en: ", the nearest",
        it: ", la più vicina",
        cs: ", nejbližší",
        hr: ", najbliži",
    }
}

/// *A* to *D*, as they are submitted.
const SCENE: [&[(f64, f64, f64)]; 4] = [
    &[(-3.4, -1.2, -7.4), (0.9, -1.4, -6.6), (-1.5, 1.9, -7.0)],
    &[
        (-1.2, -1.0, -3.6),
        (0.7, -1.1, -4.2),
        (0.7, 0.4, -4.2),
        (-1.2, 0.35, -3.6),
    ],
    &[
        (-4.2, -2.3, -9.0),
        (3.4, -2.4, -9.4),
        (3.4, 2.3, -9.4),
        (-4.2, 2.5, -9.0),
    ],
    &[
        (-0.5, -1.3, -5.4),
        (2.7, -1.6, -6.2),
        (2.7, 0.5, -6.2),
        (1.1, 1.5, -5.8),
        (-0.5, 0.6, -5.4),
    ],
];

fn scene() -> [Polygon; 4] {
    SCENE.map(|corners| Polygon {
        vertices: corners.iter().map(|&corner| DVec3::from(corner)).collect(),
    })
}

fn draw(sheet: &mut Sheet, scene: &[Polygon; 4]) -> Result<(), FigureError> {
    let order = order(scene, EYE).map_err(|cycle| FigureError::Scene {
        reason: cycle.to_string(),
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
            0 => format!("{name}{}", FARTHEST.text(language)),
            _ if i == last => format!("{name}{}", NEAREST.text(language)),
            _ => format!("{} {name}", THEN.text(language)),
        })
        .collect();
    let lines: Vec<&str> = lines.iter().map(String::as_str).collect();
    for (i, panel) in panels(sheet, &lines, Stage::TALLEST)?
        .into_iter()
        .enumerate()
    {
        let stage = Stage::fit(panel);
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
        let scene = scene();
        let usual = drawn(|sheet| draw(sheet, &scene));
        assert_eq!(
            lines(&usual),
            ["C, the farthest", "then A", "then D", "B, the nearest"]
        );
        assert_eq!(times(&usual), [3, 1, 4, 2]);
        // Each hides some of the one before it, so that the order is the only one.
        for (far, near) in [(2, 0), (0, 3), (3, 1)] {
            assert_eq!(compare(&scene[far], &scene[near], EYE), Pair::SecondNearer);
        }
    }

    #[test]
    fn one_moved_away_is_painted_earlier() {
        let usual = drawn(|sheet| draw(sheet, &scene()));
        // D farther and larger, the same in the picture: now behind A.
        let mut moved = scene();
        for p in &mut moved[3].vertices {
            *p *= 1.4;
        }
        let drawing = drawn(|sheet| draw(sheet, &moved));
        assert_eq!(
            lines(&drawing),
            ["C, the farthest", "then D", "then A", "B, the nearest"]
        );
        assert_eq!(times(&drawing), [2, 1, 4, 3]);
        assert_ne!(shapes(&usual), shapes(&drawing));
    }
}
