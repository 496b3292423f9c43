//! The painter's algorithm: what is farther away is painted first, what is nearer over it.
//!
//! The depth sort orders the primitives by distance. That is a first guess: a large primitive may begin nearer and end
//! farther away than another. So before one is painted, it is compared with those not painted yet, and what it hides
//! is painted before it. Where three hide each other in a ring, or two cross, there is no order: [`order`] says so and
//! names them, [`order_by_cutting`] cuts them until there is one.
#![cfg_attr(doc, doc = "")]
#![cfg_attr(doc, doc = include_str!("../figures/painter-steps.svg"))]
#![cfg_attr(doc, doc = "")]
#![cfg_attr(doc, doc = include_str!("../figures/painter-cycle.svg"))]
//!
//! # Which pairs are compared
//!
//! Every primitive has an extent: a box round its directions from the eye (in a parallel view, round its place across
//! the view), and the range of its distance. A primitive is compared with those only whose box overlaps its own and
//! which do not end before it begins. A tree of boxes finds them. [`order_plain`] compares every pair instead, and
//! answers the same, but for planes seen at so grazing an angle that their distance is within the
//! [`tolerance`](crate::pair::tolerance) where the primitives are not even at the same distance from the eye.
#![doc(alias = "painters algorithm")]
#![doc(alias = "depth sort")]

use ombra_math::glam::DVec4;
use ombra_math::work::{Count, Counter};

use crate::pair::{Pair, Seen, compare_seen};
use crate::polygon::Polygon;

mod cut;
mod cycle;
mod divide;
mod extent;
mod fast;
mod piece;
#[cfg(test)]
mod tests;
mod tree;

pub use cycle::Cycle;
use cycle::ring_on;
use extent::View;

/// [`order`] as the slide tells it: every pair is compared before anything is painted.
///
/// Counts the pairs compared: k (k − 1) / 2.
///
/// # Errors
///
/// As for [`order`].
pub fn order_plain(
    polygons: &[Polygon],
    eye: DVec4,
    work: &mut impl Count,
) -> Result<Vec<usize>, Cycle> {
    let view = View::of(eye);
    let distances: Vec<f64> = polygons.iter().map(|p| view.distance(p)).collect();
    let farther = |a: &usize, b: &usize| distances[*b].total_cmp(&distances[*a]);
    // Sort by distance, farther first; a stable sort leaves equal ones as they were submitted.
    let mut sorted: Vec<usize> = (0..polygons.len()).collect();
    sorted.sort_by(farther);
    // What each hides, the farthest first.
    let mut hidden_by = vec![Vec::new(); polygons.len()];
    for [front, back] in hiding_pairs_plain(polygons, eye, work) {
        hidden_by[front].push(back);
    }
    for hidden in &mut hidden_by {
        hidden.sort_by(farther);
    }
    let mut order = Vec::with_capacity(polygons.len());
    let mut is_painted = vec![false; polygons.len()];
    for next in sorted {
        // The next of the sort; and after it what has to be painted before, because the one before hides it.
        let mut path = vec![next];
        while let Some(&last) = path.last() {
            match hidden_by[last].iter().find(|&&back| !is_painted[back]) {
                // It hides nothing that is not painted yet: paint it.
                None => {
                    path.pop();
                    if !is_painted[last] {
                        is_painted[last] = true;
                        order.push(last);
                    }
                }
                // It hides this one: that first. But if that waits for it, each hides the next in a ring.
                Some(&back) => match path.iter().position(|&p| p == back) {
                    None => path.push(back),
                    Some(start) => {
                        return Err(Cycle::of(ring_on(&path[start..], |p| &hidden_by[p])));
                    }
                },
            }
        }
    }
    Ok(order)
}

