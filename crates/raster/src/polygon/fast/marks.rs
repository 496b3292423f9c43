//! Columns sorted without comparing them: marked in a table of one bit a column, and read off from left to right.

use super::changes::Changes;

/// The table, empty between two rows.
#[derive(Clone, Debug, Default)]
pub(super) struct Marks {
    bits: Vec<u64>,
    /// What the winding number gains at each column.
    gains: Vec<i32>,
}

impl Marks {
    /// Sorts `columns`, at most `width`, and leaves out pairs of equal ones; how many are left.
    pub fn sort(&mut self, columns: &mut [u32], width: u32) -> usize {
        self.widen(width);
        let mut mark = |column: u32| {
            if let Some(word) = self.bits.get_mut(column as usize / 64) {
                *word ^= 1 << (column % 64);
            }
        };
        // Columns are nearly sorted, and a mark has to wait for the one before it in the same word: four quarters take
        // turns.
        let quarter = columns.len() / 4;
        let (a, rest) = columns.split_at(quarter);
        let (b, rest) = rest.split_at(quarter);
        let (c, rest) = rest.split_at(quarter);
        let (d, rest) = rest.split_at(quarter);
        for ((&a, &b), (&c, &d)) in a.iter().zip(b).zip(c.iter().zip(d)) {
            mark(a);
            mark(b);
            mark(c);
            mark(d);
        }
        rest.iter().copied().for_each(mark);
        let mut kept = 0;
        self.take(|column, _| {
            if let Some(place) = columns.get_mut(kept) {
                *place = column;
            }
            kept += 1;
        });
        kept
    }

    /// Sorts `columns`, at most `width`, and keeps those where the winding number, `border` left of all, changes from 0 or
    /// to 0, given what it gains at each; how many are left.
    pub fn sort_with_gains(
        &mut self,
        columns: &mut [u32],
        width: u32,
        gains: impl Iterator<Item = i32>,
        border: i64,
    ) -> usize {
        self.widen(width);
        if self.gains.len() < self.bits.len() * 64 {
            self.gains.resize(self.bits.len() * 64, 0);
        }
        for (&column, gain) in columns.iter().zip(gains) {
            let word = self.bits.get_mut(column as usize / 64);
            let sum = self.gains.get_mut(column as usize);
            if let (Some(word), Some(sum)) = (word, sum) {
                *word |= 1 << (column % 64);
                *sum += gain;
            }
        }
        let mut changes = Changes::from(border);
        self.take(|column, gains| {
            let gain = gains.get_mut(column as usize).map_or(0, core::mem::take);
            changes.cross(column, gain, columns);
        });
        changes.kept
    }

    /// Makes room for columns 0 to `width`.
    fn widen(&mut self, width: u32) {
        let words = width as usize / 64 + 1;
        if self.bits.len() < words {
            self.bits.resize(words, 0);
        }
    }

    /// Takes the marks out, from left to right.
    #[inline(always)]
    fn take(&mut self, mut column: impl FnMut(u32, &mut [i32])) {
        for (word, bits) in (0..).zip(&mut self.bits) {
            let mut bits = core::mem::take(bits);
            while bits != 0 {
                column(word * 64 + bits.trailing_zeros(), &mut self.gains);
                bits &= bits - 1;
            }
        }
    }
}
