//! Spherical coordinates of a point, and the patch of the unit sphere that is a solid angle.

use core::f64::consts::FRAC_PI_2;

use ombra_math::glam::{DVec2, DVec3};
use ombra_math::spherical::Spherical;

use super::marks::{arrow, point, polyline};
use crate::colour::{Ink, Role};
use crate::drawing::{EMPHASIS, NORMAL, Pen, THIN};
use crate::error::FigureError;
use crate::figure::{About, Figure, Takes};
use crate::path::{Path, Rect};
use crate::sheet::{Align, Label, Sheet};
use crate::space::View;
use crate::text::LABEL;
use crate::words::words;

pub(super) const FIGURE: Figure = Figure {
    id: "math/spherical",
    takes: Takes::Nothing(crate::words::FIXED),
    words: WORDS,
    about: |_, language| About::new(language, SUMMARY, CAPTION),
    drawn: |sheet, _| draw(sheet),
};

words! {
    SUMMARY {
        en: "Spherical coordinates and a solid angle",
        it: "Coordinate sferiche e un angolo solido",
        cs: "Sférické souřadnice a prostorový úhel",
        hr: "Sferne koordinate i prostorni kut",
    }

    CAPTION {
        en: "*θ* is measured from the pole, *φ* from *x* towards *y*. The patch of the unit sphere is the solid angle d*ω*.",
        it: "*θ* si misura dal polo, *φ* da *x* verso *y*. La porzione di sfera unitaria è l’angolo solido d*ω*.",
        cs: "*θ* se měří od pólu, *φ* od *x* k *y*. Ploška na jednotkové kouli je prostorový úhel d*ω*.",
        hr: "*θ* se mjeri od pola, *φ* od *x* prema *y*. Djelić jedinične sfere prostorni je kut d*ω*.",
    }
}

/// The point shown.
const P: Spherical = Spherical {
    r: 1.5,
    theta: 0.8,
    phi: 1.05,
};
/// Half the extent of the patch in θ and φ.
const HALF: DVec2 = DVec2::new(0.09, 0.13);
/// Chords of a quarter circle.
const CHORDS: u32 = 24;

/// The place of a point on the stage. In the house view y is up; here z is, as the pole is always drawn, and x comes
/// towards the eye: a turn with the columns below.
fn stage(p: Spherical) -> DVec3 {
    let p = p.to_cartesian();
    DVec3::new(-0.8, 0.0, 0.6) * p.x + DVec3::new(0.6, 0.0, 0.8) * p.y + DVec3::Y * p.z
}

fn unit(theta: f64, phi: f64) -> DVec3 {
    stage(Spherical { r: 1.0, theta, phi })
}

/// Points of an arc between two directions, one of θ and φ changing, at distance `r`.
fn arc(r: f64, from: (f64, f64), to: (f64, f64)) -> Vec<DVec3> {
    (0..=CHORDS)
        .map(|i| {
            let t = f64::from(i) / f64::from(CHORDS);
            let mix = |a: f64, b: f64| a + (b - a) * t;
            unit(mix(from.0, to.0), mix(from.1, to.1)) * r
        })
        .collect()
}

