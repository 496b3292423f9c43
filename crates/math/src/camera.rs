//! A camera: projection and viewport in one, with the eye and the sight line of each pixel read off its matrix.
//!
//! Every method of hidden-surface removal needs another part of the same camera: the z-buffer its matrix, ray casting
//! its sight lines, the painter its eye. Taken from one matrix, they cannot disagree.

use glam::{DMat4, DVec2, DVec3, DVec4};

use crate::homogeneous::project;
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
/// assert_eq!((line.origin, line.direction.normalize()), (DVec3::new(0.0, 0.0, 4.0), -DVec3::Z));
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
    /// Away from the eye; not of unit length.
    pub direction: DVec3,
}

impl SightLine {
    /// The point at parameter `t`.
    #[must_use]
    pub fn at(&self, t: f64) -> DVec3 {
        self.origin + t * self.direction
    }
}

impl Camera {
    /// A point of the world in clip coordinates, before the division by w.
    #[must_use]
    pub fn to_clip(&self, p_world: DVec3) -> DVec4 {
        self.view_projection * p_world.extend(1.0)
    }

    /// Where a point of the world comes out: pixel coordinates and depth 0 … 1, or `None` behind the eye.
    ///
    /// Points outside the view volume come out outside the picture or the range of depth.
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
    /// It lies on the viewer's side of the near plane. w is exactly 0 for a matrix whose last row is 0 0 0 1.
    ///
    /// # Errors
    ///
    /// `None` where the matrix has no such point, or one beyond the largest double.
    #[must_use]
    pub fn eye(&self) -> Option<DVec4> {
        let [x, y, z, w] = self.rows();
        let eye = meet(x, y, w);
        if eye.w != 0.0 {
            return project(eye).map(|place| place.extend(1.0));
        }
        let behind_near = if (z + w).dot(eye) > 0.0 { -eye } else { eye };
        let towards = behind_near.truncate().try_normalize()?;
        Some(towards.extend(0.0))
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
    /// # Errors
    ///
    /// `None` for a picture without pixels, a matrix that cannot be inverted, numbers that are not finite.
    #[must_use]
    pub fn sight_line(&self, pixel: DVec2) -> Option<SightLine> {
        let [x, y, z, w] = self.rows();
        let size = DVec2::new(
            f64::from(self.viewport.width),
            f64::from(self.viewport.height),
        );
        let ndc = (2.0 * pixel / size - 1.0) * DVec2::new(1.0, -1.0);
        let (column, row, near) = (x - ndc.x * w, y - ndc.y * w, z + w);
        let origin = project(meet(column, row, near))?;
        let along = column.truncate().cross(row.truncate()).try_normalize()?;
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
mod tests {
    use super::*;
    use crate::view::{frustum_infinite, look_at, orthographic, perspective};
    use proptest::num::f64::ANY;
    use proptest::prelude::*;

    const VIEWPORT: Viewport = Viewport {
        width: 640,
        height: 480,
    };

    fn camera(projection: DMat4, eye: DVec3) -> Camera {
        let view = look_at(eye, DVec3::new(1.0, 2.0, -3.0), DVec3::Y).unwrap();
        Camera {
            view_projection: projection * view,
            viewport: VIEWPORT,
        }
    }

    #[test]
    fn degenerate() {
        let perspective = perspective(1.0, 4.0 / 3.0, 0.1, 100.0).unwrap();
        let good = camera(perspective, DVec3::new(5.0, 4.0, 6.0));
        let line_of = |camera: Camera| camera.sight_line(DVec2::new(320.5, 240.5));
        assert!(good.eye().is_some() && line_of(good).is_some());
        for matrix in [
            DMat4::ZERO,
            DMat4::NAN,
            DMat4::from_diagonal(DVec4::new(1.0, 0.0, 1.0, 1.0)),
            DMat4::from_diagonal(DVec4::splat(f64::INFINITY)),
            perspective * f64::MAX,
        ] {
            let bad = Camera {
                view_projection: matrix,
                ..good
            };
            assert_eq!((bad.eye(), line_of(bad)), (None, None), "{matrix}");
        }
        let empty = Camera {
            viewport: Viewport {
                width: 0,
                height: 480,
            },
            ..good
        };
        assert_eq!(line_of(empty), None);
        for pixel in [DVec2::NAN, DVec2::INFINITY] {
            assert_eq!(good.sight_line(pixel), None);
        }
        // Behind the eye, and in the plane of the eye.
        assert_eq!(good.to_pixel(DVec3::new(9.0, 6.0, 15.0)), None);
        assert_eq!(good.to_pixel(good.eye().unwrap().truncate()), None);
        assert_eq!(good.to_pixel(DVec3::NAN), None);
    }

    #[test]
    fn a_parallel_view_looks_along_one_direction() {
        let projection = orthographic(-4.0, 4.0, -3.0, 3.0, 1.0, 50.0).unwrap();
        let at = DVec3::new(5.0, 4.0, 6.0);
        let camera = camera(projection, at);
        let eye = camera.eye().unwrap();
        let back = (at - DVec3::new(1.0, 2.0, -3.0)).normalize();
        assert_eq!(eye.w, 0.0);
        // Three roundings a coordinate in the view matrix, a dozen in the cross product.
        assert!((eye.truncate() - back).length() <= 16.0 * f64::EPSILON);
        for pixel in [DVec2::new(0.5, 0.5), DVec2::new(600.0, 13.0)] {
            let line = camera.sight_line(pixel).unwrap();
            assert!((line.direction + back).length() <= 16.0 * f64::EPSILON);
        }
    }

    proptest! {
        /// Points of the sight line come out at the pixel it was asked for, the first at depth 0; seen from a place, it
        /// passes through the eye.
        #[test]
        fn sight_lines_meet_their_pixel(
            eye in prop::array::uniform3(2.0..9.0),
            pixel in (0.0..640.0, 0.0..480.0),
            t in 0.0..20.0,
            kind in 0..3,
        ) {
            let projection = match kind {
                0 => perspective(1.0, 4.0 / 3.0, 0.5, 100.0),
                1 => frustum_infinite(-0.2, 0.5, -0.3, 0.4, 0.5),
                _ => orthographic(-4.0, 4.0, -3.0, 3.0, 0.5, 50.0),
            }.unwrap();
            let (eye, pixel) = (DVec3::from(eye), DVec2::from(pixel));
            let camera = camera(projection, eye);
            let line = camera.sight_line(pixel).unwrap();
            // A few dozen roundings, seen at 640 pixels.
            let tolerance = 64.0 * f64::EPSILON * 640.0;
            let near = camera.to_pixel(line.origin).unwrap();
            let found = camera.to_pixel(line.at(t)).unwrap();
            prop_assert!((near.truncate() - pixel).length() < tolerance, "{near}");
            prop_assert!((found.truncate() - pixel).length() < tolerance, "{found}");
            prop_assert!(near.z.abs() < tolerance && found.z >= near.z);
            let place = camera.eye().unwrap();
            prop_assert_eq!(place.w == 1.0, kind < 2);
            if kind < 2 {
                prop_assert!((place.truncate() - eye).length() < 256.0 * f64::EPSILON * eye.length());
                let off = (line.origin - eye).normalize() - line.direction;
                prop_assert!(off.length() < tolerance, "{off}");
            }
        }

        #[test]
        fn never_panics(m in prop::array::uniform16(ANY), p in prop::array::uniform3(ANY)) {
            let camera = Camera { view_projection: DMat4::from_cols_array(&m), viewport: VIEWPORT };
            let p = DVec3::from(p);
            let _ = (camera.eye(), camera.to_pixel(p), camera.sight_line(p.truncate()));
        }
    }
}
