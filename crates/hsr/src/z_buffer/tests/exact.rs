//! Which pixels and which depths: against the exact cover and exact rationals.

use num_bigint::BigInt;
use num_rational::BigRational;
use ombra_math::glam::{DMat4, DVec2, DVec4};
use ombra_raster::triangle;

use super::*;
use crate::z_buffer::screen::{Corner, Scene};
use crate::z_buffer::setup::Setup;

type R = BigRational;

fn r(x: f64) -> R {
    R::from_float(x).unwrap()
}

fn int(x: impl Into<BigInt>) -> R {
    R::from_integer(x.into())
}

/// Places in a picture, some far beyond it, some equal, some on pixel centres.
fn place() -> impl Strategy<Value = [i32; 2]> {
    let side = prop_oneof![
        -2000..12_000,
        (-4..44).prop_map(|i| 128 * i),
        -(1 << 24)..(1 << 24)
    ];
    prop::array::uniform2(side)
}

fn corners() -> impl Strategy<Value = [Corner; 3]> {
    let value = prop_oneof![
        0.0..=1.0f64,
        (-1074..1).prop_map(|e| libm::scalbn(1.0, e)),
        Just(0.0)
    ];
    let w = 1.0;
    let corner = (place(), value).prop_map(move |([x, y], value)| Corner { x, y, value, w });
    prop::array::uniform3(corner)
}

proptest! {
    /// The pixels are those of the exact cover of the snapped corners.
    #[test]
    fn coverage_is_exact(corners in corners()) {
        let (width, height) = (40, 36);
        let points = corners.each_ref().map(|c| DVec2::new(f64::from(c.x), f64::from(c.y)) / 256.0);
        let mut expected = vec![false; 40 * 36];
        for span in triangle::cover(points, width, height).unwrap() {
            for x in span.x {
                expected[(span.y * width + x) as usize] = true;
            }
        }
        let setup = Setup::new(corners.each_ref(), Cull::Nothing);
        prop_assert!(setup.is_some() || !expected.contains(&true));
        let Some(setup) = setup else { return Ok(()) };
        let [columns, rows] = setup.bounds(width, height);
        for y in 0..height {
            for x in 0..width {
                let inside = setup.edges_at(x, y).is_some();
                prop_assert_eq!(inside, expected[(y * width + x) as usize], "{} {}", x, y);
                prop_assert!(!inside || (columns.contains(&x) && rows.contains(&y)));
            }
        }
    }

    /// The depth of the plane through the corners, within 5 roundings relative to it, however thin the triangle.
    #[test]
    fn depth_is_within_five_roundings(corners in corners(), near in any::<bool>()) {
        // Half of the triangles are small: all their pixels are in the picture.
        let corners = if near {
            corners.map(|c| Corner { x: c.x.rem_euclid(40 * 256), y: c.y.rem_euclid(36 * 256), ..c })
        } else {
            corners
        };
        let Some(setup) = Setup::new(corners.each_ref(), Cull::Nothing) else { return Ok(()) };
        for y in (0..36).step_by(5) {
            for x in 0..40 {
                let Some(edges) = setup.edges_at(x, y) else { continue };
                let value = setup.value(edges);
                // Cramer's rule on the corners as given.
                let [a, b, c] = corners;
                let point = |c: &Corner| [int(c.x), int(c.y)];
                let p = [int(x * 256 + 128), int(y * 256 + 128)];
                let area = |[px, py]: [R; 2], [qx, qy]: [R; 2], [sx, sy]: [R; 2]| {
                    (qx - &px) * (sy - &py) - (qy - py) * (sx - px)
                };
                let [pa, pb, pc] = [&a, &b, &c].map(point);
                let sum = area(p.clone(), pb.clone(), pc.clone()) * r(a.value)
                    + area(pa.clone(), p.clone(), pc.clone()) * r(b.value)
                    + area(pa.clone(), pb.clone(), p) * r(c.value);
                let exact = sum / area(pa, pb, pc);
                let error = r(value) - &exact;
                let error = if error < int(0) { -error } else { error };
                // 5 · 2⁻⁵³; below the range of doubles the dᵢ / E have an error of 2⁻¹⁰⁷⁵, times Eᵢ < 2⁵².
                let bound = exact.clone() * r(5.01 * f64::EPSILON / 2.0) + r(libm::scalbn(1.0, -1021));
                prop_assert!(error <= bound, "{} {}: {}", x, y, value);
                prop_assert!((setup.least..=setup.greatest).contains(&value));
            }
        }
    }

    /// Integers: no other is nearer. f32 is rounded by the processor.
    #[test]
    fn integers_are_the_nearest(value in 0.0..=1.0f64, i in 0..(1u32 << 24)) {
        fn check<F: DepthFormat>(value: f64, max: u32) -> Result<(), TestCaseError>
        where
            F::Stored: Into<u32>,
        {
            let found: u32 = F::encode(value).into();
            let scaled = r(value) * int(max);
            let error = scaled - int(found);
            let error = if error < int(0) { -error } else { error };
            // Half a step, and the rounding of the product.
            prop_assert!(error <= r(0.5) + int(max) * r(f64::EPSILON));
            let decoded = F::decode(F::encode(value));
            prop_assert_eq!(F::encode(decoded).into(), found);
            Ok(())
        }
        check::<Depth16>(value, 65_535)?;
        check::<Depth24>(value, 16_777_215)?;
        check::<Depth16>((f64::from(i % 65_535) + 0.5) / 65_535.0, 65_535)?;
        check::<Depth24>((f64::from(i % 16_777_215) + 0.5) / 16_777_215.0, 16_777_215)?;
    }
}

