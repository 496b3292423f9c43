//! A closed outline as it is put together: no vertex follows itself.

use ombra_math::glam::DVec2;

use crate::cohen_sutherland::{Outcode, outcode};
use crate::window::Window;

/// The vertices of a polygon, one after another.
#[derive(Default)]
pub(crate) struct Outline {
    points: Vec<DVec2>,
}

impl Outline {
    pub(crate) fn with_capacity(vertices: usize) -> Self {
        Self {
            points: Vec::with_capacity(vertices),
        }
    }

    /// Appends a vertex, unless it is where the last one is.
    pub(crate) fn put(&mut self, p: DVec2) {
        if self.points.last() != Some(&p) {
            self.points.push(p);
        }
    }

    /// Appends vertices of which none equals its neighbour.
    pub(crate) fn extend(&mut self, points: &[DVec2]) {
        if let Some((&first, rest)) = points.split_first() {
            self.put(first);
            self.points.extend_from_slice(rest);
        }
    }

    /// The polygon; empty if fewer than three vertices are left or all lie along one side of the window.
    pub(crate) fn close(mut self, window: &Window) -> Vec<DVec2> {
        while self.points.len() > 1 && self.points.first() == self.points.last() {
            self.points.pop();
        }
        let along_a_side = [
            self.points.iter().all(|p| p.y == window.max.y),
            self.points.iter().all(|p| p.y == window.min.y),
            self.points.iter().all(|p| p.x == window.max.x),
            self.points.iter().all(|p| p.x == window.min.x),
        ];
        if self.points.len() < 3 || along_a_side.contains(&true) {
            self.points.clear();
        }
        self.points
    }
}

/// Whether no coordinate is NaN or infinite.
pub(crate) fn is_finite(polygon: &[DVec2]) -> bool {
    // No early end: the whole is a sum that the compiler can take several vertices at a time.
    polygon.iter().fold(true, |all, p| all & p.is_finite())
}

/// How many of the vertices after `p` lie in the same region; inside, up to one that repeats the one before.
pub(crate) fn length_of_run(window: &Window, p: DVec2, code: Outcode, after: &[DVec2]) -> usize {
    let mut before = p;
    let mut in_run = |&q: &DVec2| {
        let go_on = outcode(window, q) == code && (q != before || !code.is_inside());
        before = q;
        go_on
    };
    after.iter().position(|q| !in_run(q)).unwrap_or(after.len())
}

/// Each vertex with the one before it, the last before the first.
pub(crate) fn edges(polygon: &[DVec2]) -> impl Iterator<Item = (DVec2, DVec2)> {
    let before = polygon.last().into_iter().chain(polygon);
    before.copied().zip(polygon.iter().copied())
}
