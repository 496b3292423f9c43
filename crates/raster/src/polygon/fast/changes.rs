//! Where a row changes between outside and inside, by the winding number.

/// The crossings, met from left to right, where the winding number changes from outside, 0, to inside or back.
pub(super) struct Changes {
    winding: i64,
    /// How many columns have been kept.
    pub kept: usize,
}

impl Changes {
    /// With the winding number left of all.
    pub fn from(winding: i64) -> Self {
        Self { winding, kept: 0 }
    }

    /// Writes a column after those kept, and keeps it if it is one of these.
    #[inline(always)]
    pub fn cross(&mut self, column: u32, gain: i32, columns: &mut [u32]) {
        let was_inside = self.winding != 0;
        self.winding += i64::from(gain);
        if let Some(place) = columns.get_mut(self.kept) {
            *place = column;
        }
        self.kept += usize::from(was_inside != (self.winding != 0));
    }
}
