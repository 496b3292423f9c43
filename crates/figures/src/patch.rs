//! The receiver in figures of space: a rectangle of a plane with a grid.

use ombra_math::glam::{DVec2, DVec3};
use ombra_math::plane::Plane;

use crate::colour::{Ink, Role};
use crate::drawing::{Pen, THIN};
use crate::error::FigureError;
use crate::number::{as_typed, round_step};
use crate::path::{Path, Rect};
use crate::sheet::Sheet;
use crate::space::View;

/// A rectangle of a plane with a grid at round distances: the surface that receives shadows.
#[derive(Clone, Copy, Debug)]
pub struct Patch {
    origin: DVec3,
    u: DVec3,
    v: DVec3,
    min: DVec2,
    max: DVec2,
    step: f64,
}

impl Patch {
    /// The least rectangle of whole grid cells of `plane` that holds the feet of `points` and a little more.
    ///
    /// # Errors
    ///
    /// [`FigureError::Scene`] when the plane has no finite normal or there are no finite points.
    pub fn around(plane: Plane, points: &[DVec3]) -> Result<Patch, FigureError> {
        Patch::with_cells(plane, points, None)
    }

    /// The same with cells of a given side; those of [`Patch::around`] are round parts of the whole.
    ///
    /// # Errors
    ///
    /// Those of [`Patch::around`].
    pub fn with_cells(
        plane: Plane,
        points: &[DVec3],
        side: Option<f64>,
    ) -> Result<Patch, FigureError> {
        let wrong = || FigureError::Scene {
            reason: format!(
                "the plane {} has no patch to draw near the object",
                as_typed(&plane.coefficients().to_array())
            ),
        };
        // Any multiple is the same plane: one with ordinary numbers, before lengths are squared.
        let largest = plane.normal.abs().max_element();
        let (normal, d) = (plane.normal / largest, plane.d / largest);
        let n = normal.try_normalize().ok_or_else(wrong)?;
        let origin = -n * (d / normal.length());
        // On the ground along x; on a wall level.
        let u = DVec3::Y
            .cross(n)
            .try_normalize()
            .filter(|_| n.y.abs() < 0.999)
            .unwrap_or(DVec3::X);
        let u = (u - n * u.dot(n)).try_normalize().ok_or_else(wrong)?;
        let v = n.cross(u);
        let flat = |p: &DVec3| DVec2::new((*p - origin).dot(u), (*p - origin).dot(v));
        let first = flat(points.first().ok_or_else(wrong)?);
        let (min, max) = points
            .iter()
            .map(flat)
            .fold((first, first), |(min, max), p| (min.min(p), max.max(p)));
        let step = side.unwrap_or_else(|| round_step((max - min).max_element() / 9.0));
        let margin = DVec2::splat(0.3 * step);
        let (min, max) = (
            ((min - margin) / step).floor() * step,
            ((max + margin) / step).ceil() * step,
        );
        let usable = step > 0.0 && min.is_finite() && max.is_finite() && origin.is_finite();
        if usable {
            Ok(Patch {
                origin,
                u,
                v,
                min,
                max,
                step,
            })
        } else {
            Err(wrong())
        }
    }

    fn at(&self, u: f64, v: f64) -> DVec3 {
        self.origin + self.u * u + self.v * v
    }

    /// Its corners, in order.
    pub fn corners(&self) -> [DVec3; 4] {
        let (a, b) = (self.min, self.max);
        [
            self.at(a.x, a.y),
            self.at(b.x, a.y),
            self.at(b.x, b.y),
            self.at(a.x, b.y),
        ]
    }

    fn flat(&self, p: DVec3) -> DVec2 {
        let p = p - self.origin;
        DVec2::new(p.dot(self.u), p.dot(self.v))
    }

    /// Whether a point of the plane lies on it.
    pub fn contains(&self, p: DVec3) -> bool {
        let p = self.flat(p);
        Rect::new(self.min, self.max).contains(&Rect::new(p, p))
    }

    /// The part of a line in the plane that lies on it.
    pub fn cut(&self, a: DVec3, b: DVec3) -> Option<(DVec3, DVec3)> {
        let whole = Rect::new(self.min, self.max);
        let (a, b) = whole.cut(self.flat(a), self.flat(b))?;
        Some((self.at(a.x, a.y), self.at(b.x, b.y)))
    }

    /// The middles of its grid cells at the corners, in the order of [`Patch::corners`].
    pub fn corner_cells(&self) -> [DVec3; 4] {
        let (a, b) = (self.min + 0.5 * self.step, self.max - 0.5 * self.step);
        [
            self.at(a.x, a.y),
            self.at(b.x, a.y),
            self.at(b.x, b.y),
            self.at(a.x, b.y),
        ]
    }

    /// A length for axes beside it.
    pub fn axis(&self) -> f64 {
        2.0 * self.step
    }

    /// Distance of its grid lines.
    pub fn step(&self) -> f64 {
        self.step
    }

    /// Draws it: the area, the grid, no outline.
    pub fn draw(&self, sheet: &mut Sheet, view: &View) {
        self.draw_in(sheet, view, Role::Ground.into());
    }

    /// Draws it as the front of a wall: the sides of the wall that the eye sees, then the patch.
    pub fn draw_wall(&self, sheet: &mut Sheet, view: &View) {
        let corners = self.corners();
        let n = self.u.cross(self.v).normalize_or_zero();
        let front = n.dot(view.eye() - self.origin) >= 0.0;
        let back = if front { -n } else { n } * (0.3 * self.step);
        let middle = corners.iter().sum::<DVec3>() / 4.0;
        for (&a, &b) in corners.iter().zip(corners.iter().cycle().skip(1)) {
            let out = a.midpoint(b) - middle;
            if out.dot(view.eye() - a.midpoint(b)) <= 0.0 {
                continue;
            }
            if let Some(side) = view.contour(&[a, b, b + back, a + back]) {
                let ink = Ink::of(Role::Receiver);
                let path = Path::polygon(&side);
                sheet.fill_unmarked(path, ink.tint(0.45), Pen::new(ink.tint(0.7), THIN));
            }
        }
        self.draw(sheet, view);
    }

    /// Draws it see-through, for one that stands before other things.
    pub fn draw_glass(&self, sheet: &mut Sheet, view: &View) {
        self.draw_in(sheet, view, Ink::of(Role::Ground).alpha(0.65));
    }

    fn draw_in(&self, sheet: &mut Sheet, view: &View, ink: Ink) {
        if let Some(corners) = view.contour(&self.corners()) {
            sheet.fill(Path::polygon(&corners), ink);
        }
        let mut grid = Path::new();
        let cells = (self.max - self.min) / self.step;
        let lines = |cells: f64| (0..=cells.round().clamp(0.0, 40.0) as u32).map(f64::from);
        for i in lines(cells.x) {
            let u = self.min.x + i * self.step;
            if let Some((a, b)) = view.segment(self.at(u, self.min.y), self.at(u, self.max.y)) {
                grid.add_polyline(&[a, b]);
            }
        }
        for i in lines(cells.y) {
            let v = self.min.y + i * self.step;
            if let Some((a, b)) = view.segment(self.at(self.min.x, v), self.at(self.max.x, v)) {
                grid.add_polyline(&[a, b]);
            }
        }
        sheet.stroke(grid, Pen::new(Role::Grid, THIN));
    }
}
