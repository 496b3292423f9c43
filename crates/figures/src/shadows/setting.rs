//! What the figures in space share: an object, a light, a plane, and the object's shadow on it.

use std::sync::Arc;

use ombra_math::glam::{DVec2, DVec3, DVec4};
use ombra_math::mesh::Mesh;
use ombra_math::plane::Plane;
use ombra_shadows::planar::cast;

use crate::colour::Role;
use crate::error::FigureError;
use crate::input::{Ask, Inputs};
use crate::marks;
use crate::number::{as_typed, coordinates};
use crate::object::{LABELLED, NamedMesh};
use crate::path::Rect;
use crate::sheet::{Label, Sheet};
use crate::solid;
use crate::space::View;
use crate::style::Language;
use crate::words;

/// The object of all figures that show one.
pub(super) const OBJECT: Ask<Arc<NamedMesh>> = Ask::object("mesh", "", words::OBJECT, "cube");
/// The plane of those whose lecture has the ground.
pub(super) const GROUND: Ask<Plane> = Ask::plane("plane", "", words::PLANE, [0.0, 1.0, 0.0, 0.0]);

/// The light of a figure.
pub(super) const fn light(default: [f64; 4]) -> Ask<DVec4> {
    Ask::light("light", "", words::LIGHT, default)
}

/// What is to be said of the object.
pub(super) fn of_object(inputs: &Inputs, language: Language) -> Option<&'static str> {
    let word = solid::note(&inputs.get(&OBJECT).mesh)?;
    Some(word.text(language))
}

/// Whether the object is the lectures' cube.
pub(super) fn is_cube(inputs: &Inputs) -> bool {
    inputs.get(&OBJECT).name == "cube"
}

/// An object, a light and the plane its shadow falls on.
pub(super) struct Setting {
    pub mesh: Mesh,
    pub light: DVec4,
    pub plane: Plane,
    /// The shadow of every vertex that has one.
    pub casts: Vec<Option<DVec3>>,
    /// The middle of the object's box and its half diagonal.
    pub centre: DVec3,
    pub reach: f64,
}

impl Setting {
    /// # Errors
    ///
    /// [`FigureError::Scene`] when no vertex has a shadow.
    pub fn new(object: &NamedMesh, light: DVec4, plane: Plane) -> Result<Setting, FigureError> {
        let mesh = object.mesh.clone();
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
                    object.name,
                    as_typed(&plane.coefficients().to_array())
                ),
            });
        }
        let [low, high] = mesh.bounds().unwrap_or_default();
        Ok(Setting {
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
pub(super) fn setting_of(mesh: &str, light: DVec4, plane: Plane) -> Setting {
    Setting::new(&mesh.parse().unwrap(), light, plane).unwrap()
}
