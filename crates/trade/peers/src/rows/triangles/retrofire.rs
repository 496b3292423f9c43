//! retrofire-core with the same flat colour, and with depth alone: both by its own pipeline, the cheapest way that it takes.

use ombra_math::glam::Mat4;
use retrofire_core::geom::{Tri, Vertex, Vertex3, vertex};
use retrofire_core::mat;
use retrofire_core::math::vary::ZDiv;
use retrofire_core::math::{Color4, Lerp, ProjMat3, Vary, pt3};
use retrofire_core::render::clip::ClipVert;
use retrofire_core::render::ctx::FaceCull;
use retrofire_core::render::raster::{Scanline, ScreenPt};
use retrofire_core::render::{
    Colorbuf, Context, Frag, FragmentShader, Framebuf, Model, Ndc, Render, Screen, Target, render,
    shader,
};
use retrofire_core::util::pixfmt::Rgba8888;
use retrofire_core::util::{Dims, MutSlice2};

use super::mesh::Ball;
use super::picture::{BACKGROUND, Drawn, Picture};

pub struct Retrofire {
    vertices: Vec<Vertex3<Flat>>,
    triangles: Vec<Triangle>,
    to_clip: ProjMat3<Model>,
    context: Context,
}

impl Retrofire {
    pub fn new(ball: &Ball, cull: bool) -> Self {
        let vertices = (ball.positions_f32().zip(&ball.colours))
            .map(|([x, y, z], &colour)| vertex(pt3(x, y, z), Flat(colour)));
        let triangles = (ball.triangles.iter()).map(|t| Triangle(t.map(|v| v as usize)));
        Self {
            vertices: vertices.collect(),
            triangles: triangles.collect(),
            to_clip: ProjMat3::new(rows(ball.to_clip.as_mat4())),
            context: Context {
                face_cull: cull.then_some(FaceCull::Back),
                ..Context::default()
            },
        }
    }

    pub fn draw(&self, picture: &mut Picture) {
        picture.drawn = Drawn::InverseW;
        picture.depth.fill(0.0);
        let dims = Dims(picture.size, picture.size);
        let half = 0.5 * picture.size as f32;
        let to_screen = mat![
            half,   0.0, 0.0, half;
             0.0, -half, 0.0, half;
             0.0,   0.0, 1.0,  0.0;
             0.0,   0.0, 0.0,  1.0;
        ];
        let shader = shader::new(
            |v: Vertex3<Flat>, to_clip: &ProjMat3<Model>| vertex(to_clip.apply(&v.pos), v.attrib),
            |frag: Frag<Flat>, _: &ProjMat3<Model>| -> Option<Color4> { Some(frag.var.0.into()) },
        );
        let (triangles, vertices) = (&self.triangles, &self.vertices);
        if picture.colour.is_empty() {
            let mut target = DepthOnly {
                depths: &mut picture.depth,
                size: picture.size as usize,
            };
            let context = &self.context;
            render(
                triangles,
                vertices,
                &shader,
                &self.to_clip,
                to_screen,
                &mut target,
                context,
            );
        } else {
            let (pixels, _) = picture.colour.as_chunks_mut::<4>();
            pixels.fill(BACKGROUND);
            let color_buf = Colorbuf {
                buf: MutSlice2::new(dims, picture.size, pixels),
                fmt: Rgba8888,
            };
            let depth_buf = MutSlice2::new(dims, picture.size, &mut picture.depth);
            let mut target = Framebuf {
                color_buf,
                depth_buf,
            };
            let context = &self.context;
            render(
                triangles,
                vertices,
                &shader,
                &self.to_clip,
                to_screen,
                &mut target,
                context,
            );
        }
    }
}

fn rows(m: Mat4) -> [[f32; 4]; 4] {
    m.transpose().to_cols_array_2d()
}

/// A colour that is the same all over a triangle: nothing to interpolate.
#[derive(Clone, Copy, Debug)]
struct Flat([u8; 4]);

impl Lerp for Flat {
    fn lerp(&self, _: &Self, _: f32) -> Self {
        *self
    }
}

impl ZDiv for Flat {}

impl Vary for Flat {
    type Iter = std::iter::RepeatN<Self>;
    type Diff = ();

    fn vary(self, (): (), n: Option<u32>) -> Self::Iter {
        std::iter::repeat_n(self, n.map_or(usize::MAX, |n| n as usize))
    }

    fn dv_dt(&self, _: &Self, _: f32) {}

    fn step(&self, (): &()) -> Self {
        *self
    }
}

/// Its triangle, but with the colour of the first vertex at all three.
#[derive(Clone, Copy)]
struct Triangle([usize; 3]);

impl Render<Flat> for Triangle {
    type Clip = Tri<ClipVert<Flat>>;
    type Clips = [Tri<ClipVert<Flat>>];
    type Screen = Tri<Vertex<ScreenPt, Flat>>;

    fn inline(Self(corners): Self, vertices: &[ClipVert<Flat>]) -> Self::Clip {
        let Tri([a, mut b, mut c]) = Tri::<usize>::inline(Tri(corners), vertices);
        (b.attrib, c.attrib) = (a.attrib, a.attrib);
        Tri([a, b, c])
    }

    fn is_backface(triangle: &Self::Screen) -> bool {
        // Its rows run upwards, ours downwards.
        !<Tri<usize> as Render<Flat>>::is_backface(triangle)
    }

    fn to_screen(
        clip: Self::Clip,
        to_screen: &retrofire_core::math::Mat4<Ndc, Screen>,
    ) -> Self::Screen {
        <Tri<usize> as Render<Flat>>::to_screen(clip, to_screen)
    }

    fn rasterize<F: FnMut(Scanline<Flat>)>(triangle: Self::Screen, line: F) {
        <Tri<usize> as Render<Flat>>::rasterize(triangle, line);
    }
}

/// Its framebuffer without the colour.
struct DepthOnly<'a> {
    depths: &'a mut [f32],
    size: usize,
}

impl Target for DepthOnly<'_> {
    fn rasterize<V: Vary, U: Copy, Fs: FragmentShader<V, U>>(
        &mut self,
        mut line: Scanline<V>,
        _: &Fs,
        _: U,
        context: &Context,
    ) {
        let row = line.y * self.size;
        let span = row + line.xs.start..row + line.xs.end.max(line.xs.start);
        let depths = self.depths.get_mut(span);
        for (fragment, depth) in line.fragments().zip(depths.into_iter().flatten()) {
            if context.depth_test(fragment.pos.z(), *depth) {
                *depth = fragment.pos.z();
            }
        }
    }
}
