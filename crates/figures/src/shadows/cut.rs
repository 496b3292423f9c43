//! The part of an object on the light's side of the plane.

use std::collections::BTreeMap;

use ombra_math::glam::{DVec3, DVec4};
use ombra_math::mesh::Mesh;
use ombra_math::plane::Plane;

/// What of `mesh` lies on the side of `plane` on which `light` is; all of it where nothing lies on the other side.
pub(super) fn on_lights_side(mesh: &Mesh, plane: Plane, light: DVec4) -> Mesh {
    let towards = plane.coefficients().dot(light);
    let side = if light.w < 0.0 { -towards } else { towards };
    let height = |p: &DVec3| plane.coefficients().dot(p.extend(1.0)) * side.signum();
    let heights: Vec<f64> = mesh.positions.iter().map(height).collect();
    if heights.iter().all(|h| *h >= 0.0) {
        return mesh.clone();
    }

    let mut cut = Cut {
        positions: mesh.positions.clone(),
        heights,
        on_edges: BTreeMap::new(),
    };
    let mut triangles = Vec::new();
    for &corners in &mesh.triangles {
        if let [first, rest @ ..] = &cut.piece(corners)[..] {
            triangles.extend(rest.windows(2).filter_map(|pair| match pair {
                [a, b] => Some([*first, *a, *b]),
                _ => None,
            }));
        }
    }
    used(&cut.positions, &triangles)
}

struct Cut {
    positions: Vec<DVec3>,
    heights: Vec<f64>,
    /// New vertices by the edge they lie on, so that neighbours share them.
    on_edges: BTreeMap<[u32; 2], u32>,
}

impl Cut {
    /// The corners of what is left of a triangle, in its order.
    fn piece(&mut self, corners: [u32; 3]) -> Vec<u32> {
        let [a, b, c] = corners;
        let mut piece = Vec::with_capacity(4);
        for (from, to) in [(a, b), (b, c), (c, a)] {
            let (above, next) = (self.height(from), self.height(to));
            if above >= 0.0 {
                piece.push(from);
            }
            if (above > 0.0 && next < 0.0) || (above < 0.0 && next > 0.0) {
                piece.push(self.crossing([from.min(to), from.max(to)]));
            }
        }
        piece
    }

    fn height(&self, i: u32) -> f64 {
        let height = usize::try_from(i).ok().and_then(|i| self.heights.get(i));
        height.copied().unwrap_or(0.0)
    }

    fn crossing(&mut self, edge: [u32; 2]) -> u32 {
        if let Some(&there) = self.on_edges.get(&edge) {
            return there;
        }
        let [i, j] = edge;
        let (h, k) = (self.height(i), self.height(j));
        let at = |i: u32| {
            let place = usize::try_from(i).ok().and_then(|i| self.positions.get(i));
            place.copied().unwrap_or_default()
        };
        let new = u32::try_from(self.positions.len()).unwrap_or(u32::MAX);
        self.positions.push(at(i).lerp(at(j), h / (h - k)));
        self.heights.push(0.0);
        self.on_edges.insert(edge, new);
        new
    }
}

/// The triangles with the vertices they use, in their order.
fn used(positions: &[DVec3], triangles: &[[u32; 3]]) -> Mesh {
    let mut places: BTreeMap<u32, u32> = triangles.iter().flatten().map(|&i| (i, 0)).collect();
    let mut kept = Vec::with_capacity(places.len());
    for (new, (old, place)) in (0..).zip(&mut places) {
        *place = new;
        let at = usize::try_from(*old).ok().and_then(|i| positions.get(i));
        kept.push(at.copied().unwrap_or_default());
    }
    let of = |i: u32| places.get(&i).copied().unwrap_or_default();
    let triangles = triangles.iter().map(|triangle| triangle.map(of)).collect();
    Mesh::new(kept, triangles).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use ombra_math::solids::slide_cube;

    use super::*;

    fn volume_and_area(mesh: &Mesh) -> (f64, f64) {
        let triangles = (0..mesh.triangles.len()).filter_map(|i| mesh.triangle(i));
        triangles.fold((0.0, 0.0), |(volume, area), [a, b, c]| {
            let normal = (b - a).cross(c - a);
            (volume + a.dot(normal) / 6.0, area + 0.5 * normal.length())
        })
    }

    /// The lectures' cube, 10 wide, from y = 20 to 30, cut at y = 26: four sides 4 high and the top are left.
    #[test]
    fn a_cube_in_the_ground_keeps_its_upper_part() {
        let plane = Plane {
            normal: DVec3::Y,
            d: -26.0,
        };
        let sun = DVec4::new(1.0, 5.0, 2.0, 0.0);
        for light in [
            sun,
            DVec4::new(3.0, 90.0, 1.0, 1.0),
            DVec4::new(-3.0, -90.0, -1.0, -1.0),
        ] {
            let cut = on_lights_side(&slide_cube(), plane, light);
            let (_, area) = volume_and_area(&cut);
            assert!((area - (4.0 * 40.0 + 100.0)).abs() < 1e-9, "{area}");
            assert!(cut.positions.iter().all(|p| p.y >= 26.0));
            // Neighbours share the new corners: the only open edges are those of the cut.
            let open = cut
                .edges()
                .into_iter()
                .filter(|edge| edge.left.is_none() || edge.right.is_none());
            assert!(open.count() <= 8);
        }
        // From below the lower part is left, and what the plane does not reach stays as it is.
        let (_, area) = volume_and_area(&on_lights_side(
            &slide_cube(),
            plane,
            DVec4::new(0.0, -9.0, 0.0, 1.0),
        ));
        assert!((area - (4.0 * 60.0 + 100.0)).abs() < 1e-9, "{area}");
        assert_eq!(
            on_lights_side(&slide_cube(), Plane::GROUND, sun),
            slide_cube()
        );
    }
}
