//! Where a primitive lies as seen from the eye, as a box: primitives whose boxes are apart need no comparison.

use ombra_math::glam::{DVec3, DVec4};
use ombra_math::scaling::normalised;

use crate::pair::Eye;
use crate::polygon::Polygon;

/// What distances and directions are measured from.
#[derive(Clone, Copy, Debug)]
pub(super) enum View {
    /// A place.
    Place(DVec3),
    /// A parallel view: unit vectors to the viewer and across.
    Parallel { towards: DVec3, across: [DVec3; 2] },
    /// No eye: nothing is seen.
    Nowhere,
}

/// Bounds of what a primitive covers of the view and of its distance, wide enough for every rounding.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Extent {
    /// From a place: the unit directions towards the primitive. In a parallel view: coordinates across it, then 0.
    pub(super) min: DVec3,
    pub(super) max: DVec3,
    pub(super) nearest: f64,
    pub(super) farthest: f64,
    /// The distance that is sorted by: that of the farthest vertex.
    pub(super) distance: f64,
}

/// Widens depths, as a share of the coordinates: much more than rounding, as equal depths are a matter of rounding too.
const DEPTH_SLACK: f64 = 1.0 / (1u64 << 32) as f64;

/// Widens directions and coordinates across the view: a dozen roundings.
const SLACK: f64 = 32.0 * f64::EPSILON;

impl Extent {
    pub(super) const EVERYWHERE: Self = Self {
        min: DVec3::NEG_INFINITY,
        max: DVec3::INFINITY,
        nearest: f64::NEG_INFINITY,
        farthest: f64::INFINITY,
        distance: f64::INFINITY,
    };

    /// Whether the two may share a sight line.
    pub(super) fn overlaps(&self, other: &Self) -> bool {
        self.min.cmple(other.max).all() && other.min.cmple(self.max).all()
    }

    /// The box round both.
    pub(super) fn union(&self, other: &Self) -> Self {
        Self {
            min: self.min.min(other.min),
            max: self.max.max(other.max),
            nearest: self.nearest.min(other.nearest),
            farthest: self.farthest.max(other.farthest),
            distance: self.distance.max(other.distance),
        }
    }
}

impl View {
    pub(super) fn of(eye: DVec4) -> Self {
        match Eye::new(eye) {
            None => Self::Nowhere,
            Some(Eye::Place(at)) => Self::Place(at),
            Some(Eye::Towards(towards)) => {
                let towards = unit(towards);
                let across = towards.any_orthonormal_pair().into();
                Self::Parallel { towards, across }
            }
        }
    }

    /// The extent of a primitive, or `None` for one that is not seen: no eye, too few vertices, not finite.
    pub(super) fn extent(&self, polygon: &Polygon) -> Option<Extent> {
        let vertices = &polygon.vertices;
        if vertices.len() < 3 || !vertices.iter().all(|v| v.is_finite()) {
            return None;
        }
        match *self {
            Self::Place(at) => Some(seen_from(at, vertices)),
            Self::Parallel { towards, across } => Some(seen_along(towards, across, vertices)),
            Self::Nowhere => None,
        }
    }

    /// The distance that is sorted by, infinite for a primitive that has none.
    pub(super) fn distance(&self, polygon: &Polygon) -> f64 {
        self.extent(polygon).map_or(f64::INFINITY, |e| e.distance)
    }
}

/// From a place.
fn seen_from(at: DVec3, vertices: &[DVec3]) -> Extent {
    let (mut low, mut high) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    let mut mean = DVec3::ZERO;
    let mut distance = 0.0f64;
    let (mut corner, mut opposite) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    for &v in vertices {
        let direction = unit(away(at, v));
        (low, high) = (low.min(direction), high.max(direction));
        (corner, opposite) = (corner.min(v), opposite.max(v));
        mean += direction;
        distance = distance.max(distance_between(at, v));
    }
    // A direction of the inside is a mean of those to the vertices, made a unit vector again: divided by a length
    // that is at least the mean's part along any one axis.
    let axis = unit(mean);
    let shortest = vertices
        .iter()
        .map(|&v| unit(away(at, v)).dot(axis))
        .fold(1.0, f64::min);
    let size = at.abs().max(corner.abs()).max(opposite.abs()).max_element();
    let depth_slack = DEPTH_SLACK * size;
    let nearest = distance_between(at, at.max(corner).min(opposite)).min(f64::MAX);
    let (min, max) = if shortest > 1e-3 {
        let grown = |x: DVec3| (x / shortest).max(x) + SLACK / shortest;
        (-grown(-low), grown(high))
    } else {
        // A vertex at the eye, or nearly half the view.
        (DVec3::NEG_INFINITY, DVec3::INFINITY)
    };
    Extent {
        min,
        max,
        nearest: nearest - depth_slack,
        farthest: distance + depth_slack,
        distance,
    }
}

/// In a parallel view.
fn seen_along(towards: DVec3, across: [DVec3; 2], vertices: &[DVec3]) -> Extent {
    let (mut low, mut high) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    let mut size = 0.0f64;
    for v in vertices {
        let [x, y] = across.map(|axis| axis.dot(*v));
        let seen = DVec3::new(x, y, -towards.dot(*v));
        (low, high) = (low.min(seen), high.max(seen));
        size = size.max(v.abs().max_element());
    }
    let slack = SLACK * size + f64::MIN_POSITIVE;
    let depth_slack = DEPTH_SLACK * size;
    if !(low.is_finite() && high.is_finite()) {
        // A product overflowed.
        return Extent::EVERYWHERE;
    }
    Extent {
        min: low.with_z(0.0) - slack,
        max: high.with_z(0.0) + slack,
        nearest: low.z - depth_slack,
        farthest: high.z + depth_slack,
        distance: high.z,
    }
}

/// ‖v − at‖, infinite beyond the largest double.
fn distance_between(at: DVec3, v: DVec3) -> f64 {
    let d = v - at;
    if d.is_finite() {
        length(d)
    } else {
        2.0 * length(away(at, v))
    }
}

/// From `at` to `v`, or half of it where the difference overflows.
fn away(at: DVec3, v: DVec3) -> DVec3 {
    let d = v - at;
    if d.is_finite() { d } else { v * 0.5 - at * 0.5 }
}

/// The unit vector along `v` at every exponent; zero of zero.
fn unit(v: DVec3) -> DVec3 {
    let largest = v.abs().max_element();
    if largest == 0.0 {
        return DVec3::ZERO;
    }
    (v / largest).normalize_or_zero()
}

/// ‖v‖ at every exponent, the same for all orders and signs of the coordinates.
fn length(v: DVec3) -> f64 {
    let (shares, exponent) = normalised(v.to_array());
    let mut squares = shares.map(|x| x * x);
    squares.sort_by(f64::total_cmp);
    libm::scalbn(squares.iter().sum::<f64>().sqrt(), exponent)
}
