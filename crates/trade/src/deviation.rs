//! How far a technique's answers lie from the truth.

/// The errors of a technique's answers to one question.
///
/// # Formula
///
/// ```text
/// max = max e_i        rms = √(Σ e_i² / n)        over the n answers given, e_i ≥ 0
/// ```
///
/// # Pitfalls
///
/// A missing answer has no error, so a technique that answers only where it is good looks good: read
/// [`missing`](Self::missing) first, or ask [`worst`](Self::worst), which does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Deviation {
    /// Answers that were asked for.
    pub asked: usize,
    /// Those that were not given, or were no numbers.
    pub missing: usize,
    /// The largest error; NaN if there is no answer.
    pub max: f64,
    /// The root of the mean square error; NaN if there is no answer.
    pub rms: f64,
}

impl Deviation {
    /// Of the errors of all answers asked for; `None`, NaN and ∞ are missing ones.
    ///
    /// # Examples
    ///
    /// ```
    /// use ombra_trade::deviation::Deviation;
    ///
    /// let deviation = Deviation::of([Some(3.0), Some(4.0), None]);
    /// assert_eq!((deviation.max, deviation.rms), (4.0, 12.5f64.sqrt()));
    /// assert_eq!(deviation.missing_share(), 1.0 / 3.0);
    /// assert_eq!(deviation.worst(), f64::INFINITY);
    /// ```
    pub fn of(errors: impl IntoIterator<Item = Option<f64>>) -> Self {
        let (mut asked, mut given) = (0, Vec::new());
        for error in errors {
            asked += 1;
            given.extend(error.map(f64::abs).filter(|e| e.is_finite()));
        }
        let max = given.iter().copied().fold(f64::NAN, f64::max);
        // Relative to the largest, so that no square leaves the range of doubles.
        let squares: f64 = given.iter().map(|e| (e / max) * (e / max)).sum();
        let rms = if max == 0.0 {
            0.0
        } else {
            max * (squares / given.len() as f64).sqrt()
        };
        Self {
            asked,
            missing: asked - given.len(),
            max,
            rms,
        }
    }

    /// The share of answers that were not given; 0 if none was asked for.
    #[must_use]
    pub fn missing_share(&self) -> f64 {
        self.missing as f64 / self.asked.max(1) as f64
    }

    /// The largest error, or ∞ if an answer is missing.
    #[must_use]
    pub fn worst(&self) -> f64 {
        if self.missing == 0 {
            self.max
        } else {
            f64::INFINITY
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn degenerate() {
        let none = Deviation::of([]);
        assert!(none.max.is_nan() && none.rms.is_nan() && none.worst().is_nan());
        assert_eq!(none.missing_share(), 0.0);
        let missing = Deviation::of([None, Some(f64::NAN), Some(f64::INFINITY)]);
        assert_eq!((missing.asked, missing.missing), (3, 3));
        assert_eq!(missing.worst(), f64::INFINITY);
        let exact = Deviation::of([Some(0.0), Some(-0.0)]);
        assert_eq!((exact.max, exact.rms, exact.worst()), (0.0, 0.0, 0.0));
        // Neither square overflows nor vanishes.
        assert_eq!(Deviation::of([Some(1e300), Some(1e300)]).rms, 1e300);
        assert_eq!(Deviation::of([Some(1e-300), Some(-1e-300)]).rms, 1e-300);
    }
}
