//! A solid as a picture made of pixels, by the z-buffer, and those parts of its edges that nothing in it hides.

use ombra_hsr::z_buffer::{Colours, Depth32F, DepthBuffer, Options, draw as draw_mesh};
use ombra_math::camera::Camera;
use ombra_math::glam::{DMat4, DVec2, DVec3, DVec4};
use ombra_math::mesh::Mesh;
use ombra_math::view::Viewport;
use ombra_raster::buffers;
use ombra_raster::buffers::image::{ImageBuffer, Rgba};
use ombra_raster::triangle::cover;

use super::Solid;
use crate::colour::Ink;
use crate::drawing::Picture;
use crate::error::FigureError;
use crate::path::{Path, Rect};
use crate::sheet::Sheet;
use crate::space::View;

/// Samples across and down a pixel.
const SAMPLES: u32 = 2;
/// Most pixels along the shorter side of the canvas; a larger picture is spread over more.
const FINEST: f64 = 2000.0;
/// An edge is seen that lies no farther behind its surroundings than this part of the range of depth.
const ON_IT: f64 = 1e-4;

/// Draws the faces; the path is that of the edges that are seen.
///
/// # Errors
///
/// [`FigureError::Scene`] when the picture has no room in memory or a vertex is too far away.
pub(super) fn draw(sheet: &mut Sheet, view: &View, solid: &Solid) -> Result<Path, FigureError> {
    let canvas = sheet.canvas();
    let pixel = 1000.0 / f64::from(sheet.style().size.shorter()).min(FINEST);
    let corners = || solid.faces.iter().flat_map(|face| face.corners);
    let places = corners().filter_map(|p| view.project(p));
    let Some(place) = bounds(places, pixel, canvas) else {
        return Ok(Path::new());
    };
    let size = (place.size() / pixel).round().as_uvec2();
    let viewport = Viewport {
        width: size.x * SAMPLES,
        height: size.y * SAMPLES,
    };
    let depths = corners().map(|p| view.depth(p));
    let (near, far) = depths.fold((f64::INFINITY, 0.0_f64), |(near, far), depth| {
        (near.min(depth), far.max(depth))
    });
    let camera = Camera {
        view_projection: projection(view, place, [0.999 * near, 1.001 * far]),
        viewport,
    };

    let wrong = |reason: String| FigureError::Scene { reason };
    let triangles = (0..).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]);
    let triangles = triangles.take(solid.faces.len()).collect();
    let mesh = Mesh::new(corners().collect(), triangles).map_err(|e| wrong(e.to_string()))?;
    let palette = sheet.style().palette();
    let colour = |rgb: u32| Rgba([(rgb >> 16) as u8, (rgb >> 8) as u8, rgb as u8, 255]);
    let colours: Vec<Rgba<u8>> = solid
        .faces
        .iter()
        .map(|f| colour(f.ink.rgb(palette)))
        .collect();
    let no_room = |error: buffers::BufferError| wrong(error.to_string());
    let (width, height) = (viewport.width, viewport.height);
    let mut picture = buffers::new(width, height, Rgba([0; 4])).map_err(no_room)?;
    let mut depth: DepthBuffer<Depth32F> = DepthBuffer::new(width, height).map_err(no_room)?;
    let colours = Colours::PerTriangle(&colours);
    let options = Options::default();
    draw_mesh(&mesh, &camera, colours, options, &mut picture, &mut depth)
        .map_err(|error| wrong(error.to_string()))?;

    sheet.picture(place, averaged(&picture));
    Ok(visible(view, solid, &camera, &depth))
}

/// Draws convex polygons of the canvas in one ink, their union.
pub(crate) fn flat(sheet: &mut Sheet, polygons: &[Vec<DVec2>], ink: impl Into<Ink>) {
    let pixel = 1000.0 / f64::from(sheet.style().size.shorter()).min(FINEST);
    let places = polygons.iter().flatten().copied();
    let Some(place) = bounds(places, pixel, sheet.canvas()) else {
        return;
    };
    let size = (place.size() / pixel).round().as_uvec2() * SAMPLES;
    let rgb = ink.into().rgb(sheet.style().palette());
    let on = Rgba([(rgb >> 16) as u8, (rgb >> 8) as u8, rgb as u8, 255]);
    let Ok(mut samples) = buffers::new(size.x, size.y, Rgba([0; 4])) else {
        return;
    };
    let scale = f64::from(SAMPLES) / pixel;
    for polygon in polygons {
        let [first, rest @ ..] = &polygon[..] else {
            continue;
        };
        for pair in rest.windows(2) {
            let &[a, b] = pair else { continue };
            let triangle = [*first, a, b].map(|p| (p - place.min) * scale);
            let Ok(spans) = cover(triangle, size.x, size.y) else {
                continue;
            };
            for pixel in spans.flat_map(|span| span.pixels()) {
                if let Some(sample) = samples.get_pixel_mut_checked(pixel.x, pixel.y) {
                    *sample = on;
                }
            }
        }
    }
    sheet.picture(place, averaged(&samples));
}

