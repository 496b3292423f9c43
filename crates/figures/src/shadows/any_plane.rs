//! A cube's shadow on a slanted wall.

use ombra_math::glam::{DVec2, DVec3, DVec4};
use ombra_math::plane::Plane;

use super::cube::{LIGHT as LIGHT_STEP, RAYS, SHADOW};
use super::setting::{
    ABOVE, OBJECT, Setting, TURN, draw_normal, is_cube, light, of_cut, of_object, on_sheet,
};
use crate::colour::Role;
use crate::figure::{About, Figure, Takes};
use crate::input::Ask;
use crate::marks;
use crate::number::{coordinates, equation};
use crate::sheet::Label;
use crate::solid::{mesh, sight::Sight};
use crate::space::axes;
use crate::text::LABEL;
use crate::words::{self, words};

const LIGHT: Ask<DVec4> = light([10.0, 60.0, 50.0, 1.0]);
const WALL: Ask<Plane> = Ask::plane("plane", "", words::PLANE, [0.0, 1.0, 2.0, 20.0]);

/// The lectures' cube, a light at a place, and a wall that leans back and aside (Bologna, Ombre su piani, caso
/// generale; Olomouc, Projekce na libovolnou plochu).
pub(super) const FIGURE: Figure = Figure {
    id: "shadows/planar-any-plane",
    takes: Takes::These(&[
        LIGHT.input,
        WALL.input,
        OBJECT.input,
        TURN.input,
        ABOVE.input,
    ]),
    words: WORDS,
    about: |inputs, language| {
        let summary = match (is_cube(inputs), inputs.has(&WALL)) {
            (true, false) => ANY_PLANE_SUMMARY,
            (false, false) => OBJECT_ON_WALL_SUMMARY,
            (true, true) => CUBE_ON_PLANE_SUMMARY,
            (false, true) => OBJECT_ON_PLANE_SUMMARY,
        };
        let cut = of_cut(inputs, (inputs.get(&LIGHT), inputs.get(&WALL)), language);
        About::new(language, summary, ANY_PLANE_CAPTION)
            .and(of_object(inputs, language))
            .and(cut)
    },
    drawn: |sheet, inputs| {
        let object = inputs.get(&OBJECT);
        let setting = Setting::new(&object, inputs.get(&LIGHT), inputs.get(&WALL))?.seen(inputs);
        let stage = setting.stage(sheet.frame(), &beyond(&setting))?;
        let view = &stage.view;

        // A wall between the eye and the object is drawn over it, see-through.
        let before = stage.hides(&setting);
        if before {
            mesh(sheet, view, &setting.shown, Role::Occluder)?;
            stage.patch.draw_glass(sheet, view);
        } else {
            stage.patch.draw_wall(sheet, view);
        }
        sheet.step(SHADOW);
        setting.draw_shadow(sheet, &stage);
        setting.draw_edges_in_shadow(sheet, &stage);
        sheet.step(0);
        if !before {
            mesh(sheet, view, &setting.shown, Role::Occluder)?;
        }
        let sight = Sight::new(view, &setting.shown);
        axes(sheet, view, &sight, stage.patch.axis());
        sheet.step(RAYS);
        setting.draw_rays(sheet, view, &sight);
        sheet.step(0);
        let foot = stage.normal_foot(&setting);
        draw_normal(sheet, view, setting.plane, foot, setting.normal_length());
        let words = equation(setting.plane);
        let line = sheet.lay_out(&words, LABEL)?;
        let size = DVec2::new(line.width, line.ascent + line.descent);
        if let Some((at, out)) = stage.free_edge(&setting, &[foot], size, sheet.frame()) {
            sheet.label(Label::new(at, words).towards(out));
        }
        sheet.step(LIGHT_STEP);
        setting.draw_light(sheet, view, &sight);
        if let Some(&(_, v, p)) = setting.outermost(view).first() {
            for (point, name, role, step) in
                [(v, "V", Role::Occluder, 0), (p, "P", Role::Shadow, SHADOW)]
            {
                sheet.step(step);
                if let Some(at) = on_sheet(sheet, view, point) {
                    if sight.hides(point) {
                        marks::hollow_point(sheet, at, role);
                    } else {
                        marks::point(sheet, at, role);
                    }
                    sheet.label(Label::new(at, format!("*{name}* {}", coordinates(point))));
                }
            }
        }
        Ok(())
    },
};

words! {
    /// `shadows/planar-any-plane` in lists.
    ANY_PLANE_SUMMARY {
        en: "A cube’s shadow on a slanted wall",
        it: "L’ombra di un cubo su una parete inclinata",
        cs: "Stín krychle na šikmé stěně",
        hr: "Sjena kocke na kosom zidu",
    }

    /// The same with an instructor's own object.
    OBJECT_ON_WALL_SUMMARY {
        en: "An object’s shadow on a slanted wall",
        it: "L’ombra di un oggetto su una parete inclinata",
        cs: "Stín tělesa na šikmé stěně",
        hr: "Sjena objekta na kosom zidu",
    }

    /// The same with an instructor's own plane.
    CUBE_ON_PLANE_SUMMARY {
        en: "A cube’s shadow on a plane",
        it: "L’ombra di un cubo su un piano",
        cs: "Stín krychle v rovině",
        hr: "Sjena kocke na ravnini",
    }

    /// The same with an instructor's own object and plane.
    OBJECT_ON_PLANE_SUMMARY {
        en: "An object’s shadow on a plane",
        it: "L’ombra di un oggetto su un piano",
        cs: "Stín tělesa v rovině",
        hr: "Sjena objekta na ravnini",
    }

    /// `shadows/planar-any-plane` below the figure.
    ANY_PLANE_CAPTION {
        en: "Any plane **n** · *X* + *d* = 0 receives the shadow: every vertex moves along its ray onto it.",
        it: "Ogni piano **n** · *X* + *d* = 0 riceve l’ombra: ogni vertice vi si sposta lungo il suo raggio.",
        cs: "Stín dopadá do libovolné roviny **n** · *X* + *d* = 0: každý vrchol se do ní posune po svém paprsku.",
        hr: "Sjena pada na bilo koju ravninu **n** · *X* + *d* = 0: svaki se vrh po svojoj zraci pomiče na nju.",
    }
}

/// Points that make the wall larger than the shadow, so that it reads as a wall and has room for its normal.
fn beyond(setting: &Setting) -> Vec<DVec3> {
    let shadow: Vec<DVec3> = setting.casts.iter().copied().flatten().collect();
    let middle = shadow.iter().sum::<DVec3>() / shadow.len().max(1) as f64;
    shadow
        .into_iter()
        .map(|p| middle + (p - middle) * 1.3)
        .collect()
}
