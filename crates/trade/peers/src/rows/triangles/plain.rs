//! What one would write in an hour: each pixel of each triangle's bounding box is tried, in f32, one after the other.

use ombra_math::glam::{Mat4, Vec3, Vec3Swizzles};

use super::mesh::Ball;
use super::picture::{BACKGROUND, FARTHEST, Picture};

pub struct Plain<'a> {
    triangles: &'a [[u32; 3]],
    colours: Vec<[u8; 4]>,
    positions: Vec<Vec3>,
    to_clip: Mat4,
    cull: bool,
}

impl<'a> Plain<'a> {
    pub fn new(ball: &'a Ball, cull: bool) -> Self {
        Self {
            triangles: &ball.triangles,
            colours: ball.triangle_colours().collect(),
            positions: ball.positions.iter().map(|p| p.as_vec3()).collect(),
            to_clip: ball.to_clip.as_mat4(),
            cull,
        }
    }

    /// Clears and draws. The mesh must lie within the view volume.
    pub fn draw(&self, picture: &mut Picture) {
        let (pixels, _) = picture.colour.as_chunks_mut::<4>();
        pixels.fill(BACKGROUND);
        picture.depth.fill(FARTHEST);
        let half = 0.5 * picture.size as f32;
        let corners: Vec<Vec3> = (self.positions.iter())
            .map(|position| {
                let ndc = self.to_clip.project_point3(*position);
                Vec3::new(
                    (1.0 + ndc.x) * half,
                    (1.0 - ndc.y) * half,
                    0.5 + 0.5 * ndc.z,
                )
            })
            .collect();
        for (triangle, &colour) in self.triangles.iter().zip(&self.colours) {
            let [Some(&a), Some(&b), Some(&c)] = triangle.map(|v| corners.get(v as usize)) else {
                continue;
            };
            // y runs down: counter-clockwise, as a front is seen, is negative.
            let area = (b - a).xy().perp_dot((c - a).xy());
            let corners = if area < 0.0 { [a, c, b] } else { [a, b, c] };
            if area != 0.0 && !(self.cull && area > 0.0) {
                fill(
                    corners,
                    area.abs(),
                    colour,
                    picture.size,
                    pixels,
                    &mut picture.depth,
                );
            }
        }
    }
}

fn fill(
    [a, b, c]: [Vec3; 3],
    area: f32,
    colour: [u8; 4],
    size: u32,
    pixels: &mut [[u8; 4]],
    depths: &mut [f32],
) {
    // The pixels whose centres may be in.
    let low = a.min(b).min(c).xy() - 0.5;
    let high = a.max(b).max(c).xy() + 0.5;
    let [left, top] = [low.x, low.y].map(|v| v.ceil().max(0.0) as usize);
    let [right, bottom] = [high.x, high.y].map(|v| v.floor().min(size as f32) as usize);
    // Corners as seen from the centre of the first of them.
    let origin = Vec3::new(left as f32 + 0.5, top as f32 + 0.5, 0.0);
    let [a, b, c] = [a, b, c].map(|corner| corner - origin);
    let edges = [(a, b), (b, c), (c, a)].map(|(from, to)| {
        let along = to - from;
        let is_top_left = along.y < 0.0 || (along.y == 0.0 && along.x > 0.0);
        (-along.y, along.x, from.xy().perp_dot(to.xy()), is_top_left)
    });
    let (u, v) = (b - a, c - a);
    let dz_dx = (u.z * v.y - v.z * u.y) / area;
    let dz_dy = (v.z * u.x - u.z * v.x) / area;
    let z = a.z - dz_dx * a.x - dz_dy * a.y;
    for (y, row) in (top..bottom).zip(0_u16..) {
        let start = y * size as usize;
        let run = start + left..start + right.max(left);
        let Some(depths) = depths.get_mut(run.clone()) else {
            return;
        };
        let y = f32::from(row);
        for ((i, depth), column) in run.zip(depths).zip(0_u16..) {
            let x = f32::from(column);
            let is_in = edges.iter().all(|&(dx, dy, constant, is_top_left)| {
                let side = dx * x + dy * y + constant;
                side > 0.0 || (side == 0.0 && is_top_left)
            });
            let z = dz_dx * x + dz_dy * y + z;
            if is_in && z < *depth {
                *depth = z;
                // None where depth alone is drawn.
                if let Some(pixel) = pixels.get_mut(i) {
                    *pixel = colour;
                }
            }
        }
    }
}
