//! Many active edges side by side, stepped together from row to row.
//!
//! Each number of an edge is kept in an array of its own, so that a few edges take their step in one instruction. The
//! edges stand in the order of their crossings. They keep it until one crosses another, and as long as they do, the
//! columns of a row come out sorted; afterwards a [`Row`] sorts them, until the edges themselves are sorted again.

use ombra_math::work::{Count, Counter};

use super::found::Found;
use super::row::Row;
use crate::edge::Edge;
use crate::polygon::FillRule;
use crate::step::{MARGIN, Steps, settle};

/// Rows after which edges that are out of order are sorted again, at first: sorting is to cost less than the rows.
const PATIENCE: u32 = 64;

/// Most rows that an edge is stepped before its crossing is computed anew.
const MOST_ROWS: u32 = 1 << 16;

/// [`MARGIN`] in units of the fraction, 2⁻³².
const DOUBT: i64 = (MARGIN * (1u64 << 32) as f64) as i64;

/// An edge from some row on.
#[derive(Clone, Copy, Debug)]
pub(super) struct Entry {
    /// X + ½ + [`MARGIN`], with 32 bits of fraction. Unless that is less than twice the margin, the integer part is the
    /// column.
    x: i64,
    /// Its change a row.
    slope: i64,
    /// The row where the edge ends, or has to enter again.
    end: u32,
    /// What the winding number gains at the edge.
    gain: i32,
    /// The edge's index in the table.
    index: usize,
}

impl Entry {
    /// Fixed point adds less than 2⁻³² a row to the error of a stepped crossing, 2⁻¹⁶ in all.
    #[inline]
    pub fn new(index: usize, (edge, steps): &(Edge, Steps), row: u32) -> Self {
        let unit = (1u64 << 32) as f64;
        let x = steps.x + steps.slope * f64::from(row - steps.stepped.start);
        Self {
            x: (((x + 0.5) * unit) as i64).saturating_add(DOUBT),
            slope: (steps.slope * unit) as i64,
            end: steps.stepped.end.min(row.saturating_add(MOST_ROWS)),
            gain: edge.winding,
            index,
        }
    }
}

/// The edges, one number of each in each array.
#[derive(Clone, Debug, Default)]
pub(super) struct Active {
    /// [`Entry::x`]: integer part, and the fraction less 2³¹, so that fractions compare as integers with a sign do.
    column: Vec<i32>,
    fraction: Vec<i32>,
    /// [`Entry::slope`], in halves.
    column_step: Vec<i32>,
    fraction_step: Vec<i32>,
    end: Vec<u32>,
    label: Vec<Label>,
    /// The first row where one of them ends.
    next_end: u32,
    /// The row in which to sort them, if they are out of order.
    disordered_until: Option<u32>,
    /// When they were sorted last.
    sorted_at: u32,
    /// Rows to leave them out of order.
    patience: u32,
    row: Row,
}

/// What is not needed to step an edge.
#[derive(Clone, Copy, Debug, Default)]
struct Label {
    index: usize,
    gain: i32,
}

/// The same for each array.
macro_rules! each {
    ($active:expr, $array:ident => $what:expr) => {{
        each!(@ $active, $array => $what, column, fraction, column_step, fraction_step, end, label);
    }};
    (@ $active:expr, $array:ident => $what:expr, $($name:ident),*) => {
        $({ let $array = &mut $active.$name; $what; })*
    };
}

impl Active {
    pub fn len(&self) -> usize {
        self.label.len()
    }

    pub fn is_empty(&self) -> bool {
        self.label.is_empty()
    }

    /// The first row where an edge ends; [`Active::end_at`] must be told.
    pub fn next_end(&self) -> u32 {
        self.next_end
    }

    /// Takes in edges, which are used up.
    pub fn begin(&mut self, entries: &mut Vec<Entry>) {
        if entries.is_empty() {
            return;
        }
        if self.is_empty() {
            (self.next_end, self.disordered_until) = (u32::MAX, None);
            self.patience = PATIENCE;
        }
        entries.sort_unstable_by_key(|entry| entry.x);
        let mut unmoved = self.len();
        let length = unmoved + entries.len();
        each!(self, array => array.resize(length, Default::default()));
        // From the last one on, all that stand right of it give way at once.
        for (before, entry) in entries.iter().enumerate().rev() {
            let at = match self.disordered_until {
                None => self.place(entry.x, unmoved),
                Some(_) => unmoved,
            };
            each!(self, array => array.copy_within(at..unmoved, at + before + 1));
            self.set(at + before, entry);
            self.next_end = self.next_end.min(entry.end);
            unmoved = at;
        }
        entries.clear();
    }

