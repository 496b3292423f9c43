//! Four bits for a point.

use core::fmt;
use core::ops::{BitAnd, BitOr};

use ombra_math::glam::DVec2;

use crate::window::{Side, Window};

/// Where a point lies: above, below, right, left of the window.
///
/// # Formula
///
/// ```text
/// bit 1: y > y_max      bit 2: y < y_min      bit 3: x > x_max      bit 4: x < x_min
/// 1001 | 1000 | 1010
/// 0001 | 0000 | 0010
/// 0101 | 0100 | 0110
/// ```
///
/// # Properties
///
/// Bits are written from left to right, as the lecture does. 0000 is the window itself, border included. A code of six
/// bits, `Outcode<6>`, is that of a [box](crate::box3::Outcode).
///
/// # References
///
/// Grafica 3, «Algoritmo Cohen-Sutherland».
#[doc(alias = "region code")]
#[doc(alias = "area code")]
#[doc(alias = "clip code")]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Outcode<const BITS: usize = 4>(pub(crate) u8);

impl Outcode {
    /// 0000.
    pub const INSIDE: Self = Self(0);
    /// 1000.
    pub const ABOVE: Self = Self(0b1000);
    /// 0100.
    pub const BELOW: Self = Self(0b0100);
    /// 0010.
    pub const RIGHT: Self = Self(0b0010);
    /// 0001.
    pub const LEFT: Self = Self(0b0001);

    /// The code with the one bit of `side`.
    #[must_use]
    pub const fn of(side: Side) -> Self {
        Self(0b1000 >> side as u8)
    }

    /// Whether the bit of `side` is 1.
    #[must_use]
    pub const fn has(self, side: Side) -> bool {
        self.0 & Self::of(side).0 != 0
    }
}

impl<const BITS: usize> Outcode<BITS> {
    /// The bits as a number, `0b1001` for 1001.
    #[must_use]
    pub const fn bits(self) -> u8 {
        self.0
    }

    /// Whether all bits are 0.
    #[must_use]
    pub const fn is_inside(self) -> bool {
        self.0 == 0
    }
}

/// A digit a bit: `1001` is above and to the left.
impl<const BITS: usize> fmt::Display for Outcode<BITS> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:0BITS$b}", self.0)
    }
}

impl<const BITS: usize> BitAnd for Outcode<BITS> {
    type Output = Self;
    fn bitand(self, other: Self) -> Self {
        Self(self.0 & other.0)
    }
}

impl<const BITS: usize> BitOr for Outcode<BITS> {
    type Output = Self;
    fn bitor(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }
}

/// The region of `p`.
///
/// # Properties
///
/// 0000 exactly where [`Window::contains`] says inside: a coordinate that is NaN sets both bits of its axis, which no
/// number does.
///
/// # Examples
///
/// ```
/// use ombra_clip::Window;
/// use ombra_clip::cohen_sutherland::outcode;
/// use ombra_math::glam::DVec2;
///
/// let window = Window::new(DVec2::ZERO, DVec2::splat(10.0))?;
/// let (a, b) = (outcode(&window, DVec2::new(-1.0, 11.0)), outcode(&window, DVec2::new(11.0, 11.0)));
/// assert_eq!(format!("{a} AND {b} = {}", a & b), "1001 AND 1010 = 1000");
/// # Ok::<(), ombra_clip::WindowError>(())
/// ```
///
/// # References
///
/// Grafica 3, «Algoritmo Cohen-Sutherland».
#[allow(clippy::neg_cmp_op_on_partial_ord)] // so that NaN is not inside
#[inline]
#[must_use]
pub fn outcode(window: &Window, p: DVec2) -> Outcode {
    Outcode(
        u8::from(!(p.y <= window.max.y)) << 3
            | u8::from(!(p.y >= window.min.y)) << 2
            | u8::from(!(p.x <= window.max.x)) << 1
            | u8::from(!(p.x >= window.min.x)),
    )
}
