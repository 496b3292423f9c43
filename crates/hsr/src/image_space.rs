//! Image space: a ray a pixel, the nearest hit wins.
//!
//! For each pixel a ray runs away from the eye, is intersected with the plane of every primitive, and the nearest
//! intersection that lies inside its primitive and in front gives the pixel its primitive: n·m pixels and k primitives
//! take n·m·k intersections.
//! Nothing is sorted, clipped or projected, and every decision is exact: this is the reference for the other methods.
#![cfg_attr(doc, doc = "")]
#![cfg_attr(doc, doc = include_str!("../figures/image-space-ray.svg"))]

mod about;
mod ray;

use core::cmp::Ordering;

use ombra_math::camera::{Camera, SightLine};
use ombra_math::glam::{DVec3, UVec2};
use ombra_math::work::{Count, Counter, Work};
#[cfg(feature = "parallel")]
use rayon::prelude::*;

use crate::picture::{IdBuffer, NOTHING, PictureError, background, number};
use crate::polygon::Polygon;
use about::{is_true, pixel_box};
use ray::{Meeting, Ray, Target, is_within, order};

/// Where a sight line meets a primitive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// The primitive, as an index into the polygons.
    pub primitive: usize,
    /// The parameter along the line, 0 at its origin.
    pub t: f64,
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
///   0 or between 10⁻⁷⁵ and 10⁷⁵; beyond, primitives whose t rounds to the same double may come in either order.
/// - At equal depth the primitive with the smaller index comes first.
/// - The plane is that of [`Polygon::span`]. The relative error of t is at most 2⁻⁴⁰.
/// - A primitive along the line is not met: seen edge-on, it has no inside. Nor is one without a plane, or whose t is
///   beyond the largest double.
///
/// # Pitfalls
///
/// The nearest intersection with the *planes* of the primitives is not what is seen (errata E23): a plane goes on
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
#[must_use]
pub fn hits(polygons: &[Polygon], line: SightLine) -> Vec<Hit> {
    hits_counted(polygons, line, &mut ())
}

/// [`hits`], counting the ray and its intersections with planes.
#[must_use]
pub fn hits_counted(polygons: &[Polygon], line: SightLine, work: &mut impl Count) -> Vec<Hit> {
    let Some(ray) = Ray::new(line) else {
        return Vec::new();
    };
    work.add(Counter::Rays, 1);
    let mut found: Vec<(usize, Target, Meeting)> = Vec::new();
    for (index, polygon) in polygons.iter().enumerate() {
        let Some(primitive) = Primitive::new(polygon) else {
            continue;
        };
        work.add(Counter::Intersections, 1);
        if let Some(meeting) = primitive.target.meet(&ray)
            && meeting.t >= 0.0
            && primitive.holds(&ray)
        {
            found.push((index, primitive.target, meeting));
        }
    }
    found.sort_by(|(_, _, m), (_, _, n)| m.t.total_cmp(&n.t));
    // What rounding has mixed up lies side by side.
    for end in 1..found.len() {
        for at in (1..=end).rev() {
            let [(i, a, m), (j, b, n)] = &found[at - 1..=at] else {
                break;
            };
            if order(&ray, (a, m), (b, n)).then(i.cmp(j)) != Ordering::Greater {
                break;
            }
            found.swap(at - 1, at);
        }
    }
    let hit = |(primitive, _, meeting): (usize, Target, Meeting)| Hit {
        primitive,
        t: meeting.t,
    };
    found.into_iter().map(hit).collect()
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
/// A picture that is too large, a camera without an eye, a pixel without a sight line, more primitives than numbers.
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
    cast_counted(polygons, camera, &mut ())
}

/// [`cast`], counting rays and their intersections with planes: those that were not left out.
///
/// # Errors
///
/// As [`cast`].
pub fn cast_counted(
    polygons: &[Polygon],
    camera: &Camera,
    work: &mut impl Count,
) -> Result<IdBuffer, PictureError> {
    let mut picture = background(camera)?;
    let scene = Scene::new(polygons, camera)?;
    let width = camera.viewport.width.max(1) as usize;
    let row = |(y, row): (usize, &mut [u32])| {
        let mut work = Work::default();
        scene.cast_row(y as u32, row, &mut work).map(|()| work)
    };
    #[cfg(feature = "parallel")]
    let counted: Result<Vec<Work>, PictureError> =
        picture.par_chunks_mut(width).enumerate().map(row).collect();
    #[cfg(not(feature = "parallel"))]
    let counted: Result<Vec<Work>, PictureError> =
        picture.chunks_mut(width).enumerate().map(row).collect();
    for row in counted? {
        for &what in Counter::ALL {
            work.add(what, row.get(what));
        }
    }
    Ok(picture)
}

