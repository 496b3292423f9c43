//! Object space: the visible parts of every primitive, found by comparing each with each.
//!
//! The answer is made of polygons: as sharp at any size of the picture, and fit for a plotter. Its price is k (k − 1)
//! / 2 comparisons for k primitives, whatever the picture.
#![cfg_attr(doc, doc = "")]
#![cfg_attr(doc, doc = include_str!("../figures/object-space-pairs.svg"))]

use ombra_math::glam::{DVec3, DVec4};
use ombra_math::work::{Count, Counter};

use crate::pair::{Pair, Seen, Side, compare_seen, tolerance};
use crate::polygon::Polygon;

/// The visible parts of opaque `polygons` as seen from `eye`, each with the index of the polygon it is a part of.
///
/// w ≠ 0: the eye is at a place. w = 0: a parallel view, the eye infinitely far in that direction.
///
/// # Formula
///
/// ```text
/// for i = 1 … k − 1,  j = i + 1 … k:        the nearer of i and j hides of the other
///     what lies inside the planes through the eye and the edges of the nearer,
///     and, where they cross, beyond its plane
/// ```
///
/// A part is cut at one of those planes after the other; what lies outside it is visible and peeled off, and what
/// remains in the end is hidden.
///
/// # Properties
///
/// - In the order of the polygons; a polygon of which all is visible comes out unchanged, its parts run round as it
///   does.
/// - Each sight line that meets a polygon that is seen meets exactly one part at its inside, that of the nearest; a
///   line within rounding of an edge, or of where an edge would go on, may meet two or none.
/// - Parts lie inside their polygon: their corners are corners of it, or are cut out of its edges and parts, each cut
///   rounding to a few ε of the largest coordinate.
/// - Polygons that touch at an edge or a corner do not cut each other: that is decided exactly.
/// - Where two lie at the same depth (see [`compare`](crate::pair::compare)) the first in the slice is seen.
/// - Where two interpenetrate, a fourth case beside the slide's three, each is cut by the plane of the other.
/// - An edge-on polygon has no visible part and hides nothing, nor does what is no polygon. Without an eye (0, NaN,
///   ∞, a place beyond the largest double) nothing is seen. Both sides of a polygon are seen: leave out
///   [back faces](crate::back_face) first.
///
/// # Pitfalls
///
/// From a place all directions round the eye count, and there is no near plane: what lies behind the back of a camera
/// is in the answer.
///
/// O(k²) is the number of comparisons. The answer itself can grow as k² too: n strips over n strips leave n (n + 2)
/// parts.
///
/// Equal depth within a [`tolerance`] is not transitive: of three sheets, each within it of the next but the last
/// nearer than the first, each is hidden by another, and nothing is seen there.
///
/// Convex parts are not the fewest or the largest ones: a window in the middle of a wall leaves four.
///
/// # Examples
///
/// ```
/// use ombra_hsr::object_space::visible_parts;
/// use ombra_hsr::polygon::Polygon;
/// use ombra_math::glam::{DVec3, DVec4};
///
/// let square = |x: f64, z: f64| {
///     let corners = [(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)];
///     Polygon::new(corners.map(|(i, j)| DVec3::new(x + i, j, z)).to_vec()).unwrap()
/// };
/// // Seen from above, the second covers the right half of the first.
/// let scene = [square(0.0, 0.0), square(1.0, 1.0)];
/// let parts = visible_parts(&scene, DVec4::Z);
/// assert_eq!(parts.len(), 2);
/// assert_eq!((parts[0].0, parts[0].1.area()), (0, 2.0));
/// assert_eq!(parts[1], (1, scene[1].clone()));
/// ```
///
/// # References
///
/// Grafica 3, «Approccio Object-Space».
#[must_use]
pub fn visible_parts(polygons: &[Polygon], eye: DVec4) -> Vec<(usize, Polygon)> {
    visible_parts_counted(polygons, eye, &mut ())
}

