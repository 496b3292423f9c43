//! Attributes of a triangle's corners, depth, colour, texture coordinates, at its pixels.
//!
//! A pixel's centre is a mixture of the corners, by its barycentric weights; an attribute that is linear on the
//! screen is the same mixture of the corners' values. One that is linear in space is not, under perspective: the
//! weights must be divided by each corner's w first. That correction is in no deck.

use core::cmp::Ordering;

use ombra_math::exact::Sum;
use ombra_math::glam::{DVec2, DVec3};

use crate::span::Span;

/// The barycentric weights (λ₀, λ₁, λ₂) of `p` in a triangle on the screen.
///
/// # Formula
///
/// ```text
/// λ₀ = E(b, c, p) / E(a, b, c)     λ₁ = E(c, a, p) / E(a, b, c)     λ₂ = E(a, b, p) / E(a, b, c)
/// E(a, b, p) = (b − a) × (p − a),  twice the area of the triangle a b p
/// ```
///
/// # Properties
///
/// Each is within 64ε of itself, with the exact sign, short of underflow: ≥ 0 inside and on the border, 0 on the
/// opposite side alone. At a corner they are 1, 0, 0. Either winding gives the same weights but for rounding.
///
/// # Errors
///
/// `None` for a degenerate triangle, a point that is not finite, and weights that no double holds.
///
/// # Examples
///
/// ```
/// use ombra_math::glam::{DVec2, DVec3};
/// use ombra_raster::attributes::weights;
///
/// let triangle = [DVec2::ZERO, DVec2::new(4.0, 0.0), DVec2::new(0.0, 4.0)];
/// assert_eq!(weights(triangle, DVec2::new(1.0, 2.0)), Some(DVec3::new(0.25, 0.25, 0.5)));
/// ```
///
/// # References
///
/// Grafica 3, «Algoritmo Z-Buffer»: the depth of the point of the primitive at each pixel; Olomouc, «Gouraud
/// shading».
#[must_use]
pub fn weights(triangle: [DVec2; 3], p: DVec2) -> Option<DVec3> {
    let [a, b, c] = triangle;
    let parts = [[b, c, p], [c, a, p], [a, b, p]];
    let rounded = parts.map(|[a, b, c]| twice_area(a, b, c));
    let weights = match (twice_area(a, b, c), rounded) {
        (Some(whole), [Some(x), Some(y), Some(z)]) => DVec3::new(x, y, z) / whole,
        _ => {
            let whole = exact_twice_area(a, b, c);
            if whole.sign() == Some(Ordering::Equal) {
                return None;
            }
            let [x, y, z] = parts.map(|[a, b, c]| exact_twice_area(a, b, c).quotient(&whole));
            DVec3::new(x, y, z)
        }
    };
    weights.is_finite().then_some(weights)
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

fn exact_twice_area(a: DVec2, b: DVec2, p: DVec2) -> Sum {
    Sum::of(&[
        [a.x, b.y, 1.0],
        [-a.y, b.x, 1.0],
        [b.x, p.y, 1.0],
        [-b.y, p.x, 1.0],
        [p.x, a.y, 1.0],
        [-p.y, a.x, 1.0],
    ])
}

/// The weights at the centres of a span's pixels, left to right: found once, then stepped.
///
/// # Formula
///
/// ```text
/// λ(i) = λ(start) + (i − start) g          g₀ = (b.y − c.y) / E(a, b, c),  and so on round
/// ```
///
/// # Properties
///
/// The step is multiplied, not added up, so the error does not grow with the length of the span: each weight is
/// within 128ε of the larger |λ| at the span's two ends.
///
/// # Pitfalls
///
/// Near an edge a weight may come out below 0 by that error, where [`weights`] would not.
///
/// # Errors
///
/// As [`weights`], and `None` for steps that no double holds.
///
/// # Examples
///
/// ```
/// use ombra_math::glam::DVec2;
/// use ombra_raster::attributes::{along, linear};
/// use ombra_raster::span::Span;
///
/// let triangle = [DVec2::ZERO, DVec2::new(8.0, 0.0), DVec2::new(0.0, 8.0)];
/// let depths = [1.0, 0.0, 1.0];
/// let span = Span { y: 0, x: 0..4 };
/// let row: Vec<f64> = along(triangle, &span).unwrap().map(|weights| linear(weights, depths)).collect();
/// assert_eq!(row, [0.9375, 0.8125, 0.6875, 0.5625]);
/// ```
///
/// # References
///
/// As [`weights`]; the step is that of Grafica 3, «Soluzione analitica»: an addition instead of a multiplication,
/// but see there what adding up does to the error.
#[must_use]
pub fn along(triangle: [DVec2; 3], span: &Span) -> Option<impl Iterator<Item = DVec3> + use<>> {
    let [a, b, c] = triangle;
    let start = span.x.start;
    let centre = DVec2::new(f64::from(start) + 0.5, f64::from(span.y) + 0.5);
    let first = weights(triangle, centre)?;
    let sides = [(b, c), (c, a), (a, b)];
    let [x, y, z] = match twice_area(a, b, c) {
        Some(whole) => sides.map(|(from, to)| (from.y - to.y) / whole),
        None => {
            let whole = exact_twice_area(a, b, c);
            sides.map(|(from, to)| {
                Sum::of(&[[from.y, 1.0, 1.0], [-to.y, 1.0, 1.0]]).quotient(&whole)
            })
        }
    };
    let step = DVec3::new(x, y, z);
    step.is_finite().then(|| {
        span.x
            .clone()
            .map(move |x| first + step * f64::from(x - start))
    })
}

/// An attribute that is linear on the screen, from its values at the corners.
///
/// # Formula
///
/// ```text
/// a = λ₀ a₀ + λ₁ a₁ + λ₂ a₂
/// ```
///
/// # Properties
///
/// Within 2ε·Σ|λᵢ aᵢ| of the exact mixture by these weights; with the weights of [`weights`], within
/// 67ε·Σ|λᵢ aᵢ| of the exact attribute, short of underflow.
///
/// # Pitfalls
///
/// Right for z/w and 1/w, and for everything in a parallel view. A texture coordinate in perspective wants
/// [`perspective`].
///
/// # References
///
/// Grafica 3, «Algoritmo Z-Buffer»; Olomouc, «Gouraud shading».
#[must_use]
pub fn linear(weights: DVec3, values: [f64; 3]) -> f64 {
    weights.dot(DVec3::from_array(values))
}

/// The weights in space of a point whose weights on the screen are `weights`, the corners' w being `w`.
///
/// # Formula
///
/// ```text
///       λᵢ/wᵢ
/// μᵢ = ───────
///      Σ λⱼ/wⱼ
/// ```
///
/// # Properties
///
/// For λ ≥ 0 each is within 5ε of itself, given λ; only the ratios of the w count. Equal w change nothing but
/// rounding.
///
/// # Errors
///
/// `None` unless every w is positive and finite: a corner at or behind the eye has to be clipped first. Also
/// where Σ λⱼ/wⱼ is not positive, which no point of the triangle has, or leaves the range of a double.
///
/// # Examples
///
/// The middle of an edge on the screen is nearer to its near end in space:
///
/// ```
/// use ombra_math::glam::DVec3;
/// use ombra_raster::attributes::perspective_weights;
///
/// let middle = DVec3::new(0.5, 0.5, 0.0);
/// assert_eq!(perspective_weights(middle, [1.0, 3.0, 1.0]), Some(DVec3::new(0.75, 0.25, 0.0)));
/// assert_eq!(perspective_weights(middle, [1.0, 0.0, 1.0]), None);
/// ```
///
/// # References
///
/// Beyond the decks. J. F. Blinn, «Hyperbolic interpolation», 1992.
#[must_use]
pub fn perspective_weights(weights: DVec3, w: [f64; 3]) -> Option<DVec3> {
    if !w.iter().all(|&w| w > 0.0 && w < f64::INFINITY) {
        return None;
    }
    let w = DVec3::from_array(w);
    // Divided by the smallest, so that 1/w cannot overflow.
    let shares = weights * (w.min_element() / w);
    let total = shares.element_sum();
    (total > 0.0 && total < f64::INFINITY).then(|| shares / total)
}

/// An attribute that is linear in space, seen in perspective, from its values at the corners.
///
/// # Formula
///
/// ```text
///     Σ λᵢ aᵢ/wᵢ
/// a = ──────────
///      Σ λᵢ/wᵢ
/// ```
///
/// # Properties
///
/// For a point of the triangle, with the weights of [`weights`], within 140ε·max|aᵢ| of the exact attribute,
/// short of underflow, whatever the ratios of the w.
///
/// # Pitfalls
///
/// Stepping weights ([`along`]) and correcting them has a larger error: beside an edge a weight's error may be all
/// of it, and the correction multiplies it by up to w_max/w_min.
///
/// # Errors
///
/// As [`perspective_weights`].
///
/// # Examples
///
/// ```
/// use ombra_math::glam::DVec3;
/// use ombra_raster::attributes::{linear, perspective};
///
/// let (middle, u, w) = (DVec3::new(0.5, 0.5, 0.0), [0.0, 8.0, 0.0], [1.0, 3.0, 1.0]);
/// assert_eq!(perspective(middle, u, w), Some(2.0));
/// assert_eq!(linear(middle, u), 4.0); // where the texture would swim
/// ```
///
/// # References
///
/// As [`perspective_weights`].
#[must_use]
pub fn perspective(weights: DVec3, values: [f64; 3], w: [f64; 3]) -> Option<f64> {
    Some(linear(perspective_weights(weights, w)?, values))
}

#[cfg(test)]
mod tests;
