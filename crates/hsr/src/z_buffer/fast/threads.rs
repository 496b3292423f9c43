//! The fast form on several threads: the picture in bands of rows, each drawn by one thread.
//!
//! A band gets its triangles in the order in which they were submitted, so every pixel sees the same tests in the same
//! order as on one thread.

use rayon::prelude::*;

use ombra_raster::depth_format::DepthFormat;
use ombra_raster::triangle_setup::Cull;

use super::band::Band;
use crate::z_buffer::paint::Paint;
use crate::z_buffer::projected::Projected;

/// Triangles that a thread sorts into bands at a time.
const CHUNK: usize = 8192;
/// Bands for each thread, so that none waits long for the last.
const BANDS: usize = 8;
/// Rows of a band at least: a triangle that crosses from one to the next is set up twice.
const ROWS: usize = 16;

/// Places in the lists of a batch at most: 32 MiB of them, however many triangles there are and however tall.
const PLACES: usize = 1 << 24;

/// How many triangles are sorted into `bands` at once.
fn batch(bands: usize) -> usize {
    let chunks = PLACES / CHUNK / bands.max(1);
    chunks.max(1) * CHUNK
}

/// Draws the whole mesh into `whole`, on `threads` threads.
pub(super) fn draw<F: DepthFormat, I: Paint>(
    projected: &Projected<'_>,
    cull: Cull,
    paint: I,
    whole: Band<'_, F, I>,
    threads: usize,
) {
    let rows = (whole.rows.len().div_ceil(threads * BANDS)).max(ROWS);
    let batch = batch(whole.rows.len().div_ceil(rows));
    draw_bands(projected, cull, paint, whole, rows, batch);
}

/// [`draw`] in bands of `rows` rows, `batch` triangles at a time.
pub(in crate::z_buffer) fn draw_bands<F: DepthFormat, I: Paint>(
    projected: &Projected<'_>,
    cull: Cull,
    paint: I,
    whole: Band<'_, F, I>,
    rows: usize,
    batch: usize,
) {
    let height = whole.rows.end;
    let mut bands: Vec<_> = whole.split(rows).collect();
    let count = bands.len();
    let expected = projected.triangles.len().min(CHUNK) / count.max(1);
    for (number, triangles) in projected.triangles.chunks(batch).enumerate() {
        // For each chunk of triangles, for each band: which of them are in it, counted from the chunk's first.
        let bins_of = |triangles: &[[u32; 3]]| {
            let mut bins: Vec<_> = (0..count).map(|_| Vec::with_capacity(expected)).collect();
            for (i, triangle) in (0u16..).zip(triangles) {
                let reach = projected.rows(triangle, height);
                let first = reach.start as usize / rows;
                let end = (reach.end as usize).div_ceil(rows);
                for bin in bins.iter_mut().take(end).skip(first) {
                    bin.push(i);
                }
            }
            bins
        };
        let chunks: Vec<Vec<Vec<u16>>> = triangles.par_chunks(CHUNK).map(bins_of).collect();
        let starts = (number * batch..).step_by(CHUNK);
        bands.par_iter_mut().enumerate().for_each(|(b, band)| {
            let bins = starts.clone().zip(&chunks);
            let numbers = bins.flat_map(|(start, bins)| {
                let bin = bins.get(b).map_or(&[][..], Vec::as_slice);
                bin.iter().map(move |&i| start + usize::from(i))
            });
            band.draw(projected, numbers, cull, paint, &mut ());
        });
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every triangle in every band, on any machine: a picture has 2¹⁵ rows at most.
    #[test]
    fn lists_are_bounded() {
        for bands in 0..=crate::z_buffer::MAX_SIDE as usize / ROWS {
            let batch = batch(bands);
            assert!(batch * bands <= PLACES && batch.is_multiple_of(CHUNK) && batch > 0);
        }
        const { assert!(CHUNK <= 1 << u16::BITS) };
        // Few bands: a million triangles at once.
        assert_eq!(batch(16), 1 << 20);
    }
}
