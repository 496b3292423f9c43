//! The z-buffer: for every pixel a depth, and triangles in any order.
//!
//! A fragment is written where it is nearer than what the pixel holds. [`draw`] takes an indexed mesh all the way: to
//! clip space, clipped at the near plane, the far plane and where pixel coordinates would leave their range, to
//! sub-pixels, to fragments, to the test. The formats of depth are types ([`Depth16`], [`Depth24`], [`Depth32F`],
//! [`ReversedDepth32F`]) on one code path.
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
#![cfg_attr(doc, doc = "")]
#![cfg_attr(doc, doc = include_str!("../figures/zbuffer-steps.svg"))]

mod buffer;
mod error;
mod fast;
mod format;
mod paint;
mod plain;
pub mod precision;
mod screen;
mod setup;
#[cfg(feature = "parallel")]
mod threads;

use fearless_simd::Level;
use ombra_math::camera::Camera;
use ombra_math::mesh::Mesh;
use ombra_math::work::Count;
use ombra_raster::buffers::image::ImageBuffer;

pub use buffer::DepthBuffer;
pub use error::DrawError;
pub use format::{Depth16, Depth24, Depth32F, DepthFormat, ReversedDepth32F};
pub use paint::PicturePixel;
pub use screen::{MAX_SIDE, SUBPIXEL_BITS};

use fast::Band;
use paint::{DepthOnly, Flat, Paint, Smooth};
use screen::Scene;

/// A picture of pixels `P`.
pub type Picture<P> = ImageBuffer<P, Vec<<P as ombra_raster::buffers::image::Pixel>::Subpixel>>;

/// Pixels that the fast form does at once.
const LANES: usize = 4;

/// Where the colour of a fragment comes from.
///
/// For a picture of triangle numbers, give each triangle its own: `Luma([i])`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Colours<'a, P> {
    /// All triangles have this one.
    One(P),
    /// One for each triangle of the mesh.
    PerTriangle(&'a [P]),
    /// One for each vertex of the mesh, interpolated over the triangle in space, not in the picture. A number that is
    /// NaN or ∞ at a vertex is NaN or ∞ in its triangles.
    PerVertex(&'a [P]),
}

/// Which triangles are left out, by the side from which they are seen.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Cull {
    /// None.
    #[default]
    Nothing,
    /// Those seen from behind: their corners run clockwise in the picture.
    Back,
    /// Those seen from the front.
    Front,
}

/// What a fragment nearer than the pixel's depth does to its colour. Its depth is stored in either case.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Blend {
    /// Takes its place.
    #[default]
    Replace,
    /// Is laid over it, as opaque as its alpha says: then the picture depends on the order of the triangles.
    Over,
}

/// How to draw; the default draws both sides of every triangle, opaque.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Options {
    /// Which triangles are left out.
    pub cull: Cull,
    /// What a fragment does to the colour.
    pub blend: Blend,
}

/// Draws a mesh into a picture and its depth buffer.
///
/// # Formula
///
/// ```text
/// for each triangle, for each pixel (x, y) it owns:
///     z = its depth there, as the format stores it
///     if z is nearer than depth(x, y):   depth(x, y) = z,  picture(x, y) = its colour
/// ```
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
    drawn::<F, P, _>(
        mesh,
        camera,
        colours,
        options,
        target,
        Form::Threads,
        &mut (),
    )
}

/// [`draw`], one pixel after the other: the lecture's loop.
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
) -> Result<(), DrawError> {
    let target = (picture, depth);
    drawn::<F, P, _>(mesh, camera, colours, options, target, Form::Plain, &mut ())
}

/// [`draw`], counting the vertices transformed and made by clipping, the fragments and the depth tests.
///
/// Clipping is also done far outside the picture, where coordinates would leave their range; so the number of vertices
/// depends on the picture's size.
///
/// # Errors
///
/// As [`draw`].
///
/// # References
///
/// Grafica 3, «Algoritmo Z-Buffer»: nearly constant cost, since more primitives are smaller ones.
pub fn draw_counted<F: DepthFormat, P: PicturePixel>(
    mesh: &Mesh,
    camera: &Camera,
    colours: Colours<'_, P>,
    options: Options,
    picture: &mut Picture<P>,
    depth: &mut DepthBuffer<F>,
    work: &mut impl Count,
) -> Result<(), DrawError> {
    let target = (picture, depth);
    drawn::<F, P, _>(mesh, camera, colours, options, target, Form::Fast, work)
}

