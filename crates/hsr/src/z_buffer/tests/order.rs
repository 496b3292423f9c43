//! The order of triangles, threads, transparency.

use ombra_raster::buffers::image::Rgba;

use super::*;
#[cfg(feature = "parallel")]
use crate::z_buffer::fast::{Band, draw_bands};
#[cfg(feature = "parallel")]
use crate::z_buffer::paint::Flat;

const SIZE: (u32, u32) = (48, 40);

fn front() -> Camera {
    Camera {
        view_projection: orthographic(-2.0, 2.0, -2.0, 2.0, -2.0, 2.0).unwrap(),
        viewport: viewport(SIZE.0, SIZE.1),
    }
}

/// The number of the triangle seen at each pixel, and the depths.
fn ids<F: DepthFormat>(mesh: &Mesh, camera: &Camera) -> (Vec<u32>, DepthBuffer<F>) {
    let Viewport { width, height } = camera.viewport;
    let colours: Vec<_> = (0..mesh.triangles.len() as u32)
        .map(|i| Luma([i]))
        .collect();
    let mut picture = buffers::new(width, height, Luma([u32::MAX])).unwrap();
    let mut depth = DepthBuffer::new(width, height).unwrap();
    let colours = Colours::PerTriangle(&colours);
    draw(
        mesh,
        camera,
        colours,
        Options::default(),
        &mut picture,
        &mut depth,
    )
    .unwrap();
    (picture.into_raw(), depth)
}

proptest! {
    /// Whatever the order: the depths are the same, and where only one triangle has the nearest, so is the picture. Where
    /// several have it, the first submitted is seen.
    #[test]
    fn order_decides_ties_alone(mesh in meshes(), camera in cameras(), seed in any::<u64>()) {
        let n = mesh.triangles.len();
        let mut order: Vec<usize> = (0..n).collect();
        order.sort_by_key(|&i| (i as u64 + 1).wrapping_mul(seed | 1) >> 7);
        let shuffled = Mesh {
            triangles: order.iter().map(|&i| mesh.triangles[i]).collect(),
            ..mesh.clone()
        };
        let (picture, depth) = ids::<Depth16>(&mesh, &camera);
        let (other, other_depth) = ids::<Depth16>(&shuffled, &camera);
        prop_assert_eq!(depth.image().as_raw(), other_depth.image().as_raw());
        // The depths of each triangle alone.
        let alone: Vec<_> = mesh.triangles.iter().map(|&t| {
            let one = Mesh { triangles: vec![t], ..mesh.clone() };
            ids::<Depth16>(&one, &camera).1
        }).collect();
        for (i, (&seen, &seen_other)) in picture.iter().zip(&other).enumerate() {
            let nearest = depth.image().as_raw()[i];
            let has_it = |t: usize| nearest < u16::MAX && alone[t].image().as_raw()[i] == nearest;
            let first = (0..n).find(|&t| has_it(t)).map_or(u32::MAX, |t| t as u32);
            let first_other = (0..n).find(|&k| has_it(order[k])).map_or(u32::MAX, |k| k as u32);
            prop_assert_eq!((seen, seen_other), (first, first_other), "pixel {}", i);
        }
    }
}

/// The same triangle twice: in every format and form the first one stays.
#[test]
fn of_equal_depths_the_first_stays() {
    fn check<F: DepthFormat>() {
        let corners = [(-2.0, -2.0, -0.7), (2.0, -2.0, 0.3), (0.0, 2.0, 0.9)].map(DVec3::from);
        let mesh = Mesh::new(corners.to_vec(), vec![[0, 1, 2], [2, 0, 1]]).unwrap();
        for form in [Form::Plain, Form::Fast] {
            let mut picture = buffers::new(SIZE.0, SIZE.1, Luma([9u8])).unwrap();
            let mut depth = DepthBuffer::<F>::new(SIZE.0, SIZE.1).unwrap();
            // One after the other, so that the depths are the same to the last bit.
            for colour in [1, 2] {
                let target = (&mut picture, &mut depth);
                drawn(
                    &Mesh {
                        triangles: vec![mesh.triangles[0]],
                        ..mesh.clone()
                    },
                    &front(),
                    Colours::One(Luma([colour])),
                    Options::default(),
                    target,
                    form,
                    &mut (),
                )
                .unwrap();
            }
            let count = |v: u8| picture.iter().filter(|&&p| p == v).count();
            assert!(count(1) > 900, "{}", F::NAME);
            assert_eq!(count(2), 0, "{} {form:?}", F::NAME);
        }
    }
    check::<Depth16>();
    check::<Depth24>();
    check::<Depth32F>();
    check::<ReversedDepth32F>();
}

