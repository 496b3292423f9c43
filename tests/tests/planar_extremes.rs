//! The shadow of a point at the ends of the numbers: what every function gives for input that is degenerate, huge,
//! tiny or not finite.

use ombra_math::glam::{DVec3, DVec4, dvec3, dvec4};
use ombra_math::plane::Plane;
use ombra_shadows::fake::ellipse;
use ombra_shadows::planar::{
    Placement, cast, cast_onto, cast_polygon, classify, ground_matrix_directional,
    ground_matrix_point, shadow_matrix, textbook,
};
use ombra_tests::shadow::ExactShadow;

fn by_quotient(plane: Plane, light: DVec4, v: DVec3) -> Option<DVec3> {
    textbook::by_quotient(plane, light, v, &mut ())
}

fn by_parameter(plane: Plane, light: DVec4, v: DVec3) -> Option<DVec3> {
    textbook::by_parameter(plane, light, v, &mut ())
}

const MAX: f64 = f64::MAX;

/// The smallest double above zero.
const LEAST: f64 = 5e-324;

const SUN: DVec4 = dvec4(1.0, 2.0, 1.0, 0.0);

const LAMP: DVec4 = dvec4(0.0, 100.0, 100.0, 1.0);

const TRIANGLE: [DVec3; 3] = [
    dvec3(0.0, 20.0, 0.0),
    dvec3(10.0, 20.0, 0.0),
    dvec3(0.0, 20.0, 10.0),
];

const FLOOR: [DVec3; 4] = [
    dvec3(-50.0, 0.0, -50.0),
    dvec3(50.0, 0.0, -50.0),
    dvec3(50.0, 0.0, 50.0),
    dvec3(-50.0, 0.0, 50.0),
];

const fn plane(a: f64, b: f64, c: f64, d: f64) -> Plane {
    Plane {
        normal: dvec3(a, b, c),
        d,
    }
}

/// What the table of points expects.
type Row = (
    &'static str,
    Plane,
    DVec4,
    DVec3,
    Option<Placement>,
    Option<DVec3>,
);

