//! The loop on several pixels at a time, in some rows of the picture.

use core::ops::Range;

use fearless_simd::{Select, Simd, SimdBase, SimdFloat, SimdMask, dispatch, f64x4, mask64x4};
use ombra_math::work::{Count, Counter};
use ombra_raster::depth_format::DepthFormat;
use ombra_raster::triangle_setup::{Corner, Cull, Line, Setup};

use crate::z_buffer::paint::{LANES, Paint};
use crate::z_buffer::projected::{Pieces, Projected, Weights};

/// In triangles wider than this, rows begin and end near the sides.
const WIDE: usize = 8 * LANES;

/// Some rows of the buffers.
pub(in crate::z_buffer) struct Band<'a, F: DepthFormat, I: Paint> {
    pub(in crate::z_buffer) rows: Range<u32>,
    pub(in crate::z_buffer) width: u32,
    pub(in crate::z_buffer) depth: &'a mut [F::Stored],
    pub(in crate::z_buffer) samples: &'a mut [I::Sample],
}

/// A triangle about to be drawn.
struct Ready<'a, Ink> {
    setup: Setup<'a>,
    lines: [Line; 3],
    columns: Range<u32>,
    rows: Range<u32>,
    ink: Ink,
}

impl<F: DepthFormat, I: Paint> Band<'_, F, I> {
    /// Bands of `rows` rows each, from the top; the last may have fewer.
    #[cfg(feature = "parallel")]
    pub(in crate::z_buffer) fn split(self, rows: usize) -> impl Iterator<Item = Self> {
        let pixels = rows * self.width as usize;
        let channels = self
            .samples
            .len()
            .checked_div(self.depth.len())
            .unwrap_or(0);
        let (mut depth, mut samples) = (self.depth, self.samples);
        let (end, width) = (self.rows.end, self.width);
        self.rows.step_by(rows).map(move |start| {
            let at = pixels.min(depth.len());
            let (band_depth, rest) = core::mem::take(&mut depth).split_at_mut(at);
            depth = rest;
            let at = (pixels * channels).min(samples.len());
            let (band_samples, rest) = core::mem::take(&mut samples).split_at_mut(at);
            samples = rest;
            Band {
                rows: start..(start + rows as u32).min(end),
                width,
                depth: band_depth,
                samples: band_samples,
            }
        })
    }

    /// Draws triangles into these rows.
    pub(in crate::z_buffer) fn draw(
        &mut self,
        projected: &Projected<'_>,
        triangles: impl Iterator<Item = usize>,
        cull: Cull,
        paint: I,
        work: &mut impl Count,
    ) {
        dispatch!(projected.level, simd => self.draw_with(simd, projected, triangles, cull, paint, work));
    }

    /// [`Band::draw`], compiled for each set of vector instructions. None of them rounds otherwise than one
    /// multiplication or addition at a time does, so the results are the same on every processor.
    #[inline(always)]
    fn draw_with<S: Simd>(
        &mut self,
        simd: S,
        projected: &Projected<'_>,
        triangles: impl Iterator<Item = usize>,
        cull: Cull,
        paint: I,
        work: &mut impl Count,
    ) {
        let mut fragments = 0;
        let mut cut = Pieces::default();
        for triangle in triangles {
            for (piece, weights) in projected.pieces(triangle, &mut cut, work).iter() {
                let Some(ready) = self.ready(triangle, piece, weights, cull, paint) else {
                    continue;
                };
                fragments += if ready.columns.len() <= WIDE {
                    self.fill::<S, false>(simd, &ready, paint)
                } else {
                    self.fill::<S, true>(simd, &ready, paint)
                };
            }
        }
        work.add(Counter::Fragments, fragments);
        work.add(Counter::DepthTests, fragments);
    }

    /// `None` if no pixel of the band can be in the piece.
    #[inline(always)]
    fn ready<'a>(
        &self,
        triangle: usize,
        piece: [&'a Corner; 3],
        weights: &Weights,
        cull: Cull,
        paint: I,
    ) -> Option<Ready<'a, I::Ink>> {
        let setup = Setup::new(piece, cull)?;
        let [columns, rows] = setup.bounds(self.width, self.rows.end);
        let rows = rows.start.max(self.rows.start)..rows.end;
        if columns.is_empty() || rows.is_empty() {
            return None;
        }
        Some(Ready {
            ink: paint.ink(triangle, weights, &setup)?,
            lines: setup.lines(columns.start, rows.start),
            setup,
            columns,
            rows,
        })
    }

    /// Row after row; in a wide triangle each from one side to the other.
    #[inline(always)]
    fn fill<S: Simd, const WIDE: bool>(
        &mut self,
        simd: S,
        ready: &Ready<'_, I::Ink>,
        paint: I,
    ) -> u64 {
        let Ready {
            lines,
            columns,
            rows,
            ..
        } = ready;
        let ends = RowEnds::new(lines);
        let mut fragments = 0;
        let lanes = f64x4::from_fn(simd, |l| l as f64);
        let [l0, l1, l2] = lines;
        let [d0, d1, d2] = [l0.down, l1.down, l2.down];
        let [a0, a1, a2] = [l0.across, l1.across, l2.across];
        let (mut row0, mut row1, mut row2) = (
            lanes * a0 + l0.first,
            lanes * a1 + l1.first,
            lanes * a2 + l2.first,
        );
        let (depth, samples) = (&mut *self.depth, &mut *self.samples);
        let mut row = (rows.start - self.rows.start) as usize * self.width as usize;
        for _ in rows.clone() {
            let [mut e0, mut e1, mut e2] = [row0, row1, row2];
            let (mut x, mut end) = (columns.start, columns.end);
            if WIDE {
                let span = ends.span([e0[0], e1[0], e2[0]], end - x);
                (x, end) = (columns.start + span.start, columns.start + span.end);
                let skipped = f64::from(span.start);
                e0 += a0 * skipped;
                e1 += a1 * skipped;
                e2 += a2 * skipped;
            }
            while x < end {
                let left = lanes.simd_lt(f64::from(end - x));
                let at = row + x as usize;
                fragments +=
                    block::<S, F, I>(simd, ready, [e0, e1, e2], at, left, paint, depth, samples);
                x += LANES as u32;
                e0 += a0 * LANES as f64;
                e1 += a1 * LANES as f64;
                e2 += a2 * LANES as f64;
            }
            row0 += d0;
            row1 += d1;
            row2 += d2;
            row += self.width as usize;
        }
        fragments
    }
}

