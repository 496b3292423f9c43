//! A segment against an upright box: Cohen–Sutherland's codes with six bits, and three strips instead of two.

use core::cmp::Ordering;
use core::fmt;
use core::ops::{BitAnd, BitOr};

use ombra_math::glam::{DVec2, DVec3};
use ombra_math::work::{Count, Counter};

use crate::crossing::{at, order};
use crate::segment::Segment;
use crate::window::Line;

/// The box x_min ≤ x ≤ x_max, y_min ≤ y ≤ y_max, z_min ≤ z ≤ z_max, its border included.
///
/// # Properties
///
/// It may be flat. Fields are public; a box written by hand with min above max, or with NaN, contains no point.
///
/// # Examples
///
/// ```
/// use ombra_clip::box3::Box3;
/// use ombra_math::glam::DVec3;
///
/// let cube = Box3::new(DVec3::ZERO, DVec3::splat(10.0))?;
/// assert!(cube.contains(DVec3::new(0.0, 10.0, 5.0)));
/// # Ok::<(), ombra_clip::box3::Box3Error>(())
/// ```
///
/// # References
///
/// Grafica 3, «Clipping»: the hexahedron.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Box3 {
    /// The corner with the least coordinates.
    pub min: DVec3,
    /// The corner with the greatest coordinates.
    pub max: DVec3,
}

/// Why two corners are no box.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Box3Error {
    /// A coordinate is NaN or infinite.
    NotFinite {
        /// The corner with that coordinate.
        corner: DVec3,
    },
    /// A coordinate of the first corner exceeds the second's.
    Swapped {
        /// The corner given as the least.
        min: DVec3,
        /// The corner given as the greatest.
        max: DVec3,
    },
}

impl fmt::Display for Box3Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotFinite { corner } => {
                write!(
                    f,
                    "box corner {corner}: all coordinates must be finite numbers"
                )
            }
            Self::Swapped { min, max } => write!(
                f,
                "box from {min} to {max}: no coordinate of the first corner may exceed the second's"
            ),
        }
    }
}

impl core::error::Error for Box3Error {}

impl Box3 {
    /// The box with the corners `min` and `max`.
    ///
    /// # Errors
    ///
    /// A coordinate that is not finite, or one of `min` that exceeds that of `max`.
    pub fn new(min: DVec3, max: DVec3) -> Result<Self, Box3Error> {
        for corner in [min, max] {
            if !corner.is_finite() {
                return Err(Box3Error::NotFinite { corner });
            }
        }
        if min.cmple(max).all() {
            Ok(Self { min, max })
        } else {
            Err(Box3Error::Swapped { min, max })
        }
    }

    /// Whether `p` lies in the box: six inequalities, the border inside, NaN outside.
    #[must_use]
    pub fn contains(&self, p: DVec3) -> bool {
        self.min.cmple(p).all() && p.cmple(self.max).all()
    }
}

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

/// The part of a segment in the box, or `None` if there is none.
///
/// # Formula
///
/// ```text
/// OR = 000000: inside      AND ≠ 000000: outside
/// otherwise from the latest entry to the earliest exit, t = (x_side − x_a) / (x_b − x_a)
/// ```
///
/// # Properties
///
/// As in the plane: ends inside are unchanged, others lie in the box exactly, at the nearest doubles to the true
/// crossings; clipping twice changes nothing, direction is kept, coordinates may be of any size. Two t's are compared
/// exactly: which of two axes is passed first is a question in the plane of both. `None` if an end is not finite.
///
/// # Examples
///
/// ```
/// use ombra_clip::box3::{Box3, clip_segment};
/// use ombra_math::glam::DVec3;
///
/// let cube = Box3::new(DVec3::ZERO, DVec3::splat(10.0))?;
/// let diagonal = [DVec3::splat(-5.0), DVec3::new(15.0, 15.0, 5.0)];
/// let inside = [DVec3::new(5.0, 5.0, 0.0), DVec3::new(10.0, 10.0, 2.5)];
/// assert_eq!(clip_segment(&cube, diagonal), Some(inside));
/// # Ok::<(), ombra_clip::box3::Box3Error>(())
/// ```
///
/// # References
///
/// Grafica 3, «Clipping» and «Algoritmo Cohen-Sutherland».
#[must_use]
pub fn clip_segment(bounds: &Box3, segment: [DVec3; 2]) -> Option<[DVec3; 2]> {
    clip_segment_counted(bounds, segment, &mut ())
}

/// [`clip_segment`], counting its [work](crate#counted-work).
#[must_use]
pub fn clip_segment_counted(
    bounds: &Box3,
    [a, b]: [DVec3; 2],
    work: &mut impl Count,
) -> Option<[DVec3; 2]> {
    work.add(Counter::Comparisons, 12);
    let codes = [outcode(bounds, a), outcode(bounds, b)];
    let finite = a.is_finite() && b.is_finite() && bounds.min.cmple(bounds.max).all();
    if !finite || !(codes[0] & codes[1]).is_inside() {
        return None;
    }
    if (codes[0] | codes[1]).is_inside() {
        return Some([a, b]);
    }
    let entry = last_side(bounds, [a, b], work);
    let exit = last_side(bounds, [b, a], work);
    if let (Some(entry), Some(exit)) = (entry, exit)
        && first_met([a, b], entry, exit, work) == Ordering::Greater
    {
        return None;
    }
    let mut cut = |(axis, c): Side| {
        work.add(Counter::Divisions, 1);
        let coordinate = |k: usize| {
            if k == axis {
                c + 0.0
            } else {
                at(c, [a[axis], b[axis]], [a[k], b[k]])
            }
        };
        DVec3::new(coordinate(0), coordinate(1), coordinate(2))
    };
    Some([entry.map_or(a, &mut cut), exit.map_or(b, &mut cut)])
}

/// An axis and where on it the side stands.
type Side = (usize, f64);

/// Of the sides that the first end lies beyond, the one passed last on the way in.
fn last_side(bounds: &Box3, [a, b]: [DVec3; 2], work: &mut impl Count) -> Option<Side> {
    let mut last: Option<Side> = None;
    for axis in 0..3 {
        work.add(Counter::Comparisons, 2);
        let side = if a[axis] > bounds.max[axis] {
            (axis, bounds.max[axis])
        } else if a[axis] < bounds.min[axis] {
            (axis, bounds.min[axis])
        } else {
            continue;
        };
        if last.is_none_or(|best| first_met([a, b], side, best, work) == Ordering::Greater) {
            last = Some(side);
        }
    }
    last
}

/// Which of two sides is met first from a to b: seen along the third axis, a question in the plane.
fn first_met([a, b]: [DVec3; 2], (i, c): Side, (j, k): Side, work: &mut impl Count) -> Ordering {
    if i == j {
        let flat = Segment::new(DVec2::new(a[i], 0.0), DVec2::new(b[i], 0.0));
        return order(flat, Line::Vertical(c), Line::Vertical(k), work);
    }
    let flat = Segment::new(DVec2::new(a[i], a[j]), DVec2::new(b[i], b[j]));
    order(flat, Line::Vertical(c), Line::Horizontal(k), work)
}

#[cfg(test)]
mod tests;
