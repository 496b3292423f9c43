//! A planar convex polygon in space: the primitive of the lecture.
//!
//! The object-space methods ask on which side of a plane a vertex lies and cut polygons at planes. Both are simple
//! because the primitives are planar and convex; so that is checked once, when a polygon is made.

use core::fmt;

use ombra_math::glam::DVec3;
use ombra_math::plane::Plane;
use ombra_math::scaling::{scaled, split};

/// A planar convex polygon in space; its vertices run round it, seen counter-clockwise from its front.
///
/// # Properties
///
/// [`Polygon::new`] checks. The field is public, so every method and function is total as well: a polygon that is
/// none gets some answer, and never a panic.
///
/// # Examples
///
/// ```
/// use ombra_hsr::polygon::{Polygon, PolygonError};
/// use ombra_math::glam::DVec3;
///
/// let square = vec![DVec3::ZERO, DVec3::X, DVec3::X + DVec3::Y, DVec3::Y];
/// let polygon = Polygon::new(square.clone()).unwrap();
/// assert_eq!(polygon.plane().unwrap().normal, DVec3::Z);
/// assert_eq!(polygon.area(), 1.0);
///
/// let bent = [&square[..3], &[DVec3::Y + 0.5 * DVec3::Z]].concat();
/// assert!(matches!(Polygon::new(bent), Err(PolygonError::NotPlanar { .. })));
/// ```
///
/// # References
///
/// Grafica 3, «Approccio Object-Space»: k planar and opaque primitives.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Polygon {
    /// The vertices, in order.
    pub vertices: Vec<DVec3>,
}

/// Why vertices make no polygon.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PolygonError {
    /// Fewer than three.
    TooFew {
        /// How many there are.
        vertices: usize,
    },
    /// A vertex is NaN or infinite.
    Position {
        /// Which one.
        vertex: usize,
        /// Where it is.
        position: DVec3,
    },
    /// All on one line, or at one place.
    Collinear,
    /// A vertex away from the plane of the others.
    NotPlanar {
        /// Which one.
        vertex: usize,
        /// How far.
        distance: f64,
        /// How far it may be.
        allowed: f64,
    },
    /// A corner turned inwards, or more than one turn round.
    NotConvex {
        /// The corner.
        vertex: usize,
    },
    /// A tolerance that is negative or NaN.
    Tolerance {
        /// Its value.
        tolerance: f64,
    },
}

impl fmt::Display for PolygonError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooFew { vertices } => {
                write!(f, "a polygon needs three vertices at least, not {vertices}")
            }
            Self::Position { vertex, position } => write!(
                f,
                "vertex {vertex} is at {position}; its coordinates must be finite numbers"
            ),
            Self::Collinear => write!(f, "the vertices lie on one line; a polygon needs a plane"),
            Self::NotPlanar {
                vertex,
                distance,
                allowed,
            } => write!(
                f,
                "vertex {vertex} is {distance:e} away from the plane of the others; at most {allowed:e} is allowed"
            ),
            Self::NotConvex { vertex } => write!(
                f,
                "the polygon is not convex at vertex {vertex}; cut it into convex ones"
            ),
            Self::Tolerance { tolerance } => {
                write!(f, "the tolerance must be 0 or more, not {tolerance}")
            }
        }
    }
}

impl core::error::Error for PolygonError {}

impl Polygon {
    /// How far, as a share of the largest coordinate, a vertex may be from the plane or inside a straight edge: 2⁻⁴⁰,
    /// about 10⁻¹². That is 4096 times the rounding of coordinates.
    pub const TOLERANCE: f64 = 1.0 / (1u64 << 40) as f64;

    /// A polygon of these vertices, checked with [`Polygon::TOLERANCE`].
    ///
    /// # Properties
    ///
    /// Repeated vertices and straight corners are allowed. That the vertices have a plane is decided exactly; of three
    /// vertices no more is asked.
    ///
    /// # Errors
    ///
    /// See [`PolygonError`].
    pub fn new(vertices: Vec<DVec3>) -> Result<Self, PolygonError> {
        Self::with_tolerance(vertices, Self::TOLERANCE)
    }