/// The pixels from `at` on, those of `left`; how many of them are in.
#[inline(always)]
#[expect(clippy::too_many_arguments, reason = "the state of the innermost loop")]
fn block<S: Simd, F: DepthFormat, I: Paint>(
    simd: S,
    ready: &Ready<'_, I::Ink>,
    [e0, e1, e2]: [f64x4<S>; 3],
    at: usize,
    left: mask64x4<S>,
    paint: I,
    depth: &mut [F::Stored],
    samples: &mut [I::Sample],
) -> u64 {
    let Ready {
        setup, lines, ink, ..
    } = ready;
    let inside =
        left & e0.simd_ge(lines[0].least) & e1.simd_ge(lines[1].least) & e2.simd_ge(lines[2].least);
    let [v0, v1, v2] = setup.values;
    let value = e0 * v0 + e1 * v1 + e2 * v2;
    let value = value.max(setup.least).min(setup.greatest);
    // Outside, a value that is nearer than none.
    let value = inside.select(value, f64x4::splat(simd, F::NEVER));
    let mut stored = [F::FAR; LANES];
    for l in 0..LANES {
        stored[l] = F::encode(value[l]);
    }
    let block = depth.get_mut(at..);
    if let Some(depth) = block.and_then(|depth| depth.first_chunk_mut::<LANES>()) {
        let mut pass = [false; LANES];
        for l in 0..LANES {
            pass[l] = F::is_nearer(stored[l], depth[l]);
        }
        for l in 0..LANES {
            depth[l] = F::nearer(stored[l], depth[l]);
        }
        paint.write_lanes(samples, at, ink, &pass, [e0, e1, e2]);
    } else {
        // The last pixels of the band.
        for l in 0..LANES {
            if let Some(depth) = depth.get_mut(at + l)
                && F::is_nearer(stored[l], *depth)
            {
                *depth = stored[l];
                paint.write(samples, at + l, ink, [e0[l], e1[l], e2[l]]);
            }
        }
    }
    u64::from(inside.to_bitmask().count_ones())
}

/// Where a row begins and ends, found without looking at its pixels.
///
/// ```text
/// e + k across ≥ least
/// k ≥ (least − e) / across on a left side, k ≤ the same on a right one
/// ```
#[derive(Clone, Copy)]
struct RowEnds {
    least: [f64; 3],
    /// 1 / across for left sides and 0 for others, which then begin at 0.
    left: [f64; 3],
    /// 1 / across for right sides and 0 for others, which then end at `beyond`.
    right: [f64; 3],
    beyond: [f64; 3],
}

impl RowEnds {
    #[inline(always)]
    fn new(lines: &[Line; 3]) -> Self {
        let inverse = |line: Line, yes: bool| if yes { 1.0 / line.across } else { 0.0 };
        let beyond = |line: Line| {
            if line.across < 0.0 {
                0.0
            } else {
                f64::from(u32::MAX)
            }
        };
        Self {
            least: lines.map(|line| line.least),
            left: lines.map(|line| inverse(line, line.across > 0.0)),
            right: lines.map(|line| inverse(line, line.across < 0.0)),
            beyond: lines.map(beyond),
        }
    }

    /// The columns that may be in the triangle, of `columns`, where the edge functions begin with `edges`.
    #[inline(always)]
    fn span(&self, edges: [f64; 3], columns: u32) -> Range<u32> {
        let (mut start, mut end) = (0.0, f64::from(columns));
        for (i, e) in edges.into_iter().enumerate() {
            let k = (self.least[i] - e) * self.left[i];
            start = if k > start { k } else { start };
            let k = (self.least[i] - e) * self.right[i] + self.beyond[i];
            end = if k < end { k } else { end };
        }
        // A column to spare for rounding; as it goes to u32, a number below 0 becomes 0.
        let end = columns.min((end + 2.0) as u32);
        ((start - 1.0) as u32).min(end)..end
    }
}
