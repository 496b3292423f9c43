//! The parts of a polygon's boundary strictly inside the window.

use ombra_math::glam::DVec2;
use ombra_math::work::{Count, Counter};

use super::ends::{Border, End, strict_code};
use crate::cohen_sutherland::Outcode;
use crate::crossing::Queue;
use crate::window::Window;

/// The parts of the boundary strictly inside, with their ends on the border.
pub(super) struct Chains {
    points: Vec<DVec2>,
    /// Where in `points` each chain ends.
    limits: Vec<usize>,
    pub(super) ends: Vec<End>,
    /// The polygon's first vertex is strictly inside: the first chain continues the last.
    pub(super) first_continues_last: bool,
}

impl Chains {
    pub(super) fn of(window: &Window, polygon: &[DVec2], work: &mut impl Count) -> Self {
        let border = Border { window, polygon };
        let mut code = polygon
            .first()
            .map_or(Outcode::ABOVE, |&p| strict_code(window, p));
        let first_inside = code.is_inside();
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

    /// How many there are.
    pub(super) fn number(&self) -> usize {
        self.limits.len()
    }

    /// The points of one.
    pub(super) fn points(&self, chain: usize) -> &[DVec2] {
        let limit = |i: usize| self.limits.get(i).copied().unwrap_or(0);
        let start = chain.checked_sub(1).map_or(0, limit);
        self.points.get(start..limit(chain)).unwrap_or_default()
    }
}
