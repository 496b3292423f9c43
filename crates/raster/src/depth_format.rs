//! How a depth is stored: 16 bits, 24 bits, floating point, floating point reversed.
//!
//! The depth of what the eye sees is a number from 0 on the near plane to 1 on the far one. A
//! [`DepthBuffer`](crate::buffers::DepthBuffer) keeps it in few digits; each format is a type.

use core::fmt::Debug;

use image::Primitive;
use ombra_math::glam::DVec4;

/// A way to store depths; the z-buffer is one and the same for all.
///
/// Sealed: the formats are [`Depth16`], [`Depth24`], [`Depth32F`] and [`ReversedDepth32F`]. The fast form of the
/// z-buffer relies on more than these methods say.
///
/// ```compile_fail,E0277
/// use ombra_raster::depth_format::DepthFormat;
///
/// #[derive(Clone, Copy, Debug)]
/// struct Mine;
/// impl DepthFormat for Mine {
///     type Stored = u8;
///     const NAME: &'static str = "8 bits";
///     const REVERSED: bool = false;
///     const FAR: u8 = 255;
///     const NEVER: f64 = 2.0;
///     fn encode(value: f64) -> u8 { (255.0 * value) as u8 }
///     fn decode(stored: u8) -> f64 { f64::from(stored) / 255.0 }
///     fn spacing(_: f64) -> f64 { 1.0 / 255.0 }
/// }
/// ```
///
/// # Formula
///
/// ```text
/// depth   d = (w + z) / 2w     0 on the near plane, 1 on the far one
/// stored  b bits:    d (2ᵇ − 1), rounded to the nearest integer, ties to even
///         float:     d, rounded to 24 binary digits
///         reversed:  1 − d = (w − z) / 2w, rounded to 24 binary digits;
///                    near and far change places
/// ```
///
/// # Pitfalls
///
/// 1 − d computed from a stored d gains nothing: the digits are gone. Nor does w − z from clip coordinates, doubles that
/// are all but the same far away. The z-buffer takes w ± z from the rows of the matrix: it has all digits, of the depth
/// that this matrix stands for. A matrix is made of rounded numbers too, and its near and far planes are a little off:
/// 1 − d as a whole may be wrong by a share of some ε · distance / near, alike for all that is drawn with this matrix.
///
/// # Examples
///
/// ```
/// use ombra_raster::depth_format::{Depth16, Depth32F, DepthFormat, ReversedDepth32F};
///
/// // Two depths near the far plane, a millionth of a millionth apart.
/// let [a, b] = [1e-9, 1.001e-9];
/// assert_eq!(Depth16::encode(1.0 - a), Depth16::encode(1.0 - b));
/// assert_eq!(Depth32F::encode(1.0 - a), Depth32F::encode(1.0 - b));
/// let [a, b] = [a, b].map(ReversedDepth32F::encode);
/// assert!(ReversedDepth32F::is_nearer(b, a));
/// ```
///
/// # References
///
/// Grafica 3, «Algoritmo Z-Buffer». The reversed format is in no deck.
pub trait DepthFormat: sealed::Sealed + Copy + Debug + Send + Sync + 'static {
    /// A stored depth.
    type Stored: Primitive + Debug + Send + Sync + 'static;

    /// Its name in tables: `24 bits`.
    const NAME: &'static str;
    /// Whether 1 − depth is stored.
    const REVERSED: bool;
    /// The stored value of the far plane, which a cleared buffer holds.
    const FAR: Self::Stored;
    /// A value beyond the far plane: as it is stored, it is nearer than nothing.
    const NEVER: f64;

    /// A value 0 … 1, of depth or 1 − depth as the format wants it, as it is stored: rounded to nearest. What lies
    /// outside is taken to the nearer end by the formats in bits, and kept by those in floating point.
    fn encode(value: f64) -> Self::Stored;

    /// What a stored value stands for: a value 0 … 1, of depth or 1 − depth.
    ///
    /// # Properties
    ///
    /// - Error: ½ ε of itself in bits, 0 in floating point
    fn decode(stored: Self::Stored) -> f64;

    /// How far stored values are apart around `value`, of 0 … 1.
    ///
    /// # Properties
    ///
    /// - Error: ½ ε of itself in bits, 0 in floating point
    fn spacing(value: f64) -> f64;

    /// Whether `a` is strictly nearer to the eye than `b`.
    #[inline(always)]
    fn is_nearer(a: Self::Stored, b: Self::Stored) -> bool {
        if Self::REVERSED { a > b } else { a < b }
    }

    /// The nearer one of two.
    #[inline(always)]
    fn nearer(a: Self::Stored, b: Self::Stored) -> Self::Stored {
        if Self::is_nearer(a, b) { a } else { b }
    }

    /// The value of a point in clip space; 0 … 1 between near and far.
    ///
    /// # Properties
    ///
    /// - Error: ε of itself, short of underflow
    #[inline(always)]
    fn value(p_clip: DVec4) -> f64 {
        let z = if Self::REVERSED { -p_clip.z } else { p_clip.z };
        // Halved first: 2w may be beyond the largest double.
        (0.5 * p_clip.w + 0.5 * z) / p_clip.w
    }
}

