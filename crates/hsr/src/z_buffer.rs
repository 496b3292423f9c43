//! The z-buffer: for every pixel a depth, and triangles in any order.
//!
//! A fragment is written where it is nearer than what the pixel holds. [`draw`] takes an indexed mesh all the way: to
//! clip space, clipped at the near plane, the far plane and where pixel coordinates would leave their range, to
//! sub-pixels, to fragments, to the test. The [formats](ombra_raster::depth_format) of depth are types on one code path.
#![cfg_attr(doc, doc = "")]
#![cfg_attr(doc, doc = include_str!("../figures/zbuffer-steps.svg"))]
//!
//! # Which pixels, which depth
//!
//! Corners are snapped to 2⁻⁸ of a pixel; a pixel is a triangle's when its centre is in it, by the top-left rule and
//! exactly, so triangles that share an edge leave no gap, and share no pixel where they lie on opposite sides of it once
//! snapped. The depth there lies between those of the corners and is within 5 roundings of a double of what they make it
//! in the snapped triangle, relative to it: what is stored is that, rounded to the format. Of a triangle that is clipped,
//! the pieces are snapped, each by itself. Snapped, a triangle seen edge-on may have an area, and a pixel or a few along
//! its line; a mesh seen edge-on may fold there, and neighbours overlap.
//!
//! # Order
//!
//! The test is strict, so of equal stored depths the first one drawn stays. Where no stored depths tie, the picture
//! does not depend on the order, unless colours are blended. It never depends on the number of threads or the
//! processor.
#![doc(alias = "hidden surface removal")]
#![doc(alias = "depth buffer")]
#![doc(alias = "depth test")]

mod error;
mod fast;
mod options;
mod paint;
pub mod precision;
mod projected;

use ombra_math::camera::Camera;
use ombra_math::mesh::Mesh;
use ombra_math::work::{Count, Counter};
use ombra_raster::triangle_setup::Setup;

pub use error::{DrawError, MAX_SIDE};
pub use ombra_raster::buffers::{DepthBuffer, Picture};
pub use ombra_raster::depth_format::{Depth16, Depth24, Depth32F, DepthFormat, ReversedDepth32F};
pub use ombra_raster::triangle_setup::{Cull, SUBPIXEL_BITS};
pub use options::{Blend, Colours, Options};
pub use paint::PicturePixel;

use fast::Threads;
use projected::{Pieces, Projected};

/// [`draw`] as the lecture has it: triangle after triangle, pixel after pixel.
///
/// # Formula
///
/// ```text
/// for each primitive, for each pixel (x, y) of its projection:
///     z = its depth there, as the format stores it
///     if z is nearer than depth(x, y):   depth(x, y) = z,  picture(x, y) = its colour
/// ```
///
/// # Errors
///
/// As [`draw`].
///
/// # References
///
/// Grafica 3, «Algoritmo Z-Buffer».
pub fn draw_plain<F: DepthFormat, P: PicturePixel>(
    mesh: &Mesh,
    camera: &Camera,
    colours: Colours<'_, P>,
    options: Options,
    picture: &mut Picture<P>,
    depth: &mut DepthBuffer<F>,
    work: &mut impl Count,
) -> Result<(), DrawError> {
    let sizes = [picture.dimensions(), depth.dimensions()];
    options::check(mesh, camera, &colours, sizes)?;
    let (width, height) = depth.dimensions();
    // Each vertex once: to clip space and into the picture.
    let projected = Projected::new::<F>(mesh, camera, work)?;
    let mut cut = Pieces::default();
    // For each primitive, in any order; what clipping leaves of it may be several triangles.
    for triangle in 0..mesh.triangles.len() {
        for (corners, weights) in projected.pieces(triangle, &mut cut, work).iter() {
            let Some(setup) = Setup::new(corners, options.cull) else {
                continue;
            };
            let Some(ink) = colours.ink(mesh, triangle, weights, &setup) else {
                continue;
            };
            let mut fragments = 0;
            let [columns, rows] = setup.bounds(width, height);
            for y in rows {
                for x in columns.clone() {
                    // For each pixel of its projection: z, the depth of the primitive there.
                    let Some(edges) = setup.edges_at(x, y) else {
                        continue;
                    };
                    let z = F::encode(setup.value(edges));
                    fragments += 1;
                    // Is it nearer than what the buffer holds? Then both are written, depth and colour.
                    if let Some(nearest) = depth.stored_mut(x, y)
                        && F::is_nearer(z, *nearest)
                        && let Some(pixel) = picture.get_pixel_mut_checked(x, y)
                    {
                        *nearest = z;
                        options.blend.write(pixel.channels_mut(), ink.at(edges));
                    }
                }
            }
            work.add(Counter::Fragments, fragments);
            work.add(Counter::DepthTests, fragments);
        }
    }
    Ok(())
}

