//! The four sides, two behind two: each edge passes the lines above and below, then those to the right and
//! left; a crossing is computed only if it stays.

use core::cmp::Ordering;

use ombra_math::glam::DVec2;
use ombra_math::work::{Count, Counter};

use crate::cohen_sutherland::Outcode;
use crate::crossing::{LENGTH, Queue, compare_quickly};
use crate::outline::{Outline, run};
use crate::segment::Segment;
use crate::window::{Line, Window};

mod block;
mod together;

const ABOVE: u8 = Outcode::ABOVE.bits();
const RIGHT: u8 = Outcode::RIGHT.bits();
const ABOVE_OR_BELOW: u8 = ABOVE | Outcode::BELOW.bits();
const RIGHT_OR_LEFT: u8 = RIGHT | Outcode::LEFT.bits();

/// A point of the polygon cut above and below.
#[derive(Clone, Copy)]
struct Point {
    /// Whether it is to the right or left of the window.
    code: u8,
    y: f64,
    /// NaN for a crossing that is not exactly on one of the sides.
    x: f64,
    /// The way here is an edge of the polygon; otherwise the border, from where the polygon had left.
    along_edge: bool,
}

/// What has passed the sides, and what came last to each.
pub(super) struct Pipeline<'a> {
    window: &'a Window,
    /// The first point that came to the sides right and left, and the last one.
    first: Option<Point>,
    last: Option<Point>,
    out: Outline,
    /// Crossings in `out` that are still to be computed.
    queue: Queue,
}

impl<'a> Pipeline<'a> {
    pub(super) fn new(window: &'a Window, vertices: usize) -> Self {
        Self {
            window,
            first: None,
            last: None,
            out: Outline::of(Vec::with_capacity(vertices + vertices / 2 + 4)),
            queue: Queue::default(),
        }
    }

    /// The first vertex.
    pub(super) fn start(&mut self, p: DVec2, code: Outcode) {
        if code.bits() & ABOVE_OR_BELOW == 0 {
            let point = Point::vertex(p, code.bits(), false);
            (self.first, self.last) = (Some(point), Some(point));
        }
        if code.is_inside() {
            self.out.points.push(p);
        }
    }

    /// The edges between these vertices, of which the first has been reached and lies in the region `code`; the answer
    /// is the region of the last.
    pub(super) fn one_by_one(
        &mut self,
        mut code: Outcode,
        vertices: &[DVec2],
        work: &mut impl Count,
    ) -> Outcode {
        let Some((&first, mut after)) = vertices.split_first() else {
            return code;
        };
        work.add(Counter::Vertices, after.len() as u64);
        work.add(Counter::Comparisons, 4 * after.len() as u64);
        let mut a = first;
        loop {
            // Within a run of vertices of one region no side is crossed.
            let (length, next_code) = run(self.window, code, after);
            let (inner, next) = after.split_at(length);
            if let Some(&end) = inner.last() {
                a = end;
                self.go_on(inner, end, code);
            }
            let Some((&b, rest)) = next.split_first() else {
                return code;
            };
            self.edge(Segment::new(a, b), [code, next_code], work);
            (a, code, after) = (b, next_code, rest);
        }
    }

    /// Vertices in the region of the one before; `end` is the last of them.
    #[inline]
    fn go_on(&mut self, vertices: &[DVec2], end: DVec2, code: Outcode) {
        if code.is_inside() {
            self.out.points.extend_from_slice(vertices);
            if vertices.len() > LENGTH {
                self.settle();
            }
        }
        if code.bits() & ABOVE_OR_BELOW == 0 {
            self.last = Some(Point::vertex(end, code.bits(), true));
        }
    }

    /// The edge to the next vertex, in another region.
    #[inline(always)]
    fn edge(&mut self, edge: Segment, codes: [Outcode; 2], work: &mut impl Count) {
        let codes = codes.map(Outcode::bits);
        let along_edge = self.above_and_below(edge, codes, work);
        let [_, code] = codes;
        if code & ABOVE_OR_BELOW == 0 {
            self.right_and_left(edge, Point::vertex(edge.b, code, along_edge), work);
        }
        if code == 0 {
            self.out.points.push(edge.b);
        }
    }

    /// The edge back to the first vertex; the answer is the polygon.
    pub(super) fn close(
        mut self,
        edge: Segment,
        codes: [Outcode; 2],
        work: &mut impl Count,
    ) -> Vec<DVec2> {
        let codes = codes.map(Outcode::bits);
        let along_edge = self.above_and_below(edge, codes, work);
        if let Some(mut point) = self.first {
            if codes[1] & ABOVE_OR_BELOW == 0 {
                point.along_edge = along_edge;
            }
            self.right_and_left(edge, point, work);
        }
        self.settle();
        self.out.close(self.window)
    }

    /// Appends the point where an edge crosses a line, to be computed with others.
    #[inline]
    fn push_crossing(&mut self, edge: Segment, line: Line, work: &mut impl Count) {
        work.add(Counter::Divisions, 1);
        if self.queue.is_full() {
            self.settle();
        }
        self.queue.push(edge, line, self.out.points.len());
        self.out.points.push(DVec2::ZERO);
    }

