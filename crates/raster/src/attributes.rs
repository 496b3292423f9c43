//! Attributes of a triangle's corners, depth, colour, texture coordinates, at its pixels.
//!
//! A pixel's centre is a mixture of the corners, by its barycentric weights; an attribute that is linear on the
//! screen is the same mixture of the corners' values. One that is linear in space is not, under perspective: the
//! weights must be divided by each corner's w first. That correction is in no deck.
#![cfg_attr(doc, doc = "")]
#![cfg_attr(doc, doc = include_str!("../figures/perspective-correct.svg"))]
#![doc(alias = "interpolation")]
#![doc(alias = "varying")]

mod fast;

use ombra_math::exact::Sum;
use ombra_math::glam::{DVec2, DVec3};

use crate::span::Span;

/// [`weights`] exact as its formula: the shares of three triangles in the whole.
///
/// # Properties
///
/// - Error: none: the nearest doubles.
///
/// # Errors
///
/// As [`weights`].
///
/// # References
///
/// As [`weights`].
#[must_use]
pub fn weights_plain(triangle: [DVec2; 3], p: DVec2) -> Option<DVec3> {
    let [a, b, c] = triangle;
    // P parts the triangle into three; a corner weighs as much as the part opposite to it.
    let parts = [
        twice_area(b, c, p),
        twice_area(c, a, p),
        twice_area(a, b, p),
    ];
    let whole = twice_area(a, b, c);
    let weights = DVec3::from_array(parts.map(|part| part.quotient(&whole)));
    weights.is_finite().then_some(weights)
}

/// E(a, b, p) = (b − a) × (p − a), exact, as the sum of its products.
fn twice_area(a: DVec2, b: DVec2, p: DVec2) -> Sum {
    Sum::of(&[
        [a.x, b.y, 1.0],
        [-a.y, b.x, 1.0],
        [b.x, p.y, 1.0],
        [-b.y, p.x, 1.0],
        [p.x, a.y, 1.0],
        [-p.y, a.x, 1.0],
    ])
}

/// The barycentric weights (λ₀, λ₁, λ₂) of `p` in a triangle on the screen.
///
/// # Formula
///
/// ```text
/// λ₀ = E(b, c, p) / E(a, b, c)    λ₁ = E(c, a, p) / E(a, b, c)    λ₂ = E(a, b, p) / E(a, b, c)
/// E(a, b, p) = (b − a) × (p − a),  twice the area of the triangle a b p
/// ```
///
/// # Properties
///
/// - Error: at most 64 ε |λᵢ|, short of underflow.
/// - Each has the exact sign: ≥ 0 inside and on the border, 0 on the opposite side alone. At a corner they are 1, 0, 0.
///   Either winding gives the same weights but for rounding.
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
#[doc(alias = "barycentric coordinates")]
#[must_use]
pub fn weights(triangle: [DVec2; 3], p: DVec2) -> Option<DVec3> {
    fast::weights(triangle, p)
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
/// - Error: at most 128 ε max(|λᵢ(start)|, |λᵢ(end − 1)|), short of underflow.
/// - The step is multiplied, not added up, so the error does not grow with the length of the span.
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
    let start = span.x.start;
    let centre = DVec2::new(f64::from(start) + 0.5, f64::from(span.y) + 0.5);
    let first = weights(triangle, centre)?;
    let step = fast::gradient(triangle);
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
/// - Error: at most 2 ε Σ|λᵢ aᵢ|, given λ, and with the λ of [`weights`] at most 67 ε Σ|λᵢ aᵢ|, short of underflow.
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
/// - Error: at most 5 ε |μᵢ|, given λ ≥ 0, short of underflow.
/// - Only the ratios of the w count. Equal w change nothing but rounding.
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
/// - Error: at most 140 ε max|aᵢ|, at a point of the triangle with the λ of [`weights`], short of underflow.
/// - That holds whatever the ratios of the w.
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
#[doc(alias = "perspective-correct")]
#[doc(alias = "perspective correct interpolation")]
#[must_use]
pub fn perspective(weights: DVec3, values: [f64; 3], w: [f64; 3]) -> Option<f64> {
    Some(linear(perspective_weights(weights, w)?, values))
}

#[cfg(test)]
mod tests;
