//! What the figures in space share: an object, a light, a plane, and the object's shadow on it.

use std::sync::Arc;

use ombra_math::glam::{DVec2, DVec3, DVec4};
use ombra_math::mesh::Mesh;
use ombra_math::plane::Plane;
use ombra_shadows::planar::cast;

use super::cube::SHADOW;
use super::cut::on_lights_side;
use super::stage::Stage;
use crate::colour::{Ink, Role};
use crate::drawing::{Pen, THIN};
use crate::error::FigureError;
use crate::input::{Ask, Inputs};
use crate::marks;
use crate::number::{as_typed, coordinates};
use crate::object::{LABELLED, NamedMesh};
use crate::path::{Path, Rect};
use crate::sheet::{Label, Sheet};
use crate::solid::sight::Sight;
use crate::solid::{self};
use crate::space::View;
use crate::style::Language;
use crate::words::{self, words};

/// The object of all figures that show one.
pub(super) const OBJECT: Ask<Arc<NamedMesh>> = Ask::object("mesh", "", words::OBJECT, "cube");
/// The plane of those whose lecture has the ground.
pub(super) const GROUND: Ask<Plane> = Ask::plane("plane", "", words::PLANE, [0.0, 1.0, 0.0, 0.0]);

/// How the eye is turned around the y axis from where it usually is, and raised above the ground, in degrees.
const CAMERA: [f64; 2] = [0.0, 26.0];
pub(super) const TURN: Ask<f64> = Ask::number("turn", "", TURN_WORD, CAMERA[0], [-180.0, 180.0]);
pub(super) const ABOVE: Ask<f64> = Ask::number("above", "", ABOVE_WORD, CAMERA[1], [2.0, 85.0]);

words! {
    /// An input.
    TURN_WORD {
        en: "degrees by which the eye is turned around the *y* axis",
        it: "gradi di cui l’osservatore ruota intorno all’asse *y*",
        cs: "stupně, o které je pozorovatel otočen kolem osy *y*",
        hr: "stupnjevi za koje je oko okrenuto oko osi *y*",
    }

    /// An input.
    ABOVE_WORD {
        en: "degrees by which the eye looks down",
        it: "gradi di cui l’osservatore guarda dall’alto",
        cs: "stupně, pod kterými se pozorovatel dívá shora",
        hr: "stupnjevi pod kojima oko gleda odozgo",
    }

    /// Below a figure of an object that reaches behind the plane or the light.
    CUT {
        en: "What lies behind the plane or the light casts no shadow; what lies behind the plane is cut away.",
        it: "Ciò che sta dietro il piano o la luce non fa ombra; ciò che sta dietro il piano è tagliato via.",
        cs: "Co leží za rovinou nebo za zdrojem, stín nevrhá; co leží za rovinou, je odříznuto.",
        hr: "Što leži iza ravnine ili izvora ne baca sjenu; što leži iza ravnine odrezano je.",
    }
}

/// The light of a figure.
pub(super) const fn light(default: [f64; 4]) -> Ask<DVec4> {
    Ask::light("light", "", words::LIGHT, default)
}

/// What is to be said of the object.
pub(super) fn of_object(inputs: &Inputs, language: Language) -> Option<String> {
    let words = solid::notes(inputs.get(&OBJECT).as_ref()).into_iter();
    let said: Vec<&str> = words.map(|word| word.text(language)).collect();
    (!said.is_empty()).then(|| said.join(" "))
}

/// What is to be said of an object of which a part has no shadow.
pub(super) fn of_cut(
    inputs: &Inputs,
    (light, plane): (DVec4, Plane),
    language: Language,
) -> Option<&'static str> {
    let object = inputs.get(&OBJECT);
    let without = |v: &DVec3| cast(plane, light, *v).is_none();
    let cut = object.mesh.positions.iter().any(without);
    cut.then(|| CUT.text(language))
}

/// Whether the object is the lectures' cube.
pub(super) fn is_cube(inputs: &Inputs) -> bool {
    inputs.get(&OBJECT).name == "cube"
}

