//! The visible parts of a solid's edges.
//!
//! Seen from the eye, an edge and a face are a segment and a triangle of the picture, and over the picture the inverse
//! of the distance along the view is linear: on both sides of every comparison stands a linear function of the place on
//! the edge. So what a face hides of an edge is one interval.

use ombra_math::glam::{DVec2, DVec3};

use super::Solid;
use crate::path::{Path, Rect};
use crate::space::View;

/// A face hides what is behind it by more than this part of the distance; what lies on it is seen.
const ON_IT: f64 = 1e-9;

/// The parts that no face hides, lines of one path.
pub(super) fn visible(view: &View, solid: &Solid) -> Path {
    let faces: Vec<Option<Shown>> = solid
        .faces
        .iter()
        .map(|face| Shown::new(view, face.corners))
        .collect();
    let mut path = Path::new();
    for &[a, b] in &solid.edges {
        let (Some(a), Some(b)) = (place(view, a), place(view, b)) else {
            continue;
        };
        let [from, to] = [a, b].map(DVec3::truncate);
        let bounds = Rect::new(from.min(to), from.max(to));
        let mut hidden: Vec<[f64; 2]> = faces
            .iter()
            .flatten()
            .filter(|face| face.bounds.meets(&bounds))
            .filter_map(|face| face.hides(a, b))
            .collect();
        hidden.sort_by(|a, b| a[0].total_cmp(&b[0]));
        let mut seen = 0.0;
        let at = |t: f64| from.lerp(to, t);
        for [start, end] in hidden.into_iter().chain([[1.0, 1.0]]) {
            if at(start).distance(at(seen)) > SHORTEST && start > seen {
                path.add_polyline(&[at(seen), at(start)]);
            }
            seen = seen.max(end);
        }
    }
    path
}

/// Shorter parts are left out: they are shorter than a line is wide.
const SHORTEST: f64 = 0.05;

/// Where a point appears, and the inverse of its distance along the view.
fn place(view: &View, p: DVec3) -> Option<DVec3> {
    Some(view.project(p)?.extend(1.0 / view.depth(p)))
}

/// A face as it appears.
struct Shown {
    /// Places of its corners, round it in the positive sense.
    corners: [DVec3; 3],
    bounds: Rect,
    /// Twice its area.
    area: f64,
}

impl Shown {
    /// None for a face seen edge-on, which hides nothing.
    fn new(view: &View, corners: [DVec3; 3]) -> Option<Shown> {
        let [a, b, c] = corners.map(|p| place(view, p));
        let (a, b, c) = (a?, b?, c?);
        let area = (b - a).truncate().perp_dot((c - a).truncate());
        let flat = [a, b, c].map(DVec3::truncate);
        let [low, high] = [
            flat[0].min(flat[1]).min(flat[2]),
            flat[0].max(flat[1]).max(flat[2]),
        ];
        let shown = Shown {
            corners: if area < 0.0 { [a, c, b] } else { [a, b, c] },
            bounds: Rect::new(low, high),
            area: area.abs(),
        };
        (shown.area > 0.0).then_some(shown)
    }

    /// Twice the areas of the triangles that a place makes with each side, in the order of the opposite corners.
    fn weights(&self, p: DVec2) -> [f64; 3] {
        let [a, b, c] = self.corners.map(DVec3::truncate);
        [(b, c), (c, a), (a, b)].map(|(from, to)| (to - from).perp_dot(p - from))
    }

    /// By how much the face is nearer than `p`.
    fn nearer(&self, p: DVec3) -> f64 {
        let weights = self.weights(p.truncate());
        let products = weights
            .iter()
            .zip(&self.corners)
            .map(|(w, corner)| w * corner.z);
        products.sum::<f64>() / self.area - p.z * (1.0 + ON_IT)
    }

    /// The interval of the edge from `a` to `b` that the face hides.
    fn hides(&self, a: DVec3, b: DVec3) -> Option<[f64; 2]> {
        let mut interval = [0.0, 1.0];
        let (at_a, at_b) = (self.weights(a.truncate()), self.weights(b.truncate()));
        for (a, b) in at_a.into_iter().zip(at_b) {
            interval = positive(interval, a, b)?;
        }
        // Inside the face its distance is well told; its plane's elsewhere need not be.
        let [start, end] = interval;
        let [first, last] = interval.map(|t| self.nearer(a.lerp(b, t)));
        let [low, high] = positive([0.0, 1.0], first, last)?;
        Some([low, high].map(|t| start + (end - start) * t))
    }
}

/// The part of an interval where a linear function with the values `a` at 0 and `b` at 1 is positive.
fn positive([low, high]: [f64; 2], a: f64, b: f64) -> Option<[f64; 2]> {
    let root = a / (a - b);
    let part = match (a > 0.0, b > 0.0) {
        (true, true) => [low, high],
        (true, false) => [low, high.min(root)],
        (false, true) => [low.max(root), high],
        (false, false) => return None,
    };
    (part[0] < part[1]).then_some(part)
}
