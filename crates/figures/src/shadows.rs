//! Figures of the shadows lecture.

use ombra_math::glam::{DVec2, DVec3, DVec4};
use ombra_math::mesh::Mesh;
use ombra_math::plane::Plane;
use ombra_shadows::planar::{cast, cast_onto};

use crate::colour::Role;
use crate::drawing::{Pen, THIN};
use crate::error::FigureError;
use crate::figure::{Figure, Inputs, Takes};
use crate::labels::Key;
use crate::marks;
use crate::number::{coordinates, exact};
use crate::object::LABELLED;
use crate::path::Path;
use crate::sheet::{Label, Sheet};
use crate::space::{Patch, View, axes, mesh as draw_mesh};

/// The slides' cube under (10, 10, 10) at infinity (Olomouc, Zdroj v nekonečnu, Příklad).
pub(crate) const CUBE_INFINITY: Figure = Figure {
    id: "shadows/cube-infinity",
    takes: Takes {
        light: true,
        plane: true,
        mesh: true,
    },
    summary: Key::CubeInfinitySummary,
    caption: Key::CubeInfinityCaption,
    drawn: |sheet, inputs| {
        let light = inputs.light.unwrap_or(DVec4::new(10.0, 10.0, 10.0, 0.0));
        Scene::new(inputs, light, Plane::GROUND).draw(sheet)
    },
};

/// What lies farther from the object than this many of its radii does not widen the ground.
const FAR: f64 = 12.0;

/// An object, the light and the plane its shadow falls on.
struct Scene {
    mesh: Mesh,
    light: DVec4,
    plane: Plane,
}

impl Scene {
    fn new(inputs: &Inputs, light: DVec4, plane: Plane) -> Scene {
        Scene {
            mesh: inputs
                .mesh
                .as_ref()
                .map_or_else(ombra_math::solids::slide_cube, |named| named.mesh.clone()),
            light,
            plane: inputs.plane.unwrap_or(plane),
        }
    }

    fn draw(&self, sheet: &mut Sheet) -> Result<(), FigureError> {
        let Scene { mesh, light, plane } = self;
        let casts: Vec<Option<DVec3>> = mesh
            .positions
            .iter()
            .map(|&v| cast(*plane, *light, v))
            .collect();
        let shadow: Vec<DVec3> = casts.iter().copied().flatten().collect();
        if shadow.is_empty() {
            return Err(FigureError::Scene {
                reason: format!(
                    "--light {light} casts no shadow of the object on the plane {}: the object must lie between them",
                    plane.coefficients()
                ),
            });
        }

        let [low, high] = mesh.bounds().unwrap_or_default();
        let (centre, reach) = ((low + high) * 0.5, (high - low).length() * 0.5);
        // A shadow that runs far away is shown as far as the ground is: what lies near sets the ground's size.
        let near = |p: &DVec3| p.distance(centre) <= FAR * reach;
        let mut on_plane: Vec<DVec3> = shadow.iter().copied().filter(near).collect();
        if on_plane.is_empty() {
            on_plane.clone_from(&shadow);
        }
        if plane.d == 0.0 && near(&DVec3::ZERO) {
            on_plane.push(DVec3::ZERO);
        }
        let patch = Patch::around(*plane, &on_plane)?;

        let towards = self.towards_light(centre);
        let arrows: Vec<DVec3> = [1.5, 3.2].map(|k| centre + towards * (reach * k)).to_vec();
        let mut shown = mesh.positions.clone();
        shown.push(DVec3::ZERO);
        shown.extend(patch.corners());
        if light.w == 0.0 {
            shown.extend(&arrows);
        } else {
            shown.push(light.truncate() / light.w);
        }
        let mut frame = sheet.frame();
        // Room for labels beyond the outermost points.
        frame.min += DVec2::new(150.0, 30.0);
        frame.max -= DVec2::new(150.0, 30.0);
        let view = View::fit(&shown, frame)?;

        patch.draw(sheet, &view);
        self.draw_shadow(sheet, &view, &patch);
        axes(sheet, &view, patch.step());

        let few = mesh.positions.len() <= LABELLED;
        if few {
            self.draw_rays(sheet, &view, &casts);
        }
        draw_mesh(sheet, &view, mesh, Role::Occluder);
        self.draw_light(sheet, &view, &arrows);
        if few {
            self.name_points(sheet, &view, &casts);
        }
        Ok(())
    }

    fn towards_light(&self, from: DVec3) -> DVec3 {
        let to = if self.light.w == 0.0 {
            self.light.truncate()
        } else {
            self.light.truncate() / self.light.w - from
        };
        to.normalize_or_zero()
    }

