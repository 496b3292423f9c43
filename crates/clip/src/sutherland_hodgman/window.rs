//! A polygon against the four sides of a window.

use core::cmp::Ordering;

use fearless_simd::{Fallback, Level, Simd, dispatch};
use ombra_math::glam::DVec2;
use ombra_math::work::{Count, Counter};

use super::sides::Sides;
use crate::cohen_sutherland::outcode;
use crate::crossing::{compare, cut};
use crate::outline::{Outline, edges, is_finite};
use crate::segment::Segment;
use crate::window::{Line, Side, Window};

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
/// - Vertices inside are returned unchanged and in their order; new ones are the doubles nearest to the true crossings
///   of the polygon's own edges with the sides, or corners of the window. So all lie in the window exactly, clipping
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
    clip_polygon_counted(window, polygon, &mut ())
}

/// [`clip_polygon`], counting its work: see the [crate's page](crate#counted-work).
///
/// # Properties
///
/// A vertex comes to all four sides at once. Only crossings that stay in the answer are computed, a division each.
#[must_use]
pub fn clip_polygon_counted(
    window: &Window,
    polygon: &[DVec2],
    work: &mut impl Count,
) -> Vec<DVec2> {
    if polygon.len() < MANY {
        return clip_at(None::<Fallback>, window, polygon, work);
    }
    dispatch!(Level::new(), simd => clip_at(Some(simd), window, polygon, work))
}

/// From so many vertices on, vector instructions pay for the choice among them.
const MANY: usize = 64;

/// Fast form: with vector instructions, compiled for each set of them, or without. All compute the same numbers.
#[inline(always)]
pub(super) fn clip_at<S: Simd>(
    simd: Option<S>,
    window: &Window,
    polygon: &[DVec2],
    work: &mut impl Count,
) -> Vec<DVec2> {
    let (Some(&first), Some(&last)) = (polygon.first(), polygon.last()) else {
        return Vec::new();
    };
    if !first.is_finite() || !window.has_area() {
        return Vec::new();
    }
    let mut sides = Sides::new(window, polygon.len());
    let first_code = outcode(window, first);
    work.add(Counter::Vertices, 1);
    work.add(Counter::Comparisons, 4);
    sides.start(first, first_code);
    let blocks = match simd {
        Some(simd) => sides.blocks(simd, first_code, polygon, work),
        None => Some((first_code, polygon)),
    };
    let Some((code, rest)) = blocks else {
        return Vec::new();
    };
    if !is_finite(rest) {
        return Vec::new();
    }
    let code = sides.one_by_one(code, rest, work);
    sides.close(Segment::new(last, first), [code, first_code], work)
}

/// [`clip_polygon`] in its plain form, one pass for each side, counting its [work](crate#counted-work).
///
/// # Properties
///
/// The same result, bit for bit.
///
/// # References
///
/// As for [`clip_polygon`].
#[must_use]
pub fn clip_polygon_in_passes(
    window: &Window,
    polygon: &[DVec2],
    work: &mut impl Count,
) -> Vec<DVec2> {
    if !is_finite(polygon) || window.is_empty() {
        return Vec::new();
    }
    let mut vertices: Vec<Vertex> = edges(polygon)
        .map(|(before, p)| Vertex::of_polygon(before, p))
        .collect();
    for side in Side::ALL {
        vertices = clip_by_side(window, side, &vertices, work);
    }
    let mut outline = Outline::with_capacity(vertices.len());
    for v in vertices {
        outline.points.push(v.point);
    }
    outline.close(window)
}

/// A vertex on its way through the sides.
#[derive(Clone, Copy)]
struct Vertex {
    point: DVec2,
    /// For a crossing, the edge and the side that cross there: `point` is only the nearest double.
    crossing: Option<(Segment, Line)>,
    /// The polygon's edge that leads here; none along the border.
    edge: Option<Segment>,
}

impl Vertex {
    fn of_polygon(before: DVec2, point: DVec2) -> Self {
        Self {
            point,
            crossing: None,
            edge: Some(Segment::new(before, point)),
        }
    }

