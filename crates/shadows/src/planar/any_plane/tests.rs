use super::super::{ground_matrix_directional, ground_matrix_point};
use super::fast::{Quick, in_double_double};
use super::*;
use ombra_math::solids::slide_cube;
use ombra_math::work::Work;
use proptest::prelude::*;

const SUN: DVec4 = DVec4::new(10.0, 10.0, 10.0, 0.0);
const LAMP: DVec4 = DVec4::new(0.0, 100.0, 100.0, 1.0);

#[test]
fn the_slide_cube_under_a_light_at_infinity() {
    let shadow = slide_cube()
        .positions
        .into_iter()
        .map(|v| cast(Plane::GROUND, SUN, v).unwrap());
    let x = [-20.0, -10.0, -10.0, -20.0, -30.0, -20.0, -20.0, -30.0];
    let z = [-20.0, -20.0, -10.0, -10.0, -30.0, -30.0, -20.0, -20.0];
    assert!(shadow.eq(x.into_iter().zip(z).map(|(x, z)| DVec3::new(x, 0.0, z))));
}

#[test]
fn the_slide_cube_under_a_lamp() {
    let shadow = slide_cube()
        .positions
        .into_iter()
        .map(|v| cast(Plane::GROUND, LAMP, v).unwrap());
    // As fractions: what the slide's own formula gives, not what it prints.
    let x = [
        (0, 1),
        (25, 2),
        (25, 2),
        (0, 1),
        (0, 1),
        (100, 7),
        (100, 7),
        (0, 1),
    ];
    let z = [
        (-25, 1),
        (-25, 1),
        (-25, 2),
        (-25, 2),
        (-300, 7),
        (-300, 7),
        (-200, 7),
        (-200, 7),
    ];
    let quotient = |(n, d): (i32, i32)| f64::from(n) / f64::from(d);
    assert!(
        shadow.eq(x
            .into_iter()
            .zip(z)
            .map(|(x, z)| DVec3::new(quotient(x), 0.0, quotient(z))))
    );
}

#[test]
fn ordinary_input_needs_no_fallback() {
    let mut work = Work::default();
    for v in slide_cube().positions {
        let _ = counted::cast(Plane::GROUND, LAMP, v, &mut work);
    }
    assert_eq!((work.vertices, work.exact_fallbacks), (8, 0));
}

