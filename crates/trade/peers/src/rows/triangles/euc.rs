//! euc with the same flat colour, and with depth alone.

use ::euc::rasterizer::{BackfaceCullingDisabled, BackfaceCullingEnabled, BackfaceMode, Triangles};
use ::euc::{Interpolate, Pipeline, Target};
use ombra_math::glam::{Mat4, Vec3};

use super::euc_buffers::{BACKGROUND, Buffers, FARTHEST};
use super::mesh::Ball;
use super::picture::{Drawn, Picture};

pub struct Euc {
    positions: Vec<Vec3>,
    /// Its form of indices: one a corner, here with the colour of its triangle.
    corners: Vec<Corner>,
    to_clip: Mat4,
}

#[derive(Clone, Copy)]
struct Corner {
    vertex: u32,
    colour: [u8; 4],
}

impl Euc {
    pub fn new(ball: &Ball) -> Self {
        let corners = (ball.triangles.iter().zip(ball.triangle_colours()))
            .flat_map(|(triangle, colour)| triangle.map(|vertex| Corner { vertex, colour }));
        Self {
            positions: ball.positions.iter().map(|p| p.as_vec3()).collect(),
            corners: corners.collect(),
            to_clip: ball.to_clip.as_mat4(),
        }
    }

    pub fn draw(&self, picture: &mut Picture, cull: bool) {
        if cull {
            self.draw_sides::<BackfaceCullingEnabled>(picture);
        } else {
            self.draw_sides::<BackfaceCullingDisabled>(picture);
        }
    }

    fn draw_sides<Sides: BackfaceMode>(&self, picture: &mut Picture) {
        picture.drawn = Drawn::ByEuc;
        let Some(Buffers {
            colour,
            depth,
            none,
        }) = &mut picture.euc
        else {
            return;
        };
        depth.clear(FARTHEST);
        if picture.colour.is_empty() {
            let pipeline = DepthOnly(self);
            pipeline.draw::<Triangles<_, Sides>, _>(&self.corners, none, Some(depth));
        } else {
            colour.clear(BACKGROUND);
            let pipeline = Coloured(self);
            pipeline.draw::<Triangles<_, Sides>, _>(&self.corners, colour, Some(depth));
        }
    }

    fn to_clip(&self, corner: &Corner) -> [f32; 4] {
        let position = self.positions.get(corner.vertex as usize);
        let position = position.copied().unwrap_or_default();
        (self.to_clip * position.extend(1.0)).to_array()
    }
}

struct Coloured<'a>(&'a Euc);

impl Pipeline for Coloured<'_> {
    type Vertex = Corner;
    type VsOut = Flat;
    type Pixel = [u8; 4];

    fn vert(&self, corner: &Corner) -> ([f32; 4], Flat) {
        (self.0.to_clip(corner), Flat(corner.colour))
    }

    fn frag(&self, colour: &Flat) -> [u8; 4] {
        colour.0
    }
}

struct DepthOnly<'a>(&'a Euc);

impl Pipeline for DepthOnly<'_> {
    type Vertex = Corner;
    type VsOut = ();
    type Pixel = ();

    fn vert(&self, corner: &Corner) -> ([f32; 4], ()) {
        (self.0.to_clip(corner), ())
    }

    fn frag(&self, (): &()) {}
}

/// A colour that is the same all over a triangle: nothing to interpolate.
#[derive(Clone, Copy)]
struct Flat([u8; 4]);

impl Interpolate for Flat {
    fn lerp2(a: Self, _: Self, _: f32, _: f32) -> Self {
        a
    }

    fn lerp3(a: Self, _: Self, _: Self, _: f32, _: f32, _: f32) -> Self {
        a
    }
}
