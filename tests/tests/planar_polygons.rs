//! Shadow polygons and fake shadows at the ends: too few corners, corners in line, no area, every size.

use ombra_math::glam::{DVec3, DVec4, dvec3, dvec4};
use ombra_math::plane::Plane;
use ombra_oracle::Exact;
use ombra_shadows::fake::ellipse;
use ombra_shadows::planar::{cast, cast_onto, cast_polygon, cast_polygon_each};

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

#[test]
fn polygons_at_the_ends() {
    let [a, b, c] = TRIANGLE;
    // Fewer than three corners have no area and cast none.
    for polygon in [&[][..], &[a], &[a, b]] {
        assert_eq!(cast_polygon(Plane::GROUND, LAMP, polygon), []);
        assert_eq!(cast_onto(&FLOOR, LAMP, polygon), []);
        assert_eq!(cast_onto(polygon, LAMP, &TRIANGLE), []);
    }
    assert_eq!(ellipse(&[], Plane::GROUND, LAMP), None);
    let dot = ellipse(&[a], Plane::GROUND, LAMP).unwrap();
    assert_eq!(
        (dot.center, dot.u, dot.v),
        (dvec3(0.0, 0.0, -25.0), DVec3::ZERO, DVec3::ZERO)
    );

    // Whole polygons cast corner by corner, in order.
    let cast_each = |polygon: &[DVec3], light: DVec4| -> Vec<DVec4> {
        polygon
            .iter()
            .map(|&v| cast(Plane::GROUND, light, v).unwrap().extend(1.0))
            .collect()
    };
    let bent = [a, b, dvec3(2.0, 20.0, 2.0), c];
    for light in [SUN, LAMP, -LAMP] {
        for polygon in [&TRIANGLE[..], &bent] {
            assert_eq!(
                cast_polygon(Plane::GROUND, light, polygon),
                cast_each(polygon, light)
            );
        }
    }
    // Repeated corners and corners in line cast no other region.
    let repeated = [a, a, b, b, b, c, a];
    let in_line = [a, a.midpoint(b), b, b.midpoint(c), c];
    for polygon in [&repeated[..], &in_line] {
        let shadow = cast_polygon(Plane::GROUND, LAMP, polygon);
        assert_eq!(area(&shadow), area(&cast_each(&TRIANGLE, LAMP)));
        let onto: Vec<DVec4> = cast_onto(&FLOOR, LAMP, polygon)
            .iter()
            .map(|p| p.extend(1.0))
            .collect();
        assert_eq!(area(&onto), area(&shadow));
    }
    // A polygon without area, or edge-on to the light, casts none.
    for line in [
        [a, a, a],
        [a, b, a.midpoint(b)],
        [a, dvec3(0.0, 30.0, 10.0), dvec3(0.0, 60.0, 50.0)],
    ] {
        assert_eq!(
            area(&cast_polygon(Plane::GROUND, LAMP, &line)),
            0.0,
            "{line:?}"
        );
    }
    // Under the ground, above the lamp, touching the ground from below: nothing.
    for moved in [-30.0, 90.0, -20.0 - 1e-9] {
        let polygon = TRIANGLE.map(|v| v + dvec3(0.0, moved, 0.0));
        assert_eq!(
            cast_polygon(Plane::GROUND, LAMP, &polygon),
            [],
            "moved by {moved}"
        );
        assert_eq!(cast_onto(&FLOOR, LAMP, &polygon), [], "moved by {moved}");
    }
    let touching = [
        dvec3(0.0, 0.0, 0.0),
        dvec3(1.0, -1.0, 0.0),
        dvec3(0.0, -1.0, 1.0),
    ];
    assert_eq!(cast_polygon(Plane::GROUND, LAMP, &touching), []);
    // On the ground: its own shadow.
    let flat = TRIANGLE.map(|v| dvec3(v.x, 0.0, v.z));
    assert_eq!(
        cast_polygon(Plane::GROUND, SUN, &flat),
        flat.map(|v| v.extend(1.0))
    );

    // A receiver without area, in a line, or edge-on to the light: nothing falls on it.
    for receiver in [[a, a, a, a], [a, b, a.midpoint(b), a]] {
        assert_eq!(cast_onto(&receiver, LAMP, &TRIANGLE), []);
    }
    let wall_along = [
        dvec3(0.0, 0.0, 0.0),
        dvec3(0.0, 9.0, 0.0),
        dvec3(0.0, 9.0, 9.0),
    ];
    assert_eq!(cast_onto(&wall_along, LAMP, &TRIANGLE), []);
}

