//! The light, and the rays from it through the object to the shadow.

use ombra_math::glam::{DVec2, DVec3};

use super::setting::Setting;
use crate::colour::Role;
use crate::drawing::{Pen, THIN};
use crate::marks;
use crate::number::exact;
use crate::sheet::{Label, Sheet};
use crate::solid::sight::Sight;
use crate::space::View;

/// A light farther away than this many radii is drawn here, its rays broken.
const NEAR_LIGHT: f64 = 4.0;
/// Where a ray is broken, in radii from the object's middle along the way to the light.
const BREAK: [f64; 2] = [2.1, 2.5];
/// Half the length of the stroke at a broken end.
const STROKE: f64 = 9.0;
/// Where arrows from a light at infinity end and begin, in radii from the object's middle.
const ARROW: [f64; 2] = [1.4, 2.8];

/// How a light is shown.
#[derive(Clone, Copy)]
pub(super) enum Sun {
    /// Arrows from it, along the line from their nearer end to their farther one.
    Far([DVec3; 2]),
    /// Where it is.
    Near(DVec3),
    /// Where it is drawn, far nearer than it is: its rays are broken.
    Broken(DVec3),
}

impl Sun {
    /// Where the sun is drawn, or the middle of the arrows.
    pub fn place(&self) -> DVec3 {
        match *self {
            Sun::Near(at) | Sun::Broken(at) => at,
            Sun::Far([a, b]) => a.midpoint(b),
        }
    }
}

impl Setting {
    /// How its light is shown.
    pub(super) fn sun(&self) -> Sun {
        let towards = self.towards_light(self.centre);
        if self.light.w == 0.0 {
            return Sun::Far(ARROW.map(|k| self.centre + towards * (self.reach * k)));
        }
        let place = self.light.truncate() / self.light.w;
        if place.distance(self.centre) <= NEAR_LIGHT * self.reach {
            Sun::Near(place)
        } else {
            Sun::Broken(self.centre + towards * (self.reach * NEAR_LIGHT))
        }
    }

    /// The direction from a place to the light, of length 1.
    fn towards_light(&self, from: DVec3) -> DVec3 {
        // Any multiple is the same light: one with ordinary numbers, before lengths are squared.
        let l = self.light / self.light.abs().max_element();
        let towards = if l.w == 0.0 {
            l.truncate()
        } else {
            (l.truncate() - from * l.w) * l.w.signum()
        };
        towards.normalize_or_zero()
    }

    /// Whether a triangle's front is turned to the light.
    pub(super) fn is_lit(&self, i: usize) -> bool {
        let [a, b, c] = self.mesh.triangle(i).unwrap_or_default();
        (b - a).cross(c - a).dot(self.towards_light(a)) > 0.0
    }

    /// Index of each vertex that has a shadow, but of those with one shadow only the nearest to the light.
    fn rays(&self) -> Vec<(usize, DVec3, DVec3)> {
        let mut rays: Vec<(usize, DVec3, DVec3)> = Vec::new();
        for (i, (&v, p)) in self.mesh.positions.iter().zip(&self.casts).enumerate() {
            let Some(p) = *p else { continue };
            match rays.iter_mut().find(|(_, _, q)| *q == p) {
                Some(ray) if ray.1.distance(p) < v.distance(p) => *ray = (i, v, p),
                Some(_) => {}
                None => rays.push((i, v, p)),
            }
        }
        rays
    }

    /// The two vertices whose rays enclose all others on the canvas.
    pub fn outermost(&self, view: &View) -> Vec<(usize, DVec3, DVec3)> {
        let pairs: Vec<(usize, DVec3, DVec3, DVec2)> = self
            .mesh
            .positions
            .iter()
            .zip(&self.casts)
            .enumerate()
            .filter_map(|(i, (&v, p))| Some((i, v, (*p)?, view.project((*p)?)?)))
            .collect();
        let middle = pairs.iter().map(|ray| ray.3).sum::<DVec2>() / pairs.len().max(1) as f64;
        let Some(across) = view
            .project(self.centre)
            .and_then(|at| (middle - at).try_normalize())
        else {
            return Vec::new();
        };
        let aside = |ray: &&(usize, DVec3, DVec3, DVec2)| across.perp_dot(ray.3 - middle);
        let by = |a: &&_, b: &&_| aside(a).total_cmp(&aside(b));
        [pairs.iter().min_by(by), pairs.iter().max_by(by)]
            .into_iter()
            .flatten()
            .map(|&(i, v, p, _)| (i, v, p))
            .collect()
    }

    /// From each vertex on to its shadow; of many vertices only the outermost.
    pub fn draw_rays(&self, sheet: &mut Sheet, view: &View, sight: &Sight) {
        let rays = if self.has_few() {
            self.rays()
        } else {
            self.outermost(view)
        };
        let canvas = sheet.frame();
        let pieces = rays.iter().flat_map(|&(_, v, p)| sight.visible(v, p));
        for (a, b) in pieces {
            if let Some((from, to)) = view.segment(a, b)
                && let Some((from, to)) = canvas.cut(from, to)
            {
                marks::stopped_ray(sheet, from, to);
            }
        }
    }

