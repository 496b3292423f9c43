//! The view of a setting, and free places in it.

use ombra_math::glam::{DVec2, DVec3};

use super::light::Sun;
use super::setting::Setting;
use crate::error::FigureError;
use crate::marks;
use crate::number::as_typed;
use crate::patch::Patch;
use crate::path::Rect;
use crate::space::{View, towards_eye};
use crate::text::LABEL;

/// From an edge of the receiver to a label beyond it.
const BEYOND: f64 = 24.0;

/// What lies farther from the object than this many of its radii is not shown: the object would be a dot.
const FAR: f64 = 60.0;
/// The origin is shown, with the axes, within this many radii.
const NEAR: f64 = 12.0;
/// Directions of the eye around the y axis, the house's first.
const AROUND: [f64; 6] = [-32.0, 8.0, -8.0, 32.0, -62.0, 62.0];
/// Another than the house's must show this much more.
const BETTER: f64 = 1.25;
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
        let within = |p: &DVec3, radii: f64| p.distance(self.centre) <= radii * self.reach;
        let shadow = self.casts.iter().copied().flatten();
        let mut on_plane: Vec<DVec3> = shadow.filter(|p| within(p, FAR)).collect();
        if on_plane.is_empty() {
            return Err(FigureError::Scene {
                reason: format!(
                    "the shadow of the object under the light {} lies more than {FAR} times the object's size away on \
                     the plane {} (--light, --plane)",
                    as_typed(&self.light.to_array()),
                    as_typed(&self.plane.coefficients().to_array())
                ),
            });
        }
        let near = |p: &DVec3| within(p, NEAR);
        on_plane.extend(also.iter().copied().filter(|p| within(p, FAR)));
        on_plane.extend(self.drops().into_iter().map(|[_, foot]| foot).filter(near));
        if self.plane.d == 0.0 && near(&DVec3::ZERO) {
            on_plane.push(DVec3::ZERO);
        }
        let patch = Patch::around(self.plane, &on_plane)?;

        let mut shown = self.shown.positions.clone();
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
            Sun::Near(at) | Sun::Broken(at) => {
                shown.push(at);
                frame.min.y += marks::SUN + 1.2 * LABEL;
            }
        }
        let view = self.best_view(&shown, frame)?;
        Ok(Stage { view, patch })
    }

    /// The view from that side on which object, shadow and light lie least over one another.
    fn best_view(&self, shown: &[DVec3], frame: Rect) -> Result<View, FigureError> {
        let [turn, above] = self.camera;
        let mut best: Option<(f64, View)> = None;
        for around in AROUND {
            let view = View::fit_towards(shown, frame, towards_eye(around + turn, above))?;
            let worth = self.worth(&view);
            if best.as_ref().is_none_or(|(most, _)| worth > most * BETTER) {
                best = Some((worth, view));
            }
        }
        match best {
            Some((_, view)) => Ok(view),
            None => View::fit(shown, frame),
        }
    }

    /// How large the object appears, less where it lies over its shadow, and where shadow or light are near to it.
    fn worth(&self, view: &View) -> f64 {
        let object: Vec<DVec2> = self
            .shown
            .positions
            .iter()
            .filter_map(|&p| view.project(p))
            .collect();
        let around = |p: &DVec2| Rect::new(*p, *p);
        let joined = |a: Rect, b: Rect| Rect::new(a.min.min(b.min), a.max.max(b.max));
        let Some(bounds) = object.iter().map(around).reduce(joined) else {
            return 0.0;
        };
        let shadow: Vec<DVec2> = self
            .casts
            .iter()
            .filter_map(|p| view.project((*p)?))
            .collect();
        let over = shadow
            .iter()
            .filter(|&p| bounds.contains(&around(p)))
            .count();
        let free = (1.0 - over as f64 / shadow.len().max(1) as f64).max(0.2);
        // Light and shadow stand out where they are at least as far away as the object is large.
        let size = bounds.size().length();
        let apart = |at: Option<DVec2>| {
            let distance = at.map_or(0.0, |at| at.distance(bounds.centre()));
            (distance / (1.2 * size)).min(1.0)
        };
        let middle = shadow.iter().sum::<DVec2>() / shadow.len().max(1) as f64;
        let sun = view.project(self.sun().place());
        size * free * apart(sun) * apart(Some(middle))
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
        let object = setting.shown.positions.iter();
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
        let object = setting.shown.positions.iter().copied();
        let shadow = setting.casts.iter().copied().flatten();
        let axes = DVec3::AXES.map(|axis| axis * self.patch.axis());
        let mut taken: Vec<DVec3> = taken.iter().copied().chain(axes).collect();
        taken.extend(object.chain(shadow));
        // Along the rays, too.
        let sun = setting.sun().place();
        taken.extend([0.25, 0.5, 0.75, 1.0].map(|part| setting.centre.lerp(sun, part)));
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
