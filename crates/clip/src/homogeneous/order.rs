//! Which plane comes first: t against t, exactly.

use core::cmp::Ordering;

use ombra_math::exact::Sum;
use ombra_math::glam::DVec4;
use ombra_math::work::{Count, Counter};

use super::ViewPlane;

/// Which of two planes, each with a and b on different sides, is met first on the way from a to b: exact.
pub(super) fn order([p, q]: [ViewPlane; 2], [a, b]: [DVec4; 2], work: &mut impl Count) -> Ordering {
    work.add(Counter::Multiplications, 2);
    work.add(Counter::Comparisons, 1);
    // t_p < t_q  ⇔  |s_p(a)| |s_q(b)| < |s_q(a)| |s_p(b)|
    let left = (p.side(a) * q.side(b)).abs();
    let right = (q.side(a) * p.side(b)).abs();
    let size = left.max(right);
    // Two roundings to a side, one to a product: 3ε of the larger, if nothing left the range.
    let in_range = size < f64::MAX && size > f64::MIN_POSITIVE / f64::EPSILON;
    if in_range && (left - right).abs() > 4.0 * f64::EPSILON * size {
        return if left < right {
            Ordering::Less
        } else {
            Ordering::Greater
        };
    }
    // |s| = −s where s(a) < 0 < s(b), and s(b) has the other sign than s(a).
    let sign = |plane: ViewPlane| if plane.side(a) < 0.0 { -1.0 } else { 1.0 };
    let mut sum = Sum::default();
    for (first, second, turned) in [(p, q, 1.0), (q, p, -1.0)] {
        for x in first.terms(a) {
            for y in second.terms(b) {
                sum.add([-turned * sign(p) * sign(q), x, y]);
            }
        }
    }
    sum.sign().unwrap_or(Ordering::Equal)
}