    /// Where among the first edges, in order, a crossing belongs.
    fn place(&self, x: i64, edges: usize) -> usize {
        let (column, fraction) = split(x);
        let columns = self.column.get(..edges).unwrap_or_default();
        let from = columns.partition_point(|&other| other < column);
        let to = columns.partition_point(|&other| other <= column);
        let fractions = self.fraction.get(from..to).unwrap_or_default();
        from + fractions.partition_point(|&other| other < fraction)
    }

    fn set(&mut self, at: usize, entry: &Entry) {
        let (column, fraction) = split(entry.x);
        // The step is added to the fraction as it is.
        let steps = ((entry.slope >> 32) as i32, entry.slope as i32);
        put(&mut self.column, at, column);
        put(&mut self.fraction, at, fraction);
        put(&mut self.column_step, at, steps.0);
        put(&mut self.fraction_step, at, steps.1);
        put(&mut self.end, at, entry.end);
        let (index, gain) = (entry.index, entry.gain);
        put(&mut self.label, at, Label { index, gain });
    }

    fn get(&self, at: usize) -> Option<Entry> {
        let label = self.label.get(at)?;
        let step = i64::from(*self.column_step.get(at)?) << 32;
        Some(Entry {
            x: join(*self.column.get(at)?, *self.fraction.get(at)?),
            slope: step | i64::from(*self.fraction_step.get(at)? as u32),
            end: *self.end.get(at)?,
            gain: label.gain,
            index: label.index,
        })
    }

    /// Lets go of the edges that end at `row`, and tells their indices.
    pub fn end_at(&mut self, row: u32, mut ended: impl FnMut(usize)) {
        let (mut kept, mut from) = (0, 0);
        loop {
            let rest = self.end.get(from..).unwrap_or_default();
            let at = rest.iter().position(|&end| end == row);
            let stay = from..from + at.unwrap_or(rest.len());
            let moved = stay.len();
            if from > kept {
                each!(self, array => array.copy_within(stay.clone(), kept));
            }
            kept += moved;
            let Some(label) = self.label.get(stay.end).filter(|_| at.is_some()) else {
                break;
            };
            ended(label.index);
            from = stay.end + 1;
        }
        each!(self, array => array.truncate(kept));
        self.next_end = self.end.iter().fold(u32::MAX, |least, &end| least.min(end));
    }

    /// Lets go of all edges, and tells their indices.
    pub fn drain(&mut self) -> impl Iterator<Item = usize> {
        let labels = core::mem::take(&mut self.label);
        each!(self, array => array.clear());
        labels.into_iter().map(|label| label.index)
    }

    /// Adds the spans of row `y` to `found`, and steps all edges to the next row.
    ///
    /// `border` is the winding number at the left border.
    pub fn scan_row(
        &mut self,
        y: u32,
        (rule, width, border): (FillRule, u32, i64),
        edges: &[(Edge, Steps)],
        found: &mut Found,
        work: &mut impl Count,
    ) {
        if self.disordered_until.is_some_and(|row| row <= y) {
            self.sort();
            self.sorted_at = y;
        }
        let crossings = self.len();
        work.add(Counter::EdgeRecords, crossings as u64);
        let columns = self.row.columns(crossings);
        let doubt = step(
            columns,
            &mut self.column,
            &mut self.fraction,
            &self.column_step,
            &self.fraction_step,
        );
        if doubt {
            self.settle(y, width, edges, work);
        }
        let columns = self.row.columns(crossings);
        if self.disordered_until.is_none() && !is_sorted(columns) {
            self.lose_order(y);
        }
        let columns = self.row.columns(crossings);
        keep_within(columns, width, self.disordered_until.is_none());
        let gains = self.label.iter().map(|label| label.gain);
        match self.disordered_until {
            None => self.row.keep_changes(rule, border, gains),
            Some(_) => self.row.order(rule, width, border, gains),
        }
        self.row.spans(y, rule.contains(border), width, found);
    }