/// Centres on the sides of a square: those on its top and left sides are in, however it is made of triangles.
#[test]
fn top_and_left_sides_are_in() {
    let [a, b, c, d] = [(-0.75, 0.75), (0.25, 0.75), (0.25, -0.25), (-0.75, -0.25)]
        .map(|(x, y)| DVec3::new(x, y, 0.0));
    let camera = Camera {
        view_projection: DMat4::IDENTITY,
        viewport: viewport(4, 4),
    };
    for triangles in [
        [[0, 1, 2], [0, 2, 3]],
        [[1, 2, 3], [1, 3, 0]],
        [[2, 1, 0], [3, 2, 0]],
    ] {
        let mesh = Mesh::new(vec![a, b, c, d], triangles.to_vec()).unwrap();
        for form in [Form::Plain, Form::Fast] {
            let mut depth = DepthBuffer::<Depth16>::new(4, 4).unwrap();
            depth_drawn(&mesh, &camera, Cull::Nothing, &mut depth, form, &mut ()).unwrap();
            let drawn: Vec<_> = depth
                .image()
                .iter()
                .map(|&z| u8::from(z < u16::MAX))
                .collect();
            let expected = [1, 1, 0, 0, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0];
            assert_eq!(drawn, expected, "{triangles:?} {form:?}");
        }
    }
}

/// Three corners at one depth: that depth everywhere, also where the next double would be stored as another one.
#[test]
fn level_triangles_are_level() {
    let n = 61u32;
    // Spokes of a wheel, and one corner beside its hub.
    let at = |i: u32, z: f64| {
        let angle = core::f64::consts::TAU * f64::from(i) / f64::from(n);
        DVec3::new(0.97 * libm::cos(angle), 0.97 * libm::sin(angle), z)
    };
    // Depths ½ + 2⁻²⁵ and ½ + 3 · 2⁻²⁵, halfway between two singles: ties to even.
    for (z, expected) in [(1.0, 0.5f32), (3.0, 0.5 + 2.0 * f32::EPSILON / 2.0)] {
        let z = z * libm::scalbn(1.0, -24);
        let mut positions: Vec<_> = (0..n).map(|i| at(i, z)).collect();
        positions.push(DVec3::new(0.013, -0.071, z));
        let triangles = (0..n).map(|i| [i, (i + 1) % n, n]).collect();
        let mesh = Mesh::new(positions, triangles).unwrap();
        let camera = Camera {
            view_projection: DMat4::IDENTITY,
            viewport: viewport(101, 97),
        };
        for form in [Form::Plain, Form::Fast] {
            let mut depth = DepthBuffer::<Depth32F>::new(101, 97).unwrap();
            depth_drawn(&mesh, &camera, Cull::Nothing, &mut depth, form, &mut ()).unwrap();
            let stored = depth.image().as_raw();
            let drawn = stored.iter().filter(|&&z| z < 1.0).count();
            assert!(drawn > 7000);
            assert!(
                stored.iter().all(|&z| z == expected || z == 1.0),
                "{form:?}"
            );
        }
    }
}

/// In a wide triangle rows end by a division that rounds: 1/49 · 49 is below 1. The last pixel is there all the same.
#[test]
fn wide_rows_end_where_their_pixels_do() {
    let (width, height) = (120, 64);
    for last in 34..110u32 {
        // A right side, 49 pixels down and 3 sub-pixels right, with the edge function 1 at the centre (last, 40):
        // 3 · 8363 − 12544 · 2 = 1.
        let (x, y) = (last as i32 * 256 + 128 - 2, 40 * 256 + 128 - 8363);
        let corner = |x, y| Corner {
            x,
            y,
            value: 0.5,
            w: 1.0,
        };
        let corners = [corner(128, y), corner(x, y), corner(x + 3, y + 12544)];
        let setup = Setup::new(corners.each_ref(), Cull::Nothing).unwrap();
        assert_eq!(
            setup.edges_at(last, 40).map(|e| e.contains(&1.0)),
            Some(true)
        );
        let to_ndc = |c: &Corner| {
            DVec3::new(
                f64::from(c.x) / (128.0 * f64::from(width)) - 1.0,
                1.0 - f64::from(c.y) / (128.0 * f64::from(height)),
                0.0,
            )
        };
        let mesh = Mesh::new(corners.iter().map(to_ndc).collect(), vec![[0, 1, 2]]).unwrap();
        let camera = Camera {
            view_projection: DMat4::IDENTITY,
            viewport: viewport(width, height),
        };
        let [plain, fast] = [Form::Plain, Form::Fast].map(|form| {
            let mut depth = DepthBuffer::<Depth16>::new(width, height).unwrap();
            depth_drawn(&mesh, &camera, Cull::Nothing, &mut depth, form, &mut ()).unwrap();
            depth
        });
        assert!(plain.stored(last, 40).unwrap() < u16::MAX, "{last}");
        assert_eq!(plain, fast, "{last}");
    }
}