/// The part of the canvas that points lie in, grown to whole pixels.
fn bounds(points: impl Iterator<Item = DVec2>, pixel: f64, canvas: DVec2) -> Option<Rect> {
    let (low, high) = points.fold((canvas, DVec2::ZERO), |(low, high), p| {
        (low.min(p), high.max(p))
    });
    let low = (low / pixel).floor() * pixel;
    let high = (high / pixel).ceil() * pixel;
    let (low, high) = (low.max(DVec2::ZERO), high.min(canvas));
    (low.x < high.x && low.y < high.y).then_some(Rect::new(low, high))
}

/// The perspective of `view` on the part of the canvas that is `place`.
pub(super) fn projection(view: &View, place: Rect, [near, far]: [f64; 2]) -> DMat4 {
    let [across, down, along] = view.rows();
    // Over the distance along the view, the first two give places on the canvas: to −1 … 1, up positive.
    let (size, low) = (place.size(), place.min);
    let x = (across - low.x * along) * (2.0 / size.x) - along;
    let y = along - (down - low.y * along) * (2.0 / size.y);
    let z = along * ((far + near) / (far - near)) + DVec4::W * (-2.0 * far * near / (far - near));
    DMat4::from_cols(x, y, z, along).transpose()
}

/// The mean of the samples of each pixel.
fn averaged(samples: &ImageBuffer<Rgba<u8>, Vec<u8>>) -> Picture {
    let size = (samples.width() / SAMPLES, samples.height() / SAMPLES);
    let mut rgba = Vec::new();
    for y in 0..size.1 {
        for x in 0..size.0 {
            let mut sum = [0_u32; 4];
            for (i, j) in (0..SAMPLES).flat_map(|j| (0..SAMPLES).map(move |i| (i, j))) {
                let sample = samples.get_pixel_checked(x * SAMPLES + i, y * SAMPLES + j);
                for (sum, channel) in sum.iter_mut().zip(sample.map_or([0; 4], |s| s.0)) {
                    *sum += u32::from(channel);
                }
            }
            let half = SAMPLES * SAMPLES / 2;
            rgba.extend(sum.map(|sum| ((sum + half) / (SAMPLES * SAMPLES)) as u8));
        }
    }
    Picture { size, rgba }
}

/// The parts of edges where not all samples around are nearer.
fn visible(view: &View, solid: &Solid, camera: &Camera, depth: &DepthBuffer<Depth32F>) -> Path {
    let mut path = Path::new();
    for ends in &solid.edges {
        let [Some(a), Some(b)] = ends.map(|p| camera.to_pixel(p)) else {
            continue;
        };
        let [Some(from), Some(to)] = ends.map(|p| view.project(p)) else {
            continue;
        };
        let is_seen = |p: DVec3| {
            let near = |i: f64, j: f64| {
                let (x, y) = (p.x + i, p.y + j);
                let inside = x >= 0.0 && y >= 0.0;
                let stored = inside.then(|| depth.depth(x as u32, y as u32)).flatten();
                stored.is_none_or(|stored| stored + ON_IT >= p.z)
            };
            [-1.0, 0.0, 1.0]
                .iter()
                .any(|&j| [-1.0, 0.0, 1.0].iter().any(|&i| near(i, j)))
        };
        // A step is at most a sample long.
        let steps = (b - a)
            .truncate()
            .abs()
            .max_element()
            .ceil()
            .clamp(1.0, 65_536.0) as u32;
        let mut run: Option<[u32; 2]> = None;
        for i in 0..=steps + 1 {
            let t = f64::from(i) / f64::from(steps);
            if i <= steps && is_seen(a.lerp(b, t)) {
                run = Some([run.map_or(i, |[first, _]| first), i]);
            } else if let Some(run) = run.take() {
                let [start, end] = run.map(|i| from.lerp(to, f64::from(i) / f64::from(steps)));
                if start != end {
                    path.add_polyline(&[start, end]);
                }
            }
        }
    }
    path
}
