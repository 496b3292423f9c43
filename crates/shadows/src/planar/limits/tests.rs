use super::*;
use proptest::prelude::*;

const SUN: DVec4 = DVec4::new(10.0, 10.0, 10.0, 0.0);

fn v(x: f64, y: f64, z: f64) -> DVec3 {
    DVec3::new(x, y, z)
}

#[test]
fn a_face_of_the_slide_cube() {
    let bottom = [
        v(0.0, 20.0, 0.0),
        v(10.0, 20.0, 0.0),
        v(10.0, 20.0, 10.0),
        v(0.0, 20.0, 10.0),
    ];
    let expected = [(-20, -20), (-10, -20), (-10, -10), (-20, -10)];
    let expected = expected.map(|(x, z)| DVec4::new(x.into(), 0.0, z.into(), 1.0));
    assert_eq!(cast_polygon(Plane::GROUND, SUN, &bottom), expected);
    assert_eq!(cast_polygon(Plane::GROUND.turned(), SUN, &bottom), expected);
}

#[test]
fn a_pillar_higher_than_the_lamp_runs_to_infinity() {
    let lamp = DVec4::new(0.0, 2.0, 0.0, 1.0);
    let wall = [
        v(1.0, 0.0, -1.0),
        v(1.0, 0.0, 1.0),
        v(1.0, 4.0, 1.0),
        v(1.0, 4.0, -1.0),
    ];
    let shadow = cast_polygon(Plane::GROUND, lamp, &wall);
    let at_infinity: Vec<_> = shadow.iter().filter(|p| p.w == 0.0).collect();
    assert_eq!(
        at_infinity,
        [
            &DVec4::new(1.0, 0.0, -1.0, 0.0),
            &DVec4::new(1.0, 0.0, 1.0, 0.0)
        ]
    );
    assert_eq!(shadow.len(), 4);
}

#[test]
fn a_shadow_no_double_can_hold_keeps_its_direction() {
    let low = DVec4::new(1e300, 1e-300, 0.0, 0.0);
    let shadow = cast_polygon(
        Plane::GROUND,
        low,
        &[v(0.0, 1.0, 0.0), v(0.0, 1.0, 1.0), v(0.0, 2.0, 0.0)],
    );
    assert_eq!(shadow.len(), 3);
    for p in shadow {
        assert!(
            p.is_finite() && p.w >= 0.0 && p.w < 1e-300 && p.x < 0.0,
            "{p}"
        );
    }
}

#[test]
fn receivers_of_any_winding_and_side() {
    let tile = [
        v(-1.0, 0.0, -1.0),
        v(-1.0, 0.0, 1.0),
        v(1.0, 0.0, 1.0),
        v(1.0, 0.0, -1.0),
    ];
    let mut turned = tile;
    turned.reverse();
    let sheet = tile.map(|p| p * 10.0 + DVec3::Y);
    for receiver in [tile, turned] {
        for light in [
            DVec4::Y,
            DVec4::new(0.3, 1.0, -0.4, 0.0),
            DVec4::new(0.0, 5.0, 1.0, 1.0),
        ] {
            let mut shadow = cast_onto(&receiver, light, &sheet);
            assert_eq!(shadow.len(), 4);
            shadow.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.z.total_cmp(&b.z)));
            for (p, q) in shadow.iter().zip([tile[0], tile[1], tile[3], tile[2]]) {
                assert!(
                    (*p - q).abs().max_element() <= 8.0 * f64::EPSILON * 10.0,
                    "{p} {q}"
                );
            }
            assert_eq!(
                cast_onto(&receiver, light, &sheet.map(|p| p - 2.0 * DVec3::Y)),
                []
            );
        }
    }
}

#[test]
fn the_error_is_that_of_the_unclipped_shadow() {
    let tile = [
        v(-1.0, 0.0, -1.0),
        v(-1.0, 0.0, 1.0),
        v(1.0, 0.0, 1.0),
        v(1.0, 0.0, -1.0),
    ];
    for k in [1e3, 1e6, 1e9] {
        for (x, z) in [(0.3, 0.7), (-0.9, 0.2), (0.55, -0.35)] {
            let sheet = [v(x, 1.0, -k), v(k, 1.0, z * k), v(-k, 1.0, 0.9 * k)];
            for p in cast_onto(&tile, DVec4::Y, &sheet) {
                let outside = p.abs().max_element() - 1.0;
                assert!(outside <= 2.0 * f64::EPSILON * k, "{k:e}: {outside:e}");
            }
        }
    }
}

#[test]
fn a_lamp_below_a_ceiling() {
    let ceiling = [
        v(-9.0, 3.0, -9.0),
        v(9.0, 3.0, -9.0),
        v(9.0, 3.0, 9.0),
        v(-9.0, 3.0, 9.0),
    ];
    let plate = [v(0.0, 2.0, 0.0), v(1.0, 2.0, 0.0), v(1.0, 2.0, 1.0)];
    let shadow = cast_onto(&ceiling, DVec4::new(0.0, 1.0, 0.0, 1.0), &plate);
    assert_eq!(
        shadow,
        [v(0.0, 3.0, 0.0), v(2.0, 3.0, 0.0), v(2.0, 3.0, 2.0)]
    );
}

#[test]
fn degenerate() {
    let triangle = [v(0.0, 1.0, 0.0), v(1.0, 1.0, 0.0), v(0.0, 1.0, 1.0)];
    let ground = Plane::GROUND;
    let bad_plane = Plane {
        normal: DVec3::ZERO,
        d: 1.0,
    };
    for (plane, light, polygon) in [
        (ground, SUN, &triangle[..0]),
        (ground, SUN, &triangle[..2]),
        (ground, DVec4::ZERO, &triangle[..]),
        (ground, DVec4::X, &triangle[..]),
        (ground, -SUN, &triangle[..]),
        (ground, DVec4::new(0.0, 1.0, 0.0, 1.0), &triangle[..]),
        (ground, DVec4::new(0.0, 0.5, 0.0, 1.0), &triangle[..]),
        (ground, DVec4::NAN, &triangle[..]),
        (bad_plane, SUN, &triangle[..]),
        (ground, SUN, &[DVec3::Y, DVec3::NAN, DVec3::X][..]),
        (ground, SUN, &[DVec3::Y; 4][..]),
    ] {
        assert_eq!(
            cast_polygon(plane, light, polygon),
            [],
            "{plane:?} {light} {polygon:?}"
        );
    }
    for receiver in [
        &triangle[..0],
        &triangle[..2],
        &[DVec3::ZERO; 4][..],
        &[DVec3::NAN; 3][..],
    ] {
        assert_eq!(cast_onto(receiver, SUN, &triangle), []);
    }
    // A polygon on the plane is its own shadow.
    let flat = triangle.map(|p| p - DVec3::Y);
    assert_eq!(cast_polygon(ground, SUN, &flat), flat.map(point));
}

proptest! {
    #[test]
    fn never_panics(x in prop::collection::vec(proptest::num::f64::ANY, 26)) {
        let p: Vec<_> = x.chunks_exact(3).map(DVec3::from_slice).collect();
        let light = DVec4::from_slice(&x[20..24]);
        let plane = Plane { normal: p[6], d: x[25] };
        for q in cast_polygon(plane, light, &p[..4]) {
            prop_assert!(q.w >= 0.0 && q.w <= 1.0 && !q.is_nan());
        }
        prop_assert!(cast_onto(&p[4..8], light, &p[..4]).iter().all(|q| q.is_finite()));
    }
}