#[test]
fn degenerate() {
    let ground = Plane::GROUND;
    let v = DVec3::new(1.0, 2.0, 3.0);
    let casts = |p: DVec3| (Some(p), Some(Placement::Casts));
    let no = |placement| (None, Some(placement));
    let nothing = (None, None);
    let huge = f64::MAX;
    let cases = [
        (ground, LAMP, DVec3::ZERO, casts(DVec3::ZERO)),
        (
            ground,
            LAMP,
            DVec3::new(7.0, 0.0, -0.5),
            casts(DVec3::new(7.0, 0.0, -0.5)),
        ),
        (
            ground,
            -LAMP,
            v,
            (cast(ground, LAMP, v), Some(Placement::Casts)),
        ),
        (
            ground.turned(),
            LAMP,
            v,
            (cast(ground, LAMP, v), Some(Placement::Casts)),
        ),
        (ground, -SUN, v, no(Placement::BehindPlane)),
        (ground, -SUN, -v, casts(DVec3::new(1.0, 0.0, -1.0))),
        (ground, DVec4::X, v, no(Placement::LightAlongPlane)),
        (
            ground,
            DVec4::new(5.0, 0.0, 5.0, 1.0),
            v,
            no(Placement::LightAlongPlane),
        ),
        (
            ground,
            LAMP,
            DVec3::Y * 100.0,
            no(Placement::LevelWithLight),
        ),
        (
            ground,
            LAMP,
            DVec3::Y * 100.0_f64.next_up(),
            no(Placement::BeyondLight),
        ),
        (ground, LAMP, DVec3::Y * -5e-324, no(Placement::BehindPlane)),
        (
            ground,
            LAMP,
            DVec3::Y * 5e-324,
            casts(DVec3::new(0.0, 0.0, -5e-324)),
        ),
        // The shadow of the vertex just under the lamp, 100 z/(z − …): exact by hand, (100·0 − 100 V_y)/(100 − V_y).
        (
            ground,
            LAMP,
            DVec3::Y * 100.0_f64.next_down(),
            casts(DVec3::new(
                0.0,
                0.0,
                -100.0 * 100.0_f64.next_down() / (100.0 - 100.0_f64.next_down()),
            )),
        ),
        // Beyond the largest double there is a shadow, but no number for it.
        (
            ground,
            DVec4::new(huge, 1.0, 0.0, 0.0),
            v,
            no(Placement::Casts),
        ),
        (
            ground,
            DVec4::new(huge, huge, 0.0, 1.0),
            DVec3::new(0.0, huge / 2.0, 0.0),
            casts(DVec3::new(-huge, 0.0, 0.0)),
        ),
        (
            ground,
            DVec4::Y * 1e-320,
            v,
            casts(DVec3::new(1.0, 0.0, 3.0)),
        ),
        (
            Plane {
                normal: DVec3::Y * 1e300,
                d: 0.0,
            },
            SUN,
            v,
            casts(DVec3::new(-1.0, 0.0, 1.0)),
        ),
        (
            Plane {
                normal: DVec3::Y * 5e-324,
                d: 0.0,
            },
            SUN,
            v,
            casts(DVec3::new(-1.0, 0.0, 1.0)),
        ),
        (
            Plane {
                normal: DVec3::ZERO,
                d: 1.0,
            },
            SUN,
            v,
            nothing,
        ),
        (ground, DVec4::ZERO, v, nothing),
        (ground, LAMP, DVec3::NAN, nothing),
        (ground, LAMP, DVec3::INFINITY, nothing),
        (ground, DVec4::new(0.0, f64::INFINITY, 0.0, 1.0), v, nothing),
        (ground, DVec4::new(0.0, 1.0, 0.0, f64::NAN), v, nothing),
        (
            Plane {
                normal: DVec3::Y,
                d: f64::NAN,
            },
            LAMP,
            v,
            nothing,
        ),
        (
            Plane {
                normal: DVec3::INFINITY,
                d: 0.0,
            },
            LAMP,
            v,
            nothing,
        ),
    ];
    for (plane, light, v, expected) in cases {
        let answer = (cast(plane, light, v), classify(plane, light, v));
        assert_eq!(answer, expected, "{plane:?} {light} {v}");
    }
}

fn number() -> impl Strategy<Value = f64> {
    prop_oneof![
        (-1.0..1.0f64, -60..60i32).prop_map(|(m, e)| libm::scalbn(m, e)),
        -10.0..10.0f64,
        (-3i32..4).prop_map(f64::from),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(4000))]

    /// The quick path, where it settles, is the exact one bit for bit.
    #[test]
    fn quick_is_exact(x in prop::collection::vec(number(), 11), near in 0u8..4, ulps in -3i64..4) {
        let mut plane = Plane { normal: DVec3::new(x[0], x[1], x[2]), d: x[3] };
        let light = DVec4::new(x[4], x[5], x[6], x[7].abs());
        let v = DVec3::new(x[8], x[9], x[10]);
        // A vertex almost on the plane, or a light almost along it.
        let nudge = |d: f64| f64::from_bits(d.to_bits().wrapping_add_signed(ulps));
        match near {
            0 => plane.d = nudge(-plane.normal.dot(v)),
            1 if light.w != 0.0 => plane.d = nudge(-plane.normal.dot(light.truncate()) / light.w),
            _ => {}
        }
        prop_assume!(plane.d.is_finite());
        match in_double_double(plane, light, v, &mut ()) {
            Quick::Shadow(p) => prop_assert_eq!(Some(p), cast_plain(plane, light, v, &mut ())),
            Quick::NoShadow => prop_assert_eq!(None, cast_plain(plane, light, v, &mut ())),
            Quick::InDoubt => {}
        }
    }

    #[test]
    fn never_panics(x in prop::collection::vec(proptest::num::f64::ANY, 11)) {
        let plane = Plane { normal: DVec3::new(x[0], x[1], x[2]), d: x[3] };
        let light = DVec4::new(x[4], x[5], x[6], x[7]);
        let v = DVec3::new(x[8], x[9], x[10]);
        let shadow = cast(plane, light, v);
        prop_assert!(shadow.is_none_or(|p| p.is_finite()));
        if shadow.is_some() {
            prop_assert_eq!(classify(plane, light, v), Some(Placement::Casts));
        }
    }
}