/// The table: plane, light, vertex, then what `classify` says and `cast` gives.
#[rustfmt::skip]
fn table() -> Vec<Row> {
    use Placement::{BehindPlane, BeyondLight, Casts, LevelWithLight, LightAlongPlane};
    let ground = Plane::GROUND;
    let v = dvec3(1.0, 2.0, 3.0);
    let above = dvec4(0.0, 1.0, 0.0, 0.0);
    vec![
        ("no normal", plane(0.0, 0.0, 0.0, 1.0), SUN, v, None, None),
        ("no light", ground, DVec4::ZERO, v, None, None),
        ("no light, signs", ground, -DVec4::ZERO, v, None, None),
        ("light along the plane", ground, DVec4::X, v, Some(LightAlongPlane), None),
        ("lamp on the plane", ground, dvec4(5.0, 0.0, 5.0, 1.0), v, Some(LightAlongPlane), None),
        ("lamp at the origin on it", ground, DVec4::W, v, Some(LightAlongPlane), None),
        ("vertex on the plane", ground, LAMP, dvec3(7.0, 0.0, -3.0), Some(Casts), Some(dvec3(7.0, 0.0, -3.0))),
        ("vertex on it, under the sun", ground, SUN, dvec3(7.0, -0.0, -3.0), Some(Casts), Some(dvec3(7.0, 0.0, -3.0))),
        ("vertex under the ground", ground, SUN, dvec3(7.0, -LEAST, -3.0), Some(BehindPlane), None),
        ("vertex at the lamp", ground, LAMP, dvec3(0.0, 100.0, 100.0), Some(LevelWithLight), None),
        ("level with the lamp", ground, LAMP, dvec3(9.0, 100.0, 0.0), Some(LevelWithLight), None),
        ("just under the lamp's height", ground, LAMP, dvec3(0.0, 100.0_f64.next_down(), 100.0), Some(Casts), Some(dvec3(0.0, 0.0, 100.0))),
        ("just above it", ground, LAMP, dvec3(0.0, 100.0_f64.next_up(), 100.0), Some(BeyondLight), None),
        ("the lamp as −L", ground, -LAMP, dvec3(0.0, 20.0, 0.0), Some(Casts), Some(dvec3(0.0, 0.0, -25.0))),
        ("the ground turned round", ground.turned(), LAMP, dvec3(0.0, 20.0, 0.0), Some(Casts), Some(dvec3(0.0, 0.0, -25.0))),
        ("a lamp under the ground", ground, dvec4(0.0, -100.0, 100.0, 1.0), dvec3(0.0, -20.0, 0.0), Some(Casts), Some(dvec3(0.0, 0.0, -25.0))),
        ("and a vertex over it", ground, dvec4(0.0, -100.0, 100.0, 1.0), dvec3(0.0, 20.0, 0.0), Some(BehindPlane), None),
        ("the sun's opposite", ground, -SUN, v, Some(BehindPlane), None),
        // Multiples of the plane: 5 · (0,1,0,0), huge and subnormal ones.
        ("a longer normal", plane(0.0, 5.0, 0.0, 0.0), SUN, v, Some(Casts), Some(dvec3(0.0, 0.0, 2.0))),
        ("a huge plane", plane(0.0, MAX, 0.0, -MAX), SUN, v, Some(Casts), Some(dvec3(0.5, 1.0, 2.5))),
        ("a subnormal plane", plane(0.0, LEAST, 0.0, -LEAST), SUN, v, Some(Casts), Some(dvec3(0.5, 1.0, 2.5))),
        ("a plane at 10³⁰⁰", plane(0.0, 1.0, 0.0, 1e300), above, v, Some(Casts), Some(dvec3(1.0, -1e300, 3.0))),
        ("a plane at −MAX", plane(0.0, 1.0, 0.0, MAX), above, v, Some(Casts), Some(dvec3(1.0, -MAX, 3.0))),
        ("a plane beyond all doubles", plane(0.0, 0.25, 0.0, MAX), above, v, Some(Casts), None),
        // Lights of every length.
        ("a huge sun", ground, dvec4(MAX / 2.0, MAX, MAX / 2.0, 0.0), v, Some(Casts), Some(dvec3(0.0, 0.0, 2.0))),
        ("a subnormal sun", ground, dvec4(LEAST, 2.0 * LEAST, LEAST, 0.0), v, Some(Casts), Some(dvec3(0.0, 0.0, 2.0))),
        ("a low sun, far shadow", ground, dvec4(1.0, 1e-300, 0.0, 0.0), v, Some(Casts), Some(dvec3(-2.0 / 1e-300, 0.0, 3.0))),
        ("a lower sun, too far", ground, dvec4(1.0, 1e-308, 0.0, 0.0), v, Some(Casts), None),
        ("a sun of 2⁶⁰⁰ over 2⁻⁶⁰⁰", ground, dvec4(2.0_f64.powi(600), 2.0_f64.powi(-600), 0.0, 0.0), v, Some(Casts), None),
        ("a lamp of w = 2⁻¹⁰⁷⁴", ground, dvec4(0.0, 100.0 * LEAST, 100.0 * LEAST, LEAST), dvec3(0.0, 20.0, 0.0), Some(Casts), Some(dvec3(0.0, 0.0, -25.0))),
        ("a lamp so far it is a sun", ground, dvec4(1.0, 2.0, 1.0, LEAST), v, Some(Casts), Some(dvec3(0.0, 0.0, 2.0))),
        ("and its negative, under us", ground, dvec4(1.0, 2.0, 1.0, -LEAST), v, Some(BehindPlane), None),
        ("a lamp at MAX", ground, dvec4(0.0, MAX, 0.0, 1.0), dvec3(5.0, 1.0, 7.0), Some(Casts), Some(dvec3(5.0, 0.0, 7.0))),
        ("a lamp at w = MAX, all at the origin", ground, dvec4(0.0, MAX, 0.0, MAX), dvec3(5.0, 0.5, 7.0), Some(Casts), Some(dvec3(10.0, 0.0, 14.0))),
        // Vertices at the ends.
        ("a vertex at MAX", ground, dvec4(1.0, 1.0, 1.0, 0.0), DVec3::MAX, Some(Casts), Some(DVec3::ZERO)),
        ("from MAX to −MAX", ground, dvec4(2.0, 1.0, 2.0, 0.0), DVec3::MAX, Some(Casts), Some(dvec3(-MAX, 0.0, -MAX))),
        ("beyond −MAX", ground, dvec4(3.0, 1.0, 2.0, 0.0), DVec3::MAX, Some(Casts), None),
        ("subnormal vertex", ground, dvec4(1.0, 1.0, -1.0, 0.0), DVec3::splat(LEAST), Some(Casts), Some(dvec3(0.0, 0.0, 2.0 * LEAST))),
        ("subnormal vertex under the lamp", ground, LAMP, DVec3::splat(LEAST), Some(Casts), Some(dvec3(LEAST, 0.0, 0.0))),
        ("a subnormal scene", ground, dvec4(0.0, 100.0 * LEAST, 100.0 * LEAST, 1.0), dvec3(0.0, 20.0 * LEAST, 0.0), Some(Casts), Some(dvec3(0.0, 0.0, -25.0 * LEAST))),
    ]
}

