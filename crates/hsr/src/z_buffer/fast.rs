//! The same loop on several pixels at a time, and on several threads.

mod band;
#[cfg(feature = "parallel")]
mod threads;

use ombra_math::camera::Camera;
use ombra_math::mesh::Mesh;
use ombra_math::work::Count;
use ombra_raster::buffers::{DepthBuffer, Picture};
use ombra_raster::depth_format::DepthFormat;
use ombra_raster::triangle_setup::Cull;

use super::error::{DrawError, check_size};
use super::options::{self, Colours, Options};
use super::paint::{DepthOnly, Flat, Paint, PicturePixel, Smooth};
use super::projected::Projected;
#[cfg(feature = "parallel")]
use super::projected::threads_for;
pub(super) use band::Band;
#[cfg(all(test, feature = "parallel"))]
pub(super) use threads::draw_bands;

/// By how many threads the triangles are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Threads {
    One,
    /// All of rayon's current pool; nothing is counted.
    All,
}

/// [`draw`](super::draw) on one thread, counting the vertices transformed and made by clipping, the fragments and the
/// depth tests.
///
/// Clipping is also done far outside the picture, where coordinates would leave their range; so the number of vertices
/// depends on the picture's size.
///
/// # Errors
///
/// As [`draw`](super::draw).
///
/// # References
///
/// Grafica 3, «Algoritmo Z-Buffer»: nearly constant cost, since more primitives are smaller ones.
pub fn draw<F: DepthFormat, P: PicturePixel>(
    mesh: &Mesh,
    camera: &Camera,
    colours: Colours<'_, P>,
    options: Options,
    picture: &mut Picture<P>,
    depth: &mut DepthBuffer<F>,
    work: &mut impl Count,
) -> Result<(), DrawError> {
    let target = (picture, depth);
    drawn(mesh, camera, colours, options, target, Threads::One, work)
}

/// [`draw_depth`](super::draw_depth) on one thread, counted as [`draw`] is.
///
/// # Errors
///
/// As [`draw`](super::draw).
///
/// # References
///
/// Grafica 3, «Algoritmo Z-Buffer».
pub fn draw_depth<F: DepthFormat>(
    mesh: &Mesh,
    camera: &Camera,
    cull: Cull,
    depth: &mut DepthBuffer<F>,
    work: &mut impl Count,
) -> Result<(), DrawError> {
    depth_drawn(mesh, camera, cull, depth, Threads::One, work)
}

/// Draws on one thread or on all of them.
pub(super) fn drawn<F: DepthFormat, P: PicturePixel>(
    mesh: &Mesh,
    camera: &Camera,
    colours: Colours<'_, P>,
    Options { cull, blend }: Options,
    (picture, depth): (&mut Picture<P>, &mut DepthBuffer<F>),
    threads: Threads,
    work: &mut impl Count,
) -> Result<(), DrawError> {
    let sizes = [picture.dimensions(), depth.dimensions()];
    options::check(mesh, camera, &colours, sizes)?;
    let projected = Projected::new::<F>(mesh, camera, work)?;
    if let Colours::PerVertex(colours) = colours {
        let triangles = &mesh.triangles;
        let paint = Smooth {
            colours,
            triangles,
            blend,
        };
        run(&projected, cull, paint, depth, picture, threads, work);
    } else {
        let paint = Flat { colours, blend };
        run(&projected, cull, paint, depth, picture, threads, work);
    }
    Ok(())
}

/// Draws depths on one thread or on all of them.
pub(super) fn depth_drawn<F: DepthFormat>(
    mesh: &Mesh,
    camera: &Camera,
    cull: Cull,
    depth: &mut DepthBuffer<F>,
    threads: Threads,
    work: &mut impl Count,
) -> Result<(), DrawError> {
    check_size(camera, depth.dimensions())?;
    let projected = Projected::new::<F>(mesh, camera, work)?;
    run(&projected, cull, DepthOnly, depth, &mut [], threads, work);
    Ok(())
}

/// Draws all triangles into `depth` and the picture's `samples`.
pub(super) fn run<F: DepthFormat, I: Paint>(
    projected: &Projected<'_>,
    cull: Cull,
    paint: I,
    depth: &mut DepthBuffer<F>,
    samples: &mut [I::Sample],
    threads: Threads,
    work: &mut impl Count,
) {
    let (width, height) = depth.dimensions();
    let mut whole: Band<'_, F, I> = Band {
        rows: 0..height,
        width,
        depth: depth.values_mut(),
        samples,
    };
    let triangles = 0..projected.triangles.len();
    #[cfg(feature = "parallel")]
    if threads == Threads::All {
        let threads = threads_for(triangles.len());
        if threads > 1 {
            threads::draw(projected, cull, paint, whole, threads);
            return;
        }
    }
    #[cfg(not(feature = "parallel"))]
    let _ = threads;
    whole.draw(projected, triangles, cull, paint, work);
}
