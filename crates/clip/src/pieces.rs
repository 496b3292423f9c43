//! A polygon against a window, in separate pieces.
//!
//! A concave polygon may fall into several parts. Its boundary enters and leaves the window; between leaving and the
//! next entry along the window's border runs the border of a piece. Joining each way out with the right way in gives
//! every piece for itself, without the edges back and forth that one outline for all needs.
#![cfg_attr(doc, doc = "")]
#![cfg_attr(doc, doc = include_str!("../figures/polygon-cases.svg"))]
#![doc(alias = "Weiler-Atherton")]
#![doc(alias = "concave polygon")]

use ombra_math::glam::DVec2;
use ombra_math::work::{Count, Counter};

use crate::cohen_sutherland::Outcode;
use crate::outline::{Outline, is_finite, run};
use crate::window::Window;

use chains::Chains;
use ends::Border;
use links::{links, winding_beside_first_corner};

mod chains;
mod ends;
mod links;

/// [`clip_polygon`] with its walk, counting its [work](crate#counted-work).
///
/// # Properties
///
/// - Error: none: each coordinate is the double nearest to the exact one.
///
/// # References
///
/// As for [`clip_polygon`].
#[must_use]
pub fn clip_polygon_plain(
    window: &Window,
    polygon: &[DVec2],
    work: &mut impl Count,
) -> Vec<Vec<DVec2>> {
    if !window.has_area() {
        return Vec::new();
    }
    // As it is, if nothing lies outside.
    let (inside, _) = run(window, Outcode::INSIDE, polygon);
    work.add(Counter::Comparisons, 4 * inside as u64);
    if inside == polygon.len() {
        work.add(Counter::Vertices, inside as u64);
        let whole = Outline::of(polygon.to_vec()).close(window);
        return not_empty(whole).into_iter().collect();
    }
    if !is_finite(polygon) {
        return Vec::new();
    }
    // Chains: the parts of the boundary strictly inside, each from its entry E to its exit X.
    let mut chains = Chains::of(window, polygon, work);
    // None: the window lies all inside the polygon, or all outside.
    let winding = winding_beside_first_corner(window, polygon, work);
    if chains.ends.is_empty() {
        return around(window, winding);
    }
    // From each X along the border, to the E where the polygon comes back.
    let border = Border { window, polygon };
    let (mut next, whole) = links(&mut chains, border, winding, work);
    // Walk along a chain, along the border to the next one, and so on until the piece is closed.
    let mut pieces = Vec::new();
    for first in 0..next.len() {
        let mut outline = Outline::default();
        let mut chain = first;
        while let Some(link) = next.get_mut(chain).and_then(Option::take) {
            outline.points.extend_from_slice(chains.points(chain));
            outline.points.extend(link.corners(window));
            chain = link.to;
        }
        pieces.extend(not_empty(outline.close(window)));
    }
    pieces.extend(around(window, whole));
    pieces
}

fn not_empty(polygon: Vec<DVec2>) -> Option<Vec<DVec2>> {
    (!polygon.is_empty()).then_some(polygon)
}

/// The window itself, as often as `winding` says and in its direction.
fn around(window: &Window, winding: i64) -> Vec<Vec<DVec2>> {
    let mut corners = window.corners().to_vec();
    if winding < 0 {
        corners.reverse();
    }
    vec![corners; winding.unsigned_abs() as usize]
}

/// The parts of a polygon in `window`, each a polygon of its own.
///
/// # Formula
///
/// ```text
/// chain: a part of the polygon's boundary strictly inside the window,
///        from an entry E to an exit X on its border
/// counter-clockwise polygon: from X along the border, counter-clockwise, to the next E;
/// clockwise: the other way
/// ```
///
/// # Properties
///
/// - Every point strictly inside the window and off the boundary has in the pieces together the winding number it has
///   in the polygon, whatever the input: 1 (or −1, clockwise) in one piece and 0 elsewhere for a simple polygon.
/// - Error: none: each coordinate is the double nearest to the exact one.
/// - Vertices inside are returned unchanged; new ones are crossings, or corners of the window. All lie in the window exactly, and a piece clipped again comes back unchanged.
/// - What is entry, exit, order along the border is decided exactly. Pieces come in the order in which the
///   polygon enters them, each turns the way the polygon does, and no vertex follows itself.
/// - A polygon inside the window is returned as it is. One around it gives the window.
/// - None for what has no area in the window: a polygon beside it or touching it, fewer than three vertices, a
///   window that is a segment or a point; none if a coordinate is not finite.
/// - Self-intersecting input: pieces may overlap, and where the polygon winds round the window k times there are k
///   outlines. A piece may touch itself where the polygon does.
///
/// # Pitfalls
///
/// Comparing rounded positions along the border joins the wrong ends where two edges leave through nearly one point.
///
/// # Examples
///
/// The letter U, of which the window cuts off the bottom:
///
/// ```
/// use ombra_clip::{Window, pieces};
/// use ombra_math::glam::DVec2;
///
/// let window = Window::new(DVec2::ZERO, DVec2::splat(10.0))?;
/// let u = [(1.0, -5.0), (9.0, -5.0), (9.0, 5.0), (7.0, 5.0), (7.0, -3.0), (3.0, -3.0), (3.0, 5.0), (1.0, 5.0)];
/// let arms = pieces::clip_polygon(&window, &u.map(DVec2::from));
/// assert_eq!(arms.len(), 2);
/// assert_eq!(arms[0], [(9.0, 0.0), (9.0, 5.0), (7.0, 5.0), (7.0, 0.0)].map(DVec2::from));
/// # Ok::<(), ombra_clip::WindowError>(())
/// ```
///
/// # References
///
/// Grafica 3, «Clipping di un poligono», case B. K. Weiler, P. Atherton, «Hidden surface removal using polygon area
/// sorting», 1977, from whom the walk along the other polygon's border is.
#[must_use]
pub fn clip_polygon(window: &Window, polygon: &[DVec2]) -> Vec<Vec<DVec2>> {
    clip_polygon_plain(window, polygon, &mut ())
}

/// Each gives the same answer as the function of its name and counts its [work](crate#counted-work), which comes last.
pub mod counted {
    pub use super::clip_polygon_plain as clip_polygon;
}

#[cfg(test)]
mod tests;
