//! Any doubles, NaN and the infinities among them.

use ombra_math::glam::{DVec2, DVec3};
use proptest::num::f64::ANY;
use proptest::prelude::*;

/// Any double, with those that decide something more often than their bits would be hit.
pub fn number() -> impl Strategy<Value = f64> {
    let special = prop::sample::select(vec![
        0.0,
        -0.0,
        0.5,
        1.0,
        -1.0,
        5e-324,
        f64::MIN_POSITIVE,
        f64::MAX,
        f64::MIN,
        f64::INFINITY,
        f64::NEG_INFINITY,
        f64::NAN,
    ]);
    prop_oneof![4 => ANY, 2 => special, 4 => -20.0..20.0]
}

pub fn point2() -> impl Strategy<Value = DVec2> {
    (number(), number()).prop_map(DVec2::from)
}

pub fn point3() -> impl Strategy<Value = DVec3> {
    (number(), number(), number()).prop_map(DVec3::from)
}

pub fn finite(polygon: &[DVec2]) -> bool {
    polygon.iter().all(|p| p.is_finite())
}