/// The forms of the z-buffer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Form {
    /// One pixel after the other.
    Plain,
    /// Several at a time.
    Fast,
    /// Several at a time on several threads; nothing is counted.
    Threads,
}

fn drawn<F: DepthFormat, P: PicturePixel, C: Count>(
    mesh: &Mesh,
    camera: &Camera,
    colours: Colours<'_, P>,
    options: Options,
    (picture, depth): (&mut Picture<P>, &mut DepthBuffer<F>),
    form: Form,
    work: &mut C,
) -> Result<(), DrawError> {
    check_size(camera, picture.dimensions())?;
    check_size(camera, depth.dimensions())?;
    colours.check(mesh)?;
    let scene = Scene::new::<F>(mesh, camera, Level::new(), work)?;
    let Options { cull, blend } = options;
    let flat = |colours| Flat { colours, blend };
    let paint = match colours {
        Colours::One(pixel) => flat(Ok(pixel)),
        Colours::PerTriangle(colours) => flat(Err(colours)),
        Colours::PerVertex(colours) => {
            let triangles = &mesh.triangles;
            let paint = Smooth {
                colours,
                triangles,
                blend,
            };
            run::<F, _, _>(&scene, cull, paint, depth, picture, form, work);
            return Ok(());
        }
    };
    run::<F, _, _>(&scene, cull, paint, depth, picture, form, work);
    Ok(())
}

fn run<F: DepthFormat, I: Paint, C: Count>(
    scene: &Scene<'_>,
    cull: Cull,
    paint: I,
    depth: &mut DepthBuffer<F>,
    samples: &mut [I::Sample],
    form: Form,
    work: &mut C,
) {
    let (width, height) = depth.dimensions();
    let depth = depth.values_mut();
    let rows = 0..height;
    let triangles = 0..scene.triangles.len();
    if form == Form::Plain {
        plain::draw::<F, _>(scene, cull, paint, (width, height), depth, samples, work);
        return;
    }
    let mut whole: Band<'_, F, I> = Band {
        rows,
        width,
        depth,
        samples,
    };
    #[cfg(feature = "parallel")]
    if form == Form::Threads {
        let threads = threads::number(triangles.len());
        if threads > 1 {
            threads::draw(scene, cull, paint, whole, threads);
            return;
        }
    }
    whole.draw(scene, triangles, cull, paint, work);
}

/// Draws the depths of a mesh and no colour: a shadow map.
///
/// # Properties
///
/// The depths of [`draw`].
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
    depth_drawn(mesh, camera, cull, depth, Form::Threads, &mut ())
}

/// [`draw_depth`], counted as [`draw_counted`] is.
///
/// # Errors
///
/// As [`draw`].
///
/// # References
///
/// As [`draw_depth`].
pub fn draw_depth_counted<F: DepthFormat>(
    mesh: &Mesh,
    camera: &Camera,
    cull: Cull,
    depth: &mut DepthBuffer<F>,
    work: &mut impl Count,
) -> Result<(), DrawError> {
    depth_drawn(mesh, camera, cull, depth, Form::Fast, work)
}

/// [`draw_depth`] as [`draw_plain`] does it.
///
/// # Errors
///
/// As [`draw`].
///
/// # References
///
/// As [`draw_depth`].
pub fn draw_depth_plain<F: DepthFormat>(
    mesh: &Mesh,
    camera: &Camera,
    cull: Cull,
    depth: &mut DepthBuffer<F>,
) -> Result<(), DrawError> {
    depth_drawn(mesh, camera, cull, depth, Form::Plain, &mut ())
}

fn depth_drawn<F: DepthFormat>(
    mesh: &Mesh,
    camera: &Camera,
    cull: Cull,
    depth: &mut DepthBuffer<F>,
    form: Form,
    work: &mut impl Count,
) -> Result<(), DrawError> {
    check_size(camera, depth.dimensions())?;
    let scene = Scene::new::<F>(mesh, camera, Level::new(), work)?;
    run::<F, _, _>(&scene, cull, DepthOnly, depth, &mut [], form, work);
    Ok(())
}

/// A buffer must have the viewport's size, and one that can be drawn.
fn check_size(camera: &Camera, found: (u32, u32)) -> Result<(), DrawError> {
    let viewport = (camera.viewport.width, camera.viewport.height);
    if found != viewport {
        return Err(DrawError::Size { found, viewport });
    }
    if viewport.0.max(viewport.1) > MAX_SIDE {
        return Err(DrawError::TooLong { size: viewport });
    }
    Ok(())
}

#[cfg(test)]
mod tests;
