//! A polygon against the four sides of a window.

use core::cmp::Ordering;

use ombra_math::glam::DVec2;
use ombra_math::work::{Count, Counter};

use crate::cohen_sutherland::outcode;
use crate::crossing::{Entries, compare, cut, two_entries};
use crate::outline::{Outline, edges, is_finite, length_of_run};
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
    // Fast form: one pass, four sides behind one another, no polygon in between.
    let Some(&last) = polygon.last() else {
        return Vec::new();
    };
    if !is_finite(polygon) || window.is_empty() {
        return Vec::new();
    }
    let mut sides = Sides::new(window, polygon.len());
    let (mut before, mut rest) = (last, polygon);
    // After a vertex inside, what follows may take the short way; the sides then see only where it ends.
    let mut short_way = false;
    let mut unseen = None;
    while let Some((&p, after)) = rest.split_first() {
        // Within a run of vertices of one region no side is crossed.
        let code = outcode(window, p);
        let (inner, next) = after.split_at(length_of_run(window, p, code, after));
        let end = inner.last().copied().unwrap_or(p);
        if short_way && code.is_inside() {
            sides.out.put(p);
            sides.out.extend(inner);
            unseen = Some(end);
        } else if short_way
            && let Some(&back) = next.first()
            && let Some(detour) = detour(window, [before, p], [end, back])
        {
            for p in detour.into_iter().flatten() {
                sides.out.put(p);
            }
        } else {
            if let Some(v) = unseen.take() {
                sides.resume(v);
            }
            sides.pass(0, Vertex::of_polygon(before, p));
            if let Some((&end, between)) = inner.split_last() {
                if code.is_inside() {
                    sides.out.extend(between);
                }
                let before_end = between.last().copied().unwrap_or(p);
                sides.pass(0, Vertex::of_polygon(before_end, end));
            }
            short_way = code.is_inside();
        }
        (before, rest) = (end, next);
    }
    if let Some(v) = unseen {
        sides.resume(v);
    }
    sides.close();
    sides.out.close(window)
}

/// [`clip_polygon`] in its plain form, four passes, counting the vertices of each and a division for each crossing.
///
/// # Properties
///
/// The same result, bit for bit.
#[must_use]
pub fn clip_polygon_counted(
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
        outline.put(v.point);
    }
    outline.close(window)
}

/// Fast form: what the four sides make of a way out from a vertex inside to `out` and, through the same region, back
/// in to another: the crossings, and between them the corner if they are on different sides. `None` where that is in
/// doubt, or a vertex lies on the border.
fn detour(
    window: &Window,
    [before, out]: [DVec2; 2],
    [end, back]: [DVec2; 2],
) -> Option<[Option<DVec2>; 3]> {
    let inside = |p: DVec2| {
        (window.min.x < p.x) & (p.x < window.max.x) & (window.min.y < p.y) & (p.y < window.max.y)
    };
    if !(inside(before) && inside(back)) {
        return None;
    }
    let lanes = |p: DVec2, q: DVec2| [DVec2::new(p.x, q.x), DVec2::new(p.y, q.y)];
    let [x, y] = lanes(out, end);
    let within = [
        (x - window.min.x).min(window.max.x - x),
        (y - window.min.y).min(window.max.y - y),
    ];
    let Entries {
        x,
        y,
        upright,
        certain,
        ..
    } = two_entries(window, [x, y], lanes(before, back), within);
    if certain[0] & certain[1] == 0 {
        return None;
    }
    let corner = out.max(window.min).min(window.max) + 0.0;
    let turns = upright[0] != upright[1];
    Some([
        Some(DVec2::new(x.x, y.x)),
        turns.then_some(corner),
        Some(DVec2::new(x.y, y.y)),
    ])
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
        let (cut, v) = stage.step(v);
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
    first: Option<Vertex>,
}

impl<'a> Stage<'a> {
    fn new(window: &'a Window, side: Side) -> Self {
        Self {
            window,
            side,
            before: None,
            first: None,
        }
    }

