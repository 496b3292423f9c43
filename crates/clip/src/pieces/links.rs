//! Which chain follows which along the border.

use core::cmp::Ordering;

use ombra_math::glam::DVec2;
use ombra_math::work::{Count, Counter};

use super::chains::Chains;
use super::ends::{Border, End};
use crate::crossing::compare_quickly;
use crate::outline::edges;
use crate::segment::Segment;
use crate::window::{Line, Window};

/// What follows a chain: so many corners of the window, from the exit's side on, then another chain.
#[derive(Clone, Copy)]
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
            let side = if self.forwards {
                self.side + 1 + k
            } else {
                self.side + 4 - k
            };
            corners.get(usize::from(side % 4)).copied()
        })
    }
}

/// The links of all chains.
pub(super) struct Links {
    /// For each chain what follows.
    pub(super) next: Vec<Option<Link>>,
    /// How often the polygon winds round the whole window besides.
    pub(super) around: i64,
}

impl Links {
    /// Joins each exit with the right entry; `winding` is that of the border's start.
    pub(super) fn of(
        chains: &mut Chains,
        border: Border,
        winding: i64,
        work: &mut impl Count,
    ) -> Self {
        border.sort(&mut chains.ends, false, work);
        // Past an exit of a counter-clockwise polygon the border runs inside it, past an entry outside.
        let step = |end: &End| if end.is_entry { -1 } else { 1 };
        let lowest = |ends: &[End]| running(winding, ends.iter().map(step)).min().unwrap_or(0);
        if lowest(&chains.ends).min(winding) < 0 {
            // Clockwise: so that an edge out and back in meets itself here too.
            border.sort(&mut chains.ends, true, work);
        }
        let least = lowest(&chains.ends).min(winding);
        let most = running(winding, chains.ends.iter().map(step))
            .max()
            .unwrap_or(0)
            .max(winding);
        // What winds round the whole border is the window itself, as often.
        let base = 0.clamp(least, most);
        let start = running(winding, chains.ends.iter().map(step))
            .position(|w| w == base)
            .map_or(0, |i| i + 1);

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
            let (exit, entry) = if end.is_entry {
                (earlier, end)
            } else {
                (end, earlier)
            };
            let link = Link {
                to: entry.chain,
                corners,
                side: exit.side,
                forwards: end.is_entry,
            };
            if let Some(slot) = next.get_mut(exit.chain) {
                *slot = Some(link);
            }
        }
        if chains.first_continues_last
            && let Some(slot) = next.last_mut()
        {
            *slot = Some(Link {
                to: 0,
                corners: 0,
                side: 0,
                forwards: true,
            });
        }
        Self { next, around: base }
    }
}

/// The sums of `start` and the steps so far, after each step.
fn running(start: i64, steps: impl Iterator<Item = i64>) -> impl Iterator<Item = i64> {
    steps.scan(start, |w, step| {
        *w += step;
        Some(*w)
    })
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
        let left = match compare_quickly(
            Segment::new(low, high),
            Line::Horizontal(corner.y),
            corner.x,
        ) {
            Ordering::Less => true,
            Ordering::Equal => high.x <= low.x,
            Ordering::Greater => false,
        };
        if left {
            winding += if rises { -1 } else { 1 };
        }
    }
    winding
}
