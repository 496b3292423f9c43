//! A vertex on its way through the sides, for the plain form: what lies where is asked of true points, not rounded ones.

use core::cmp::Ordering;

use ombra_math::glam::DVec2;

use crate::crossing::{compare, cut};
use crate::segment::Segment;
use crate::window::{Line, Side, Window};

#[derive(Clone, Copy)]
pub(super) struct Vertex {
    pub(super) point: DVec2,
    /// For a crossing, the edge and the side that cross there: `point` is only the nearest double.
    crossing: Option<(Segment, Line)>,
    /// The polygon's edge that leads here; none along the border.
    edge: Option<Segment>,
}

impl Vertex {
    /// A vertex of the polygon, after the vertex `before`.
    pub(super) fn new(before: DVec2, point: DVec2) -> Self {
        Self {
            point,
            crossing: None,
            edge: Some(Segment::new(before, point)),
        }
    }

    /// `Greater` on the window's side, `Equal` on the line of the side, `Less` beyond.
    pub(super) fn side(&self, window: &Window, side: Side) -> Ordering {
        let along = |x: f64, limit: f64, of: fn(f64) -> Line| match self.crossing {
            Some((edge, line)) if line.is_vertical() != of(limit).is_vertical() => {
                compare(edge, line, x, limit)
            }
            _ => x.partial_cmp(&limit).unwrap_or(Ordering::Less),
        };
        match side {
            Side::Above => along(self.point.y, window.max.y, Line::Horizontal).reverse(),
            Side::Below => along(self.point.y, window.min.y, Line::Horizontal),
            Side::Right => along(self.point.x, window.max.x, Line::Vertical).reverse(),
            Side::Left => along(self.point.x, window.min.x, Line::Vertical),
        }
    }

    /// The crossing with the line of a side on the way to `v`. It is on v's edge, whatever earlier sides cut from that;
    /// the border crosses at a corner.
    pub(super) fn crossing(&self, v: &Self, line: Line, side: Ordering) -> Self {
        let point = match (v.edge, line) {
            (Some(edge), _) => cut(edge, line),
            (None, Line::Vertical(x)) => DVec2::new(x, self.point.y),
            (None, Line::Horizontal(y)) => DVec2::new(self.point.x, y),
        };
        let crossing = v.edge.map(|edge| (edge, line));
        // Coming back from beyond, the way to where the line is met is the border.
        let edge = if side == Ordering::Less { None } else { v.edge };
        Self {
            point,
            crossing,
            edge,
        }
    }

    /// The vertex after one on `side_before`: on the line it may be where the polygon comes back, along the border.
    pub(super) fn after(self, side_before: Ordering, side: Ordering) -> Self {
        let comes_back = side_before == Ordering::Less && side == Ordering::Equal;
        let edge = if comes_back { None } else { self.edge };
        Self { edge, ..self }
    }
}
