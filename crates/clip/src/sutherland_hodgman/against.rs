//! A polygon against one line or plane.

use ombra_math::exact::{dot, relative};
use ombra_math::glam::{DVec2, DVec3, DVec4};
use ombra_math::homogeneous::{incidence, point};
use ombra_math::plane::Plane;
use ombra_math::scaling::{scaled, split};
use ombra_math::work::{Count, Counter};

use super::clip_by_plain;
use crate::crossing::between_products;

/// The points p with n·p ≥ offset.
///
/// # Formula
///
/// ```text
/// n·p = n_x x + n_y y ≥ offset          n points inside, and need not be of unit length
/// ```
///
/// # Properties
///
/// The border n·p = offset belongs to it. With a zero normal it is the whole plane or nothing.
///
/// # Examples
///
/// ```
/// use ombra_clip::sutherland_hodgman::HalfPlane;
/// use ombra_math::glam::DVec2;
///
/// // x ≤ 10
/// let left_of_10 = HalfPlane { normal: -DVec2::X, offset: -10.0 };
/// assert!(left_of_10.contains(DVec2::new(10.0, 3.0)));
/// assert!(!left_of_10.contains(DVec2::new(10.000001, 3.0)));
/// ```
///
/// # References
///
/// Grafica 3, «Clipping di un poligono»: the polygon against one line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HalfPlane {
    /// n, towards the inside.
    pub normal: DVec2,
    /// n·Q for a point Q of the line.
    pub offset: f64,
}

impl HalfPlane {
    /// Whether n·p ≥ offset: exact, and never for NaN or ∞.
    #[must_use]
    pub fn contains(&self, p: DVec2) -> bool {
        self.side(p) >= 0.0
    }

    /// A number with the sign of n·p − offset; NaN if a coordinate is not finite.
    fn side(&self, p: DVec2) -> f64 {
        let (normal, offset) = (self.normal, self.offset);
        let line = DVec4::new(normal.x, normal.y, offset, 0.0);
        dot(line, DVec4::new(p.x, p.y, -1.0, 0.0)).0
    }

    /// n·p − offset as a sum of products.
    fn products(&self, p: DVec2) -> [[f64; 2]; 3] {
        [
            [self.normal.x, p.x],
            [self.normal.y, p.y],
            [self.offset, -1.0],
        ]
    }
}

/// [`clip_against_line`], counting its [work](crate#counted-work): two multiplications for n·p.
///
/// # Properties
///
/// - Error: none: each coordinate is the double nearest to the exact one.
///
/// # References
///
/// As for [`clip_against_line`].
#[must_use]
pub fn clip_against_line_plain(
    polygon: &[DVec2],
    half: HalfPlane,
    work: &mut impl Count,
) -> Vec<DVec2> {
    work.add(Counter::Multiplications, 2 * polygon.len() as u64);
    clip_by_plain(
        polygon,
        |p| half.side(p),
        |a, b, _, _| {
            let (sa, sb) = (half.products(a), half.products(b));
            [0, 1]
                .map(|k| between_products(&sa, &sb, [a[k], b[k]]))
                .into()
        },
        work,
    )
}

/// The part of a polygon on one side of a line.
///
/// # Formula
///
/// ```text
/// inside: n·p ≥ offset          crossing: p = (s_A B − s_B A) / (s_A − s_B),  s = n·p − offset
/// ```
///
/// # Properties
///
/// - Error: none: each coordinate is the double nearest to the exact one.
/// - Which side a vertex lies on is exact; for an upright or level line crossings lie on it exactly.
/// - Vertices inside are kept unchanged and in order. Empty where nothing but an edge or a vertex is left, or a number is
///   not finite.
///
/// # Pitfalls
///
/// See [`clip_by`](super::clip_by) for concave polygons. For a line at an angle the nearest double may lie beyond it, by rounding of
/// its coordinates: no double may lie on it at all.
///
/// # Examples
///
/// ```
/// use ombra_clip::sutherland_hodgman::{HalfPlane, clip_against_line};
/// use ombra_math::glam::DVec2;
///
/// let square = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)].map(DVec2::from);
/// let below_diagonal = HalfPlane { normal: DVec2::new(-1.0, -1.0), offset: -4.0 }; // x + y ≤ 4
/// let half = [(0.0, 0.0), (4.0, 0.0), (0.0, 4.0)].map(DVec2::from);
/// assert_eq!(clip_against_line(&square, below_diagonal), half);
/// ```
///
/// # References
///
/// Grafica 3, «Clipping di un poligono».
#[must_use]
pub fn clip_against_line(polygon: &[DVec2], half: HalfPlane) -> Vec<DVec2> {
    clip_against_line_plain(polygon, half, &mut ())
}

/// [`clip_against_plane`], counting its [work](crate#counted-work): three multiplications for n·X.
///
/// # Properties
///
/// - Error: 4ε of the larger of the two ends' coordinates, for each coordinate of a crossing.
///
/// # References
///
/// As for [`clip_against_plane`].
#[must_use]
pub fn clip_against_plane_plain(
    polygon: &[DVec3],
    plane: &Plane,
    work: &mut impl Count,
) -> Vec<DVec3> {
    work.add(Counter::Multiplications, 3 * polygon.len() as u64);
    let scaled: Vec<_> = polygon
        .iter()
        .map(|&v| dot(plane.coefficients(), point(v)))
        .collect();
    let sides = relative(&scaled);
    let vertices: Vec<_> = polygon.iter().copied().zip(sides).collect();
    let clipped = clip_by_plain(
        &vertices,
        |(_, side)| side,
        |(a, _), (b, _), sa, sb| {
            // The shares of both ends, from s_in > 0 > s_out below 2.
            let [wa, wb] = [-sb / (sa - sb), sa / (sa - sb)];
            // Rounding may not leave the edge's box.
            ((a * wa + b * wb).max(a.min(b)).min(a.max(b)), 0.0)
        },
        work,
    );
    clipped.into_iter().map(|(v, _)| v).collect()
}

