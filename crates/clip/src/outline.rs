//! A closed outline as it is put together.

use ombra_math::glam::DVec2;

use crate::cohen_sutherland::{Outcode, outcode};
use crate::window::Window;

/// The vertices of a polygon, one after another.
#[derive(Default)]
pub(crate) struct Outline {
    pub(crate) points: Vec<DVec2>,
    /// Among so many at the start, none follows itself.
    settled: usize,
}

impl Outline {
    pub(crate) const fn of(points: Vec<DVec2>) -> Self {
        Self { points, settled: 0 }
    }

    /// Whether none follows itself, for certain.
    #[inline(always)]
    pub(crate) fn is_settled(&self) -> bool {
        self.settled == self.points.len()
    }

    /// Appends vertices; `new` if none of them equals the one before it.
    #[inline(always)]
    pub(crate) fn append(&mut self, vertices: &[DVec2], new: bool) {
        let settled = new && self.is_settled();
        self.points.extend_from_slice(vertices);
        if settled {
            self.settled = self.points.len();
        }
    }

    /// Takes out vertices that follow themselves.
    pub(crate) fn settle(&mut self) {
        let mut kept = self.settled.saturating_sub(1);
        let tail = self.points.get(kept..).unwrap_or_default();
        let next = tail.get(1..).unwrap_or_default();
        // Seldom; to look is faster than to move every point onto itself. A difference of doubles is 0 only of equal ones.
        if (tail.iter().zip(next)).any(|(&p, &q)| (p - q).abs().element_sum() == 0.0) {
            for i in kept + 1..self.points.len() {
                if self.points.get(i) != self.points.get(kept) {
                    kept += 1;
                    self.points.swap(kept, i);
                }
            }
            self.points.truncate(kept + 1);
        }
        self.settled = self.points.len();
    }

    /// The polygon; empty if fewer than three vertices are left or all lie along one side of the window.
    pub(crate) fn close(mut self, window: &Window) -> Vec<DVec2> {
        self.settle();
        let mut points = closed(self.points);
        let along_a_side = [
            points.iter().all(|p| p.y == window.max.y),
            points.iter().all(|p| p.y == window.min.y),
            points.iter().all(|p| p.x == window.max.x),
            points.iter().all(|p| p.x == window.min.x),
        ];
        if along_a_side.contains(&true) {
            points.clear();
        }
        points
    }
}

/// A polygon without its first vertex again at the end; empty if fewer than three are left.
pub(crate) fn closed<V: PartialEq>(mut polygon: Vec<V>) -> Vec<V> {
    while polygon.len() > 1 && polygon.first() == polygon.last() {
        polygon.pop();
    }
    if polygon.len() < 3 {
        polygon.clear();
    }
    polygon
}

/// Whether no coordinate is NaN or infinite.
pub(crate) fn is_finite(polygon: &[DVec2]) -> bool {
    // No early end: the whole is a sum that the compiler can take several vertices at a time.
    polygon.iter().fold(true, |all, p| all & p.is_finite())
}

/// How many of the vertices `after` one of the region `code` lie there too, and the region of the next.
#[inline]
pub(crate) fn run(window: &Window, code: Outcode, after: &[DVec2]) -> (usize, Outcode) {
    for (i, &p) in after.iter().enumerate() {
        let next = outcode(window, p);
        if next != code {
            return (i, next);
        }
    }
    (after.len(), code)
}

/// Each vertex with the one before it, the last before the first.
pub(crate) fn edges(polygon: &[DVec2]) -> impl Iterator<Item = (DVec2, DVec2)> {
    let before = polygon.last().into_iter().chain(polygon);
    before.copied().zip(polygon.iter().copied())
}
