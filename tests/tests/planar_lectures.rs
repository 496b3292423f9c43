//! The lectures' numbers: the slide cube's shadow from every form of the formula, and how the forms behave as
//! the light goes to infinity or down to the plane.
#![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use ombra_math::glam::{DMat4, DVec3, DVec4};
use ombra_math::homogeneous::{point, project};
use ombra_math::plane::Plane;
use ombra_math::solids::slide_cube;
use ombra_oracle::Exact;
use ombra_shadows::planar::{
    cast, ground_matrix_directional, ground_matrix_point, shadow_matrix, textbook,
};
use ombra_tests::shadow::ExactShadow;

fn by_quotient(plane: Plane, light: DVec4, v: DVec3) -> Option<DVec3> {
    textbook::by_quotient(plane, light, v, &mut ())
}

fn by_parameter(plane: Plane, light: DVec4, v: DVec3) -> Option<DVec3> {
    textbook::by_parameter(plane, light, v, &mut ())
}

/// Olomouc, «Zdroj v nekonečnu», example: the cube's corners in the deck's order.
const CUBE: [DVec3; 8] = [
    DVec3::new(0.0, 20.0, 0.0),
    DVec3::new(10.0, 20.0, 0.0),
    DVec3::new(10.0, 20.0, 10.0),
    DVec3::new(0.0, 20.0, 10.0),
    DVec3::new(0.0, 30.0, 0.0),
    DVec3::new(10.0, 30.0, 0.0),
    DVec3::new(10.0, 30.0, 10.0),
    DVec3::new(0.0, 30.0, 10.0),
];

const SUN: DVec4 = DVec4::new(10.0, 10.0, 10.0, 0.0);
const LAMP: DVec4 = DVec4::new(0.0, 100.0, 100.0, 1.0);

/// (x, z) of the shadow under the sun (10, 10, 10) at infinity, as on the slide.
const UNDER_SUN: [(f64, f64); 8] = [
    (-20.0, -20.0),
    (-10.0, -20.0),
    (-10.0, -10.0),
    (-20.0, -10.0),
    (-30.0, -30.0),
    (-20.0, -30.0),
    (-20.0, -20.0),
    (-30.0, -20.0),
];

/// (x, z) under the lamp at (0, 100, 100): exact fractions, each the nearest double by one IEEE division.
const UNDER_LAMP: [(f64, f64); 8] = [
    (0.0, -25.0),
    (25.0 / 2.0, -25.0),
    (25.0 / 2.0, -25.0 / 2.0),
    (0.0, -25.0 / 2.0),
    (0.0, -300.0 / 7.0),
    (100.0 / 7.0, -300.0 / 7.0),
    (100.0 / 7.0, -200.0 / 7.0),
    (0.0, -200.0 / 7.0),
];

const EXAMPLES: [(DVec4, [(f64, f64); 8]); 2] = [(SUN, UNDER_SUN), (LAMP, UNDER_LAMP)];

fn on_ground((x, z): (f64, f64)) -> DVec3 {
    DVec3::new(x, 0.0, z)
}

/// The coordinates in which `shadow` is not the nearest double, as (corner, coordinate, last places off).
fn off(light: DVec4, shadow: impl Fn(DVec3) -> Option<DVec3>) -> Vec<(usize, char, i64)> {
    let (_, expected) = EXAMPLES.into_iter().find(|(l, _)| *l == light).unwrap();
    let mut off = Vec::new();
    for (corner, (v, expected)) in CUBE.into_iter().zip(expected).enumerate() {
        let (computed, expected) = (shadow(v).unwrap(), on_ground(expected));
        for (j, name) in ['x', 'y', 'z'].into_iter().enumerate() {
            let places = places_between(computed[j], expected[j]);
            if places != 0 {
                off.push((corner, name, places));
            }
        }
    }
    off
}

/// The number of doubles from `b` up to `a`.
fn places_between(a: f64, b: f64) -> i64 {
    // The bits of a double order it within its sign; −0 and 0 are one place.
    let rank = |x: f64| {
        let magnitude = (x.to_bits() & (u64::MAX >> 1)) as i64;
        if x < 0.0 { -magnitude } else { magnitude }
    };
    rank(a) - rank(b)
}

#[test]
fn the_cube_has_the_decks_corners() {
    assert_eq!(slide_cube().positions, CUBE);
}

/// Olomouc, both examples; shadows1 to shadows3 of the exercises.
#[test]
fn cube_by_matrix() {
    for (light, _) in EXAMPLES {
        let m = shadow_matrix(Plane::GROUND, light).unwrap();
        assert_eq!(off(light, |v| project(m * point(v))), [], "light {light}");
        // True shadows have w > 0, so that clipping keeps them (errata E21).
        assert!(CUBE.iter().all(|&v| (m * point(v)).w > 0.0));
    }
}

