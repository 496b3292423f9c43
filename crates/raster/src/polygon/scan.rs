//! The active edges, carried from band to band: the fast form of the fill.
//!
//! Where few edges are active, the crossings of one row are sorted. Where many are, each edge marks its crossings
//! in a table of one bit a pixel, for a band of rows at once; the table then gives them in order, without a
//! comparison. An edge left of the picture is no active edge: it changes the winding number with which rows begin.

use core::cmp::Reverse;

use ombra_math::work::{Count, Counter};

use super::FillRule;
use super::edge::Edge;
use super::marks::{Marks, ROWS, WIDEST};
use super::step::Steps;
use crate::span::Span;

/// With fewer active edges than this, crossings are sorted.
const FEW: usize = 16;

/// An edge of the active list.
#[derive(Clone, Debug)]
struct Active {
    steps: Steps,
    /// Index of its edge.
    edge: usize,
}

/// Iterator over the spans of a fill.
#[derive(Clone, Debug)]
pub(crate) struct Scan<C> {
    rule: FillRule,
    width: u32,
    edges: Vec<Edge>,
    /// How to step along each edge.
    steps: Vec<Steps>,
    /// First row and index of the edges that have not begun, the next one last.
    waiting: Vec<(u32, usize)>,
    /// Changes of the winding number at the left border, the next one last.
    left: Vec<(u32, i64)>,
    active: Vec<Active>,
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
    pub fn new(edges: Vec<Edge>, rule: FillRule, width: u32, mut work: C) -> Self {
        let steps: Vec<_> = edges.iter().map(|edge| Steps::new(edge, width)).collect();
        let (mut waiting, mut left) = (Vec::with_capacity(edges.len()), Vec::new());
        for (index, (edge, steps)) in edges.iter().zip(&steps).enumerate() {
            if !steps.left.is_empty() {
                left.push((steps.left.start, i64::from(edge.winding)));
                left.push((steps.left.end, -i64::from(edge.winding)));
            }
            if !steps.stepped.is_empty() {
                waiting.push((steps.stepped.start, index));
            }
        }
        // Vertices on a curve come as a few runs in order, which this sort only has to join.
        waiting.sort_by_key(|&(row, _)| Reverse(row));
        left.sort_unstable_by_key(|&(row, _)| Reverse(row));
        work.add(Counter::EdgeRecords, edges.len() as u64);
        Self {
            rule,
            width,
            edges,
            steps,
            waiting,
            left,
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
            self.row = first.saturating_add(1);
            self.sort_row(first);
        } else {
            self.row = first.saturating_add(ROWS);
            self.take_in(self.row - 1);
            self.mark_band(first);
        }
        let end = self.row;
        self.active.retain(|active| active.steps.stepped.end > end);
        true
    }

    /// Takes in the edges that begin up to `row`.
    fn take_in(&mut self, row: u32) {
        while let Some((_, edge)) = self.waiting.pop_if(|waiting| waiting.0 <= row) {
            let steps = self.steps.get(edge).cloned();
            self.active
                .extend(steps.map(|steps| Active { steps, edge }));
        }
    }

    /// Brings the winding number at the left border to `row`.
    fn begin_row(&mut self, row: u32) -> Runs {
        while let Some((_, gain)) = self.left.pop_if(|left| left.0 <= row) {
            self.border += gain;
        }
        Runs {
            y: row,
            mask: self.rule.mask(),
            winding: self.border,
            start: 0,
        }
    }

    fn sort_row(&mut self, row: u32) {
        let mut runs = self.begin_row(row);
        self.crossings.clear();
        for Active { steps, edge } in &self.active {
            if let Some(edge) = self.edges.get(*edge) {
                let column = steps.column(edge, row, self.width, &mut self.work);
                self.crossings.push((column, edge.winding));
            }
        }
        self.work
            .add(Counter::EdgeRecords, self.crossings.len() as u64);
        self.crossings.sort_unstable_by_key(|&(column, _)| column);
        // All crossings of one column count before it is decided.
        for group in self.crossings.chunk_by(|a, b| a.0 == b.0) {
            let gain = group.iter().map(|&(_, gain)| i64::from(gain)).sum();
            if let Some(&(column, _)) = group.first() {
                runs.cross(column, gain, &mut self.found);
            }
        }
        runs.finish(self.width, &mut self.found);
    }

    fn mark_band(&mut self, first: u32) {
        self.marks.begin(first, self.rule, self.width);
        for Active { steps, edge } in &self.active {
            if let Some(edge) = self.edges.get(*edge) {
                self.marks.add(edge, steps, &mut self.work);
            }
        }
        for y in first..self.row {
            let mut runs = self.begin_row(y);
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
