//! What part of a promised bound the errors of a function take.

use ombra_math::glam::DVec3;
use ombra_oracle::Exact;
use ombra_oracle::vector::exact;

use super::to_300_bits::{q, root};

/// The worst that was found for a function.
#[derive(Clone, Debug)]
pub struct Share {
    /// Its path.
    pub path: String,
    /// The largest share of its bound that an error took; `None` where the bound is that no other double is nearer.
    pub of_bound: Option<f64>,
}

impl Share {
    pub fn new(path: &str, of_bound: f64) -> Self {
        Self {
            path: path.to_owned(),
            of_bound: Some(of_bound),
        }
    }

    /// No double was nearer than the answer.
    pub fn nearest(path: &str) -> Self {
        Self {
            path: path.to_owned(),
            of_bound: None,
        }
    }
}

/// The largest error of a function so far.
#[derive(Default)]
pub struct Worst {
    /// The largest share of the bound.
    of_bound: f64,
    is_nearest: bool,
    seen: u32,
}

impl Worst {
    /// An error must be within `bound`.
    pub fn see(&mut self, found: f64, right: &Exact, bound: &Exact) {
        self.seen += 1;
        let error = (q(found) - right).abs();
        assert!(
            error <= *bound,
            "{found:e} instead of {right:?}, error {:e} of {:e}",
            error.nearest(),
            bound.nearest()
        );
        if !bound.is_zero() {
            self.of_bound = self.of_bound.max(error.ratio(bound));
        }
    }

    /// No double may be nearer.
    pub fn see_nearest(&mut self, found: f64, right: &Exact) {
        self.seen += 1;
        let off = |x: f64| (q(x) - right).abs();
        assert!(
            off(found) <= off(right.nearest()),
            "{found:e} instead of {:e}",
            right.nearest()
        );
        self.is_nearest = true;
    }

    /// For the function `path`.
    pub fn of(&self, path: &str) -> Share {
        assert!(self.seen > 10, "{path}: {} answers measured", self.seen);
        if self.is_nearest && self.of_bound == 0.0 {
            return Share::nearest(path);
        }
        Share::new(path, self.of_bound)
    }
}

pub fn q3(v: DVec3) -> [Exact; 3] {
    exact(v).unwrap()
}

/// `k` ε.
pub fn eps(k: f64) -> Exact {
    q(k * f64::EPSILON)
}

/// The smallest double.
pub fn smallest() -> Exact {
    Exact::power_of_two(-1074)
}

/// ‖v‖.
pub fn length<const N: usize>(v: &[Exact; N]) -> Exact {
    root(&ombra_oracle::vector::dot(v, v))
}
