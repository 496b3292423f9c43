//! A polygon as seen from an eye, made ready for many comparisons.

use core::cmp::Ordering;

use ombra_math::glam::{DVec3, DVec4};
use ombra_math::predicates::orient_3d;

use super::bound::Bound;
use super::eye::Eye;
use super::outline::convex_from;
use super::{CutPlane, Depths, tolerance};
use crate::polygon::Polygon;

/// A polygon as seen from an eye: what comparing and cutting ask for again and again.
///
/// # Formula
///
/// ```text
/// seen through it:  X with πᵢ·X ≥ 0, all i
///                   πᵢ: plane of the eye and the edge Vᵢ Vᵢ₊₁, its front inside
/// hidden by it:     of these, X with π·X < 0     π: its own plane, its front towards the eye
/// ```
///
/// # Properties
///
/// A polygon is seen from both its sides. Made once for each polygon, it lets pairs that are far apart be told by one
/// comparison of two round cones.
///
/// # Examples
///
/// ```
/// use ombra_hsr::pair::Seen;
/// use ombra_hsr::polygon::Polygon;
/// use ombra_math::glam::{DVec3, DVec4};
///
/// let triangle = Polygon::new(vec![DVec3::ZERO, DVec3::X, DVec3::Y]).unwrap();
/// let seen = Seen::new(&triangle, DVec4::Z).unwrap();
/// let below = DVec3::new(0.25, 0.25, -3.0);
/// assert!(seen.sides().all(|side| side.distance(below) > 0.0) && seen.front().distance(below) == -3.0);
/// assert!(Seen::new(&triangle, DVec4::X).is_none()); // edge-on
/// ```
///
/// # References
///
/// Grafica 3, «Approccio Object-Space»: the step «proiettare», without a projection.
#[derive(Clone, Debug)]
pub struct Seen {
    pub(super) eye: Eye,
    /// Counter-clockwise as seen; those where the outline does not turn left are left out.
    pub(super) vertices: Vec<DVec3>,
    /// Three of them that span the plane, in that order.
    span: [DVec3; 3],
    pub(super) scale: f64,
    pub(super) bound: Bound,
    front: CutPlane,
    pub(super) edges: Vec<Edge>,
}

/// An edge and the plane through it and the eye.
#[derive(Clone, Copy, Debug)]
pub(super) struct Edge {
    pub(super) ends: [DVec3; 2],
    inside: CutPlane,
}

/// The sine of an angle of a degree.
const ONE_DEGREE: f64 = 0.017_45;

impl Seen {
    /// `polygon` as seen from `eye`, or `None` where it is not: its plane holds the eye, it is no polygon, or that is
    /// no eye (0, NaN, ∞, a place beyond the largest double).
    #[must_use]
    pub fn new(polygon: &Polygon, eye: DVec4) -> Option<Self> {
        Self::from_eye(polygon, Eye::new(eye)?)
    }

    /// A part of it as seen from the same eye, or `None` where that has no area.
    pub(crate) fn part(&self, vertices: Vec<DVec3>) -> Option<Self> {
        Self::from_eye(&Polygon { vertices }, self.eye)
    }

    fn from_eye(polygon: &Polygon, eye: Eye) -> Option<Self> {
        let (mut span, mut plane) = polygon.span_and_plane()?;
        let [a, b, c] = span;
        let mut vertices = polygon.vertices.clone();
        match eye.turn(a, b, c)? {
            Ordering::Greater => {}
            Ordering::Less => {
                vertices.reverse();
                span.reverse();
                plane = plane.turned();
            }
            Ordering::Equal => return None,
        }
        let vertices = convex_from(vertices, eye, Ordering::Greater);
        let next = vertices.iter().cycle().skip(1);
        let edges = vertices.iter().zip(next).filter_map(|(&a, &b)| {
            Some(Edge {
                ends: [a, b],
                inside: CutPlane::of(eye.plane_through(a, b)?)?,
            })
        });
        let scale = polygon.scale();
        Some(Self {
            eye,
            edges: edges.collect(),
            span,
            scale,
            bound: Bound::new(eye, &vertices, scale),
            front: CutPlane::of(plane)?,
            vertices,
        })
    }

    /// The largest coordinate of a vertex, without its sign.
    ///
    /// # Properties
    ///
    /// - Error: 0
    #[must_use]
    pub fn scale(&self) -> f64 {
        self.scale
    }

