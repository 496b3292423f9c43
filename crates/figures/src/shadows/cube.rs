//! The slides' cube and its shadow on the ground, every coordinate exact.

use ombra_math::glam::{DVec2, DVec4};
use ombra_math::plane::Plane;
use ombra_math::solids::slide_cube;

use super::scene::{Scene, Stage};
use crate::colour::Role;
use crate::error::FigureError;
use crate::figure::{Figure, Inputs, Takes, Words};
use crate::labels::Key;
use crate::sheet::Sheet;
use crate::space::{axes, mesh};
use crate::table::Table;

const TAKES: Takes = Takes {
    light: true,
    plane: true,
    mesh: true,
};

const AT_INFINITY: DVec4 = DVec4::new(10.0, 10.0, 10.0, 0.0);
const AT_A_PLACE: DVec4 = DVec4::new(0.0, 100.0, 100.0, 1.0);

/// Under (10, 10, 10) at infinity (Olomouc, Zdroj v nekonečnu, Příklad).
pub(super) const INFINITY: Figure = Figure {
    id: "shadows/cube-infinity",
    takes: TAKES,
    words: |inputs| words(inputs, AT_INFINITY),
    drawn: |sheet, inputs| draw(sheet, inputs, AT_INFINITY),
};

/// Under the point (0, 100, 100) (Olomouc, Zdroj světla v bodě, Příklad).
pub(super) const POINT: Figure = Figure {
    id: "shadows/cube-point",
    takes: TAKES,
    words: |inputs| words(inputs, AT_A_PLACE),
    drawn: |sheet, inputs| draw(sheet, inputs, AT_A_PLACE),
};

/// By the kind of light and by whether the object is the cube.
fn words(inputs: &Inputs, light: DVec4) -> Words {
    let at_infinity = inputs.light.unwrap_or(light).w == 0.0;
    let (summary, caption) = match (at_infinity, inputs.is_cube()) {
        (true, true) => (Key::CUBE_INFINITY_SUMMARY, Key::CUBE_INFINITY_CAPTION),
        (true, false) => (Key::OBJECT_INFINITY_SUMMARY, Key::CUBE_INFINITY_CAPTION),
        (false, true) => (Key::CUBE_POINT_SUMMARY, Key::CUBE_POINT_CAPTION),
        (false, false) => (Key::OBJECT_POINT_SUMMARY, Key::OBJECT_POINT_CAPTION),
    };
    Words { summary, caption }
}

fn draw(sheet: &mut Sheet, inputs: &Inputs, light: DVec4) -> Result<(), FigureError> {
    let scene = Scene::new(inputs, slide_cube, light, Plane::GROUND)?;
    let stage = if scene.has_few() {
        stage_beside_table(sheet, &scene)?
    } else {
        scene.stage(sheet.frame(), &[])?
    };
    let view = &stage.view;
    stage.patch.draw(sheet, view);
    scene.draw_shadow(sheet, &stage);
    scene.draw_edges_in_shadow(sheet, &stage);
    axes(sheet, view, stage.patch.axis());
    scene.draw_rays(sheet, view);
    mesh(sheet, view, &scene.mesh, Role::Occluder);
    scene.draw_light(sheet, view);
    if scene.has_few() {
        scene.name_points(sheet, view);
    }
    Ok(())
}

/// The coordinates beside the scene or below it, whichever leaves the scene larger.
fn stage_beside_table(sheet: &mut Sheet, scene: &Scene) -> Result<Stage, FigureError> {
    let frame = sheet.frame();
    let lines = scene.shadow_coordinates();
    let beside = Table::new(&lines, 0.0)?;
    let below = Table::new(&lines, frame.size().x)?;

    let mut left = frame;
    left.max.x -= beside.size().x + SPACE;
    let mut above = frame;
    above.max.y -= below.size().y + SPACE;
    let stages = (scene.stage(left, &[])?, scene.stage(above, &[])?);

    if stages.0.view.scale() >= stages.1.view.scale() {
        let corner = frame.max - beside.size();
        beside.draw(sheet, corner);
        Ok(stages.0)
    } else {
        let start = frame.centre().x - 0.5 * below.size().x;
        let corner = DVec2::new(start, frame.max.y - below.size().y);
        below.draw(sheet, corner);
        Ok(stages.1)
    }
}

/// Between the scene and the coordinates.
const SPACE: f64 = 24.0;
