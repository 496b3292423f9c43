//! Where two pictures of one scene differ, and how far from any edge.

use ombra_math::camera::Camera;
use ombra_math::glam::{DVec2, DVec4, UVec2};

use super::{IdBuffer, NOTHING, PictureError, projected};
use crate::polygon::Polygon;

/// How two pictures differ.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Difference {
    /// Pixels that show two different primitives, or one and the background.
    pub pixels: usize,
    /// The largest distance, in pixels, of such a pixel's centre from any edge, or from a line in which one of its two
    /// primitives crosses another; 0 without any.
    pub farthest: f64,
}

/// How two pictures of the same polygons differ.
///
/// # Formula
///
/// Two methods that agree on coverage and depth agree on the picture. So where one sees A and the other B, either A or
/// B covers the pixel for only one of them, and an edge passes close by; or they see A and B at another order of depth,
/// and A and B cross close by. A method that cuts its primitives may leave a crack along the cut, which is an edge of
/// what hides a part of A or B, or the line in which they cross:
///
/// ```text
/// distance = min(to the edges of all primitives, to the lines A ∩ C and B ∩ C for all C)
///                                                               projected, in pixels
/// ```
///
/// # Properties
///
/// Edges are those of what lies in the view volume: a cut at the near plane is one. Distances are rounded: a few ε
/// times the size of the picture to an edge; to A ∩ C that divided by the sine of the angle between A and C in clip
/// space. Where that angle is below 64 ε, A and C are coplanar: if they are A and B they cross everywhere, 0; otherwise
/// nowhere. Every pixel that differs is held against every edge and plane: d (e + k) distances for d pixels, e edges and k
/// polygons.
///
/// # Errors
///
/// Pictures of different sizes. A pixel is infinitely far from the edges where there is no polygon.
///
/// # Examples
///
/// ```
/// use ombra_hsr::picture::{compare, paint};
/// use ombra_hsr::polygon::Polygon;
/// use ombra_math::camera::Camera;
/// use ombra_math::glam::{DMat4, DVec3};
/// use ombra_math::view::Viewport;
///
/// let camera = Camera { view_projection: DMat4::IDENTITY, viewport: Viewport { width: 8, height: 8 } };
/// let triangle = Polygon { vertices: vec![DVec3::ZERO, DVec3::X, DVec3::Y] };
/// let [all, none] = [vec![(0, &triangle)], vec![]].map(|parts| paint(parts, &camera).unwrap());
/// let difference = compare(&all, &none, &[triangle.clone()], &camera).unwrap();
/// // One pixel, two and three; the four centres on the slanted edge belong to what lies right of it.
/// assert_eq!((difference.pixels, difference.farthest < 1.0), (6, true));
/// ```
pub fn compare(
    first: &IdBuffer,
    second: &IdBuffer,
    polygons: &[Polygon],
    camera: &Camera,
) -> Result<Difference, PictureError> {
    let [size, other] = [first, second].map(|picture| UVec2::from(picture.dimensions()));
    if size != other {
        return Err(PictureError::Sizes {
            first: size,
            second: other,
        });
    }
    let mut difference = Difference::default();
    let mut borders = None;
    for ((x, y, a), b) in first.enumerate_pixels().zip(second.pixels()) {
        if a == b {
            continue;
        }
        let borders = borders.get_or_insert_with(|| Borders::new(polygons, camera));
        let centre = UVec2::new(x, y).as_dvec2() + 0.5;
        difference.pixels += 1;
        difference.farthest = difference
            .farthest
            .max(borders.distance([a.0[0], b.0[0]], centre));
    }
    Ok(difference)
}

/// Where a scene's primitives end and cross: the outlines in the picture, the planes in clip space.
struct Borders {
    size: DVec2,
    outlines: Vec<Vec<DVec2>>,
    planes: Vec<Option<DVec4>>,
}

impl Borders {
    fn new(polygons: &[Polygon], camera: &Camera) -> Self {
        Self {
            size: UVec2::new(camera.viewport.width, camera.viewport.height).as_dvec2(),
            outlines: polygons.iter().map(|p| projected(p, camera)).collect(),
            planes: polygons.iter().map(|p| clip_plane(p, camera)).collect(),
        }
    }

    /// From `centre` to the nearest edge, or the nearest line in which one of the two primitives crosses another.
    fn distance(&self, ids: [u32; 2], centre: DVec2) -> f64 {
        let to_edges = self
            .outlines
            .iter()
            .map(|outline| to_outline(outline, centre));
        let mut nearest = to_edges.fold(f64::INFINITY, f64::min);
        for (id, other) in [(ids[0], ids[1]), (ids[1], ids[0])] {
            let Some(&Some(plane)) = self.planes.get(id as usize).filter(|_| id != NOTHING) else {
                continue;
            };
            for (i, second) in self.planes.iter().enumerate() {
                let Some(second) = second else { continue };
                let distance = to_crossing(plane, *second, centre, self.size);
                // Coplanar.
                let distance = distance.unwrap_or(if i == other as usize {
                    0.0
                } else {
                    f64::INFINITY
                });
                nearest = nearest.min(distance);
            }
        }
        nearest
    }
}

fn to_outline(outline: &[DVec2], centre: DVec2) -> f64 {
    let ends = outline.iter().cycle().skip(1);
    outline
        .iter()
        .zip(ends)
        .fold(f64::INFINITY, |least, (&a, &b)| {
            let along = b - a;
            let t = ((centre - a).dot(along) / along.length_squared()).clamp(0.0, 1.0);
            // Of an edge without length, t is NaN.
            let foot = if t.is_nan() { a } else { a + t * along };
            least.min(centre.distance(foot))
        })
}

/// The planes α and β of clip space, with z eliminated: the line (β.z α − α.z β)·(x, y, ·, w) = 0 of the picture.
/// `None` for planes that are the same.
fn to_crossing(a: DVec4, b: DVec4, centre: DVec2, size: DVec2) -> Option<f64> {
    let (a, b) = (a / a.abs().max_element(), b / b.abs().max_element());
    let line = b.z * a - a.z * b;
    // The inverse and the product round a dozen times: less than this is no direction.
    if line.abs().max_element() <= 64.0 * f64::EPSILON {
        return None;
    }
    let turn = DVec2::new(1.0, -1.0);
    let ndc = (2.0 * centre / size - 1.0) * turn;
    let value = line.x * ndc.x + line.y * ndc.y + line.w;
    // How fast it changes a pixel.
    let gradient = DVec2::new(line.x, line.y) * 2.0 / size * turn;
    Some((value / gradient.length()).abs())
}

/// A polygon's plane in clip coordinates: π M⁻¹.
fn clip_plane(polygon: &Polygon, camera: &Camera) -> Option<DVec4> {
    let plane = polygon.plane()?.coefficients();
    let inverse = camera.view_projection.inverse();
    let plane = inverse.transpose() * plane;
    plane.is_finite().then_some(plane)
}