/// Many triangles of all sizes, in layers that tie.
fn many(n: u32) -> Mesh {
    let mut random = 1u32;
    let mut next = |below: u32| {
        random = random.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (random >> 8) % below
    };
    let positions = (0..n)
        .map(|_| {
            let [x, y, z] = [next(64), next(64), next(5)].map(f64::from);
            DVec3::new(x / 16.0 - 2.0, y / 16.0 - 2.0, z / 2.0 - 1.0)
        })
        .collect();
    let triangles = (0..n)
        .map(|i| {
            let far = if i % 7 == 0 { next(n) } else { (i + 2) % n };
            [i, (i + 1) % n, far]
        })
        .collect();
    Mesh {
        positions,
        triangles,
    }
}

#[cfg(feature = "parallel")]
#[test]
fn threads_change_nothing() {
    let mesh = many(20_000);
    let n = mesh.triangles.len();
    let colours: Vec<_> = (0..n)
        .map(|i| Rgba([i as u8, (i >> 8) as u8, 7, (i * 13) as u8]))
        .collect();
    let near_cuts = Camera {
        view_projection: frustum(-0.3, 0.3, -0.3, 0.3, 0.3, 4.0).unwrap(),
        viewport: viewport(150, 170),
    };
    let flat = Camera {
        viewport: viewport(150, 170),
        ..front()
    };
    for (camera, blend) in [
        (flat, Blend::Replace),
        (flat, Blend::Over),
        (near_cuts, Blend::Over),
    ] {
        let options = Options {
            blend,
            ..Options::default()
        };
        let run = |form| {
            let mut picture = buffers::new(150, 170, Rgba([0, 0, 0, 255])).unwrap();
            let mut depth = DepthBuffer::<Depth24>::new(150, 170).unwrap();
            let target = (&mut picture, &mut depth);
            drawn(
                &mesh,
                &camera,
                Colours::PerTriangle(&colours),
                options,
                target,
                form,
                &mut (),
            )
            .unwrap();
            (picture.into_raw(), depth.into_image().into_raw())
        };
        let expected = run(Form::Plain);
        assert!(expected.0.iter().filter(|&&v| v > 0).count() > 10_000);
        for threads in [1, 2, 3, 8] {
            let pool = rayon::ThreadPoolBuilder::new()
                .num_threads(threads)
                .build()
                .unwrap();
            assert!(
                pool.install(|| run(Form::Threads)) == expected,
                "{threads} threads"
            );
        }
        assert!(run(Form::Fast) == expected);
    }
}

/// Triangles sorted into bands a few at a time come in the same order.
#[cfg(feature = "parallel")]
#[test]
fn batches_change_nothing() {
    let mesh = many(20_000);
    let (width, height) = (150, 170);
    let camera = Camera {
        viewport: viewport(width, height),
        ..front()
    };
    let projected = Projected::new::<Depth24>(&mesh, &camera, &mut ()).unwrap();
    let colours: Vec<_> = (0..mesh.triangles.len())
        .map(|i| Rgba([i as u8, (i >> 8) as u8, 7, (i * 13) as u8]))
        .collect();
    let paint = Flat {
        colours: Colours::PerTriangle(&colours),
        blend: Blend::Over,
    };
    let run = |batch: Option<usize>| {
        let mut picture = buffers::new(width, height, Rgba([0, 0, 0, 255])).unwrap();
        let mut depth = DepthBuffer::<Depth24>::new(width, height).unwrap();
        let mut whole: Band<'_, Depth24, Flat<'_, Rgba<u8>>> = Band {
            rows: 0..height,
            width,
            depth: depth.values_mut(),
            samples: &mut picture,
        };
        match batch {
            Some(batch) => draw_bands(&projected, Cull::Nothing, paint, whole, 16, batch),
            None => whole.draw(&projected, 0..colours.len(), Cull::Nothing, paint, &mut ()),
        }
        (picture.into_raw(), depth.into_image().into_raw())
    };
    let expected = run(None);
    for batch in [8192, 1 << 20] {
        assert!(run(Some(batch)) == expected, "{batch}");
    }
}

