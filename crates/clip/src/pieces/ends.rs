//! Where the polygon's boundary crosses the window's border, and in which order along it.

use core::cmp::Ordering;

use ombra_math::exact::Sum;
use ombra_math::glam::DVec2;
use ombra_math::work::{Count, Counter};

use crate::cohen_sutherland::Outcode;
use crate::crossing::{compare_exactly, compare_quickly};
use crate::segment::Segment;
use crate::window::{Line, Side, Window};

/// The sides on the way counter-clockwise from `min`.
const AROUND: [Side; 4] = [Side::Below, Side::Right, Side::Above, Side::Left];

/// Where a chain meets the border.
#[derive(Clone, Copy)]
pub(super) struct End {
    /// The nearest double.
    pub(super) point: DVec2,
    /// The number of its side in [`AROUND`]; a corner belongs to the side that starts there.
    pub(super) side: u8,
    /// An entry; otherwise an exit.
    pub(super) is_entry: bool,
    /// The line of the side that the edge crosses at an inner point; otherwise `point` is exact.
    pub(super) crosses: Option<Line>,
    /// The number of its edge, of its place among the points of all chains, and of its chain.
    pub(super) edge: usize,
    pub(super) place: usize,
    pub(super) chain: usize,
}

/// The region of `p` with the border counted as outside: 0000 only strictly inside.
#[inline]
pub(super) fn strict_code(window: &Window, p: DVec2) -> Outcode {
    let bit = |is: bool, code: Outcode| if is { code } else { Outcode::INSIDE };
    bit(p.y >= window.max.y, Outcode::ABOVE)
        | bit(p.y <= window.min.y, Outcode::BELOW)
        | bit(p.x >= window.max.x, Outcode::RIGHT)
        | bit(p.x <= window.min.x, Outcode::LEFT)
}

/// Where an edge, coming from beyond the line of a side, crosses it: the corner, or the line of which a point within the
/// side is still to be computed. Decided exactly; `None` outside the window.
fn meets(
    window: &Window,
    edge: Segment,
    side: Side,
    work: &mut impl Count,
) -> Option<(DVec2, Option<Line>)> {
    let Segment { a, b } = edge;
    let line = window.line(side);
    let [_, along] = line.turn(a, b);
    let [_, [low, high]] = line.turn(window.min, window.max);
    // Between ends that both lie within a limit, so does the crossing.
    for (limit, outside) in [(low, Ordering::Less), (high, Ordering::Greater)] {
        work.add(Counter::Comparisons, 2);
        let within = |x: f64| x.partial_cmp(&limit) == Some(outside.reverse());
        if along.into_iter().all(within) {
            continue;
        }
        work.add(Counter::Multiplications, 2);
        work.add(Counter::Comparisons, 1);
        let order = compare_quickly(edge, line, limit);
        if order == outside {
            return None;
        } else if order == Ordering::Equal {
            return Some((line.point(limit + 0.0), None));
        }
    }
    Some((DVec2::ZERO, Some(line)))
}

/// A polygon and the window's border that it crosses.
#[derive(Clone, Copy)]
pub(super) struct Border<'a> {
    pub(super) window: &'a Window,
    pub(super) polygon: &'a [DVec2],
}

