//! What the figures in space share: an object, a light, a plane, and the object's shadow on it.

mod light;
mod shadow;
mod stage;

use ombra_math::glam::{DVec2, DVec3, DVec4};
use ombra_math::mesh::Mesh;
use ombra_math::plane::Plane;
use ombra_shadows::planar::cast;

use self::light::Sun;
pub(super) use self::stage::Stage;
use crate::colour::Role;
use crate::error::FigureError;
use crate::figure::Inputs;
use crate::marks;
use crate::number::{as_typed, coordinates};
use crate::object::LABELLED;
use crate::patch::Patch;
use crate::path::Rect;
use crate::sheet::{Label, Sheet};
use crate::space::View;

/// What lies farther from the object than this many of its radii does not widen the receiver.
const FAR: f64 = 12.0;
/// Room beyond the outermost points, for labels.
const ROOM: DVec2 = DVec2::new(70.0, 34.0);

/// An object, a light and the plane its shadow falls on.
pub(super) struct Scene {
    pub mesh: Mesh,
    pub light: DVec4,
    pub plane: Plane,
    /// The shadow of every vertex that has one.
    pub casts: Vec<Option<DVec3>>,
    centre: DVec3,
    reach: f64,
}

impl Scene {
    /// # Errors
    ///
    /// [`FigureError::Scene`] when no vertex has a shadow.
    pub fn new(
        inputs: &Inputs,
        mesh: fn() -> Mesh,
        light: DVec4,
        plane: Plane,
    ) -> Result<Scene, FigureError> {
        let mesh = inputs
            .mesh
            .as_ref()
            .map_or_else(mesh, |named| named.mesh.clone());
        let light = inputs.light.unwrap_or(light);
        let plane = inputs.plane.unwrap_or(plane);
        let casts: Vec<Option<DVec3>> = mesh
            .positions
            .iter()
            .map(|&v| cast(plane, light, v))
            .collect();
        if casts.iter().all(Option::is_none) {
            return Err(FigureError::Scene {
                reason: format!(
                    "the light {} casts no shadow of {} on the plane {}: the object must lie between them (--light, --plane)",
                    as_typed(&light.to_array()),
                    inputs.mesh.as_ref().map_or("the cube", |named| &named.name),
                    as_typed(&plane.coefficients().to_array())
                ),
            });
        }
        let [low, high] = mesh.bounds().unwrap_or_default();
        Ok(Scene {
            mesh,
            light,
            plane,
            casts,
            centre: (low + high) * 0.5,
            reach: (high - low).length() * 0.5,
        })
    }

    /// Whether its vertices are few enough for rays and names.
    pub fn has_few(&self) -> bool {
        self.mesh.positions.len() <= LABELLED
    }

    /// Length of a normal beside the object.
    pub fn normal_length(&self) -> f64 {
        1.7 * self.reach
    }

    /// Its view in `frame`, with room for `also`, which lies on the plane.
    ///
    /// # Errors
    ///
    /// Those of [`Patch::around`] and [`View::fit`].
    pub fn stage(&self, mut frame: Rect, also: &[DVec3]) -> Result<Stage, FigureError> {
        // A shadow that runs far away is shown as far as the receiver is: what lies near sets the receiver's size.
        let near = |p: &DVec3| p.distance(self.centre) <= FAR * self.reach;
        let shadow = self.casts.iter().copied().flatten();
        let mut on_plane: Vec<DVec3> = shadow.clone().filter(near).collect();
        if on_plane.is_empty() {
            on_plane = shadow.collect();
        }
        on_plane.extend(also.iter().copied().filter(near));
        if self.plane.d == 0.0 && near(&DVec3::ZERO) {
            on_plane.push(DVec3::ZERO);
        }
        let patch = Patch::around(self.plane, &on_plane)?;

        let mut shown = self.mesh.positions.clone();
        shown.extend(patch.corners());
        if near(&DVec3::ZERO) {
            let tips = DVec3::AXES.map(|axis| axis * patch.axis());
            shown.push(DVec3::ZERO);
            shown.extend(tips);
        }
        frame.min += ROOM;
        frame.max -= ROOM;
        match self.sun() {
            Sun::Far(arrow) => shown.extend(arrow),
            Sun::Near(at) => {
                shown.push(at);
                frame.min.y += marks::SUN;
            }
        }
        let view = View::fit(&shown, frame)?;
        Ok(Stage { view, patch })
    }

    /// The shadows' points, each once, with the names of all vertices that have it: *P*_1 = *P*_7.
    fn named_shadows(&self) -> Vec<(DVec3, String)> {
        let mut named: Vec<(DVec3, String)> = Vec::new();
        for (i, p) in self.casts.iter().enumerate() {
            let Some(p) = *p else { continue };
            let name = format!("*P*_{{{}}}", i + 1);
            match named.iter_mut().find(|(q, _)| *q == p) {
                Some((_, names)) => *names = format!("{names} = {name}"),
                None => named.push((p, name)),
            }
        }
        named
    }

    /// The shadows' points by name with exact coordinates, a line each.
    pub fn shadow_coordinates(&self) -> Vec<String> {
        let line = |(p, names): (DVec3, String)| format!("{names} {}", coordinates(p));
        self.named_shadows().into_iter().map(line).collect()
    }

    /// V₁ … on the object, P₁ … on the plane, on the outer side where they can.
    pub fn name_points(&self, sheet: &mut Sheet, view: &View) {
        let vertices = self.mesh.positions.iter().enumerate();
        let vertices = vertices
            .map(|(i, &v)| (v, format!("*V*_{{{}}}", i + 1)))
            .collect();
        for (points, role) in [
            (self.named_shadows(), Role::Shadow),
            (vertices, Role::Occluder),
        ] {
            let flat: Vec<(DVec2, String)> = points
                .into_iter()
                .filter_map(|(p, name)| Some((on_sheet(sheet, view, p)?, name)))
                .collect();
            let middle = flat.iter().map(|(at, _)| *at).sum::<DVec2>() / flat.len().max(1) as f64;
            for (at, name) in flat {
                marks::point(sheet, at, role);
                // The coordinates stand elsewhere, so a name may be missing where points crowd.
                let label = Label::new(at, name).towards(at - middle);
                sheet.label(label.optional());
            }
        }
    }
}

/// Where a point appears, unless it is off the sheet: a shadow may run far away.
pub(super) fn on_sheet(sheet: &Sheet, view: &View, p: DVec3) -> Option<DVec2> {
    let at = view.project(p)?;
    sheet.frame().contains(&Rect::new(at, at)).then_some(at)
}

/// A normal of the plane, drawn from `foot` on, `length` long in space.
pub(super) fn draw_normal(sheet: &mut Sheet, view: &View, plane: Plane, foot: DVec3, length: f64) {
    let tip = foot + plane.normal.normalize_or_zero() * length;
    if let (Some(from), Some(to)) = (view.project(foot), view.project(tip)) {
        marks::normal(sheet, from, to);
        marks::point(sheet, from, Role::Normal);
        let label = Label::new(to, "**n**").towards(to - from).ink(Role::Normal);
        sheet.label(label.beside());
    }
}

#[cfg(test)]
fn scene_of(mesh: &str, light: DVec4, plane: Plane) -> Scene {
    let inputs = Inputs {
        mesh: Some(mesh.parse().unwrap()),
        ..Inputs::default()
    };
    Scene::new(&inputs, ombra_math::solids::slide_cube, light, plane).unwrap()
}
