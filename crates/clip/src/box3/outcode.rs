//! Six bits for a point.

use core::fmt;
use core::ops::{BitAnd, BitOr};

use ombra_math::glam::DVec3;

use super::{Box3, Face};

/// Where a point lies: above, below, right, left of the box, in front of it, behind it.
///
/// # Formula
///
/// ```text
/// bit 1: y > y_max      bit 2: y < y_min      bit 3: x > x_max      bit 4: x < x_min
/// bit 5: z > z_max      bit 6: z < z_min
/// ```
///
/// # Properties
///
/// Bits are written from left to right; the first four are those of the plane. In front is where z is greater, for
/// eyes that look along −z.
///
/// # References
///
/// Grafica 3, «Algoritmo Cohen-Sutherland» and «Clipping».
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Outcode(u8);

impl Outcode {
    /// The six bits as a number, `0b100101` for 100101.
    #[must_use]
    pub const fn bits(self) -> u8 {
        self.0
    }

    /// Whether the bit of a face is 1.
    pub(super) const fn has(self, face: Face) -> bool {
        self.0 & Self::of(face).0 != 0
    }

    /// The code with the one bit of a face.
    pub(super) const fn of(face: Face) -> Self {
        Self(1 << (5 - face as u8))
    }

    /// Whether all bits are 0.
    #[must_use]
    pub const fn is_inside(self) -> bool {
        self.0 == 0
    }
}

/// Six digits: `100101` is above, to the left and behind.
impl fmt::Display for Outcode {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:06b}", self.0)
    }
}

impl BitAnd for Outcode {
    type Output = Self;
    fn bitand(self, other: Self) -> Self {
        Self(self.0 & other.0)
    }
}

impl BitOr for Outcode {
    type Output = Self;
    fn bitor(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }
}

/// The region of `p`: 000000 exactly where [`Box3::contains`] says inside. NaN sets both bits of its axis.
///
/// # Examples
///
/// ```
/// use ombra_clip::box3::{Box3, outcode};
/// use ombra_math::glam::DVec3;
///
/// let cube = Box3::new(DVec3::ZERO, DVec3::splat(10.0))?;
/// assert_eq!(outcode(&cube, DVec3::new(-1.0, 11.0, -1.0)).to_string(), "100101");
/// # Ok::<(), ombra_clip::box3::Box3Error>(())
/// ```
#[allow(clippy::neg_cmp_op_on_partial_ord)] // so that NaN is not inside
#[must_use]
pub fn outcode(bounds: &Box3, p: DVec3) -> Outcode {
    let axis =
        |k: usize| u8::from(!(p[k] <= bounds.max[k])) << 1 | u8::from(!(p[k] >= bounds.min[k]));
    Outcode(axis(1) << 4 | axis(0) << 2 | axis(2))
}
