//! A closed outline as it is put together: no vertex follows itself.

use ombra_math::glam::DVec2;

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

    /// Appends a whole polygon.
    pub(crate) fn put_all(&mut self, polygon: &[DVec2]) {
        let repeats = |pairs: &[DVec2]| pairs.windows(2).fold(false, |any, p| any | (p[0] == p[1]));
        if repeats(polygon) {
            polygon.iter().for_each(|&p| self.put(p));
        } else {
            self.extend(polygon);
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

/// Whether all vertices lie in the window.
pub(crate) fn is_inside(window: &Window, polygon: &[DVec2]) -> bool {
    let inside = |p: &DVec2| {
        (window.min.x <= p.x)
            & (p.x <= window.max.x)
            & (window.min.y <= p.y)
            & (p.y <= window.max.y)
    };
    // By blocks, as above, but with an end where one is outside.
    let mut blocks = polygon.chunks(64);
    blocks.all(|block| block.iter().fold(true, |all, p| all & inside(p)))
}

/// Each vertex with the one before it, the last before the first.
pub(crate) fn edges(polygon: &[DVec2]) -> impl Iterator<Item = (DVec2, DVec2)> {
    let before = polygon.last().into_iter().chain(polygon);
    before.copied().zip(polygon.iter().copied())
}
