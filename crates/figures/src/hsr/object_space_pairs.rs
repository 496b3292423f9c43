//! Two primitives: what hides what, and what is left.

use ombra_hsr::object_space::visible_parts;
use ombra_hsr::pair::{Pair, compare};
use ombra_hsr::polygon::Polygon;
use ombra_math::glam::{DVec2, DVec3};

use super::primitives::PRIMITIVES;
use super::stage::{EYE, Stage, section};
use crate::colour::Role;
use crate::drawing::{EMPHASIS, NORMAL, Pen};
use crate::error::FigureError;
use crate::figure::{About, Figure, Takes};
use crate::input::{Ask, Inputs};
use crate::panels::panels;
use crate::sheet::{Label, Sheet};
use crate::style::Language;
use crate::words::words;

/// The three relations of Grafica 3, Approccio Object-Space.
pub(super) const FIGURE: Figure = Figure {
    id: "hsr/object-space-pairs",
    takes: Takes::These(&[DISTANCE_A.input, DISTANCE_B.input, SHIFT.input]),
    words: WORDS,
    about,
    drawn: |sheet, inputs| draw(sheet, &pairs(inputs)),
};

words! {
    SUMMARY {
        en: "Two primitives in three places: %1",
        it: "Due primitive in tre posizioni: %1",
        cs: "Dvě plochy ve třech polohách: %1",
        hr: "Dva poligona u tri položaja: %1",
    }

    CAPTION {
        en: "Above what the eye sees, below the same from above.",
        it: "In alto ciò che vede l’osservatore, in basso la pianta.",
        cs: "Nahoře to, co vidí pozorovatel, dole půdorys.",
        hr: "Gore ono što vidi oko, dolje tlocrt.",
    }

    /// Where one hides something of another.
    BEHIND {
        en: "What lies in the pyramid behind %1 is hidden; what is left of %2 is cut into convex parts.",
        it: "Ciò che sta nella piramide dietro %1 è oscurato; ciò che resta di %2 si divide in parti convesse.",
        cs: "Co leží v jehlanu za %1, je zakryté; zbytek %2 se rozdělí na konvexní části.",
        hr: "Što leži u piramidi iza %1, zaklonjeno je; ostatak od %2 dijeli se na konveksne dijelove.",
    }

    /// A panel.
    HIDDEN {
        en: "%1 hides %2",
        it: "%1 oscura %2",
        cs: "%1 zakrývá %2",
        hr: "%1 zaklanja %2",
    }

    /// A panel.
    BOTH {
        en: "%1 and %2 are visible",
        it: "%1 e %2 visibili",
        cs: "%1 i %2 jsou viditelné",
        hr: "%1 i %2 su vidljivi",
    }

    /// A panel.
    PART {
        en: "%1 hides part of %2",
        it: "%1 occlude parte di %2",
        cs: "%1 zakrývá část %2",
        hr: "%1 zaklanja dio %2",
    }

    /// A panel: each hides part of the other.
    CROSS {
        en: "%1 and %2 cross",
        it: "%1 e %2 si intersecano",
        cs: "%1 a %2 se protínají",
        hr: "%1 i %2 se sijeku",
    }

    /// An input.
    DISTANCE {
        en: "distance of this primitive’s middle from the eye",
        it: "distanza del centro di questa primitiva dall’osservatore",
        cs: "vzdálenost středu této plochy od pozorovatele",
        hr: "udaljenost sredine ovog poligona od oka",
    }

    /// An input.
    SHIFT_OF {
        en: "how far *B* is moved to the right",
        it: "di quanto *B* è spostata a destra",
        cs: "o kolik je *B* posunuta doprava",
        hr: "koliko je *B* pomaknut udesno",
    }
}

/// The lecture's distances, at which the walls stand as they are written down.
const OWN: [f64; 2] = [4.8, 8.0];
const DISTANCE_A: Ask<f64> = Ask::number("za", "*z*_{*A*}", DISTANCE, OWN[0], [2.0, 9.0]);
const DISTANCE_B: Ask<f64> = Ask::number("zb", "*z*_{*B*}", DISTANCE, OWN[1], [2.0, 9.0]);
const SHIFT: Ask<f64> = Ask::number("shift", "Δ*x*", SHIFT_OF, 0.0, [-4.0, 4.0]);

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

