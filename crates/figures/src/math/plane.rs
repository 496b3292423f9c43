//! A plane by its normal and one of its points, and the distance of a point from it.

use ombra_math::glam::{DVec2, DVec3};
use ombra_math::plane::Plane;

use super::marks::{arrow, point, polyline};
use crate::colour::Role;
use crate::drawing::{NORMAL, Pen, THIN};
use crate::error::FigureError;
use crate::figure::{About, Figure, Takes};
use crate::input::{Ask, Inputs};
use crate::marks;
use crate::number::{as_typed, coordinates, equation, exact};
use crate::patch::Patch;
use crate::path::Rect;
use crate::sheet::{Align, Label, Sheet};
use crate::space::View;
use crate::text::LABEL;
use crate::words::{Word, words};

pub(super) const FIGURE: Figure = Figure {
    id: "math/plane",
    takes: Takes::These(&[N.input, Q.input, P.input]),
    words: WORDS,
    about: |inputs, language| {
        let side = side(inputs).map(|word| word.text(language));
        About::new(language, SUMMARY, CAPTION).and(side)
    },
    drawn: draw,
};

words! {
    SUMMARY {
        en: "A plane by a point and its normal, and how far a point is from it",
        it: "Un piano dato da un punto e dalla normale, e la distanza di un punto",
        cs: "Rovina daná bodem a normálou a vzdálenost bodu od ní",
        hr: "Ravnina zadana točkom i normalom te udaljenost točke od nje",
    }

    CAPTION {
        en: "**n** is perpendicular to the plane, *Q* lies on it: *d* = −**n**·*Q*.",
        it: "**n** è perpendicolare al piano, *Q* vi giace: *d* = −**n**·*Q*.",
        cs: "**n** je kolmé k rovině, *Q* v ní leží: *d* = −**n**·*Q*.",
        hr: "**n** je okomit na ravninu, *Q* leži u njoj: *d* = −**n**·*Q*.",
    }

    /// Where the point is.
    IN_FRONT {
        en: "*p* lies in front of the plane: the distance is positive.",
        it: "*p* sta davanti al piano: la distanza è positiva.",
        cs: "*p* leží před rovinou: vzdálenost je kladná.",
        hr: "*p* leži ispred ravnine: udaljenost je pozitivna.",
    }

    /// Where the point is.
    BEHIND {
        en: "*p* lies behind the plane: the distance is negative.",
        it: "*p* sta dietro il piano: la distanza è negativa.",
        cs: "*p* leží za rovinou: vzdálenost je záporná.",
        hr: "*p* leži iza ravnine: udaljenost je negativna.",
    }

    /// Where the point is.
    IN_THE_PLANE {
        en: "*p* lies in the plane: the distance is 0.",
        it: "*p* sta sul piano: la distanza è 0.",
        cs: "*p* leží v rovině: vzdálenost je 0.",
        hr: "*p* leži u ravnini: udaljenost je 0.",
    }

    /// An input.
    NORMAL_WORD {
        en: "the normal of the plane",
        it: "la normale del piano",
        cs: "normála roviny",
        hr: "normala ravnine",
    }

    /// An input.
    ON_PLANE {
        en: "a point of the plane",
        it: "un punto del piano",
        cs: "bod roviny",
        hr: "točka ravnine",
    }

    /// An input.
    POINT_WORD {
        en: "the point whose distance is asked for",
        it: "il punto di cui si cerca la distanza",
        cs: "bod, jehož vzdálenost se hledá",
        hr: "točka čija se udaljenost traži",
    }
}

const RANGE: [f64; 2] = [-10.0, 10.0];
/// Of length 5.
const N: Ask<DVec3> = Ask::place("n", "**n**", NORMAL_WORD, [0.0, 4.0, 3.0], RANGE);
const Q: Ask<DVec3> = Ask::place("q", "*Q*", ON_PLANE, [-3.0, 2.0, -1.0], RANGE);
const P: Ask<DVec3> = Ask::place("p", "*p*", POINT_WORD, [2.0, 5.0, 0.0], RANGE);

