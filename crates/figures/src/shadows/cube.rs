//! The slides' cube and its shadow on the ground, every coordinate exact.

use ombra_math::glam::{DVec2, DVec4};

use super::setting::{ABOVE, GROUND, OBJECT, Setting, TURN, is_cube, light, of_cut, of_object};
use super::stage::Stage;
use crate::colour::Role;
use crate::error::FigureError;
use crate::figure::{About, Figure, Takes};
use crate::input::{Ask, Inputs};
use crate::sheet::Sheet;
use crate::solid::{mesh, sight::Sight};
use crate::space::axes;
use crate::style::Language;
use crate::table::Table;
use crate::words::words;

const AT_INFINITY: Ask<DVec4> = light([10.0, 10.0, 10.0, 0.0]);
const AT_A_PLACE: Ask<DVec4> = light([0.0, 100.0, 100.0, 1.0]);

/// Under (10, 10, 10) at infinity (Olomouc, Zdroj v nekonečnu, Příklad).
pub(super) const INFINITY: Figure = Figure {
    id: "shadows/cube-infinity",
    takes: Takes::These(&[
        AT_INFINITY.input,
        GROUND.input,
        OBJECT.input,
        TURN.input,
        ABOVE.input,
    ]),
    words: WORDS,
    about: |inputs, language| about(inputs, language, &AT_INFINITY),
    drawn: |sheet, inputs| draw(sheet, inputs, &AT_INFINITY),
};

/// Under the point (0, 100, 100) (Olomouc, Zdroj světla v bodě, Příklad).
pub(super) const POINT: Figure = Figure {
    id: "shadows/cube-point",
    takes: Takes::These(&[
        AT_A_PLACE.input,
        GROUND.input,
        OBJECT.input,
        TURN.input,
        ABOVE.input,
    ]),
    words: WORDS,
    about: |inputs, language| about(inputs, language, &AT_A_PLACE),
    drawn: |sheet, inputs| draw(sheet, inputs, &AT_A_PLACE),
};

words! {
    /// `shadows/cube-infinity` in lists.
    CUBE_INFINITY_SUMMARY {
        en: "A cube under a light at infinity, its shadow with exact coordinates",
        it: "Un cubo sotto una luce all’infinito, la sua ombra con le coordinate esatte",
        cs: "Krychle a zdroj v nekonečnu, její stín s přesnými souřadnicemi",
        hr: "Kocka i izvor u beskonačnosti, njezina sjena s točnim koordinatama",
    }

    /// `shadows/cube-infinity` below the figure.
    CUBE_INFINITY_CAPTION {
        en: "Light at infinity: every vertex moves along the same direction **L** onto the plane.",
        it: "Luce all’infinito: ogni vertice si sposta lungo la stessa direzione **L** fino al piano.",
        cs: "Zdroj v nekonečnu: každý vrchol se posune týmž směrem **L** do roviny.",
        hr: "Izvor u beskonačnosti: svaki se vrh pomiče istim smjerom **L** do ravnine.",
    }

    /// The same with an instructor's own object.
    OBJECT_INFINITY_SUMMARY {
        en: "An object under a light at infinity and its shadow",
        it: "Un oggetto sotto una luce all’infinito e la sua ombra",
        cs: "Těleso pod zdrojem v nekonečnu a jeho stín",
        hr: "Objekt pod izvorom u beskonačnosti i njegova sjena",
    }

    /// `shadows/cube-point` in lists.
    CUBE_POINT_SUMMARY {
        en: "A cube under a point light, its shadow with exact fractions",
        it: "Un cubo sotto una luce puntiforme, la sua ombra in frazioni esatte",
        cs: "Krychle a zdroj v bodě, její stín v přesných zlomcích",
        hr: "Kocka i točkasti izvor, njezina sjena u točnim razlomcima",
    }

    /// `shadows/cube-point` below the figure.
    CUBE_POINT_CAPTION {
        en: "Light at a place: the rays from **L** spread, so the shadow is larger than the cube.",
        it: "Luce puntiforme: i raggi da **L** divergono, perciò l’ombra è più grande del cubo.",
        cs: "Zdroj v bodě: paprsky z **L** se rozbíhají, stín je proto větší než krychle.",
        hr: "Točkasti izvor: zrake iz **L** se razilaze, pa je sjena veća od kocke.",
    }

    /// The same with an instructor's own object.
    OBJECT_POINT_SUMMARY {
        en: "An object under a point light and its shadow",
        it: "Un oggetto sotto una luce puntiforme e la sua ombra",
        cs: "Těleso pod zdrojem v bodě a jeho stín",
        hr: "Objekt pod točkastim izvorom i njegova sjena",
    }

    /// The same below the figure.
    OBJECT_POINT_CAPTION {
        en: "Light at a place: the rays from **L** spread, so the shadow is larger than the object.",
        it: "Luce puntiforme: i raggi da **L** divergono, perciò l’ombra è più grande dell’oggetto.",
        cs: "Zdroj v bodě: paprsky z **L** se rozbíhají, stín je proto větší než těleso.",
        hr: "Točkasti izvor: zrake iz **L** se razilaze, pa je sjena veća od objekta.",
    }
}

