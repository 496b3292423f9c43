//! One light, one plate at three heights: the matrix draws a shadow each time, and only one is true.

use ombra_math::glam::{DVec2, DVec3, DVec4};
use ombra_math::homogeneous::{point, project};
use ombra_math::plane::Plane;
use ombra_shadows::planar::{Placement, classify, shadow_matrix};

use crate::colour::Role;
use crate::drawing::{EMPHASIS, NORMAL, Pen};
use crate::error::FigureError;
use crate::figure::{About, Figure, Takes};
use crate::input::Ask;
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
    takes: Takes::These(&[LIGHT.input, V1.input, V2.input, V3.input]),
    words: WORDS,
    about: |_, language| About::new(language, SUMMARY, CAPTION),
    drawn: |sheet, inputs| {
        let language = sheet.style().language;
        let light = DVec4::new(0.0, inputs.get(&LIGHT), 0.0, 1.0);
        let heights = [V1, V2, V3].map(|height| inputs.get(&height));
        sheet.heading("*S*(*t*) = *V* − *t* (*V* − **L**)")?;
        let lines = heights.map(|height| line_of(light, height).text(language));
        let frames = panels(sheet, &lines, 1.3)?;
        for (i, (frame, height)) in frames.into_iter().zip(heights).enumerate() {
            sheet.panel(i, frame);
            draw(sheet, frame, light, height)?;
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

    /// An input.
    LIGHT_WORD {
        en: "height of the light",
        it: "altezza della luce",
        cs: "výška zdroje",
        hr: "visina izvora",
    }

    /// An input.
    PLATE_WORD {
        en: "height of the plate in its picture",
        it: "altezza della lastra nella sua figura",
        cs: "výška desky na jejím obrázku",
        hr: "visina ploče na njezinoj slici",
    }

    /// What a matrix draws where there is no shadow.
    FALSE_SHADOW {
        en: "false shadow",
        it: "ombra falsa",
        cs: "falešný stín",
        hr: "neispravna sjena",
    }
}

/// The light's height, and the plate's in each panel.
const LIGHT: Ask<f64> = Ask::number("l", "*L*_y", LIGHT_WORD, 4.0, [2.6, 5.0]);
const V1: Ask<f64> = Ask::number("v1", "*V*_{1,y}", PLATE_WORD, 2.0, [0.4, 2.2]);
const V2: Ask<f64> = Ask::number("v2", "*V*_{2,y}", PLATE_WORD, -2.0, [-2.2, -0.4]);
const V3: Ask<f64> = Ask::number("v3", "*V*_{3,y}", PLATE_WORD, 6.0, [5.4, 6.1]);
/// How far from the light's foot a shadow may reach.
const FARTHEST: f64 = 1.6;
/// The ends of the plate.
const ENDS: [f64; 2] = [-0.2, 0.9];
/// What every panel shows.
const SHOWN: [DVec2; 2] = [DVec2::new(-2.0, -2.3), DVec2::new(2.0, 6.2)];
/// The light stands this share of a panel's width right of its middle, which leaves room for words on the left.
const ASIDE: f64 = 0.16;

/// The panel's line, by what the library says of the plate.
fn line_of(light: DVec4, height: f64) -> Word {
    match classify(Plane::GROUND, light, DVec3::new(ENDS[0], height, 0.0)) {
        Some(Placement::Casts) => BETWEEN,
        Some(Placement::BehindPlane) => BEHIND_PLANE,
        _ => BEYOND_LIGHT,
    }
}

fn draw(sheet: &mut Sheet, panel: Rect, source: DVec4, height: f64) -> Result<(), FigureError> {
    let kind = line_of(source, height);
    let mut frame = panel;
    frame.min.x += 2.0 * ASIDE * panel.size().x;
    let section = Section::fit(&SHOWN, frame)?;
    let at = |p: DVec3| section.at(p.truncate());
    let language = sheet.style().language;

    let line = section.at(DVec2::ZERO).y;
    let edge = |x| DVec2::new(x, line);
    ground(sheet, edge(panel.min.x), edge(panel.max.x));

    let light = source.truncate();
    // A plate right above the light throws its false shadow far away: it is shorter then.
    let spread = (source.y / (source.y - height)).abs() * ENDS[1];
    let length = (FARTHEST / spread).min(1.0);
    let plate = ENDS.map(|x| DVec3::new(x * length, height, 0.0));
    let drawn_by_matrix = |v: DVec3| -> Option<DVec3> {
        project(shadow_matrix(Plane::GROUND, source).ok()? * point(v))
    };
    let shadow = plate.map(|v| drawn_by_matrix(v).unwrap_or_default());
    let is_true = kind == BETWEEN;

    for (v, p) in plate.into_iter().zip(shadow) {
        // In order along the ray; light travels as far as the first thing it meets.
        let (first, last) = match kind {
            BETWEEN => (v, p),
            _ => (p, v),
        };
        marks::ray_from_sun(sheet, at(light), at(first));
        let from = if kind == BEYOND_LIGHT { light } else { first };
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

    // Where the point is for three values of t: on the plate, at the light, on the plane.
    let value = exact(height / (height - source.y));
    let right = |a: DVec2, b: DVec2| if a.x > b.x { a } else { b };
    for (at, reach, t) in [
        (right(c, d), EMPHASIS + 4.0, "0"),
        (at(light), marks::SUN + 2.0, "1"),
        (right(a, b), EMPHASIS + 4.0, value.as_str()),
    ] {
        let label = Label::new(at, format!("*t* = {t}")).reach(reach);
        sheet.label(label.towards(DVec2::new(1.0, -0.2)));
    }
    let words = if is_true { TRUE_SHADOW } else { FALSE_SHADOW };
    // Below the ground's hatched strip, clear of rays that go on there.
    let (under, side) = match kind {
        BEHIND_PLANE => (a.min(b), DVec2::new(-1.0, 1.0)),
        _ => ((a + b) * 0.5, DVec2::Y),
    };
    let label = Label::new(under + DVec2::new(0.0, STRIP), words.text(language));
    sheet.label(label.towards(side).size(NOTE));
    for (place, name, reach) in [
        (at(light), "**L**", marks::SUN + 2.0),
        (c.min(d), "*V*", EMPHASIS + 4.0),
    ] {
        sheet.label(Label::new(place, name).reach(reach).towards(DVec2::NEG_X));
    }
    Ok(())
}
