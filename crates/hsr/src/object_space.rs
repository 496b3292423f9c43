//! Object space: the visible parts of every primitive, found by comparing each with each.
//!
//! The answer is made of polygons: as sharp at any size of the picture, and fit for a plotter. Its price is k (k − 1)
//! / 2 comparisons for k primitives, whatever the picture.
#![cfg_attr(doc, doc = "")]
#![cfg_attr(doc, doc = include_str!("../figures/object-space-pairs.svg"))]
#![doc(alias = "visible surface determination")]

mod overlap;

use ombra_math::glam::{DVec3, DVec4};
use ombra_math::work::Count;

use crate::pair::{CutPlane, Pair, Seen, tolerance};
use crate::polygon::Polygon;
use overlap::{Overlap, overlaps};

/// The slide's form of [`visible_parts`], which is all there is: each primitive is compared with each.
///
/// Counts the [pairs](ombra_math::work::Counter::Pairs) compared: k (k − 1) / 2.
#[must_use]
pub fn visible_parts_plain(
    polygons: &[Polygon],
    eye: DVec4,
    work: &mut impl Count,
) -> Vec<(usize, Polygon)> {
    let seen: Vec<_> = polygons.iter().map(|p| Seen::new(p, eye)).collect();
    // Compare each with each: which pairs share sight lines, and who is nearer there?
    let overlaps = overlaps(&seen, work);
    let whole = |(polygon, seen): (&Polygon, Option<Seen>)| Primitive {
        parts: seen.iter().map(|_| polygon.vertices.clone()).collect(),
        seen,
    };
    let mut scene: Vec<Primitive> = polygons.iter().zip(seen).map(whole).collect();
    // From what is visible so far of each of a pair, take what the other hides.
    for (number, overlaps) in overlaps.iter().enumerate() {
        let (before, from) = scene.split_at_mut(number);
        for overlap in overlaps {
            if let (Some(first), Some(second)) = (before.get_mut(overlap.with), from.first_mut()) {
                first.meet(second, overlap);
            }
        }
    }
    // What is left is seen.
    let parts = scene.into_iter().map(|primitive| primitive.parts);
    let numbered = parts.enumerate().flat_map(|(source, parts)| {
        let part = move |vertices| (source, Polygon { vertices });
        parts.into_iter().map(part)
    });
    numbered.collect()
}

/// The visible parts of opaque `polygons` as seen from `eye`, each with the index of the polygon it is a part of.
///
/// w ≠ 0: the eye is at a place. w = 0: a parallel view, the eye infinitely far in that direction.
///
/// # Formula
///
/// ```text
/// for i = 1 … k − 1,  j = i + 1 … k:        the nearer of i and j hides of the other
///     what lies inside the planes through the eye and the edges of the nearer
/// where they cross, each hides so on one side of the plane through the eye and their line
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
///   line within rounding of an edge, of where an edge would go on, or of a line in which two cross, may meet two or none.
/// - Parts lie inside their polygon: their corners are corners of it, or are cut out of its edges and parts, each cut
///   rounding to a few ε of the largest coordinate.
/// - Polygons that touch at an edge or a corner do not cut each other: that is decided exactly.
/// - Where two lie at the same depth (see [`compare`](crate::pair::compare)) the first in the slice is seen.
/// - Where two interpenetrate, a fourth case beside the slide's three, each is cut at the line in which they cross.
/// - An edge-on polygon has no visible part and hides nothing, nor does what is no polygon. Without an eye (0, NaN,
///   ∞, a place beyond the largest double) nothing is seen. Both sides of a polygon are seen: leave out
///   [back faces](crate::back_face) first.
///
/// # Pitfalls
///
/// From a place all directions round the eye count, and there is no near plane: what lies behind the back of a camera
/// is in the answer.
///
/// O(k²) is the number of comparisons, and the pairs that overlap in the view are kept until the end, 16 bytes each: if all
/// do, 8 k² bytes, 80 MB for k = 3200. The answer itself can grow as k² too: n strips over n strips leave n (n + 2) parts.
///
/// Equal depth within a [`tolerance`] is not transitive: of three sheets, each within it of the next, the last may be
/// nearer than the first, and each is hidden by another. One of them is seen all the same: the first is, until one comes
/// that hides the one seen so far. So of many sheets that all but coincide the one seen may depend on their order.
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
    visible_parts_plain(polygons, eye, &mut ())
}

/// The same answers, each counting its work.
pub mod counted {
    pub use super::visible_parts_plain as visible_parts;
}

/// A polygon, and what is visible of it so far.
struct Primitive {
    seen: Option<Seen>,
    parts: Vec<Vec<DVec3>>,
}

impl Primitive {
    /// Takes from each what the other hides. `self` is submitted first, and so is seen at equal depth.
    fn meet(&mut self, second: &mut Self, overlap: &Overlap) {
        let (Some(p), Some(q)) = (&self.seen, &second.seen) else {
            return;
        };
        let tolerance = tolerance(p.scale().max(q.scale()));
        // Where they cross, the first is nearer on the front of a plane through the eye: the same for both.
        let (first_hides, second_hides, border) = match overlap.pair {
            Pair::Apart => return,
            Pair::FirstNearer | Pair::Coplanar => (true, false, None),
            Pair::SecondNearer => (false, true, None),
            Pair::Crossing => match p.nearer_side(q) {
                None => (true, false, None),
                border => (true, true, border),
            },
        };
        if first_hides && overlap.is_knotted {
            let visible = self.parts.iter().filter_map(|part| p.part(part.clone()));
            for part in visible {
                hide(&mut second.parts, &part, border, tolerance);
            }
        } else if first_hides {
            hide(&mut second.parts, p, border, tolerance);
        }
        if second_hides {
            hide(&mut self.parts, q, border.map(CutPlane::turned), tolerance);
        }
    }
}

/// Takes from parts what `nearer` hides: all that it covers, or of that what is in front of `border`.
fn hide(parts: &mut Vec<Vec<DVec3>>, nearer: &Seen, border: Option<CutPlane>, tolerance: f64) {
    let mut visible = Vec::with_capacity(parts.len());
    for part in parts.drain(..) {
        let peeled = peel(&part, nearer, border, tolerance);
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
    border: Option<CutPlane>,
    tolerance: f64,
) -> Option<Vec<Vec<DVec3>>> {
    // All on or outside one plane: the common case, and no reason to cut at the others.
    let misses = |side: CutPlane| part.iter().all(|&v| side.distance(v) <= tolerance);
    if border.into_iter().chain(nearer.sides()).any(misses) {
        return None;
    }
    let mut pieces = Vec::new();
    let mut rest = part.to_vec();
    for side in border.into_iter().chain(nearer.sides()) {
        let [inside, outside] = side.split(&rest, tolerance);
        pieces.push(outside);
        rest = inside;
    }
    pieces.retain(|piece| !piece.is_empty());
    (!rest.is_empty()).then_some(pieces)
}

#[cfg(test)]
mod tests;
