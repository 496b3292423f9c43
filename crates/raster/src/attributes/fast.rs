//! Rounded areas where they keep their digits, exact ones elsewhere.

use ombra_math::exact::Sum;
use ombra_math::glam::{DVec2, DVec3};

use super::weights_plain;

/// The body of [`weights`](super::weights).
pub(super) fn weights(triangle: [DVec2; 3], p: DVec2) -> Option<DVec3> {
    let [a, b, c] = triangle;
    let parts = [(b, c), (c, a), (a, b)].map(|(a, b)| twice_area(a, b, p));
    match (twice_area(a, b, c), parts) {
        (Some(whole), [Some(x), Some(y), Some(z)]) => {
            let weights = DVec3::new(x, y, z) / whole;
            weights.is_finite().then_some(weights)
        }
        _ => weights_plain(triangle, p),
    }
}

/// What the weights gain from a pixel to the one on its right.
pub(super) fn gradient(triangle: [DVec2; 3]) -> DVec3 {
    let [a, b, c] = triangle;
    let sides = [(b, c), (c, a), (a, b)];
    DVec3::from_array(match twice_area(a, b, c) {
        Some(whole) => sides.map(|(from, to)| (from.y - to.y) / whole),
        None => {
            let whole = super::twice_area(a, b, c);
            sides.map(|(from, to)| {
                Sum::of(&[[from.y, 1.0, 1.0], [-to.y, 1.0, 1.0]]).quotient(&whole)
            })
        }
    })
}

/// E(a, b, p) where rounding leaves it within 25ε of itself and it is not near the ends of a double's range.
fn twice_area(a: DVec2, b: DVec2, p: DVec2) -> Option<f64> {
    const RANGE: core::ops::Range<f64> = 1e-140..1e140;
    let (u, v) = (b - a, p - a);
    let (x, y) = (u.x * v.y, u.y * v.x);
    let size = x.abs() + y.abs();
    // Each product is within 3 ε/2 of itself, so E within 3 ε/2 of the size, 24ε of itself, and one rounding.
    ((x - y).abs() >= size / 16.0 && RANGE.contains(&size)).then_some(x - y)
}
