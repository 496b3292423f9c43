//! The fast form on several threads: the picture in bands of rows, each drawn by one thread.
//!
//! A band gets its triangles in the order in which they were submitted, so every pixel sees the same tests in the same
//! order as on one thread.

use rayon::prelude::*;

use super::Cull;
use super::fast::Band;
use super::format::DepthFormat;
use super::paint::Paint;
use super::screen::Scene;

/// Fewer triangles than this are drawn by one thread.
const WORTH_IT: usize = 1024;
/// Triangles that a thread sorts into bands at a time.
const CHUNK: usize = 8192;
/// Bands for each thread, so that none waits long for the last.
const BANDS: usize = 8;
/// Rows of a band at least: a triangle that crosses from one to the next is set up twice.
const ROWS: usize = 16;

/// How many threads to draw `triangles` with.
pub(super) fn number(triangles: usize) -> usize {
    if triangles < WORTH_IT {
        1
    } else {
        rayon::current_num_threads()
    }
}

/// Draws the whole scene into `whole`, on `threads` threads.
pub(super) fn draw<F: DepthFormat, I: Paint>(
    scene: &Scene<'_>,
    cull: Cull,
    paint: I,
    whole: Band<'_, F, I>,
    threads: usize,
) {
    let height = whole.rows.end;
    let rows = (whole.rows.len().div_ceil(threads * BANDS)).max(ROWS);
    let bands: Vec<_> = whole.split(rows).collect();
    let expected = scene
        .triangles
        .len()
        .min(CHUNK)
        .checked_div(bands.len())
        .unwrap_or(0);
    // For each chunk of triangles, for each band: which of them are in it.
    let chunks: Vec<Vec<Vec<usize>>> = scene
        .triangles
        .par_chunks(CHUNK)
        .enumerate()
        .map(|(chunk, triangles)| {
            let mut bins: Vec<_> = bands.iter().map(|_| Vec::with_capacity(expected)).collect();
            for (i, triangle) in (chunk * CHUNK..).zip(triangles) {
                let reach = scene.rows(triangle, height);
                let (first, end) = (
                    reach.start as usize / rows,
                    (reach.end as usize).div_ceil(rows),
                );
                for bin in bins.iter_mut().take(end).skip(first) {
                    bin.push(i);
                }
            }
            bins
        })
        .collect();
    bands.into_par_iter().enumerate().for_each(|(b, mut band)| {
        let bins = chunks.iter().filter_map(|bins| bins.get(b));
        band.draw(scene, bins.flatten().copied(), cull, paint, &mut ());
    });
}