/// Two half transparent squares at one place: the far one shows through the near one only if it is drawn first.
#[test]
fn transparency_depends_on_order() {
    let square = |z: f64| {
        [(-2.0, -2.0), (2.0, -2.0), (2.0, 2.0), (-2.0, 2.0)].map(|(x, y)| DVec3::new(x, y, z))
    };
    let (near, far) = (square(1.0), square(-1.0));
    let faces = [[0, 1, 2], [0, 2, 3], [4, 5, 6], [4, 6, 7]];
    let (red, blue) = (Rgba([255, 0, 0, 128]), Rgba([0, 0, 255, 128]));
    let draw_both = |first: [DVec3; 4], second: [DVec3; 4], colours: [Rgba<u8>; 2]| {
        let mesh = Mesh::new([first, second].concat(), faces.to_vec()).unwrap();
        let [a, b] = colours;
        let mut picture = buffers::new(SIZE.0, SIZE.1, Rgba([255u8; 4])).unwrap();
        let mut depth = DepthBuffer::<Depth24>::new(SIZE.0, SIZE.1).unwrap();
        let options = Options {
            blend: Blend::Over,
            ..Options::default()
        };
        let colours = [a, a, b, b];
        draw(
            &mesh,
            &front(),
            Colours::PerTriangle(&colours),
            options,
            &mut picture,
            &mut depth,
        )
        .unwrap();
        let first = *picture.get_pixel(0, 0);
        assert!(picture.pixels().all(|&p| p == first), "one colour, no seam");
        (first, depth)
    };
    let (back_to_front, depth) = draw_both(far, near, [blue, red]);
    let (front_to_back, depth_too) = draw_both(near, far, [red, blue]);
    // Of white: blue over it, (127, 127, 255); red over that. Red over white alone, the far one is not nearer.
    assert_eq!(back_to_front, Rgba([191, 63, 127, 255]));
    assert_eq!(front_to_back, Rgba([255, 127, 127, 255]));
    assert_eq!(depth.image(), depth_too.image());
}

/// 10⁶ triangles, and a near plane of 10⁻⁹ of far.
#[test]
fn a_million_triangles() {
    let mesh = many(1_000_000);
    let (picture, depth) = ids::<Depth32F>(&mesh, &front());
    let one = Mesh {
        triangles: mesh.triangles.iter().rev().copied().collect(),
        ..mesh
    };
    let (_, reversed) = ids::<Depth32F>(&one, &front());
    // All but the last column and row or two are full.
    assert!(picture.iter().filter(|&&id| id < 1_000_000).count() >= 46 * 38);
    assert_eq!(depth.image(), reversed.image());
}

/// Over what is itself transparent: by hand from α' = α + (1 − α) α_below and C' = (α C + (1 − α) α_below C_below) / α'.
#[test]
fn transparent_over_transparent() {
    let mesh = Mesh::new(
        [(-9.0, -9.0, 0.0), (9.0, -9.0, 0.0), (0.0, 18.0, 0.0)]
            .map(DVec3::from)
            .to_vec(),
        vec![[0, 1, 2]],
    )
    .unwrap();
    // Two fifths over one fifth: 0.52 = 132.6 of 255; (80 + 12) / 0.52 = 176.9.
    let (below, pixel) = (Rgba([100u8, 0, 255, 51]), Rgba([200, 0, 255, 102]));
    let nothing = Rgba([1, 2, 3, 0]);
    for (below, pixel, expected) in [
        (below, pixel, Rgba([177, 0, 255, 133])),
        (nothing, pixel, pixel),
        (below, nothing, below),
        (nothing, Rgba([4, 5, 6, 0]), nothing),
    ] {
        for colours in [Colours::One(pixel), Colours::PerVertex(&[pixel; 3])] {
            for form in [Form::Plain, Form::Fast] {
                let mut picture = buffers::new(SIZE.0, SIZE.1, below).unwrap();
                let mut depth = DepthBuffer::<Depth24>::new(SIZE.0, SIZE.1).unwrap();
                let options = Options {
                    blend: Blend::Over,
                    ..Options::default()
                };
                let target = (&mut picture, &mut depth);
                drawn(&mesh, &front(), colours, options, target, form, &mut ()).unwrap();
                let other = picture.pixels().find(|&&p| p != expected);
                assert_eq!(other, None, "{pixel:?} over {below:?}, {form:?}");
            }
        }
    }
}
