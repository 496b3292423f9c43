//! Any doubles at all, NaN and the infinities among them: every function answers, with finite numbers, and none
//! panics.

use ombra_math::glam::{DVec3, DVec4, dvec3, dvec4};
use ombra_math::plane::Plane;
use ombra_shadows::fake::ellipse;
use ombra_shadows::planar::{
    cast, cast_onto, cast_polygon, cast_polygon_each, classify, ground_matrix_directional,
    ground_matrix_point, shadow_matrix, textbook,
};
use ombra_tests::cases::{Random, case};
use ombra_tests::shadow::ExactShadow;
use proptest::num::f64::ANY;
use proptest::prelude::*;

fn by_quotient(plane: Plane, light: DVec4, v: DVec3) -> Option<DVec3> {
    textbook::by_quotient(plane, light, v, &mut ())
}

fn by_parameter(plane: Plane, light: DVec4, v: DVec3) -> Option<DVec3> {
    textbook::by_parameter(plane, light, v, &mut ())
}

fn any_point() -> impl Strategy<Value = DVec3> {
    (ANY, ANY, ANY).prop_map(|(x, y, z)| dvec3(x, y, z))
}

fn any_light() -> impl Strategy<Value = DVec4> {
    (ANY, ANY, ANY, prop_oneof![ANY, Just(0.0), Just(1.0)])
        .prop_map(|(x, y, z, w)| dvec4(x, y, z, w))
}

fn any_plane() -> impl Strategy<Value = Plane> {
    (any_point(), ANY).prop_map(|(normal, d)| Plane { normal, d })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 4096, ..ProptestConfig::default() })]

    /// Any doubles, NaN and infinities among them: an answer, finite, and no panic.
    #[test]
    fn nothing_panics_on_points(plane in any_plane(), light in any_light(), v in any_point()) {
        for answer in [cast, by_quotient, by_parameter] {
            prop_assert!(answer(plane, light, v).is_none_or(DVec3::is_finite));
        }
        let placement = classify(plane, light, v);
        prop_assert_eq!(placement.is_some(), ExactShadow::new(plane, light, v).is_some());
        for matrix in [shadow_matrix(plane, light), ground_matrix_directional(v), ground_matrix_point(v)] {
            match matrix {
                Ok(m) => prop_assert!(m.is_finite()),
                Err(why) => prop_assert!(!why.to_string().is_empty()),
            }
        }
    }

    #[test]
    fn nothing_panics_on_polygons(
        plane in any_plane(),
        lights in prop::collection::vec(any_light(), 0..3),
        polygon in prop::collection::vec(any_point(), 0..6),
        receiver in prop::collection::vec(any_point(), 0..6),
    ) {
        let shadows = cast_polygon_each(plane, &lights, &polygon);
        prop_assert_eq!(shadows.len(), lights.len());
        for (&light, shadow) in lights.iter().zip(shadows) {
            prop_assert!(shadow.iter().all(|p| p.is_finite() && (0.0..=1.0).contains(&p.w)), "{:?}", shadow);
            prop_assert_eq!(cast_polygon(plane, light, &polygon), shadow);
            let onto = cast_onto(&receiver, light, &polygon);
            prop_assert!(onto.iter().all(|p| p.is_finite()), "{:?}", onto);
            if let Some(e) = ellipse(&polygon, plane, light) {
                prop_assert!(e.center.is_finite() && e.u.is_finite() && e.v.is_finite(), "{:?}", e);
            }
        }
    }

    /// The same with finite doubles of every size, where more than refusal is asked for.
    #[test]
    fn finite_polygons_of_every_size(seed in any::<u64>()) {
        let mut random = Random::new(seed);
        let first = case(&mut random);
        let mut corners = vec![first.vertex];
        corners.extend((0..3).map(|_| case(&mut random).vertex));
        let shadow = cast_polygon(first.plane, first.light, &corners);
        prop_assert!(shadow.iter().all(|p| p.is_finite() && (0.0..=1.0).contains(&p.w)), "{:?}", shadow);
        // Every corner that casts is there as its own shadow, if the polygon casts at all.
        for &v in &corners {
            if let (Some(p), false) = (cast(first.plane, first.light, v), shadow.is_empty()) {
                prop_assert!(shadow.contains(&p.extend(1.0)), "{:?} misses {}", shadow, p);
            }
        }
        let receiver: Vec<DVec3> = (0..3).map(|_| case(&mut random).vertex).collect();
        let onto = cast_onto(&receiver, first.light, &corners);
        prop_assert!(onto.iter().all(|p| p.is_finite()), "{:?}", onto);
    }
}
