//! Scenes with hidden surfaces, as the studies of them put them to every method: triangles before one eye, their
//! pictures, and what is seen in truth.

mod truth;

use ombra_hsr::picture::{self, IdBuffer, NOTHING, PictureError, polygons};
use ombra_hsr::polygon::Polygon;
use ombra_hsr::z_buffer::{Colours, Cull, Depth24, DepthBuffer, DepthFormat, Options, counted};
use ombra_hsr::{image_space, object_space, painter};
use ombra_math::camera::Camera;
use ombra_math::glam::{DVec3, DVec4};
use ombra_math::mesh::Mesh;
use ombra_math::view::{Viewport, frustum};
use ombra_math::work::{Count, Counter, Work};
use ombra_raster::buffers::{self, image::Luma};
use rayon::{ThreadPool, ThreadPoolBuilder};

use crate::deviation::Deviation;
use crate::hidden::truth::Truth;

/// The distance of the near plane.
pub const NEAR: f64 = 2.0;
/// The distance of the far plane.
pub const FAR: f64 = 16.0;
/// Coordinates are multiples of 1 / this.
const UNITS: f64 = 65_536.0;
/// The eye of every scene.
pub const EYE: DVec4 = DVec4::W;

/// Triangles between the near and the far plane, seen from the origin along −z through a window of 90°.
pub struct TrianglesInView {
    /// Of side × side pixels.
    pub camera: Camera,
    pub mesh: Mesh,
    /// The same triangles.
    pub polygons: Vec<Polygon>,
    numbers: Vec<Luma<u32>>,
    truth: Truth,
    /// All methods run on one thread.
    thread: Option<ThreadPool>,
}

/// A picture of primitives' numbers; `None` where a method refuses.
pub type Answer = Option<IdBuffer>;

/// The z-buffer with depths of format `F`: the number of the triangle at each pixel.
pub fn draw<F: DepthFormat>(
    mesh: &Mesh,
    camera: &Camera,
    numbers: &[Luma<u32>],
    cull: Cull,
    work: &mut impl Count,
) -> Answer {
    let Viewport { width, height } = camera.viewport;
    let mut picture: IdBuffer = buffers::new(width, height, Luma([NOTHING])).ok()?;
    let mut depth: DepthBuffer<F> = DepthBuffer::new(width, height).ok()?;
    let colours = Colours::PerTriangle(numbers);
    let options = Options {
        cull,
        ..Options::default()
    };
    counted::draw(
        mesh,
        camera,
        colours,
        options,
        &mut picture,
        &mut depth,
        work,
    )
    .ok()?;
    Some(picture)
}

impl TrianglesInView {
    /// Of a mesh in a picture of side × side pixels; positions are moved to multiples of 2⁻¹⁶.
    ///
    /// They must lie between the near and the far plane, and below 32 in every coordinate.
    pub fn new(mesh: Mesh, side: u32) -> Self {
        let on_grid = |p: &DVec3| (*p * UNITS).round() / UNITS;
        let mesh = Mesh {
            positions: mesh.positions.iter().map(on_grid).collect(),
            triangles: mesh.triangles,
        };
        // With these planes there is a matrix.
        let projection = frustum(-NEAR, NEAR, -NEAR, NEAR, NEAR, FAR).unwrap_or_default();
        let viewport = Viewport {
            width: side,
            height: side,
        };
        Self {
            camera: Camera {
                view_projection: projection,
                viewport,
            },
            polygons: polygons(&mesh),
            numbers: (0..mesh.triangles.len() as u32)
                .map(|i| Luma([i]))
                .collect(),
            truth: Truth::new(&mesh, side),
            mesh,
            thread: ThreadPoolBuilder::new().num_threads(1).build().ok(),
        }
    }

    /// How many pixels a picture has.
    pub fn pixels(&self) -> usize {
        let viewport = self.camera.viewport;
        viewport.width as usize * viewport.height as usize
    }

    /// The z-buffer of 24 bits.
    pub fn z_buffer(&self, cull: Cull, work: &mut impl Count) -> Answer {
        self.z_buffered(&self.mesh, &self.numbers, cull, work)
    }

    /// The z-buffer of a part of the mesh, under numbers of its own.
    pub fn z_buffered(
        &self,
        mesh: &Mesh,
        numbers: &[Luma<u32>],
        cull: Cull,
        work: &mut impl Count,
    ) -> Answer {
        draw::<Depth24>(mesh, &self.camera, numbers, cull, work)
    }

    /// Every ray with every primitive.
    pub fn image_space(&self, work: &mut impl Count) -> Answer {
        image_space::cast_plain(&self.polygons, &self.camera, work).ok()
    }

    /// Every ray with the primitives about its pixel.
    pub fn image_space_in_boxes(&self, work: &mut impl Count) -> Answer {
        let cast = || {
            let mut counted = Work::default();
            let picture =
                image_space::counted::cast(&self.polygons, &self.camera, &mut counted).ok();
            (picture, counted)
        };
        let (picture, counted) = self.thread.as_ref()?.install(cast);
        for &what in Counter::ALL {
            work.add(what, counted.get(what));
        }
        picture
    }

    /// The visible parts, painted.
    pub fn object_space(&self, work: &mut impl Count) -> Answer {
        let parts = object_space::counted::visible_parts(&self.polygons, EYE, work);
        self.painted(parts.iter().map(|(i, part)| (*i, part)), work)
    }

    /// The same of some of the primitives.
    pub fn object_space_of(&self, some: &[usize], work: &mut impl Count) -> Answer {
        let polygons = some.iter().filter_map(|&i| self.polygons.get(i).cloned());
        let polygons: Vec<_> = polygons.collect();
        let parts = object_space::counted::visible_parts(&polygons, EYE, work);
        let number = |i: usize| some.get(i).copied().unwrap_or(i);
        self.painted(parts.iter().map(|(i, part)| (number(*i), part)), work)
    }

    /// Back to front, cut where there is no order.
    pub fn painter(&self, work: &mut impl Count) -> Answer {
        let pieces = painter::counted::order_by_cutting(&self.polygons, EYE, work);
        self.painted(pieces.iter().map(|(i, piece)| (*i, piece)), work)
    }

    /// Sorted by the distance of the farthest vertex and painted: the first half of the depth sort for the whole.
    pub fn sort_only(&self, work: &mut impl Count) -> Answer {
        let farthest = |(i, polygon): (usize, &Polygon)| {
            let distances = polygon.vertices.iter().map(|v| v.length_squared());
            (i, distances.fold(0.0, f64::max))
        };
        let mut sorted: Vec<(usize, f64)> =
            self.polygons.iter().enumerate().map(farthest).collect();
        sorted.sort_by(|a, b| {
            work.add(Counter::Comparisons, 1);
            b.1.total_cmp(&a.1)
        });
        let parts = sorted
            .iter()
            .filter_map(|&(i, _)| Some((i, self.polygons.get(i)?)));
        self.painted(parts, work)
    }

    fn painted<'a>(
        &self,
        parts: impl IntoIterator<Item = (usize, &'a Polygon)>,
        work: &mut impl Count,
    ) -> Answer {
        let picture: Result<IdBuffer, PictureError> =
            picture::counted::paint(parts, &self.camera, work);
        picture.ok()
    }

    /// Which pixels of a picture do not show what is seen there. A pixel whose centre is on an edge of what could be
    /// seen there is not asked.
    pub fn deviation(&self, answer: &Answer) -> Deviation {
        self.truth.deviation(answer.as_ref())
    }
}
