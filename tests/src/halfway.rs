//! Whether a double is the nearest one: not by computing that, but by the two points half way to its neighbours.

use ombra_oracle::Exact;

/// Whether `y` is the double nearest to `x`: no further than half way to either neighbour, and only an even one as far as
/// that.
#[must_use]
pub fn is_nearest(y: f64, x: &Exact) -> bool {
    let exact = |x| Exact::new(x).unwrap_or_default();
    let reach = |neighbour: f64| {
        if neighbour.is_finite() {
            return (exact(neighbour) + exact(y)).scaled(-1);
        }
        // As if the doubles went on beyond the largest.
        let half = exact(f64::MAX.next_down() - f64::MAX).scaled(-1);
        exact(y) - half * exact(y.signum())
    };
    let (low, high) = (reach(y.next_down()), reach(y.next_up()));
    y.is_finite()
        && match y.to_bits() % 2 {
            0 => low <= *x && *x <= high,
            _ => low < *x && *x < high,
        }
}

#[cfg(test)]
mod tests {
    use super::is_nearest;
    use ombra_oracle::Exact;

    #[test]
    fn by_hand() {
        let exact = |x: f64| Exact::new(x).unwrap();
        let half = Exact::power_of_two(-53);
        let least = Exact::power_of_two(-2000);
        let (even, odd) = (1.0, 1.0_f64.next_up());
        assert!(is_nearest(even, &exact(even)) && !is_nearest(odd, &exact(even)));
        let tie = exact(even) + &half;
        assert!(is_nearest(even, &tie) && !is_nearest(odd, &tie));
        let above = &tie + &least;
        assert!(!is_nearest(even, &above) && is_nearest(odd, &above));
        // Below 1 the neighbours are nearer.
        assert!(!is_nearest(even, &(exact(even) - &half)));
        let largest = exact(f64::MAX) + Exact::power_of_two(970);
        assert!(!is_nearest(f64::MAX, &largest) && is_nearest(f64::MAX, &(largest - least)));
        assert!(!is_nearest(f64::NAN, &tie) && !is_nearest(f64::INFINITY, &tie));
    }
}
