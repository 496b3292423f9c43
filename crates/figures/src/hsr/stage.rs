//! What an eye sees and, below it, the same from above.
//!
//! The eye is at the origin and looks along −z. Seen from above it looks up, and the picture stands where the plan
//! ends, as wide as the view is there: a sight line that leaves the plan at the top enters the picture in the column
//! that it belongs to.

use ombra_clip::Window;
use ombra_clip::sutherland_hodgman::clip_polygon;
use ombra_hsr::polygon::Polygon;
use ombra_math::glam::{DVec2, DVec3, DVec4};

use super::primitives::AREA;
use crate::colour::{Ink, Role};
use crate::drawing::{NORMAL, Pen, THIN};
use crate::marks;
use crate::path::{Path, Rect};
use crate::sheet::Sheet;

/// The eye of the stage.
pub(super) const EYE: DVec4 = DVec4::W;
/// How far the plan reaches from the eye.
const DEPTH: f64 = 10.0;
/// Half of what the picture shows at that distance.
const HALF: DVec2 = DVec2::new(5.5, 3.4);
/// Between the picture and the plan, on the canvas.
const GAP: f64 = 24.0;
/// How far the mark of the eye reaches below its place, and how far lines keep off it.
const BELOW: f64 = 28.0;
const RIM: f64 = 38.0;

/// A picture and a plan in one panel.
pub(super) struct Stage {
    /// Thousandths of the canvas's shorter side a unit of the plan.
    scale: f64,
    /// The place of the eye in the plan.
    eye: DVec2,
    /// The frame of the picture.
    pub(super) picture: Rect,
}

impl Stage {
    /// How many times as high as wide a panel is that it fills.
    pub(super) const TALLEST: f64 = 1.7;

    /// As large as it fits into `panel`.
    pub(super) fn fit(panel: Rect) -> Stage {
        let across = panel.size().x / (2.0 * HALF.x);
        let down = (panel.size().y - GAP - BELOW) / (2.0 * HALF.y + DEPTH);
        let scale = across.min(down);
        let height = scale * (2.0 * HALF.y + DEPTH) + GAP + BELOW;
        let middle = panel.centre();
        let bottom = middle.y + 0.5 * height;
        let half = scale * HALF;
        let centre = DVec2::new(middle.x, bottom - height + half.y);
        Stage {
            scale,
            eye: DVec2::new(middle.x, bottom - BELOW),
            picture: Rect::new(centre - half, centre + half),
        }
    }

    /// Where a point in front of the eye appears in the picture.
    pub(super) fn seen(&self, p: DVec3) -> DVec2 {
        let at_depth = DVec2::new(p.x, -p.y) * (DEPTH / -p.z);
        self.picture.centre() + self.scale * at_depth
    }

    /// Where a point appears from above.
    pub(super) fn above(&self, p: DVec3) -> DVec2 {
        self.eye + self.scale * DVec2::new(p.x, p.z)
    }

    /// The corners of a polygon in the picture, cut off at its frame.
    pub(super) fn contour(&self, polygon: &Polygon) -> Vec<DVec2> {
        let seen: Vec<DVec2> = polygon.vertices.iter().map(|&p| self.seen(p)).collect();
        let Rect { min, max } = self.picture;
        clip_polygon(&Window { min, max }, &seen)
    }

    /// The outline of a polygon in the picture.
    pub(super) fn outline(&self, polygon: &Polygon) -> Path {
        Path::polygon(&self.contour(polygon))
    }

    /// Where the plan is.
    fn plan(&self) -> Rect {
        let Rect { min, max } = self.picture;
        Rect::new(
            DVec2::new(min.x, max.y + GAP),
            DVec2::new(max.x, self.eye.y),
        )
    }

    /// A polygon cut at the height of the eye, from above, from left to right, as far as the plan shows it.
    pub(super) fn cut(&self, polygon: &Polygon) -> Option<(DVec2, DVec2)> {
        let [a, b] = section(polygon)?;
        self.plan().cut(self.above(a), self.above(b))
    }

    /// The frame of the picture and the sides of the view.
    pub(super) fn draw_frame(&self, sheet: &mut Sheet) {
        let Rect { min, max } = self.picture;
        let frame = [min, DVec2::new(max.x, min.y), max, DVec2::new(min.x, max.y)];
        sheet.stroke(Path::polygon(&frame), Pen::new(Role::Note, THIN));
        for side in [-1.0, 1.0] {
            let far = DVec3::new(side * HALF.x, 0.0, -DEPTH);
            let [from, to] = [self.rim(far), self.above(far)];
            sheet.line(from, to, Pen::new(Role::Grid, THIN));
        }
        marks::eye(sheet, self.eye, DVec2::NEG_Y);
    }

