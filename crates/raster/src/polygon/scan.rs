//! The active edges, carried from band to band: the fast form of the fill.
//!
//! Where few edges are active, rows are scanned up to the next one in which an edge begins or ends: two edges bound
//! one run, the crossings of more are sorted. Where many are, each edge marks its crossings in a table of one bit a
//! pixel, for a band of rows at once; the table then gives them in order, without a comparison. An edge left of the
//! picture is no active edge: it changes the winding number with which rows begin.

use core::cmp::Reverse;
use core::ops::Range;

use ombra_math::work::{Count, Counter};

use super::FillRule;
use super::edge::Edge;
use super::marks::{Marks, ROWS, WIDEST};
use super::step::Steps;
use crate::span::Span;

/// With fewer active edges than this, crossings are sorted and not marked.
const FEW: usize = 16;

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
    /// Indices of the active edges.
    active: Vec<usize>,
    /// Winding number at the left border of the row.
    border: i64,
    /// The first row that has not been scanned.
    row: u32,
    /// Crossings of one row: column, and what the winding number gains there.
    crossings: Vec<(u32, i32)>,
    /// Crossings of a band.
    marks: Marks,
    /// Spans that have been found, and how many of them have been given out.
    found: Vec<Span>,
    given: usize,
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
            active: Vec::new(),
            border: 0,
            row: 0,
            crossings: Vec::new(),
            marks: Marks::default(),
            found: Vec::new(),
            given: 0,
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

    /// Finds the spans of the next row, or rows, that can have some; `false` where there is none.
    fn scan(&mut self) -> bool {
        self.found.clear();
        self.given = 0;
        if self.active.is_empty() && !self.rule.contains(self.border) {
            // Empty rows cost nothing.
            let begins = self.waiting.last().map(|waiting| waiting.0);
            let changes = self.left.last().map(|left| left.0);
            match begins.into_iter().chain(changes).min() {
                Some(row) => self.row = self.row.max(row),
                None => return false,
            }
        }
        let first = self.row;
        self.take_in(first);
        if self.active.len() < FEW || self.width > WIDEST {
            self.border_at(first);
            let rows = first..self.next_change(first);
            self.row = rows.end;
            self.scan_rows(rows);
        } else {
            self.row = first.saturating_add(ROWS);
            self.take_in(self.row - 1);
            self.mark_band(first);
        }
        let (edges, end) = (&self.edges, self.row);
        self.active
            .retain(|&index| edges.get(index).is_some_and(|(_, s)| s.stepped.end > end));
        true
    }

    /// The active edges.
    fn active(&self) -> impl Iterator<Item = &(Edge, Steps)> {
        self.active
            .iter()
            .filter_map(|&index| self.edges.get(index))
    }

    /// The first row after `row` where the active edges or the winding number at the left border are others; not
    /// further than a band.
    fn next_change(&self, row: u32) -> u32 {
        let begins = self.waiting.last().map(|waiting| waiting.0);
        let changes = self.left.last().map(|left| left.0);
        let ends = self.active().map(|(_, steps)| steps.stepped.end);
        ends.chain(begins)
            .chain(changes)
            .fold(row.saturating_add(ROWS), u32::min)
    }

    /// Takes in the edges that begin up to `row`.
    fn take_in(&mut self, row: u32) {
        while let Some((_, index)) = self.waiting.pop_if(|waiting| waiting.0 <= row) {
            self.active.push(index);
        }
    }

    /// Brings the winding number at the left border to `row`.
    fn border_at(&mut self, row: u32) {
        while let Some((_, gain)) = self.left.pop_if(|left| left.0 <= row) {
            self.border += gain;
        }
    }

    /// The spans of rows that the same few edges cross.
    fn scan_rows(&mut self, rows: Range<u32>) {
        let (rule, width, border) = (self.rule, self.width, self.border);
        let crossings = self.active.len() as u64 * u64::from(rows.end - rows.start);
        self.work.add(Counter::EdgeRecords, crossings);
        if let &[a, b] = self.active.as_slice()
            && let (Some((a, a_steps)), Some((b, b_steps))) = (self.edges.get(a), self.edges.get(b))
            && !rule.contains(border)
            && !rule.contains(border + i64::from(a.winding) + i64::from(b.winding))
        {
            // Outside on either side of two edges, as in every convex polygon: one run between them.
            for y in rows {
                let a = a_steps.stepped_column(a, y, width, &mut self.work);
                let b = b_steps.stepped_column(b, y, width, &mut self.work);
                if a != b {
                    let x = a.min(b)..a.max(b);
                    self.found.push(Span { y, x });
                }
            }
        } else {
            for y in rows {
                self.sort_row(y);
            }
        }
    }

    /// The spans of one row, its crossings sorted.
    fn sort_row(&mut self, y: u32) {
        self.crossings.clear();
        for &index in &self.active {
            if let Some((edge, steps)) = self.edges.get(index) {
                let column = steps.stepped_column(edge, y, self.width, &mut self.work);
                self.crossings.push((column, edge.winding));
            }
        }
        self.crossings.sort_unstable_by_key(|&(column, _)| column);
        let mut runs = Runs::new(y, self.rule, self.border);
        // All crossings of one column count before it is decided.
        for group in self.crossings.chunk_by(|a, b| a.0 == b.0) {
            let gain = group.iter().map(|&(_, gain)| i64::from(gain)).sum();
            if let Some(&(column, _)) = group.first() {
                runs.cross(column, gain, &mut self.found);
            }
        }
        runs.finish(self.width, &mut self.found);
    }

    /// The spans of a band of rows that many edges cross.
    fn mark_band(&mut self, first: u32) {
        self.marks.begin(first, self.rule, self.width);
        for &index in &self.active {
            if let Some((edge, steps)) = self.edges.get(index) {
                self.marks.add(edge, steps, &mut self.work);
            }
        }
        for y in first..self.row {
            self.border_at(y);
            let mut runs = Runs::new(y, self.rule, self.border);
            self.marks
                .take_row(y, |column, gain| runs.cross(column, gain, &mut self.found));
            runs.finish(self.width, &mut self.found);
        }
    }
}