    /// A polygon of these vertices, planar and convex within `tolerance` times the largest coordinate.
    ///
    /// # Properties
    ///
    /// The plane is that of [`Polygon::span`]. A corner turned inwards is measured by its distance from the line
    /// between its neighbours.
    ///
    /// # Errors
    ///
    /// See [`PolygonError`].
    pub fn with_tolerance(vertices: Vec<DVec3>, tolerance: f64) -> Result<Self, PolygonError> {
        if tolerance.is_nan() || tolerance < 0.0 {
            return Err(PolygonError::Tolerance { tolerance });
        }
        let polygon = Self { vertices };
        polygon.check(tolerance)?;
        Ok(polygon)
    }

    /// Three of its vertices, in order, that span its plane well: the one farthest from the first, and the one
    /// farthest from the line through both.
    ///
    /// # Properties
    ///
    /// Vertices of more than three are seldom on one plane exactly. What asks for the plane of a polygon takes these
    /// three, so that there is one answer.
    ///
    /// - Error: none: they are vertices
    ///
    /// # Errors
    ///
    /// `None` where they are on one line, which is decided exactly, or a coordinate is not finite.
    ///
    /// # Examples
    ///
    /// ```
    /// use ombra_hsr::polygon::Polygon;
    /// use ombra_math::glam::DVec3;
    ///
    /// // The first three vertices are on one line.
    /// let [a, b, c, d] = [DVec3::ZERO, DVec3::X, 2.0 * DVec3::X, DVec3::Y];
    /// let polygon = Polygon::new(vec![a, b, c, d]).unwrap();
    /// assert_eq!(polygon.span(), Some([a, c, d]));
    /// ```
    #[must_use]
    pub fn span(&self) -> Option<[DVec3; 3]> {
        self.span_and_plane().map(|(span, _)| span)
    }

    /// Its plane, the normal towards the side from which the vertices run counter-clockwise; `None` as for
    /// [`Polygon::span`].
    ///
    /// # Formula
    ///
    /// ```text
    /// n = AB × AC          d = −n·A          A, B, C: the span
    /// ```
    ///
    /// # Properties
    ///
    /// - Error: none for the three: each is the nearest double, times a power of two common to all
    ///
    /// # References
    ///
    /// Olomouc, «Flat shading», first example.
    #[must_use]
    pub fn plane(&self) -> Option<Plane> {
        self.span_and_plane().map(|(_, plane)| plane)
    }

    /// The span with its plane.
    pub(crate) fn span_and_plane(&self) -> Option<([DVec3; 3], Plane)> {
        if !self.vertices.iter().all(|v| v.is_finite()) {
            return None;
        }
        let away = self.relative_to_first();
        let elsewhere = || {
            self.vertices
                .iter()
                .position(|v| Some(v) != self.vertices.first())
        };
        let farthest = largest(away.iter().map(|v| v.length_squared())).or_else(elsewhere)?;
        let line = *away.get(farthest)?;
        let third = largest(away.iter().map(|v| v.cross(line).length_squared()));
        let through = |third: usize| {
            let mut span = [0, farthest, third];
            span.sort_unstable();
            let [a, b, c] = span;
            let span = [
                *self.vertices.get(a)?,
                *self.vertices.get(b)?,
                *self.vertices.get(c)?,
            ];
            Some((span, Plane::of_triangle(span[0], span[1], span[2])?))
        };
        // Rounding may make a vertex on the line look the farthest from it, and lose one beside it.
        third
            .and_then(through)
            .or_else(|| (1..away.len()).find_map(through))
    }

