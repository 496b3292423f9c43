//! The view of a scene, and free places in it.

use ombra_math::glam::{DVec2, DVec3};

use super::Scene;
use super::light::Sun;
use crate::patch::Patch;
use crate::path::Rect;
use crate::space::View;

/// From an edge of the receiver to a label beyond it.
const BEYOND: f64 = 24.0;

/// The view of a scene and the piece of the plane that is shown.
pub(in crate::shadows) struct Stage {
    pub view: View,
    pub patch: Patch,
}

impl Stage {
    /// Whether the plane stands between the eye and the object.
    pub fn hides(&self, scene: &Scene) -> bool {
        let distance = |p| scene.plane.signed_distance(p);
        distance(self.view.eye()) * distance(scene.centre) < 0.0
    }

    /// A place on the plane for its normal: that corner of the patch at which the arrow is farthest from shadow and
    /// object.
    pub fn normal_foot(&self, scene: &Scene) -> DVec3 {
        let shadow: Vec<DVec2> = scene
            .casts
            .iter()
            .filter_map(|p| self.view.project((*p)?))
            .collect();
        let object = scene.mesh.positions.iter();
        let object = object.filter_map(|&v| self.view.project(v));
        let taken: Vec<DVec2> = shadow.into_iter().chain(object).collect();
        let along = scene.plane.normal.normalize_or_zero() * scene.normal_length();
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
    /// all that the scene draws, and the direction out of the patch there.
    pub fn free_edge(
        &self,
        scene: &Scene,
        taken: &[DVec3],
        size: DVec2,
        frame: Rect,
    ) -> Option<(DVec2, DVec2)> {
        let corners = self.view.contour(&self.patch.corners())?;
        let middle = corners.iter().sum::<DVec2>() / corners.len() as f64;
        let object = scene.mesh.positions.iter().copied();
        let shadow = scene.casts.iter().copied().flatten();
        let axes = DVec3::AXES.map(|axis| axis * self.patch.axis());
        let mut taken: Vec<DVec3> = taken.iter().copied().chain(axes).collect();
        taken.extend(object.chain(shadow));
        if let Sun::Near(at) = scene.sun() {
            // Along the rays, too.
            taken.extend([0.25, 0.5, 0.75, 1.0].map(|part| scene.centre.lerp(at, part)));
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
