//! How fine stored depths are: the step of each format at a distance, from the formula and measured.
//!
//! Of two surfaces nearer to each other than the step, the stored depths may be the same, and the one drawn first is
//! seen whichever is nearer: z-fighting. Distances are those of a perspective view, along its axis; the far plane may
//! be at infinity.
#![cfg_attr(doc, doc = "")]
#![cfg_attr(doc, doc = include_str!("../../figures/depth-precision.svg"))]

use ombra_raster::depth_format::DepthFormat;

/// The two planes of a perspective view.
#[derive(Clone, Copy)]
struct Planes {
    near: f64,
    far: f64,
    /// (far − near) / far, within 2 roundings: 1 − near / far would lose the digits of a thin volume.
    share: f64,
}

impl Planes {
    fn new(near: f64, far: f64) -> Option<Self> {
        let valid = near > 0.0 && near < far && near.is_finite();
        let share = if far < f64::INFINITY {
            (far - near) / far
        } else {
            1.0
        };
        valid.then_some(Self { near, far, share })
    }

    /// The depth at a distance from near to far.
    fn depth(self, distance: f64) -> f64 {
        // Rounded, the quotient may be above 1 just before the far plane.
        ((distance - self.near) / distance / self.share).min(1.0)
    }

    /// What the format stores: depth or 1 − depth = n (f − z) / (z (f − n)).
    fn value<F: DepthFormat>(self, distance: f64) -> f64 {
        if !F::REVERSED {
            self.depth(distance)
        } else if self.far < f64::INFINITY {
            (self.near / distance) * ((self.far - distance) / (self.far - self.near))
        } else {
            self.near / distance
        }
    }

    /// The distance at which the format stores `value`.
    ///
    /// ```text
    /// n / z = (1 − d) + d n / f
    /// ```
    fn distance<F: DepthFormat>(self, value: f64) -> f64 {
        let [depth, rest] = if F::REVERSED {
            [1.0 - value, value]
        } else {
            [value, 1.0 - value]
        };
        (self.near / (rest + depth * (self.near / self.far))).clamp(self.near, self.far)
    }

    /// How far the distance is from one stored value to the next, `spacing` away: δ z (z / n) (f − n) / f.
    fn step(self, distance: f64, spacing: f64) -> f64 {
        // z² / n may leave the range of a double where the step does not: exponents apart.
        let (z, z_exponent) = libm::frexp(distance);
        let (n, n_exponent) = libm::frexp(self.near);
        let (delta, delta_exponent) = libm::frexp(spacing);
        let step = delta * z * (z / n) * self.share;
        libm::scalbn(step, delta_exponent + 2 * z_exponent - n_exponent)
    }
}

fn planes_and_distance(near: f64, far: f64, distance: f64) -> Option<Planes> {
    let planes = Planes::new(near, far)?;
    (distance.is_finite() && (near..=far).contains(&distance)).then_some(planes)
}

/// The depth of a point at `distance` from the eye, along the axis of a perspective view.
///
/// # Formula
///
/// ```text
/// d = f (z − n) / (z (f − n))          0 at n, 1 at f; for f = ∞:  d = 1 − n / z
/// ```
///
/// # Properties
///
/// From 0 to 1.
///
/// - Error: 2½ ε of itself
///
/// # Errors
///
/// `None` unless 0 < near ≤ distance ≤ far, all but far finite, and near < far.
///
/// # Pitfalls
///
/// (1 − n / z) / (1 − n / f) loses its digits where z or f is near n: 1 − n / f has those of the difference alone.
///
/// # Examples
///
/// ```
/// use ombra_hsr::z_buffer::precision::depth_at;
///
/// // Half of all depths lie between the near plane and twice its distance, nearly.
/// assert_eq!(depth_at(1.0, 1000.0, 2.0), Some(0.5 / 0.999));
/// assert_eq!(depth_at(1.0, f64::INFINITY, 2.0), Some(0.5));
/// assert_eq!(depth_at(1.0, 1000.0, 0.5), None);
/// ```
///
/// # References
///
/// CIS 781, «Standard glFrustum projection matrix», taken to 0 … 1.
#[must_use]
pub fn depth_at(near: f64, far: f64, distance: f64) -> Option<f64> {
    Some(planes_and_distance(near, far, distance)?.depth(distance))
}

