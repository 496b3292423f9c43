//! Which chain follows which along the border.

use core::iter::once;

use ombra_math::glam::DVec2;
use ombra_math::work::{Count, Counter};

use super::chains::Chains;
use super::ends::{Border, End};
use crate::crossing::compare_quickly;
use crate::outline::edges;
use crate::segment::Segment;
use crate::window::{Line, Window};

/// What follows a chain: so many corners of the window, from the exit's side on, then another chain; without more, the
/// first chain.
#[derive(Clone, Copy, Default)]
pub(super) struct Link {
    pub(super) to: usize,
    corners: u8,
    side: u8,
    /// Counter-clockwise.
    forwards: bool,
}

impl Link {
    /// The corners on the way.
    pub(super) fn corners(self, window: &Window) -> impl Iterator<Item = DVec2> {
        let corners = window.corners();
        (0..self.corners).filter_map(move |k| {
            let side = match self.forwards {
                true => self.side + 1 + k,
                false => self.side + 4 - k,
            };
            corners.get(usize::from(side % 4)).copied()
        })
    }
}

/// Joins each exit with the right entry, `winding` being that of the border's start: what follows each chain, and how
/// often the polygon winds round the whole window besides.
pub(super) fn links(
    chains: &mut Chains,
    border: Border,
    winding: i64,
    work: &mut impl Count,
) -> (Vec<Option<Link>>, i64) {
    let lowest = |ends: &[End]| windings(winding, ends).min().unwrap_or(0);
    border.sort(&mut chains.ends, false, work);
    if lowest(&chains.ends) < 0 {
        // Clockwise: so that an edge out and back in meets itself here too.
        border.sort(&mut chains.ends, true, work);
    }
    let most = windings(winding, &chains.ends).max().unwrap_or(0);
    // What winds round the whole border is the window itself, as often.
    let base = 0.clamp(lowest(&chains.ends), most);
    let mut after_ends = windings(winding, &chains.ends).skip(1);
    let start = after_ends.position(|w| w == base).map_or(0, |i| i + 1);

    let mut next: Vec<Option<Link>> = vec![None; chains.number()];
    let mut open: Vec<(usize, End)> = Vec::new();
    let mut depth = 0;
    let ranked = chains.ends.iter().copied().enumerate();
    for (rank, end) in ranked.clone().skip(start).chain(ranked.take(start)) {
        let opens = if end.is_entry { depth <= 0 } else { depth >= 0 };
        depth += step(&end);
        if opens {
            open.push((rank, end));
            continue;
        }
        let Some((earlier_rank, earlier)) = open.pop() else {
            continue;
        };
        let mut corners = (end.side + 4 - earlier.side) % 4;
        if corners == 0 && rank < earlier_rank {
            corners = 4;
        }
        let (exit, entry) = match end.is_entry {
            true => (earlier, end),
            false => (end, earlier),
        };
        if let Some(link) = next.get_mut(exit.chain) {
            *link = Some(Link {
                to: entry.chain,
                corners,
                side: exit.side,
                forwards: end.is_entry,
            });
        }
    }
    if let Some(link) = next.last_mut().filter(|_| chains.first_continues_last) {
        *link = Some(Link::default());
    }
    (next, base)
}

/// How the winding number changes past an end, counter-clockwise along the border: past an exit of a counter-clockwise
/// polygon the border runs inside it, past an entry outside.
fn step(end: &End) -> i64 {
    if end.is_entry { -1 } else { 1 }
}

/// The winding numbers along the border: at its start, and after each end.
fn windings(start: i64, ends: &[End]) -> impl Iterator<Item = i64> {
    let after = ends.iter().scan(start, |winding, end| {
        *winding += step(end);
        Some(*winding)
    });
    once(start).chain(after)
}

/// The winding number of the polygon just inside the corner `min`: right of the left side by less than above the lower.
///
/// A ray to the left from there meets the edges from below or on y_min to above it, if they cross y_min left of the
/// corner, or at it and lean left or stand upright.
pub(super) fn winding_beside_first_corner(
    window: &Window,
    polygon: &[DVec2],
    work: &mut impl Count,
) -> i64 {
    let corner = window.min;
    let mut winding = 0;
    for (a, b) in edges(polygon) {
        let rises = b.y > corner.y;
        work.add(Counter::Comparisons, 2);
        if (a.y > corner.y) == rises {
            continue;
        }
        let [low, high] = if rises { [a, b] } else { [b, a] };
        work.add(Counter::Multiplications, 2);
        work.add(Counter::Comparisons, 1);
        let line = Line::Horizontal(corner.y);
        let order = compare_quickly(Segment::new(low, high), line, corner.x);
        if order.is_lt() || (order.is_eq() && high.x <= low.x) {
            winding += if rises { -1 } else { 1 };
        }
    }
    winding
}
