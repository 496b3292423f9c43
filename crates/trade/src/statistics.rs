//! Medians and spread, which an interruption by the machine's other work hardly moves.

/// Half of the numbers lie between the quartiles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quartiles {
    /// A quarter lies below.
    pub lower: f64,
    /// Half lies below.
    pub median: f64,
    /// A quarter lies above.
    pub upper: f64,
}

impl Quartiles {
    /// The quartiles of `numbers`; all three NaN if there are none.
    ///
    /// # Formula
    ///
    /// ```text
    /// q(p) = (1 − f) x_k + f x_(k+1)        k + f = p (n − 1),  x sorted, counted from 0
    /// ```
    ///
    /// # Examples
    ///
    /// ```
    /// use ombra_trade::statistics::Quartiles;
    ///
    /// let q = Quartiles::of(&[3.0, 1.0, 2.0, 1000.0, 4.0]);
    /// assert_eq!((q.lower, q.median, q.upper), (2.0, 3.0, 4.0));
    /// assert_eq!(q.spread(), 2.0);
    /// ```
    #[must_use]
    pub fn of(numbers: &[f64]) -> Self {
        let mut sorted = numbers.to_vec();
        sorted.sort_by(f64::total_cmp);
        let at = |p: f64| {
            let place = p * (sorted.len().saturating_sub(1)) as f64;
            let k = place as usize;
            let (Some(&low), Some(&high)) = (sorted.get(k), sorted.get(k + 1).or(sorted.last()))
            else {
                return f64::NAN;
            };
            low + (place - k as f64) * (high - low)
        };
        Self {
            lower: at(0.25),
            median: at(0.5),
            upper: at(0.75),
        }
    }

    /// The distance of the quartiles.
    #[must_use]
    pub fn spread(&self) -> f64 {
        self.upper - self.lower
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn between_two_numbers_the_median_is_halfway() {
        let q = Quartiles::of(&[4.0, 1.0, 3.0, 2.0]);
        assert_eq!((q.lower, q.median, q.upper), (1.75, 2.5, 3.25));
        assert_eq!(
            Quartiles::of(&[7.0]),
            Quartiles {
                lower: 7.0,
                median: 7.0,
                upper: 7.0
            }
        );
        assert!(Quartiles::of(&[]).median.is_nan());
    }
}
