//! A segment against an upright box: Cohen–Sutherland's codes with six bits, and three strips instead of two.

use core::cmp::Ordering;

use ombra_math::glam::{DVec2, DVec3};
use ombra_math::work::{Count, Counter};

use crate::cohen_sutherland;
use crate::crossing::{at, compare};
use crate::segment::Segment;
use crate::window::{CornersError, Line};

mod fast;

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

/// [`clip_segment`] by the iterations of Cohen and Sutherland, with six bits, counting its [work](crate#counted-work).
///
/// # Properties
///
/// - The same result, bit for bit.
/// - Error: none: each coordinate is the double nearest to the exact one.
///
/// # References
///
/// As for [`clip_segment`].
#[must_use]
pub fn clip_segment_plain(
    bounds: &Box3,
    given: [DVec3; 2],
    work: &mut impl Count,
) -> Option<[DVec3; 2]> {
    let [mut a, mut b] = given;
    if !a.is_finite() || !b.is_finite() || bounds.is_empty() {
        return None;
    }
    let mut codes = [outcode(bounds, a), outcode(bounds, b)];
    work.add(Counter::Comparisons, 12);
    loop {
        // OR = 000000: both ends inside. AND ≠ 000000: both beyond one face.
        if (codes[0] | codes[1]).is_inside() {
            return Some([a, b]);
        }
        if !(codes[0] & codes[1]).is_inside() {
            return None;
        }
        // Cut at the first face whose bits differ, then test both again.
        let differs = |&face: &Face| codes[0].has(face) != codes[1].has(face);
        let face = Face::ALL.into_iter().find(differs)?;
        let (p, code) = crossing(bounds, given, face);
        work.add(Counter::Divisions, 1);
        work.add(Counter::Comparisons, 4);
        // The crossing replaces the end with the bit 1.
        if codes[0].has(face) {
            (a, codes[0]) = (p, code);
        } else {
            (b, codes[1]) = (p, code);
        }
    }
}

/// Where the segment as given crosses a face, and the code of that point: of the true one, of which the point is the
/// nearest double.
fn crossing(bounds: &Box3, given: [DVec3; 2], face: Face) -> (DVec3, Outcode) {
    let (axis, limit) = face.place(bounds);
    let (p, line) = (cut(given, (axis, limit)), Line::Vertical(limit));
    let mut code = Outcode::default();
    for other in Face::ALL {
        let (along, limit) = other.place(bounds);
        if along == axis {
            continue;
        }
        let beyond = match other {
            Face::Above | Face::Right | Face::InFront => Ordering::Greater,
            Face::Below | Face::Left | Face::Behind => Ordering::Less,
        };
        if compare(seen(given, axis, along), line, p[along], limit) == beyond {
            code = code | Outcode::of(other);
        }
    }
    (p, code)
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
/// - Error: none: each coordinate is the double nearest to the exact one.
/// - As in the plane: ends inside are unchanged, others lie in the box exactly; clipping twice changes nothing, direction
///   is kept, coordinates may be of any size.
/// - Two t's are compared exactly: which of two axes is passed first is a question in the plane of both.
/// - `None` if an end is not finite.
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
    fast::clip_segment(bounds, segment, &mut ())
}

/// Each gives the same answer as the function of its name and counts its [work](crate#counted-work), which comes last.
pub mod counted {
    pub use super::fast::clip_segment;
}

/// Why two corners are no box.
pub type Box3Error = CornersError<DVec3>;

impl Box3 {
    /// The box with the corners `min` and `max`.
    ///
    /// # Errors
    ///
    /// A coordinate that is not finite, or one of `min` that exceeds that of `max`.
    pub fn new(min: DVec3, max: DVec3) -> Result<Self, Box3Error> {
        match [min, max].into_iter().find(|p| !p.is_finite()) {
            Some(corner) => Err(Box3Error::NotFinite { corner }),
            None if min.cmple(max).all() => Ok(Self { min, max }),
            None => Err(Box3Error::Swapped { min, max }),
        }
    }

    /// Whether `p` lies in the box: six inequalities, the border inside, NaN outside.
    #[must_use]
    pub fn contains(&self, p: DVec3) -> bool {
        self.min.cmple(p).all() && p.cmple(self.max).all()
    }

    /// Whether no point lies in the box.
    fn is_empty(&self) -> bool {
        !self.min.cmple(self.max).all()
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
/// eyes that look along −z. Displayed, `100101` is above, to the left and behind.
///
/// # References
///
/// Grafica 3, «Algoritmo Cohen-Sutherland» and «Clipping».
pub type Outcode = cohen_sutherland::Outcode<6>;

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
    cohen_sutherland::Outcode(axis(1) << 4 | axis(0) << 2 | axis(2))
}

/// An axis, and where on it.
type Place = (usize, f64);

/// A face of a box, in the order of the bits.
#[derive(Clone, Copy)]
enum Face {
    Above,
    Below,
    Right,
    Left,
    InFront,
    Behind,
}

impl Face {
    const ALL: [Self; 6] = [
        Self::Above,
        Self::Below,
        Self::Right,
        Self::Left,
        Self::InFront,
        Self::Behind,
    ];

    /// The axis across it, and where on that it stands.
    #[inline]
    const fn place(self, bounds: &Box3) -> Place {
        match self {
            Self::Above => (1, bounds.max.y),
            Self::Below => (1, bounds.min.y),
            Self::Right => (0, bounds.max.x),
            Self::Left => (0, bounds.min.x),
            Self::InFront => (2, bounds.max.z),
            Self::Behind => (2, bounds.min.z),
        }
    }
}

impl Outcode {
    /// The code with the one bit of a face.
    const fn of(face: Face) -> Self {
        Self(1 << (5 - face as u8))
    }

    /// Whether the bit of a face is 1.
    const fn has(self, face: Face) -> bool {
        self.0 & Self::of(face).0 != 0
    }
}

/// Where a segment with its ends on either side of a face crosses it.
#[inline]
fn cut([a, b]: [DVec3; 2], (axis, limit): Place) -> DVec3 {
    let across = [a[axis], b[axis]];
    DVec3::from_array([0, 1, 2].map(|k| match k == axis {
        true => limit + 0.0,
        false => at(limit, across, [a[k], b[k]]),
    }))
}

/// A segment as seen along a third axis.
fn seen([a, b]: [DVec3; 2], across: usize, along: usize) -> Segment {
    let flat = |p: DVec3| DVec2::new(p[across], p[along]);
    Segment::new(flat(a), flat(b))
}

#[cfg(test)]
mod tests;