/// By the kind of light and by whether the object is the cube.
fn about(inputs: &Inputs, language: Language, light: &Ask<DVec4>) -> About {
    let at_infinity = inputs.get(light).w == 0.0;
    let (summary, caption) = match (at_infinity, is_cube(inputs)) {
        (true, true) => (CUBE_INFINITY_SUMMARY, CUBE_INFINITY_CAPTION),
        (true, false) => (OBJECT_INFINITY_SUMMARY, CUBE_INFINITY_CAPTION),
        (false, true) => (CUBE_POINT_SUMMARY, CUBE_POINT_CAPTION),
        (false, false) => (OBJECT_POINT_SUMMARY, OBJECT_POINT_CAPTION),
    };
    let cut = of_cut(inputs, (inputs.get(light), inputs.get(&GROUND)), language);
    About::new(language, summary, caption)
        .and(of_object(inputs, language))
        .and(cut)
}

fn draw(sheet: &mut Sheet, inputs: &Inputs, light: &Ask<DVec4>) -> Result<(), FigureError> {
    let object = inputs.get(&OBJECT);
    let setting = Setting::new(&object, inputs.get(light), inputs.get(&GROUND))?.seen(inputs);
    let stage = if setting.has_few() {
        stage_beside_table(sheet, &setting)?
    } else {
        setting.stage(sheet.frame(), &[])?
    };
    let view = &stage.view;
    stage.patch.draw(sheet, view);
    sheet.step(SHADOW);
    setting.draw_shadow(sheet, &stage);
    setting.draw_edges_in_shadow(sheet, &stage);
    sheet.step(0);
    mesh(sheet, view, &setting.shown, Role::Occluder)?;
    let sight = Sight::new(view, &setting.shown);
    setting.draw_drops(sheet, &stage, &sight);
    axes(sheet, view, &sight, stage.patch.axis());
    sheet.step(RAYS);
    setting.draw_rays(sheet, view, &sight);
    sheet.step(LIGHT);
    setting.draw_light(sheet, view, &sight);
    sheet.step(0);
    if setting.has_few() {
        setting.name_points(sheet, view, &sight);
    }
    Ok(())
}

/// The steps that build the figure up, after the object over the plane.
pub(super) const LIGHT: usize = 1;
pub(super) const RAYS: usize = 2;
pub(super) const SHADOW: usize = 3;

/// The coordinates beside the setting or below it, whichever leaves the setting larger.
fn stage_beside_table(sheet: &mut Sheet, setting: &Setting) -> Result<Stage, FigureError> {
    let frame = sheet.frame();
    let lines = setting.shadow_coordinates();
    let beside = Table::new(sheet, &lines, 0.0)?;
    let below = Table::new(sheet, &lines, frame.size().x)?;

    let mut left = frame;
    left.max.x -= beside.size().x + SPACE;
    let mut above = frame;
    above.max.y -= below.size().y + SPACE;
    let stages = (setting.stage(left, &[])?, setting.stage(above, &[])?);

    sheet.step(SHADOW);
    let stage = if stages.0.view.scale() >= stages.1.view.scale() {
        let corner = frame.max - beside.size();
        beside.draw(sheet, corner);
        stages.0
    } else {
        let start = frame.centre().x - 0.5 * below.size().x;
        let corner = DVec2::new(start, frame.max.y - below.size().y);
        below.draw(sheet, corner);
        stages.1
    };
    sheet.step(0);
    Ok(stage)
}

/// Between the setting and the coordinates.
const SPACE: f64 = 24.0;
