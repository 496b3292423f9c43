//! A camera: projection and viewport in one, with the eye and the sight line of each pixel read off its matrix.
//!
//! Every method of hidden-surface removal needs another part of the same camera: the z-buffer its matrix, ray casting
//! its sight lines, the painter its eye. Taken from one matrix, they cannot disagree.

use core::ops::RangeInclusive;

use glam::{DMat4, DVec2, DVec3, DVec4};

use crate::homogeneous::project;
use crate::scaling::{scaled, split};
use crate::triangle::unit;
use crate::view::Viewport;

/// A camera: where a point of the world comes out in the picture.
///
/// # Examples
///
/// ```
/// use ombra_math::camera::Camera;
/// use ombra_math::glam::{DVec2, DVec3};
/// use ombra_math::view::{Viewport, frustum, look_at};
///
/// let view = look_at(DVec3::new(0.0, 0.0, 5.0), DVec3::ZERO, DVec3::Y).unwrap();
/// let projection = frustum(-1.0, 1.0, -1.0, 1.0, 1.0, 10.0).unwrap();
/// let camera = Camera { view_projection: projection * view, viewport: Viewport { width: 8, height: 8 } };
///
/// assert_eq!(camera.eye().unwrap().truncate(), DVec3::new(0.0, 0.0, 5.0));
/// assert_eq!(camera.to_pixel(DVec3::ZERO).unwrap().truncate(), DVec2::new(4.0, 4.0));
/// let line = camera.sight_line(DVec2::new(4.0, 4.0)).unwrap();
/// assert_eq!((line.origin, line.direction), (DVec3::new(0.0, 0.0, 4.0), -DVec3::Z));
/// ```
///
/// # References
///
/// In no deck as one thing; its parts are those of [`view`](crate::view).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// From world to clip coordinates: projection · view.
    pub view_projection: DMat4,
    /// The picture that clip space is spread over.
    pub viewport: Viewport,
}

/// The points that come out at one place of the picture, from the near plane on: origin + t · direction, t ≥ 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SightLine {
    /// The point on the near plane.
    pub origin: DVec3,
    /// Away from the eye; of unit length as [`Camera::sight_line`] makes it.
    pub direction: DVec3,
}

impl SightLine {
    /// The point at parameter `t`.
    ///
    /// # Properties
    ///
    /// - Error: at most ε (|origin| + |t direction|) in each coordinate.
    #[must_use]
    pub fn at(&self, t: f64) -> DVec3 {
        self.origin + t * self.direction
    }
}

impl Camera {
    /// A point of the world in clip coordinates, before the division by w.
    ///
    /// # Properties
    ///
    /// - Error: at most 3 ε Σ|mᵢⱼ pⱼ| in coordinate i.
    #[must_use]
    pub fn to_clip(&self, p_world: DVec3) -> DVec4 {
        self.view_projection * p_world.extend(1.0)
    }

    /// Where a point of the world comes out: pixel coordinates and depth 0 … 1, or `None` behind the eye.
    ///
    /// Points outside the view volume come out outside the picture or the range of depth.
    ///
    /// # Properties
    ///
    /// - Error: at most 3 ε K (1 + |ndc|) of width, height and 1, K = max Σ|mᵢⱼ pⱼ| / w.
    #[must_use]
    pub fn to_pixel(&self, p_world: DVec3) -> Option<DVec3> {
        let p_clip = self.to_clip(p_world);
        let ndc = project(p_clip).filter(|_| p_clip.w > 0.0)?;
        Some(self.viewport.to_pixel(ndc))
    }

