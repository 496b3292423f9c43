//! Which side comes first: t against t, exactly.

use core::cmp::Ordering;

use ombra_math::double_double::DoubleDouble;
use ombra_math::exact::{Sum, dot};
use ombra_math::glam::DVec3;
use ombra_math::homogeneous::point;
use ombra_math::plane::Plane;
use ombra_math::scaling::common;

/// n·x + d as a sum of products.
pub(super) fn products(plane: &Plane, x: DVec3) -> [[f64; 2]; 4] {
    let n = plane.normal;
    [[n.x, x.x], [n.y, x.y], [n.z, x.z], [plane.d, 1.0]]
}

/// A number with the sign of n·x + d, and a power of two to scale it by.
fn side(plane: &Plane, x: DVec3) -> (f64, i32) {
    dot(plane.coefficients(), point(x))
}

/// Which of two planes, each with a and b on different sides, is met first on the way from a to b.
pub(super) fn order(p: &Plane, q: &Plane, a: DVec3, b: DVec3) -> Ordering {
    // t_p < t_q  ⇔  |s_p(a)| |s_q(b)| < |s_q(a)| |s_p(b)|
    let product = |(f, e): (f64, i32), (g, h): (f64, i32)| (f.abs() * g.abs(), e + h);
    let products = [
        product(side(p, a), side(q, b)),
        product(side(q, a), side(p, b)),
    ];
    let ([left, right], _) = common(products);
    let rounded = left.partial_cmp(&right).unwrap_or(Ordering::Equal);
    // Four values within ε and two products: 6ε of the larger.
    let certain = (left - right).abs() > 8.0 * f64::EPSILON * left.max(right);
    if certain {
        rounded
    } else {
        order_carefully(p, q, [a, b])
    }
}

/// The same, exactly.
#[cold]
#[inline(never)]
fn order_carefully(p: &Plane, q: &Plane, [a, b]: [DVec3; 2]) -> Ordering {
    let numbers = [p.coefficients(), q.coefficients(), point(a), point(b)];
    let mut numbers = numbers.iter().flat_map(|v| v.to_array());
    if !numbers.all(DoubleDouble::in_range) {
        return Ordering::Equal;
    }
    let at_both = |plane: &Plane| [a, b].map(|x| products(plane, x));
    // Where s(a) is 0, s(b) is not.
    let enters = |plane: &Plane| side(plane, a).0 < 0.0 || side(plane, b).0 > 0.0;
    order_exactly([at_both(p), at_both(q)], [enters(p), enters(q)])
}

/// The same of any two sides, given s(a) and s(b) for each as sums of products, and whether a segment enters there.
///
/// Exact where the products neither overflow nor lose digits below the smallest double.
pub(super) fn order_exactly<const N: usize>(
    [p, q]: [[[[f64; 2]; N]; 2]; 2],
    [p_enters, q_enters]: [bool; 2],
) -> Ordering {
    // s(b) has the other sign than s(a): |s_p(a)| |s_q(b)| is s_p(a) s_q(b) of an entry and an exit, otherwise less that.
    let sign = if p_enters == q_enters { -1.0 } else { 1.0 };
    let mut sum = Sum::default();
    for ([at_a, _], [_, at_b], sign) in [(p, q, sign), (q, p, -sign)] {
        for [x, y] in at_a {
            let exact = DoubleDouble::product(x, y);
            for [z, w] in at_b {
                sum.add([sign * exact.hi, z, w]);
                sum.add([sign * exact.lo, z, w]);
            }
        }
    }
    sum.sign().unwrap_or(Ordering::Equal)
}
