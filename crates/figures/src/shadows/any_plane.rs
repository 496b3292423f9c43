//! A cube's shadow on a slanted wall.

use ombra_math::glam::{DVec2, DVec3, DVec4};
use ombra_math::plane::Plane;
use ombra_math::solids::slide_cube;

use super::scene::{Scene, draw_normal, on_sheet};
use crate::colour::Role;
use crate::figure::{Figure, Takes, Words};
use crate::labels::Key;
use crate::marks;
use crate::number::{coordinates, equation};
use crate::sheet::Label;
use crate::space::{axes, mesh};
use crate::text::{LABEL, Line};

/// The lectures' cube, a light at a place, and a wall that leans back and aside (Bologna, Ombre su piani, caso
/// generale; Olomouc, Projekce na libovolnou plochu).
pub(super) const FIGURE: Figure = Figure {
    id: "shadows/planar-any-plane",
    takes: Takes {
        light: true,
        plane: true,
        mesh: true,
    },
    words: |inputs| Words {
        summary: match (inputs.is_cube(), inputs.plane) {
            (true, None) => Key::ANY_PLANE_SUMMARY,
            (false, None) => Key::OBJECT_ON_WALL_SUMMARY,
            (true, Some(_)) => Key::CUBE_ON_PLANE_SUMMARY,
            (false, Some(_)) => Key::OBJECT_ON_PLANE_SUMMARY,
        },
        caption: Key::ANY_PLANE_CAPTION,
    },
    drawn: |sheet, inputs| {
        let wall = Plane {
            normal: DVec3::new(0.0, 1.0, 2.0),
            d: 20.0,
        };
        let light = DVec4::new(10.0, 60.0, 50.0, 1.0);
        let scene = Scene::new(inputs, slide_cube, light, wall)?;
        let stage = scene.stage(sheet.frame(), &beyond(&scene))?;
        let view = &stage.view;

        // A wall between the eye and the object is drawn over it, see-through.
        let before = stage.hides(&scene);
        if before {
            mesh(sheet, view, &scene.mesh, Role::Occluder);
            stage.patch.draw_glass(sheet, view);
        } else {
            stage.patch.draw(sheet, view);
        }
        scene.draw_shadow(sheet, &stage);
        scene.draw_edges_in_shadow(sheet, &stage);
        axes(sheet, view, stage.patch.axis());
        scene.draw_rays(sheet, view);
        if !before {
            mesh(sheet, view, &scene.mesh, Role::Occluder);
        }
        let foot = stage.normal_foot(&scene);
        draw_normal(sheet, view, scene.plane, foot, scene.normal_length());
        let words = equation(scene.plane);
        let line = Line::new(&words, LABEL)?;
        let size = DVec2::new(line.width, line.ascent + line.descent);
        if let Some((at, out)) = stage.free_edge(&scene, &[foot], size, sheet.frame()) {
            sheet.label(Label::new(at, words).towards(out));
        }
        scene.draw_light(sheet, view);
        if let Some(&(_, v, p)) = scene.outermost(view).first() {
            for (point, name, role) in [(v, "V", Role::Occluder), (p, "P", Role::Shadow)] {
                if let Some(at) = on_sheet(sheet, view, point) {
                    marks::point(sheet, at, role);
                    sheet.label(Label::new(at, format!("*{name}* {}", coordinates(point))));
                }
            }
        }
        Ok(())
    },
};

/// Points that make the wall larger than the shadow, so that it reads as a wall and has room for its normal.
fn beyond(scene: &Scene) -> Vec<DVec3> {
    let shadow: Vec<DVec3> = scene.casts.iter().copied().flatten().collect();
    let middle = shadow.iter().sum::<DVec3>() / shadow.len().max(1) as f64;
    shadow
        .into_iter()
        .map(|p| middle + (p - middle) * 1.3)
        .collect()
}