#[test]
fn the_table_of_points() {
    for (name, plane, light, v, placement, shadow) in table() {
        assert_eq!(classify(plane, light, v), placement, "{name}");
        assert_eq!(cast(plane, light, v), shadow, "{name}");
        // The rows themselves, by the other hand.
        let exact = ExactShadow::new(plane, light, v);
        assert_eq!(
            exact.and_then(|exact| exact.answer()),
            shadow,
            "{name}: the row"
        );
        // The plain forms may lose such a shadow, but not invent one that is not finite.
        for plain in [by_quotient, by_parameter] {
            let p = plain(plane, light, v);
            assert!(p.is_none_or(DVec3::is_finite), "{name}: {p:?}");
        }
        // One shadow of a polygon is that of its corners, so no corner, no polygon.
        if placement.is_none() || placement == Some(Placement::LightAlongPlane) {
            assert_eq!(cast_polygon(plane, light, &TRIANGLE), [], "{name}");
            assert!(shadow_matrix(plane, light).is_err(), "{name}");
            assert_eq!(ellipse(&TRIANGLE, plane, light), None, "{name}");
        } else {
            assert!(shadow_matrix(plane, light).is_ok(), "{name}");
        }
    }
}

/// A coordinate that is not finite, in any of the eleven places, is refused by every function.
#[test]
fn not_finite_is_refused() {
    let good = [0.0, 1.0, 0.0, 0.0, 0.0, 100.0, 100.0, 1.0, 0.0, 20.0, 0.0];
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for place in 0..11 {
            let mut x = good;
            x[place] = bad;
            let plane = plane(x[0], x[1], x[2], x[3]);
            let (light, v) = (dvec4(x[4], x[5], x[6], x[7]), dvec3(x[8], x[9], x[10]));
            let at = format!("{bad} at {place}");
            for answer in [cast, by_quotient, by_parameter] {
                assert_eq!(answer(plane, light, v), None, "{at}");
            }
            assert_eq!(classify(plane, light, v), None, "{at}");
            let polygon = [v, TRIANGLE[1], TRIANGLE[2]];
            assert_eq!(cast_polygon(plane, light, &polygon), [], "{at}");
            assert_eq!(ellipse(&polygon, plane, light), None, "{at}");
            if place >= 4 {
                assert_eq!(cast_onto(&FLOOR, light, &polygon), [], "{at}");
            }
            if place < 8 {
                let refused = shadow_matrix(plane, light).unwrap_err().to_string();
                // A sentence that names what was given.
                assert!(refused.len() > 20, "{at}: {refused}");
            }
            if (4..7).contains(&place) {
                assert!(ground_matrix_directional(light.truncate()).is_err(), "{at}");
                assert!(ground_matrix_point(light.truncate()).is_err(), "{at}");
            }
            let mut floor = FLOOR;
            floor[place % 4][place % 3] = bad;
            assert_eq!(cast_onto(&floor, LAMP, &TRIANGLE), [], "{at}");
        }
    }
}