#[test]
fn formats_at_their_ends() {
    assert_eq!([Depth16::encode(0.0), Depth16::encode(1.0)], [0, 65_535]);
    assert_eq!([Depth24::encode(0.0), Depth24::encode(1.0)], [0, 0xff_ffff]);
    assert_eq!([Depth32F::encode(0.0), Depth32F::encode(1.0)], [0.0, 1.0]);
    let (near, far) = (
        DVec4::new(3.0, 1.0, -2.0, 2.0),
        DVec4::new(3.0, 1.0, 2.0, 2.0),
    );
    assert_eq!([Depth24::value(near), Depth24::value(far)], [0.0, 1.0]);
    let reversed = [ReversedDepth32F::value(near), ReversedDepth32F::value(far)];
    assert_eq!(reversed, [1.0, 0.0]);
    // (w − z) / 2w with all its digits, where 1 − (w + z) / 2w has none but the first.
    let nearly_far = DVec4::new(0.0, 0.0, 3.0 - libm::scalbn(1.0, -49), 3.0);
    assert_eq!(
        ReversedDepth32F::value(nearly_far),
        libm::scalbn(1.0, -50) / 3.0
    );
    // Beyond half of the largest double.
    let huge = DVec4::new(0.0, 0.0, 0.0, f64::MAX);
    assert_eq!(Depth24::value(huge), 0.5);
    // What is outside the range is stored as something.
    for value in [f64::NAN, f64::INFINITY, -1.0, 1e300] {
        let _ = (
            Depth16::encode(value),
            Depth24::encode(value),
            Depth32F::encode(value),
        );
    }
    assert_eq!([Depth16::encode(-1.0), Depth16::encode(2.0)], [0, 65_535]);
}

/// Near the far plane 1 − d rounded after subtraction has 2⁻⁵³ to lose, not 2⁻²⁴.
#[test]
fn reversed_depth_is_not_one_minus_a_rounded_depth() {
    let camera = Camera {
        view_projection: frustum(-1.0, 1.0, -1.0, 1.0, 1.0, 1e6).unwrap(),
        viewport: viewport(2, 2),
    };
    let stored = |z: f64| {
        let at = |x: f64, y: f64| DVec3::new(x * z, y * z, -z);
        let mesh = Mesh::new(
            vec![at(-9.0, -9.0), at(9.0, -9.0), at(0.0, 9.0)],
            vec![[0, 1, 2]],
        )
        .unwrap();
        let mut reversed = DepthBuffer::<ReversedDepth32F>::new(2, 2).unwrap();
        draw_depth(&mesh, &camera, Cull::Nothing, &mut reversed).unwrap();
        let mut plain = DepthBuffer::<Depth32F>::new(2, 2).unwrap();
        draw_depth(&mesh, &camera, Cull::Nothing, &mut plain).unwrap();
        (reversed.stored(0, 0).unwrap(), plain.stored(0, 0).unwrap())
    };
    let (near_one, far_one) = (stored(1000.0), stored(1001.0));
    // n (f − z) / (z (f − n)) to the nearest single, within one more rounding.
    let exact = |z: f64| (1e6 - z) / (z * (1e6 - 1.0));
    for (z, (reversed, _)) in [(1000.0, near_one), (1001.0, far_one)] {
        let error = (f64::from(reversed) / exact(z) - 1.0).abs();
        assert!(error <= f64::from(f32::EPSILON) / 2.0 + 1e-9, "{error}");
    }
    let (near_far, far_far) = (stored(100_000.0), stored(100_001.0));
    assert!(near_far.0 > far_far.0, "told apart");
    assert_eq!(near_far.1, far_far.1, "not told apart");
}

proptest! {
    /// Snapping is that of the raster lecture.
    #[test]
    fn corners_are_snapped(x in -1.0..1.0f64, y in -1.0..1.0f64, far in any::<bool>()) {
        let scale = if far { 100.0 } else { 1.0 };
        let position = DVec3::new(x * scale, y * scale, 0.0);
        let camera = Camera { view_projection: DMat4::IDENTITY, viewport: viewport(37, 23) };
        let mesh = Mesh::new(vec![position], vec![]).unwrap();
        let scene = Scene::new::<Depth24>(&mesh, &camera, Level::new(), &mut ()).unwrap();
        let expected = triangle::snap(camera.to_pixel(position).unwrap().truncate(), SUBPIXEL_BITS) * 256.0;
        let found = scene.corner(0).unwrap();
        prop_assert_eq!(DVec2::new(f64::from(found.x), f64::from(found.y)), expected);
    }
}
