//! The z-buffer: its pictures, depths and counts against a loop of its own over whole-number edge
//! functions, and coverage around an eye that a solid encloses.
#![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use ombra_hsr::z_buffer::{
    Colours, Cull, Depth16, Depth24, Depth32F, DepthBuffer, DepthFormat, Options, ReversedDepth32F,
    counted,
};
use ombra_math::camera::Camera;
use ombra_math::glam::{DMat4, DVec3, dvec3};
use ombra_math::mesh::Mesh;
use ombra_math::solids::sphere;
use ombra_math::view::{Viewport, frustum, frustum_infinite, look_at, orthographic, perspective};
use ombra_math::work::Work;
use ombra_raster::buffers::{self, image::Luma};
use ombra_tests::cases::Random;

/// A triangle in the picture: corners in 1/256 of a pixel, and what the format stores there before rounding.
struct Snapped {
    corners: [[i64; 2]; 3],
    values: [f64; 3],
}

/// `None` for a corner outside near and far, or so near to half a step that its own rounding decides.
fn snapped(corners: [DVec3; 3], camera: &Camera, reversed: bool) -> Option<Snapped> {
    let m = camera.view_projection.transpose().to_cols_array_2d();
    let clip = corners.map(|p| m.map(|row| row[0] * p.x + row[1] * p.y + row[2] * p.z + row[3]));
    let Viewport { width, height } = camera.viewport;
    let mut places = [[0; 2]; 3];
    for (place, [x, y, z, w]) in places.iter_mut().zip(clip) {
        let pixel = [
            (x / w + 1.0) / 2.0 * f64::from(width),
            (1.0 - y / w) / 2.0 * f64::from(height),
        ];
        for (whole, share) in place.iter_mut().zip(pixel.map(|v| v * 256.0 + 0.5)) {
            let clear = (share - share.round()).abs() > 1e-6 && share.abs() < 256.0 * 16384.0;
            if !(clear && w > 0.0 && z.abs() <= w) {
                return None;
            }
            *whole = share.floor() as i64;
        }
    }
    let values = clip.map(|[_, _, z, w]| {
        if reversed {
            (w - z) / (2.0 * w)
        } else {
            (w + z) / (2.0 * w)
        }
    });
    Some(Snapped {
        corners: places,
        values,
    })
}

/// The value at the centre of pixel (x, y), if the triangle owns it.
fn at_centre(triangle: &Snapped, x: u32, y: u32) -> Option<f64> {
    let p = [256 * i64::from(x) + 128, 256 * i64::from(y) + 128];
    let turn = |a: [i64; 2], b: [i64; 2], p: [i64; 2]| {
        i128::from(b[0] - a[0]) * i128::from(p[1] - a[1])
            - i128::from(b[1] - a[1]) * i128::from(p[0] - a[0])
    };
    let [a, b, c] = triangle.corners;
    let area = turn(a, b, c);
    let mut value = 0.0;
    for (corner, [from, to]) in [[b, c], [c, a], [a, b]].into_iter().enumerate() {
        // y down: clockwise is positive, and a side on the left runs up.
        let [from, to] = if area > 0 { [from, to] } else { [to, from] };
        let share = turn(from, to, p);
        let top_or_left = to[1] < from[1] || (to[1] == from[1] && to[0] > from[0]);
        if area == 0 || share < 0 || (share == 0 && !top_or_left) {
            return None;
        }
        value += share as f64 / area.abs() as f64 * triangle.values[corner];
    }
    Some(value)
}

fn cameras(random: &mut Random, viewport: Viewport) -> Camera {
    let eye = dvec3(
        random.between(-3.0, 3.0),
        random.between(-3.0, 3.0),
        random.between(4.0, 9.0),
    );
    let view = look_at(eye, dvec3(0.3, -0.2, 0.0), DVec3::Y).unwrap();
    let near = [0.1, 1.0, 1e-3][random.below(3) as usize];
    let low = random.between(-2.0, 0.2);
    let projection: DMat4 = match random.below(4) {
        0 => perspective(
            random.between(0.3, 2.0),
            1.3,
            near,
            random.between(15.0, 1000.0),
        ),
        1 => frustum(near * low, near * 1.1, -0.7 * near, near * 0.4, near, 30.0),
        2 => frustum_infinite(near * low, near, near * low, near, near),
        _ => orthographic(-3.0, 2.0, -2.5, 3.0, 0.5, 20.0),
    }
    .unwrap();
    Camera {
        view_projection: projection * view,
        viewport,
    }
}

