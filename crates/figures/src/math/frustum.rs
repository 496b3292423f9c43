//! The view frustum, and the cube it becomes.

use ombra_math::glam::{DVec2, DVec3};
use ombra_math::view;

use super::marks::{arrow, polyline};
use crate::colour::{Ink, Role};
use crate::drawing::{NORMAL, Pen, THIN};
use crate::error::FigureError;
use crate::figure::{About, Figure, Takes};
use crate::input::{Ask, Inputs};
use crate::marks;
use crate::number::{coordinates, exact};
use crate::panels::panels;
use crate::path::{Path, Rect};
use crate::sheet::{Label, Sheet};
use crate::space::View;
use crate::words::words;

pub(super) const FIGURE: Figure = Figure {
    id: "math/frustum",
    takes: Takes::These(&[L.input, R.input, B.input, T.input, N.input, F.input]),
    words: WORDS,
    about: |_, language| About::new(language, SUMMARY, CAPTION).and(Some(TURNED.text(language))),
    drawn: draw,
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

    /// On the axes.
    TURNED {
        en: "*z* turns round: in the cube it points away from the eye.",
        it: "*z* si inverte: nel cubo punta lontano dall’occhio.",
        cs: "*z* se obrací: v krychli míří od oka.",
        hr: "*z* se okreće: u kocki pokazuje od oka.",
    }

    /// An input.
    LEFT {
        en: "x of the left side of the near section",
        it: "x del lato sinistro della sezione vicina",
        cs: "x levé strany bližšího řezu",
        hr: "x lijeve stranice bližeg presjeka",
    }

    /// An input.
    RIGHT {
        en: "x of the right side of the near section",
        it: "x del lato destro della sezione vicina",
        cs: "x pravé strany bližšího řezu",
        hr: "x desne stranice bližeg presjeka",
    }

    /// An input.
    BOTTOM {
        en: "y of the lower side of the near section",
        it: "y del lato inferiore della sezione vicina",
        cs: "y dolní strany bližšího řezu",
        hr: "y donje stranice bližeg presjeka",
    }

    /// An input.
    TOP {
        en: "y of the upper side of the near section",
        it: "y del lato superiore della sezione vicina",
        cs: "y horní strany bližšího řezu",
        hr: "y gornje stranice bližeg presjeka",
    }

    /// An input.
    NEAR {
        en: "the distance of the near plane",
        it: "la distanza del piano vicino",
        cs: "vzdálenost bližší roviny",
        hr: "udaljenost bliže ravnine",
    }

    /// An input.
    FAR {
        en: "the distance of the far plane",
        it: "la distanza del piano lontano",
        cs: "vzdálenost vzdálenější roviny",
        hr: "udaljenost dalje ravnine",
    }

    /// The first picture.
    BEFORE {
        en: "The eye looks along\u{a0}−*z*",
        it: "L’occhio guarda lungo\u{a0}−*z*",
        cs: "Oko hledí ve směru\u{a0}−*z*",
        hr: "Oko gleda uzduž\u{a0}−*z*",
    }

    /// The second picture.
    AFTER {
        en: "After matrix and division: *z* turned",
        it: "Dopo matrice e divisione: *z* invertito",
        cs: "Po matici a dělení: *z* obráceno",
        hr: "Nakon matrice i dijeljenja: *z* okrenut",
    }
}

const L: Ask<f64> = Ask::number("left", "*l*", LEFT, -0.55, [-3.0, 3.0]);
const R: Ask<f64> = Ask::number("right", "*r*", RIGHT, 0.55, [-3.0, 3.0]);
const B: Ask<f64> = Ask::number("bottom", "*b*", BOTTOM, -0.45, [-3.0, 3.0]);
const T: Ask<f64> = Ask::number("top", "*t*", TOP, 0.45, [-3.0, 3.0]);
const N: Ask<f64> = Ask::number("near", "*n*", NEAR, 1.0, [0.25, 8.0]);
const F: Ask<f64> = Ask::number("far", "*f*", FAR, 3.0, [0.25, 20.0]);

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