/// An object, a light and the plane its shadow falls on.
pub(super) struct Setting {
    pub mesh: Mesh,
    /// What of it lies on the light's side of the plane: the part that is drawn.
    pub shown: Mesh,
    /// How far the eye is turned around the y axis from its usual place, and raised, in degrees.
    pub camera: [f64; 2],
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
        let shown = on_lights_side(&mesh, plane, light);
        let [low, high] = shown.bounds().unwrap_or_default();
        Ok(Setting {
            shown,
            camera: CAMERA,
            mesh,
            light,
            plane,
            casts,
            centre: (low + high) * 0.5,
            reach: (high - low).length() * 0.5,
        })
    }

    /// The same seen by the instructor's camera.
    pub fn seen(self, inputs: &Inputs) -> Setting {
        let camera = [inputs.get(&TURN), inputs.get(&ABOVE)];
        Setting { camera, ..self }
    }

    /// Whether its vertices are few enough for rays and names.
    pub fn has_few(&self) -> bool {
        self.mesh.positions.len() <= LABELLED
    }

    /// Length of a normal beside the object.
    pub fn normal_length(&self) -> f64 {
        1.7 * self.reach
    }

    /// From each of the object's lowest vertices to its foot on the plane; none of an object with many.
    pub fn drops(&self) -> Vec<[DVec3; 2]> {
        if !self.has_few() {
            return Vec::new();
        }
        let height = |v: &DVec3| self.plane.signed_distance(*v);
        let heights = self.shown.positions.iter().map(|v| height(v).abs());
        let lowest = heights.fold(f64::INFINITY, f64::min);
        let near = lowest + 1e-9 * self.reach;
        let lowest = self
            .shown
            .positions
            .iter()
            .filter(|v| height(v).abs() <= near);
        let unit = self.plane.normal.normalize_or_zero();
        lowest.map(|&v| [v, v - unit * height(&v)]).collect()
    }

    /// Those lines, which tell how high the object hangs over which place.
    pub fn draw_drops(&self, sheet: &mut Sheet, stage: &Stage, sight: &Sight) {
        let view = &stage.view;
        let drops = self.drops().into_iter();
        for [v, foot] in drops.filter(|[_, foot]| stage.patch.contains(*foot)) {
            for (a, b) in sight.visible(v, foot) {
                if let Some((a, b)) = view.segment(a, b) {
                    sheet.stroke_unmarked(Path::line(a, b), Pen::new(Role::Note, THIN).dotted());
                }
            }
        }
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
    pub fn name_points(&self, sheet: &mut Sheet, view: &View, sight: &Sight) {
        let vertices = self.mesh.positions.iter().enumerate();
        let vertices = vertices
            .filter(|(_, v)| self.shown.positions.contains(v))
            .map(|(i, &v)| (v, format!("*V*_{{{}}}", i + 1)))
            .collect();
        for (points, role, step) in [
            (self.named_shadows(), Role::Shadow, SHADOW),
            (vertices, Role::Occluder, 0),
        ] {
            sheet.step(step);
            let flat: Vec<(DVec2, bool, String)> = points
                .into_iter()
                .filter_map(|(p, name)| Some((on_sheet(sheet, view, p)?, sight.hides(p), name)))
                .collect();
            let middle = flat.iter().map(|(at, ..)| *at).sum::<DVec2>() / flat.len().max(1) as f64;
            for (at, hidden, name) in flat {
                // A hidden point is as faint as the hidden edges that meet there.
                if hidden {
                    marks::hollow_point(sheet, at, Ink::of(role).tint(0.8));
                } else {
                    marks::point(sheet, at, role);
                }
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
    // Shorter where it would leave the sheet.
    let along = plane.normal / plane.normal.abs().max_element();
    let along = along.normalize_or_zero() * length;
    let tips = [1.0, 0.5, 0.25].map(|part| on_sheet(sheet, view, foot + along * part));
    if let (Some(from), Some(to)) = (
        on_sheet(sheet, view, foot),
        tips.into_iter().flatten().next(),
    ) {
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
