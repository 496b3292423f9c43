//! The six planes of the view volume, and which comes first: t against t, exactly.

use core::cmp::Ordering;

use ombra_math::exact::Sum;
use ombra_math::glam::DVec4;
use ombra_math::work::{Count, Counter};

/// A plane of the view volume.
///
/// # Formula
///
/// ```text
/// left: w + x ≥ 0     below: w + y ≥ 0     near: w + z ≥ 0
/// right: w − x ≥ 0    above: w − y ≥ 0     far: w − z ≥ 0
/// ```
///
/// # References
///
/// CIS 781, «Standard glFrustum projection matrix» (OpenGL's clip space).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ViewPlane {
    /// x = −w.
    Left,
    /// x = w.
    Right,
    /// y = −w.
    Below,
    /// y = w.
    Above,
    /// z = −w.
    #[doc(alias = "near plane")]
    Near,
    /// z = w.
    #[doc(alias = "far plane")]
    Far,
}

impl ViewPlane {
    /// All six.
    pub const ALL: [Self; 6] = [
        Self::Near,
        Self::Far,
        Self::Left,
        Self::Right,
        Self::Below,
        Self::Above,
    ];

    /// The two numbers whose sum is positive inside: w and ± a coordinate.
    ///
    /// # Properties
    ///
    /// - Error: none: numbers of `p` as they are, or with the other sign.
    #[must_use]
    pub fn terms(self, p: DVec4) -> [f64; 2] {
        match self {
            Self::Left => [p.w, p.x],
            Self::Right => [p.w, -p.x],
            Self::Below => [p.w, p.y],
            Self::Above => [p.w, -p.y],
            Self::Near => [p.w, p.z],
            Self::Far => [p.w, -p.z],
        }
    }

    /// The sum of the terms, rounded; its sign is exact.
    pub(super) fn side(self, p: DVec4) -> f64 {
        let [w, x] = self.terms(p);
        w + x
    }
}

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
        return left.total_cmp(&right);
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