    /// Arrows from a light far away or at infinity; otherwise a sun with its rays to the vertices it lights.
    pub fn draw_light(&self, sheet: &mut Sheet, view: &View, sight: &Sight) {
        let l = self.light;
        let name = format!(
            "**L** = ({}, {}, {}, {})",
            exact(l.x),
            exact(l.y),
            exact(l.z),
            exact(l.w)
        );
        match self.sun() {
            Sun::Far([near, far]) => {
                let (Some(near), Some(far)) = (view.project(near), view.project(far)) else {
                    return;
                };
                let aside = (far - near).normalize_or_zero().perp() * 34.0;
                let above = if aside.y > 0.0 { -aside } else { aside };
                let bundle: Vec<_> = [-1.0, 0.0, 1.0]
                    .map(|k| (far + above * k, near + above * k))
                    .to_vec();
                marks::bundle(sheet, &bundle);
                let middle = (far + near) * 0.5 + above;
                sheet.label(Label::new(middle, name).towards(above));
            }
            sun @ (Sun::Near(place) | Sun::Broken(place)) => {
                let (Some(at), Some(object)) = (view.project(place), view.project(self.centre))
                else {
                    return;
                };
                for v in self.lit_vertices(view) {
                    if let Sun::Broken(_) = sun {
                        self.draw_broken_ray(sheet, view, sight, (place, v));
                    } else {
                        for (a, b) in sight.visible(place, v) {
                            if let Some((from, to)) = view.segment(a, b) {
                                marks::ray_from_sun(sheet, from, to);
                            }
                        }
                    }
                }
                marks::sun(sheet, at);
                let label = Label::new(at, name).reach(marks::SUN + 4.0);
                sheet.label(label.towards(at - object).beside());
            }
        }
    }

    /// A ray from a light that is drawn too near: its true direction at the vertex, a gap, and its end at the sun.
    fn draw_broken_ray(
        &self,
        sheet: &mut Sheet,
        view: &View,
        sight: &Sight,
        (sun, v): (DVec3, DVec3),
    ) {
        let axis = self.towards_light(self.centre);
        let from = (v - self.centre).dot(axis);
        let along = self.towards_light(v);
        let steep = along.dot(axis);
        // Never level with what it crosses: the light is more than four radii away.
        if steep.is_nan() || steep <= 0.0 {
            return;
        }
        let broken = v + along * ((BREAK[0] * self.reach - from) / steep);
        let whole = (sun - v).dot(axis);
        let on = v.lerp(sun, (BREAK[1] * self.reach - from) / whole);
        for (a, b) in sight.visible(broken, v) {
            if let Some((a, b)) = view.segment(a, b) {
                marks::ray(sheet, a, b);
            }
        }
        if let Some((a, b)) = view.segment(sun, on) {
            marks::ray_from_sun(sheet, a, b);
        }
        // Two strokes of one slant, as a break is drawn on an axis.
        let Some((a, b)) = view.segment(sun, self.centre) else {
            return;
        };
        let along = (b - a).normalize_or_zero();
        let across = along.perp() * STROKE + along * 0.5 * STROKE;
        for end in [broken, on].into_iter().filter(|&p| !sight.hides(p)) {
            if let Some(end) = view.project(end) {
                sheet.line(end - across, end + across, Pen::new(Role::Ray, THIN));
            }
        }
    }

    /// The vertices of sides turned to the light; of many vertices only those on the outermost rays.
    fn lit_vertices(&self, view: &View) -> Vec<DVec3> {
        if !self.has_few() {
            let outermost = self.outermost(view);
            return outermost.into_iter().map(|(_, v, _)| v).collect();
        }
        let mut lit: Vec<u32> = Vec::new();
        for (i, corners) in self.mesh.triangles.iter().enumerate() {
            if self.is_lit(i) {
                lit.extend(corners);
            }
        }
        lit.sort_unstable();
        lit.dedup();
        let position = |i: u32| self.mesh.positions.get(usize::try_from(i).ok()?).copied();
        let there = |v: &DVec3| self.shown.positions.contains(v);
        lit.into_iter().filter_map(position).filter(there).collect()
    }
}

#[cfg(test)]
mod tests {
    use ombra_math::glam::DVec4;
    use ombra_math::plane::Plane;
    use ombra_shadows::planar::cast;

    use super::super::setting::setting_of;
    use super::*;
    use crate::path::Rect;

    #[test]
    fn many_vertices_have_two_rays_that_enclose_the_shadow() {
        let setting = setting_of("torus", DVec4::new(3.0, 9.0, 2.0, 0.0), Plane::GROUND);
        let frame = Rect::new(DVec2::ZERO, DVec2::new(1700.0, 900.0));
        let view = setting.stage(frame, &[]).unwrap().view;
        let outermost = setting.outermost(&view);
        let [(_, v, a), (_, w, b)] = outermost[..] else {
            panic!("{outermost:?}")
        };
        assert_eq!(cast(setting.plane, setting.light, v), Some(a));
        assert_eq!(cast(setting.plane, setting.light, w), Some(b));
        let (a, b) = (view.project(a).unwrap(), view.project(b).unwrap());
        let along = view.project(setting.centre).unwrap() - (a + b) * 0.5;
        let aside = |p: DVec2| along.perp_dot(p);
        let (low, high) = (aside(a).min(aside(b)), aside(a).max(aside(b)));
        // The direction is taken from the shadow's middle, which differs a little from that of its two ends.
        let slack = 0.1 * (high - low);
        for p in setting.casts.iter().flatten() {
            let x = aside(view.project(*p).unwrap());
            assert!(x >= low - slack && x <= high + slack);
        }
    }
}