/// The indices of `polygons` back to front: the order to paint them in.
///
/// # Formula
///
/// ```text
/// sort:    farther first, by the farthest vertex; equal distances as submitted
/// paint:   the first of the sort that is left; but what it hides of the others left is
///          painted before it, the farthest of that first, and each in this same way
/// ```
///
/// `eye` is a place (w ≠ 0), seen from in all directions, or the direction towards the viewer of a parallel view
/// (w = 0). The slide's depth is measured along the direction of view. So is the distance of a parallel view; from a
/// place, where directions differ, it is that from the eye.
///
/// # Properties
///
/// - Every index once. Of two primitives that share sight lines, the nearer one comes later.
/// - Where the sort by distance is such an order already, it is the answer. Distances are rounded to a few ε.
/// - Two at the same depth, to the [`tolerance`](crate::pair::tolerance) of a comparison: the one submitted first is
///   seen, so it comes later.
/// - A primitive that is not seen (edge-on, without area, not finite) hides nothing. It comes where its distance puts
///   it, first if it has none. Without an eye (0, NaN, ∞, a place beyond the largest double) nothing is seen, and the
///   order is that of submission.
///
/// # Pitfalls
///
/// - Sorting by distance alone, of centres or of vertices: a floor is farther away than the box on it by one and
///   nearer by the other, and both are wrong somewhere.
/// - What is decided exactly may surprise: rounded vertices at the pole of a sphere make slivers that do cross.
/// - Equal depth within a tolerance is not transitive: three sheets, each within it of the next but the last nearer
///   than the first, are a cycle. One of the ties would have to give way, and an order of wholes cannot say where;
///   [`order_by_cutting`] settles it.
///
/// # Errors
///
/// A [`Cycle`] where there is no order, and only there: primitives of which each hides part of the next.
///
/// # Examples
///
/// ```
/// use ombra_hsr::painter::order;
/// use ombra_hsr::polygon::Polygon;
/// use ombra_math::glam::{DVec3, DVec4};
///
/// let square = |z: f64| Polygon {
///     vertices: [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)].map(|(x, y)| DVec3::new(x, y, z)).to_vec(),
/// };
/// let scene = [square(1.0), square(0.0), square(3.0)];
/// assert_eq!(order(&scene, DVec4::Z), Ok(vec![1, 0, 2]));
/// assert_eq!(order(&scene, DVec4::new(2.0, 2.0, 1.75, 1.0)), Ok(vec![1, 2, 0])); // looking both ways
/// ```
///
/// # References
///
/// Grafica 3, «Algoritmo del Pittore (depth-sort)». M. E. Newell, R. G. Newell, T. L. Sancha, «A solution to the hidden
/// surface problem», 1972.
pub fn order(polygons: &[Polygon], eye: DVec4) -> Result<Vec<usize>, Cycle> {
    fast::order(polygons, eye, &mut ())
}