#[test]
fn cube_by_ground_matrices() {
    let sun = ground_matrix_directional(SUN.truncate()).unwrap();
    assert_eq!(sun.row(3), DVec4::W);
    assert_eq!(off(SUN, |v| project(sun * point(v))), []);
    // w = 1 without any division: the slide's own form.
    assert!(CUBE.iter().all(|&v| (sun * point(v)).w == 1.0));

    let lamp = ground_matrix_point(LAMP.truncate()).unwrap();
    assert_eq!(off(LAMP, |v| project(lamp * point(v))), []);
    // w = L_y − V_y.
    for v in CUBE {
        assert_eq!((lamp * point(v)).w, 100.0 - v.y);
    }
    // The same matrices, entry by entry, as the any-plane form: over the ground M = L_y I − L (0, 1, 0, 0).
    assert_eq!(lamp, shadow_matrix(Plane::GROUND, LAMP).unwrap());
    let sun_scaled = shadow_matrix(Plane::GROUND, SUN).unwrap();
    assert_eq!(sun_scaled, sun * 10.0);
}

#[test]
fn cube_by_point() {
    for (light, _) in EXAMPLES {
        let exact = off(light, |v| cast(Plane::GROUND, light, v));
        assert_eq!(exact, [], "light {light}");
        // s, t, both products and their difference are whole numbers below 2⁵³: one rounding, the division.
        let quotient = off(light, |v| by_quotient(Plane::GROUND, light, v));
        assert_eq!(quotient, [], "light {light}");
    }
}

/// P = L + k (V − L) rounds k, the product and the sum, each by up to half a last place *of its own size*. At z
/// the product is −142.9 or −128.6 and the sum −42.9 or −28.6: leading digits cancel, and what was half a place
/// of the product becomes one place of the result, or three.
#[test]
fn cube_by_parameter() {
    // Towards the sun, k = 2 or 3 is exact, and so is all that follows.
    let sun = off(SUN, |v| by_parameter(Plane::GROUND, SUN, v));
    assert_eq!(sun, []);
    // Under the lamp, k = 5/4 is exact at the four lower corners and k = 10/7 is not at the four upper ones.
    // There x = 0 + k · 10 and y = 100 − k · 70 happen to round back; z does not. With one rounding each for k,
    // product and sum there is one outcome, in whatever order the dot products are summed, for they are whole
    // numbers here.
    let lamp = off(LAMP, |v| by_parameter(Plane::GROUND, LAMP, v));
    assert_eq!(
        lamp,
        [(4, 'z', -1), (5, 'z', -1), (6, 'z', -3), (7, 'z', -3)]
    );
    // A place is between ε/2 and ε of a number, and 28.57 has small ones: the relative error stays below 2 ε.
    for v in CUBE {
        let exact = ExactShadow::new(Plane::GROUND, LAMP, v).unwrap();
        let computed = by_parameter(Plane::GROUND, LAMP, v).unwrap();
        for j in 0..3 {
            let (n, w) = exact.fraction(j);
            let error = Exact::new(computed[j]).unwrap() * w - n;
            let bound = n.abs().scaled(-51);
            assert!(error.abs() <= bound, "{v}, coordinate {j}");
        }
    }
}

/// The light (D, w) for w → 0 is the place D/w, farther and farther away: its shadow tends to that of the
/// direction D as the first power of w. With s₀ = n·D, t = n·V + d and c = d − t,
///
/// ```text
/// P(w) − P(0) = w (d V − c P(0)) / (s₀ + c w)
/// ```
///
/// so that halving w halves the difference, but for the w in the denominator.
#[test]
fn a_far_lamp_tends_to_a_sun() {
    let wall = Plane {
        normal: DVec3::new(1.0, 2.0, 3.0),
        d: 4.0,
    };
    let (direction, vertex) = (DVec3::new(3.0, 7.0, 2.0), DVec3::new(1.0, 5.0, -2.0));
    for plane in [Plane::GROUND, wall] {
        let sun = cast(plane, direction.extend(0.0), vertex).unwrap();
        let s = plane.normal.dot(direction);
        let c = -plane.normal.dot(vertex);
        let slope = (plane.d * vertex - c * sun) / s;
        // Every coordinate of both shadows is rounded once.
        let rounding = f64::EPSILON * sun.length();
        let difference = |k: i32| {
            let w = 2.0_f64.powi(-k);
            cast(plane, direction.extend(w), vertex).unwrap() - sun
        };
        for k in 6..30 {
            let w = 2.0_f64.powi(-k);
            let (at_w, at_half) = (difference(k), difference(k + 1));
            let next_order = c.abs() * w / (s - c.abs() * w);
            let ratio = at_w.length() / at_half.length();
            let bound = next_order + 8.0 * rounding / at_half.length();
            assert!(
                (ratio - 2.0).abs() <= bound,
                "w = 2^-{k}: {ratio}, bound {bound:e}"
            );
            // And the first order is the derivative.
            let off = (at_w - slope * w).length();
            let bound = next_order * (slope * w).length() + 2.0 * rounding;
            assert!(off <= bound, "w = 2^-{k}: {at_w}, derivative {slope}");
        }
        // From w = 2⁻⁶⁰ on the two are the same doubles, and a w below the range of doubles' squares changes nothing.
        for w in [2.0_f64.powi(-70), 1e-200, 1e-300, 5e-324] {
            assert_eq!(
                cast(plane, direction.extend(w), vertex),
                Some(sun),
                "w = {w:e}"
            );
            // Seen from the other side of the projective line: −w is far away in the opposite direction,
            // under the plane, where this vertex casts no shadow.
            assert_eq!(
                cast(plane, direction.extend(-w), vertex),
                None,
                "w = -{w:e}"
            );
        }
    }
}

