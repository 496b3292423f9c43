//! t = q/p without rounding.

use core::cmp::Ordering;

use ombra_math::exact::Sum;

/// x − y, of which nothing is rounded.
#[derive(Clone, Copy)]
pub(super) struct Difference(pub(super) [f64; 2]);

impl Difference {
    pub(super) fn sign(self) -> Ordering {
        let [x, y] = self.0;
        x.partial_cmp(&y).unwrap_or(Ordering::Equal)
    }
}

/// t = q/p; two are compared exactly, by q p' against q' p.
#[derive(Clone, Copy)]
pub(super) struct Parameter {
    q: Difference,
    p: Difference,
}

impl Parameter {
    /// t = 0.
    pub(super) const ZERO: Self = Self::new(Difference([0.0, 0.0]), Difference([1.0, 0.0]));
    /// t = 1.
    pub(super) const ONE: Self = Self::new(Difference([1.0, 0.0]), Difference([1.0, 0.0]));

    pub(super) const fn new(q: Difference, p: Difference) -> Self {
        Self { q, p }
    }

    /// 1 for ∞, −1 for −∞, 0 for a number.
    fn infinity(&self) -> i8 {
        match self.q.0.iter().all(|x| x.is_finite()) {
            true => 0,
            false if self.q.sign() == self.p.sign() => 1,
            false => -1,
        }
    }
}

impl PartialEq for Parameter {
    fn eq(&self, other: &Self) -> bool {
        self.partial_cmp(other) == Some(Ordering::Equal)
    }
}

impl PartialOrd for Parameter {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        let mut sum = Sum::default();
        for (first, second, sign) in [(self, other, 1.0), (other, self, -1.0)] {
            for (q, s) in first.q.0.into_iter().zip([sign, -sign]) {
                for (p, t) in second.p.0.into_iter().zip([1.0, -1.0]) {
                    sum.add([s * t, q, p]);
                }
            }
        }
        // The sign of p q' − q p' turns with those of p and p'.
        let turned = self.p.sign() != other.p.sign();
        match sum.sign() {
            Some(order) if turned => Some(order.reverse()),
            Some(order) => Some(order),
            // A window made by hand may be infinite.
            None => self.infinity().partial_cmp(&other.infinity()),
        }
    }
}
