//! Inputs that no file shows, the same in every run.

use glam::DVec3;

/// A generator of test inputs (SplitMix64: Steele, Lea and Flood 2014), the same on every machine.
#[derive(Clone, Debug)]
pub struct Inputs(u64);

impl Inputs {
    /// The inputs that belong to `seed`.
    #[must_use]
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }

    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A whole number from `min` to `max`, both included.
    ///
    /// # Panics
    ///
    /// When `min > max`.
    pub fn integer(&mut self, min: i32, max: i32) -> i32 {
        assert!(min <= max, "no integer lies between {min} and {max}");
        let count = i64::from(max) - i64::from(min) + 1;
        // The remainder's bias is below 2⁻³², which no test can notice.
        (i64::from(min) + (self.next() % count as u64) as i64) as i32
    }

    /// A number from `min` up to `max`.
    pub fn real(&mut self, min: f64, max: f64) -> f64 {
        // 53 random bits fill the significand of a number in 0..1.
        min + (max - min) * ((self.next() >> 11) as f64 / (1_u64 << 53) as f64)
    }

    /// A vector with whole coordinates from `min` to `max`.
    pub fn whole_vector(&mut self, min: i32, max: i32) -> DVec3 {
        DVec3::from_array([(); 3].map(|()| f64::from(self.integer(min, max))))
    }

    /// A vector of length 1 (a corner of the cube is drawn again, so that all directions are as likely).
    pub fn direction(&mut self) -> DVec3 {
        loop {
            let v = DVec3::from_array([(); 3].map(|()| self.real(-1.0, 1.0)));
            if (0.01..=1.0).contains(&v.length_squared()) {
                return v.normalize();
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_seed_gives_the_same_inputs_again() {
        let draw = |seed| {
            let mut inputs = Inputs::new(seed);
            [(); 4].map(|()| inputs.real(0.0, 1.0))
        };
        assert_eq!(draw(1), draw(1));
        assert_ne!(draw(1), draw(2));
    }

    #[test]
    fn integers_reach_both_ends_and_stay_between() {
        let mut inputs = Inputs::new(3);
        let drawn: Vec<i32> = (0..200).map(|_| inputs.integer(-2, 2)).collect();
        assert!((-2..=2).all(|value| drawn.contains(&value)));
        assert!(drawn.iter().all(|value| (-2..=2).contains(value)));
        assert_eq!(inputs.integer(i32::MAX, i32::MAX), i32::MAX);
        inputs.integer(i32::MIN, i32::MAX);
    }

    #[test]
    fn directions_have_length_one() {
        let mut inputs = Inputs::new(4);
        for _ in 0..100 {
            // One rounding of a length near 1.
            assert!((inputs.direction().length() - 1.0).abs() <= 4.0 * f64::EPSILON);
        }
    }
}
