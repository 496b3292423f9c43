//! An ellipse instead of a shadow, over the true one.

use ombra_math::glam::{DVec2, DVec3, DVec4};
use ombra_math::plane::Plane;
use ombra_shadows::fake::ellipse;

use super::setting::{ABOVE, OBJECT, Setting, TURN, light, of_object, on_sheet};
use crate::colour::Role;
use crate::drawing::{EMPHASIS, Pen, THIN};
use crate::error::FigureError;
use crate::figure::{About, Figure, Takes};
use crate::input::Ask;
use crate::number::as_typed;
use crate::object::NamedMesh;
use crate::path::Path;
use crate::sheet::{Label, Sheet};
use crate::solid::{mesh, sight::Sight};
use crate::words::{TRUE_SHADOW, words};

/// Olomouc, Zjednodušení; Croatian 8.4, lažne sjene.
pub(super) const FIGURE: Figure = Figure {
    id: "shadows/fake",
    takes: Takes::These(&[LIGHT.input, OBJECT.input, TURN.input, ABOVE.input]),
    words: WORDS,
    about: |inputs, language| {
        About::new(language, SUMMARY, CAPTION).and(of_object(inputs, language))
    },
    drawn: |sheet, inputs| {
        let object = lowered((*inputs.get(&OBJECT)).clone());
        let setting = Setting::new(&object, inputs.get(&LIGHT), Plane::GROUND)?.seen(inputs);
        let fake = ellipse(&setting.mesh.positions, setting.plane, setting.light).ok_or_else(|| {
            FigureError::Scene {
                reason: format!(
                    "the light {} casts no shadow of the object's middle on the ground, where the ellipse would lie (--light)",
                    as_typed(&setting.light.to_array())
                ),
            }
        })?;
        let rim: Vec<DVec3> = (0..CORNERS)
            .map(|i| fake.point(core::f64::consts::TAU * f64::from(i) / f64::from(CORNERS)))
            .collect();
        let stage = setting.stage(sheet.frame(), &rim)?;
        let view = &stage.view;
        stage.patch.draw(sheet, view);
        sheet.step(1);
        setting.draw_shadow(sheet, &stage);

        let language = sheet.style().language;
        let shadow: Vec<DVec2> = setting
            .casts
            .iter()
            .filter_map(|p| on_sheet(sheet, view, (*p)?))
            .collect();
        sheet.step(2);
        if let Some(rim) = view.contour(&rim) {
            sheet.stroke_unmarked(Path::hatching(&rim, 16.0), Pen::new(Role::Chosen, THIN));
            sheet.stroke(Path::polygon(&rim), Pen::new(Role::Chosen, EMPHASIS));
            let words = SHADOW.text(language);
            name_ellipse(sheet, &rim, &shadow, words);
        }
        sheet.step(1);
        if let Some(leftmost) = shadow.into_iter().min_by(|a, b| a.x.total_cmp(&b.x)) {
            let label = Label::new(leftmost, TRUE_SHADOW.text(language));
            sheet.label(label.towards(DVec2::NEG_X).ink(Role::Shadow));
        }

        sheet.step(0);
        mesh(sheet, view, &setting.shown, Role::Occluder)?;
        let sight = Sight::new(view, &setting.shown);
        setting.draw_light(sheet, view, &sight);
        Ok(())
    },
};

words! {
    SUMMARY {
        en: "A fake shadow, an ellipse, over the true one",
        it: "Un’ombra finta, un’ellisse, sopra quella vera",
        cs: "Pseudostín, elipsa, přes skutečný stín",
        hr: "Lažna sjena, elipsa, preko prave sjene",
    }

    CAPTION {
        en: "The ellipse has the object’s largest extents: it says where the object is, not what shape it has.",
        it: "L’ellisse ha le dimensioni massime dell’oggetto: dice dove si trova, non che forma ha.",
        cs: "Elipsa má největší rozměry tělesa: říká, kde těleso je, ne jaký má tvar.",
        hr: "Elipsa ima najveće dimenzije objekta: govori gdje je objekt, a ne kakva je oblika.",
    }

    /// An ellipse instead of a shadow.
    SHADOW {
        en: "fake: an ellipse",
        it: "finta: un’ellisse",
        cs: "pseudostín: elipsa",
        hr: "lažna sjena: elipsa",
    }
}

const LIGHT: Ask<DVec4> = light([6.0, 7.0, -3.0, 0.0]);
/// Near the ground, over which it hovers as high as this share of its radius.
const HEIGHT: f64 = 0.6;

/// The object a little above the ground, where a fake shadow serves best; no coordinates are shown here.
fn lowered(mut object: NamedMesh) -> NamedMesh {
    if let Some([low, high]) = object.mesh.bounds() {
        let down = low.y - HEIGHT * 0.5 * (high - low).length();
        for p in &mut object.mesh.positions {
            p.y -= down;
        }
    }
    object
}

/// Corners that stand for the ellipse.
const CORNERS: u32 = 72;

/// Leads out of the shadow, to the lower right.
fn name_ellipse(sheet: &mut Sheet, rim: &[DVec2], shadow: &[DVec2], words: &str) {
    let out = DVec2::new(0.8, 0.6);
    let outermost = rim
        .iter()
        .copied()
        .max_by(|a, b| a.dot(out).total_cmp(&b.dot(out)));
    let Some(start) = outermost else { return };
    let beyond = shadow
        .iter()
        .map(|p| p.dot(out))
        .fold(start.dot(out), f64::max);
    let end = start + out * (beyond - start.dot(out) + 26.0);
    sheet.line(start, end, Pen::new(Role::Chosen, THIN));
    let label = Label::new(end, words).reach(2.0).towards(DVec2::X);
    sheet.label(label.beside().ink(Role::Chosen));
}