impl<C: Count> Iterator for Scan<C> {
    type Item = Span;

    #[inline]
    fn next(&mut self) -> Option<Span> {
        loop {
            if let Some(span) = self.found.get(self.given) {
                self.given += 1;
                self.work.add(Counter::Fragments, u64::from(span.len()));
                return Some(span.clone());
            }
            if !self.scan() {
                return None;
            }
        }
    }
}

/// The spans of one row, from its crossings left to right.
struct Runs {
    y: u32,
    mask: i64,
    winding: i64,
    /// Where the inside began, if the winding number is inside.
    start: u32,
}

impl Runs {
    #[inline(always)]
    fn new(y: u32, rule: FillRule, border: i64) -> Self {
        Self {
            y,
            mask: rule.mask(),
            winding: border,
            start: 0,
        }
    }

    #[inline(always)]
    fn cross(&mut self, column: u32, gain: i64, found: &mut Vec<Span>) {
        let was_inside = self.winding & self.mask != 0;
        self.winding += gain;
        let inside = self.winding & self.mask != 0;
        if inside && !was_inside {
            self.start = column;
        } else if was_inside && !inside {
            self.finish_at(column, found);
        }
    }

    /// Still inside after the last crossing: up to the right border.
    #[inline(always)]
    fn finish(self, width: u32, found: &mut Vec<Span>) {
        if self.winding & self.mask != 0 {
            self.finish_at(width, found);
        }
    }

    #[inline(always)]
    fn finish_at(&self, end: u32, found: &mut Vec<Span>) {
        if self.start < end {
            found.push(Span {
                y: self.y,
                x: self.start..end,
            });
        }
    }
}