fn draw(sheet: &mut Sheet) -> Result<(), FigureError> {
    let pole = (0.0, P.phi);
    let (x, y) = ((FRAC_PI_2, 0.0), (FRAC_PI_2, FRAC_PI_2));
    let foot = (FRAC_PI_2, P.phi);
    let direction = (P.theta, P.phi);
    let place = stage(P);
    let shadow = DVec3::new(place.x, 0.0, place.z);
    let axes =
        [(x, "*x*"), (y, "*y*"), ((0.0, 0.0), "*z*")].map(|(d, name)| (unit(d.0, d.1) * 1.3, name));

    let mut shown = vec![DVec3::ZERO, place, shadow];
    shown.extend(axes.map(|(tip, _)| tip));
    let frame = sheet.frame();
    let room = DVec2::new(60.0, 45.0);
    let view = View::fit(&shown, Rect::new(frame.min + room, frame.max - room))?;

    // The eighth of the unit sphere between the axes.
    let border = [
        arc(1.0, (0.0, 0.0), x),
        arc(1.0, x, y),
        arc(1.0, y, (0.0, FRAC_PI_2)),
    ]
    .concat();
    if let Some(border) = view.contour(&border) {
        sheet.fill(Path::polygon(&border), Role::Ground);
        sheet.stroke(Path::polygon(&border), Pen::new(Role::Receiver, THIN));
    }
    let grid = Pen::new(Role::Grid, THIN);
    polyline(sheet, &view, &arc(1.0, pole, foot), grid.clone());
    polyline(
        sheet,
        &view,
        &arc(1.0, (P.theta, 0.0), (P.theta, FRAC_PI_2)),
        grid,
    );
    for (tip, name) in axes {
        arrow(sheet, &view, DVec3::ZERO, tip, Role::Axis);
        if let (Some(from), Some(to)) = (view.project(DVec3::ZERO), view.project(tip)) {
            sheet.label(
                Label::new(to, name)
                    .towards(to - from)
                    .ink(Role::Axis)
                    .beside(),
            );
        }
    }

    // The patch: a range of θ and φ.
    let corner = |i: f64, j: f64| (P.theta + i * HALF.x, P.phi + j * HALF.y);
    let patch = [
        arc(1.0, corner(-1.0, -1.0), corner(1.0, -1.0)),
        arc(1.0, corner(1.0, -1.0), corner(1.0, 1.0)),
        arc(1.0, corner(1.0, 1.0), corner(-1.0, 1.0)),
        arc(1.0, corner(-1.0, 1.0), corner(-1.0, -1.0)),
    ]
    .concat();
    if let Some(patch) = view.contour(&patch) {
        let path = Path::polygon(&patch);
        sheet.fill(path.clone(), Ink::of(Role::Chosen).tint(0.45));
        sheet.stroke(path, Pen::new(Role::Chosen, NORMAL));
    }

    // Down to the plane of x and y, and back to the origin.
    let dashed = Pen::new(Role::Note, THIN).dashed();
    polyline(sheet, &view, &[place, shadow, DVec3::ZERO], dashed);
    polyline(
        sheet,
        &view,
        &[DVec3::ZERO, place],
        Pen::new(Role::Occluder, NORMAL),
    );
    for (from, to, r, name) in [(pole, direction, 0.42, "*θ*"), (x, foot, 0.42, "*φ*")] {
        let points = arc(r, from, to);
        polyline(sheet, &view, &points, Pen::new(Role::Normal, EMPHASIS));
        let middle = points
            .get(points.len() / 2)
            .and_then(|&p| Some((view.project(p)?, view.project(p * 1.3)?)));
        if let Some((at, out)) = middle {
            let label = Label::new(at, name).towards(out - at).ink(Role::Normal);
            sheet.label(label.reach(6.0).beside());
        }
    }
    point(
        sheet,
        &view,
        place,
        Role::Occluder,
        Some(("*P* (*r*, *θ*, *φ*)", DVec2::X)),
    );
    if let (Some(origin), Some(at)) = (view.project(DVec3::ZERO), view.project(place * 0.5)) {
        let label = Label::new(at, "*r*")
            .towards((at - origin).perp())
            .ink(Role::Occluder);
        sheet.label(label.reach(6.0).beside());
    }
    // The sphere has the radius 1.
    if let Some(at) = view.project(unit(0.0, 0.0)) {
        sheet.label(Label::new(at, "1").towards(DVec2::NEG_X).beside());
    }
    // The patch is named outside the sphere, where there is room.
    let (named, outside) = (unit(P.theta - HALF.x, P.phi), unit(0.42, FRAC_PI_2) * 1.22);
    if let Some((at, end)) = view.segment(named, outside) {
        sheet.line(at, end, Pen::new(Role::Note, THIN));
        let place = end + DVec2::new(10.0, 0.0);
        sheet.text(
            place,
            Align::Left,
            "d*ω* = sin *θ* d*θ* d*φ*",
            LABEL,
            Role::Chosen,
        )?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The stage only turns: right-handed, the pole up, a quarter turn of φ from x to y.
    #[test]
    fn the_stage_shows_the_axes_as_they_are() {
        let [x, y, z] =
            [(FRAC_PI_2, 0.0), (FRAC_PI_2, FRAC_PI_2), (0.0, 0.0)].map(|(t, p)| unit(t, p));
        let near = |a: DVec3, b: DVec3| (a - b).length() <= 4.0 * f64::EPSILON;
        assert!(near(x.cross(y), z) && near(y.cross(z), x));
        assert!(near(z, DVec3::Y));
    }

    #[test]
    fn the_patch_lies_around_the_direction_of_the_point() {
        let direction = unit(P.theta, P.phi);
        assert!((stage(P) - direction * P.r).length() <= 4.0 * f64::EPSILON * P.r);
        for (from, to) in [
            ((P.theta, 0.0), (P.theta, 1.0)),
            ((0.0, P.phi), (1.0, P.phi)),
        ] {
            assert!(
                arc(1.0, from, to)
                    .iter()
                    .all(|p| (p.length() - 1.0).abs() <= 4.0 * f64::EPSILON)
            );
        }
    }
}