/// Corners so far out, so near or of so different a size that their shadow is not a double keep their place by w.
#[test]
fn polygons_of_every_size() {
    for k in [-1000, -500, 500, 1000] {
        let size = 2.0_f64.powi(k);
        let light = dvec4(LAMP.x * size, LAMP.y * size, LAMP.z * size, 1.0);
        let shadow = cast_polygon(Plane::GROUND, light, &TRIANGLE.map(|v| v * size));
        let expected = cast_polygon(Plane::GROUND, LAMP, &TRIANGLE)
            .iter()
            .map(|p| (p.truncate() * size).extend(1.0))
            .collect::<Vec<_>>();
        assert_eq!(shadow, expected, "2^{k}");
    }
    // The corner (MAX, MAX, 0) under the sun (−1, 1, 0) is cast to (2 MAX, 0, 0).
    let far = [
        dvec3(MAX, MAX, 0.0),
        dvec3(0.0, 1.0, 0.0),
        dvec3(0.0, 1.0, 1.0),
    ];
    let shadow = cast_polygon(Plane::GROUND, dvec4(-1.0, 1.0, 0.0, 0.0), &far);
    assert_eq!(shadow.len(), 3);
    let beyond = shadow.iter().find(|p| p.w != 1.0).unwrap();
    assert!(
        beyond.w > 0.0 && beyond.w < 1.0 && beyond.x / 2.0 / beyond.w == MAX,
        "{beyond}"
    );
    assert_eq!((beyond.y, beyond.z), (0.0, 0.0));
}

/// A corner level with the light casts a direction, and a direction has no length: however far apart lamp and corner
/// are, it is written with finite coordinates.
#[test]
fn directions_are_finite() {
    let corner = dvec3(MAX, 0.0, 0.0);
    let level = [corner, dvec3(MAX, 2.0, 0.0), dvec3(MAX, 0.0, 1.0)];
    for lamp in [
        dvec4(-MAX, 1.0, 0.0, 1.0),
        dvec4(-1e10, 1e-300, 0.0, 1e-300),
        dvec4(-1.0, LEAST, 0.0, LEAST),
    ] {
        let shadow = cast_polygon(Plane::GROUND, lamp, &level);
        assert!(shadow.iter().all(|p| p.is_finite()), "{lamp}: {shadow:?}");
        // Away from the lamp, so towards +x; y and z are nothing beside it.
        let far: Vec<_> = shadow.iter().filter(|p| p.w == 0.0).collect();
        assert!(!far.is_empty(), "{lamp}: {shadow:?}");
        assert!(
            far.iter()
                .all(|p| p.x > 0.0 && p.y == 0.0 && p.z.abs() <= p.x * 1e-300),
            "{lamp}: {shadow:?}"
        );
    }
}

/// A receiver, caster and lamp made larger or smaller together: the same region, at every size.
#[test]
fn receivers_of_every_size() {
    let caster = [
        dvec3(50.0, -80.0, 150.0),
        dvec3(110.0, 120.0, 130.0),
        dvec3(220.0, 260.0, 120.0),
        dvec3(270.0, 200.0, 130.0),
        dvec3(210.0, 0.0, 150.0),
        dvec3(100.0, -140.0, 160.0),
    ];
    let receiver = [
        dvec3(20.0, -180.0, 360.0),
        dvec3(220.0, 100.0, 320.0),
        dvec3(480.0, 480.0, 240.0),
        dvec3(280.0, 200.0, 280.0),
    ];
    let lamp = dvec3(100.0, -130.0, -120.0);
    let at_size = |size: f64| {
        let scaled = |polygon: &[DVec3]| polygon.iter().map(|&v| v * size).collect::<Vec<_>>();
        cast_onto(
            &scaled(&receiver),
            (lamp * size).extend(2.0),
            &scaled(&caster),
        )
    };
    let expected = at_size(1.0);
    assert_eq!(expected.len(), 6);
    for k in (-1000..=1000).step_by(20) {
        let size = Exact::power_of_two(k).nearest();
        let found = at_size(size);
        assert_eq!(found.len(), expected.len(), "2^{k}");
        for (p, expected) in found.iter().zip(&expected) {
            // Twice the stated 8 ε of the receiver's largest coordinate.
            let off = (*p / size - *expected).abs().max_element();
            assert!(
                off <= 16.0 * f64::EPSILON * 480.0,
                "2^{k}: {} against {expected}",
                *p / size
            );
        }
    }
}

