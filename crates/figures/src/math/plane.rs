//! A plane by its normal and one of its points, and the distance of a point from it.

use ombra_math::glam::{DVec2, DVec3};
use ombra_math::mesh::Mesh;
use ombra_math::plane::Plane;

use super::marks::{arrow, point, polyline};
use crate::colour::Role;
use crate::drawing::{NORMAL, Pen, THIN};
use crate::error::FigureError;
use crate::figure::{About, Figure, Takes};
use crate::number::{coordinates, equation, exact};
use crate::patch::Patch;
use crate::path::Rect;
use crate::sheet::{Align, Label, Sheet};
use crate::solid::sight::Sight;
use crate::space::{View, axes};
use crate::text::LABEL;
use crate::words::words;

pub(super) const FIGURE: Figure = Figure {
    id: "math/plane",
    takes: Takes::Nothing(crate::words::FIXED),
    words: WORDS,
    about: |_, language| About::new(language, SUMMARY, CAPTION),
    drawn: |sheet, _| draw(sheet),
};

words! {
    SUMMARY {
        en: "A plane by a point and its normal, and how far a point is from it",
        it: "Un piano dato da un punto e dalla normale, e la distanza di un punto",
        cs: "Rovina daná bodem a normálou a vzdálenost bodu od ní",
        hr: "Ravnina zadana točkom i normalom te udaljenost točke od nje",
    }

    CAPTION {
        en: "**n** is perpendicular to the plane, *Q* lies on it: *d* = −**n**·*Q*. In front of the plane the distance is positive.",
        it: "**n** è perpendicolare al piano, *Q* vi giace: *d* = −**n**·*Q*. Davanti al piano la distanza è positiva.",
        cs: "**n** je kolmé k rovině, *Q* v ní leží: *d* = −**n**·*Q*. Před rovinou je vzdálenost kladná.",
        hr: "**n** je okomit na ravninu, *Q* leži u njoj: *d* = −**n**·*Q*. Ispred ravnine udaljenost je pozitivna.",
    }
}

/// n, of length 5; Q on the plane; p in front of it.
const NORMAL_VECTOR: DVec3 = DVec3::new(0.0, 4.0, 3.0);
const Q: DVec3 = DVec3::new(-3.0, 2.0, -1.0);
const P: DVec3 = DVec3::new(2.0, 5.0, 0.0);

fn draw(sheet: &mut Sheet) -> Result<(), FigureError> {
    let plane = Plane::through(Q, NORMAL_VECTOR).unwrap_or(Plane::GROUND);
    let distance = plane.signed_distance(P);
    let unit = plane.normal.normalize_or_zero();
    let foot = P - unit * distance;

    let patch = Patch::around(plane, &[Q, foot])?;
    let tip = Q + plane.normal;
    let mut shown = patch.corners().to_vec();
    shown.extend([tip, P, DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z]);
    let frame = sheet.frame();
    let corner = DVec2::new(70.0, 45.0);
    let aside = DVec2::new(250.0, 0.0);
    let view = View::fit(
        &shown,
        Rect::new(frame.min + corner, frame.max - corner - aside),
    )?;

    patch.draw(sheet, &view);
    axes(sheet, &view, &Sight::new(&view, &Mesh::default()), 1.0);
    // From p straight down to its foot, with the right angle there.
    polyline(
        sheet,
        &view,
        &[P, foot],
        Pen::new(Role::Note, NORMAL).dashed(),
    );
    let side = (Q - foot).normalize_or_zero() * 0.4;
    let up = unit * 0.4;
    let corner = [foot + side, foot + side + up, foot + up];
    polyline(sheet, &view, &corner, Pen::new(Role::Note, THIN));
    point(sheet, &view, foot, Role::Receiver, None);
    arrow(sheet, &view, Q, tip, Role::Normal);

    let name = |p: DVec3, name: &str| format!("*{name}* {}", coordinates(p));
    point(
        sheet,
        &view,
        Q,
        Role::Receiver,
        Some((&name(Q, "Q"), DVec2::Y)),
    );
    point(
        sheet,
        &view,
        P,
        Role::Chosen,
        Some((&name(P, "p"), DVec2::NEG_Y)),
    );
    if let (Some(from), Some(to)) = (view.project(Q), view.project(tip)) {
        let label = Label::new(to, format!("**n** = {}", coordinates(plane.normal)));
        sheet.label(label.towards(to - from).ink(Role::Normal));
    }
    if let (Some(from), Some(to)) = (view.project(foot), view.project(P)) {
        let label = format!("(**n**·*p* + *d*) / ∥**n**∥ = {}", exact(distance));
        sheet.label(Label::new((from + to) * 0.5, label).reach(20.0));
    }
    // The plane in numbers, below its left corner.
    let lines = [
        format!("*d* = −**n**·*Q* = {}", exact(plane.d)),
        equation(plane),
    ];
    for (line, up) in lines.iter().zip([1.0, 2.4]) {
        let at = DVec2::new(frame.min.x + 70.0, frame.max.y - up * LABEL);
        sheet.text(at, Align::Left, line, LABEL, Role::Text)?;
    }
    Ok(())
}