    /// The vertices as seen from the first, all by one power of two of a size at which products stay in range.
    fn relative_to_first(&self) -> Vec<DVec3> {
        let Some(&first) = self.vertices.first() else {
            return Vec::new();
        };
        // Halves of large ones, so that no difference overflows.
        let share = if self.scale() > 1.0 { 0.5 } else { 1.0 };
        let away = |&v: &DVec3| share * v - share * first;
        let size = |v: DVec3| v.abs().max_element();
        let extent = self.vertices.iter().map(|v| size(away(v)));
        let extent = extent.fold(0.0, f64::max);
        let exponent = split(extent).1;
        let all = self.vertices.iter().map(away);
        all.map(|v| scaled(v.to_array(), -exponent).into())
            .collect()
    }

    /// The largest coordinate, without its sign; 0 for no vertices.
    pub(crate) fn scale(&self) -> f64 {
        let sizes = self.vertices.iter().map(|v| v.abs().max_element());
        sizes.fold(0.0, f64::max)
    }

    /// Its area: 0 for fewer than three vertices, NaN or ∞ where a coordinate is.
    ///
    /// # Formula
    ///
    /// ```text
    /// A = ½ ‖Σ (Vᵢ − V₀) × (Vᵢ₊₁ − V₀)‖
    /// ```
    ///
    /// # Properties
    ///
    /// - Error: 8 n ε · M², n vertices, M the largest coordinate
    /// - 0 or ∞ where no double holds it.
    #[must_use]
    pub fn area(&self) -> f64 {
        let twice: DVec3 = self.fan().map(|(_, cross)| cross).sum();
        libm::scalbn(twice.length() / 2.0, 2 * self.exponent())
    }

    /// The centre of its area, or `None` where it has none, or a coordinate is not finite.
    ///
    /// # Formula
    ///
    /// ```text
    /// G = Σ Aᵢ Gᵢ / Σ Aᵢ          Aᵢ, Gᵢ: area and centre of the triangle V₀ Vᵢ Vᵢ₊₁
    /// ```
    ///
    /// # Properties
    ///
    /// - Error: 16 n ε · M³/A + the smallest double, n vertices, M the largest coordinate, A the area
    ///
    /// # Examples
    ///
    /// ```
    /// use ombra_hsr::polygon::Polygon;
    /// use ombra_math::glam::DVec3;
    ///
    /// let triangle = Polygon::new(vec![DVec3::ZERO, 3.0 * DVec3::X, 3.0 * DVec3::Y]).unwrap();
    /// assert_eq!(triangle.centroid(), Some(DVec3::X + DVec3::Y));
    /// ```
    #[must_use]
    pub fn centroid(&self) -> Option<DVec3> {
        let first = *self.vertices.first()?;
        let whole: DVec3 = self.fan().map(|(_, cross)| cross).sum();
        let direction = whole.try_normalize()?;
        let (moment, area) = self.fan().fold((DVec3::ZERO, 0.0), |(m, a), (sum, cross)| {
            let weight = cross.dot(direction);
            (m + weight * sum / 3.0, a + weight)
        });
        let from_first = scaled((moment / area).to_array(), self.exponent());
        Some(first + DVec3::from(from_first)).filter(|g| g.is_finite())
    }

    /// That of the power of two that brings its largest coordinate to 1 … 2, so that products stay in range.
    fn exponent(&self) -> i32 {
        split(self.scale()).1
    }

    /// For each triangle V₀ Vᵢ Vᵢ₊₁, seen from V₀: the sum and the cross product of its other two vertices, scaled by
    /// [`Self::exponent`].
    fn fan(&self) -> impl Iterator<Item = (DVec3, DVec3)> {
        let exponent = self.exponent();
        let scaled = move |v: DVec3| DVec3::from(scaled(v.to_array(), -exponent));
        let first = self.vertices.first().copied().map_or(DVec3::ZERO, scaled);
        self.vertices.windows(2).filter_map(move |pair| {
            let [a, b] = pair.first_chunk()?.map(|v: DVec3| scaled(v) - first);
            Some((a + b, a.cross(b)))
        })
    }