/// Twice the area of a polygon of places in a plane y = const.
fn area(polygon: &[DVec4]) -> f64 {
    let next = polygon.iter().cycle().skip(1);
    let sum: f64 = polygon
        .iter()
        .zip(next)
        .map(|(a, b)| a.x * b.z - a.z * b.x)
        .sum();
    sum.abs()
}

#[test]
fn several_lights_are_several_shadows() {
    let lights = [
        SUN,
        LAMP,
        DVec4::X,
        -LAMP,
        DVec4::ZERO,
        dvec4(f64::NAN, 1.0, 0.0, 0.0),
    ];
    let shadows = cast_polygon_each(Plane::GROUND, &lights, &TRIANGLE);
    let each: Vec<_> = lights
        .iter()
        .map(|&l| cast_polygon(Plane::GROUND, l, &TRIANGLE))
        .collect();
    assert_eq!(shadows, each);
    assert_eq!(
        shadows.iter().map(Vec::len).collect::<Vec<_>>(),
        [3, 3, 0, 3, 0, 0]
    );
    assert!(cast_polygon_each(Plane::GROUND, &[], &TRIANGLE).is_empty());
}

/// The fake shadow: its centre is the shadow of the middle of the object's box, its axes lie in the plane, at
/// right angles, as long as half the object is wide along them; however small or large the object.
#[test]
fn fake_shadows() {
    let object = [
        dvec3(0.0, 20.0, 0.0),
        dvec3(10.0, 20.0, 0.0),
        dvec3(10.0, 30.0, 4.0),
        dvec3(0.0, 24.0, 4.0),
    ];
    let middle = dvec3(5.0, 25.0, 2.0);
    for plane in [
        Plane::GROUND,
        plane(1.0, 2.0, 3.0, 4.0),
        plane(0.0, 0.0, -7.0, 3e-3),
    ] {
        for light in [SUN, LAMP, -LAMP] {
            let Some(centre) = cast(plane, light, middle) else {
                assert_eq!(ellipse(&object, plane, light), None);
                continue;
            };
            let e = ellipse(&object, plane, light).unwrap();
            assert_eq!(e.center, centre, "{plane:?} {light}");
            let n = plane.normal.normalize();
            // Lengths up to 30, each axis some ten roundings.
            let tolerance = 16.0 * 30.0 * f64::EPSILON;
            assert!(e.u.dot(n).abs() <= tolerance && e.v.dot(n).abs() <= tolerance);
            assert!(e.u.normalize().dot(e.v.normalize()).abs() <= 16.0 * f64::EPSILON);
            for axis in [e.u, e.v] {
                let along = object.map(|v| v.dot(axis.normalize()));
                let (low, high) = along
                    .iter()
                    .fold((MAX, -MAX), |(l, h), &x| (l.min(x), h.max(x)));
                assert!(
                    (axis.length() - (high - low) / 2.0).abs() <= tolerance,
                    "{axis}"
                );
            }
            for k in [-900, 900] {
                let size = 2.0_f64.powi(k);
                let light = dvec4(light.x * size, light.y * size, light.z * size, light.w);
                let plane = Plane {
                    normal: plane.normal,
                    d: plane.d * size,
                };
                let other = ellipse(&object.map(|v| v * size), plane, light).unwrap();
                assert_eq!(
                    (other.center, other.u, other.v),
                    (e.center * size, e.u * size, e.v * size),
                    "2^{k}"
                );
            }
        }
    }
    // The middle has no true shadow: under the ground, above the lamp, along the ground.
    let moved = |y: f64| object.map(|v| v + dvec3(0.0, y, 0.0));
    assert_eq!(ellipse(&moved(-30.0), Plane::GROUND, LAMP), None);
    assert_eq!(ellipse(&moved(80.0), Plane::GROUND, LAMP), None);
    assert_eq!(ellipse(&object, Plane::GROUND, DVec4::X), None);
    // A box from −MAX to MAX is wider than any double, its half is not.
    let widest = [dvec3(-MAX, 1.0, -MAX), dvec3(MAX, 1.0, MAX)];
    let e = ellipse(&widest, Plane::GROUND, DVec4::Y).unwrap();
    assert_eq!(
        (e.center, e.u.abs(), e.v.abs()),
        (DVec3::ZERO, DVec3::X * MAX, DVec3::Z * MAX)
    );
}
