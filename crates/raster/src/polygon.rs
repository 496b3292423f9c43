//! Polygons: the outline as a closed chain of segments, the inside by scan lines.
//!
//! A pixel is a point, its centre (i + ½, j + ½); it is filled when its centre is inside. Along one row of
//! centres the inside begins and ends where edges cross the row: the edge table holds the edges by their first
//! row, the active edges are those that cross the present one, and between their crossings lie the spans.
#![cfg_attr(doc, doc = "")]
#![cfg_attr(doc, doc = include_str!("../figures/scanline.svg"))]
#![cfg_attr(doc, doc = "")]
#![cfg_attr(doc, doc = include_str!("../figures/polygon-kinds.svg"))]
//!
//! # Centres on an edge
//!
//! Every centre is taken a little to the right and a very little further down:
//!
//! ```text
//! (i + ½ + δ, j + ½ + δ²),  δ → 0
//! ```
//!
//! Then no centre lies on an edge, and its winding number is that of a point in general position, whatever the
//! contours and the rule. For one edge this is the top-left rule of triangles: a centre exactly on an edge
//! belongs to what lies right of it, and on a horizontal edge, to what lies below. Polygons that tile the plane
//! own every pixel exactly once.
//!
//! An edge therefore crosses the rows with top ≤ j + ½ < bottom, and of such a row the columns from ⌈X − ½⌉ on
//! lie right of its crossing X. Both are decided exactly, for all finite vertices.
//!
//! # Plain and fast
//!
//! [`fill_plain`] is the method as it is told, and its steps can be looked at: [`edge_table`], then for each row
//! [`active_edges`] and [`spans_between`]. [`fill`] gives the same spans: it follows each edge from row to row in
//! rounded arithmetic, and asks the exact predicate only where a crossing comes so near a centre that rounding could
//! move it past.
#![doc(alias = "scan conversion")]
#![doc(alias = "scan line")]
#![doc(alias = "scanline")]

mod error;
mod fast;

use core::ops::Range;

use ombra_math::glam::{DVec2, IVec2};
use ombra_math::work::{Count, Counter};

use crate::bresenham;
use crate::edge::first_centre;
use crate::span::Span;

pub use crate::edge::Edge;
pub use error::PolygonError;

/// Which points are inside contours that cross each other or lie in one another.
///
/// The winding number of a point is how often the contours run round it, counted with direction. It is the sum
/// over the edges that a ray from the point to the left crosses: +1 for one that runs down, −1 for one that runs up.
///
/// # References
///
/// Grafica 3, «Rasterizzazione di Poligoni»: intrecciato, a contorni multipli. The rules are in no deck.
#[doc(alias = "winding number")]
#[doc(alias = "winding rule")]
#[doc(alias = "fill rule")]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum FillRule {
    /// Inside where the winding number is odd.
    #[doc(alias = "even-odd")]
    #[doc(alias = "parity rule")]
    EvenOdd,
    /// Inside where the winding number is not 0.
    #[doc(alias = "non-zero")]
    NonZero,
}

impl FillRule {
    /// Whether a point with this winding number is inside.
    #[must_use]
    pub const fn contains(self, winding: i64) -> bool {
        winding & self.mask() != 0
    }

    /// The bits of the winding number that count.
    const fn mask(self) -> i64 {
        match self {
            Self::EvenOdd => 1,
            Self::NonZero => -1,
        }
    }
}

/// [`fill`] as the lecture tells it: for each scan line the active edges, sorted by their crossings, and the
/// spans between them; `plot` gets the spans.
///
/// # Properties
///
/// Every column comes from the exact predicate alone. Looks at all edges in every row, and sorts anew: the
/// oracle of [`fill`], not its rival. Its work: vertices read, edge records (one when an edge enters the table, one for
/// each row in which it is active), fragments.
///
/// # Errors
///
/// As [`fill`].
///
/// # References
///
/// As [`fill`].
pub fn fill_plain(
    contours: &[Vec<DVec2>],
    rule: FillRule,
    width: u32,
    height: u32,
    work: &mut impl Count,
    mut plot: impl FnMut(Span),
) -> Result<(), PolygonError> {
    // The edge table: all edges, by the first scan line that each crosses.
    let table = edge_table(contours, height)?;
    work.add(
        Counter::Vertices,
        contours.iter().map(|c| c.len() as u64).sum(),
    );
    work.add(Counter::EdgeRecords, table.len() as u64);
    let first = table.first().map_or(0, |edge| edge.rows.start);
    let end = table.iter().map(|edge| edge.rows.end).max().unwrap_or(0);
    for y in first..end {
        // The active edges: those that cross the scan line, from left to right.
        let active = active_edges(&table, y, width);
        work.add(Counter::EdgeRecords, active.len() as u64);
        // Between two crossings all centres are inside, or none is.
        for x in spans_between(&active, rule, width) {
            let span = Span { y, x };
            work.add(Counter::Fragments, u64::from(span.len()));
            plot(span);
        }
    }
    Ok(())
}

