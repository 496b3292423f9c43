//! Image space: a ray a pixel, the nearest hit wins.
//!
//! For each pixel a ray runs away from the eye, is intersected with the plane of every primitive, and the nearest
//! intersection that lies inside its primitive and in front gives the pixel its primitive: n·m pixels and k primitives
//! take n·m·k intersections.
//! Nothing is sorted, clipped or projected, and every decision is exact: this is the reference for the other methods.
#![cfg_attr(doc, doc = "")]
#![cfg_attr(doc, doc = include_str!("../figures/image-space-ray.svg"))]
#![doc(alias = "ray casting")]
#![doc(alias = "raycasting")]
#![doc(alias = "ray tracing")]

mod about;
mod fast;
mod primitive;
mod ray;

use core::cmp::Ordering;

use ombra_math::camera::{Camera, SightLine};
use ombra_math::glam::UVec2;
use ombra_math::work::{Count, Counter};

use crate::picture::{IdBuffer, NOTHING, PictureError, background};
use crate::polygon::Polygon;
use primitive::{Primitive, Targets};
use ray::{Meeting, Met, Ray, is_within, order};

/// [`cast`] as the slide tells it: every ray with every primitive.
///
/// Counts n·m rays and n·m·k intersections with planes, k the primitives that have one.
///
/// # Errors
///
/// As [`cast`].
///
/// # Examples
///
/// ```
/// use ombra_hsr::image_space::cast_plain;
/// use ombra_hsr::picture::polygons;
/// use ombra_math::camera::Camera;
/// use ombra_math::glam::DMat4;
/// use ombra_math::solids::tetrahedron;
/// use ombra_math::view::Viewport;
/// use ombra_math::work::Work;
///
/// let camera = Camera { view_projection: DMat4::IDENTITY, viewport: Viewport { width: 30, height: 20 } };
/// let mut work = Work::default();
/// cast_plain(&polygons(&tetrahedron()), &camera, &mut work).unwrap();
/// assert_eq!((work.rays, work.intersections), (30 * 20, 30 * 20 * 4));
/// ```
pub fn cast_plain(
    polygons: &[Polygon],
    camera: &Camera,
    work: &mut impl Count,
) -> Result<IdBuffer, PictureError> {
    let mut picture = background(camera)?;
    let targets = Targets::new(polygons, camera)?;
    for (x, y, pixel) in picture.enumerate_pixels_mut() {
        // The ray from the eye through the centre of the pixel.
        let (_, ray) = targets.ray(UVec2::new(x, y))?;
        work.add(Counter::Rays, 1);
        let mut nearest: Option<(&Primitive, Meeting)> = None;
        for primitive in &targets.primitives {
            // Where it comes through the plane of the primitive.
            let target = &primitive.target;
            work.add(Counter::Intersections, 1);
            let Some(meeting) = target.meet(&ray) else {
                continue;
            };
            // The nearest of all intersections is seen …
            let is_nearer = nearest.as_ref().is_none_or(|(best, m)| {
                order(&ray, (target, &meeting), (&best.target, m)) == Ordering::Less
            });
            // … that lie inside their primitive and in the view volume.
            if is_nearer
                && primitive.holds(&ray)
                && is_within(&ray, target, &meeting, &targets.near)
                && is_within(&ray, target, &meeting, &targets.far)
            {
                nearest = Some((primitive, meeting));
            }
        }
        pixel.0 = [nearest.map_or(NOTHING, |(primitive, _)| primitive.number)];
    }
    Ok(picture)
}

/// The picture by a ray a pixel: at each the nearest primitive within the view volume, near and far planes included.
///
/// # Properties
///
/// As for [`hits`], along the sight lines of the pixels' centres as [`Camera::sight_line`] rounds them; a tie goes to
/// the polygon submitted first. They begin on the near plane, the slide's rays at the eye: of what lies in the view
/// volume the nearest is the same.
///
/// A ray is only intersected with the primitives whose outline in the picture lies about its pixel; rows of pixels run
/// in parallel with the feature `parallel`. Equal to [`cast_plain`]: outlines are widened by their rounding, and a ray
/// that rounding may carry off its pixel is intersected with all.
///
/// # Pitfalls
///
/// A sight line through the border of a primitive is inside, where a rasterizer asks the top-left rule: pictures differ
/// there. The line through a pixel's centre is rounded, so a centre on the border may be on either side.
/// What lies *in* the near or the far plane is seen or not as the matrix rounds those planes.
///
/// # Errors
///
/// A picture that is too large, a camera without an eye, a pixel without a sight line (the first, row by row), more
/// primitives than numbers.
///
/// # Examples
///
/// ```
/// use ombra_hsr::image_space::cast;
/// use ombra_hsr::polygon::Polygon;
/// use ombra_math::camera::Camera;
/// use ombra_math::glam::DVec3;
/// use ombra_math::view::{Viewport, frustum};
///
/// let square = |half: f64, z: f64| Polygon {
///     vertices: [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)]
///         .map(|(x, y)| DVec3::new(half * x, half * y, z))
///         .to_vec(),
/// };
/// let camera = Camera {
///     view_projection: frustum(-2.0, 2.0, -2.0, 2.0, 1.0, 9.0).unwrap(),
///     viewport: Viewport { width: 4, height: 4 },
/// };
/// // The nearer one hides the middle of the other; the third lies behind the eye.
/// let picture = cast(&[square(3.5, -2.0), square(1.0, -1.5), square(1.0, 1.5)], &camera).unwrap();
/// assert_eq!(picture.into_raw(), [
///     0, 0, 0, 0,
///     0, 1, 1, 0,
///     0, 1, 1, 0,
///     0, 0, 0, 0,
/// ]);
/// ```
///
/// # References
///
/// Grafica 3, «Approccio Image-Space». A. Appel, «Some techniques for shading machine renderings of solids», 1968.
pub fn cast(polygons: &[Polygon], camera: &Camera) -> Result<IdBuffer, PictureError> {
    fast::cast(polygons, camera, &mut ())
}

