//! The z-buffer as the lecture has it: triangle after triangle, pixel after pixel.

use ombra_math::work::{Count, Counter};

use super::Cull;
use super::format::DepthFormat;
use super::paint::Paint;
use super::screen::{Pieces, Scene};
use super::setup::Setup;

/// Draws all triangles into `depth` and `samples`, of `width` × `height` pixels.
pub(super) fn draw<F: DepthFormat, I: Paint>(
    scene: &Scene<'_>,
    cull: Cull,
    paint: I,
    (width, height): (u32, u32),
    depth: &mut [F::Stored],
    samples: &mut [I::Sample],
    work: &mut impl Count,
) {
    let mut cut = Pieces::default();
    for triangle in 0..scene.triangles.len() {
        let mut fragments = 0;
        for (piece, weights) in scene.pieces(triangle, &mut cut, work).iter() {
            let Some(setup) = Setup::new(piece, cull) else {
                continue;
            };
            let Some(ink) = paint.ink(triangle, weights, &setup) else {
                continue;
            };
            let [columns, rows] = setup.bounds(width, height);
            for y in rows {
                for x in columns.clone() {
                    let Some(edges) = setup.edges_at(x, y) else {
                        continue;
                    };
                    fragments += 1;
                    let i = y as usize * width as usize + x as usize;
                    let Some(current) = depth.get_mut(i) else {
                        continue;
                    };
                    // The slide's test: nearer than what is there? Then it takes its place.
                    let z = F::encode(setup.value(edges));
                    if F::is_nearer(z, *current) {
                        *current = z;
                        paint.write(samples, i, &ink, edges);
                    }
                }
            }
        }
        work.add(Counter::Fragments, fragments);
        work.add(Counter::DepthTests, fragments);
    }
}
