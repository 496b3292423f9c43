//! A segment against an upright box: Cohen–Sutherland's codes with six bits, and three strips instead of two.

use core::cmp::Ordering;

use ombra_math::glam::{DVec2, DVec3};
use ombra_math::work::{Count, Counter};

use crate::crossing::{at, compare};
use crate::segment::Segment;
use crate::window::Line;

mod error;
mod fast;
mod outcode;

pub use error::Box3Error;
pub use outcode::{Outcode, outcode};

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
    let (axis, limit) = (face.axis(), face.limit(bounds));
    let (p, line) = (cut(given, axis, limit), Line::Vertical(limit));
    let mut code = Outcode::default();
    for other in Face::ALL.into_iter().filter(|other| other.axis() != axis) {
        let flat = seen(given, axis, other.axis());
        let (along, limit) = (p[other.axis()], other.limit(bounds));
        let beyond = match other {
            Face::Above | Face::Right | Face::InFront => Ordering::Greater,
            Face::Below | Face::Left | Face::Behind => Ordering::Less,
        };
        if compare(flat, line, along, limit) == beyond {
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

    /// Whether no point lies in the box.
    fn is_empty(&self) -> bool {
        !self.min.cmple(self.max).all()
    }
}

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

    /// Which coordinate is the same all over it.
    #[inline]
    const fn axis(self) -> usize {
        match self {
            Self::Right | Self::Left => 0,
            Self::Above | Self::Below => 1,
            Self::InFront | Self::Behind => 2,
        }
    }

    /// What that coordinate is.
    #[inline]
    fn limit(self, bounds: &Box3) -> f64 {
        match self {
            Self::Above | Self::Right | Self::InFront => bounds.max[self.axis()],
            Self::Below | Self::Left | Self::Behind => bounds.min[self.axis()],
        }
    }
}

/// Where a segment with its ends on either side of a face crosses it.
#[inline]
fn cut([a, b]: [DVec3; 2], axis: usize, limit: f64) -> DVec3 {
    let coordinate = |k: usize| {
        if k == axis {
            limit + 0.0
        } else {
            at(limit, [a[axis], b[axis]], [a[k], b[k]])
        }
    };
    DVec3::new(coordinate(0), coordinate(1), coordinate(2))
}

/// A segment as seen along a third axis.
fn seen([a, b]: [DVec3; 2], across: usize, along: usize) -> Segment {
    let flat = |p: DVec3| DVec2::new(p[across], p[along]);
    Segment::new(flat(a), flat(b))
}

#[cfg(test)]
mod tests;