/// Keeps implementations inside.
mod sealed {
    pub trait Sealed {}

    impl Sealed for super::Depth16 {}
    impl Sealed for super::Depth24 {}
    impl Sealed for super::Depth32F {}
    impl Sealed for super::ReversedDepth32F {}
}

/// Depth in 16 bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Depth16;

/// Depth in 24 bits, kept in 32.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Depth24;

/// Depth in single precision.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Depth32F;

/// 1 − depth in single precision: the digits are dense where the perspective crowds the depths, at the far end.
#[doc(alias = "reversed z")]
#[doc(alias = "reverse z")]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ReversedDepth32F;

/// An integer of 24 bits, kept in 32: a depth of [`Depth24`].
///
/// # Examples
///
/// ```
/// use ombra_raster::depth_format::U24;
///
/// assert_eq!(U24::new(0xff_ffff), Some(U24::MAX));
/// assert_eq!(U24::new(0x100_0000), None);
/// assert_eq!(U24::MAX.get(), 16_777_215);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct U24(u32);

impl U24 {
    /// 2²⁴ − 1.
    pub const MAX: Self = Self((1 << 24) - 1);

    /// `value`, or `None` if it needs more than 24 bits.
    #[must_use]
    pub const fn new(value: u32) -> Option<Self> {
        if value <= Self::MAX.0 {
            Some(Self(value))
        } else {
            None
        }
    }

    /// The value.
    #[must_use]
    pub const fn get(self) -> u32 {
        self.0
    }
}

impl DepthFormat for Depth16 {
    type Stored = u16;
    const NAME: &'static str = "16 bits";
    const REVERSED: bool = false;
    const FAR: u16 = u16::MAX;
    const NEVER: f64 = 2.0;

    #[inline(always)]
    fn encode(value: f64) -> u16 {
        nearest_integer(value.clamp(0.0, 1.0) * f64::from(u16::MAX)) as u16
    }

    #[inline(always)]
    fn decode(stored: u16) -> f64 {
        f64::from(stored) / f64::from(u16::MAX)
    }

    fn spacing(_: f64) -> f64 {
        1.0 / f64::from(u16::MAX)
    }
}

impl DepthFormat for Depth24 {
    type Stored = u32;
    const NAME: &'static str = "24 bits";
    const REVERSED: bool = false;
    const FAR: u32 = U24::MAX.get();
    const NEVER: f64 = 2.0;

    #[inline(always)]
    fn encode(value: f64) -> u32 {
        nearest_integer(value.clamp(0.0, 1.0) * f64::from(U24::MAX.get())) as u32
    }

    #[inline(always)]
    fn decode(stored: u32) -> f64 {
        f64::from(stored) / f64::from(U24::MAX.get())
    }

    fn spacing(_: f64) -> f64 {
        1.0 / f64::from(U24::MAX.get())
    }
}

impl DepthFormat for Depth32F {
    type Stored = f32;
    const NAME: &'static str = "f32";
    const REVERSED: bool = false;
    const FAR: f32 = 1.0;
    const NEVER: f64 = 2.0;

    #[inline(always)]
    fn encode(value: f64) -> f32 {
        value as f32
    }

    #[inline(always)]
    fn decode(stored: f32) -> f64 {
        f64::from(stored)
    }

    fn spacing(value: f64) -> f64 {
        spacing_f32(value)
    }
}

impl DepthFormat for ReversedDepth32F {
    type Stored = f32;
    const NAME: &'static str = "f32 reversed";
    const REVERSED: bool = true;
    const FAR: f32 = 0.0;
    const NEVER: f64 = -1.0;

    #[inline(always)]
    fn encode(value: f64) -> f32 {
        value as f32
    }

    #[inline(always)]
    fn decode(stored: f32) -> f64 {
        f64::from(stored)
    }

    fn spacing(value: f64) -> f64 {
        spacing_f32(value)
    }
}

/// The nearest integer of 0 … 2³², ties to even.
#[inline(always)]
fn nearest_integer(value: f64) -> u64 {
    // From 2⁵² to 2⁵³ a double has no place for fractions: the sum is rounded, and its last digits are the integer.
    const INTEGERS: f64 = (1u64 << 52) as f64;
    (value + INTEGERS).to_bits() & 0xffff_ffff
}

/// From a number in single precision to the next greater one.
fn spacing_f32(value: f64) -> f64 {
    let exponent = if value > 0.0 {
        libm::ilogb(value)
    } else {
        i32::MIN
    };
    libm::scalbn(1.0, exponent.max(-126) - 23)
}

#[cfg(test)]
mod tests;
