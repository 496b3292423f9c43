//! The view of a setting, and free places in it.

use ombra_math::glam::{DVec2, DVec3};

use super::light::Sun;
use super::setting::Setting;
use crate::error::FigureError;
use crate::marks;
use crate::patch::Patch;
use crate::path::Rect;
use crate::space::View;

/// From an edge of the receiver to a label beyond it.
const BEYOND: f64 = 24.0;

/// What lies farther from the object than this many of its radii does not widen the receiver.
const FAR: f64 = 12.0;
/// Room beyond the outermost points, for labels.
const ROOM: DVec2 = DVec2::new(70.0, 34.0);

/// The view of a setting and the piece of the plane that is shown.
pub(super) struct Stage {
    pub view: View,
    pub patch: Patch,
}

impl Setting {
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
}

impl Stage {
    /// Whether the plane stands between the eye and the object.
    pub fn hides(&self, setting: &Setting) -> bool {
        let distance = |p| setting.plane.signed_distance(p);
        distance(self.view.eye()) * distance(setting.centre) < 0.0
    }

    /// A place on the plane for its normal: that corner of the patch at which the arrow is farthest from shadow and
    /// object.
    pub fn normal_foot(&self, setting: &Setting) -> DVec3 {
        let shadow: Vec<DVec2> = setting
            .casts
            .iter()
            .filter_map(|p| self.view.project((*p)?))
            .collect();
        let object = setting.mesh.positions.iter();
        let object = object.filter_map(|&v| self.view.project(v));
        let taken: Vec<DVec2> = shadow.into_iter().chain(object).collect();
        let along = setting.plane.normal.normalize_or_zero() * setting.normal_length();
        let clearance = |foot: &DVec3| {
            let arrow = [0.0, 0.5, 1.0].map(|part| self.view.project(*foot + along * part));
            let places = arrow.into_iter().flatten();
            let distances = places.flat_map(|at| taken.iter().map(move |q| q.distance_squared(at)));
            distances.fold(f64::INFINITY, f64::min)
        };
        self.patch
            .corner_cells()
            .into_iter()
            .max_by(|a, b| clearance(a).total_cmp(&clearance(b)))
            .unwrap_or_default()
    }

    /// The middle of that edge of the patch beyond which a label of `size` lies in `frame` and farthest from `taken` and
    /// all that the setting draws, and the direction out of the patch there.
    pub fn free_edge(
        &self,
        setting: &Setting,
        taken: &[DVec3],
        size: DVec2,
        frame: Rect,
    ) -> Option<(DVec2, DVec2)> {
        let corners = self.view.contour(&self.patch.corners())?;
        let middle = corners.iter().sum::<DVec2>() / corners.len() as f64;
        let object = setting.mesh.positions.iter().copied();
        let shadow = setting.casts.iter().copied().flatten();
        let axes = DVec3::AXES.map(|axis| axis * self.patch.axis());
        let mut taken: Vec<DVec3> = taken.iter().copied().chain(axes).collect();
        taken.extend(object.chain(shadow));
        if let Sun::Near(at) = setting.sun() {
            // Along the rays, too.
            taken.extend([0.25, 0.5, 0.75, 1.0].map(|part| setting.centre.lerp(at, part)));
        }
        let taken: Vec<DVec2> = taken.iter().filter_map(|&p| self.view.project(p)).collect();
        let edges = corners.iter().zip(corners.iter().cycle().skip(1));
        let room = |&(at, out): &(DVec2, DVec2)| {
            let label = at + out * BEYOND + out * 0.5 * size;
            let bounds = Rect::new(label - 0.5 * size, label + 0.5 * size);
            let from = |p: &DVec2| p.distance_squared(p.clamp(bounds.min, bounds.max));
            match frame.contains(&bounds) {
                true => taken.iter().map(from).fold(f64::INFINITY, f64::min),
                false => -1.0,
            }
        };
        edges
            .map(|(&a, &b)| (a.midpoint(b), (b - a).perp().normalize_or_zero()))
            .map(|(at, out)| {
                (
                    at,
                    if out.dot(at - middle) < 0.0 {
                        -out
                    } else {
                        out
                    },
                )
            })
            .max_by(|a, b| room(a).total_cmp(&room(b)))
    }
}