    /// The eye: a place with w = 1, or for a parallel projection the direction towards the viewer, w = 0.
    ///
    /// # Formula
    ///
    /// ```text
    /// M E = (0, 0, z, 0):   the one point on the planes x = 0, y = 0 and w = 0 of clip space
    /// ```
    ///
    /// # Properties
    ///
    /// It lies on the viewer's side of the near plane. w is exactly 0 for a matrix whose last row is 0 0 0 1. A multiple
    /// of the matrix has the same eye, however large or small it is.
    ///
    /// - Error: at most 4 ε (Pᵢ + |Eᵢ| P_w) / |W|, P the absolute terms of E W and of W.
    ///
    /// # Errors
    ///
    /// `None` where the matrix has no such point, or one beyond the largest double, or a row with NaN or ∞.
    #[must_use]
    pub fn eye(&self) -> Option<DVec4> {
        let [x, y, z, w] = self.rows();
        let eye = meet(ordinary(x), ordinary(y), ordinary(w));
        if eye.w != 0.0 {
            return project(eye).map(|place| place.extend(1.0));
        }
        let behind_near = if (z + w).dot(eye) > 0.0 { -eye } else { eye };
        unit(behind_near.truncate()).map(|towards| towards.extend(0.0))
    }

    /// The sight line through a place of the picture, in pixel coordinates: (i + ½, j + ½) for a pixel's centre.
    ///
    /// # Formula
    ///
    /// ```text
    /// the points on two planes:   x = x_ndc w   and   y = y_ndc w
    /// x_ndc = 2 x_pixel / width − 1      y_ndc = 1 − 2 y_pixel / height
    /// ```
    ///
    /// # Properties
    ///
    /// - Error: at most 8 ε (Pᵢ + |Oᵢ| P_w) / |W| in the origin O, 8 ε P_d / |D| in the direction.
    ///
    /// # Pitfalls
    ///
    /// A matrix that cannot be inverted shows at one place of the picture nothing, or more than a line. Where the two
    /// planes and the near one still meet in one point there is an answer, but not a sight line.
    ///
    /// # Errors
    ///
    /// `None` for a picture without pixels, planes that do not meet in one point, numbers that are not finite.
    #[doc(alias = "primary ray")]
    #[doc(alias = "unproject")]
    #[must_use]
    pub fn sight_line(&self, pixel: DVec2) -> Option<SightLine> {
        let [x, y, z, w] = self.rows();
        let size = DVec2::new(
            f64::from(self.viewport.width),
            f64::from(self.viewport.height),
        );
        let ndc = (2.0 * pixel / size - 1.0) * DVec2::new(1.0, -1.0);
        let [column, row, near] = [x - ndc.x * w, y - ndc.y * w, z + w].map(ordinary);
        let origin = project(meet(column, row, near))?;
        let along = unit(column.truncate().cross(row.truncate()))?;
        let inwards = near.truncate().dot(along);
        (inwards != 0.0 && ndc.is_finite()).then_some(SightLine {
            origin,
            direction: if inwards > 0.0 { along } else { -along },
        })
    }

    fn rows(&self) -> [DVec4; 4] {
        [0, 1, 2, 3].map(|i| self.view_projection.row(i))
    }
}

/// The same plane with a normal of a size at which products of three stay in range; a power of two rounds nothing.
fn ordinary(plane: DVec4) -> DVec4 {
    const ORDINARY: RangeInclusive<f64> = 1e-60..=1e60;
    let size = plane.truncate().abs().max_element();
    if ORDINARY.contains(&size) && plane.w.abs() < 1e120 || size == 0.0 || !size.is_finite() {
        return plane;
    }
    // Below 1/8: six products with a fourth coordinate of any size are not too large together.
    let (_, exponent) = split(size);
    scaled(plane.to_array(), -exponent - 4).into()
}

/// The homogeneous point on three planes: the vector at right angles to their coefficients.
fn meet(a: DVec4, b: DVec4, c: DVec4) -> DVec4 {
    let minor = |part: fn(DVec4) -> DVec3| part(a).dot(part(b).cross(part(c)));
    DVec4::new(
        minor(|v| DVec3::new(v.y, v.z, v.w)),
        -minor(|v| DVec3::new(v.x, v.z, v.w)),
        minor(|v| DVec3::new(v.x, v.y, v.w)),
        -minor(|v| DVec3::new(v.x, v.y, v.z)),
    )
}

#[cfg(test)]
mod tests;
