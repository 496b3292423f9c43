//! The view frustum, and the cube it becomes.

use ombra_math::glam::{DVec2, DVec3};
use ombra_math::view;

use super::marks::{arrow, polyline};
use crate::colour::{Ink, Role};
use crate::drawing::{NORMAL, Pen, THIN};
use crate::error::FigureError;
use crate::figure::{About, Figure, Takes};
use crate::marks;
use crate::number::exact;
use crate::panels::panels;
use crate::path::{Path, Rect};
use crate::sheet::{Label, Sheet};
use crate::space::View;
use crate::words::words;

pub(super) const FIGURE: Figure = Figure {
    id: "math/frustum",
    takes: Takes::Nothing(crate::words::FIXED),
    words: WORDS,
    about: |_, language| About::new(language, SUMMARY, CAPTION),
    drawn: |sheet, _| draw(sheet),
};

words! {
    SUMMARY {
        en: "The view frustum and the cube it becomes",
        it: "Il volume di vista e il cubo che diventa",
        cs: "Pohledový objem a krychle, kterou se stane",
        hr: "Volumen pogleda i kocka u koju prelazi",
    }

    CAPTION {
        en: "The plane *z* = −2*fn* / (*f* + *n*) comes to the middle of the cube: half of all depths lies before it.",
        it: "Il piano *z* = −2*fn* / (*f* + *n*) arriva al centro del cubo: metà delle profondità sta davanti.",
        cs: "Rovina *z* = −2*fn* / (*f* + *n*) přejde do středu krychle: polovina všech hloubek leží před ní.",
        hr: "Ravnina *z* = −2*fn* / (*f* + *n*) dolazi u sredinu kocke: polovica svih dubina leži ispred nje.",
    }

    /// The first picture.
    BEFORE {
        en: "What the eye sees along\u{a0}−*z*",
        it: "Ciò che l’occhio vede lungo\u{a0}−*z*",
        cs: "Co vidí oko ve směru −*z*",
        hr: "Što oko vidi uzduž −*z*",
    }

    /// The second picture.
    AFTER {
        en: "After the matrix and the division by\u{a0}*w*",
        it: "Dopo la matrice e la divisione per\u{a0}*w*",
        cs: "Po násobení maticí a dělení\u{a0}*w*",
        hr: "Nakon matrice i dijeljenja s\u{a0}*w*",
    }
}

/// l = −r and b = −t.
const R: f64 = 0.55;
const T: f64 = 0.45;
const N: f64 = 1.0;
const F: f64 = 3.0;

/// A rectangle across the view, counter-clockwise from the lower left corner as the eye sees it.
type Section = [DVec3; 4];

/// A place of view space on the stage, turned so that the eye looks to the right and a little away from us.
fn stage(p: DVec3) -> DVec3 {
    DVec3::new(-p.z, p.y, p.x)
}

/// The same turn in the cube, whose z points away from the eye: its axes are left-handed.
fn cube_stage(p: DVec3) -> DVec3 {
    DVec3::new(p.z, p.y, p.x)
}

/// The frustum's section at a distance from the eye.
fn section(distance: f64) -> Section {
    [(-R, -T), (R, -T), (R, T), (-R, T)].map(|(x, y)| DVec3::new(x, y, -N) * (distance / N))
}

fn draw(sheet: &mut Sheet) -> Result<(), FigureError> {
    let matrix = view::frustum(-R, R, -T, T, N, F).map_err(|error| FigureError::Scene {
        reason: error.to_string(),
    })?;
    let language = sheet.style().language;
    let lines = [BEFORE, AFTER].map(|word| word.text(language));
    let [before, after] = panels(sheet, &lines, 1.0)?[..] else {
        return Ok(());
    };

    // Near, the distance that becomes the middle of the cube, far.
    let sections = [N, 2.0 * F * N / (F + N), F].map(section);
    let picture = Picture::new(before, stage, sections, 1.05, 50.0)?;
    picture.draw(sheet, 0.95);
    let sides = ["*l*", "*r*", "*b*", "*t*"].map(str::to_owned);
    let depths = ["−*n*", "−2*fn* / (*f* + *n*)", "−*f*"].map(str::to_owned);
    picture.name(sheet, &sides, &depths);
    if let (Some(eye), Some(ahead)) = (picture.at(DVec3::ZERO), picture.at(DVec3::NEG_Z)) {
        // The axes begin around the eye.
        sheet.fill(Path::circle(eye, 33.0), Role::Paper);
        marks::eye(sheet, eye, ahead - eye);
    }

    let cube = sections.map(|section| section.map(|p| matrix.project_point3(p)));
    let picture = Picture::new(after, cube_stage, cube, 0.0, 125.0)?;
    picture.draw(sheet, 0.7);
    let [near, middle, far] = cube;
    let [low, .., high] = [near[0], near[2]];
    let sides = [("x", low.x), ("x", high.x), ("y", low.y), ("y", high.y)];
    picture.name(
        sheet,
        &sides.map(|(axis, value)| format!("*{axis}* = {}", exact(value))),
        &[near[0].z, middle[0].z, far[0].z].map(exact),
    );
    Ok(())
}

