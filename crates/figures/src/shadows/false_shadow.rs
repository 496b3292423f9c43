//! One light, one plate at three heights: the matrix draws a shadow each time, and only one is true.

use ombra_math::glam::{DVec2, DVec3, DVec4};
use ombra_math::homogeneous::{point, project};
use ombra_math::plane::Plane;
use ombra_shadows::planar::{Placement, classify, shadow_matrix};

use crate::colour::Role;
use crate::drawing::{EMPHASIS, NORMAL, Pen};
use crate::error::FigureError;
use crate::figure::{About, Figure, Takes};
use crate::marks;
use crate::number::exact;
use crate::panels::panels;
use crate::path::{Path, Rect};
use crate::section::{STRIP, Section, ground};
use crate::sheet::{Label, Sheet};
use crate::text::NOTE;
use crate::words::{TRUE_SHADOW, Word, words};

/// Olomouc, Nevýhody; Croatian 8.4, projicirane sjene.
pub(super) const FIGURE: Figure = Figure {
    id: "shadows/false-shadow",
    takes: Takes::Nothing(crate::words::FIXED),
    words: WORDS,
    about: |_, language| About::new(language, SUMMARY, CAPTION),
    drawn: |sheet, _| {
        let language = sheet.style().language;
        let lines = HEIGHTS.map(|height| line_of(height).text(language));
        let frames = panels(sheet, &lines, 1.45)?;
        for (frame, height) in frames.into_iter().zip(HEIGHTS) {
            draw(sheet, frame, height)?;
        }
        Ok(())
    },
};

words! {
    SUMMARY {
        en: "A true shadow beside two false ones: object behind the plane, object behind the light",
        it: "Un’ombra vera e due false: oggetto dietro il piano, oggetto dietro la luce",
        cs: "Skutečný stín a dva falešné: těleso za rovinou, těleso za zdrojem",
        hr: "Prava sjena i dvije neispravne: objekt iza ravnine, objekt iza izvora",
    }

    CAPTION {
        en: "The matrix finds a point in all three cases; a shadow falls only where the object is between light and plane.",
        it: "La matrice trova un punto in tutti e tre i casi; l’ombra cade solo se l’oggetto è tra la luce e il piano.",
        cs: "Matice najde bod ve všech třech případech; stín vrhá jen těleso mezi zdrojem a rovinou.",
        hr: "Matrica nalazi točku u sva tri slučaja; sjenu baca samo objekt između izvora i ravnine.",
    }

    /// First panel of `shadows/false-shadow`.
    BETWEEN {
        en: "*t* ≤ 0: between",
        it: "*t* ≤ 0: in mezzo",
        cs: "*t* ≤ 0: mezi nimi",
        hr: "*t* ≤ 0: između",
    }

    /// Second panel of `shadows/false-shadow`.
    BEHIND_PLANE {
        en: "0 < *t* < 1: behind the plane",
        it: "0 < *t* < 1: dietro il piano",
        cs: "0 < *t* < 1: za rovinou",
        hr: "0 < *t* < 1: iza ravnine",
    }

    /// Third panel of `shadows/false-shadow`.
    BEYOND_LIGHT {
        en: "*t* > 1: behind the light",
        it: "*t* > 1: dietro la luce",
        cs: "*t* > 1: za zdrojem",
        hr: "*t* > 1: iza izvora",
    }

    /// What a matrix draws where there is no shadow.
    FALSE_SHADOW {
        en: "false shadow",
        it: "ombra falsa",
        cs: "falešný stín",
        hr: "neispravna sjena",
    }
}

const LIGHT: DVec4 = DVec4::new(0.0, 4.0, 0.0, 1.0);
/// The plate's height in each panel, and its ends.
const HEIGHTS: [f64; 3] = [2.0, -2.0, 6.0];
const ENDS: [f64; 2] = [-0.2, 0.9];
/// What every panel shows.
const SHOWN: [DVec2; 2] = [DVec2::new(-2.0, -2.3), DVec2::new(2.0, 6.2)];
/// The light stands this share of a panel's width right of its middle, which leaves room for words on the left.
const ASIDE: f64 = 0.16;

/// The panel's line, by what the library says of the plate.
fn line_of(height: f64) -> Word {
    match classify(Plane::GROUND, LIGHT, DVec3::new(ENDS[0], height, 0.0)) {
        Some(Placement::Casts) => BETWEEN,
        Some(Placement::BehindPlane) => BEHIND_PLANE,
        _ => BEYOND_LIGHT,
    }
}

fn draw(sheet: &mut Sheet, panel: Rect, height: f64) -> Result<(), FigureError> {
    let mut frame = panel;
    frame.min.x += 2.0 * ASIDE * panel.size().x;
    let section = Section::fit(&SHOWN, frame)?;
    let at = |p: DVec3| section.at(p.truncate());
    let language = sheet.style().language;

    let line = section.at(DVec2::ZERO).y;
    let edge = |x| DVec2::new(x, line);
    ground(sheet, edge(panel.min.x), edge(panel.max.x));

    let light = LIGHT.truncate();
    let plate = ENDS.map(|x| DVec3::new(x, height, 0.0));
    let drawn_by_matrix = |v: DVec3| -> Option<DVec3> {
        project(shadow_matrix(Plane::GROUND, LIGHT).ok()? * point(v))
    };
    let shadow = plate.map(|v| drawn_by_matrix(v).unwrap_or_default());
    let is_true = line_of(height) == BETWEEN;

    for (v, p) in plate.into_iter().zip(shadow) {
        // In order along the ray; light travels as far as the first thing it meets.
        let (first, last) = match line_of(height) {
            BETWEEN => (v, p),
            _ => (p, v),
        };
        marks::ray_from_sun(sheet, at(light), at(first));
        let from = if line_of(height) == BEYOND_LIGHT {
            light
        } else {
            first
        };
        marks::stopped_ray(sheet, at(from), at(last));
        sheet.avoid(&Path::line(at(from), at(last)));
    }

    let [a, b] = shadow.map(at);
    if is_true {
        sheet.line(a, b, Pen::new(Role::Shadow, 2.0 * EMPHASIS));
    } else {
        // Hollow: nothing is dark there.
        let half = DVec2::new(0.0, EMPHASIS);
        let bar = Path::polygon(&[a - half, b - half, b + half, a + half]);
        sheet.fill(bar.clone(), Role::Paper);
        sheet.stroke(bar, Pen::new(Role::Rejected, NORMAL).dashed());
    }
    let [c, d] = plate.map(at);
    sheet.line(c, d, Pen::new(Role::Occluder, 2.0 * EMPHASIS));
    marks::sun(sheet, at(light));

    let words = if is_true { TRUE_SHADOW } else { FALSE_SHADOW };
    // Below the ground's hatched strip, clear of rays that go on there.
    let (under, side) = match line_of(height) {
        BEHIND_PLANE => (a.min(b), DVec2::new(-1.0, 1.0)),
        _ => ((a + b) * 0.5, DVec2::Y),
    };
    let label = Label::new(under + DVec2::new(0.0, STRIP), words.text(language));
    sheet.label(label.towards(side).size(NOTE).within(panel));
    sheet.label(
        Label::new(at(light), "**L**")
            .reach(marks::SUN + 2.0)
            .towards(DVec2::NEG_X),
    );
    let t = exact(height / (height - LIGHT.y));
    sheet.label(
        Label::new(c, format!("*t* = {t}"))
            .reach(EMPHASIS + 4.0)
            .towards(DVec2::NEG_X)
            .within(panel),
    );
    Ok(())
}
