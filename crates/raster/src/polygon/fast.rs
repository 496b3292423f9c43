//! The fast form of the fill: the active edges, carried from row to row.
//!
//! Between two edges lies one run, and the crossings of a few are sorted. Many edges stand in the order of their
//! crossings and take their steps side by side; where some cross, so that a row's columns come out of order, they are
//! marked in a table of one bit a column and read off from left to right, or sorted where that would be more.

mod active;
mod changes;
mod found;
mod marks;
mod row;
mod scan;

use ombra_math::glam::DVec2;
use ombra_math::work::{Count, Counter};

use super::{FillRule, PolygonError, for_each_edge};
use crate::span::Span;

use scan::Scan;

/// The body of [`fill`](super::fill).
pub(super) fn fill<C: Count>(
    contours: &[Vec<DVec2>],
    rule: FillRule,
    width: u32,
    height: u32,
    mut work: C,
) -> Result<impl Iterator<Item = Span> + use<C>, PolygonError> {
    let vertices: usize = contours.iter().map(Vec::len).sum();
    work.add(Counter::Vertices, vertices as u64);
    let mut scan = Scan::new(vertices, rule, width, work);
    for_each_edge(contours, if width == 0 { 0 } else { height }, |edge| {
        scan.add(edge);
    })?;
    scan.sort();
    Ok(scan)
}
