//! The rows of a triangle: one run in each, between the two sides that cross it.

use ombra_math::glam::DVec2;
use ombra_math::work::{Count, Counter};

use super::error::{TriangleError, check};
use crate::edge::Edge;
use crate::span::Span;
use crate::step::{Steps, hull};

/// The body of [`cover`](super::cover).
pub(super) fn cover<C: Count>(
    triangle: [DVec2; 3],
    width: u32,
    height: u32,
    mut work: C,
) -> Result<impl Iterator<Item = Span> + use<C>, TriangleError> {
    check(triangle)?;
    work.add(Counter::Vertices, 3);
    let [a, b, c] = triangle;
    let height = if width == 0 { 0 } else { height };
    // Every row that one side crosses, exactly one other crosses too.
    let sides = [(a, b), (b, c), (c, a)].map(|(from, to)| {
        Edge::new(from, to, height).map(|edge| {
            work.add(Counter::EdgeRecords, 1);
            let steps = Steps::new(&edge, width);
            (edge, steps)
        })
    });
    // Pixels are left of one side and right of another.
    let [mut not_left, mut not_right] = [0..0, 0..0];
    for (edge, steps) in sides.iter().flatten() {
        let [left, right] = steps.beside(edge);
        (not_left, not_right) = (hull(&not_left, &left), hull(&not_right, &right));
    }
    let rows = not_left.start.max(not_right.start)..not_left.end.min(not_right.end);
    Ok(rows.filter_map(move |y| {
        let mut columns = sides
            .iter()
            .flatten()
            .filter(|(edge, _)| edge.rows.contains(&y))
            .map(|(edge, steps)| {
                work.add(Counter::EdgeRecords, 1);
                steps.column(edge, y, width, &mut work)
            });
        let (first, second) = (columns.next()?, columns.next()?);
        let span = Span {
            y,
            x: first.min(second)..first.max(second),
        };
        work.add(Counter::Fragments, u64::from(span.len()));
        (!span.is_empty()).then_some(span)
    }))
}
