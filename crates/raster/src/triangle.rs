//! Triangles, the primitive of graphics hardware: which pixels a triangle owns.
//!
//! Three edge functions say on which side of each edge a pixel's centre lies. A centre exactly on an edge goes to
//! the triangle for which that edge is a top or a left one, so that of two triangles that share the edge, one
//! and only one owns it: no gap, no pixel drawn twice.
#![cfg_attr(doc, doc = "")]
#![cfg_attr(doc, doc = include_str!("../figures/triangle-shared-edge.svg"))]
#![cfg_attr(doc, doc = "")]
#![cfg_attr(doc, doc = include_str!("../figures/sliver.svg"))]
//!
//! [`contains`] asks this of one point, [`cover_plain`] of every centre of a picture, as hardware does. [`cover`]
//! gives the same pixels without looking at those outside: a triangle is convex, so in each row they are one run,
//! between the two sides that cross it.
#![doc(alias = "half-space")]

mod error;
mod fast;

use core::cmp::Ordering;

use ombra_math::glam::{DVec2, UVec2};
use ombra_math::predicates::orient_2d;
use ombra_math::work::{Count, Counter};

use crate::span::Span;

pub use error::TriangleError;

/// What becomes of a centre that lies exactly on an edge.
#[doc(alias = "fill convention")]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum EdgeRule {
    /// It is in if the edge is a top or a left one: each pixel of a shared edge has one owner.
    TopLeft,
    /// It is in: pixels of a shared edge are drawn twice.
    Closed,
    /// It is out: a shared edge through centres is a gap.
    Open,
}

/// [`cover`] as the lecture's hardware does it: the edge functions at every centre of the picture; `plot` gets the
/// pixels, row after row.
///
/// # Properties
///
/// By [`EdgeRule::TopLeft`] equal to [`cover`]; the other rules show the gaps and the overlaps. Its work: vertices read,
/// fragments.
///
/// # Errors
///
/// As [`cover`].
///
/// # References
///
/// As [`contains`].
pub fn cover_plain(
    triangle: [DVec2; 3],
    rule: EdgeRule,
    width: u32,
    height: u32,
    work: &mut impl Count,
    mut plot: impl FnMut(UVec2),
) -> Result<(), TriangleError> {
    error::check(triangle)?;
    work.add(Counter::Vertices, 3);
    for y in 0..height {
        for x in 0..width {
            // A pixel is in when its centre is on the inner side of all three edges, or on an edge that owns it.
            let centre = DVec2::new(f64::from(x) + 0.5, f64::from(y) + 0.5);
            if contains(triangle, centre, rule) {
                work.add(Counter::Fragments, 1);
                plot(UVec2::new(x, y));
            }
        }
    }
    Ok(())
}

/// Whether `p` is in the triangle, with edges by `rule`; exact, in either winding.
///
/// # Formula
///
/// ```text
/// in  ⇔  for each edge:  E(P) > 0,  or E(P) = 0 and the rule takes that edge
/// ```
///
/// with the corners in the order in which the triangle's own E is positive.
///
/// # Properties
///
/// A degenerate triangle holds nothing, by any rule, nor does one with a corner that is not finite.
///
/// # Examples
///
/// ```
/// use ombra_math::glam::DVec2;
/// use ombra_raster::triangle::{EdgeRule, contains};
///
/// let [a, b, c, d] = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)].map(DVec2::from);
/// let on_the_diagonal = DVec2::splat(2.5);
/// let owners = |rule| [[a, b, c], [a, c, d]].map(|t| contains(t, on_the_diagonal, rule));
/// assert_eq!(owners(EdgeRule::TopLeft), [true, false]);
/// assert_eq!(owners(EdgeRule::Closed), [true, true]);
/// assert_eq!(owners(EdgeRule::Open), [false, false]);
/// ```
///
/// # References
///
/// As [`edge_function`]; Grafica 3, «Shadow Volume: Limiti e problemi»: polygons that share a side must leave no
/// overlap and no gap.
#[must_use]
pub fn contains(triangle: [DVec2; 3], p: DVec2, rule: EdgeRule) -> bool {
    let [a, b, c] = triangle;
    let [a, b, c] = match orient_2d(a, b, c) {
        Some(Ordering::Greater) => [a, b, c],
        Some(Ordering::Less) => [a, c, b],
        _ => return false,
    };
    [(a, b), (b, c), (c, a)]
        .into_iter()
        .all(|(a, b)| match orient_2d(a, b, p) {
            Some(Ordering::Greater) => true,
            Some(Ordering::Equal) => match rule {
                EdgeRule::TopLeft => is_top_left(a, b),
                EdgeRule::Closed => true,
                EdgeRule::Open => false,
            },
            _ => false,
        })
}

