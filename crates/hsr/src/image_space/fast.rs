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
    let targets = Targets::new(polygons, camera)?;
    let primitives = targets.primitives.iter();
    let boxed: Vec<Boxed> = primitives
        .map(|p| (p, pixel_box(p.corners, camera)))
        .collect();
    let width = camera.viewport.width.max(1) as usize;
    let row = |(y, row): (usize, &mut [u32])| {
        let mut work = Work::default();
        cast_row(&targets, &boxed, y as u32, row, &mut work).map(|()| work)
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

/// A primitive, and where it may be seen: first column and row, last column and row.
type Boxed<'a> = (&'a Primitive<'a>, [UVec2; 2]);

/// A row of the picture, each ray with the primitives about its pixel only.
fn cast_row(
    targets: &Targets,
    boxed: &[Boxed],
    y: u32,
    row: &mut [u32],
    work: &mut Work,
) -> Result<(), PictureError> {
    let is_about = |(_, [low, high]): &&Boxed| low.y <= y && y <= high.y;
    let about: Vec<&Boxed> = boxed.iter().filter(is_about).collect();
    for (x, pixel) in (0..).zip(row) {
        let place = UVec2::new(x, y);
        let (line, ray) = targets.ray(place)?;
        let last = targets.far.meet(&ray).map(|meeting| meeting.t);
        *pixel = if is_true(line, last, place, targets.camera) {
            let is_here = |(_, [low, high]): &&&Boxed| low.x <= x && x <= high.x;
            let here = about
                .iter()
                .filter(is_here)
                .map(|(primitive, _)| *primitive);
            cast_ray(targets, ray, here, work)
        } else {
            cast_ray(targets, ray, &targets.primitives, work)
        };
    }
    Ok(())
}

/// The number of the nearest of `primitives` on a ray.
fn cast_ray<'a>(
    targets: &Targets,
    ray: Ray,
    primitives: impl IntoIterator<Item = &'a Primitive<'a>>,
    work: &mut impl Count,
) -> u32 {
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
            && is_within(&ray, target, &meeting, &targets.near)
            && is_within(&ray, target, &meeting, &targets.far);
        if seen {
            nearest = Some((primitive, meeting));
        }
    }
    nearest.map_or(NOTHING, |(primitive, _)| primitive.number)
}
