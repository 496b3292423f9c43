//! One row: from the columns where edges cross it to its spans.

use super::changes::Changes;
use super::found::Found;
use super::marks::Marks;
use crate::polygon::FillRule;
use crate::span::Span;

/// The columns where edges cross a row, between a place for the left border and one for the right.
#[derive(Clone, Debug, Default)]
pub(super) struct Row {
    columns: Vec<u32>,
    crossings: usize,
    /// Columns with their gains, where both are sorted together.
    pairs: Vec<(u32, i32)>,
    marks: Marks,
}

impl Row {
    /// The places of so many columns, to be written.
    #[inline]
    pub fn columns(&mut self, crossings: usize) -> &mut [u32] {
        self.crossings = crossings;
        if self.columns.len() < crossings + 2 {
            self.columns.resize(crossings + 2, 0);
        }
        self.columns.get_mut(1..=crossings).unwrap_or_default()
    }

    /// Sorts the columns, at most `width`, and keeps those where inside and outside change over, given what the winding
    /// number, `border` left of all, gains at each.
    ///
    /// Where only odd and even count that is each column: one that comes twice bounds an empty run.
    #[inline]
    pub fn order(
        &mut self,
        rule: FillRule,
        width: u32,
        border: i64,
        gains: impl Iterator<Item = i32>,
    ) {
        let columns = self.columns.get_mut(1..=self.crossings).unwrap_or_default();
        // Marking looks at the whole row; memory for it, too, is to follow the crossings.
        let mark = (width / 64) as usize <= columns.len();
        match (rule, mark) {
            (FillRule::EvenOdd, true) => self.crossings = self.marks.sort(columns, width),
            (FillRule::EvenOdd, false) => columns.sort_unstable(),
            (FillRule::NonZero, true) => {
                self.crossings = self.marks.sort_with_gains(columns, width, gains, border);
            }
            (FillRule::NonZero, false) => {
                self.pairs.clear();
                self.pairs.extend(columns.iter().copied().zip(gains));
                self.pairs.sort_unstable_by_key(|&(column, _)| column);
                let mut changes = Changes::from(border);
                for &(column, gain) in &self.pairs {
                    changes.cross(column, gain, columns);
                }
                self.crossings = changes.kept;
            }
        }
    }

    /// The same for columns that are sorted already.
    pub fn keep_changes(&mut self, rule: FillRule, border: i64, gains: impl Iterator<Item = i32>) {
        if rule == FillRule::EvenOdd {
            return;
        }
        let columns = self.columns.get_mut(1..=self.crossings).unwrap_or_default();
        let mut changes = Changes::from(border);
        for (i, gain) in gains.enumerate() {
            if let Some(&column) = columns.get(i) {
                changes.cross(column, gain, columns);
            }
        }
        self.crossings = changes.kept;
    }

    /// Adds the spans of row `y` to `found`, once the columns are in order.
    pub fn spans(&mut self, y: u32, inside: bool, width: u32, found: &mut Found) {
        // Inside at the left border, a run begins there; inside after the last crossing, it ends at the right one.
        let first = usize::from(!inside);
        let mut end = self.crossings + 1;
        if !(end - first).is_multiple_of(2) {
            if let Some(last) = self.columns.get_mut(end) {
                *last = width;
            }
            end += 1;
        }
        let columns = self.columns.get(first..end).unwrap_or_default();
        let (runs, _) = columns.as_chunks::<2>();
        let spans = found.room(runs.len());
        // Lengths are hard to predict, so nothing here jumps: an empty run is overwritten by the next one, and one that
        // touches the next is written again, longer.
        let (mut kept, mut start, mut end) = (0, 0, 0);
        for &[from, to] in runs {
            let touches = from == end;
            kept += usize::from(!touches & (start < end));
            start = if touches { start } else { from };
            end = to;
            if let Some(span) = spans.get_mut(kept) {
                *span = Span { y, x: start..end };
            }
        }
        found.keep(kept + usize::from(start < end));
    }
}