/// The edge function of A → B at P: twice the area of the triangle A B P, rounded.
///
/// # Formula
///
/// ```text
/// E(P) = (b.x − a.x)(p.y − a.y) − (b.y − a.y)(p.x − a.x)
/// ```
///
/// # Properties
///
/// 0 on the line, positive on one side and negative on the other; with y down, positive to the right of who walks
/// from A to B. Linear in P: a step in x adds a.y − b.y, a step in y adds b.x − a.x.
///
/// - Error: at most 2.01 ε (|(b.x − a.x)(p.y − a.y)| + |(b.y − a.y)(p.x − a.x)|), short of underflow and overflow.
///
/// # Pitfalls
///
/// Beside the line its sign is rounding error. What decides is
/// [`orient_2d`], the exact sign of the same expression.
///
/// # Examples
///
/// ```
/// use ombra_math::glam::DVec2;
/// use ombra_raster::triangle::edge_function;
///
/// let (a, b) = (DVec2::ZERO, DVec2::new(4.0, 0.0));
/// assert_eq!(edge_function(a, b, DVec2::new(1.0, 2.0)), 8.0);
/// ```
///
/// # References
///
/// Grafica 3, «Algoritmo di Bresenham»: F(x, y), the same implicit line. J. Pineda, «A parallel algorithm for
/// polygon rasterization», 1988.
#[doc(alias = "edge function")]
#[must_use]
pub fn edge_function(a: DVec2, b: DVec2, p: DVec2) -> f64 {
    (b - a).perp_dot(p - a)
}

/// Whether A → B is a top or a left edge of a triangle that lies where its edge function is positive.
///
/// # Formula
///
/// ```text
/// top:   b.y = a.y and b.x > a.x          the triangle below it (y down)
/// left:  b.y < a.y                        the triangle to its right
/// ```
///
/// # Pitfalls
///
/// A lower horizontal edge is neither. With y up, top and bottom change places.
///
/// # References
///
/// In no deck; the rule of graphics hardware.
#[doc(alias = "top-left rule")]
#[must_use]
pub fn is_top_left(a: DVec2, b: DVec2) -> bool {
    b.y < a.y || (b.y == a.y && b.x > a.x)
}

/// The pixels whose centres are in the triangle, as spans from the top row to the bottom, one a row at most, in a
/// picture of `width` × `height` pixels.
///
/// # Formula
///
/// ```text
/// in row j:  ⌈X_left − ½⌉ ≤ i < ⌈X_right − ½⌉
/// ```
///
/// X_left and X_right are where the sides cross y = j + ½, a side from its upper end (included) to its lower.
///
/// # Properties
///
/// Exact for all finite vertices: these are the pixels of [`contains`] by [`EdgeRule::TopLeft`] and those of
/// [`fill`](crate::polygon::fill). So of two triangles on either side of an edge one and only one owns a pixel on
/// it, and a fan round a point owns the point's pixel once. Either winding gives the same pixels; a degenerate
/// triangle has none. No allocation; time for the rows of the picture that the triangle crosses.
///
/// # Pitfalls
///
/// A sliver narrower than a pixel may miss all centres or hit some: pixels found are not its area, and its
/// pixels need not hang together.
///
/// # Errors
///
/// The first vertex that is not finite.
///
/// # Examples
///
/// ```
/// use ombra_math::glam::DVec2;
/// use ombra_raster::triangle::cover;
///
/// // Two halves of a square; the diagonal runs through four centres.
/// let [a, b, c, d] = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)].map(DVec2::from);
/// let count = |triangle| cover(triangle, 8, 8).unwrap().map(|span| span.len()).sum::<u32>();
/// assert_eq!((count([a, b, c]), count([a, c, d])), (10, 6));
/// ```
///
/// # References
///
/// Grafica 3, «Rasterizzazione di Poligoni»: hardware rasterizes triangles, and long thin ones badly; «Shadow
/// Volume: Limiti e problemi».
pub fn cover(
    triangle: [DVec2; 3],
    width: u32,
    height: u32,
) -> Result<impl Iterator<Item = Span> + use<>, TriangleError> {
    fast::cover(triangle, width, height, ())
}

