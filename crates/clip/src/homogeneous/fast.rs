//! Fast form: no pass where all corners lie on the inner side, as most do of most planes.

use ombra_math::work::{Count, Counter};

use super::{Vertex, ViewPlane, cut, is_point, settled};
use crate::sutherland_hodgman::clip_by_plain;

/// [`clip_polygon`](super::clip_polygon), counting its [work](crate#counted-work).
#[must_use]
pub fn clip_polygon<const N: usize>(
    polygon: &[Vertex<N>],
    work: &mut impl Count,
) -> Vec<Vertex<N>> {
    clip_polygon_to(polygon, &ViewPlane::ALL, work)
}

/// [`clip_polygon_to`](super::clip_polygon_to), counting its [work](crate#counted-work).
#[must_use]
pub fn clip_polygon_to<const N: usize>(
    polygon: &[Vertex<N>],
    planes: &[ViewPlane],
    work: &mut impl Count,
) -> Vec<Vertex<N>> {
    if polygon.len() < 3 || !polygon.iter().all(|v| is_point(v.position)) {
        return Vec::new();
    }
    let mut clipped = polygon.to_vec();
    for &plane in planes {
        let side = |v: Vertex<N>| plane.side(v.position);
        let outside = clipped.iter().position(|&v| side(v) < 0.0);
        let inside = outside.unwrap_or(clipped.len());
        work.add(Counter::Comparisons, clipped.len().min(inside + 1) as u64);
        if inside == clipped.len() {
            work.add(Counter::Vertices, inside as u64);
            continue;
        }
        clipped = clip_by_plain(&clipped, side, |a, b, _, _| cut(plane, a, b), work);
    }
    settled(clipped)
}