    /// Computes what waits and takes out repeated points, while all are in the nearest cache.
    fn settle(&mut self) {
        self.queue.fill(&mut self.out.points);
        self.out.settle();
    }

    /// Where an edge crosses the lines above and below; the answer is whether the edge leads on from there.
    #[inline(always)]
    fn above_and_below(&mut self, edge: Segment, [a, b]: [u8; 2], work: &mut impl Count) -> bool {
        // From beyond a line, the way to where it is met is the border.
        let along_edge = a & ABOVE_OR_BELOW == 0;
        match (a ^ b) & ABOVE_OR_BELOW {
            0 => along_edge,
            ABOVE_OR_BELOW => self.through_strip(edge, [a, b], work),
            one => self.level(edge, [a, b], one, along_edge, work),
        }
    }

    /// An edge from above the window to below it, or upwards.
    #[inline(never)]
    fn through_strip(&mut self, edge: Segment, [a, b]: [u8; 2], work: &mut impl Count) -> bool {
        let (first, second) = (a & ABOVE_OR_BELOW, b & ABOVE_OR_BELOW);
        let along_edge = self.level(edge, [a, b], first, false, work);
        self.level(edge, [a, b], second, along_edge, work)
    }

    /// Where an edge with its ends on either side of one of these two lines, or one end on it, crosses it.
    #[inline(always)]
    fn level(
        &mut self,
        edge: Segment,
        codes: [u8; 2],
        side: u8,
        along_edge: bool,
        work: &mut impl Count,
    ) -> bool {
        let [min, max] = [self.window.min.y, self.window.max.y];
        let y = if side == ABOVE { max } else { min } + 0.0;
        let inner = if codes[0] & side == 0 { edge.a } else { edge.b };
        if inner.y == y {
            // The vertex on the line stands for the crossing.
            return along_edge;
        }
        let line = Line::Horizontal(y);
        let (code, x) = self.place_of_crossing(edge, line, codes, work);
        let point = Point {
            code,
            x,
            y,
            along_edge,
        };
        self.right_and_left(edge, point, work);
        if code == 0 {
            self.push_crossing(edge, line, work);
        }
        true
    }

    /// Where a level line is crossed: right of the window, left of it, on one of the sides, or between them; exact.
    #[inline]
    fn place_of_crossing(
        &self,
        edge: Segment,
        line: Line,
        [a, b]: [u8; 2],
        work: &mut impl Count,
    ) -> (u8, f64) {
        let (a, b) = (a & RIGHT_OR_LEFT, b & RIGHT_OR_LEFT);
        if a == b {
            let upright = edge.a.x == edge.b.x;
            return (a, if upright { edge.a.x } else { f64::NAN });
        }
        let sides = [
            (RIGHT, self.window.max.x, Ordering::Greater),
            (Outcode::LEFT.bits(), self.window.min.x, Ordering::Less),
        ];
        for (bit, side, beyond) in sides {
            if (a | b) & bit == 0 {
                continue;
            }
            work.add(Counter::Multiplications, 2);
            work.add(Counter::Comparisons, 1);
            let order = compare_quickly(edge, line, side);
            if order == beyond {
                return (bit, f64::NAN);
            } else if order == Ordering::Equal {
                return (0, side);
            }
        }
        (0, f64::NAN)
    }

    /// Where the way from the last point to the next, which is on `edge`, crosses the lines to the right and left.
    #[inline(always)]
    fn right_and_left(&mut self, edge: Segment, to: Point, work: &mut impl Count) {
        let Some(from) = self.last.replace(to) else {
            self.first = Some(to);
            return;
        };
        match (from.code ^ to.code) & RIGHT_OR_LEFT {
            0 => {}
            RIGHT_OR_LEFT => {
                // From one side to the other.
                self.upright(edge, [from, to], from.code, work);
                self.upright(edge, [from, to], to.code, work);
            }
            one => self.upright(edge, [from, to], one, work),
        }
    }

    /// Where that way crosses one of these two lines.
    #[inline(always)]
    fn upright(&mut self, edge: Segment, [from, to]: [Point; 2], side: u8, work: &mut impl Count) {
        let [min, max] = [self.window.min.x, self.window.max.x];
        let x = if side == RIGHT { max } else { min } + 0.0;
        let inner = if from.code & side == 0 { from.x } else { to.x };
        if inner == x {
            return;
        }
        if to.along_edge {
            self.push_crossing(edge, Line::Vertical(x), work);
        } else {
            // The border turns at a corner.
            self.out.points.push(DVec2::new(x, from.y));
        }
    }
}

impl Point {
    #[inline]
    fn vertex(p: DVec2, code: u8, along_edge: bool) -> Self {
        Self {
            code: code & RIGHT_OR_LEFT,
            x: p.x,
            y: p.y,
            along_edge,
        }
    }
}