    /// Its plane, the front towards the eye.
    #[must_use]
    pub fn front(&self) -> CutPlane {
        self.front
    }

    /// The planes through the eye and its edges, their fronts inside.
    pub fn sides(&self) -> impl Iterator<Item = CutPlane> {
        self.edges.iter().map(|edge| edge.inside)
    }

    /// The plane through the eye and the line in which the two planes cross, its front where this one is nearer.
    ///
    /// ```text
    /// Σ = π(E) π' − π'(E) π
    /// E: the eye, homogeneous     π, π': the planes, their fronts towards E
    /// ```
    ///
    /// On π it has the sign of π', on π' the opposite one of π. `None` where the planes are parallel.
    pub(crate) fn nearer_side(&self, other: &Self) -> Option<CutPlane> {
        CutPlane::of(
            self.eye
                .plane_of_pencil(self.front.plane(), other.front.plane())?,
        )
    }

    /// Whether the two are sheets that nearly lie in each other: their planes at an angle below 1°, and neither of
    /// them wholly on one side of the other's plane by more than what counts as equally deep.
    ///
    /// Who is nearer is then a matter of rounding. At a larger angle it is so along the line in which they cross only.
    pub(crate) fn clings_to(&self, other: &Self) -> bool {
        if self.front.sine(&other.front) > ONE_DEGREE {
            return false;
        }
        let slack = self.warp() + other.warp() + tolerance(self.scale.max(other.scale));
        let clear = |of: &Self, from: CutPlane| {
            let distances = || of.vertices.iter().map(|&v| from.distance(v));
            distances().all(|d| d > slack) || distances().all(|d| d < -slack)
        };
        !clear(self, other.front) && !clear(other, self.front)
    }

    /// How far vertices lie off the plane.
    fn warp(&self) -> f64 {
        let distances = self.vertices.iter().map(|&v| self.front.distance(v).abs());
        distances.fold(0.0, f64::max)
    }

    /// Where the vertices of `other` lie from this plane.
    pub(super) fn depths_of(&self, other: &Self) -> Depths {
        let tolerance = tolerance(self.scale.max(other.scale));
        let mut depths = Depths::default();
        for &v in &other.vertices {
            depths.add(self.nearness(v, tolerance));
        }
        depths
    }

    /// Whether `other` is, for certain, on the same side of the plane through `eye` that is parallel to this polygon.
    pub(super) fn is_ahead(&self, eye: DVec3, other: &Self) -> bool {
        let scale = self.scale.max(other.scale).max(eye.abs().max_element());
        let bound = 2.0 * tolerance(scale);
        let from = self.front.distance(eye);
        let mut vertices = other.vertices.iter();
        vertices.all(|&v| self.front.distance(v) - from < -bound)
    }

    /// Whether `v` is nearer to the eye than this plane along its sight line (`Greater`), or farther.
    pub(super) fn nearness(&self, v: DVec3, tolerance: f64) -> Ordering {
        if self.front.distance(v).abs() <= tolerance {
            return Ordering::Equal;
        }
        let [a, b, c] = self.span;
        orient_3d(a, b, c, v).unwrap_or(Ordering::Equal)
    }

    /// Whether `v` lies inside the cone or on its border.
    pub(super) fn covers(&self, v: DVec3) -> bool {
        self.edges
            .iter()
            .all(|edge| self.turn(edge, v) != Ordering::Less)
    }

    /// Whether all of `other` lies on or outside the plane through one edge.
    pub(super) fn has_side_before(&self, other: &Self) -> bool {
        let outside = |edge: &Edge, v: &DVec3| self.turn(edge, *v) != Ordering::Greater;
        self.edges
            .iter()
            .any(|edge| other.vertices.iter().all(|v| outside(edge, v)))
    }

    /// How `v` lies from an edge as seen: inside (`Greater`), in line, or outside. Exact.
    pub(super) fn turn(&self, edge: &Edge, v: DVec3) -> Ordering {
        let bound = tolerance(self.scale.max(v.abs().max_element()));
        let distance = edge.inside.distance(v);
        if distance > bound {
            Ordering::Greater
        } else if distance < -bound {
            Ordering::Less
        } else {
            let [a, b] = edge.ends;
            if self.eye.sees_as_one(v, a) || self.eye.sees_as_one(v, b) {
                return Ordering::Equal;
            }
            self.eye.turn(a, b, v).unwrap_or(Ordering::Equal)
        }
    }
}