    /// `Greater` on the window's side, `Equal` on the line of the side, `Less` beyond: of the true point, not the
    /// rounded one.
    fn side(&self, window: &Window, side: Side) -> Ordering {
        let along = |x: f64, limit: f64, of: fn(f64) -> Line| match self.crossing {
            Some((edge, line)) if !same_axis(line, of(limit)) => compare(edge, line, x, limit),
            _ => x.partial_cmp(&limit).unwrap_or(Ordering::Less),
        };
        match side {
            Side::Above => along(self.point.y, window.max.y, Line::Horizontal).reverse(),
            Side::Below => along(self.point.y, window.min.y, Line::Horizontal),
            Side::Right => along(self.point.x, window.max.x, Line::Vertical).reverse(),
            Side::Left => along(self.point.x, window.min.x, Line::Vertical),
        }
    }
}

fn same_axis(a: Line, b: Line) -> bool {
    matches!(
        (a, b),
        (Line::Vertical(_), Line::Vertical(_)) | (Line::Horizontal(_), Line::Horizontal(_))
    )
}

/// The crossing of the way from `before` to `v` with the line of a side. It is on v's edge, whatever earlier sides cut
/// from that; the border crosses at a corner.
fn crossing(before: &Vertex, v: &Vertex, line: Line) -> (DVec2, Option<(Segment, Line)>) {
    match (v.edge, line) {
        (Some(edge), _) => (cut(edge, line), Some((edge, line))),
        (None, Line::Vertical(x)) => (DVec2::new(x, before.point.y), None),
        (None, Line::Horizontal(y)) => (DVec2::new(before.point.x, y), None),
    }
}

/// Plain form: what of a polygon lies on the window's side of one line.
fn clip_by_side(
    window: &Window,
    side: Side,
    polygon: &[Vertex],
    work: &mut impl Count,
) -> Vec<Vertex> {
    let mut kept = Vec::with_capacity(polygon.len() + 1);
    let mut stage = Stage::new(window, side);
    work.add(Counter::Vertices, polygon.len() as u64);
    let closing = polygon.first().copied();
    for (i, v) in polygon.iter().copied().chain(closing).enumerate() {
        let (cut, v) = stage.step(v, work);
        work.add(Counter::Divisions, u64::from(cut.is_some()));
        kept.extend(cut);
        if i < polygon.len() {
            kept.extend(v);
        } else if let (Some(first), Some(again)) = (kept.first_mut(), v) {
            // The first vertex comes once more, for the edge that leads to it.
            *first = again;
        }
    }
    kept
}

/// One side, and the vertex that came before.
struct Stage<'a> {
    window: &'a Window,
    side: Side,
    before: Option<(Vertex, Ordering)>,
}

impl<'a> Stage<'a> {
    fn new(window: &'a Window, side: Side) -> Self {
        Self {
            window,
            side,
            before: None,
        }
    }

    /// The crossing before `v`, if there is one, and `v` itself if it is kept.
    fn step(&mut self, v: Vertex, work: &mut impl Count) -> (Option<Vertex>, Option<Vertex>) {
        work.add(Counter::Comparisons, 1);
        let side = v.side(self.window, self.side);
        let line = self.window.line(self.side);
        // Coming back from beyond, the way to where the line is met is the border.
        let comes_back = matches!(self.before, Some((_, Ordering::Less)));
        let cut = match self.before {
            Some((before, was)) if was != Ordering::Equal && side == was.reverse() => {
                let (point, on) = crossing(&before, &v, line);
                let edge = if comes_back { None } else { v.edge };
                Some(Vertex {
                    point,
                    crossing: on,
                    edge,
                })
            }
            _ => None,
        };
        self.before = Some((v, side));
        let edge = if comes_back && side == Ordering::Equal {
            None
        } else {
            v.edge
        };
        let kept = (side != Ordering::Less).then_some(Vertex { edge, ..v });
        (cut, kept)
    }
}

#[cfg(test)]
mod tests;
