//! How far a technique's answers lie from the truth.

use core::fmt;

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
    /// Those that were given and are not the truth.
    pub wrong: usize,
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
    /// assert_eq!((deviation.missing_share(), deviation.wrong_share()), (1.0 / 3.0, 1.0));
    /// assert_eq!(deviation.worst(), f64::INFINITY);
    /// ```
    pub fn of(errors: impl IntoIterator<Item = Option<f64>>) -> Self {
        let (mut asked, mut given, mut wrong) = (0_usize, 0_usize, 0_usize);
        let (mut max, mut squares) = (f64::NAN, 0.0);
        for error in errors {
            asked += 1;
            let Some(e) = error.map(f64::abs).filter(|e| e.is_finite()) else {
                continue;
            };
            given += 1;
            wrong += usize::from(e > 0.0);
            // Squares are relative to the largest so far, so that none leaves the range of doubles.
            if e > 0.0 && e > max {
                squares *= (max / e) * (max / e);
                max = e;
            } else {
                max = max.max(e);
            }
            if e > 0.0 {
                squares += (e / max) * (e / max);
            }
        }
        let rms = if max == 0.0 {
            0.0
        } else {
            max * (squares / given as f64).sqrt()
        };
        Self {
            asked,
            missing: asked - given,
            wrong,
            max,
            rms,
        }
    }

    /// The share of answers that were not given; 0 if none was asked for.
    #[must_use]
    pub fn missing_share(&self) -> f64 {
        self.missing as f64 / self.asked.max(1) as f64
    }

    /// The share of answers that are not the truth, missing ones among them; 0 if none was asked for.
    #[must_use]
    pub fn wrong_share(&self) -> f64 {
        (self.wrong + self.missing) as f64 / self.asked.max(1) as f64
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

/// How the errors of many answers become one number; the words say of what, for the axes of charts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Measure {
    /// The largest: `relative error of the shadow`.
    Largest(&'static str),
    /// The share of answers that are not the truth: `wrong pixels`.
    Share(&'static str),
}

impl Measure {
    /// The number; ∞ for the largest error if an answer is missing.
    #[must_use]
    pub fn of(self, deviation: &Deviation) -> f64 {
        match self {
            Self::Largest(_) => deviation.worst(),
            Self::Share(_) => deviation.wrong_share(),
        }
    }

    /// What it measures.
    #[must_use]
    pub const fn words(self) -> &'static str {
        match self {
            Self::Largest(words) | Self::Share(words) => words,
        }
    }
}

/// `largest relative error of the shadow`, `share of wrong pixels`.
impl fmt::Display for Measure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Largest(words) => write!(f, "largest {words}"),
            Self::Share(words) => write!(f, "share of {words}"),
        }
    }
}

/// What a judge says of a technique's answers: their errors, and how many have faults of certain kinds.
#[derive(Clone, Debug, PartialEq)]
pub struct Verdict {
    /// Their errors.
    pub deviation: Deviation,
    /// Kinds of fault, `gaps`, with their numbers; the same kinds in all verdicts of a study.
    pub faults: Vec<(&'static str, u64)>,
}

impl From<Deviation> for Verdict {
    fn from(deviation: Deviation) -> Self {
        Self {
            deviation,
            faults: Vec::new(),
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
        assert_eq!((exact.wrong, exact.wrong_share()), (0, 0.0));
        // Neither square overflows nor vanishes.
        assert_eq!(Deviation::of([Some(1e300), Some(1e300)]).rms, 1e300);
        assert_eq!(Deviation::of([Some(1e-300), Some(-1e-300)]).rms, 1e-300);
    }

    #[test]
    fn the_order_of_errors_does_not_matter() {
        // √((0 + 1 + 16 + 4)/4), and a share of 3 in 4.
        let expected = (21.0f64 / 4.0).sqrt();
        for errors in [
            [0.0, 1.0, 4.0, 2.0],
            [4.0, 2.0, 1.0, 0.0],
            [1.0, 0.0, -2.0, -4.0],
        ] {
            let deviation = Deviation::of(errors.map(Some));
            assert_eq!((deviation.max, deviation.wrong), (4.0, 3));
            // Quotients by powers of two, products and sums of them: only the root is rounded.
            assert_eq!(deviation.rms, expected);
        }
    }

    #[test]
    fn measures() {
        let deviation = Deviation::of([Some(0.0), Some(0.5), None, Some(0.0)]);
        let (largest, share) = (Measure::Largest("error"), Measure::Share("wrong pixels"));
        assert_eq!(
            (largest.of(&deviation), share.of(&deviation)),
            (f64::INFINITY, 0.5)
        );
        assert_eq!(
            (largest.to_string(), share.to_string()),
            ("largest error".into(), "share of wrong pixels".into())
        );
    }
}