    /// A polygon as it is painted.
    pub(super) fn paint(&self, sheet: &mut Sheet, polygon: &Polygon, role: Role) {
        let outline = self.outline(polygon);
        sheet.fill(outline.clone(), Ink::of(role).tint(AREA));
        sheet.stroke(outline, Pen::new(role, NORMAL));
    }

    /// A polygon cut at the height of the eye, from above.
    pub(super) fn draw_section(&self, sheet: &mut Sheet, polygon: &Polygon, pen: Pen) {
        if let Some((a, b)) = self.cut(polygon) {
            sheet.line(a, b, pen);
        }
    }

    /// A sight line as far as `p`, from above, if the plan shows it.
    pub(super) fn draw_ray(&self, sheet: &mut Sheet, p: DVec3) {
        let at = self.above(p);
        if self.plan().grown(1.0).contains(&Rect::new(at, at)) {
            marks::ray(sheet, self.rim(p), at);
        }
    }

    /// What lies behind a polygon: nothing there is seen.
    pub(super) fn draw_hidden(&self, sheet: &mut Sheet, polygon: &Polygon) {
        let Some(ends) = section(polygon) else { return };
        let far = ends.map(|p| p * (DEPTH / -p.z));
        let [a, b] = ends.map(|p| self.above(p));
        let [far_a, far_b] = far.map(|p| self.above(p));
        let Rect { min, max } = self.plan();
        let area = clip_polygon(&Window { min, max }, &[a, far_a, far_b, b]);
        sheet.fill(Path::polygon(&area), Role::Ground);
        for (from, to) in [(a, far_a), (b, far_b)] {
            if let Some((from, to)) = self.plan().cut(from, to) {
                marks::stopped_ray(sheet, from, to);
            }
        }
    }

    /// Where a sight line to `p` leaves the mark of the eye.
    fn rim(&self, p: DVec3) -> DVec2 {
        let along = self.above(p) - self.eye;
        self.eye + along.normalize_or_zero() * RIM
    }
}

/// The ends of a polygon's section at the height of the eye, from left to right.
pub(super) fn section(polygon: &Polygon) -> Option<[DVec3; 2]> {
    let vertices = &polygon.vertices;
    let edges = vertices.iter().zip(vertices.iter().cycle().skip(1));
    let crossings = edges
        .filter(|(a, b)| (a.y < 0.0) != (b.y < 0.0))
        .map(|(&a, &b)| a + (b - a) * (a.y / (a.y - b.y)));
    let mut ends: Vec<DVec3> = crossings.collect();
    ends.sort_by(|a, b| a.x.total_cmp(&b.x));
    Some([*ends.first()?, *ends.last()?])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn stage() -> Stage {
        Stage::fit(Rect::new(DVec2::new(40.0, 60.0), DVec2::new(440.0, 900.0)))
    }

    #[test]
    fn the_picture_stands_above_the_plan_within_the_panel() {
        let stage = stage();
        // 400 wide for 11 units; 16.8 of them high, and the rest free.
        assert!((stage.scale - 400.0 / 11.0).abs() < 1e-9);
        let far = stage.above(DVec3::new(0.0, 0.0, -DEPTH));
        assert!((far.y - stage.picture.max.y - GAP).abs() < 1e-9);
        assert!(stage.picture.min.y >= 60.0 && stage.eye.y + BELOW <= 900.0);
    }

    #[test]
    fn a_sight_line_enters_the_picture_in_its_own_column() {
        let stage = stage();
        for p in [DVec3::new(1.0, 0.5, -4.0), DVec3::new(-2.0, 1.0, -8.0)] {
            let leaves = stage.above(p * (DEPTH / -p.z));
            assert!((stage.seen(p).x - leaves.x).abs() < 1e-9);
        }
        // Up in space is up in the picture, and right is right in both.
        let [a, b] = [DVec3::new(0.0, 0.0, -4.0), DVec3::new(1.0, 1.0, -4.0)];
        assert!(stage.seen(b).y < stage.seen(a).y && stage.seen(b).x > stage.seen(a).x);
        assert!(stage.above(b).x > stage.above(a).x);
    }

    #[test]
    fn a_section_is_cut_at_the_height_of_the_eye() {
        let triangle = |low: f64| Polygon {
            vertices: vec![
                DVec3::new(-2.0, low, -4.0),
                DVec3::new(2.0, low, -6.0),
                DVec3::new(0.0, low + 4.0, -5.0),
            ],
        };
        // Halfway up the sides.
        let ends = [DVec3::new(-1.0, 0.0, -4.5), DVec3::new(1.0, 0.0, -5.5)];
        assert_eq!(section(&triangle(-2.0)), Some(ends));
        assert_eq!(section(&triangle(1.0)), None);
    }
}
