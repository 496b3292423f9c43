//! Figures of space: one house perspective and its axes.
//!
//! The eye always looks from the same side (from the left of +z, a little above), so that a student who has read one
//! figure has read the axes of all. What is shown is fitted to the canvas; the distance grows with it, so that the
//! perspective is equally strong in every figure.

use ombra_math::glam::{DVec2, DVec3, DVec4};

use crate::colour::Role;
use crate::drawing::{NORMAL, Pen};
use crate::error::FigureError;
use crate::path::Rect;
use crate::sheet::{Label, Sheet};
use crate::solid::sight::Sight;

/// From the scene towards the eye; its length does not matter.
const TOWARDS_EYE: DVec3 = DVec3::new(-0.50, 0.46, 0.80);
/// Distance of the eye from the middle of the scene, in radii of the scene.
const DISTANCE: f64 = 4.5;
/// The same where perspective is not to show: sizes differ by a millionth at most.
const AFAR: f64 = 1e6;

/// Towards an eye turned `around` the y axis from +z to +x and raised `above` the ground, in degrees.
pub fn towards_eye(around: f64, above: f64) -> DVec3 {
    let (s, c) = libm::sincos(around.to_radians());
    let (up, level) = libm::sincos(above.to_radians());
    DVec3::new(s * level, up, c * level)
}

/// The house perspective, fitted to what a figure shows.
#[derive(Clone, Copy, Debug)]
pub struct View {
    eye: DVec3,
    right: DVec3,
    up: DVec3,
    forward: DVec3,
    radius: f64,
    scale: f64,
    offset: DVec2,
}

impl View {
    /// Fits `shown` into `frame`.
    ///
    /// # Errors
    ///
    /// [`FigureError::Scene`] when `shown` is empty, a single point, or too large to compute with.
    pub fn fit(shown: &[DVec3], frame: Rect) -> Result<View, FigureError> {
        View::fit_from(shown, frame, TOWARDS_EYE, DISTANCE)
    }

    /// The same for an eye in another direction.
    ///
    /// # Errors
    ///
    /// Those of [`View::fit`].
    pub fn fit_towards(shown: &[DVec3], frame: Rect, eye: DVec3) -> Result<View, FigureError> {
        View::fit_from(shown, frame, eye, DISTANCE)
    }

    /// The same from so far away that nothing shrinks with its distance.
    ///
    /// # Errors
    ///
    /// Those of [`View::fit`].
    pub fn fit_from_afar(shown: &[DVec3], frame: Rect) -> Result<View, FigureError> {
        View::fit_from(shown, frame, TOWARDS_EYE, AFAR)
    }

    /// From the scene towards the eye, of length 1.
    pub fn towards_eye() -> DVec3 {
        TOWARDS_EYE.normalize()
    }

    fn fit_from(
        shown: &[DVec3],
        frame: Rect,
        towards_eye: DVec3,
        distance: f64,
    ) -> Result<View, FigureError> {
        let wrong = || {
            FigureError::Scene {
            reason: "nothing to show: the points of the figure are too few, too far or too close together".to_owned(),
        }
        };
        let first = *shown.first().ok_or_else(wrong)?;
        let (min, max) = shown
            .iter()
            .fold((first, first), |(min, max), &p| (min.min(p), max.max(p)));
        let centre = min * 0.5 + max * 0.5;
        let radius = shown.iter().map(|p| p.distance(centre)).fold(0.0, f64::max);
        let forward = -towards_eye.normalize_or(DVec3::Z);
        let right = forward.cross(DVec3::Y).normalize_or(DVec3::X);
        let mut view = View {
            eye: centre - forward * (radius * distance),
            right,
            up: right.cross(forward),
            forward,
            radius,
            scale: 1.0,
            offset: DVec2::ZERO,
        };
        let flat: Vec<DVec2> = shown.iter().filter_map(|&p| view.project(p)).collect();
        let start = *flat.first().ok_or_else(wrong)?;
        let (low, high) = flat
            .iter()
            .fold((start, start), |(low, high), &p| (low.min(p), high.max(p)));
        let ratio = frame.size() / (high - low);
        view.scale = ratio.x.min(ratio.y);
        view.offset = frame.centre() - (low + high) * 0.5 * view.scale;
        let usable =
            radius > 0.0 && radius.is_finite() && view.scale.is_finite() && view.offset.is_finite();
        if usable { Ok(view) } else { Err(wrong()) }
    }

    /// Where a point appears; none for what is not well in front of the eye.
    pub fn project(&self, p: DVec3) -> Option<DVec2> {
        let d = p - self.eye;
        let depth = d.dot(self.forward);
        let at =
            DVec2::new(d.dot(self.right), -d.dot(self.up)) * (self.radius / depth) * self.scale
                + self.offset;
        (depth > 0.1 * self.radius && at.is_finite()).then_some(at)
    }

    /// [`View::project`] as a matrix: of a point with w = 1, the products with the first two rows, each over that with the
    /// third, which is [`View::depth`].
    pub fn rows(&self) -> [DVec4; 3] {
        let row = |v: DVec3| v.extend(-v.dot(self.eye));
        let along = row(self.forward);
        let size = self.radius * self.scale;
        let across = row(self.right) * size + along * self.offset.x;
        let down = row(-self.up) * size + along * self.offset.y;
        [across, down, along]
    }

    /// How large things appear; only views of the same points compare.
    pub fn scale(&self) -> f64 {
        self.scale
    }

    /// Where the eye is.
    pub fn eye(&self) -> DVec3 {
        self.eye
    }

    /// Distance from the eye along the view.
    pub fn depth(&self, p: DVec3) -> f64 {
        (p - self.eye).dot(self.forward)
    }

    /// A contour on the canvas; none if a point of it cannot be seen.
    pub fn contour(&self, points: &[DVec3]) -> Option<Vec<DVec2>> {
        points.iter().map(|&p| self.project(p)).collect()
    }

    /// The part of a segment in front of the eye.
    pub fn segment(&self, a: DVec3, b: DVec3) -> Option<(DVec2, DVec2)> {
        let near = 0.2 * self.radius;
        let (da, db) = (self.depth(a), self.depth(b));
        let cut = |from: DVec3, to: DVec3, d_from: f64, d_to: f64| {
            from + (to - from) * ((near - d_from) / (d_to - d_from))
        };
        let (a, b) = match (da > near, db > near) {
            (true, true) => (a, b),
            (true, false) => (a, cut(b, a, db, da)),
            (false, true) => (cut(a, b, da, db), b),
            (false, false) => return None,
        };
        Some((self.project(a)?, self.project(b)?))
    }
}

/// Three short labelled arrows at the origin, `length` long in space, as far as nothing hides them.
pub fn axes(sheet: &mut Sheet, view: &View, sight: &Sight, length: f64) {
    for (axis, name) in [(DVec3::X, "*x*"), (DVec3::Y, "*y*"), (DVec3::Z, "*z*")] {
        let end = axis * length;
        let pieces = sight.visible(DVec3::ZERO, end);
        for &(a, b) in &pieces {
            let (Some(from), Some(to)) = (view.project(a), view.project(b)) else {
                continue;
            };
            if b == end {
                crate::marks::arrow(sheet, from, to, Role::Axis, NORMAL);
                let label = Label::new(to, name).towards(to - from).ink(Role::Axis);
                // Two are enough to tell the third.
                sheet.label(label.beside().optional());
            } else {
                sheet.line(from, to, Pen::new(Role::Axis, NORMAL));
            }
        }
    }
}
