//! Where linear functions of a parameter are not negative: what clipping a segment is, without rounding.

use crate::Exact;

/// The part of 0 ≤ t ≤ 1 in which none of the linear `functions`, each given by its values at 0 and 1, is negative;
/// `None` if there is none.
///
/// # Examples
///
/// ```
/// use ombra_oracle::Exact;
/// use ombra_oracle::interval::not_negative;
///
/// // t ≥ 1/4 and t ≤ 1/2.
/// let sides = [[-1, 3], [5, -5]].map(|side| side.map(Exact::from));
/// assert_eq!(not_negative(&sides).map(|t| t.map(|t| t.nearest())), Some([0.25, 0.5]));
/// ```
#[must_use]
pub fn not_negative(functions: &[[Exact; 2]]) -> Option<[Exact; 2]> {
    let (mut first, mut last) = (Exact::ZERO, Exact::from(1));
    for [s, e] in functions {
        match s.over(&(s - e)) {
            Some(zero) if s < e => first = first.max(zero),
            Some(zero) => last = last.min(zero),
            None if *s < 0 => return None,
            None => {}
        }
    }
    (first <= last).then_some([first, last])
}

/// a + t (b − a).
#[must_use]
pub fn between(t: &Exact, a: &Exact, b: &Exact) -> Exact {
    a + t * (b - a)
}

#[cfg(test)]
mod tests {
    use super::{between, not_negative};
    use crate::Exact;

    #[test]
    fn by_hand() {
        let part = |sides: &[[i32; 2]]| {
            let sides: Vec<_> = sides.iter().map(|s| s.map(Exact::from)).collect();
            not_negative(&sides).map(|t| t.map(|t| t.nearest()))
        };
        assert_eq!(part(&[]), Some([0.0, 1.0]));
        // Parallel to a side: on it, inside it, outside it.
        assert_eq!(part(&[[0, 0], [2, 2]]), Some([0.0, 1.0]));
        assert_eq!(part(&[[-1, -1]]), None);
        assert_eq!(part(&[[-1, 2], [2, -1]]), Some([1.0 / 3.0, 2.0 / 3.0]));
        // A single t, and none.
        assert_eq!(part(&[[-1, 2], [1, -2]]), Some([1.0 / 3.0; 2]));
        assert_eq!(part(&[[-2, 1], [1, -2]]), None);
        assert_eq!(part(&[[-2, -1]]), None);
        assert_eq!(part(&[[0, -1], [0, 1]]), Some([0.0, 0.0]));
    }

    #[test]
    fn between_two_numbers() {
        let [a, b] = [4, 10].map(Exact::from);
        let third = Exact::from(1).over(&Exact::from(3)).unwrap();
        assert_eq!(between(&third, &a, &b), 6);
        assert_eq!(between(&Exact::from(1), &a, &b), b);
    }
}
