//! The crossings of many edges in a band of rows, marked instead of sorted.

use core::ops::Range;

use ombra_math::work::{Count, Counter};

use super::FillRule;
use super::edge::Edge;
use super::step::{MARGIN, Steps, settle};

/// Widest picture whose bands are marked, so that their memory does not grow with the width.
pub(super) const WIDEST: u32 = 1 << 13;

/// Rows of a band: its table should stay in the fast cache.
pub(super) const ROWS: u32 = 64;

/// Bits of the fraction of a stepped crossing.
const FRACTION: u32 = 24;
/// [`MARGIN`] in units of that fraction.
const DOUBT: i64 = (MARGIN * (1u64 << FRACTION) as f64) as i64;

/// One bit for each column of a band where edges cross, and what the winding number gains there.
#[derive(Clone, Debug)]
pub(super) struct Marks {
    first: u32,
    width: u32,
    rule: FillRule,
    bits: Vec<u64>,
    /// For non-zero alone. Where only odd and even count, a second crossing wipes out the bit of the first, and a
    /// bit that is left counts 1.
    gains: Vec<i32>,
}

impl Default for Marks {
    fn default() -> Self {
        Self {
            first: 0,
            width: 0,
            rule: FillRule::EvenOdd,
            bits: Vec::new(),
            gains: Vec::new(),
        }
    }
}

impl Marks {
    /// Begins a band at row `first`, with no mark.
    pub fn begin(&mut self, first: u32, rule: FillRule, width: u32) {
        (self.first, self.rule, self.width) = (first, rule, width);
        let rows = ROWS as usize;
        self.bits.resize(rows * self.words(), 0);
        if rule == FillRule::NonZero {
            self.gains.resize(rows * self.words() * 64, 0);
        }
    }

    /// Words of a row; the column `width` has its bit too.
    fn words(&self) -> usize {
        self.width as usize / 64 + 1
    }

    /// Marks the crossings of an edge.
    pub fn add(&mut self, edge: &Edge, steps: &Steps, work: &mut impl Count) {
        let end = self.first.saturating_add(ROWS);
        let rows = steps.stepped.start.max(self.first)..steps.stepped.end.min(end);
        work.add(Counter::EdgeRecords, u64::from(rows.end - rows.start));
        let words = self.words();
        let mut place = (rows.start - self.first) as usize * words;
        let columns = Columns::new(edge, steps, rows, self.width, work);
        // A row's bits begin a row's words after those of the row before.
        match self.rule {
            FillRule::EvenOdd => {
                for column in columns {
                    if let Some(word) = self.bits.get_mut(place + column as usize / 64) {
                        *word ^= 1 << (column % 64);
                    }
                    place += words;
                }
            }
            FillRule::NonZero => {
                for column in columns {
                    let word = self.bits.get_mut(place + column as usize / 64);
                    let gain = self.gains.get_mut(place * 64 + column as usize);
                    if let (Some(word), Some(gain)) = (word, gain) {
                        *word |= 1 << (column % 64);
                        *gain += edge.winding;
                    }
                    place += words;
                }
            }
        }
    }

    /// Gives the crossings of row `y`, left to right, and wipes them out.
    #[inline]
    pub fn take_row(&mut self, y: u32, mut cross: impl FnMut(u32, i64)) {
        let words = self.words();
        let start = (y - self.first) as usize * words;
        let row = self.bits.get_mut(start..start + words).unwrap_or_default();
        let gains = self.gains.get_mut(start * 64..).unwrap_or_default();
        let rule = self.rule;
        for (word, bits) in row.iter_mut().enumerate() {
            let mut bits = core::mem::take(bits);
            while bits != 0 {
                let column = word * 64 + bits.trailing_zeros() as usize;
                bits &= bits - 1;
                let gain = match rule {
                    FillRule::EvenOdd => 1,
                    FillRule::NonZero => gains.get_mut(column).map_or(0, core::mem::take),
                };
                cross(column as u32, i64::from(gain));
            }
        }
    }
}

/// The columns of an edge, row after row.
struct Columns<'a, C> {
    /// X + ½ + [`MARGIN`] in fixed point. Unless its fraction is at most twice the margin, its integer part is the column.
    x: i64,
    slope: i64,
    row: u32,
    end: u32,
    width: u32,
    edge: &'a Edge,
    work: &'a mut C,
}

impl<'a, C: Count> Columns<'a, C> {
    /// Within a band, fixed point adds at most 65 · 2⁻²⁴ to the error of a stepped crossing.
    #[inline]
    fn new(edge: &'a Edge, steps: &Steps, rows: Range<u32>, width: u32, work: &'a mut C) -> Self {
        let unit = f64::from(1 << FRACTION);
        let x = steps.x + steps.slope * f64::from(rows.start - steps.stepped.start);
        Self {
            x: ((x + 0.5) * unit) as i64 + DOUBT,
            slope: (steps.slope * unit) as i64,
            row: rows.start,
            end: rows.end,
            width,
            edge,
            work,
        }
    }
}

impl<C: Count> Iterator for Columns<'_, C> {
    type Item = u32;

    #[inline(always)]
    fn next(&mut self) -> Option<u32> {
        if self.row >= self.end {
            return None;
        }
        let doubt = self.x & ((1 << FRACTION) - 1) <= 2 * DOUBT;
        let column = self.x >> FRACTION;
        let column = if doubt || column as u64 > u64::from(self.width) {
            doubtful(
                self.edge,
                self.x - DOUBT,
                self.row,
                self.width,
                doubt,
                self.work,
            )
        } else {
            column as u32
        };
        // A slope too steep for fixed point is that of an edge of one row.
        self.x = self.x.wrapping_add(self.slope);
        self.row += 1;
        Some(column)
    }
}

/// The column where there is doubt, or where it lies outside the picture.
#[cold]
#[inline(never)]
fn doubtful(edge: &Edge, x: i64, row: u32, width: u32, doubt: bool, work: &mut impl Count) -> u32 {
    if doubt {
        let x = x as f64 / f64::from(1 << FRACTION) - 0.5;
        settle(edge, x, row, width, work)
    } else {
        (x >> FRACTION).clamp(0, i64::from(width)) as u32
    }
}
