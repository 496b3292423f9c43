//! Random numbers that are the same on every machine.

/// G. L. Steele, D. Lea, C. H. Flood, «Fast splittable pseudorandom number generators», 2014.
pub struct SplitMix(pub u64);

impl SplitMix {
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// In [low, high).
    pub fn real(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * ((self.bits() >> 11) as f64 * 2_f64.powi(-53))
    }

    /// In [low, high).
    pub fn integer(&mut self, low: i32, high: i32) -> i32 {
        let size = u64::from(high.abs_diff(low)).max(1);
        low.wrapping_add((self.bits() % size) as i32)
    }
}