    /// Finite, with a plane, on it, and convex.
    fn check(&self, tolerance: f64) -> Result<(), PolygonError> {
        let vertices = self.vertices.len();
        if vertices < 3 {
            return Err(PolygonError::TooFew { vertices });
        }
        let not_finite = |(vertex, v): (usize, &DVec3)| {
            (!v.is_finite()).then_some(PolygonError::Position {
                vertex,
                position: *v,
            })
        };
        if let Some(error) = self.vertices.iter().enumerate().find_map(not_finite) {
            return Err(error);
        }
        let (span, plane) = self.span_and_plane().ok_or(PolygonError::Collinear)?;
        if vertices == 3 {
            return Ok(());
        }
        let scale = self.scale();
        let largest = plane.normal.abs().max_element();
        let normal = (plane.normal / largest).normalize();
        let [a, b, _] = span.map(|v| v / scale);
        for (vertex, &v) in self.vertices.iter().enumerate() {
            let distance = normal.dot(v / scale - a).abs();
            if distance > tolerance {
                return Err(PolygonError::NotPlanar {
                    vertex,
                    distance: distance * scale,
                    allowed: tolerance * scale,
                });
            }
        }
        let mut ring: Vec<(usize, DVec3)> = Vec::with_capacity(vertices);
        for (i, &v) in self.vertices.iter().enumerate() {
            let v = v / scale;
            if ring.last().is_none_or(|&(_, last)| last != v) {
                ring.push((i, v));
            }
        }
        while ring.len() > 1 && ring.first().map(|(_, v)| *v) == ring.last().map(|(_, v)| *v) {
            ring.pop();
        }
        match reflex(&ring, normal, tolerance).or_else(|| second_turn(&ring, b - a, tolerance)) {
            Some(vertex) => Err(PolygonError::NotConvex { vertex }),
            None => Ok(()),
        }
    }
}

/// The index of the largest value above 0, the first of equal ones.
fn largest(values: impl Iterator<Item = f64>) -> Option<usize> {
    let above = |best: Option<(usize, f64)>, (i, x)| match best {
        Some((_, most)) if x <= most => best,
        _ if x > 0.0 => Some((i, x)),
        _ => best,
    };
    values.enumerate().fold(None, above).map(|(i, _)| i)
}

/// A corner that lies deeper than `tolerance` inside the line between its neighbours.
fn reflex(ring: &[(usize, DVec3)], normal: DVec3, tolerance: f64) -> Option<usize> {
    let after = |k: usize| ring.iter().cycle().skip(k);
    let corners = ring.iter().zip(after(1)).zip(after(2));
    corners
        .map(|((a, b), c)| (a.1, b, c.1))
        .find(|&(before, &(_, corner), next)| {
            let across = next - before;
            // Neighbours at one place: the corner is a spike, and its foot turns inwards.
            let turned = normal.dot((corner - before).cross(across));
            turned < -tolerance * across.length()
        })
        .map(|(_, &(vertex, _), _)| vertex)
}

/// The vertex where a polygon that only turns one way begins to go round again: on one turn, the edges go along
/// `axis` and back once.
fn second_turn(ring: &[(usize, DVec3)], axis: DVec3, tolerance: f64) -> Option<usize> {
    let axis = axis.normalize_or_zero();
    let edges = ring.iter().zip(ring.iter().cycle().skip(1));
    let steps: Vec<(usize, f64)> = edges
        .map(|(&(vertex, a), &(_, b))| (vertex, axis.dot(b - a)))
        .filter(|(_, step)| step.abs() > tolerance)
        .collect();
    let pairs = steps.iter().zip(steps.iter().cycle().skip(1));
    let mut turns = pairs.filter(|((_, a), (_, b))| (*a > 0.0) != (*b > 0.0));
    turns.nth(2).map(|(_, &(vertex, _))| vertex)
}

#[cfg(test)]
mod tests;