fn draw(sheet: &mut Sheet, inputs: &Inputs) -> Result<(), FigureError> {
    let [l, r, b, t, n, f] = [&L, &R, &B, &T, &N, &F].map(|ask| inputs.get(ask));
    let matrix = view::frustum(l, r, b, t, n, f).map_err(|error| FigureError::Scene {
        reason: error.to_string(),
    })?;
    // The section at a distance from the eye.
    let section = |distance: f64| -> Section {
        [(l, b), (r, b), (r, t), (l, t)].map(|(x, y)| DVec3::new(x, y, -n) * (distance / n))
    };
    let language = sheet.style().language;
    let lines = [BEFORE, AFTER].map(|word| word.text(language));
    let [before, after] = panels(sheet, &lines, 1.0)?[..] else {
        return Ok(());
    };

    // Near, the distance that becomes the middle of the cube, far.
    let sections = [n, 2.0 * f * n / (f + n), f].map(section);
    sheet.panel(0, before);
    let [near, _, far] = sections;
    let size = far.iter().chain(&near).map(|p| p.abs().max_element());
    let size = size.fold(0.0, f64::max) / 3.0;
    let picture = Picture::new(before, stage, sections, 1.05 * size, 50.0)?;
    // Where the eye sees the corners.
    for corner in near {
        let pen = Pen::new(Role::Ray, THIN).dashed();
        polyline(
            sheet,
            &picture.view,
            &[stage(DVec3::ZERO), stage(corner)],
            pen,
        );
    }
    picture.draw(sheet, 0.95 * size);
    let corners = ["(*l*, *b*, −*n*)", "(*r*, *t*, −*n*)"].map(str::to_owned);
    let depths = ["−2*fn* / (*f* + *n*)", "−*f*"].map(str::to_owned);
    picture.name(sheet, &corners, &depths);
    if let (Some(eye), Some(ahead)) = (picture.at(DVec3::ZERO), picture.at(DVec3::NEG_Z)) {
        // The axes begin around the eye.
        sheet.fill(Path::circle(eye, 33.0), Role::Paper);
        marks::eye(sheet, eye, ahead - eye);
    }

    sheet.panel(1, after);
    let cube = sections.map(|section| section.map(|p| matrix.project_point3(p)));
    let picture = Picture::new(after, cube_stage, cube, 0.0, 125.0)?;
    picture.draw(sheet, 0.7);
    let [near, middle, far] = cube;
    picture.name(
        sheet,
        &[near[0], near[2]].map(coordinates),
        &[middle[0].z, far[0].z].map(exact),
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

    /// The lower left and the upper right corner of the near section; z of the others.
    fn name(&self, sheet: &mut Sheet, corners: &[String; 2], depths: &[String; 2]) {
        let [near, middle, far] = self.sections;
        let z = |z: &String| format!("*z* = {z}");
        let [low, high] = corners.clone();
        let [between, beyond] = depths.each_ref().map(z);
        for (p, towards, role, name) in [
            (near[0], DVec2::new(-1.0, 1.0), Role::Occluder, low),
            (near[2], DVec2::NEG_Y, Role::Occluder, high),
            (middle[3], DVec2::NEG_Y, Role::Chosen, between),
            (far[1], DVec2::Y, Role::Occluder, beyond),
        ] {
            if let Some(at) = self.at(p) {
                sheet.label(Label::new(at, name).towards(towards).ink(role));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::style::Style;

    #[test]
    fn what_has_no_extent_is_said_and_an_oblique_frustum_is_drawn() {
        let style = Style::default();
        let with =
            |name: &Ask<f64>, value: &str| Inputs::default().with(&name.input, value).unwrap();
        let error = FIGURE.draw(&style, &with(&R, "-0.55")).unwrap_err();
        assert!(error.to_string().contains("-0.55"), "{error}");
        let error = FIGURE.draw(&style, &with(&F, "1")).unwrap_err();
        assert!(error.to_string().contains('1'), "{error}");
        let oblique = FIGURE.draw(&style, &with(&L, "0.1")).unwrap();
        assert_ne!(
            oblique.items,
            FIGURE.draw(&style, &Inputs::default()).unwrap().items
        );
        assert_eq!(FIGURE.steps(&style, &Inputs::default()).unwrap(), 2);
    }
}