/// [`visible_parts`], with its [`Counter::Pairs`] counted: k (k − 1) / 2.
#[must_use]
pub fn visible_parts_counted(
    polygons: &[Polygon],
    eye: DVec4,
    work: &mut impl Count,
) -> Vec<(usize, Polygon)> {
    let mut scene: Vec<Primitive> = polygons.iter().map(|p| Primitive::new(p, eye)).collect();
    let mut rest = scene.as_mut_slice();
    while let Some((first, others)) = rest.split_first_mut() {
        for second in others.iter_mut() {
            work.add(Counter::Pairs, 1);
            first.meet(second);
        }
        rest = others;
    }
    let parts = scene.into_iter().map(|primitive| primitive.parts);
    let numbered = parts.enumerate().flat_map(|(source, parts)| {
        let part = move |vertices| (source, Polygon { vertices });
        parts.into_iter().map(part)
    });
    numbered.collect()
}

/// A polygon, and what is visible of it so far.
struct Primitive {
    seen: Option<Seen>,
    parts: Vec<Vec<DVec3>>,
}

/// What two polygons at one depth get.
#[derive(Clone, Copy, PartialEq)]
enum Tie {
    Seen,
    Hidden,
}

impl Primitive {
    fn new(polygon: &Polygon, eye: DVec4) -> Self {
        let seen = Seen::new(polygon, eye);
        let parts = seen.iter().map(|_| polygon.vertices.clone()).collect();
        Self { seen, parts }
    }

    /// Takes from each what the other hides.
    fn meet(&mut self, second: &mut Self) {
        let (Some(p), Some(q)) = (&self.seen, &second.seen) else {
            return;
        };
        if self.parts.is_empty() && second.parts.is_empty() {
            return;
        }
        match compare_seen(p, q) {
            Pair::Apart => {}
            Pair::FirstNearer | Pair::Coplanar => hide(&mut second.parts, q, p, None),
            Pair::SecondNearer => hide(&mut self.parts, p, q, None),
            Pair::Crossing => {
                hide(&mut self.parts, p, q, Some(Tie::Seen));
                hide(&mut second.parts, q, p, Some(Tie::Hidden));
            }
        }
    }
}

/// Takes from the parts of `of` what `nearer` hides: all that it covers, or what also lies beyond its plane.
fn hide(parts: &mut Vec<Vec<DVec3>>, of: &Seen, nearer: &Seen, beyond: Option<Tie>) {
    let tolerance = tolerance(of.scale().max(nearer.scale()));
    let mut visible = Vec::with_capacity(parts.len());
    for part in parts.drain(..) {
        let peeled = peel(&part, nearer, beyond, tolerance);
        match peeled {
            Some(pieces) => visible.extend(pieces),
            None => visible.push(part),
        }
    }
    *parts = visible;
}

/// The pieces of a part outside the region that `nearer` hides; `None` where nothing of it is hidden.
fn peel(
    part: &[DVec3],
    nearer: &Seen,
    beyond: Option<Tie>,
    tolerance: f64,
) -> Option<Vec<Vec<DVec3>>> {
    // All on or outside one plane: the common case, and no reason to cut at the others.
    let misses = |side: Side| part.iter().all(|&v| side.distance(v) <= tolerance);
    if nearer.sides().any(misses) {
        return None;
    }
    let mut pieces = Vec::new();
    let mut rest = part.to_vec();
    if let Some(tie) = beyond {
        let [before, behind] = nearer.front().split(&rest, tolerance);
        let level = before.is_empty() && behind.is_empty();
        if !level {
            rest = behind;
        } else if tie == Tie::Seen {
            return None;
        }
        pieces.push(before);
    }
    for side in nearer.sides() {
        let [inside, outside] = side.split(&rest, tolerance);
        pieces.push(outside);
        rest = inside;
    }
    pieces.retain(|piece| !piece.is_empty());
    (!rest.is_empty()).then_some(pieces)
}

#[cfg(test)]
mod tests;
