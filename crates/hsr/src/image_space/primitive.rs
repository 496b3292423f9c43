//! The primitives and the view volume, ready for rays.

use core::cmp::Ordering;

use ombra_math::camera::{Camera, SightLine};
use ombra_math::glam::{DVec3, UVec2};

use super::ray::{self, Ray, Target};
use crate::picture::{NOTHING, PictureError, number};
use crate::polygon::Polygon;

/// A primitive, ready for rays.
pub(super) struct Primitive<'a> {
    /// As it is stored in a picture.
    pub(super) number: u32,
    pub(super) corners: &'a [DVec3],
    pub(super) target: Target,
}

impl<'a> Primitive<'a> {
    /// `None` for a polygon without a plane.
    pub(super) fn new(polygon: &'a Polygon) -> Option<Self> {
        let corners = polygon.vertices.as_slice();
        let mut target = Target::of_triangle(polygon.span()?);
        target.ordinary = corners.iter().copied().all(ray::is_ordinary);
        Some(Self {
            number: NOTHING,
            corners,
            target,
        })
    }

    /// Whether the line of the ray, which is not along the plane, passes inside, border included.
    pub(super) fn holds(&self, ray: &Ray) -> bool {
        let ends = self.corners.iter().cycle().skip(1);
        let mut turn = Ordering::Equal;
        for (&a, &b) in self.corners.iter().zip(ends) {
            let side = ray.passes(a, b, self.target.ordinary);
            if side == turn || side == Ordering::Equal {
                continue;
            }
            if turn != Ordering::Equal {
                return false;
            }
            turn = side;
        }
        true
    }
}

/// The primitives and the view volume.
pub(super) struct Targets<'a> {
    pub(super) camera: &'a Camera,
    pub(super) primitives: Vec<Primitive<'a>>,
    pub(super) near: Target,
    pub(super) far: Target,
}

impl<'a> Targets<'a> {
    pub(super) fn new(polygons: &'a [Polygon], camera: &'a Camera) -> Result<Self, PictureError> {
        let mut primitives = Vec::with_capacity(polygons.len());
        for (id, polygon) in polygons.iter().enumerate() {
            let number = number(id)?;
            primitives.extend(Primitive::new(polygon).map(|primitive| Primitive {
                number,
                ..primitive
            }));
        }
        let (z, w) = (camera.view_projection.row(2), camera.view_projection.row(3));
        Ok(Self {
            camera,
            primitives,
            near: Target::of_coefficients(w + z),
            far: Target::of_coefficients(w - z),
        })
    }

    /// The sight line of a pixel, and the ray it is.
    pub(super) fn ray(&self, pixel: UVec2) -> Result<(SightLine, Ray), PictureError> {
        let line = self.camera.sight_line(pixel.as_dvec2() + 0.5);
        line.and_then(|line| Some((line, Ray::new(line)?)))
            .ok_or(PictureError::NoSightLine { pixel })
    }
}