/// The difference in distance that a format can tell apart at `distance`.
///
/// # Formula
///
/// ```text
/// Δz = δ / |dd/dz| = δ z² (f − n) / (f n)
///
/// δ = 1 / (2ᵇ − 1)                b bits
/// δ = 2ᵉ⁻²³,  2ᵉ ≤ v < 2ᵉ⁺¹       single precision;
///                                  v is what is stored: d, or 1 − d reversed
/// ```
///
/// # Properties
///
/// Reversed, v is about n / z, and δ shrinks with it: Δz / z stays between 2⁻²⁴ and 2⁻²³ far from the far plane.
///
/// - Error: 3½ ε of itself, short of underflow, with the δ of a v that is within 2½ ε of the true one
///
/// # Pitfalls
///
/// This is the format's share. Coordinates have theirs: positions are doubles, and corners are snapped to sub-pixels, so
/// the depth of a slanted surface is that of a place 2⁻⁹ of a pixel aside.
///
/// # Errors
///
/// As [`depth_at`].
///
/// # Examples
///
/// ```
/// use ombra_hsr::z_buffer::precision::depth_step;
/// use ombra_hsr::z_buffer::{Depth16, Depth24, ReversedDepth32F};
///
/// let (near, far, distance) = (0.1, 1000.0, 500.0);
/// let centimetres = |step: Option<f64>| (100.0 * step.unwrap()).round();
/// assert_eq!(centimetres(depth_step::<Depth16>(near, far, distance)), 3814.0);
/// assert_eq!(centimetres(depth_step::<Depth24>(near, far, distance)), 15.0);
/// assert_eq!(centimetres(depth_step::<ReversedDepth32F>(near, far, distance)), 0.0);
/// ```
///
/// # References
///
/// Grafica 3, «Algoritmo Z-Buffer», has no formula; this one is the derivative of [`depth_at`].
#[doc(alias = "depth resolution")]
#[must_use]
pub fn depth_step<F: DepthFormat>(near: f64, far: f64, distance: f64) -> Option<f64> {
    let planes = planes_and_distance(near, far, distance)?;
    let spacing = F::spacing(planes.value::<F>(distance));
    Some(planes.step(distance, spacing))
}

/// [`depth_step`] measured: from the least to the greatest distance that are stored as `distance` is.
///
/// # Properties
///
/// Found by bisection, with the format's own rounding of a value within 2½ ε of the true one. Shorter at the two
/// planes and, in floating point, where the stored value is a power of two.
///
/// - Error: ½ ε of itself: the two distances are doubles that are stored so, the next ones outside are not
///
/// # Errors
///
/// As [`depth_at`], and `None` for a far plane at infinity.
#[must_use]
pub fn separable_distance<F: DepthFormat>(near: f64, far: f64, distance: f64) -> Option<f64> {
    let planes = planes_and_distance(near, far, distance)?;
    if !far.is_finite() {
        return None;
    }
    let stored = |z: f64| F::encode(planes.value::<F>(z));
    let here = stored(distance);
    // Between a distance stored alike and one that is not, or the end of the range.
    let border = |end: f64| {
        if stored(end) == here {
            return end;
        }
        let (mut alike, mut other) = (distance, end);
        loop {
            let middle = 0.5 * alike + 0.5 * other;
            if middle == alike || middle == other {
                return alike;
            }
            if stored(middle) == here {
                alike = middle;
            } else {
                other = middle;
            }
        }
    };
    Some(border(far) - border(near))
}

/// The distance from which on two surfaces, one `gap` behind the other, may get the same depth.
///
/// # Formula
///
/// ```text
/// the least z with Δz(z) ≥ gap          z = √(gap · f n / ((f − n) δ)) where δ is constant
/// ```
///
/// # Properties
///
/// - Error: 5 ε of itself, for a gap within 12 ε of the given one, short of underflow
///
/// # Errors
///
/// `None` if that is beyond the far plane or the largest double, or for planes that are none, or a gap that is not
/// positive.
///
/// # Examples
///
/// ```
/// use ombra_hsr::z_buffer::precision::fighting_distance;
/// use ombra_hsr::z_buffer::{Depth16, Depth24, ReversedDepth32F};
///
/// // A poster one centimetre before a wall, in metres.
/// let metres = |z: Option<f64>| z.map(f64::round);
/// assert_eq!(metres(fighting_distance::<Depth16>(0.1, 1000.0, 0.01)), Some(8.0));
/// assert_eq!(metres(fighting_distance::<Depth24>(0.1, 1000.0, 0.01)), Some(130.0));
/// assert_eq!(metres(fighting_distance::<ReversedDepth32F>(0.1, 1000.0, 0.01)), None);
/// ```
///
/// # References
///
/// As [`depth_step`].
#[doc(alias = "z-fighting")]
#[must_use]
pub fn fighting_distance<F: DepthFormat>(near: f64, far: f64, gap: f64) -> Option<f64> {
    let planes = Planes::new(near, far)?;
    if gap.is_nan() || gap <= 0.0 {
        return None;
    }
    // The values from one power of two to the next have one spacing. In order of distance:
    let powers = -149..0;
    let bands = powers.map(|e| [libm::scalbn(1.0, e), libm::scalbn(1.0, e + 1)]);
    let mut bands: Vec<_> = core::iter::once([0.0, libm::scalbn(1.0, -149)])
        .chain(bands)
        .collect();
    if F::REVERSED {
        bands.reverse();
    }
    bands
        .into_iter()
        .find_map(|[low, high]| {
            let ends = [low, high].map(|value| planes.distance::<F>(value));
            let [first, last] = [ends[0].min(ends[1]), ends[0].max(ends[1])];
            // Δz = gap; a root at a time, so that nothing leaves the range of a double on the way.
            let roots = [gap, F::spacing(low), near, planes.share].map(f64::sqrt);
            let [gap, spacing, near, share] = roots;
            let distance = (gap / spacing) * (near / share);
            (distance <= last && first < far).then_some(distance.max(first))
        })
        .filter(|&distance| distance <= far.min(f64::MAX))
}