/// The part of a polygon in space that lies in front of `plane` or on it.
///
/// # Formula
///
/// ```text
/// inside: n·X + d ≥ 0          crossing: X = A + t (B − A),  t = s_A / (s_A − s_B)
/// ```
///
/// # Properties
///
/// - Error: 4ε of the larger of the two ends' coordinates, for each coordinate of a crossing.
/// - That is while the vertices' distances from the plane are 0 or within a factor of 2⁹⁰⁰ of one another.
/// - Which side a vertex lies on is exact. A crossing lies in the box round its edge, and is equal for both directions of
///   the edge.
/// - Empty where nothing but an edge or a vertex is left, or a coordinate is not finite. A normal of 0 is no plane: all is
///   inside for d ≥ 0, nothing for d < 0.
///
/// # Pitfalls
///
/// See [`clip_by`](super::clip_by) for concave polygons.
///
/// # Examples
///
/// ```
/// use ombra_clip::sutherland_hodgman::clip_against_plane;
/// use ombra_math::glam::DVec3;
/// use ombra_math::plane::Plane;
///
/// let wall = [DVec3::new(0.0, -1.0, 0.0), DVec3::new(4.0, -1.0, 0.0), DVec3::new(4.0, 3.0, 0.0)];
/// let above = clip_against_plane(&wall, &Plane::GROUND);
/// assert_eq!(above, [DVec3::new(1.0, 0.0, 0.0), DVec3::new(4.0, 0.0, 0.0), DVec3::new(4.0, 3.0, 0.0)]);
/// ```
///
/// # References
///
/// Grafica 3, «Clipping di un poligono»; Croatian 8.4, projected shadows (an object behind the plane).
#[must_use]
pub fn clip_against_plane(polygon: &[DVec3], plane: &Plane) -> Vec<DVec3> {
    clip_against_plane_plain(polygon, plane, &mut ())
}

/// [`clip_homogeneous`], counting its [work](crate#counted-work): four multiplications for π·P.
///
/// # Properties
///
/// - Error: 3ε (|s_A B| + |s_B A|) in each coordinate of a crossing, which is s_A B − s_B A times a power of two.
///
/// # References
///
/// As for [`clip_homogeneous`].
#[must_use]
pub fn clip_homogeneous_plain(
    polygon: &[DVec4],
    plane: DVec4,
    work: &mut impl Count,
) -> Vec<DVec4> {
    work.add(Counter::Multiplications, 4 * polygon.len() as u64);
    let side = |p| incidence(plane, p).clamp(-f64::MAX, f64::MAX);
    let cut = |a, b, sa: f64, sb: f64| {
        // Any multiple will do: the power of two that keeps the weights below ½ costs no digit.
        let [sa, sb] = scaled([sa, sb], -split(sa.max(-sb)).1 - 2);
        b * sa - a * sb
    };
    clip_by_plain(polygon, side, cut, work)
}

/// The part of a homogeneous polygon where π·P ≥ 0.
///
/// # Formula
///
/// ```text
/// inside: π·P ≥ 0          crossing: P = (s_A B − s_B A) / (s_A − s_B)
/// ```
///
/// # Properties
///
/// - Error: 3ε (|s_A B| + |s_B A|) in each coordinate of a crossing, which is s_A B − s_B A times a power of two.
/// - Needs no division by w, so points at infinity (w = 0) and behind the eye (w < 0) are clipped like any other.
/// - Sides are exact, except that values below the smallest double count as 0; values beyond the largest count as
///   the largest, and the crossing beside them is rough.
/// - Empty where nothing but an edge or a vertex is left, or a coordinate is not finite.
///
/// # Pitfalls
///
/// Clip against w ≥ 0 before dividing: a polygon with w of both signs turns inside out.
///
/// # Examples
///
/// The wedge between two parallel edges that run to infinity, cut at x ≤ 5:
///
/// ```
/// use ombra_clip::sutherland_hodgman::clip_homogeneous;
/// use ombra_math::glam::DVec4;
///
/// let strip = [
///     DVec4::new(0.0, 0.0, 0.0, 1.0),
///     DVec4::new(1.0, 0.0, 0.0, 0.0), // the direction +x
///     DVec4::new(0.0, 0.0, 2.0, 1.0),
/// ];
/// let cut = clip_homogeneous(&strip, DVec4::new(-1.0, 0.0, 0.0, 5.0));
/// let places: Vec<_> = cut.iter().map(|p| *p / p.w).collect();
/// assert_eq!(places[1], DVec4::new(5.0, 0.0, 0.0, 1.0));
/// assert_eq!(places[2], DVec4::new(5.0, 0.0, 2.0, 1.0));
/// ```
///
/// # References
///
/// CIS 781, «Avoiding far plane clipping»; Grafica 3, «Clipping di un poligono». J. F. Blinn, M. E. Newell,
/// «Clipping using homogeneous coordinates», 1978.
#[must_use]
pub fn clip_homogeneous(polygon: &[DVec4], plane: DVec4) -> Vec<DVec4> {
    clip_homogeneous_plain(polygon, plane, &mut ())
}

#[cfg(test)]
mod tests;