/// The same spans, with the work of finding them in `work`: as [`polygon::counted`](crate::polygon::counted) vertices
/// read, edge records (one for each side that crosses a row, two for each row), fragments, and crossings that only exact
/// arithmetic could settle.
pub mod counted {
    use super::{Count, DVec2, Span, TriangleError, fast};

    /// [`cover`](super::cover), counted as the spans are asked for: of a row that nobody asks for, nothing.
    ///
    /// # Errors
    ///
    /// As [`cover`](super::cover).
    ///
    /// # Examples
    ///
    /// The slanted side of this triangle runs through a centre in each of its 4 rows:
    ///
    /// ```
    /// use ombra_math::glam::DVec2;
    /// use ombra_math::work::Work;
    /// use ombra_raster::triangle::counted;
    ///
    /// let triangle = [(0.0, 0.0), (4.0, 0.0), (0.0, 4.0)].map(DVec2::from);
    /// let mut work = Work::default();
    /// let spans = counted::cover(triangle, 8, 8, &mut work).unwrap().count();
    /// assert_eq!(spans, 3);
    /// assert_eq!(
    ///     work.to_string(),
    ///     "6 fragments, 3 vertices, 10 edge records, 4 exact fallbacks"
    /// );
    /// ```
    pub fn cover<C: Count>(
        triangle: [DVec2; 3],
        width: u32,
        height: u32,
        work: &mut C,
    ) -> Result<impl Iterator<Item = Span> + use<'_, C>, TriangleError> {
        fast::cover(triangle, width, height, work)
    }
}

/// A vertex moved to the nearest multiple of 2⁻ᵇⁱᵗˢ, as hardware with `bits` of sub-pixel precision stores it.
///
/// # Formula
///
/// ```text
/// ⌊x · 2ᵇ + ½⌋ / 2ᵇ
/// ```
///
/// # Properties
///
/// Vertices that were equal stay equal, so triangles that share an edge still do, and leave no gap; which pixels
/// they own changes. A coordinate that has no finer digits stays where it is.
///
/// - Error: none.
///
/// # Examples
///
/// ```
/// use ombra_math::glam::DVec2;
/// use ombra_raster::triangle::snap;
///
/// assert_eq!(snap(DVec2::new(0.3, 1.5), 2), DVec2::new(0.25, 1.5));
/// assert_eq!(snap(DVec2::new(0.3, 1.5), 0), DVec2::new(0.0, 2.0));
/// ```
///
/// # References
///
/// In no deck; graphics hardware, mostly with 4 or 8 bits.
#[doc(alias = "sub-pixel")]
#[doc(alias = "fixed point")]
#[must_use]
pub fn snap(vertex: DVec2, bits: u32) -> DVec2 {
    // 2⁻¹⁰⁷⁴ is the finest digit there is.
    let bits = bits.min(1074) as i32;
    let snap = |x: f64| {
        // From 2⁵² on a double is an integer: nothing to round.
        let scaled = libm::scalbn(x, bits);
        if scaled.abs() < 1.0 / f64::EPSILON {
            let floor = scaled.floor();
            let up = if scaled - floor >= 0.5 { 1.0 } else { 0.0 };
            libm::scalbn(floor + up, -bits)
        } else {
            x
        }
    };
    DVec2::new(snap(vertex.x), snap(vertex.y))
}

#[cfg(test)]
mod tests;
