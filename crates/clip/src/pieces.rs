//! A polygon against a window, in separate pieces.
//!
//! A concave polygon may fall into several parts. Its boundary enters and leaves the window; between leaving and the
//! next entry along the window's border runs the border of a piece. Joining each way out with the right way in gives
//! every piece for itself, without the edges back and forth that one outline for all needs.
#![cfg_attr(doc, doc = "")]
#![cfg_attr(doc, doc = include_str!("../figures/polygon-cases.svg"))]

use core::cmp::Ordering;

use ombra_math::glam::DVec2;
use ombra_math::work::{Count, Counter};

use crate::cohen_sutherland::Outcode;
use crate::crossing::{Queue, compare_quickly};
use crate::outline::{Outline, edges, is_finite, run};
use crate::segment::Segment;
use crate::window::{Line, Window};

use ends::{Border, End, strict_code};

mod ends;

/// The parts of a polygon in `window`, each a polygon of its own.
///
/// # Formula
///
/// ```text
/// chain: a part of the polygon's boundary strictly inside the window, from an entry E to an exit X on its border
/// counter-clockwise polygon: from X along the border, counter-clockwise, to the next E; clockwise: the other way
/// ```
///
/// # Properties
///
/// - Every point strictly inside the window and off the boundary has in the pieces together the winding number it has
///   in the polygon, whatever the input: 1 (or −1, clockwise) in one piece and 0 elsewhere for a simple polygon.
/// - Vertices inside are returned unchanged; new ones are the nearest doubles to the crossings, or corners of the
///   window. All lie in the window exactly, and a piece clipped again comes back unchanged.
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
    clip_polygon_counted(window, polygon, &mut ())
}

/// [`clip_polygon`], counting its [work](crate#counted-work).
#[must_use]
pub fn clip_polygon_counted(
    window: &Window,
    polygon: &[DVec2],
    work: &mut impl Count,
) -> Vec<Vec<DVec2>> {
    if !(window.min.x < window.max.x && window.min.y < window.max.y) {
        return Vec::new();
    }
    // As it is, if nothing lies outside.
    let (inside, _) = run(window, Outcode::INSIDE, polygon);
    work.add(Counter::Comparisons, 4 * inside as u64);
    if inside == polygon.len() {
        work.add(Counter::Vertices, inside as u64);
        let mut outline = Outline::with_capacity(inside);
        outline.points.extend_from_slice(polygon);
        return not_empty(outline.close(window)).into_iter().collect();
    }
    if !is_finite(polygon) {
        return Vec::new();
    }
    let chains = Chains::of(window, polygon, work);
    let winding = winding_beside_first_corner(window, polygon, work);
    if chains.ends.is_empty() {
        return around(window, winding);
    }
    chains.join(Border { window, polygon }, winding, work)
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
    (0..winding.unsigned_abs())
        .map(|_| corners.clone())
        .collect()
}

/// The parts of the boundary strictly inside, with their ends on the border.
struct Chains {
    points: Vec<DVec2>,
    /// Where in `points` each chain ends.
    limits: Vec<usize>,
    ends: Vec<End>,
    /// The polygon's first vertex is strictly inside: the first chain continues the last.
    first_continues_last: bool,
}

impl Chains {
    fn of(window: &Window, polygon: &[DVec2], work: &mut impl Count) -> Self {
        let first_inside = polygon
            .first()
            .is_some_and(|&p| strict_code(window, p).is_inside());
        let mut chains = Self {
            points: Vec::with_capacity(polygon.len()),
            limits: Vec::new(),
            ends: Vec::new(),
            first_continues_last: first_inside,
        };
        work.add(Counter::Vertices, polygon.len() as u64);
        work.add(Counter::Comparisons, 4 * polygon.len() as u64);
        if first_inside {
            chains.points.extend(polygon.first());
        }
        let next = polygon.iter().skip(1).chain(polygon.first());
        let mut code = polygon
            .first()
            .map_or(Outcode::INSIDE, |&p| strict_code(window, p));
        let border = Border { window, polygon };
        let mut queue = Queue::default();
        for (edge, &b) in next.enumerate() {
            let code_a = code;
            code = strict_code(window, b);
            if (code_a | code).is_inside() {
                chains.points.push(b);
            } else if (code_a & code).is_inside() {
                let chain = chains.limits.len();
                let [enters, leaves] = [!code_a.is_inside(), !code.is_inside()];
                let mut end = |is_entry| border.end(edge, is_entry, chain, work);
                let entry = if enters { end(true) } else { None };
                let exit = if leaves { end(false) } else { None };
                if entry.is_some() != enters || exit.is_some() != leaves {
                    continue; // it only touches
                }
                if let Some(entry) = entry {
                    chains.push(border, entry, &mut queue, work);
                }
                if let Some(exit) = exit {
                    chains.push(border, exit, &mut queue, work);
                    chains.limits.push(chains.points.len());
                } else {
                    chains.points.push(b);
                }
            }
        }
        queue.fill(&mut chains.points);
        for end in &mut chains.ends {
            end.point = chains.points.get(end.place).copied().unwrap_or_default();
        }
        if first_inside && !chains.ends.is_empty() {
            // The last edge led to the first vertex, which is there already.
            chains.points.pop();
            chains.limits.push(chains.points.len());
        }
        chains
    }

