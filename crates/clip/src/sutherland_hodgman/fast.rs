//! Fast form: each vertex passes all four sides at once.

use fearless_simd::{Fallback, Level, Simd, dispatch};
use ombra_math::glam::DVec2;
use ombra_math::work::{Count, Counter};

use crate::cohen_sutherland::outcode;
use crate::outline::is_finite;
use crate::segment::Segment;
use crate::window::Window;

use pipeline::Pipeline;

mod pipeline;

/// [`clip_polygon`](super::clip_polygon), counting its work: see the [crate's page](crate#counted-work).
///
/// # Properties
///
/// A vertex comes to all four sides at once. Only crossings that stay in the answer are computed, a division each.
#[must_use]
pub fn clip_polygon(window: &Window, polygon: &[DVec2], work: &mut impl Count) -> Vec<DVec2> {
    if polygon.len() < MANY {
        return clip_at(None::<Fallback>, window, polygon, work);
    }
    dispatch!(Level::new(), simd => clip_at(Some(simd), window, polygon, work))
}

/// From so many vertices on, vector instructions pay for the choice among them.
const MANY: usize = 64;

/// With vector instructions, compiled for each set of them, or without. All compute the same numbers.
#[inline(always)]
fn clip_at<S: Simd>(
    simd: Option<S>,
    window: &Window,
    polygon: &[DVec2],
    work: &mut impl Count,
) -> Vec<DVec2> {
    let (Some(&first), Some(&last)) = (polygon.first(), polygon.last()) else {
        return Vec::new();
    };
    if !first.is_finite() || !window.has_area() {
        return Vec::new();
    }
    let mut pipeline = Pipeline::new(window, polygon.len());
    let first_code = outcode(window, first);
    work.add(Counter::Vertices, 1);
    work.add(Counter::Comparisons, 4);
    pipeline.start(first, first_code);
    let blocks = match simd {
        Some(simd) => pipeline.blocks(simd, first_code, polygon, work),
        None => Some((first_code, polygon)),
    };
    let Some((code, rest)) = blocks else {
        return Vec::new();
    };
    if !is_finite(rest) {
        return Vec::new();
    }
    let code = pipeline.one_by_one(code, rest, work);
    pipeline.close(Segment::new(last, first), [code, first_code], work)
}
