//! Which pixels and which depths.

use ombra_math::glam::{DMat4, DVec2};
use ombra_raster::triangle;
use ombra_raster::triangle_setup::Corner;

use super::*;

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
        let projected = Projected::new::<Depth24>(&mesh, &camera, &mut ()).unwrap();
        let expected = triangle::snap(camera.to_pixel(position).unwrap().truncate(), SUBPIXEL_BITS) * 256.0;
        let found = projected.corner(0).unwrap();
        prop_assert_eq!(DVec2::new(f64::from(found.x), f64::from(found.y)), expected);
    }
}