/// The pairs of all panels: *A* and *B* moved along their sight lines to their distances, then *B* aside.
fn pairs(inputs: &Inputs) -> [[Polygon; 2]; 3] {
    let distances = [&DISTANCE_A, &DISTANCE_B].map(|ask| inputs.get(ask));
    let shares = [distances[0] / OWN[0], distances[1] / OWN[1]];
    let shifts = [0.0, inputs.get(&SHIFT)];
    PAIRS.map(|pair| {
        let mut pair = pair.map(polygon);
        for ((polygon, share), shift) in pair.iter_mut().zip(shares).zip(shifts) {
            for p in &mut polygon.vertices {
                *p = *p * share + DVec3::X * shift;
            }
        }
        pair
    })
}

/// The names of the nearer and the farther one.
fn named(nearer: usize) -> [&'static str; 2] {
    let [(a, _), (b, _), ..] = PRIMITIVES;
    if nearer == 0 { [a, b] } else { [b, a] }
}

/// Which one is nearer: it hides, or would, what lies behind it. Of two that cross, none.
fn nearer([a, b]: &[Polygon; 2]) -> Option<usize> {
    match compare(a, b, EYE) {
        Pair::FirstNearer | Pair::Coplanar => Some(0),
        Pair::SecondNearer => Some(1),
        Pair::Crossing => None,
        Pair::Apart => {
            let away = |polygon: &Polygon| polygon.centroid().map_or(0.0, |middle| -middle.z);
            Some(usize::from(away(b) < away(a)))
        }
    }
}

/// How the two lie to each other, in a few words.
fn relation(pair: &[Polygon; 2], language: Language) -> String {
    let parts = visible_parts(pair, EYE);
    let nearer = nearer(pair);
    let farther = 1 - nearer.unwrap_or_default();
    let word = match compare(&pair[0], &pair[1], EYE) {
        Pair::Apart => BOTH,
        Pair::Crossing => CROSS,
        _ if parts.iter().all(|(source, _)| *source != farther) => HIDDEN,
        _ => PART,
    };
    // Those that hide nothing are said in the order of their names.
    let [first, second] = named(match word {
        word if word == BOTH || word == CROSS => 0,
        _ => 1 - farther,
    });
    let line = word.text(language).replace("%1", first);
    line.replace("%2", second)
}

fn about(inputs: &Inputs, language: Language) -> About {
    let pairs = pairs(inputs);
    let lines = pairs.each_ref().map(|pair| relation(pair, language));
    let hides = |pair: &&[Polygon; 2]| compare(&pair[0], &pair[1], EYE) != Pair::Apart;
    let mut hiding: Vec<[&str; 2]> = pairs
        .iter()
        .filter(hides)
        .flat_map(|pair| match nearer(pair) {
            Some(nearer) => vec![named(nearer)],
            None => vec![named(0), named(1)],
        })
        .collect();
    hiding.sort_unstable();
    hiding.dedup();
    let behind = hiding.into_iter().map(|[first, second]| {
        let sentence = BEHIND.text(language).replace("%1", first);
        sentence.replace("%2", second)
    });
    let about = About {
        summary: SUMMARY
            .text(language)
            .replace("%1", &lines.join("; ").replace('*', "")),
        caption: CAPTION.text(language).to_owned(),
    };
    behind.fold(about, |about, sentence| about.and(Some(sentence)))
}

