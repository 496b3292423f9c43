//! What of a line or a point a solid hides.

use ombra_math::glam::DVec3;
use ombra_math::mesh::Mesh;

use crate::space::View;

/// Places at which a line is looked at, and halvings of the stretch in which it appears or vanishes.
const PLACES: u32 = 64;
const HALVINGS: u32 = 8;
/// What lies nearer to a face than this share of its distance from the eye lies on it.
const ON: f64 = 1e-6;

/// A solid as the eye sees it.
pub struct Sight {
    eye: DVec3,
    triangles: Vec<[DVec3; 3]>,
}

impl Sight {
    /// Of a mesh in a view.
    pub fn new(view: &View, mesh: &Mesh) -> Sight {
        Sight {
            eye: view.eye(),
            triangles: (0..mesh.triangles.len())
                .filter_map(|i| mesh.triangle(i))
                .collect(),
        }
    }

    /// Whether a face lies before `p`.
    pub fn hides(&self, p: DVec3) -> bool {
        let along = p - self.eye;
        self.triangles.iter().any(|&[a, b, c]| {
            // The hit a + u (b − a) + v (c − a) = eye + t along, by Cramer's rule.
            let (u, v, from) = (b - a, c - a, self.eye - a);
            let across = along.cross(v);
            let det = u.dot(across);
            if det == 0.0 {
                return false;
            }
            let first = from.dot(across) / det;
            let normal = from.cross(u);
            let second = along.dot(normal) / det;
            let t = v.dot(normal) / det;
            first >= 0.0 && second >= 0.0 && first + second <= 1.0 && t > 0.0 && t < 1.0 - ON
        })
    }

    /// The pieces of a–b that can be seen.
    pub fn visible(&self, a: DVec3, b: DVec3) -> Vec<(DVec3, DVec3)> {
        let at = |t: f64| a.lerp(b, t);
        let seen = |t: f64| !self.hides(at(t));
        let mut pieces = Vec::new();
        let mut start = seen(0.0).then_some(0.0);
        let mut before = (0.0, start.is_some());
        for i in 1..=PLACES {
            let now = (
                f64::from(i) / f64::from(PLACES),
                seen(f64::from(i) / f64::from(PLACES)),
            );
            if now.1 != before.1 {
                let (mut low, mut high) = (before.0, now.0);
                for _ in 0..HALVINGS {
                    let middle = 0.5 * (low + high);
                    if seen(middle) == before.1 {
                        low = middle;
                    } else {
                        high = middle;
                    }
                }
                match start.take() {
                    Some(from) => pieces.push((at(from), at(low))),
                    None => start = Some(high),
                }
            }
            before = now;
        }
        pieces.extend(start.map(|from| (at(from), b)));
        pieces
    }
}

#[cfg(test)]
mod tests {
    use ombra_math::solids::slide_cube;

    use super::*;
    use crate::path::Rect;
    use ombra_math::glam::DVec2;

    #[test]
    fn a_line_through_a_cube_is_seen_before_and_beside_it() {
        let cube = slide_cube();
        let frame = Rect::new(DVec2::ZERO, DVec2::new(1000.0, 1000.0));
        let view = View::fit(&cube.positions, frame).unwrap();
        let sight = Sight::new(&view, &cube);
        let middle = DVec3::new(5.0, 25.0, 5.0);
        let towards = (view.eye() - middle).normalize();
        assert!(sight.hides(middle) && sight.hides(middle - towards * 30.0));
        assert!(!sight.hides(middle + towards * 12.0));
        // Along x at the cube's own height, in front of and behind its middle: seen on both sides of it only.
        let (a, b) = (middle - DVec3::X * 40.0, middle + DVec3::X * 40.0);
        let pieces = sight.visible(a, b);
        assert_eq!(pieces.len(), 2, "{pieces:?}");
        assert_eq!((pieces[0].0, pieces[1].1), (a, b));
        // The eye looks from the left: the line enters by the side x = 0, which is seen, and leaves by one that is not.
        assert!(
            pieces[0].1.x.abs() < 0.1 && pieces[1].0.x > 10.0,
            "{pieces:?}"
        );
        // A vertex does not hide itself.
        let near = cube.positions.iter().filter(|&&v| !sight.hides(v)).count();
        assert_eq!(near, 7);
    }
}
