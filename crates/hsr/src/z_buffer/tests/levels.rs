//! The same bits from every set of vector instructions that the machine has.

use fearless_simd::{Level, Simd};
use ombra_math::glam::DMat4;

use super::*;
use crate::z_buffer::fast::{Threads, run};
use crate::z_buffer::paint::{DepthOnly, Flat, Paint, Smooth};

/// From none to the widest.
fn levels() -> Vec<Level> {
    let widest = Level::new();
    let mut levels = vec![Level::baseline(), widest];
    #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
    levels.extend(widest.as_sse4_2().map(Simd::level));
    levels
}

/// Triangles of all sizes and depths; some reach behind the eye.
fn triangles() -> Mesh {
    let mut random = 7u32;
    let mut next = || {
        random = random.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        f64::from(random >> 8) / f64::from(1u32 << 24)
    };
    let mut positions = Vec::new();
    for i in 0..700 {
        let size = [0.02, 0.3, 2.0][i % 3];
        let middle = DVec3::new(next(), next(), next()) * 4.0 - 2.0;
        for _ in 0..3 {
            positions.push(middle + size * (DVec3::new(next(), next(), next()) - 0.5));
        }
    }
    let triangles = (0..700).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
    Mesh::new(positions, triangles).unwrap()
}

fn check<F: DepthFormat + PartialEq>(mesh: &Mesh, camera: &Camera, blend: Blend) {
    let Viewport { width, height } = camera.viewport;
    let many: Vec<_> = (0..mesh.positions.len())
        .map(|i| Rgba([i as u8, (i * 7) as u8, (i >> 4) as u8, (i * 50) as u8]))
        .collect();
    let background = buffers::new(width, height, Rgba([9, 9, 9, 255])).unwrap();
    let far = DepthBuffer::<F>::new(width, height).unwrap();
    for smooth in [false, true] {
        let draw = |level: Level| {
            let projected = Projected::at_level::<F>(mesh, camera, level, &mut ()).unwrap();
            let (mut picture, mut depth) = (background.clone(), far.clone());
            if smooth {
                let paint = Smooth {
                    colours: &many[..],
                    triangles: &mesh.triangles,
                    blend,
                };
                paint_all(&projected, paint, &mut depth, &mut picture);
            } else {
                let colours = Colours::PerTriangle(&many);
                paint_all(
                    &projected,
                    Flat { colours, blend },
                    &mut depth,
                    &mut picture,
                );
            }
            let mut alone = far.clone();
            paint_all(&projected, DepthOnly, &mut alone, &mut []);
            assert_eq!(alone, depth);
            (picture.into_raw(), depth)
        };
        let colours = if smooth {
            Colours::PerVertex(&many)
        } else {
            Colours::PerTriangle(&many[..mesh.triangles.len()])
        };
        let options = Options {
            blend,
            ..Options::default()
        };
        let (mut picture, mut depth) = (background.clone(), far.clone());
        draw_plain(
            mesh,
            camera,
            colours,
            options,
            &mut picture,
            &mut depth,
            &mut (),
        )
        .unwrap();
        let plain = (picture.into_raw(), depth);
        assert!(plain.0.chunks(4).filter(|p| **p != [9, 9, 9, 255]).count() > 1000);
        for level in levels() {
            let name = F::NAME;
            assert!(draw(level) == plain, "{name} {level:?} {blend:?}");
        }
    }
}

fn paint_all<F: DepthFormat, I: Paint>(
    projected: &Projected<'_>,
    paint: I,
    depth: &mut DepthBuffer<F>,
    samples: &mut [I::Sample],
) {
    let (cull, threads) = (Cull::Nothing, Threads::One);
    run(projected, cull, paint, depth, samples, threads, &mut ());
}

#[test]
fn every_level_draws_the_same() {
    let mesh = triangles();
    let flat = Camera {
        view_projection: DMat4::from_scale(DVec3::splat(0.5)),
        viewport: viewport(83, 61),
    };
    let view = look_at(DVec3::new(0.5, 0.7, 1.5), DVec3::ZERO, DVec3::Y).unwrap();
    let near_cuts = Camera {
        view_projection: frustum(-0.1, 0.1, -0.1, 0.1, 0.1, 9.0).unwrap() * view,
        viewport: viewport(83, 61),
    };
    for camera in [flat, near_cuts] {
        for blend in [Blend::Replace, Blend::Over] {
            check::<Depth16>(&mesh, &camera, blend);
            check::<Depth24>(&mesh, &camera, blend);
            check::<Depth32F>(&mesh, &camera, blend);
            check::<ReversedDepth32F>(&mesh, &camera, blend);
        }
    }
    // On the machines that most have there are three of them.
    if cfg!(target_arch = "x86_64") && !Level::new().is_fallback() {
        assert_eq!(levels().len(), 3);
    }
}