/// A light sinking towards the plane: the shadow's length is V_y/h times its horizontal way, ~1/height.
#[test]
fn a_low_light_makes_a_long_shadow() {
    let v = DVec3::new(0.0, 20.0, 0.0);
    // The sun (1, h, 0): length 20/h, exactly, since h is a power of two.
    for k in 0..1000 {
        let h = 2.0_f64.powi(-k);
        let p = cast(Plane::GROUND, DVec4::new(1.0, h, 0.0, 0.0), v).unwrap();
        assert_eq!(p, DVec3::new(-20.0 / h, 0.0, 0.0), "h = 2^-{k}");
    }
    // A sun in the plane, and one so low that no double holds the shadow's end.
    assert_eq!(cast(Plane::GROUND, DVec4::X, v), None);
    assert_eq!(
        cast(Plane::GROUND, DVec4::new(1.0, 1e-310, 0.0, 0.0), v),
        None
    );
    // A lamp at height 20 + h: length (20 · 100)/h beyond the lamp's foot …
    for k in 0..40 {
        let h = 2.0_f64.powi(-k);
        let lamp = DVec4::new(100.0, 20.0 + h, 0.0, 1.0);
        let p = cast(Plane::GROUND, lamp, v).unwrap();
        assert_eq!(p.x, -2000.0 / h, "h = 2^-{k}");
    }
    // … which is gone when the lamp is level with the vertex or below it.
    for h in [20.0, 20.0_f64.next_down(), 10.0, 1e-300] {
        assert_eq!(cast(Plane::GROUND, DVec4::new(100.0, h, 0.0, 1.0), v), None);
    }
}

/// The shadow does not depend on how plane and light are written: any multiple of their coefficients, negative
/// ones included.
#[test]
fn multiples_of_plane_and_light_change_nothing() {
    for (light, expected) in EXAMPLES {
        for plane_factor in [1.0, -1.0, 3.0, -0.1, 1e300, -1e-300, 5e-324] {
            let plane = Plane {
                normal: DVec3::Y * plane_factor,
                d: 0.0,
            };
            for light_factor in [1.0, 3.0, 2.0_f64.powi(900), 2.0_f64.powi(-900)] {
                let light = light * light_factor;
                // −L is the same place; −D is the opposite direction, under the ground.
                let lights = if light.w == 0.0 {
                    vec![light]
                } else {
                    vec![light, -light]
                };
                for light in lights {
                    for (v, expected) in CUBE.into_iter().zip(expected) {
                        let p = cast(plane, light, v);
                        assert_eq!(p, Some(on_ground(expected)), "{plane:?} {light}");
                    }
                }
            }
        }
    }
    assert!(CUBE.iter().all(|&v| cast(Plane::GROUND, -SUN, v).is_none()));
}

/// The any-plane matrix is M = (π·L) I − L πᵀ, entry by entry, with the plane turned towards the light.
#[test]
fn the_matrix_is_the_formula() {
    let wall = Plane {
        normal: DVec3::new(1.0, 2.0, 3.0),
        d: 4.0,
    };
    for (light, w) in [
        (DVec3::new(3.0, 7.0, 2.0), 1.0),
        (DVec3::new(-3.0, -7.0, -2.0), 0.0),
    ] {
        let light = light.extend(w);
        let pi = wall.coefficients();
        let s = pi.dot(light);
        let outer = DMat4::from_cols(light * pi.x, light * pi.y, light * pi.z, light * pi.w);
        let formula = (DMat4::IDENTITY * s - outer) * s.signum();
        // All of these are small whole numbers.
        assert_eq!(shadow_matrix(wall, light).unwrap(), formula);
    }
}