/// The edge table: the edges that cross a row of centres of a picture of `height` rows, by their first row.
///
/// # Properties
///
/// Edges of the same first row keep the order of the contours.
///
/// # Errors
///
/// The first vertex that is not finite.
///
/// # References
///
/// As [`fill`].
#[doc(alias = "edge table")]
#[doc(alias = "ET")]
pub fn edge_table(contours: &[Vec<DVec2>], height: u32) -> Result<Vec<Edge>, PolygonError> {
    let mut table = Vec::new();
    for_each_edge(contours, height, |edge| table.push(edge))?;
    table.sort_by_key(|edge| edge.rows.start);
    Ok(table)
}

/// Where an active edge crosses a scan line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing {
    /// Index of the edge in the table.
    pub edge: usize,
    /// The crossing, as the double nearest to it.
    pub x: f64,
    /// The first column whose centre is not left of it, exact; at most the width.
    pub column: u32,
    /// What the winding number gains there, left to right.
    pub winding: i32,
}

/// The active edges of row `y`, by their crossings from left to right.
///
/// # Examples
///
/// ```
/// use ombra_math::glam::DVec2;
/// use ombra_raster::polygon::{active_edges, edge_table};
///
/// let triangle = [(1.0, 0.0), (9.0, 4.0), (1.0, 8.0)].map(DVec2::from).to_vec();
/// let table = edge_table(&[triangle], 8).unwrap();
/// let row: Vec<_> = active_edges(&table, 2, 10).iter().map(|c| (c.x, c.column)).collect();
/// assert_eq!(row, [(1.0, 1), (6.0, 6)]);
/// ```
///
/// # References
///
/// As [`fill`].
#[doc(alias = "active edge table")]
#[doc(alias = "active edge list")]
#[doc(alias = "AET")]
#[must_use]
pub fn active_edges(table: &[Edge], y: u32, width: u32) -> Vec<Crossing> {
    let mut crossings: Vec<_> = table
        .iter()
        .enumerate()
        .filter(|(_, edge)| edge.rows.contains(&y))
        .map(|(index, edge)| Crossing {
            edge: index,
            x: edge.x(y),
            column: edge.column(y, width),
            winding: edge.winding,
        })
        .collect();
    // Only a record whose ends are not finite has NaN: the last in its column.
    let by_x = |a: f64, b: f64| a.partial_cmp(&b).unwrap_or(a.is_nan().cmp(&b.is_nan()));
    crossings.sort_by(|a, b| a.column.cmp(&b.column).then(by_x(a.x, b.x)));
    crossings
}

/// The columns inside, between crossings sorted by column.
///
/// # Formula
///
/// ```text
/// column i is in  ⇔  the sum of the windings of crossings with column ≤ i is inside by `rule`
/// ```
///
/// # Properties
///
/// Ranges that touch are joined, empty ones left out.
///
/// # References
///
/// As [`fill`].
#[must_use]
pub fn spans_between(crossings: &[Crossing], rule: FillRule, width: u32) -> Vec<Range<u32>> {
    let mut spans: Vec<Range<u32>> = Vec::new();
    let mut winding = 0;
    for (i, crossing) in crossings.iter().enumerate() {
        winding += i64::from(crossing.winding);
        let start = crossing.column;
        let next = crossings.get(i + 1).map_or(width, |next| next.column);
        let end = next.min(width);
        if !rule.contains(winding) || start >= end {
            continue;
        }
        match spans.last_mut() {
            Some(last) if last.end == start => last.end = end,
            _ => spans.push(start..end),
        }
    }
    spans
}

/// The pixels inside `contours`, as spans from the top row to the bottom, left to right, in a picture of
/// `width` × `height` pixels.
///
/// # Formula
///
/// ```text
/// pixel (i, j) is in  ⇔  its centre (i + ½, j + ½) is inside by `rule`
/// ```
///
/// # Properties
///
/// Exact for all finite vertices, however far away; centres on an edge as the [module](self) says. A contour is
/// closed from its last vertex to its first; it may be concave, cross itself and others, repeat vertices. The
/// spans of a row do not touch, so each is as long as it can be. Equal to [`fill_plain`].
///
/// Lazy: memory for the edges, in proportion to their number and not to the picture. Time for the edges, their crossings
/// inside the picture, put in order row by row, and the spans; none for empty rows.
///
/// # Pitfalls
///
/// A hole needs the opposite direction under [`FillRule::NonZero`]; under [`FillRule::EvenOdd`] any will do.
/// A polygon so thin that it passes between the centres has no pixels.
///
/// # Errors
///
/// The first vertex that is not finite.
///
/// # Examples
///
/// A five-pointed star drawn in one stroke, whose middle is wound round twice:
///
/// ```
/// use ombra_math::glam::DVec2;
/// use ombra_raster::polygon::{FillRule, fill};
///
/// let star = [(6.0, 0.0), (9.5, 11.0), (0.0, 4.2), (12.0, 4.2), (2.5, 11.0)];
/// let contours = [star.map(DVec2::from).to_vec()];
/// let picture = |rule| {
///     let mut rows = vec![vec!['.'; 12]; 11];
///     for span in fill(&contours, rule, 12, 11).unwrap() {
///         rows[span.y as usize][span.x.start as usize..span.x.end as usize].fill('#');
///     }
///     rows.into_iter().map(String::from_iter).collect::<Vec<_>>()
/// };
/// assert_eq!(picture(FillRule::EvenOdd)[6], "...#....#...");
/// assert_eq!(picture(FillRule::NonZero)[6], "...######...");
/// ```
///
/// # References
///
/// Grafica 3, «Rasterizzazione di Poligoni»: convex, concave, self-intersecting, several contours. The method is
/// in no deck: C. Wylie, G. Romney, D. Evans, A. Erdahl, «Half-tone perspective drawings by computer», 1967.
#[doc(alias = "polygon fill")]
pub fn fill(
    contours: &[Vec<DVec2>],
    rule: FillRule,
    width: u32,
    height: u32,
) -> Result<impl Iterator<Item = Span> + use<>, PolygonError> {
    fast::fill(contours, rule, width, height, ())
}