    /// The crossing before `v`, if there is one, and `v` itself if it is kept.
    fn step(&mut self, v: Vertex) -> (Option<Vertex>, Option<Vertex>) {
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
        self.first.get_or_insert(v);
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

/// Fast form: the four sides behind one another.
struct Sides<'a> {
    stages: [Stage<'a>; 4],
    out: Outline,
}

impl<'a> Sides<'a> {
    fn new(window: &'a Window, vertices: usize) -> Self {
        Self {
            stages: Side::ALL.map(|side| Stage::new(window, side)),
            out: Outline::with_capacity(vertices),
        }
    }

    /// Sends a vertex through the sides from `level` on.
    fn pass(&mut self, level: usize, v: Vertex) {
        let Some(stage) = self.stages.get_mut(level) else {
            self.out.put(v.point);
            return;
        };
        let (cut, v) = stage.step(v);
        for v in cut.into_iter().chain(v) {
            self.pass(level + 1, v);
        }
    }

    /// Goes on from `p`, a vertex inside that took the short way.
    fn resume(&mut self, p: DVec2) {
        let v = Vertex::of_polygon(p, p);
        for stage in &mut self.stages {
            stage.before = Some((v, v.side(stage.window, stage.side)));
        }
    }

    /// Lets the first vertex of each side follow its last.
    fn close(&mut self) {
        for level in 0..self.stages.len() {
            let step = self.stages.get_mut(level).and_then(|stage| {
                let first = stage.first?;
                Some(stage.step(first))
            });
            let Some((cut, first)) = step else {
                continue;
            };
            if let Some(cut) = cut {
                self.pass(level + 1, cut);
            }
            // Kept, it was the first of the next side too.
            if let (Some(next), Some(_)) = (self.stages.get_mut(level + 1), first) {
                next.first = first;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::oracle::{self, absolute, area, int, is_nearest, r, small_window, winding};
    use proptest::prelude::*;

    /// Both forms, which must agree.
    fn clip(window: &Window, polygon: &[DVec2]) -> Vec<DVec2> {
        let fast = clip_polygon(window, polygon);
        let plain = clip_polygon_counted(window, polygon, &mut ());
        let bits =
            |p: &[DVec2]| -> Vec<_> { p.iter().map(|p| p.to_array().map(f64::to_bits)).collect() };
        assert_eq!(bits(&fast), bits(&plain), "{window:?} {polygon:?}");
        fast
    }

    fn points<const N: usize>(p: [(f64, f64); N]) -> Vec<DVec2> {
        p.map(DVec2::from).to_vec()
    }

    fn lecture() -> Window {
        Window::new(DVec2::ZERO, DVec2::splat(10.0)).unwrap()
    }

    #[test]
    fn the_lectures_triangle() {
        let triangle = points([(5.0, 5.0), (15.0, 5.0), (5.0, 15.0)]);
        let square = points([(5.0, 5.0), (10.0, 5.0), (10.0, 10.0), (5.0, 10.0)]);
        assert_eq!(clip(&lecture(), &triangle), square);
        assert_eq!(area(&square), int(50));
    }

    #[test]
    fn convex_concave_and_around() {
        let w = lecture();
        let around = points([(-5.0, -5.0), (20.0, -5.0), (20.0, 20.0), (-5.0, 20.0)]);
        assert_eq!(area(&clip(&w, &around)), int(200));
        assert_eq!(clip(&w, &w.corners()), w.corners());
        // The letter U: one outline, its arms joined along the side.
        let u = points([
            (1.0, -5.0),
            (9.0, -5.0),
            (9.0, 5.0),
            (7.0, 5.0),
            (7.0, -3.0),
            (3.0, -3.0),
            (3.0, 5.0),
            (1.0, 5.0),
        ]);
        let arms = points([
            (9.0, 0.0),
            (9.0, 5.0),
            (7.0, 5.0),
            (7.0, 0.0),
            (3.0, 0.0),
            (3.0, 5.0),
            (1.0, 5.0),
            (1.0, 0.0),
        ]);
        assert_eq!(clip(&w, &u), arms);
    }

    #[test]
    fn degenerate() {
        let w = lecture();
        let huge = f64::MAX;
        let nothing: [Vec<DVec2>; 9] = [
            points([]),
            points([(5.0, 5.0)]),
            points([(5.0, 5.0), (6.0, 6.0)]),
            vec![DVec2::splat(5.0); 7],
            points([(11.0, 5.0), (15.0, 5.0), (11.0, 9.0)]),
            // It touches a corner; a side; a side in three points.
            points([(10.0, 10.0), (15.0, 10.0), (10.0, 15.0)]),
            points([(10.0, 2.0), (15.0, 2.0), (15.0, 8.0), (10.0, 8.0)]),
            points([(10.0, 2.0), (15.0, 5.0), (10.0, 8.0), (10.0, 5.0)]),
            // Round a corner of the window, without meeting it.
            points([(-5.0, 9.0), (1.0, 15.0), (-5.0, 15.0)]),
        ];
        for polygon in nothing {
            assert_eq!(clip(&w, &polygon), [], "{polygon:?}");
        }
        let wide = points([(-huge, -huge), (huge, -huge), (huge, huge), (-huge, huge)]);
        assert_eq!(area(&clip(&w, &wide)), int(200));
        let repeated = points([
            (1.0, 1.0),
            (1.0, 1.0),
            (9.0, 1.0),
            (9.0, 1.0),
            (9.0, 9.0),
            (1.0, 1.0),
        ]);
        assert_eq!(
            clip(&w, &repeated),
            points([(1.0, 1.0), (9.0, 1.0), (9.0, 9.0)])
        );
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            for p in [DVec2::new(bad, 5.0), DVec2::new(5.0, bad)] {
                assert_eq!(clip(&w, &[DVec2::ONE, DVec2::X, p, DVec2::Y]), []);
            }
        }
        let triangle = points([(-5.0, -5.0), (15.0, -5.0), (5.0, 15.0)]);
        for thin in [
            (DVec2::ZERO, DVec2::X * 10.0),
            (DVec2::splat(5.0), DVec2::splat(5.0)),
        ] {
            assert_eq!(clip(&Window::new(thin.0, thin.1).unwrap(), &triangle), []);
        }
        let by_hand = Window {
            min: w.max,
            max: w.min,
        };
        assert_eq!(clip(&by_hand, &triangle), []);
    }

    #[test]
    fn counts_each_pass() {
        let mut work = ombra_math::work::Work::default();
        let triangle = points([(5.0, 5.0), (15.0, 5.0), (5.0, 15.0)]);
        let _ = clip_polygon_counted(&lecture(), &triangle, &mut work);
        // Above: 3 vertices, cut twice, 4 left. Below: 4. Right: 4, one beyond; an edge meets it in the corner. Left: 4.
        assert_eq!((work.vertices, work.divisions), (15, 3));
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(2000))]

        #[test]
        fn vertices_are_the_nearest_doubles_to_the_true_ones(polygon in oracle::polygon()) {
            let w = small_window();
            let clipped = clip(&w, &polygon);
            let mut expected: Vec<DVec2> = Vec::new();
            for [x, y] in oracle::sutherland_hodgman(&w, &polygon) {
                let nearest = |p: &&DVec2| is_nearest(p.x, &x) && is_nearest(p.y, &y);
                // What is not near any vertex must not be there: then nothing is left but a side, or two points.
                let Some(&p) = clipped.iter().find(nearest) else {
                    prop_assert_eq!(&clipped, &[]);
                    continue;
                };
                if expected.last() != Some(&p) {
                    expected.push(p);
                }
            }
            while expected.len() > 1 && expected.first() == expected.last() {
                expected.pop();
            }
            prop_assert_eq!(&clipped, &expected);
            prop_assert!(clipped.iter().all(|&p| w.contains(p)));
            prop_assert_eq!(clip(&w, &clipped), clipped);
        }

        #[test]
        fn points_keep_their_winding_number(polygon in oracle::grid_polygon()) {
            let w = small_window();
            let clipped = clip(&w, &polygon);
            for p in oracle::samples() {
                let expected = winding(&polygon, p);
                prop_assert!(expected.is_none() || winding(&clipped, p) == expected, "{}", p);
            }
        }

        #[test]
        fn what_vanishes_has_no_area(polygon in oracle::polygon()) {
            let w = small_window();
            let exact = oracle::sutherland_hodgman(&w, &polygon);
            let mut true_area = int(0);
            for (i, a) in exact.iter().enumerate() {
                let b = &exact[(i + 1) % exact.len()];
                true_area += &a[0] * &b[1] - &a[1] * &b[0];
            }
            // Up to 4 crossings an edge, each off by half an ulp of 8 in x and y, times twice the window's size.
            let bound = r(14.0 * 4.0 * f64::EPSILON * 4.0 * 2.0 * 12.0);
            prop_assert!(absolute(area(&clip(&w, &polygon)) - true_area) <= bound);
        }

        #[test]
        fn never_panics(x in prop::collection::vec(proptest::num::f64::ANY, 12), n in 0usize..5) {
            let p: Vec<DVec2> = x.chunks_exact(2).map(DVec2::from_slice).collect();
            let (polygon, corners) = p.split_at(n.min(4));
            let w = Window { min: corners[0], max: corners[1] };
            let clipped = clip(&w, polygon);
            prop_assert!(clipped.iter().all(|&p| w.contains(p)));
        }
    }
}