    /// Appends an end of a chain, its point to be computed with others if it is a crossing.
    fn push(&mut self, border: Border, end: End, queue: &mut Queue, work: &mut impl Count) {
        let place = self.points.len();
        self.points.push(end.point);
        if let Some(line) = end.crosses {
            work.add(Counter::Divisions, 1);
            if queue.is_full() {
                queue.fill(&mut self.points);
            }
            queue.push(border.edge(&end), line, place);
        }
        self.ends.push(End { place, ..end });
    }

    /// Joins each exit with the right entry; `winding` is that of the border's start.
    fn join(mut self, border: Border, winding: i64, work: &mut impl Count) -> Vec<Vec<DVec2>> {
        border.sort(&mut self.ends, false, work);
        // Past an exit of a counter-clockwise polygon the border runs inside it, past an entry outside.
        let step = |end: &End| if end.is_entry { -1 } else { 1 };
        let lowest = |ends: &[End]| running(winding, ends.iter().map(step)).min().unwrap_or(0);
        if lowest(&self.ends).min(winding) < 0 {
            // Clockwise: so that an edge out and back in meets itself here too.
            border.sort(&mut self.ends, true, work);
        }
        let least = lowest(&self.ends).min(winding);
        let most = running(winding, self.ends.iter().map(step))
            .max()
            .unwrap_or(0)
            .max(winding);
        // What winds round the whole border is the window itself, as often.
        let base = 0.clamp(least, most);
        let start = running(winding, self.ends.iter().map(step))
            .position(|w| w == base)
            .map_or(0, |i| i + 1);

        let mut next: Vec<Option<Link>> = vec![None; self.limits.len()];
        let mut open: Vec<(usize, End)> = Vec::new();
        let mut depth = 0;
        let ranked = self.ends.iter().copied().enumerate();
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
        if self.first_continues_last
            && let Some(slot) = next.last_mut()
        {
            *slot = Some(Link {
                to: 0,
                corners: 0,
                side: 0,
                forwards: true,
            });
        }
        let mut pieces = self.follow(border.window, next);
        pieces.extend(around(border.window, base));
        pieces
    }

    /// The loops that the links make of the chains.
    fn follow(&self, window: &Window, mut next: Vec<Option<Link>>) -> Vec<Vec<DVec2>> {
        let corners = window.corners();
        let mut pieces = Vec::new();
        for first in 0..next.len() {
            let mut outline = Outline::default();
            let mut chain = first;
            while let Some(link) = next.get_mut(chain).and_then(Option::take) {
                let from = chain.checked_sub(1).and_then(|i| self.limits.get(i));
                let range =
                    from.copied().unwrap_or(0)..self.limits.get(chain).copied().unwrap_or(0);
                let points = self.points.get(range).unwrap_or_default();
                outline.points.extend_from_slice(points);
                for k in 0..link.corners {
                    let side = if link.forwards {
                        link.side + 1 + k
                    } else {
                        link.side + 4 - k
                    };
                    if let Some(&corner) = corners.get(usize::from(side % 4)) {
                        outline.points.push(corner);
                    }
                }
                chain = link.to;
            }
            pieces.extend(not_empty(outline.close(window)));
        }
        pieces
    }
}

/// What follows a chain: so many corners of the window, from the exit's side on, then another chain.
#[derive(Clone, Copy)]
struct Link {
    to: usize,
    corners: u8,
    side: u8,
    /// Counter-clockwise.
    forwards: bool,
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
fn winding_beside_first_corner(window: &Window, polygon: &[DVec2], work: &mut impl Count) -> i64 {
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

#[cfg(test)]
mod tests;