/// The same spans, with the work of finding them in `work`: vertices read, edge records (one when an edge enters the
/// table, one for each row in which it is active), fragments, and crossings that only exact arithmetic could settle.
pub mod counted {
    use super::{Count, DVec2, FillRule, PolygonError, Span, fast};

    /// [`fill`](super::fill), counted.
    ///
    /// # Errors
    ///
    /// As [`fill`](super::fill).
    ///
    /// # Examples
    ///
    /// ```
    /// use ombra_math::glam::DVec2;
    /// use ombra_math::work::Work;
    /// use ombra_raster::polygon::{FillRule, counted};
    ///
    /// let tower = [(1.0, -1e9), (3.0, -1e9), (3.0, 1e9), (1.0, 1e9)];
    /// let mut work = Work::default();
    /// let contours = [tower.map(DVec2::from).to_vec()];
    /// let spans = counted::fill(&contours, FillRule::NonZero, 100, 100, &mut work).unwrap().count();
    /// assert_eq!(spans, 100);
    /// assert_eq!((work.fragments, work.edge_records), (200, 2 + 2 * 100));
    /// ```
    pub fn fill<'a, C: Count>(
        contours: &[Vec<DVec2>],
        rule: FillRule,
        width: u32,
        height: u32,
        work: &'a mut C,
    ) -> Result<impl Iterator<Item = Span> + use<'a, C>, PolygonError> {
        fast::fill(contours, rule, width, height, work)
    }
}

/// The pixels of a polygon's outline, edge by edge, the last vertex joined to the first.
///
/// # Properties
///
/// Each edge is [`bresenham::segment`] without its last pixel, which is the first of the next edge: no
/// vertex comes twice in a row. Vertices are the pixels themselves, not corners between them. One vertex, or
/// several equal ones, are one pixel; none, no pixel.
///
/// # Pitfalls
///
/// Edges that cross or run back share pixels: the outline as a list may hold a pixel several times. It is not
/// the border of [`fill`], whose vertices are points of the plane: pixel (x, y) has its centre at (x + ½, y + ½).
///
/// # Examples
///
/// ```
/// use ombra_math::glam::IVec2;
/// use ombra_raster::polygon::outline;
///
/// let triangle = [IVec2::new(0, 0), IVec2::new(2, 0), IVec2::new(0, 2)];
/// let pixels: Vec<_> = outline(&triangle).map(|p| (p.x, p.y)).collect();
/// assert_eq!(pixels, [(0, 0), (1, 0), (2, 0), (1, 1), (0, 2), (0, 1)]);
/// ```
///
/// # References
///
/// Grafica 3, «Rasterizzazione di Poligoni»: a primitive given by its contour alone, drawn segment by segment.
pub fn outline(vertices: &[IVec2]) -> impl Iterator<Item = IVec2> {
    let point = vertices
        .first()
        .filter(|&first| vertices.iter().all(|vertex| vertex == first))
        .copied();
    let ends = vertices.iter().cycle().skip(1);
    let edges = vertices.iter().zip(ends);
    let edges = edges.flat_map(|(&a, &b)| bresenham::segment(a, b).but_last(1));
    point.into_iter().chain(edges)
}

/// Takes the edges of all contours that cross a row, in the order of the contours.
pub(super) fn for_each_edge(
    contours: &[Vec<DVec2>],
    height: u32,
    mut take: impl FnMut(Edge),
) -> Result<(), PolygonError> {
    for (contour, vertices) in contours.iter().enumerate() {
        let mut points = (0..).zip(vertices);
        if let Some((vertex, &point)) = points.find(|(_, point)| !point.is_finite()) {
            return Err(PolygonError::NotFinite {
                contour,
                vertex,
                point,
            });
        }
        let Some(&last) = vertices.last() else {
            continue;
        };
        let (mut from, mut from_row) = (last, first_centre(last.y, height));
        for &point in vertices {
            let row = first_centre(point.y, height);
            if let Some(edge) = Edge::between(from, point, [from_row, row]) {
                take(edge);
            }
            (from, from_row) = (point, row);
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests;