/// On which side of the plane the point lies; none where there is no plane.
fn side(inputs: &Inputs) -> Option<Word> {
    let plane = Plane::through(inputs.get(&Q), inputs.get(&N))?;
    let distance = plane.signed_distance(inputs.get(&P));
    Some(match distance {
        _ if distance > 0.0 => IN_FRONT,
        _ if distance < 0.0 => BEHIND,
        _ => IN_THE_PLANE,
    })
}

fn draw(sheet: &mut Sheet, inputs: &Inputs) -> Result<(), FigureError> {
    let (n, q, p) = (inputs.get(&N), inputs.get(&Q), inputs.get(&P));
    let plane = Plane::through(q, n).ok_or_else(|| FigureError::Scene {
        reason: format!(
            "the normal n = {} has no direction",
            as_typed(&n.to_array())
        ),
    })?;
    let distance = plane.signed_distance(p);
    let unit = plane.normal.normalize_or_zero();
    let foot = p - unit * distance;

    // A point of the plane that is its own foot has a patch around it, too.
    let about = q.distance(foot).max(1.0);
    let (u, v) = unit.any_orthonormal_pair();
    let around = [
        q + u * (0.4 * about),
        q - u * (0.4 * about),
        q + v * (0.4 * about),
        q - v * (0.4 * about),
    ];
    let mut feet = vec![q, foot];
    if q.distance(foot) < 1.0 {
        feet.extend(around);
    }
    let patch = Patch::around(plane, &feet)?;
    let tip = q + plane.normal;
    let mut shown = patch.corners().to_vec();
    shown.extend([tip, p, DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z]);
    let frame = sheet.frame();
    let corner = DVec2::new(70.0, 45.0);
    let aside = DVec2::new(250.0, 0.0);
    let below = DVec2::new(0.0, 1.4 * LABEL);
    let view = View::fit(
        &shown,
        Rect::new(frame.min + corner, frame.max - corner - aside - below),
    )?;

    // What lies beyond the plane, as we see it, is drawn before it and shows through.
    let ours = plane.signed_distance(view.eye()) > 0.0;
    let beyond = |p: DVec3| (plane.signed_distance(p) > 0.0) != ours;
    let axes = [DVec3::X, DVec3::Y, DVec3::Z].map(|axis| split(&plane, axis));
    for part in axes
        .iter()
        .flatten()
        .filter(|[a, b]| beyond((*a + *b) * 0.5))
    {
        polyline(sheet, &view, part, Pen::new(Role::Axis, NORMAL));
    }
    if beyond(tip) {
        sheet.step(1);
        arrow(sheet, &view, q, tip, Role::Normal);
    }
    let dashed = Pen::new(Role::Note, NORMAL).dashed();
    if beyond(p) {
        sheet.step(3);
        polyline(sheet, &view, &[p, foot], dashed.clone());
    }
    sheet.step(0);
    patch.draw_glass(sheet, &view);
    for (parts, (axis, name)) in
        axes.iter()
            .zip([(DVec3::X, "*x*"), (DVec3::Y, "*y*"), (DVec3::Z, "*z*")])
    {
        for part in parts.iter().filter(|[a, b]| !beyond((*a + *b) * 0.5)) {
            polyline(sheet, &view, part, Pen::new(Role::Axis, NORMAL));
        }
        // Where it goes through the plane.
        if let [_, [through, _]] = parts[..] {
            point(sheet, &view, through, Role::Axis, None);
        }
        if let Some((from, to)) = view.segment(DVec3::ZERO, axis) {
            marks::arrow(sheet, to - (to - from) * 0.3, to, Role::Axis, NORMAL);
            let label = Label::new(to, name).towards(to - from).ink(Role::Axis);
            sheet.label(label.beside());
        }
    }

    sheet.step(1);
    if !beyond(tip) {
        arrow(sheet, &view, q, tip, Role::Normal);
    }
    let name = |p: DVec3, name: &str| format!("*{name}* {}", coordinates(p));
    point(
        sheet,
        &view,
        q,
        Role::Receiver,
        Some((&name(q, "Q"), DVec2::Y)),
    );
    if let (Some(from), Some(to)) = (view.project(q), view.project(tip)) {
        let label = Label::new(to, format!("**n** = {}", coordinates(plane.normal)));
        sheet.label(label.towards(to - from).ink(Role::Normal));
    }
    // The plane in numbers, below its left corner.
    let lines = [
        format!("*d* = −**n**·*Q* = {}", exact(plane.d)),
        equation(plane),
    ];
    for (line, up) in lines.iter().zip([0.5, 1.9]) {
        let at = DVec2::new(frame.min.x + 70.0, frame.max.y - up * LABEL);
        sheet.text(at, Align::Left, line, LABEL, Role::Text)?;
    }

    sheet.step(2);
    point(
        sheet,
        &view,
        p,
        Role::Chosen,
        Some((&name(p, "p"), DVec2::NEG_Y)),
    );
    // From p straight to its foot, with the right angle there.
    sheet.step(3);
    if !beyond(p) {
        polyline(sheet, &view, &[p, foot], dashed);
    }
    let size = 0.07 * about.max(distance.abs());
    let side = (q - foot).normalize_or(u) * size;
    let up = unit * (if distance < 0.0 { -size } else { size });
    if distance != 0.0 {
        let corner = [foot + side, foot + side + up, foot + up];
        polyline(sheet, &view, &corner, Pen::new(Role::Note, THIN));
    }
    point(sheet, &view, foot, Role::Receiver, None);
    if let (Some(from), Some(to)) = (view.project(foot), view.project(p)) {
        let label = format!("(**n**·*p* + *d*) / ∥**n**∥ = {}", exact(distance));
        sheet.label(Label::new((from + to) * 0.5, label).reach(20.0));
    }
    Ok(())
}

