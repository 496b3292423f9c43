//! The mesh that is drawn.

use std::f64::consts::{PI, TAU};

use ombra_math::glam::{DMat4, DVec3};
use ombra_math::view::{look_at, perspective};

/// Quads around the sphere and from pole to pole.
const QUADS: u32 = 224;
pub const NEAR: f64 = 1.0;
pub const FAR: f64 = 6.0;

/// A bumpy sphere, all of it within the view volume.
///
/// Positions and matrix are numbers that f32 has too: every contestant draws the same.
pub struct Ball {
    pub positions: Vec<DVec3>,
    /// Counter-clockwise as seen from outside.
    pub triangles: Vec<[u32; 3]>,
    /// One for each vertex. A triangle has that of its first, all over.
    pub colours: Vec<[u8; 4]>,
    /// From the mesh to clip space, −w ≤ z ≤ w.
    pub to_clip: DMat4,
}

impl Ball {
    /// 2 · 224² triangles.
    pub fn new() -> Self {
        Self::of(QUADS)
    }

    /// 2 · `quads`² triangles.
    pub fn of(quads: u32) -> Self {
        // The first and last ring stay half a step away from the poles: no triangle is without area.
        let rings = quads + 1;
        let vertices = || (0..rings).flat_map(|ring| (0..quads).map(move |column| (ring, column)));
        let positions = vertices().map(|(ring, column)| {
            let polar = PI * (f64::from(ring) + 0.5) / f64::from(rings);
            let around = TAU * f64::from(column) / f64::from(quads);
            let radius = 1.0 + 0.08 * (9.0 * around).sin() * (8.0 * polar).sin();
            let (across, up) = polar.sin_cos();
            let direction = DVec3::new(across * around.cos(), up, -across * around.sin());
            (radius * direction).as_vec3().as_dvec3()
        });
        let triangles = (0..quads)
            .flat_map(|ring| (0..quads).map(move |column| (ring, column)))
            .flat_map(|(ring, column)| {
                let at = |down, right| (ring + down) * quads + (column + right) % quads;
                let [a, b, c, d] = [at(0, 0), at(1, 0), at(1, 1), at(0, 1)];
                // Triangles with a common side never begin at the same vertex: their colours differ.
                [[a, b, c], [c, d, a]]
            });
        let colours = (1..=rings * quads).map(|vertex| {
            let [r, g, b, _] = vertex.wrapping_mul(0x9e37_79b1).to_be_bytes();
            [r, g, b, 255]
        });
        Self {
            positions: positions.collect(),
            triangles: triangles.collect(),
            colours: colours.collect(),
            to_clip: to_clip(),
        }
    }

    pub fn positions_f32(&self) -> impl Iterator<Item = [f32; 3]> {
        self.positions.iter().map(|p| p.as_vec3().to_array())
    }

    /// One for each triangle.
    pub fn triangle_colours(&self) -> impl Iterator<Item = [u8; 4]> {
        (self.triangles.iter()).filter_map(|&[first, ..]| self.colours.get(first as usize).copied())
    }
}

fn to_clip() -> DMat4 {
    let view = look_at(DVec3::new(1.5, 1.3, 2.55), DVec3::ZERO, DVec3::Y);
    let projection = perspective(PI / 4.0, 1.0, NEAR, FAR);
    match (view, projection) {
        (Ok(view), Ok(projection)) => (projection * view).as_mat4().as_dmat4(),
        // The numbers above make a view; if not, nothing is lit and the row fails.
        _ => DMat4::ZERO,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_mesh_is_as_large_as_the_row_says_and_wholly_in_view() {
        let ball = Ball::new();
        assert_eq!(ball.triangles.len(), 100_352);
        assert_eq!(ball.triangle_colours().count(), 100_352);
        for &p in &ball.positions {
            let p_clip = ball.to_clip * p.extend(1.0);
            assert!(
                p_clip.truncate().abs().max_element() < p_clip.w,
                "{p} is not in view"
            );
        }
    }

    #[test]
    fn every_triangle_faces_outwards() {
        let ball = Ball::new();
        let volume: f64 = (ball.triangles.iter())
            .map(|t| {
                let [a, b, c] = t.map(|v| ball.positions[v as usize]);
                let normal = (b - a).cross(c - a);
                assert!(normal.dot(a) > 0.0, "{t:?}");
                normal.dot(a) / 6.0
            })
            .sum();
        // Of the smooth sphere 4π/3; the bumps are at most 8 % high, up as often as down.
        assert!((volume / (4.0 * PI / 3.0) - 1.0).abs() < 0.03, "{volume}");
    }

    #[test]
    fn triangles_with_a_common_side_have_different_colours() {
        let ball = Ball::of(30);
        let colours: Vec<_> = ball.triangle_colours().collect();
        let mut sides = std::collections::HashMap::new();
        for (&[a, b, c], colour) in ball.triangles.iter().zip(&colours) {
            for (p, q) in [(a, b), (b, c), (c, a)] {
                let neighbour = sides.insert((p.min(q), p.max(q)), colour);
                assert_ne!(neighbour, Some(colour));
            }
        }
    }
}