/// Three sections joined by four edges, and the axes at their origin.
struct Picture {
    view: View,
    stage: fn(DVec3) -> DVec3,
    /// Near, between, far.
    sections: [Section; 3],
}

impl Picture {
    /// In `panel` with room for labels `aside`, on the left, and for an axis that reaches `behind` the origin.
    fn new(
        panel: Rect,
        stage: fn(DVec3) -> DVec3,
        sections: [Section; 3],
        behind: f64,
        aside: f64,
    ) -> Result<Picture, FigureError> {
        let mut shown: Vec<DVec3> = sections.concat();
        shown.push(DVec3::ZERO + DVec3::Z * behind);
        let shown: Vec<DVec3> = shown.into_iter().map(stage).collect();
        let (left, right) = (DVec2::new(aside, 75.0), DVec2::new(50.0, 75.0));
        let view = View::fit(&shown, Rect::new(panel.min + left, panel.max - right))?;
        Ok(Picture {
            view,
            stage,
            sections,
        })
    }

    fn at(&self, p: DVec3) -> Option<DVec2> {
        self.view.project((self.stage)(p))
    }

    fn draw(&self, sheet: &mut Sheet, axis: f64) {
        let Picture { view, stage, .. } = self;
        let [near, middle, far] = self.sections.map(|section| section.map(stage));
        let outline = Pen::new(Role::Occluder, NORMAL);
        let fill = |sheet: &mut Sheet, section: &Section, ink: Ink, pen: &Pen| {
            if let Some(points) = view.contour(section) {
                sheet.fill(Path::polygon(&points), ink);
                sheet.stroke(Path::polygon(&points), pen.clone());
            }
        };
        fill(sheet, &far, Ink::of(Role::Occluder).alpha(0.22), &outline);
        let chosen = Ink::of(Role::Chosen);
        fill(
            sheet,
            &middle,
            chosen.alpha(0.22),
            &Pen::new(chosen, NORMAL),
        );
        for (a, b) in near.into_iter().zip(far) {
            polyline(sheet, view, &[a, b], Pen::new(Role::Occluder, THIN));
        }
        let axes = [(DVec3::X, "*x*"), (DVec3::Y, "*y*"), (DVec3::Z, "*z*")];
        for (direction, name) in axes {
            let tip = direction * axis;
            arrow(sheet, view, stage(DVec3::ZERO), stage(tip), Role::Axis);
            if let (Some(from), Some(to)) = (self.at(DVec3::ZERO), self.at(tip)) {
                let label = Label::new(to, name).towards(to - from).ink(Role::Axis);
                sheet.label(label.beside());
            }
        }
        fill(sheet, &near, Ink::of(Role::Occluder).alpha(0.22), &outline);
    }

    /// Left, right, bottom and top of the near section; z of each section.
    fn name(&self, sheet: &mut Sheet, sides: &[String; 4], depths: &[String; 3]) {
        let [near, middle, far] = self.sections;
        let edges = [(0, 3), (1, 2), (0, 1), (2, 3)];
        let centre = near.iter().sum::<DVec3>() / 4.0;
        for ((i, j), name) in edges.into_iter().zip(sides) {
            let edge = (near[i] + near[j]) * 0.5;
            if let (Some(at), Some(centre)) = (self.at(edge), self.at(centre)) {
                let label = Label::new(at, name).towards(at - centre);
                sheet.label(label.reach(4.0).beside());
            }
        }
        let places = [
            (near[1], DVec2::Y, Role::Occluder),
            (middle[3], DVec2::NEG_Y, Role::Chosen),
            (far[1], DVec2::Y, Role::Occluder),
        ];
        for ((p, towards, role), z) in places.into_iter().zip(depths) {
            if let Some(at) = self.at(p) {
                sheet.label(
                    Label::new(at, format!("*z* = {z}"))
                        .towards(towards)
                        .ink(role),
                );
            }
        }
    }
}
