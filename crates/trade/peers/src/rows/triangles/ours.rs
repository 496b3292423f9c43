//! Ours.

use image::{ImageBuffer, Rgba};
use ombra_hsr::z_buffer::{self, Colours, Cull, Depth32F, DepthBuffer, DrawError, Options};
use ombra_math::camera::Camera;
use ombra_math::mesh::Mesh;
use ombra_math::view::Viewport;
use rayon::ThreadPool;

use super::Form;
use super::mesh::Ball;
use super::picture::{BACKGROUND, Drawn, Picture};

pub struct Ours<'a> {
    mesh: Mesh,
    camera: Camera,
    colours: Vec<Rgba<u8>>,
    cull: Cull,
    threads: &'a ThreadPool,
}

impl<'a> Ours<'a> {
    pub fn new(ball: &Ball, form: Form, threads: &'a ThreadPool) -> Self {
        Self {
            mesh: Mesh {
                positions: ball.positions.clone(),
                triangles: ball.triangles.clone(),
            },
            camera: Camera {
                view_projection: ball.to_clip,
                viewport: Viewport {
                    width: form.size,
                    height: form.size,
                },
            },
            colours: ball.triangle_colours().map(Rgba).collect(),
            cull: if form.cull { Cull::Back } else { Cull::Nothing },
            threads,
        }
    }

    /// Clears and draws, on all of the threads.
    pub fn draw(&self, picture: &mut Picture) {
        self.threads.install(|| {
            self.clear_and(
                picture,
                |depth| z_buffer::draw_depth(&self.mesh, &self.camera, self.cull, depth),
                |colours, options, image, depth| {
                    z_buffer::draw(&self.mesh, &self.camera, colours, options, image, depth)
                },
            );
        });
    }

    /// The same by the plain form.
    pub fn draw_plain(&self, picture: &mut Picture) {
        self.clear_and(
            picture,
            |depth| {
                let options = Options {
                    cull: self.cull,
                    ..Options::default()
                };
                let (width, height) = depth.dimensions();
                // The plain form writes a colour as well.
                let mut image = ImageBuffer::new(width, height);
                let colours = Colours::One(Rgba(BACKGROUND));
                z_buffer::draw_plain(
                    &self.mesh,
                    &self.camera,
                    colours,
                    options,
                    &mut image,
                    depth,
                    &mut (),
                )
            },
            |colours, options, image, depth| {
                z_buffer::draw_plain(
                    &self.mesh,
                    &self.camera,
                    colours,
                    options,
                    image,
                    depth,
                    &mut (),
                )
            },
        );
    }

    fn clear_and(
        &self,
        picture: &mut Picture,
        draw_depth: impl FnOnce(&mut DepthBuffer<Depth32F>) -> Result<(), DrawError>,
        draw: impl FnOnce(
            Colours<'_, Rgba<u8>>,
            Options,
            &mut ImageBuffer<Rgba<u8>, Vec<u8>>,
            &mut DepthBuffer<Depth32F>,
        ) -> Result<(), DrawError>,
    ) {
        picture.drawn = Drawn::ByOurs;
        let Some(depth) = &mut picture.ours else {
            return;
        };
        depth.clear();
        // A failure shows itself: nothing is lit.
        if picture.colour.is_empty() {
            let _ = draw_depth(depth);
            return;
        }
        picture.colour.as_chunks_mut().0.fill(BACKGROUND);
        let samples = std::mem::take(&mut picture.colour);
        if let Some(mut image) = ImageBuffer::from_raw(picture.size, picture.size, samples) {
            let options = Options {
                cull: self.cull,
                ..Options::default()
            };
            let _ = draw(
                Colours::PerTriangle(&self.colours),
                options,
                &mut image,
                depth,
            );
            picture.colour = image.into_raw();
        }
    }
}
