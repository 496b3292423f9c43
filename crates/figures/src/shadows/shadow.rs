//! The shadow itself: one path, and the edges on it.

use ombra_math::glam::DVec2;
use ombra_shadows::planar::cast_onto;

use super::light::Sun;
use super::setting::Setting;
use super::stage::Stage;
use crate::colour::{Ink, Role};
use crate::contour::contours;
use crate::drawing::{Pen, THIN};
use crate::path::Path;
use crate::sheet::Sheet;
use crate::solid::creases;

impl Setting {
    /// The shadow of every triangle in one path, all of one winding, so that no seam shows.
    pub fn draw_shadow(&self, sheet: &mut Sheet, stage: &Stage) {
        let path = self.shadow(stage);
        // The outline goes below the area, so that only the outer half of it is left: edges inside do not show.
        sheet.avoid(&path);
        sheet.stroke_unmarked(path.clone(), Pen::new(Role::Shadow, 2.0 * THIN));
        sheet.fill(path, Role::Umbra);
    }

    fn shadow(&self, stage: &Stage) -> Path {
        let Stage { view, patch } = stage;
        let receiver = patch.corners();
        let on_patch: Vec<Option<DVec2>> = self
            .casts
            .iter()
            .map(|p| {
                p.filter(|p| patch.contains(*p))
                    .and_then(|p| view.project(p))
            })
            .collect();
        let place = |i: u32| on_patch.get(usize::try_from(i).ok()?).copied().flatten();

        let mut path = Path::new();
        let mut whole: Vec<[u32; 3]> = Vec::new();
        for i in self.triangles_that_cast() {
            let [a, b, c] = self.mesh.triangles.get(i).copied().unwrap_or_default();
            if let (Some(pa), Some(pb), Some(pc)) = (place(a), place(b), place(c)) {
                let negative = signed_area(&[pa, pb, pc]) < 0.0;
                whole.push(if negative { [a, c, b] } else { [a, b, c] });
                continue;
            }
            // A piece that the receiver's border or the light's height cuts.
            let corners = self.mesh.triangle(i).unwrap_or_default();
            if let Some(mut piece) = view.contour(&cast_onto(&receiver, self.light, &corners)) {
                if signed_area(&piece) < 0.0 {
                    piece.reverse();
                }
                path.add_polygon(&piece);
            }
        }
        for contour in contours(whole.into_iter()) {
            let points: Vec<DVec2> = contour.into_iter().filter_map(place).collect();
            path.add_polygon(&points);
        }
        path
    }

    /// The shadows of the object's edges, thin on its shadow; none for many vertices.
    pub fn draw_edges_in_shadow(&self, sheet: &mut Sheet, stage: &Stage) {
        if !self.has_few() {
            return;
        }
        let mut edges = Path::new();
        for [i, j] in creases(&self.mesh) {
            let shadow = |i: usize| self.casts.get(i).copied().flatten();
            if let (Some(a), Some(b)) = (shadow(i), shadow(j))
                && let Some((a, b)) = stage.patch.cut(a, b)
                && let Some((a, b)) = stage.view.segment(a, b)
            {
                edges.add_polyline(&[a, b]);
            }
        }
        let ink = Ink::of(Role::Shadow).alpha(0.55);
        sheet.stroke_unmarked(edges, Pen::new(ink, THIN));
    }

    /// Indices of the triangles whose shadows together are the whole one. Whatever a closed mesh shades lies behind a
    /// side of it that is turned to the light, so half of the triangles do, unless the light may be inside.
    fn triangles_that_cast(&self) -> Vec<usize> {
        let all = 0..self.mesh.triangles.len();
        let outside = match self.sun() {
            Sun::Far(_) | Sun::Broken(_) => true,
            Sun::Near(at) => at.distance(self.centre) > self.reach,
        };
        if outside && self.mesh.is_closed() {
            all.filter(|&i| self.is_lit(i)).collect()
        } else {
            all.collect()
        }
    }
}

/// Twice the area of a contour, negative when it runs the other way round.
fn signed_area(contour: &[DVec2]) -> f64 {
    let next = contour.iter().cycle().skip(1);
    contour.iter().zip(next).map(|(a, b)| a.perp_dot(*b)).sum()
}

#[cfg(test)]
mod tests {
    use ombra_math::glam::{DVec3, DVec4};
    use ombra_math::plane::Plane;

    use super::super::setting::setting_of;
    use super::*;
    use crate::path::Rect;

    /// How often a path of straight contours winds around `p`.
    fn winding(path: &Path, p: DVec2) -> i32 {
        let mut turns = 0;
        for (a, b) in path.chords() {
            let left = (b - a).perp_dot(p - a);
            if a.y <= p.y && b.y > p.y && left > 0.0 {
                turns += 1;
            } else if a.y > p.y && b.y <= p.y && left < 0.0 {
                turns -= 1;
            }
        }
        turns
    }

    #[test]
    fn the_contour_fills_what_the_shadows_of_all_triangles_fill() {
        let wall = Plane {
            normal: DVec3::new(1.0, 1.0, 2.0),
            d: 20.0,
        };
        for (mesh, light, plane) in [
            ("teapot", DVec4::new(10.0, 60.0, 50.0, 1.0), wall),
            ("teapot", DVec4::new(-3.0, 9.0, 5.0, 0.0), Plane::GROUND),
            ("torus", DVec4::new(0.0, 100.0, 100.0, 1.0), Plane::GROUND),
            // Level with the object, so that a part of it casts nothing and a part of the shadow is cut off.
            ("torus", DVec4::new(25.0, 22.0, 5.0, 1.0), Plane::GROUND),
        ] {
            let setting = setting_of(mesh, light, plane);
            let frame = Rect::new(DVec2::ZERO, DVec2::new(1700.0, 900.0));
            let stage = setting.stage(frame, &[]).unwrap();
            let contour = setting.shadow(&stage);
            let receiver = stage.patch.corners();
            // Each triangle by itself, whichever way it looks.
            let pieces: Vec<Path> = (0..setting.mesh.triangles.len())
                .filter_map(|i| {
                    let corners = setting.mesh.triangle(i)?;
                    let piece = cast_onto(&receiver, light, &corners);
                    Some(Path::polygon(&stage.view.contour(&piece)?))
                })
                .collect();
            let (mut dark, mut wrong) = (0, 0);
            for i in 0..60 {
                for j in 0..40 {
                    // Off the round places that corners may have.
                    let p = DVec2::new(11.3 + 28.1 * f64::from(i), 7.7 + 22.3 * f64::from(j));
                    let whole = winding(&contour, p) != 0;
                    let single = pieces.iter().any(|piece| winding(piece, p) != 0);
                    dark += i32::from(single);
                    wrong += i32::from(whole != single);
                }
            }
            assert!(dark > 10, "{mesh} {light}: {dark} places in shadow");
            assert_eq!(wrong, 0, "{mesh} {light}: of {dark}");
        }
    }
}
