//! The active edges, carried from row to row.
//!
//! Rows are scanned up to the next one in which an edge begins or ends. Two edges bound one run; the crossings of a few
//! are sorted; many are stepped side by side, in an order that holds until edges cross. An edge left of the picture is
//! no active edge: it changes the winding number with which rows begin.

use core::cmp::Reverse;
use core::ops::Range;

use ombra_math::work::{Count, Counter};

use super::active::{Active, Entry};
use super::found::Found;
use super::row::Row;
use crate::edge::Edge;
use crate::polygon::FillRule;
use crate::span::Span;
use crate::step::{Steps, WIDEST};

/// From so many active edges on they are stepped side by side, down to half as many: to put edges in their places must
/// pay.
const MANY: usize = 10;
/// Most rows that are scanned at once for a few edges.
const ROWS: u32 = 64;

/// Iterator over the spans of a fill.
#[derive(Clone, Debug)]
pub(crate) struct Scan<C> {
    rule: FillRule,
    width: u32,
    /// The edges, and how to step along each.
    edges: Vec<(Edge, Steps)>,
    /// First row and index of the edges that have not begun, the next one last.
    waiting: Vec<(u32, usize)>,
    /// Changes of the winding number at the left border, the next one last.
    left: Vec<(u32, i64)>,
    /// Indices of the active edges, while they are few; of many, those about to be taken in.
    few: Vec<usize>,
    /// The active edges, when they are many.
    many: Active,
    /// Those about to be so.
    entries: Vec<Entry>,
    /// Crossings of few edges.
    crossings: Row,
    /// Winding number at the left border of the row.
    border: i64,
    /// The first row that has not been scanned.
    row: u32,
    /// Spans to be given out.
    found: Found,
    work: C,
}

impl<C: Count> Scan<C> {
    /// With no edge yet, and room for `edges`.
    pub fn new(edges: usize, rule: FillRule, width: u32, work: C) -> Self {
        Self {
            rule,
            width,
            edges: Vec::with_capacity(edges),
            waiting: Vec::with_capacity(edges),
            left: Vec::new(),
            few: Vec::new(),
            many: Active::default(),
            entries: Vec::new(),
            crossings: Row::default(),
            border: 0,
            row: 0,
            found: Found::default(),
            work,
        }
    }

    /// Enters an edge into the table.
    #[inline(always)]
    pub fn add(&mut self, edge: Edge) {
        match Steps::near(&edge, self.width) {
            Some(steps) => self.enter(edge, steps),
            None => self.add_far(edge),
        }
    }

    #[cold]
    fn add_far(&mut self, edge: Edge) {
        let steps = Steps::far(&edge, self.width);
        self.enter(edge, steps);
    }

    #[inline(always)]
    fn enter(&mut self, edge: Edge, steps: Steps) {
        if !steps.left.is_empty() {
            let gain = i64::from(edge.winding);
            self.left.push((steps.left.start, gain));
            self.left.push((steps.left.end, -gain));
        }
        if !steps.stepped.is_empty() {
            self.waiting.push((steps.stepped.start, self.edges.len()));
        }
        self.edges.push((edge, steps));
    }

    /// Puts the table in order, once all edges are in it.
    pub fn sort(&mut self) {
        // Vertices on a curve come as a few runs in order, which this sort only has to join.
        self.waiting.sort_by_key(|&(row, _)| Reverse(row));
        self.left.sort_unstable_by_key(|&(row, _)| Reverse(row));
        self.work.add(Counter::EdgeRecords, self.edges.len() as u64);
    }

    /// Finds the spans of the next rows that have some; `false` where there are none.
    #[inline(never)]
    fn scan(&mut self) -> bool {
        self.found.clear();
        while self.found.is_empty() {
            if self.few.is_empty() && self.many.is_empty() && !self.rule.contains(self.border) {
                // Empty rows cost nothing.
                match self.next_event() {
                    Some(row) => self.row = self.row.max(row),
                    None => break,
                }
            }
            self.border_at(self.row);
            self.take_in();
            if !self.many.is_empty() {
                self.scan_many();
            } else if let &[a, b] = self.few.as_slice() {
                self.scan_two([a, b]);
            } else {
                self.scan_few();
            }
        }
        !self.found.is_empty()
    }

    /// The next row where an edge begins or the winding number at the left border changes.
    fn next_event(&self) -> Option<u32> {
        let begins = self.waiting.last().map(|waiting| waiting.0);
        let changes = self.left.last().map(|left| left.0);
        begins.into_iter().chain(changes).min()
    }

    /// Brings the winding number at the left border to `row`.
    fn border_at(&mut self, row: u32) {
        while let Some((_, gain)) = self.left.pop_if(|left| left.0 <= row) {
            self.border += gain;
        }
    }

