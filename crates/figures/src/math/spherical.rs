//! Spherical coordinates of a point, and the patch of the unit sphere that is a solid angle.

use core::f64::consts::{FRAC_PI_2, PI};

use ombra_math::glam::{DVec2, DVec3};
use ombra_math::spherical::Spherical;

use super::marks::{arrow, point, polyline};
use crate::colour::{Ink, Role};
use crate::drawing::{EMPHASIS, NORMAL, Pen, THIN};
use crate::error::FigureError;
use crate::figure::{About, Figure, Takes};
use crate::input::{Ask, Inputs};
use crate::path::{Path, Rect};
use crate::sheet::{Label, Sheet};
use crate::space::View;
use crate::words::words;

pub(super) const FIGURE: Figure = Figure {
    id: "math/spherical",
    takes: Takes::These(&[THETA.input, PHI.input, R.input]),
    words: WORDS,
    about: |_, language| About::new(language, SUMMARY, CAPTION),
    drawn: draw,
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

    /// An input.
    FROM_POLE {
        en: "the angle from the pole, in degrees",
        it: "l’angolo dal polo, in gradi",
        cs: "úhel od pólu ve stupních",
        hr: "kut od pola u stupnjevima",
    }

    /// An input.
    FROM_X {
        en: "the angle from x towards y, in degrees",
        it: "l’angolo da x verso y, in gradi",
        cs: "úhel od x k y ve stupních",
        hr: "kut od x prema y u stupnjevima",
    }

    /// An input.
    RADIUS {
        en: "the distance from the origin",
        it: "la distanza dall’origine",
        cs: "vzdálenost od počátku",
        hr: "udaljenost od ishodišta",
    }
}

const THETA: Ask<f64> = Ask::number("theta", "*θ*", FROM_POLE, 45.0, [0.0, 180.0]);
const PHI: Ask<f64> = Ask::number("phi", "*φ*", FROM_X, 60.0, [0.0, 360.0]);
const R: Ask<f64> = Ask::number("r", "*r*", RADIUS, 1.5, [0.25, 3.0]);
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

/// The point shown.
fn given(inputs: &Inputs) -> Spherical {
    Spherical {
        r: inputs.get(&R),
        theta: inputs.get(&THETA).to_radians(),
        phi: inputs.get(&PHI).to_radians(),
    }
}

/// The patch around a direction: from and to in θ, which ends at the poles, and in φ.
fn patch(p: Spherical) -> [[f64; 2]; 2] {
    [
        [(p.theta - HALF.x).max(0.0), (p.theta + HALF.x).min(PI)],
        [p.phi - HALF.y, p.phi + HALF.y],
    ]
}