/// [`cast`] as the slide tells it: every ray with every primitive.
///
/// # Errors
///
/// As [`cast`].
pub fn cast_plain(polygons: &[Polygon], camera: &Camera) -> Result<IdBuffer, PictureError> {
    cast_plain_counted(polygons, camera, &mut ())
}

/// [`cast_plain`], counting n·m rays and n·m·k intersections with planes, k the primitives that have one.
///
/// # Errors
///
/// As [`cast`].
///
/// # Examples
///
/// ```
/// use ombra_hsr::image_space::cast_plain_counted;
/// use ombra_hsr::picture::polygons;
/// use ombra_math::camera::Camera;
/// use ombra_math::glam::DMat4;
/// use ombra_math::solids::tetrahedron;
/// use ombra_math::view::Viewport;
/// use ombra_math::work::Work;
///
/// let camera = Camera { view_projection: DMat4::IDENTITY, viewport: Viewport { width: 30, height: 20 } };
/// let mut work = Work::default();
/// cast_plain_counted(&polygons(&tetrahedron()), &camera, &mut work).unwrap();
/// assert_eq!((work.rays, work.intersections), (30 * 20, 30 * 20 * 4));
/// ```
pub fn cast_plain_counted(
    polygons: &[Polygon],
    camera: &Camera,
    work: &mut impl Count,
) -> Result<IdBuffer, PictureError> {
    let mut picture = background(camera)?;
    let scene = Scene::new(polygons, camera)?;
    for (x, y, pixel) in picture.enumerate_pixels_mut() {
        let (_, ray) = scene.ray(UVec2::new(x, y))?;
        pixel.0 = [scene.cast_ray(ray, &scene.primitives, work)];
    }
    Ok(picture)
}

/// A primitive, ready for rays.
struct Primitive<'a> {
    /// As it is stored in a picture.
    number: u32,
    corners: &'a [DVec3],
    target: Target,
}

impl<'a> Primitive<'a> {
    /// `None` for a polygon without a plane.
    fn new(polygon: &'a Polygon) -> Option<Self> {
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
    fn holds(&self, ray: &Ray) -> bool {
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
struct Scene<'a> {
    camera: &'a Camera,
    primitives: Vec<Primitive<'a>>,
    /// Where each may be seen: first column and row, last column and row.
    boxes: Vec<[UVec2; 2]>,
    near: Target,
    far: Target,
}

impl<'a> Scene<'a> {
    fn new(polygons: &'a [Polygon], camera: &'a Camera) -> Result<Self, PictureError> {
        let mut primitives = Vec::with_capacity(polygons.len());
        for (id, polygon) in polygons.iter().enumerate() {
            let number = number(id)?;
            primitives.extend(Primitive::new(polygon).map(|primitive| Primitive {
                number,
                ..primitive
            }));
        }
        let boxes = primitives
            .iter()
            .map(|primitive| pixel_box(primitive.corners, camera))
            .collect();
        let (z, w) = (camera.view_projection.row(2), camera.view_projection.row(3));
        Ok(Self {
            camera,
            primitives,
            boxes,
            near: Target::of_coefficients(w + z),
            far: Target::of_coefficients(w - z),
        })
    }

    /// The sight line of a pixel, and the ray it is.
    fn ray(&self, pixel: UVec2) -> Result<(SightLine, Ray), PictureError> {
        let line = self.camera.sight_line(pixel.as_dvec2() + 0.5);
        line.and_then(|line| Some((line, Ray::new(line)?)))
            .ok_or(PictureError::NoSightLine { pixel })
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
                && is_within(&ray, target, &meeting, &self.near)
                && is_within(&ray, target, &meeting, &self.far);
            if seen {
                nearest = Some((primitive, meeting));
            }
        }
        nearest.map_or(NOTHING, |(primitive, _)| primitive.number)
    }

    /// A row of the picture, each ray with the primitives about its pixel only.
    fn cast_row(&self, y: u32, row: &mut [u32], work: &mut Work) -> Result<(), PictureError> {
        let mut about: Vec<(&Primitive, u32, u32)> = Vec::new();
        for (primitive, [low, high]) in self.primitives.iter().zip(&self.boxes) {
            if low.y <= y && y <= high.y {
                about.push((primitive, low.x, high.x));
            }
        }
        for (x, pixel) in (0..).zip(row) {
            let place = UVec2::new(x, y);
            let (line, ray) = self.ray(place)?;
            let last = self.far.meet(&ray).map(|meeting| meeting.t);
            *pixel = if is_true(line, last, place, self.camera) {
                let here = about
                    .iter()
                    .filter(|&&(_, low, high)| low <= x && x <= high)
                    .map(|&(primitive, ..)| primitive);
                self.cast_ray(ray, here, work)
            } else {
                self.cast_ray(ray, &self.primitives, work)
            };
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests;
