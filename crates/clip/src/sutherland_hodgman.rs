//! Sutherland–Hodgman: a polygon clipped against one side after another.
//!
//! Walk round the polygon. A vertex inside is kept; where an edge passes from one side to the other, the point
//! where it crosses is put in. What comes out is a polygon again, ready for the next side.
#![cfg_attr(doc, doc = "")]
#![cfg_attr(doc, doc = include_str!("../figures/sutherland-hodgman-steps.svg"))]
#![doc(alias = "reentrant polygon clipping")]
#![doc(alias = "polygon clipping")]

use core::cmp::Ordering;

use ombra_math::glam::DVec2;
use ombra_math::work::{Count, Counter};

use crate::outline::{Outline, closed, edges, is_finite};
use crate::window::{Side, Window};

use vertex::Vertex;

mod against;
mod fast;
mod textbook;
mod vertex;

pub use against::{
    HalfPlane, clip_against_line, clip_against_line_plain, clip_against_plane,
    clip_against_plane_plain, clip_homogeneous, clip_homogeneous_plain,
};
pub use textbook::{textbook, textbook_f32};

/// [`clip_by`] with its loop, counting its [work](crate#counted-work): that of `side` and `cut` as one comparison and one
/// division.
///
/// # Properties
///
/// - Error: none but that of `cut`.
///
/// # References
///
/// As for [`clip_by`].
#[must_use]
pub fn clip_by_plain<V: Copy + PartialEq>(
    polygon: &[V],
    side: impl Fn(V) -> f64,
    cut: impl Fn(V, V, f64, f64) -> V,
    work: &mut impl Count,
) -> Vec<V> {
    work.add(Counter::Vertices, polygon.len() as u64);
    work.add(Counter::Comparisons, polygon.len() as u64);
    let sides: Vec<f64> = polygon.iter().map(|&v| side(v)).collect();
    let Some((&last, &last_side)) = polygon.last().zip(sides.last()) else {
        return Vec::new();
    };
    let none_inside = !sides.iter().any(|&s| s > 0.0);
    if sides.iter().any(|s| s.is_nan()) || (none_inside && sides.iter().any(|&s| s < 0.0)) {
        return Vec::new();
    }
    let mut kept: Vec<V> = Vec::with_capacity(polygon.len() + 2);
    let mut put = |v: V| {
        if kept.last() != Some(&v) {
            kept.push(v);
        }
    };
    let (mut a, mut a_side) = (last, last_side);
    for (&b, &b_side) in polygon.iter().zip(&sides) {
        // From one side to the other: put the crossing.
        if a_side > 0.0 && b_side < 0.0 {
            put(cut(a, b, a_side, b_side));
            work.add(Counter::Divisions, 1);
        } else if a_side < 0.0 && b_side > 0.0 {
            put(cut(b, a, b_side, a_side));
            work.add(Counter::Divisions, 1);
        }
        // In: put B.
        if b_side >= 0.0 {
            put(b);
        }
        (a, a_side) = (b, b_side);
    }
    closed(kept)
}

/// [`clip_polygon`] with one pass for each side, counting its [work](crate#counted-work).
///
/// # Properties
///
/// - The same result, bit for bit.
/// - Error: none: each coordinate is the double nearest to the exact one.
///
/// # References
///
/// As for [`clip_polygon`].
#[must_use]
pub fn clip_polygon_plain(window: &Window, polygon: &[DVec2], work: &mut impl Count) -> Vec<DVec2> {
    if !is_finite(polygon) || window.is_empty() {
        return Vec::new();
    }
    // What one side leaves is ready for the next.
    let mut vertices: Vec<Vertex> = edges(polygon).map(|(a, b)| Vertex::new(a, b)).collect();
    for side in Side::ALL {
        vertices = pass(window, side, &vertices, work);
    }
    Outline::of(vertices.iter().map(|v| v.point).collect()).close(window)
}

/// What of a polygon lies on the window's side of one line.
fn pass(window: &Window, side: Side, polygon: &[Vertex], work: &mut impl Count) -> Vec<Vertex> {
    let mut kept: Vec<Vertex> = Vec::with_capacity(polygon.len() + 1);
    let Some(&(mut a)) = polygon.last() else {
        return kept;
    };
    let mut a_side = a.side(window, side);
    work.add(Counter::Vertices, polygon.len() as u64);
    work.add(Counter::Comparisons, polygon.len() as u64 + 1);
    let mut begins_with_crossing = false;
    for (i, &b) in polygon.iter().enumerate() {
        let b_side = b.side(window, side);
        // From one side to the other: put the crossing.
        if a_side != Ordering::Equal && b_side == a_side.reverse() {
            kept.push(a.crossing(&b, window.line(side), a_side));
            work.add(Counter::Divisions, 1);
            begins_with_crossing |= i == 0;
        }
        // In: put B.
        if b_side != Ordering::Less {
            kept.push(b.after(a_side, b_side));
        }
        (a, a_side) = (b, b_side);
    }
    // The crossing of the edge to the first vertex comes last.
    if begins_with_crossing {
        kept.rotate_left(1);
    }
    kept
}