/// An axis of length 1 in one piece, or in two where the plane cuts it.
fn split(plane: &Plane, axis: DVec3) -> Vec<[DVec3; 2]> {
    let t = -plane.d / plane.normal.dot(axis);
    if 0.0 < t && t < 1.0 {
        vec![[DVec3::ZERO, axis * t], [axis * t, axis]]
    } else {
        vec![[DVec3::ZERO, axis]]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::style::{Language, Style};

    fn said(inputs: &Inputs) -> Vec<String> {
        let drawing = FIGURE.draw(&Style::default(), inputs).unwrap();
        drawing.labels.into_iter().map(|label| label.text).collect()
    }

    /// Behind: n·p + d = 4·0 + 3·(−5) − 5 = −20, over 5.
    #[test]
    fn a_point_behind_has_a_negative_distance() {
        let inputs = Inputs::default().with(&P.input, "1,0,-5").unwrap();
        assert!(said(&inputs).contains(&"(n·p + d) / ∥n∥ = −4".to_owned()));
        assert!(FIGURE.caption(&inputs, Language::En).contains("behind"));
        let inputs = Inputs::default().with(&P.input, "7,2,-1").unwrap();
        assert!(said(&inputs).contains(&"(n·p + d) / ∥n∥ = 0".to_owned()));
        assert!(
            FIGURE
                .caption(&inputs, Language::En)
                .contains("distance is 0")
        );
    }

    #[test]
    fn a_normal_without_direction_is_said() {
        let inputs = Inputs::default().with(&N.input, "0,0,0").unwrap();
        let error = FIGURE.draw(&Style::default(), &inputs).unwrap_err();
        assert_eq!(error.to_string(), "the normal n = 0,0,0 has no direction");
    }

    /// The plane x = 1/4 cuts the x axis, and no other.
    #[test]
    fn an_axis_is_split_where_it_meets_the_plane() {
        let plane = Plane {
            normal: DVec3::X,
            d: -0.25,
        };
        let parts = [DVec3::X, DVec3::Y, DVec3::Z].map(|axis| split(&plane, axis).len());
        assert_eq!(parts, [2, 1, 1]);
        assert_eq!(split(&plane, DVec3::X)[0][1], DVec3::X * 0.25);
    }
}
