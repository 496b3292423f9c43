//! Two primitives: what hides what, and what is left.

use ombra_hsr::object_space::visible_parts;
use ombra_hsr::polygon::Polygon;
use ombra_math::glam::{DVec2, DVec3};

use super::primitives::PRIMITIVES;
use super::stage::{EYE, Stage, section};
use crate::colour::Role;
use crate::drawing::{EMPHASIS, NORMAL, Pen};
use crate::error::FigureError;
use crate::figure::{About, Figure, Takes};
use crate::panels::panels;
use crate::sheet::{Label, Sheet};
use crate::words::words;

/// The three relations of Grafica 3, Approccio Object-Space.
pub(super) const FIGURE: Figure = Figure {
    id: "hsr/object-space-pairs",
    takes: Takes::Nothing(crate::words::FIXED),
    words: WORDS,
    about: |_, language| About::new(language, SUMMARY, CAPTION),
    drawn: |sheet, _| draw(sheet, &pairs()),
};

words! {
    SUMMARY {
        en: "Two primitives: one hides the other, both are visible, one hides part of the other",
        it: "Due primitive: una oscura l’altra, entrambe visibili, una occlude parzialmente l’altra",
        cs: "Dvě plochy: jedna zakrývá druhou, obě jsou viditelné, jedna zakrývá část druhé",
        hr: "Dva poligona: jedan zaklanja drugi, oba su vidljiva, jedan zaklanja dio drugoga",
    }

    CAPTION {
        en: "Above what the eye sees, below the same from above. What lies in the pyramid behind *A* is hidden; what is left of *B* is cut into convex parts.",
        it: "In alto ciò che vede l’osservatore, in basso la pianta. Ciò che sta nella piramide dietro *A* è oscurato; ciò che resta di *B* si divide in parti convesse.",
        cs: "Nahoře to, co vidí pozorovatel, dole půdorys. Co leží v jehlanu za *A*, je zakryté; zbytek *B* se rozdělí na konvexní části.",
        hr: "Gore ono što vidi oko, dolje tlocrt. Što leži u piramidi iza *A*, zaklonjeno je; ostatak od *B* dijeli se na konveksne dijelove.",
    }

    /// The first panel.
    HIDDEN {
        en: "*A* hides *B*",
        it: "*A* oscura *B*",
        cs: "*A* zakrývá *B*",
        hr: "*A* zaklanja *B*",
    }

    /// The second panel.
    BOTH {
        en: "*A* and *B* are visible",
        it: "*A* e *B* visibili",
        cs: "*A* i *B* jsou viditelné",
        hr: "*A* i *B* su vidljivi",
    }

    /// The third panel.
    PART {
        en: "*A* hides part of *B*",
        it: "*A* occlude parte di *B*",
        cs: "*A* zakrývá část *B*",
        hr: "*A* zaklanja dio *B*",
    }
}

/// An upright rectangle: where it stands on the left and on the right, (x, z), and from where to where it reaches in y.
type Wall = ([(f64, f64); 2], [f64; 2]);

/// *A* and *B*, in the order of the panels.
const PAIRS: [[Wall; 2]; 3] = [
    [
        ([(-1.7, -5.2), (1.5, -4.4)], [-1.0, 1.0]),
        ([(-1.5, -7.6), (1.7, -8.4)], [-0.9, 1.1]),
    ],
    [
        ([(-2.1, -5.3), (-0.4, -4.5)], [-1.0, 1.0]),
        ([(0.4, -7.6), (3.4, -8.4)], [-1.4, 1.4]),
    ],
    [
        ([(-1.9, -5.2), (0.6, -4.4)], [-1.1, 0.6]),
        ([(-1.4, -7.6), (3.0, -8.4)], [-0.7, 2.0]),
    ],
];

fn pairs() -> [[Polygon; 2]; 3] {
    PAIRS.map(|pair| pair.map(polygon))
}

fn draw(sheet: &mut Sheet, pairs: &[[Polygon; 2]; 3]) -> Result<(), FigureError> {
    let language = sheet.style().language;
    let lines = [HIDDEN, BOTH, PART].map(|word| word.text(language));
    for (panel, pair) in panels(sheet, &lines, Stage::TALLEST)?
        .into_iter()
        .zip(pairs)
    {
        draw_pair(sheet, &Stage::fit(panel), pair);
    }
    Ok(())
}

