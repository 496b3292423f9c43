//! Barycentric weights: areas opposite to the corners, and the lines on which a weight is equal.

use ombra_math::glam::{DVec2, DVec3};
use ombra_math::triangle::barycentric;

use crate::colour::{Ink, Role};
use crate::drawing::{NORMAL, Pen, THIN};
use crate::error::FigureError;
use crate::figure::{About, Figure, Takes};
use crate::input::{Ask, Inputs};
use crate::marks;
use crate::number::{as_typed, exact, inline};
use crate::panels::panels;
use crate::path::Path;
use crate::section::Section;
use crate::sheet::{Align, Label, Sheet};
use crate::text::{LABEL, NOTE};
use crate::words::words;

pub(super) const FIGURE: Figure = Figure {
    id: "math/barycentric-weights",
    takes: Takes::These(&[A.input, B.input, C.input, P.input]),
    words: WORDS,
    about: |inputs, language| {
        let about = About::new(language, SUMMARY, CAPTION);
        let sum = weights(inputs).map(|weights| {
            let [alpha, beta, gamma] = weights.to_array().map(inline);
            SUM.text(language)
                .replace("%1", &alpha)
                .replace("%2", &beta)
                .replace("%3", &gamma)
        });
        let outside = weights(inputs).filter(|weights| weights.min_element() < 0.0);
        about.and(sum).and(outside.map(|_| OUTSIDE.text(language)))
    },
    drawn: draw,
};

words! {
    SUMMARY {
        en: "Barycentric weights: areas opposite to the corners",
        it: "Coordinate baricentriche: aree opposte ai vertici",
        cs: "Barycentrické souřadnice: plochy proti vrcholům",
        hr: "Baricentrične koordinate: površine nasuprot vrhovima",
    }

    CAPTION {
        en: "The weight of a corner is the share of the area that lies opposite; along a parallel to that side it stays the same.",
        it: "Il peso di un vertice è la quota dell’area opposta; lungo una parallela a quel lato resta uguale.",
        cs: "Váha vrcholu je podíl protilehlé plochy; podél rovnoběžky s tou stranou se nemění.",
        hr: "Težina vrha udio je nasuprotne površine; duž paralele s tom stranicom ostaje ista.",
    }

    /// The weights.
    SUM {
        en: "Here *α* = %1, *β* = %2, *γ* = %3, and their sum is 1.",
        it: "Qui *α* = %1, *β* = %2, *γ* = %3, e la loro somma è 1.",
        cs: "Zde *α* = %1, *β* = %2, *γ* = %3 a jejich součet je 1.",
        hr: "Ovdje je *α* = %1, *β* = %2, *γ* = %3, a njihov je zbroj 1.",
    }

    /// Where a weight is negative.
    OUTSIDE {
        en: "Beyond a side the weight of the corner opposite is negative.",
        it: "Oltre un lato il peso del vertice opposto è negativo.",
        cs: "Za stranou je váha protilehlého vrcholu záporná.",
        hr: "Iza stranice težina je nasuprotnog vrha negativna.",
    }

    /// The second picture.
    EQUAL {
        en: "lines of equal *α*",
        it: "rette con *α* uguale",
        cs: "přímky stejného *α*",
        hr: "pravci jednakog *α*",
    }

    /// An input.
    CORNER {
        en: "a corner of the triangle",
        it: "un vertice del triangolo",
        cs: "vrchol trojúhelníku",
        hr: "vrh trokuta",
    }

    /// An input.
    POINT {
        en: "the point whose weights are shown",
        it: "il punto di cui si mostrano i pesi",
        cs: "bod, jehož váhy se ukazují",
        hr: "točka čije se težine prikazuju",
    }
}

const RANGE: [[f64; 2]; 2] = [[-20.0; 2], [20.0; 2]];
const A: Ask<DVec2> = Ask::point("a", "*A*", CORNER, [0.0, 0.0], RANGE);
const B: Ask<DVec2> = Ask::point("b", "*B*", CORNER, [12.0, 0.0], RANGE);
const C: Ask<DVec2> = Ask::point("c", "*C*", CORNER, [3.0, 9.0], RANGE);
const P: Ask<DVec2> = Ask::point("p", "*p*", POINT, [4.0, 3.0], RANGE);
/// Room for the corners' names.
const ROOM: f64 = 75.0;
/// From a side to the end of a line of equal weight.
const ON: f64 = 36.0;
/// Weights whose lines are drawn.
const LEVELS: [f64; 5] = [0.0, 0.25, 0.5, 0.75, 1.0];

fn weights(inputs: &Inputs) -> Option<DVec3> {
    let [a, b, c, p] = [&A, &B, &C, &P].map(|ask| inputs.get(ask).extend(0.0));
    barycentric(p, a, b, c)
}