    /// Lets the edges be out of order from row `y` on: for twice as long as the last time, if sorting them then did not last.
    #[cold]
    fn lose_order(&mut self, y: u32) {
        self.patience = match y - self.sorted_at {
            lasted if lasted < self.patience => self.patience.saturating_mul(2),
            _ => PATIENCE,
        };
        self.disordered_until = Some(y.saturating_add(self.patience));
    }

    /// Asks the exact predicate where there is doubt about a column of row `y`, after the step.
    #[cold]
    fn settle(&mut self, y: u32, width: u32, edges: &[(Edge, Steps)], work: &mut impl Count) {
        for at in 0..self.len() {
            let (Some(fraction), Some(step)) = (self.fraction.get(at), self.fraction_step.get(at))
            else {
                break;
            };
            if !is_doubtful(fraction.wrapping_sub(*step)) {
                continue;
            }
            let Some(entry) = self.get(at) else { break };
            let column = self.row.columns(self.label.len()).get_mut(at);
            // Outside the picture either answer is kept within.
            if let (Some((edge, _)), Some(column)) = (edges.get(entry.index), column)
                && (1..=width).contains(column)
            {
                let x = entry.x.wrapping_sub(entry.slope) - DOUBT;
                let x = x as f64 / (1u64 << 32) as f64 - 0.5;
                *column = settle(edge, x, y, width, work);
            }
        }
    }

    /// Puts the edges in the order of their crossings.
    #[cold]
    fn sort(&mut self) {
        let mut entries: Vec<_> = (0..self.len()).filter_map(|at| self.get(at)).collect();
        entries.sort_unstable_by_key(|entry| entry.x);
        for (at, entry) in entries.iter().enumerate() {
            self.set(at, entry);
        }
        self.disordered_until = None;
    }
}

/// Integer part and fraction, as they are kept.
fn split(x: i64) -> (i32, i32) {
    ((x >> 32) as i32, x as i32 ^ i32::MIN)
}

/// What was [`split`].
fn join(column: i32, fraction: i32) -> i64 {
    i64::from(column) << 32 | i64::from((fraction ^ i32::MIN) as u32)
}

/// Whether a crossing with this fraction may lie on the other side of a centre.
#[inline(always)]
fn is_doubtful(fraction: i32) -> bool {
    fraction < i32::MIN + 2 * DOUBT as i32
}

fn put<T>(array: &mut [T], at: usize, value: T) {
    if let Some(place) = array.get_mut(at) {
        *place = value;
    }
}

/// The columns of all crossings, not yet kept within the picture, and the step to the next row; whether there is doubt
/// about any column.
#[inline(never)]
fn step(
    columns: &mut [u32],
    column: &mut [i32],
    fraction: &mut [i32],
    column_step: &[i32],
    fraction_step: &[i32],
) -> bool {
    let place = columns.iter_mut().zip(column).zip(fraction);
    let step = column_step.iter().zip(fraction_step);
    let mut doubt = false;
    for (((result, column), fraction), (&column_step, &fraction_step)) in place.zip(step) {
        doubt |= is_doubtful(*fraction);
        *result = *column as u32;
        // A sum of fractions that is less than one of them has overflowed, and carries.
        let sum = fraction.wrapping_add(fraction_step);
        let carry = i32::from(sum < *fraction);
        *column = column.wrapping_add(column_step).wrapping_add(carry);
        *fraction = sum;
    }
    doubt
}

/// Whether columns, which may be negative, are in order. There is no way out before the end, so that a few are compared
/// in one instruction.
#[inline(never)]
fn is_sorted(columns: &[u32]) -> bool {
    let pairs = columns.iter().zip(columns.get(1..).unwrap_or_default());
    !pairs.fold(false, |falls, (&a, &b)| falls | (a as i32 > b as i32))
}

/// Keeps columns, which may be negative, within 0 … `width`.
fn keep_within(columns: &mut [u32], width: u32, sorted: bool) {
    if sorted {
        let negative = columns
            .iter_mut()
            .take_while(|column| (**column as i32) < 0);
        negative.for_each(|column| *column = 0);
        let beyond = columns
            .iter_mut()
            .rev()
            .take_while(|column| **column > width);
        beyond.for_each(|column| *column = width);
    } else if columns
        .iter()
        .fold(false, |any, &column| any | (column > width))
    {
        for column in columns {
            *column = if (*column as i32) < 0 {
                0
            } else {
                (*column).min(width)
            };
        }
    }
}