fn polygon(([left, right], [low, high]): Wall) -> Polygon {
    let corner = |(x, z), y| DVec3::new(x, y, z);
    Polygon {
        vertices: vec![
            corner(left, low),
            corner(right, low),
            corner(right, high),
            corner(left, high),
        ],
    }
}

fn draw_pair(sheet: &mut Sheet, stage: &Stage, pair: &[Polygon; 2]) {
    let parts = visible_parts(pair, EYE);
    stage.draw_frame(sheet);

    // From above.
    let [a, b] = pair;
    stage.draw_hidden(sheet, a);
    for (_, part) in &parts {
        for end in section(part).into_iter().flatten() {
            stage.draw_ray(sheet, end);
        }
    }
    let hidden = Pen::new(Role::Rejected, NORMAL).dashed();
    stage.draw_section(sheet, b, hidden.clone());
    // The nearer one's outline is whole.
    for (source, part) in parts.iter().rev() {
        if let Some(&(_, role)) = PRIMITIVES.get(*source) {
            stage.draw_section(sheet, part, Pen::new(role, EMPHASIS));
            stage.paint(sheet, part, role);
        }
    }
    sheet.stroke(stage.outline(b), hidden);

    for (polygon, (name, role)) in pair.iter().zip(PRIMITIVES) {
        let side = if role == Role::Occluder { -1.0 } else { 1.0 };
        let corner = |p: &&DVec3| side * stage.seen(**p).x - stage.seen(**p).y;
        let corner = polygon
            .vertices
            .iter()
            .max_by(|p, q| corner(p).total_cmp(&corner(q)));
        if let Some(&p) = corner {
            let label = Label::new(stage.seen(p), name).towards(DVec2::new(side, -1.0));
            sheet.label(label.ink(role).within(stage.picture).beside());
        }
        if let Some([left, right]) = section(polygon) {
            let end = if side < 0.0 { left } else { right };
            let label = Label::new(stage.above(end), name).towards(DVec2::new(side, 0.0));
            sheet.label(label.ink(role).beside());
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::drawn::{areas, drawn, fills, shapes};
    use super::super::primitives::AREA;
    use super::*;
    use crate::colour::Ink;
    use crate::drawing::Drawing;
    use crate::path::Rect;
    use crate::path::round;
    use ombra_hsr::pair::{Pair, compare};

    #[test]
    fn the_panels_are_the_three_relations() {
        let relations = pairs().map(|[a, b]| compare(&a, &b, EYE));
        assert_eq!(
            relations,
            [Pair::FirstNearer, Pair::Apart, Pair::FirstNearer]
        );
        let seen = pairs().map(|pair| {
            let parts = visible_parts(&pair, EYE);
            [0, 1].map(|i| parts.iter().filter(|(source, _)| *source == i).count())
        });
        // B is gone, whole, and an L: what juts out above and aside.
        assert_eq!(seen, [[1, 0], [1, 1], [1, 2]]);
    }

    #[test]
    fn what_is_painted_is_what_the_library_finds_visible() {
        let draw = |pairs: &[[Polygon; 2]; 3]| drawn(|sheet| draw(sheet, pairs));
        let painted = |drawing: &Drawing| {
            [Role::Occluder, Role::Receiver].map(|role| areas(drawing, Ink::of(role).tint(AREA)))
        };
        let usual = draw(&pairs());
        assert_eq!(painted(&usual), [3, 3]);
        // B of the first panel raised above A: all of it is seen.
        let mut moved = pairs();
        for p in &mut moved[0][1].vertices {
            p.y += 2.4;
        }
        let moved = draw(&moved);
        assert_eq!(painted(&moved), [3, 4]);
        assert_ne!(shapes(&usual), shapes(&moved));
        assert_ne!(usual.labels, moved.labels);
    }

    #[test]
    fn every_visible_part_is_an_area_of_the_picture() {
        let stage = Stage::fit(Rect::new(DVec2::splat(100.0), DVec2::splat(900.0)));
        for pair in pairs() {
            let drawing = drawn(|sheet| {
                draw_pair(sheet, &stage, &pair);
                Ok(())
            });
            let fills = fills(&drawing);
            for (source, part) in visible_parts(&pair, EYE) {
                let ink = Ink::of(PRIMITIVES[source].1).tint(AREA);
                let outline = stage.outline(&part).map(round);
                assert!(fills.contains(&(ink, &outline)), "{source}: {part:?}");
            }
        }
    }
}