fn draw(sheet: &mut Sheet, inputs: &Inputs) -> Result<(), FigureError> {
    let language = sheet.style().language;
    let corners = [&A, &B, &C].map(|ask| inputs.get(ask));
    let p = inputs.get(&P);
    let weights = weights(inputs).ok_or_else(|| {
        let corners = corners.map(|corner| as_typed(&corner.to_array()));
        FigureError::Scene {
            reason: format!("the triangle {} has no area", corners.join(" ")),
        }
    })?;
    let shown = [corners[0], corners[1], corners[2], p];
    let (low, high) = shown
        .iter()
        .fold((p, p), |(low, high), &q| (low.min(q), high.max(q)));
    let size = high - low;
    let [alpha, beta, gamma] = weights.to_array().map(exact);
    let first = format!("*α* = {alpha}, *β* = {beta}, *γ* = {gamma}");
    let lines = [first.as_str(), EQUAL.text(language)];
    let panels = panels(sheet, &lines, (size.y / size.x).clamp(0.5, 1.6))?;
    for (i, panel) in panels.into_iter().enumerate() {
        sheet.panel(i, panel);
        let section = Section::fit(&shown, panel.grown(-ROOM))?;
        let places = corners.map(|corner| section.at(corner));
        let at = section.at(p);
        match i {
            0 => areas(sheet, &places, at, weights)?,
            _ => equal(sheet, &places)?,
        }
        let outline = Path::polygon(&places);
        sheet.stroke(outline, Pen::new(Role::Text, NORMAL));
        let middle = (places[0] + places[1] + places[2]) / 3.0;
        for (place, name) in places.into_iter().zip(["*A*", "*B*", "*C*"]) {
            marks::point(sheet, place, Role::Text);
            sheet.label(Label::new(place, name).towards(place - middle).beside());
        }
        marks::point(sheet, at, Role::Chosen);
        let label = Label::new(at, "*p*")
            .towards(DVec2::NEG_Y)
            .ink(Role::Chosen);
        sheet.label(label.beside());
    }
    sheet.whole();
    Ok(())
}

/// The three areas, each opposite to its corner, with its weight.
fn areas(
    sheet: &mut Sheet,
    corners: &[DVec2; 3],
    p: DVec2,
    weights: DVec3,
) -> Result<(), FigureError> {
    let [a, b, c] = *corners;
    let areas = [
        ([p, b, c], Role::Occluder, "*α*", weights.x),
        ([p, c, a], Role::Normal, "*β*", weights.y),
        ([p, a, b], Role::Chosen, "*γ*", weights.z),
    ];
    for (area, role, _, weight) in areas {
        let ink = Ink::of(role);
        sheet.fill(
            Path::polygon(&area),
            ink.alpha(if weight < 0.0 { 0.1 } else { 0.22 }),
        );
    }
    // Told apart in grey, too: dense, wide, and across.
    let [(first, ..), (second, ..), (third, ..)] = areas;
    let mirrored = third.map(|p| DVec2::new(-p.x, p.y));
    let across = Path::hatching(&mirrored, 24.0).map(|p| DVec2::new(-p.x, p.y));
    let hatches = [
        (Path::hatching(&first, 13.0), Role::Occluder),
        (Path::hatching(&second, 34.0), Role::Normal),
        (across, Role::Chosen),
    ];
    for (lines, role) in hatches {
        sheet.stroke_unmarked(lines, Pen::new(Ink::of(role).tint(0.45), THIN));
    }
    for corner in corners {
        sheet.line(p, *corner, Pen::new(Role::Note, THIN));
    }
    for (area, role, name, _) in areas {
        let middle = (area[0] + area[1] + area[2]) / 3.0;
        sheet.text(middle, Align::Centre, name, LABEL, role)?;
    }
    Ok(())
}

/// Parallels to B C at round values of α, from one of the other sides to the other and a little on.
fn equal(sheet: &mut Sheet, corners: &[DVec2; 3]) -> Result<(), FigureError> {
    let [a, b, c] = *corners;
    sheet.fill(Path::polygon(corners), Role::Ground);
    let along = (c - b).normalize_or_zero();
    for level in LEVELS {
        let ends = [b, c].map(|corner| corner + (a - corner) * level);
        let (from, to) = (ends[0] - along * ON, ends[1] + along * ON);
        sheet.line(from, to, Pen::new(Role::Occluder, NORMAL));
        let name = from - along * (0.75 * ON);
        sheet.text(name, Align::Centre, &exact(level), NOTE, Role::Occluder)?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::style::{Language, Style};

    /// 5/12 (0, 0) + 1/4 (12, 0) + 1/3 (3, 9) = (4, 3).
    #[test]
    fn the_weights_are_the_shares_of_the_areas() {
        let inputs = Inputs::default();
        let [a, b, c, p] = [&A, &B, &C, &P].map(|ask| inputs.get(ask));
        let area = |a: DVec2, b: DVec2, c: DVec2| (b - a).perp_dot(c - a);
        let whole = area(a, b, c);
        let expected = DVec3::new(area(p, b, c), area(p, c, a), area(p, a, b)) / whole;
        assert_eq!(weights(&inputs), Some(expected));
        assert_eq!(expected, DVec3::new(5.0, 3.0, 4.0) / 12.0);
        let drawing = FIGURE.draw(&Style::default(), &inputs).unwrap();
        let said: Vec<String> = drawing.labels.into_iter().map(|label| label.text).collect();
        let said = said.join(" ");
        for weight in ["α = 5/12", "β = 1/4", "γ = 1/3"] {
            assert!(said.contains(weight), "{said}");
        }
    }

    #[test]
    fn outside_a_weight_is_negative_and_a_flat_triangle_is_said() {
        let inputs = Inputs::default().with(&P.input, "6,-3").unwrap();
        assert!(FIGURE.caption(&inputs, Language::En).contains("negative"));
        let inputs = Inputs::default().with(&C.input, "24,0");
        assert!(inputs.is_err());
        let inputs = Inputs::default().with(&C.input, "20,0").unwrap();
        let error = FIGURE.draw(&Style::default(), &inputs).unwrap_err();
        assert_eq!(error.to_string(), "the triangle 0,0 12,0 20,0 has no area");
    }
}