impl Border<'_> {
    /// The edge, on its way into the window.
    fn inwards(self, edge: usize, is_entry: bool) -> Segment {
        let vertex = |i: usize| self.polygon.get(i).or(self.polygon.first());
        let a = vertex(edge).copied().unwrap_or_default();
        let b = vertex(edge + 1).copied().unwrap_or_default();
        let edge = Segment::new(a, b);
        if is_entry { edge } else { edge.reversed() }
    }

    /// Where an edge enters the inside of the window, or leaves it; `None` if it only touches. It must not lie beyond
    /// or along one side. The point of a crossing is still to be computed.
    pub(super) fn end(
        self,
        edge: usize,
        is_entry: bool,
        chain: usize,
        work: &mut impl Count,
    ) -> Option<End> {
        let window = self.window;
        let inwards = self.inwards(edge, is_entry);
        let Segment { a, b } = inwards;
        let end = |point, side, crosses| End {
            point,
            side,
            is_entry,
            crosses,
            edge,
            place: 0,
            chain,
        };
        work.add(Counter::Comparisons, 4);
        if window.contains(a) {
            return Some(end(a, side_of(window, a), None));
        }
        let (side, (corner, crosses)) = Side::ALL
            .into_iter()
            .filter(|&side| window.is_beyond(side, a))
            .find_map(|side| Some((side, meets(window, inwards, side, work)?)))?;
        if crosses.is_some() {
            let number = AROUND.iter().position(|&s| s == side)? as u8;
            return Some(end(DVec2::ZERO, number, crosses));
        }
        let goes_in = (strict_code(window, corner) & strict_code(window, b)).is_inside();
        goes_in.then(|| end(corner, side_of(window, corner), None))
    }

    /// The edge that an end is on, the way the polygon runs.
    pub(super) fn edge(self, end: &End) -> Segment {
        self.inwards(end.edge, true)
    }

    /// Puts ends in their order along the border; of an edge out and the same edge back in, exits or entries first.
    pub(super) fn sort(self, ends: &mut Vec<End>, entries_first: bool, work: &mut impl Count) {
        // By rounded position first, which integers compare fastest; then, where those are equal, exactly.
        let mut ranks: Vec<u128> = ends
            .iter()
            .enumerate()
            .map(|(i, end)| {
                let along = u128::from(ordered_bits(end.along()));
                u128::from(end.side) << 126 | along << 62 | i as u128
            })
            .collect();
        let mut by_rank = |a: &u128, b: &u128| {
            work.add(Counter::Comparisons, 1);
            a.cmp(b)
        };
        // Along a polygon that follows the border, long runs are in order already: the stable sort finds them.
        let breaks = ranks.windows(2).filter(|pair| pair.first() > pair.last());
        if breaks.count() * 16 < ranks.len() {
            ranks.sort_by(&mut by_rank);
        } else {
            ranks.sort_unstable_by(&mut by_rank);
        }
        let number = |rank: u128| (rank & ((1 << 62) - 1)) as usize;
        let mut sorted: Vec<End> = Vec::with_capacity(ends.len());
        sorted.extend(ranks.iter().filter_map(|&rank| ends.get(number(rank))));
        let same_place = |e: &End, f: &End| e.side == f.side && e.along() == f.along();
        for group in sorted.chunk_by_mut(same_place) {
            if group.len() > 1 {
                group.sort_by(|e, f| {
                    let kind = e.is_entry.cmp(&f.is_entry);
                    let kind = if entries_first { kind.reverse() } else { kind };
                    self.exact_order(e, f)
                        .then_with(|| self.order_of_directions(e, f))
                        .then(kind)
                });
            }
        }
        *ends = sorted;
    }

    /// The order of two ends on one side whose points are the same double.
    fn exact_order(self, e: &End, f: &End) -> Ordering {
        let side = AROUND.get(usize::from(e.side)).unwrap_or(&Side::Left);
        let line = self.window.line(*side);
        let [_, [limit, _]] = line.turn(e.point, e.point);
        let order = match (e.crosses.is_some(), f.crosses.is_some()) {
            (false, false) => Ordering::Equal,
            (true, false) => compare_exactly(self.edge(e), line, limit),
            (false, true) => compare_exactly(self.edge(f), line, limit).reverse(),
            (true, true) => order_of_crossings(self.edge(e), self.edge(f), line),
        };
        // Along the upper side and the left one the way is back.
        if e.side < 2 { order } else { order.reverse() }
    }

    /// Of two ends at one point, the one whose edge leans back more is met first just inside the border.
    fn order_of_directions(self, e: &End, f: &End) -> Ordering {
        let [d, g] = [e, f].map(|end| self.inwards(end.edge, end.is_entry));
        // (g.b − g.a) × (d.b − d.a), positive where d leans back more.
        let cross = [(g, d, 1.0), (d, g, -1.0)].map(|(u, v, sign)| {
            [
                [sign * u.b.x, v.b.y, 1.0],
                [-sign * u.b.x, v.a.y, 1.0],
                [-sign * u.a.x, v.b.y, 1.0],
                [sign * u.a.x, v.a.y, 1.0],
            ]
        });
        let sign = Sum::of(&cross.concat()).sign();
        sign.unwrap_or(Ordering::Equal).reverse()
    }
}

impl End {
    /// The position along its side, on the way counter-clockwise.
    fn along(&self) -> f64 {
        match self.side {
            0 => self.point.x,
            1 => self.point.y,
            2 => -self.point.x,
            _ => -self.point.y,
        }
    }
}

/// The side of a point on the border; of a corner, the one that starts there.
fn side_of(window: &Window, p: DVec2) -> u8 {
    let (right, left) = (p.x == window.max.x, p.x == window.min.x);
    let (above, below) = (p.y == window.max.y, p.y == window.min.y);
    match (below, right, above, left) {
        (true, false, ..) => 0,
        (_, true, false, _) => 1,
        (_, _, true, false) => 2,
        _ => 3,
    }
}

/// An integer that compares as the number does, 0 and −0 alike.
fn ordered_bits(x: f64) -> u64 {
    let bits = (x + 0.0).to_bits();
    if bits >> 63 == 0 {
        bits | 1 << 63
    } else {
        !bits
    }
}

/// Which of two edges crosses `line` first along it.
///
/// ```text
/// sign of N₁ D₂ − N₂ D₁,  y = N / D,  N = y_a (x_b − c) + y_b (c − x_a),  D = x_b − x_a > 0
/// ```
fn order_of_crossings(e: Segment, f: Segment, line: Line) -> Ordering {
    let coordinates = |s: Segment| {
        let [[a, b], [a_along, b_along]] = line.turn(s.a, s.b);
        let ends = ([a, a_along], [b, b_along]);
        if a < b { ends } else { (ends.1, ends.0) }
    };
    let c = line.place();
    let mut sum = Sum::default();
    for (first, second, sign) in [(e, f, 1.0), (f, e, -1.0)] {
        let ((a, b), (p, q)) = (coordinates(first), coordinates(second));
        for d in [q[0], -p[0]] {
            sum.add([sign * a[1], b[0], d]);
            sum.add([-sign * a[1], c, d]);
            sum.add([sign * b[1], c, d]);
            sum.add([-sign * b[1], a[0], d]);
        }
    }
    sum.sign().unwrap_or(Ordering::Equal)
}
