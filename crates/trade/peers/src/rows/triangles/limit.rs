//! What no contestant can leave out: clear the picture, read the mesh, write each pixel that is lit once.

use std::hint::black_box;
use std::ops::Range;

use ombra_math::glam::DVec3;
use rayon::ThreadPool;

use super::mesh::Ball;
use super::picture::{BACKGROUND, FARTHEST, Picture};

pub struct Limit<'a> {
    parts: Vec<Part<'a>>,
    threads: &'a ThreadPool,
}

/// What one thread does.
struct Part<'a> {
    positions: &'a [DVec3],
    triangles: &'a [[u32; 3]],
    /// Pixels that are lit, from the first of the part.
    runs: Vec<Range<usize>>,
}

impl<'a> Limit<'a> {
    /// For pictures as this one, whose ideal is known.
    pub fn new(ball: &'a Ball, picture: &Picture, threads: &'a ThreadPool) -> Self {
        let number = threads.current_num_threads().max(1);
        let lit: Vec<bool> = picture.ideally_lit().collect();
        let share = |all: usize| all.div_ceil(number).max(1);
        let parts = (lit.chunks(share(lit.len())))
            .zip(ball.positions.chunks(share(ball.positions.len())))
            .zip(ball.triangles.chunks(share(ball.triangles.len())))
            .map(|((lit, positions), triangles)| Part {
                positions,
                triangles,
                runs: runs(lit),
            });
        Self {
            parts: parts.collect(),
            threads,
        }
    }

    pub fn write(&self, picture: &mut Picture) {
        let share = picture.depth.len().div_ceil(self.parts.len().max(1)).max(1);
        let (pixels, _) = picture.colour.as_chunks_mut::<4>();
        let mut pixels = pixels.chunks_mut(share);
        self.threads.scope(|scope| {
            for (part, depths) in self.parts.iter().zip(picture.depth.chunks_mut(share)) {
                let pixels = pixels.next().unwrap_or_default();
                scope.spawn(|_| part.write(pixels, depths));
            }
        });
    }
}

impl Part<'_> {
    fn write(&self, pixels: &mut [[u8; 4]], depths: &mut [f32]) {
        pixels.fill(BACKGROUND);
        depths.fill(FARTHEST);
        black_box(self.positions.iter().copied().sum::<DVec3>());
        black_box(
            self.triangles
                .as_flattened()
                .iter()
                .fold(0, |all, index| all ^ index),
        );
        for run in &self.runs {
            if let Some(pixels) = pixels.get_mut(run.clone()) {
                pixels.fill([255; 4]);
            }
            if let Some(depths) = depths.get_mut(run.clone()) {
                depths.fill(0.5);
            }
        }
    }
}

/// Where pixels are lit.
fn runs(lit: &[bool]) -> Vec<Range<usize>> {
    let mut runs: Vec<Range<usize>> = Vec::new();
    for (i, _) in lit.iter().enumerate().filter(|(_, lit)| **lit) {
        match runs.last_mut() {
            Some(run) if run.end == i => run.end += 1,
            _ => runs.push(i..i + 1),
        }
    }
    runs
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn runs_are_what_is_lit() {
        assert_eq!(runs(&[true, false, false, true, true]), [0..1, 3..5]);
        assert_eq!(runs(&[false; 3]), []);
        assert_eq!(runs(&[]), []);
    }
}