#[test]
fn sentences_name_the_value() {
    let bad = DVec4::new(f64::NAN, 1.0, 0.0, 1.0);
    let message = shadow_matrix(Plane::GROUND, bad).unwrap_err().to_string();
    assert!(
        message.contains("[NaN, 1, 0, 1]") && message.contains("finite"),
        "{message}"
    );
    let message = shadow_matrix(Plane::GROUND, DVec4::X)
        .unwrap_err()
        .to_string();
    assert!(
        message.contains("[1, 0, 0, 0]") && message.contains("along the plane"),
        "{message}"
    );
}

#[test]
fn the_light_is_in_the_kernel_and_the_plane_is_kept() {
    let plane = Plane {
        normal: DVec3::new(1.0, 2.0, 3.0),
        d: 4.0,
    };
    let light = DVec4::new(3.0, 7.0, 2.0, 1.0);
    let m = shadow_matrix(plane, light).unwrap();
    assert_eq!(m * light, DVec4::ZERO);
    let on_plane = DVec4::new(-4.0, 0.0, 0.0, 1.0);
    assert_eq!(m * on_plane, on_plane * plane.coefficients().dot(light));
    // The corrected entries of the slide's matrix, as rows of the transpose.
    assert_eq!(m.row(3), DVec4::new(-1.0, -2.0, -3.0, 23.0));
    assert_eq!(m * DVec4::ONE, DVec4::new(-3.0, -43.0, 7.0, 17.0));
}

#[test]
fn ground_matrices_are_the_general_one() {
    let l = DVec3::new(0.0, 100.0, 100.0);
    assert_eq!(
        shadow_matrix(Plane::GROUND, l.extend(1.0)),
        ground_matrix_point(l)
    );
    let l = DVec3::splat(10.0);
    let general = shadow_matrix(Plane::GROUND, l.extend(0.0)).unwrap();
    assert_eq!(general / 10.0, ground_matrix_directional(l).unwrap());
}

#[test]
fn a_turned_plane_or_light_is_the_same() {
    let plane = Plane {
        normal: DVec3::new(1.0, -2.0, 0.5),
        d: 3.0,
    };
    for light in [
        DVec4::new(3.0, 9.0, -2.0, 1.0),
        DVec4::new(3.0, 9.0, -2.0, 0.0),
    ] {
        let m = shadow_matrix(plane, light).unwrap();
        assert_eq!(shadow_matrix(plane.turned(), light).unwrap(), m);
        if light.w != 0.0 {
            assert_eq!(shadow_matrix(plane, -light).unwrap(), m);
        }
    }
}

#[test]
fn extremes_are_scaled_or_refused() {
    let tall = Plane {
        normal: DVec3::Y * 1e300,
        d: 0.0,
    };
    let m = shadow_matrix(tall, DVec4::new(1e300, 1e300, 0.0, 1.0)).unwrap();
    let p = m * DVec4::new(0.0, 1e290, 0.0, 1.0);
    assert!((p.x / p.w + 1e290).abs() < 1e280, "{p}");
    let tiny = Plane {
        normal: DVec3::Y * 1e-300,
        d: 0.0,
    };
    let m = shadow_matrix(tiny, DVec4::new(0.0, 1e-300, 1e-300, 0.0)).unwrap();
    assert_eq!(
        m * DVec4::new(0.0, 5.0, 0.0, 1.0) / m.w_axis.w,
        DVec4::new(0.0, 0.0, -5.0, 1.0)
    );
    assert_eq!(
        ground_matrix_directional(DVec3::new(1e300, 1e-300, 0.0)),
        Err(PlanarShadowError::TooLarge(DVec4::new(
            1e300, 1e-300, 0.0, 0.0
        )))
    );
    for (plane, light) in [
        (
            Plane {
                normal: DVec3::ZERO,
                d: 1.0,
            },
            DVec4::ONE,
        ),
        (
            Plane {
                normal: DVec3::NAN,
                d: 1.0,
            },
            DVec4::ONE,
        ),
        (
            Plane {
                normal: DVec3::Y,
                d: f64::INFINITY,
            },
            DVec4::ONE,
        ),
        (Plane::GROUND, DVec4::ZERO),
        (Plane::GROUND, DVec4::INFINITY),
        (Plane::GROUND, DVec4::new(1.0, 0.0, 3.0, 1.0)),
    ] {
        assert!(shadow_matrix(plane, light).is_err(), "{plane:?} {light}");
    }
}