    /// The shadow of every triangle in one path, all of one winding, so that no seam shows.
    fn draw_shadow(&self, sheet: &mut Sheet, view: &View, patch: &Patch) {
        let receiver = patch.corners();
        let mut path = Path::new();
        for i in 0..self.mesh.triangles.len() {
            let corners = self.mesh.triangle(i).unwrap_or_default();
            let Some(mut piece) = view.contour(&cast_onto(&receiver, self.light, &corners)) else {
                continue;
            };
            if signed_area(&piece) < 0.0 {
                piece.reverse();
            }
            path.add_polygon(&piece);
        }
        // The outline goes below the area, so that only the outer half of it is left: edges inside do not show.
        sheet.stroke(path.clone(), Pen::new(Role::Shadow, 2.0 * THIN));
        sheet.fill(path, Role::Umbra);
    }

    /// From each vertex on to its shadow; where two vertices share a ray, the longer one is drawn once.
    fn draw_rays(&self, sheet: &mut Sheet, view: &View, casts: &[Option<DVec3>]) {
        let mut rays: Vec<(DVec3, DVec3)> = Vec::new();
        for (&v, p) in self.mesh.positions.iter().zip(casts) {
            let Some(p) = *p else { continue };
            match rays.iter_mut().find(|(_, q)| *q == p) {
                Some((from, _)) if from.distance(p) < v.distance(p) => *from = v,
                Some(_) => {}
                None => rays.push((v, p)),
            }
        }
        for (v, p) in rays {
            if let Some((from, to)) = view.segment(v, p) {
                marks::stopped_ray(sheet, from, to);
            }
        }
    }

    /// V₁ … on the object, P₁ … with exact coordinates on the plane; shadows that coincide share a label.
    fn name_points(&self, sheet: &mut Sheet, view: &View, casts: &[Option<DVec3>]) {
        let flat = |points: &[DVec3]| -> Vec<DVec2> {
            points.iter().filter_map(|&p| view.project(p)).collect()
        };
        let middle = |points: &[DVec2]| points.iter().sum::<DVec2>() / points.len().max(1) as f64;

        let mut groups: Vec<(DVec3, String)> = Vec::new();
        for (i, p) in casts.iter().enumerate() {
            let Some(p) = *p else { continue };
            let name = format!("*P*_{{{}}}", i + 1);
            match groups.iter_mut().find(|(q, _)| *q == p) {
                Some((_, names)) => *names = format!("{names} = {name}"),
                None => groups.push((p, name)),
            }
        }
        let shadow: Vec<DVec3> = groups.iter().map(|(p, _)| *p).collect();
        let centre = middle(&flat(&shadow));
        for (p, names) in &groups {
            if let Some(at) = view.project(*p) {
                marks::point(sheet, at, Role::Shadow);
                let label = Label::new(at, format!("{names} {}", coordinates(*p)));
                sheet.label(label.towards(at - centre));
            }
        }
        let centre = middle(&flat(&self.mesh.positions));
        for (i, &v) in self.mesh.positions.iter().enumerate() {
            if let Some(at) = view.project(v) {
                marks::point(sheet, at, Role::Occluder);
                sheet.label(Label::new(at, format!("*V*_{{{}}}", i + 1)).towards(at - centre));
            }
        }
    }

    fn draw_light(&self, sheet: &mut Sheet, view: &View, arrows: &[DVec3]) {
        let l = self.light;
        let name = format!(
            "**L** = ({}, {}, {}, {})",
            exact(l.x),
            exact(l.y),
            exact(l.z),
            exact(l.w)
        );
        if l.w == 0.0 {
            if let [Some(near), Some(far)] =
                [0, 1].map(|i| arrows.get(i).and_then(|&p| view.project(p)))
            {
                let aside = (far - near).normalize_or_zero().perp() * 34.0;
                let above = if aside.y > 0.0 { -aside } else { aside };
                let bundle: Vec<_> = [-1.0, 0.0, 1.0]
                    .map(|k| (far + above * k, near + above * k))
                    .to_vec();
                marks::bundle(sheet, &bundle);
                let middle = (far + near) * 0.5 + above;
                sheet.label(Label::new(middle, name).towards(above));
            }
        } else if let Some(at) = view.project(l.truncate() / l.w) {
            marks::sun(sheet, at);
            sheet.label(Label::new(at, name).reach(marks::SUN + 6.0));
        }
    }
}

/// Twice the area of a contour, negative when it runs the other way round.
fn signed_area(contour: &[DVec2]) -> f64 {
    let next = contour.iter().cycle().skip(1);
    contour.iter().zip(next).map(|(a, b)| a.perp_dot(*b)).sum()
}
