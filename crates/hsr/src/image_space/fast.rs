//! Only the primitives about a pixel are intersected, and rows run in parallel.

use core::cmp::Ordering;

use ombra_math::camera::Camera;
use ombra_math::glam::UVec2;
use ombra_math::work::{Count, Counter, Work};
#[cfg(feature = "parallel")]
use rayon::prelude::*;

use super::about::{is_true, pixel_box};
use super::primitive::{Primitive, Targets};
use super::ray::{Meeting, Ray, is_within, order};
use crate::picture::{IdBuffer, NOTHING, PictureError, background};
use crate::polygon::Polygon;

/// [`cast`](super::cast), counting rays and their intersections with planes: those that were not left out.
///
/// # Errors
///
/// As [`cast`](super::cast).
pub fn cast(
    polygons: &[Polygon],
    camera: &Camera,
    work: &mut impl Count,
) -> Result<IdBuffer, PictureError> {
    let mut picture = background(camera)?;
    let scene = BoxedTargets::new(polygons, camera)?;
    let width = camera.viewport.width.max(1) as usize;
    let row = |(y, row): (usize, &mut [u32])| {
        let mut work = Work::default();
        scene.cast_row(y as u32, row, &mut work).map(|()| work)
    };
    #[cfg(feature = "parallel")]
    let rows: Vec<_> = picture.par_chunks_mut(width).enumerate().map(row).collect();
    #[cfg(not(feature = "parallel"))]
    let rows: Vec<_> = picture.chunks_mut(width).enumerate().map(row).collect();
    // In the order of the rows, so that the error is that of the first pixel that has one.
    for row in rows {
        let row = row?;
        for &what in Counter::ALL {
            work.add(what, row.get(what));
        }
    }
    Ok(picture)
}

/// The primitives, and where each may be seen.
struct BoxedTargets<'a> {
    targets: Targets<'a>,
    /// First column and row, last column and row.
    boxes: Vec<[UVec2; 2]>,
}

impl<'a> BoxedTargets<'a> {
    fn new(polygons: &'a [Polygon], camera: &'a Camera) -> Result<Self, PictureError> {
        let targets = Targets::new(polygons, camera)?;
        let boxes = targets.primitives.iter();
        let boxes = boxes.map(|primitive| pixel_box(primitive.corners, camera));
        Ok(Self {
            boxes: boxes.collect(),
            targets,
        })
    }

    /// The number of the nearest of `primitives` on a ray.
    fn cast_ray<'p>(
        &self,
        ray: Ray,
        primitives: impl IntoIterator<Item = &'p Primitive<'a>>,
        work: &mut impl Count,
    ) -> u32
    where
        'a: 'p,
    {
        work.add(Counter::Rays, 1);
        let mut nearest: Option<(&Primitive, Meeting)> = None;
        for primitive in primitives {
            work.add(Counter::Intersections, 1);
            let target = &primitive.target;
            let Some(meeting) = target.meet(&ray) else {
                continue;
            };
            let is_nearer = |(best, m): &(&Primitive, Meeting)| {
                order(&ray, (target, &meeting), (&best.target, m)) == Ordering::Less
            };
            let seen = nearest.as_ref().is_none_or(is_nearer)
                && primitive.holds(&ray)
                && is_within(&ray, target, &meeting, &self.targets.near)
                && is_within(&ray, target, &meeting, &self.targets.far);
            if seen {
                nearest = Some((primitive, meeting));
            }
        }
        nearest.map_or(NOTHING, |(primitive, _)| primitive.number)
    }

    /// A row of the picture, each ray with the primitives about its pixel only.
    fn cast_row(&self, y: u32, row: &mut [u32], work: &mut Work) -> Result<(), PictureError> {
        let mut about: Vec<(&Primitive, u32, u32)> = Vec::new();
        for (primitive, [low, high]) in self.targets.primitives.iter().zip(&self.boxes) {
            if low.y <= y && y <= high.y {
                about.push((primitive, low.x, high.x));
            }
        }
        for (x, pixel) in (0..).zip(row) {
            let place = UVec2::new(x, y);
            let (line, ray) = self.targets.ray(place)?;
            let last = self.targets.far.meet(&ray).map(|meeting| meeting.t);
            *pixel = if is_true(line, last, place, self.targets.camera) {
                let here = about
                    .iter()
                    .filter(|&&(_, low, high)| low <= x && x <= high)
                    .map(|&(primitive, ..)| primitive);
                self.cast_ray(ray, here, work)
            } else {
                self.cast_ray(ray, &self.targets.primitives, work)
            };
        }
        Ok(())
    }
}