fn draw(sheet: &mut Sheet, pairs: &[[Polygon; 2]; 3]) -> Result<(), FigureError> {
    let language = sheet.style().language;
    let lines = pairs.each_ref().map(|pair| relation(pair, language));
    let lines = lines.each_ref().map(String::as_str);
    let panels = panels(sheet, &lines, Stage::TALLEST)?;
    for (i, (panel, pair)) in panels.into_iter().zip(pairs).enumerate() {
        sheet.panel(i, panel);
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

    // From above: what lies behind the nearer one, or behind either.
    let nearer = nearer(pair);
    let is_nearer = |i: &usize| nearer.is_none_or(|nearer| nearer == *i);
    let is_farther = |i: &usize| nearer != Some(*i);
    for polygon in (0..2).filter(is_nearer).filter_map(|i| pair.get(i)) {
        stage.draw_hidden(sheet, polygon);
    }
    for (_, part) in &parts {
        for end in section(part).into_iter().flatten() {
            stage.draw_ray(sheet, end);
        }
    }
    let hidden = Pen::new(Role::Rejected, NORMAL).dashed();
    let farther: Vec<&Polygon> = (0..2)
        .filter(is_farther)
        .filter_map(|i| pair.get(i))
        .collect();
    for polygon in &farther {
        stage.draw_section(sheet, polygon, hidden.clone());
    }
    // The nearer one's outline is whole.
    let mut ordered: Vec<&(usize, Polygon)> = parts.iter().collect();
    ordered.sort_by_key(|(source, _)| nearer == Some(*source));
    for (source, part) in ordered {
        if let Some(&(_, role)) = PRIMITIVES.get(*source) {
            stage.draw_section(sheet, part, Pen::new(role, EMPHASIS));
            stage.paint(sheet, part, role);
        }
    }
    for polygon in farther {
        sheet.stroke(stage.outline(polygon), hidden.clone());
    }

    for (polygon, (name, role)) in pair.iter().zip(PRIMITIVES) {
        let side = if role == Role::Occluder { -1.0 } else { 1.0 };
        let corner = |p: &DVec2| side * p.x - p.y;
        let contour = stage.contour(polygon).into_iter();
        if let Some(p) = contour.max_by(|p, q| corner(p).total_cmp(&corner(q))) {
            let label = Label::new(p, name).towards(DVec2::new(side, -1.0));
            sheet.label(label.ink(role).within(stage.picture).beside());
        }
        if let Some((left, right)) = stage.cut(polygon) {
            let end = if side < 0.0 { left } else { right };
            let label = Label::new(end, name).towards(DVec2::new(side, 0.0));
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

    fn usual() -> [[Polygon; 2]; 3] {
        pairs(&Inputs::default())
    }

    fn moved(typed: &[(&str, &str)]) -> Inputs {
        let with = |inputs: Inputs, &(name, text): &(&str, &str)| {
            let named = |input: &&crate::input::Input| input.name == name;
            let input = FIGURE.takes.inputs().iter().find(named).unwrap();
            inputs.with(input, text).unwrap()
        };
        typed.iter().fold(Inputs::default(), with)
    }

    #[test]
    fn the_words_follow_the_distances_and_the_shift() {
        let lines =
            |typed: &[(&str, &str)]| pairs(&moved(typed)).map(|pair| relation(&pair, Language::En));
        let (hides, both, part) = (
            "*A* hides *B*",
            "*A* and *B* are visible",
            "*A* hides part of *B*",
        );
        assert_eq!(lines(&[]), [hides, both, part]);
        // B in front; its picture, smaller than A's and within it in the first panel, stays.
        let (of_a, both) = ("*B* hides part of *A*", "*A* and *B* are visible");
        assert_eq!(lines(&[("zb", "3")]), [of_a, both, of_a]);
        // Nearer and to the right, B is beside the pyramid behind A.
        assert_eq!(lines(&[("zb", "6"), ("shift", "4")])[0], both);
        // The walls are turned against each other: at one distance they cross.
        assert_eq!(lines(&[("za", "6"), ("zb", "6")])[0], "*A* and *B* cross");
        let caption = FIGURE.caption(&moved(&[("zb", "3")]), Language::En);
        assert!(
            caption.contains("behind *B* is hidden") && !caption.contains("behind *A*"),
            "{caption}"
        );
    }

    /// Nothing leaves its panel, however near or far aside B stands.
    #[test]
    fn what_lies_outside_the_view_is_cut_off() {
        for (zb, shift) in [("2", "4"), ("2", "-4"), ("9", "4"), ("9", "-4")] {
            let pairs = pairs(&moved(&[("zb", zb), ("shift", shift)]));
            let panel = Rect::new(DVec2::splat(100.0), DVec2::splat(900.0));
            let stage = Stage::fit(panel);
            let drawing = drawn(|sheet| {
                pairs.iter().for_each(|pair| draw_pair(sheet, &stage, pair));
                Ok(())
            });
            for item in shapes(&drawing) {
                let crate::drawing::Item::Shape { path, .. } = item else {
                    continue;
                };
                for p in path.points() {
                    let inside = panel.grown(0.02).contains(&Rect::new(p, p));
                    assert!(inside, "{zb} {shift}: {p}");
                }
            }
        }
    }

    #[test]
    fn the_panels_are_the_three_relations() {
        let relations = usual().map(|[a, b]| compare(&a, &b, EYE));
        assert_eq!(
            relations,
            [Pair::FirstNearer, Pair::Apart, Pair::FirstNearer]
        );
        let seen = usual().map(|pair| {
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
        let first = draw(&usual());
        assert_eq!(painted(&first), [3, 3]);
        // B of the first panel raised above A: all of it is seen.
        let mut moved = usual();
        for p in &mut moved[0][1].vertices {
            p.y += 2.4;
        }
        let moved = draw(&moved);
        assert_eq!(painted(&moved), [3, 4]);
        assert_ne!(shapes(&first), shapes(&moved));
        assert_ne!(first.labels, moved.labels);
    }

    #[test]
    fn every_visible_part_is_an_area_of_the_picture() {
        let stage = Stage::fit(Rect::new(DVec2::splat(100.0), DVec2::splat(900.0)));
        for pair in usual() {
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