/// The part of a closed polygon where `side` is not negative.
///
/// The method itself, for vertices of any kind: places, homogeneous points, points with attributes.
///
/// # Formula
///
/// ```text
/// for each edge A → B:   A in,  B in     put B
///                        A in,  B out    put the crossing
///                        A out, B in     put the crossing, then B
///                        A out, B out    put nothing
/// ```
///
/// `side(v)` is positive inside, 0 on the border, negative outside; a border vertex is inside and no crossing is
/// put beside it. `cut(inside, outside, s_in, s_out)` gives the crossing, with s_in > 0 > s_out the values of `side`.
///
/// # Properties
///
/// - Error: none but that of `cut`.
/// - Vertices keep their order; vertices that are kept are kept unchanged.
/// - `cut` always gets the inside vertex first, so that two polygons that share an edge get the same crossing.
/// - No vertex stands twice in a row. Fewer than three vertices are no polygon: the answer is then empty, as it is if any
///   `side` is NaN.
///
/// # Pitfalls
///
/// A concave polygon that falls into several pieces comes out as one, joined by edges that run back and forth
/// along the border.
///
/// # Examples
///
/// ```
/// use ombra_clip::sutherland_hodgman::clip_by;
///
/// // A triangle against x ≥ 0.
/// let triangle = [(-1.0, 0.0), (1.0, 0.0), (1.0, 2.0)];
/// let lerp = |a: f64, b: f64, t: f64| a + (b - a) * t;
/// let clipped = clip_by(&triangle, |v: (f64, f64)| v.0, |a, b, sa, sb| {
///     let t = sa / (sa - sb);
///     (0.0, lerp(a.1, b.1, t))
/// });
/// assert_eq!(clipped, [(0.0, 1.0), (0.0, 0.0), (1.0, 0.0), (1.0, 2.0)]);
/// ```
///
/// # References
///
/// Grafica 3, «Clipping di un poligono». I. E. Sutherland, G. W. Hodgman, «Reentrant polygon clipping», 1974.
#[must_use]
pub fn clip_by<V: Copy + PartialEq>(
    polygon: &[V],
    side: impl Fn(V) -> f64,
    cut: impl Fn(V, V, f64, f64) -> V,
) -> Vec<V> {
    clip_by_plain(polygon, side, cut, &mut ())
}

/// The part of a polygon in `window`, as one outline.
///
/// # Formula
///
/// ```text
/// against y ≤ y_max, what is left against y ≥ y_min, then x ≤ x_max, then x ≥ x_min
/// ```
///
/// # Properties
///
/// - Error: none: each coordinate is the double nearest to the exact one.
/// - Vertices inside are returned unchanged and in their order; new ones are crossings of the polygon's own edges with the
///   sides, or corners of the window. So all lie in the window exactly, clipping
///   twice changes nothing, and the area is that of the true part up to the rounding of its vertices.
/// - Which vertices and crossings lie inside is decided exactly.
/// - No vertex follows itself; fewer than three are no polygon, nor are points along one side: the answer is empty.
///   So it is for a polygon that only touches the window, for one with a coordinate that is not finite, and for a
///   window without area.
/// - Self-intersecting input: every point inside the window keeps its winding number.
///
/// # Pitfalls
///
/// A concave polygon that falls into pieces comes out as one, its pieces joined by edges along the border that run back
/// and forth; [`pieces`](crate::pieces) gives separate ones. Such an edge has no area, but is drawn by an outline.
///
/// # Examples
///
/// ```
/// use ombra_clip::{Window, sutherland_hodgman};
/// use ombra_math::glam::DVec2;
///
/// let window = Window::new(DVec2::ZERO, DVec2::splat(10.0))?;
/// let triangle = [(5.0, 5.0), (15.0, 5.0), (5.0, 15.0)].map(DVec2::from);
/// let square = [(5.0, 5.0), (10.0, 5.0), (10.0, 10.0), (5.0, 10.0)].map(DVec2::from);
/// assert_eq!(sutherland_hodgman::clip_polygon(&window, &triangle), square);
/// # Ok::<(), ombra_clip::WindowError>(())
/// ```
///
/// # References
///
/// Grafica 3, «Clipping di un poligono». I. E. Sutherland, G. W. Hodgman, «Reentrant polygon clipping», 1974: the fast
/// form passes each vertex through all four sides at once, as they do.
#[must_use]
pub fn clip_polygon(window: &Window, polygon: &[DVec2]) -> Vec<DVec2> {
    fast::clip_polygon(window, polygon, &mut ())
}

/// Each gives the same answer as the function of its name and counts its [work](crate#counted-work), which comes last.
pub mod counted {
    pub use super::against::clip_against_line_plain as clip_against_line;
    pub use super::against::clip_against_plane_plain as clip_against_plane;
    pub use super::against::clip_homogeneous_plain as clip_homogeneous;
    pub use super::clip_by_plain as clip_by;
    pub use super::fast::clip_polygon;
}

#[cfg(test)]
mod tests;