fn draw(sheet: &mut Sheet, inputs: &Inputs) -> Result<(), FigureError> {
    let p = given(inputs);
    let pole = (0.0, p.phi);
    let (x, y) = ((FRAC_PI_2, 0.0), (FRAC_PI_2, FRAC_PI_2));
    let foot = (FRAC_PI_2, p.phi);
    let direction = (p.theta, p.phi);
    let place = stage(p);
    let shadow = DVec3::new(place.x, 0.0, place.z);
    let axes =
        [(x, "*x*"), (y, "*y*"), ((0.0, 0.0), "*z*")].map(|(d, name)| (unit(d.0, d.1) * 1.3, name));
    // The eighth of the unit sphere with the direction.
    let quarter = (p.phi / FRAC_PI_2).floor().min(3.0) * FRAC_PI_2;
    let (from, to) = ((FRAC_PI_2, quarter), (FRAC_PI_2, quarter + FRAC_PI_2));
    let top = if p.theta > FRAC_PI_2 { PI } else { 0.0 };
    let border = [
        arc(1.0, (top, from.1), from),
        arc(1.0, from, to),
        arc(1.0, to, (top, to.1)),
    ]
    .concat();

    let mut shown = vec![DVec3::ZERO, place, shadow];
    shown.extend(axes.map(|(tip, _)| tip));
    shown.extend(&border);
    let frame = sheet.frame();
    let room = DVec2::new(60.0, 45.0);
    let view = View::fit(&shown, Rect::new(frame.min + room, frame.max - room))?;

    if let Some(border) = view.contour(&border) {
        sheet.fill(Path::polygon(&border), Role::Ground);
        sheet.stroke(Path::polygon(&border), Pen::new(Role::Receiver, THIN));
    }
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
    // The sphere has the radius 1.
    if let Some(at) = view.project(unit(0.0, 0.0)) {
        sheet.label(Label::new(at, "1").towards(DVec2::NEG_X).beside());
    }

    sheet.step(1);
    // Down to the plane of x and y, and back to the origin.
    let dashed = Pen::new(Role::Note, THIN).dashed();
    polyline(sheet, &view, &[place, shadow, DVec3::ZERO], dashed);
    polyline(
        sheet,
        &view,
        &[DVec3::ZERO, place],
        Pen::new(Role::Occluder, NORMAL),
    );
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
    let angles = [(2, pole, direction, "*θ*"), (3, x, foot, "*φ*")];
    for (step, from, to, name) in angles {
        sheet.step(step);
        let points = arc(0.42, from, to);
        polyline(sheet, &view, &points, Pen::new(Role::Normal, EMPHASIS));
        let middle = points
            .get(points.len() / 2)
            .and_then(|&p| Some((view.project(p)?, view.project(p * 1.3)?)));
        if let Some((at, out)) = middle {
            let label = Label::new(at, name).towards(out - at).ink(Role::Normal);
            sheet.label(label.reach(6.0).beside());
        }
    }

    // The patch, a range of θ and φ, between circles of both; and the cone of directions through it.
    sheet.step(4);
    let grid = Pen::new(Role::Grid, THIN);
    polyline(sheet, &view, &arc(1.0, (top, p.phi), foot), grid.clone());
    polyline(
        sheet,
        &view,
        &arc(1.0, (p.theta, from.1), (p.theta, to.1)),
        grid,
    );
    let [[low, high], [start, end]] = patch(p);
    let corners = [(low, start), (high, start), (high, end), (low, end)];
    let next = corners.iter().cycle().skip(1);
    let sides: Vec<Vec<DVec3>> = corners
        .iter()
        .zip(next)
        .map(|(&from, &to)| arc(1.0, from, to))
        .collect();
    let cone = Ink::of(Role::Chosen);
    for side in &sides {
        let mut face = vec![DVec3::ZERO];
        face.extend(side);
        if let Some(face) = view.contour(&face) {
            sheet.fill(Path::polygon(&face), cone.alpha(0.13));
        }
    }
    for (theta, phi) in corners {
        let edge = [DVec3::ZERO, unit(theta, phi)];
        polyline(sheet, &view, &edge, Pen::new(cone, THIN));
    }
    if let Some(patch) = view.contour(&sides.concat()) {
        let path = Path::polygon(&patch);
        sheet.fill(path.clone(), cone.tint(0.45));
        sheet.stroke(path, Pen::new(Role::Chosen, NORMAL));
    }
    // Its name is outside the sphere, where there is room.
    if let Some((at, out)) = view.segment(unit(low, p.phi), unit(low, p.phi) * 1.5) {
        let label = Label::new(at, "d*ω* = sin *θ* d*θ* d*φ*");
        sheet.label(label.towards(out - at).ink(Role::Chosen));
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
        let p = given(&Inputs::default());
        let direction = unit(p.theta, p.phi);
        assert!((stage(p) - direction * p.r).length() <= 4.0 * f64::EPSILON * p.r);
        for (from, to) in [
            ((p.theta, 0.0), (p.theta, 1.0)),
            ((0.0, p.phi), (1.0, p.phi)),
        ] {
            assert!(
                arc(1.0, from, to)
                    .iter()
                    .all(|p| (p.length() - 1.0).abs() <= 4.0 * f64::EPSILON)
            );
        }
    }

    #[test]
    fn the_patch_ends_at_the_poles_and_degrees_are_turned_into_radians() {
        for (theta, phi, from, to) in [
            ("0", "0", 0.0, HALF.x),
            ("180", "360", PI - HALF.x, PI),
            ("90", "90", FRAC_PI_2 - HALF.x, FRAC_PI_2 + HALF.x),
        ] {
            let inputs = Inputs::default()
                .with(&THETA.input, theta)
                .and_then(|inputs| inputs.with(&PHI.input, phi));
            let p = given(&inputs.unwrap());
            let [[low, high], _] = patch(p);
            assert!(
                (low - from).abs() < 1e-15 && (high - to).abs() < 1e-15,
                "{theta}"
            );
        }
    }
}
