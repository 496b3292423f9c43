//! Figures of a section: the plane z = 0 with x to the right and y up, in one scale.

use ombra_math::glam::DVec2;

use crate::colour::{Ink, Role};
use crate::drawing::{NORMAL, Pen, THIN};
use crate::error::FigureError;
use crate::marks;
use crate::path::{Path, Rect};
use crate::sheet::{Label, Sheet};

/// Depth of the hatched strip below the ground.
pub const STRIP: f64 = 22.0;

/// From the plane of a section to the canvas.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Section {
    scale: f64,
    offset: DVec2,
}

impl Section {
    /// Fits `shown` into `frame`.
    ///
    /// # Errors
    ///
    /// [`FigureError::Scene`] when `shown` is empty, a single point, or too large to compute with.
    pub fn fit(shown: &[DVec2], frame: Rect) -> Result<Section, FigureError> {
        let wrong = || {
            FigureError::Scene {
            reason: "nothing to show: the points of the section are too few, too far or too close together".to_owned(),
        }
        };
        let around = |p: &DVec2| Rect::new(*p, *p);
        let all = shown
            .iter()
            .map(around)
            .reduce(|a, b| Rect::new(a.min.min(b.min), a.max.max(b.max)))
            .ok_or_else(wrong)?;
        let ratio = frame.size() / all.size();
        let scale = ratio.x.min(ratio.y);
        let middle = DVec2::new(all.centre().x, -all.centre().y);
        let section = Section {
            scale,
            offset: frame.centre() - middle * scale,
        };
        let usable = scale > 0.0 && scale.is_finite() && section.offset.is_finite();
        if usable { Ok(section) } else { Err(wrong()) }
    }

    /// Where a point of the section appears.
    pub fn at(&self, p: DVec2) -> DVec2 {
        DVec2::new(p.x, -p.y) * self.scale + self.offset
    }

    /// Thousandths of the canvas's shorter side a unit.
    pub fn scale(&self) -> f64 {
        self.scale
    }
}

/// The ground from `left` to `right` on the canvas: a line, hatched below.
pub fn ground(sheet: &mut Sheet, left: DVec2, right: DVec2) {
    let down = DVec2::new(0.0, STRIP);
    let strip = [left, right, right + down, left + down];
    sheet.fill(Path::polygon(&strip), Role::Ground);
    let lines = Path::hatching(&strip, 14.0);
    sheet.stroke(lines, Pen::new(Role::Grid, THIN));
    sheet.line(left, right, Pen::new(Role::Receiver, NORMAL));
}

/// Two short labelled arrows at the origin, `length` long on the canvas.
pub fn axes(sheet: &mut Sheet, section: &Section, length: f64) {
    let origin = section.at(DVec2::ZERO);
    for (axis, name) in [(DVec2::X, "*x*"), (DVec2::NEG_Y, "*y*")] {
        let tip = origin + axis * length;
        marks::arrow(sheet, origin, tip, Role::Axis, NORMAL);
        let label = Label::new(tip, name).towards(axis).ink(Ink::of(Role::Axis));
        sheet.label(label.beside());
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const FRAME: Rect = Rect::new(DVec2::new(40.0, 40.0), DVec2::new(1040.0, 640.0));

    #[test]
    fn what_is_shown_fills_the_frame_in_one_scale_and_y_points_up() {
        let shown = [DVec2::new(-3.0, 0.0), DVec2::new(7.0, 2.0)];
        let section = Section::fit(&shown, FRAME).unwrap();
        assert!((section.scale() - 100.0).abs() < 1e-9);
        let [a, b] = shown.map(|p| section.at(p));
        assert!((a.x - 40.0).abs() < 1e-9 && (b.x - 1040.0).abs() < 1e-9);
        assert!((a.y - b.y - 200.0).abs() < 1e-9);
        assert!(((a.y + b.y) * 0.5 - 340.0).abs() < 1e-9);
    }

    #[test]
    fn what_cannot_be_shown_is_refused() {
        for shown in [
            &[][..],
            &[DVec2::ONE],
            &[DVec2::ZERO, DVec2::splat(f64::NAN)],
            &[DVec2::ZERO, DVec2::splat(f64::INFINITY)],
            &[DVec2::splat(-1e308), DVec2::splat(1e308)],
        ] {
            assert!(Section::fit(shown, FRAME).is_err(), "{shown:?}");
        }
    }
}