/// Draws a mesh into a picture and its depth buffer.
///
/// # Properties
///
/// The picture and the depths of [`draw_plain`], bit for bit. With the feature `parallel` on all threads of rayon's
/// current pool, with the same result; beside the buffers that takes 25 bytes a vertex and some 64 MiB at most. Neither is
/// cleared first, so several meshes can be drawn into one picture.
///
/// # Pitfalls
///
/// What the format rounds to the depth of the far plane is not nearer than a cleared buffer, and is not seen. A
/// partially transparent triangle hides what is behind it and is drawn later ([`Blend::Over`]).
///
/// # Errors
///
/// [`DrawError`], before anything is drawn.
///
/// # Examples
///
/// ```
/// use ombra_hsr::z_buffer::{Colours, Depth24, DepthBuffer, Options, draw};
/// use ombra_math::camera::Camera;
/// use ombra_math::glam::{DMat4, DVec3};
/// use ombra_math::mesh::Mesh;
/// use ombra_math::view::Viewport;
/// use ombra_raster::buffers::{self, image::Luma};
///
/// // Two triangles that pass through each other, seen along z: each is nearer on one side.
/// let [a, b] = [0.5, -0.5].map(|z| {
///     [DVec3::new(-1.0, -1.0, z), DVec3::new(1.0, -1.0, -z), DVec3::new(1.0, 1.0, -z), DVec3::new(-1.0, 1.0, z)]
/// });
/// let mesh = Mesh::new([a, b].concat(), vec![[0, 1, 2], [0, 2, 3], [4, 5, 6], [4, 6, 7]]).unwrap();
/// let camera = Camera { view_projection: DMat4::IDENTITY, viewport: Viewport { width: 6, height: 1 } };
/// let mut picture = buffers::new(6, 1, Luma([b'.'])).unwrap();
/// let mut depth: DepthBuffer<Depth24> = DepthBuffer::new(6, 1).unwrap();
/// let colours = [b'a', b'a', b'b', b'b'].map(|c| Luma([c]));
/// draw(&mesh, &camera, Colours::PerTriangle(&colours), Options::default(), &mut picture, &mut depth).unwrap();
/// assert_eq!(picture.as_raw(), b"bbbaaa");
/// ```
///
/// # References
///
/// Grafica 3, «Algoritmo Z-Buffer».
pub fn draw<F: DepthFormat, P: PicturePixel>(
    mesh: &Mesh,
    camera: &Camera,
    colours: Colours<'_, P>,
    options: Options,
    picture: &mut Picture<P>,
    depth: &mut DepthBuffer<F>,
) -> Result<(), DrawError> {
    let target = (picture, depth);
    fast::drawn(
        mesh,
        camera,
        colours,
        options,
        target,
        Threads::All,
        &mut (),
    )
}

/// Draws the depths of a mesh and no colour: a shadow map.
///
/// # Properties
///
/// The depths of [`draw_plain`], bit for bit.
///
/// # Errors
///
/// As [`draw`].
///
/// # References
///
/// Grafica 3, «Algoritmo Z-Buffer».
pub fn draw_depth<F: DepthFormat>(
    mesh: &Mesh,
    camera: &Camera,
    cull: Cull,
    depth: &mut DepthBuffer<F>,
) -> Result<(), DrawError> {
    fast::depth_drawn(mesh, camera, cull, depth, Threads::All, &mut ())
}

/// [`draw`] and [`draw_depth`] on one thread, with the same answers, counting their work: the vertices transformed and
/// made by clipping, the fragments and the depth tests. The counter comes last.
pub mod counted {
    pub use super::fast::{draw, draw_depth};
}

#[cfg(test)]
mod tests;