/// Where a sight line meets a primitive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// The primitive, as an index into the polygons.
    pub primitive: usize,
    /// The parameter along the line, 0 at its origin.
    pub t: f64,
}

/// [`hits`], counting the ray and its intersections with planes.
///
/// # Properties
///
/// - Error: that of `hits`
#[must_use]
pub fn hits_plain(polygons: &[Polygon], line: SightLine, work: &mut impl Count) -> Vec<Hit> {
    let Some(ray) = Ray::new(line) else {
        return Vec::new();
    };
    work.add(Counter::Rays, 1);
    // Collect the intersections,
    let mut found = Vec::new();
    for (index, polygon) in polygons.iter().enumerate() {
        let Some(primitive) = Primitive::new(polygon) else {
            continue;
        };
        let target = primitive.target;
        work.add(Counter::Intersections, 1);
        if let Some(meeting) = target.meet(&ray)
            && !meeting.is_behind
            && primitive.holds(&ray)
        {
            found.push(Met {
                index,
                target,
                meeting,
            });
        }
    }
    // and put the nearest first.
    ray::sort(&ray, &mut found);
    let hit = |met: Met| Hit {
        primitive: met.index,
        t: met.meeting.t,
    };
    found.into_iter().map(hit).collect()
}

/// All primitives that a sight line meets, the nearest first.
///
/// # Formula
///
/// ```text
/// O + t D on the plane n·X + d = 0:     t = −(n·O + d) / n·D
/// inside a convex primitive  ⇔  D·((Vᵢ − O) × (Vᵢ₊₁ − O)) has one sign for all its sides
/// in front  ⇔  t ≥ 0
/// ```
///
/// # Properties
///
/// - Exact in every decision: inside or not (the border is inside), in front or not, nearer or not, for coordinates of
///   0 or between 10⁻⁷⁵ and 10⁷⁵. Beyond, among primitives whose t rounds to the same double the first submitted may
///   come before a nearer one.
/// - At equal depth the primitive with the smaller index comes first.
/// - The plane is that of [`Polygon::span`].
/// - Error: 2⁻⁴⁰ · t + the smallest double
/// - k primitives take k intersections, and k log k comparisons whatever depth they share.
/// - A primitive along the line is not met: seen edge-on, it has no inside. Nor is one without a plane, or whose t is
///   beyond the largest double.
///
/// # Pitfalls
///
/// The nearest intersection with the *planes* of the primitives is not what is seen (errata [E23](crate#e23)): a plane goes on
/// beside its primitive and behind the eye. Two primitives that are coplanar but for the rounding of their vertices are
/// at different depths, and both may be seen, in patches.
///
/// # Examples
///
/// A near triangle beside the line, whose plane the line meets first:
///
/// ```
/// use ombra_hsr::image_space::{Hit, hits};
/// use ombra_hsr::polygon::Polygon;
/// use ombra_math::camera::SightLine;
/// use ombra_math::glam::DVec3;
///
/// let triangle = |x: f64, z: f64| Polygon {
///     vertices: vec![DVec3::new(x, 0.0, z), DVec3::new(x + 4.0, 0.0, z), DVec3::new(x, 4.0, z)],
/// };
/// let scene = [triangle(5.0, -1.0), triangle(0.0, -3.0), triangle(0.0, -2.0), triangle(0.0, 1.0)];
/// let line = SightLine { origin: DVec3::new(1.0, 1.0, 0.0), direction: -DVec3::Z };
/// let found = hits(&scene, line);
/// assert_eq!(found, [Hit { primitive: 2, t: 2.0 }, Hit { primitive: 1, t: 3.0 }]);
/// ```
///
/// # References
///
/// Grafica 3, «Approccio Image-Space»: the intersections are collected, then the one at the least distance is chosen.
#[doc(alias = "intersection")]
#[must_use]
pub fn hits(polygons: &[Polygon], line: SightLine) -> Vec<Hit> {
    hits_plain(polygons, line, &mut ())
}

/// The same answers, each counting its work.
pub mod counted {
    pub use super::fast::cast;
    pub use super::hits_plain as hits;
}

#[cfg(test)]
mod tests;