    /// Takes in the edges that begin at the row.
    fn take_in(&mut self) {
        let row = self.row;
        while let Some((_, index)) = self.waiting.pop_if(|waiting| waiting.0 <= row) {
            self.few.push(index);
        }
        if !self.many.is_empty() || (self.few.len() >= MANY && self.width <= WIDEST) {
            for index in self.few.drain(..) {
                if let Some(edge) = self.edges.get(index) {
                    self.entries.push(Entry::new(index, edge, row));
                }
            }
            self.many.begin(&mut self.entries);
        }
    }

    /// The spans of the next row that has some, of those that the same many edges cross.
    fn scan_many(&mut self) {
        let row = (self.rule, self.width, self.border);
        let end = self
            .next_event()
            .unwrap_or(u32::MAX)
            .min(self.many.next_end());
        while self.row < end && self.found.is_empty() {
            let (found, work) = (&mut self.found, &mut self.work);
            (self.many).scan_row(self.row, row, &self.edges, found, work);
            self.row += 1;
        }
        if self.row == self.many.next_end() {
            let (row, edges, few) = (self.row, &self.edges, &mut self.few);
            self.many.end_at(row, |index| {
                if edges
                    .get(index)
                    .is_some_and(|(_, steps)| steps.stepped.end > row)
                {
                    few.push(index);
                }
            });
            if self.many.len() < MANY / 2 {
                self.few.extend(self.many.drain());
            }
        }
    }

    /// Rows that are crossed by the same few edges, the first of which ends at `end`.
    fn rows_to(&self, end: u32) -> Range<u32> {
        let end = self.next_event().map_or(end, |row| row.min(end));
        self.row..end.min(self.row.saturating_add(ROWS))
    }

    /// The spans of rows that the same two edges cross.
    fn scan_two(&mut self, indices: [usize; 2]) {
        let [a, b] = indices.map(|index| self.edges.get(index));
        let (Some((a, a_steps)), Some((b, b_steps))) = (a, b) else {
            return self.few.clear();
        };
        let (rule, width, border) = (self.rule, self.width, self.border);
        let after = border + i64::from(a.winding) + i64::from(b.winding);
        if rule.contains(border) || rule.contains(after) {
            return self.scan_few();
        }
        // Outside on either side of two edges, as in every convex polygon: one run between them.
        let (a_end, b_end) = (a_steps.stepped.end, b_steps.stepped.end);
        let rows = self.rows_to(a_end.min(b_end));
        let mut kept = 0;
        let spans = self.found.room(rows.len());
        for y in rows.clone() {
            let a = a_steps.stepped_column(a, y, width, &mut self.work);
            let b = b_steps.stepped_column(b, y, width, &mut self.work);
            if let Some(span) = spans.get_mut(kept) {
                let x = a.min(b)..a.max(b);
                *span = Span { y, x };
            }
            kept += usize::from(a != b);
        }
        self.found.keep(kept);
        self.row = rows.end;
        self.work
            .add(Counter::EdgeRecords, 2 * u64::from(rows.end - rows.start));
        if b_end == rows.end {
            self.few.pop();
        }
        if a_end == rows.end {
            self.few.swap_remove(0);
        }
    }

    /// The spans of rows that the same few edges cross.
    fn scan_few(&mut self) {
        let ends = self
            .few
            .iter()
            .filter_map(|&index| Some(self.edges.get(index)?.1.stepped.end));
        let rows = self.rows_to(ends.fold(u32::MAX, u32::min));
        for y in rows.clone() {
            self.sort_row(y);
        }
        self.row = rows.end;
        let crossings = self.few.len() as u64 * u64::from(rows.end - rows.start);
        self.work.add(Counter::EdgeRecords, crossings);
        let (edges, end) = (&self.edges, rows.end);
        (self.few).retain(|&index| edges.get(index).is_some_and(|(_, s)| s.stepped.end > end));
    }

    /// The spans of one row, its crossings sorted.
    fn sort_row(&mut self, y: u32) {
        let (rule, width, border) = (self.rule, self.width, self.border);
        let columns = self.crossings.columns(self.few.len());
        let active = self.few.iter().filter_map(|&index| self.edges.get(index));
        for (column, (edge, steps)) in columns.iter_mut().zip(active.clone()) {
            *column = steps.stepped_column(edge, y, width, &mut self.work);
        }
        self.crossings
            .order(rule, width, border, active.map(|(edge, _)| edge.winding));
        self.crossings
            .spans(y, rule.contains(border), width, &mut self.found);
    }
}

impl<C: Count> Iterator for Scan<C> {
    type Item = Span;

    #[inline]
    fn next(&mut self) -> Option<Span> {
        loop {
            if let Some(span) = self.found.take() {
                self.work.add(Counter::Fragments, u64::from(span.len()));
                return Some(span);
            }
            if !self.scan() {
                return None;
            }
        }
    }
}