/// `steps`: 2ᵇ − 1, or none in floating point.
fn against_own_loop<F: DepthFormat>(steps: Option<f64>, seed: u64) -> usize {
    let mut random = Random::new(seed);
    let mut compared = 0;
    for case in 0..300 {
        let viewport = Viewport {
            width: 1 + random.below(30),
            height: 1 + random.below(30),
        };
        let camera = cameras(&mut random, viewport);
        let size = [2.0, 0.3, 0.05][random.below(3) as usize];
        let count = 1 + random.below(10);
        let positions: Vec<DVec3> = (0..count)
            .flat_map(|_| {
                let middle = 2.0 * random.direction();
                [(); 3].map(|()| middle + size * random.direction())
            })
            .collect();
        let mesh = Mesh::new(
            positions,
            (0..count).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect(),
        )
        .unwrap();
        let triangles: Option<Vec<Snapped>> = (0..count as usize)
            .map(|i| snapped(mesh.triangle(i).unwrap(), &camera, F::REVERSED))
            .collect();
        let Some(triangles) = triangles else { continue };
        let mut picture = buffers::new(viewport.width, viewport.height, Luma([u32::MAX])).unwrap();
        let mut depth = DepthBuffer::<F>::new(viewport.width, viewport.height).unwrap();
        let ids: Vec<_> = (0..count).map(|i| Luma([i])).collect();
        let mut work = Work::default();
        let colours = Colours::PerTriangle(&ids);
        counted::draw(
            &mesh,
            &camera,
            colours,
            Options::default(),
            &mut picture,
            &mut depth,
            &mut work,
        )
        .unwrap();
        let mut fragments = 0;
        for (x, y) in (0..viewport.height).flat_map(|y| (0..viewport.width).map(move |x| (x, y))) {
            // Stored value, how sure its rounding is, and the triangle: the nearest, the first of equals.
            let mut nearest = (if F::REVERSED { 0.0 } else { 1.0 }, u32::MAX);
            let mut sure = true;
            for (i, triangle) in triangles.iter().enumerate() {
                let Some(value) = at_centre(triangle, x, y) else {
                    continue;
                };
                fragments += 1;
                let (stored, step) = match steps {
                    Some(steps) => ((value * steps).round_ties_even() / steps, 1.0 / steps),
                    None => {
                        let single = value as f32;
                        (f64::from(single), f64::from(single.next_up() - single))
                    }
                };
                // Two dozen roundings of numbers up to 1 between the corners and here.
                sure &= ((value - stored).abs() - step / 2.0).abs() > 24.0 * f64::EPSILON;
                if if F::REVERSED {
                    stored > nearest.0
                } else {
                    stored < nearest.0
                } {
                    nearest = (stored, i as u32);
                }
            }
            if !sure {
                continue;
            }
            compared += 1;
            assert_eq!(
                picture.get_pixel(x, y).0,
                [nearest.1],
                "{}, {case}: ({x}, {y})",
                F::NAME
            );
            let stored = depth.depth(x, y).unwrap();
            let expected = if F::REVERSED {
                1.0 - nearest.0
            } else {
                nearest.0
            };
            assert!(
                (stored - expected).abs() <= f64::EPSILON,
                "{}, {case}: {stored}, not {expected}",
                F::NAME
            );
        }
        assert_eq!(
            (work.fragments, work.depth_tests),
            (fragments, fragments),
            "{case}"
        );
    }
    compared
}

#[test]
fn pictures_depths_and_counts_of_all_formats() {
    assert!(against_own_loop::<Depth16>(Some(65_535.0), 1) > 20_000);
    assert!(against_own_loop::<Depth24>(Some(16_777_215.0), 2) > 20_000);
    assert!(against_own_loop::<Depth32F>(None, 3) > 20_000);
    assert!(against_own_loop::<ReversedDepth32F>(None, 4) > 20_000);
}

/// Round the eye a ball with dents and spikes: every sight line leaves it once, so every pixel is a fragment of one
/// triangle, whatever lies behind the eye, off the screen or millions of pixels away.
#[test]
fn a_solid_round_the_eye_covers_every_pixel_once() {
    let mut random = Random::new(5);
    for case in 0..400 {
        let mut ball = sphere(1.0, 3 + random.below(12), 2 + random.below(8)).unwrap();
        for p in &mut ball.positions {
            *p *= random.between(0.05, 20.0);
        }
        let planes = (0..ball.triangles.len()).map(|i| {
            let [a, b, c] = ball.triangle(i).unwrap();
            let normal = (b - a).cross(c - a);
            normal.dot(a).abs() / normal.length()
        });
        let clearance = planes.fold(f64::INFINITY, f64::min);
        let viewport = Viewport {
            width: 1 + random.below(90),
            height: 1 + random.below(90),
        };
        // From telescopes of a thousandth of a degree to nearly all that is ahead.
        let half = random.exponential(-16, 3).abs();
        // The corners of the near plane are nearer than any side.
        let near = 0.9 * clearance / (1.0 + 2.0 * half * half).sqrt();
        let reach = half * near;
        let projection = frustum(-reach, reach, -reach, reach, near, 30.0).unwrap();
        let Ok(view) = look_at(DVec3::ZERO, random.direction(), random.direction()) else {
            continue;
        };
        let camera = Camera {
            view_projection: projection * view,
            viewport,
        };
        let mut depth =
            DepthBuffer::<ReversedDepth32F>::new(viewport.width, viewport.height).unwrap();
        let mut work = Work::default();
        counted::draw_depth(&ball, &camera, Cull::Nothing, &mut depth, &mut work).unwrap();
        assert_eq!(
            work.fragments,
            u64::from(viewport.width * viewport.height),
            "{case}"
        );
        assert!(depth.image().pixels().all(|p| p.0[0] > 0.0), "{case}");
    }
}
