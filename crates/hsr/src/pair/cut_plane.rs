//! A plane for measuring and cutting: distances in doubles, with a bound of their error.

use ombra_math::glam::DVec3;
use ombra_math::plane::Plane;

/// A plane n·X + d = 0 for distances, and for cutting what lies on both sides.
///
/// # Properties
///
/// Distances are right within half the [`tolerance`](super::tolerance) of the largest coordinate of the vertex and the
/// points the plane was made of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CutPlane {
    /// Its normal is a quarter long: products with the largest doubles stay finite.
    plane: Plane,
}

impl CutPlane {
    /// `plane` made ready for measuring, `None` where its normal is 0 or a coefficient is not finite.
    #[must_use]
    pub fn of(plane: Plane) -> Option<Self> {
        let largest = plane.normal.abs().max_element();
        let shares = plane.normal / largest;
        let length = 4.0 * shares.length();
        let normal = shares / length;
        // Quartered first, or the distance from the origin could overflow.
        let d = plane.d * 0.25 / largest * (4.0 / length);
        Self::quartered(normal, d)
    }

    fn quartered(normal: DVec3, d: f64) -> Option<Self> {
        let plane = Plane { normal, d };
        (normal.is_finite() && d.is_finite()).then_some(Self { plane })
    }

    /// The plane through `point` along two directions; `None` where they are parallel.
    pub(super) fn along(point: DVec3, [u, v]: [DVec3; 2]) -> Option<Self> {
        let share = |u: DVec3| u / u.abs().max_element();
        let normal = share(u).cross(share(v)).try_normalize()? * 0.25;
        let d = -normal.dot(point);
        Self::quartered(normal, d)
    }

    /// The other way round.
    #[must_use]
    pub fn turned(self) -> Self {
        Self {
            plane: self.plane.turned(),
        }
    }

    /// Its plane.
    pub(super) fn plane(&self) -> Plane {
        self.plane
    }

    /// The sine of the angle between two planes.
    pub(super) fn sine(&self, other: &Self) -> f64 {
        16.0 * self.plane.normal.cross(other.plane.normal).length()
    }

    /// How far `v` lies from the plane, negative behind it.
    ///
    /// # Properties
    ///
    /// - Error: ½ [`tolerance`](super::tolerance)(M), M the largest coordinate of `v` and the points the plane was made of
    #[inline]
    #[must_use]
    pub fn distance(&self, v: DVec3) -> f64 {
        4.0 * self.quarter(v)
    }

    /// A quarter of the distance, which no coordinates make infinite.
    #[inline]
    fn quarter(&self, v: DVec3) -> f64 {
        self.plane.normal.dot(v) + self.plane.d
    }

    /// Cuts a convex polygon in two: the part in front of this plane, and the part behind.
    ///
    /// # Formula
    ///
    /// ```text
    /// crossing: X = A + t (B − A),  t = s_A / (s_A − s_B)          s: distance
    /// ```
    ///
    /// # Properties
    ///
    /// A vertex within `tolerance` of the plane is on it and belongs to both parts; a part that reaches no farther is
    /// empty. So cutting again at the same plane does nothing and leaves no slivers. Both parts get the same
    /// crossings. Of a polygon that lies on the plane both parts are empty.
    ///
    /// - Error: kept vertices none; a crossing at most [`tolerance`](super::tolerance)(M) from the plane and 2 ε M in a
    ///   coordinate from its edge, M the largest coordinate of the polygon and the points the plane was made of
    ///
    /// # Examples
    ///
    /// ```
    /// use ombra_hsr::pair::CutPlane;
    /// use ombra_math::glam::DVec3;
    /// use ombra_math::plane::Plane;
    ///
    /// let ground = CutPlane::of(Plane::GROUND).unwrap();
    /// let wall = [-DVec3::Y, DVec3::X - DVec3::Y, DVec3::X + DVec3::Y, DVec3::Y];
    /// let [above, below] = ground.split(&wall, 0.0);
    /// assert_eq!(above, [DVec3::X, DVec3::X + DVec3::Y, DVec3::Y, DVec3::ZERO]);
    /// assert_eq!(below, [-DVec3::Y, DVec3::X - DVec3::Y, DVec3::X, DVec3::ZERO]);
    /// ```
    ///
    /// # References
    ///
    /// Grafica 3, «Clipping di un poligono», for both sides at once.
    #[must_use]
    pub fn split(&self, polygon: &[DVec3], tolerance: f64) -> [Vec<DVec3>; 2] {
        let sides: Vec<f64> = polygon
            .iter()
            .map(|&v| self.quarter(v))
            .map(|s| if s.abs() <= tolerance / 4.0 { 0.0 } else { s })
            .collect();
        let (front, behind) = (
            sides.iter().any(|&s| s > 0.0),
            sides.iter().any(|&s| s < 0.0),
        );
        match (front, behind) {
            (false, false) => return [Vec::new(), Vec::new()],
            (true, false) => return [polygon.to_vec(), Vec::new()],
            (false, true) => return [Vec::new(), polygon.to_vec()],
            (true, true) => {}
        }
        let [mut front, mut behind] = [(); 2].map(|()| Vec::with_capacity(polygon.len() + 2));
        let corners = polygon.iter().zip(&sides);
        for ((&a, &s_a), (&b, &s_b)) in corners.clone().zip(corners.cycle().skip(1)) {
            if s_a >= 0.0 {
                front.push(a);
            }
            if s_a <= 0.0 {
                behind.push(a);
            }
            if (s_a > 0.0 && s_b < 0.0) || (s_a < 0.0 && s_b > 0.0) {
                let x = crossing(a, b, s_a, s_b);
                front.push(x);
                behind.push(x);
            }
        }
        [front, behind]
    }
}

/// The point of the edge A B on the plane, in the box round the edge.
fn crossing(a: DVec3, b: DVec3, s_a: f64, s_b: f64) -> DVec3 {
    let (a, b, s_a, s_b) = if s_a > 0.0 {
        (a, b, s_a, s_b)
    } else {
        (b, a, s_b, s_a)
    };
    // The difference of two of the largest doubles would overflow.
    let (s_a, s_b) = (0.25 * s_a, 0.25 * s_b);
    let t = s_a / (s_a - s_b);
    (a * (1.0 - t) + b * t).max(a.min(b)).min(a.max(b))
}
