//! Which choices are worth making: those that nothing beats in both cost and error.

/// Marks the Pareto front among points (cost, error).
///
/// # Formula
///
/// ```text
/// i is on the front  ⇔  no j has cost_j ≤ cost_i and error_j ≤ error_i, one of them strictly
/// ```
///
/// # Properties
///
/// Points that are equal in both are on the front together. A point with NaN or ∞ in it never is, and beats none.
///
/// # Examples
///
/// ```
/// use ombra_trade::pareto::front;
///
/// let (cheap, exact, slow) = ((1.0, 1e-3), (9.0, 0.0), (9.5, 1e-6));
/// assert_eq!(front(&[cheap, exact, slow]), [true, true, false]);
/// ```
///
/// # References
///
/// In no deck. V. Pareto, «Manuale di economia politica», 1906.
#[must_use]
pub fn front(points: &[(f64, f64)]) -> Vec<bool> {
    let counts = |&(cost, error): &(f64, f64)| cost.is_finite() && error.is_finite();
    points
        .iter()
        .map(|p| {
            let beaten = points
                .iter()
                .filter(|q| counts(q))
                .any(|q| q.0 <= p.0 && q.1 <= p.1 && (q.0 < p.0 || q.1 < p.1));
            counts(p) && !beaten
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn ties() {
        // Equal points stand together; equal in one, the other decides.
        assert_eq!(front(&[(1.0, 1.0), (1.0, 1.0)]), [true, true]);
        assert_eq!(
            front(&[(1.0, 1.0), (1.0, 2.0), (2.0, 1.0)]),
            [true, false, false]
        );
        assert_eq!(front(&[(1.0, 0.0), (2.0, -0.0)]), [true, false]);
    }

    #[test]
    fn what_is_no_number_is_never_chosen_and_beats_none() {
        let (nan, inf) = (f64::NAN, f64::INFINITY);
        let points = [
            (nan, 0.0),
            (0.0, nan),
            (0.0, inf),
            (inf, 0.0),
            (-inf, -inf),
            (5.0, 5.0),
        ];
        assert_eq!(front(&points), [false, false, false, false, false, true]);
        assert_eq!(front(&[]), Vec::<bool>::new());
    }

    proptest! {
        /// Sorted by cost, the front is where the error falls below everything before: another way to find it.
        #[test]
        fn the_front_is_the_running_minimum(points in proptest::collection::vec((0..20i32, 0..20i32), 0..30)) {
            let points: Vec<_> = points.iter().map(|&(c, e)| (f64::from(c), f64::from(e))).collect();
            let marked = front(&points);
            for (p, &on) in points.iter().zip(&marked) {
                let least = |costs: &dyn Fn(f64) -> bool| {
                    points.iter().filter(|q| costs(q.0)).map(|q| q.1).fold(f64::INFINITY, f64::min)
                };
                prop_assert_eq!(on, p.1 < least(&|c| c < p.0) && p.1 == least(&|c| c == p.0));
            }
        }
    }
}