/// Pieces of `polygons` back to front, each with the index of the polygon it is a part of; always succeeds.
///
/// # Formula
///
/// ```text
/// order, but a ring (P hides Q hides … hides P) is opened: one of it is cut in two by the
/// plane of another
/// after k rings of k primitives (64 at least), or one that no plane opens:  what is left is
/// divided by the plane of one; what lies beyond it is first, what lies before it last
/// ```
///
/// # Properties
///
/// - Where [`order`] succeeds, it is that order, and nothing is cut.
/// - Pieces are convex, those of one primitive lie side by side, and their areas add up to its own, to the rounding of
///   new vertices: 4 ε of the coordinates a cut.
/// - Painted in this order, each sight line shows the nearest primitive last, except within rounding of a piece's edge.
/// - Time: as [`order`] until the first ring, and as long as rings are opened one by one each half is compared with what
///   lies about it: k² comparisons at most for k sheets one over the other. Then m pieces are held against a few planes
///   at each of about log m divisions. Where all cross all, the pieces that come out are most of the time.
/// - Memory: some 2 KB a primitive and 8 bytes a pair that overlaps, while they wait; what is opened one by one counts as
///   primitives. A piece that planes divide takes less than 500 bytes, and handed out what its vertices take.
/// - Ends on every input. A piece is cut by the plane of a primitive once at most, so one of k primitives makes at most
///   1 + (k − 1) + (k − 1)(k − 2)/2 pieces, as many as k − 1 lines cut a convex polygon into.
/// - Of equal depths, what is not seen, and without an eye: as [`order`].
///
/// # Pitfalls
///
/// Cut by the planes of others, primitives meet along edges that none of them had: in a picture such an edge belongs
/// to whoever wins its pixels, as every edge does.
///
/// # Examples
///
/// Two squares that cross: z = x and z = −x, seen from above.
///
/// ```
/// use ombra_hsr::painter::{order, order_by_cutting};
/// use ombra_hsr::polygon::Polygon;
/// use ombra_math::glam::{DVec3, DVec4};
///
/// let tilted = |slope: f64| Polygon {
///     vertices: [(-1.0, 0.0), (1.0, 0.0), (1.0, 2.0), (-1.0, 2.0)]
///         .map(|(x, y)| DVec3::new(x, y, slope * x))
///         .to_vec(),
/// };
/// let scene = [tilted(1.0), tilted(-1.0)];
/// assert_eq!(order(&scene, DVec4::Z).unwrap_err().primitives, [0, 1]);
///
/// let pieces = order_by_cutting(&scene, DVec4::Z);
/// let sources: Vec<_> = pieces.iter().map(|(source, _)| *source).collect();
/// assert_eq!(sources, [0, 1, 0]);
/// ```
///
/// # References
///
/// In no deck; Grafica 3, «Algoritmo del Pittore (depth-sort)» stops at the question, and answers it with no. Newell,
/// as for [`order`]. That what is cut by all planes has an order: H. Fuchs, Z. M. Kedem, B. F. Naylor, «On visible
/// surface generation by a priori tree structures», 1980.
#[doc(alias = "Newell")]
#[must_use]
pub fn order_by_cutting(polygons: &[Polygon], eye: DVec4) -> Vec<(usize, Polygon)> {
    fast::order_by_cutting(polygons, eye, &mut ())
}

/// Which primitive hides part of which: `[front, back]` for each such pair, sorted.
///
/// # Properties
///
/// Two that cross stand there both ways round. Of two at the same depth the one submitted first hides the other.
/// An order back to front puts every back before its front.
///
/// # Examples
///
/// ```
/// use ombra_hsr::painter::hiding_pairs;
/// use ombra_hsr::polygon::Polygon;
/// use ombra_math::glam::{DVec3, DVec4};
///
/// let square = |z: f64| Polygon {
///     vertices: [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(|(x, y)| DVec3::new(x, y, z)).to_vec(),
/// };
/// // Seen from above, the second lies over the first.
/// assert_eq!(hiding_pairs(&[square(0.0), square(2.0)], DVec4::Z), [[1, 0]]);
/// ```
///
/// # References
///
/// Grafica 3, «Rimozione delle Superfici Nascoste»: nearer objects hide farther ones, in whole or in part.
#[must_use]
pub fn hiding_pairs(polygons: &[Polygon], eye: DVec4) -> Vec<[usize; 2]> {
    hiding_pairs_plain(polygons, eye, &mut ())
}

/// [`hiding_pairs`], counting the pairs compared: k (k − 1) / 2.
#[must_use]
pub fn hiding_pairs_plain(
    polygons: &[Polygon],
    eye: DVec4,
    work: &mut impl Count,
) -> Vec<[usize; 2]> {
    let seen: Vec<_> = polygons.iter().map(|p| Seen::new(p, eye)).collect();
    let mut pairs = Vec::new();
    for (i, first) in seen.iter().enumerate() {
        for (j, second) in seen.iter().enumerate().skip(i + 1) {
            work.add(Counter::Pairs, 1);
            let pair = match (first, second) {
                (Some(first), Some(second)) => compare_seen(first, second),
                _ => Pair::Apart,
            };
            if pair.first_hides() {
                pairs.push([i, j]);
            }
            if pair.second_hides() {
                pairs.push([j, i]);
            }
        }
    }
    pairs.sort_unstable();
    pairs
}

/// The same answers, each counting its work.
pub mod counted {
    pub use super::fast::{order, order_by_cutting};
    pub use super::hiding_pairs_plain as hiding_pairs;
}
