use super::about::is_true;
use super::*;
use crate::picture::{compare, paint, polygons};
use ombra_math::glam::{DMat4, DVec2, DVec3, DVec4};
use ombra_math::predicates::orient_3d;
use ombra_math::solids::{cuboid, torus};
use ombra_math::view::{Viewport, frustum, look_at, orthographic, perspective};
use ombra_math::work::Work;
use ombra_oracle::Exact;
use ombra_oracle::vector::{cross, dot, exact, minus};
use proptest::num::f64::ANY;
use proptest::prelude::*;

fn r(x: f64) -> Exact {
    Exact::new(x).unwrap()
}

fn r3(p: DVec3) -> [Exact; 3] {
    exact(p).unwrap()
}

/// All hits with their exact parameters, the nearest first, the first submitted where they tie.
fn oracle(scene: &[Polygon], line: SightLine) -> Vec<(Exact, usize)> {
    let (o, d) = (r3(line.origin), r3(line.direction));
    let hit = |(index, polygon): (usize, &Polygon)| {
        let [a, b, c] = polygon.span()?.map(r3);
        let normal = cross(&minus(&b, &a), &minus(&c, &a));
        let speed = dot(&normal, &d);
        let t = dot(&normal, &minus(&a, &o)).over(&speed)?;
        let p = [0, 1, 2].map(|i| &o[i] + &t * &d[i]);
        // Inside: p is on one side of all edges within the plane.
        let n = polygon.vertices.len();
        let sides: Vec<Exact> = (0..n)
            .map(|i| {
                let [a, b] = [i, (i + 1) % n].map(|i| r3(polygon.vertices[i]));
                dot(&normal, &cross(&minus(&b, &a), &minus(&p, &a)))
            })
            .collect();
        let inside = sides.iter().all(|s| *s >= 0) || sides.iter().all(|s| *s <= 0);
        (inside && t >= 0).then_some((t, index))
    };
    let mut hits: Vec<_> = scene.iter().enumerate().filter_map(hit).collect();
    hits.sort();
    hits
}

/// The hits are the oracle's, and their t within 2⁻⁴⁰.
fn check(scene: &[Polygon], line: SightLine) {
    let found = hits(scene, line);
    let expected = if line.direction == DVec3::ZERO {
        Vec::new()
    } else {
        oracle(scene, line)
    };
    assert_eq!(
        found.iter().map(|hit| hit.primitive).collect::<Vec<_>>(),
        expected.iter().map(|&(_, index)| index).collect::<Vec<_>>()
    );
    for (hit, (t, _)) in found.iter().zip(&expected) {
        let off = (r(hit.t) - t).abs();
        assert!(off <= t * r(libm::scalbn(1.0, -40)), "{} {t}", hit.t);
    }
}

fn polygon(vertices: &[(f64, f64, f64)]) -> Polygon {
    Polygon {
        vertices: vertices.iter().map(|&v| DVec3::from(v)).collect(),
    }
}

/// Often on a common plane, edge or point; often beside one by a little; sometimes anywhere.
fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![
        6 => (-3..4i32).prop_map(f64::from),
        2 => -4.0..4.0f64,
        1 => (-3..4i32, -1e-13..1e-13f64).prop_map(|(i, off)| f64::from(i) + off),
    ]
}

fn point() -> impl Strategy<Value = DVec3> {
    prop::array::uniform3(coordinate()).prop_map(DVec3::from)
}

/// Triangles, and parallelograms whose fourth corner is on the plane of the others exactly.
fn any_polygon() -> impl Strategy<Value = Polygon> {
    (prop::array::uniform3(point()), any::<bool>()).prop_map(|([a, b, c], fourth)| {
        let d = b + c - a;
        let fourth = fourth && orient_3d(a, b, c, d) == Some(Ordering::Equal);
        Polygon {
            vertices: if fourth {
                vec![a, b, d, c]
            } else {
                vec![a, b, c]
            },
        }
    })
}

fn camera(parallel: bool, eye: DVec3, size: u32) -> Camera {
    let projection = if parallel {
        orthographic(-3.0, 3.0, -2.0, 2.0, 0.25, 20.0)
    } else {
        frustum(-0.3, 0.3, -0.2, 0.2, 0.25, 20.0)
    };
    let view = look_at(eye, DVec3::new(0.1, 0.2, 0.3), DVec3::Y).unwrap();
    Camera {
        view_projection: projection.unwrap() * view,
        viewport: Viewport {
            width: size,
            height: size,
        },
    }
}

#[test]
fn a_plane_goes_on_beside_its_primitive_and_behind_the_eye() {
    // Errata E23: the nearest of all planes is that of the first, the nearest in front that of the second.
    let scene = [
        polygon(&[(-1.0, -1.0, 0.5), (1.0, -1.0, 0.5), (0.0, 1.0, 0.5)]),
        polygon(&[(5.0, 0.0, -1.0), (6.0, 0.0, -1.0), (5.0, 1.0, -1.0)]),
        polygon(&[(-1.0, -1.0, -3.0), (1.0, -1.0, -3.0), (0.0, 1.0, -3.0)]),
        polygon(&[(-1.0, -1.0, -9.0), (1.0, -1.0, -9.0), (0.0, 1.0, -9.0)]),
    ];
    let line = SightLine {
        origin: DVec3::ZERO,
        direction: -DVec3::Z,
    };
    let found: Vec<_> = hits(&scene, line)
        .iter()
        .map(|h| (h.primitive, h.t))
        .collect();
    assert_eq!(found, [(2, 3.0), (3, 9.0)]);
    let picture = |near: f64, far: f64| {
        let camera = Camera {
            view_projection: frustum(-near, near, -near, near, near, far).unwrap(),
            viewport: Viewport {
                width: 3,
                height: 3,
            },
        };
        let mut turned = scene.clone();
        turned
            .iter_mut()
            .for_each(|polygon| polygon.vertices.reverse());
        let picture = cast(&scene, &camera).unwrap();
        for scene in [&scene, &turned] {
            assert_eq!(cast(scene, &camera).unwrap(), picture);
            assert_eq!(cast_plain(scene, &camera, &mut ()).unwrap(), picture);
        }
        picture.get_pixel(1, 1).0[0]
    };
    assert_eq!(picture(0.25, 20.0), 2);
    // Beyond the near plane, and the far one; on the far one and on the near one.
    assert_eq!(picture(4.0, 20.0), 3);
    assert_eq!(picture(4.0, 8.0), NOTHING);
    assert_eq!(picture(1.0, 3.0), 2);
    assert_eq!(picture(3.0, 5.0), 2);
}

/// A last place before or behind the planes of near and far, turned either way: what rounded distances do not tell.
#[test]
fn near_and_far_to_the_last_place() {
    // z_clip = −2 z − 3, w = −z: w + z_clip ≥ 0 up to z = −1, w − z_clip ≥ 0 from z = −3 on, without rounding.
    let camera = Camera {
        view_projection: frustum(-1.0, 1.0, -1.0, 1.0, 1.0, 3.0).unwrap(),
        viewport: Viewport {
            width: 3,
            height: 3,
        },
    };
    for (z, seen) in [
        ((-1.0f64).next_up(), NOTHING),
        (-1.0, 0),
        ((-1.0f64).next_down(), 0),
        ((-3.0f64).next_up(), 0),
        (-3.0, 0),
        ((-3.0f64).next_down(), NOTHING),
    ] {
        let wall = polygon(&[(-9.0, -9.0, z), (9.0, -9.0, z), (0.0, 9.0, z)]);
        let mut turned = wall.clone();
        turned.vertices.reverse();
        for wall in [wall, turned] {
            let picture = cast_plain(&[wall], &camera, &mut ()).unwrap();
            assert!(picture.pixels().all(|p| p.0 == [seen]), "{z}");
        }
    }
}

#[test]
fn ties_go_to_the_first_submitted() {
    // Two pieces of one wall, their vertices far from alike, in either order; and the edge that two walls share.
    let small = polygon(&[(1.0, 1.0, -2.0), (3.0, 1.0, -1.0), (1.0, 3.0, -2.0)]);
    let large = polygon(&[
        (-7.0, 0.0, -6.0),
        (9.0, 0.0, 2.0),
        (9.0, 8.0, 2.0),
        (-7.0, 8.0, -6.0),
    ]);
    let line = SightLine {
        origin: DVec3::new(1.3, 1.7, 4.1),
        direction: DVec3::new(0.01, 0.02, -1.0),
    };
    let order = |scene: &[Polygon]| -> Vec<usize> {
        hits(scene, line).iter().map(|hit| hit.primitive).collect()
    };
    assert_eq!(
        order(&[small.clone(), large.clone(), small.clone()]),
        [0, 1, 2]
    );
    assert_eq!(order(&[large.clone(), small.clone()]), [0, 1]);
    // In a picture too, whichever comes first.
    let camera = camera(false, DVec3::new(2.0, 3.0, 5.0), 24);
    let count = |scene: [&Polygon; 2]| {
        let scene = scene.map(Clone::clone);
        let picture = cast(&scene, &camera).unwrap();
        assert_eq!(picture, cast_plain(&scene, &camera, &mut ()).unwrap());
        [0, 1].map(|id| picture.pixels().filter(|p| p.0 == [id]).count())
    };
    let [seen, all] = count([&small, &large]);
    assert!(seen > 0 && all > 0);
    assert_eq!(count([&large, &small]), [seen + all, 0]);
    let other = polygon(&[(1.0, 1.0, -2.0), (3.0, 1.0, -1.0), (1.0, -3.0, -9.0)]);
    let on_the_edge = SightLine {
        origin: DVec3::new(1.5, 1.0, 0.0),
        direction: -DVec3::Z,
    };
    let found = hits(&[other, small], on_the_edge);
    assert_eq!(
        found.iter().map(|h| (h.primitive, h.t)).collect::<Vec<_>>(),
        [(0, 1.75), (1, 1.75)]
    );
}

#[test]
fn degenerate() {
    let triangle = polygon(&[(-1.0, -1.0, -2.0), (1.0, -1.0, -2.0), (0.0, 1.0, -2.0)]);
    let at = |origin: DVec3, direction: DVec3| {
        hits(
            std::slice::from_ref(&triangle),
            SightLine { origin, direction },
        )
        .len()
    };
    let (o, z) = (DVec3::ZERO, DVec3::Z);
    let cases = [
        ("through the middle", o, -z, 1),
        ("away", o, z, 0),
        ("from the plane itself", -2.0 * z, -z, 1),
        ("from behind it", -3.0 * z, -z, 0),
        ("through a corner", DVec3::Y, -z, 1),
        ("beside a corner", DVec3::Y * 1.0f64.next_up(), -z, 0),
        ("along the plane", DVec3::new(-5.0, 0.0, -2.0), DVec3::X, 0),
        ("tiny direction", o, -1e-300 * z, 1),
        ("huge direction", o, -f64::MAX * z, 1),
        ("from far away", 1e300 * z, -z, 1),
        ("t beyond the largest double", 1e300 * z, -1e-300 * z, 0),
        ("no direction", o, o, 0),
        ("NaN", o, DVec3::NAN, 0),
        ("infinite", DVec3::INFINITY, -z, 0),
    ];
    for (name, origin, direction, expected) in cases {
        assert_eq!(at(origin, direction), expected, "{name}");
    }
    for (name, vertices) in [
        ("none", vec![]),
        ("two", vec![o - z, DVec3::X - z]),
        ("collinear", vec![o - z, DVec3::X - z, 2.0 * DVec3::X - z]),
        ("NaN", vec![o - z, DVec3::X - z, DVec3::NAN]),
        (
            "infinite",
            vec![o - z, DVec3::X - z, DVec3::Y * f64::INFINITY],
        ),
    ] {
        let line = SightLine {
            origin: o,
            direction: -z,
        };
        assert_eq!(hits(&[Polygon { vertices }], line), [], "{name}");
    }
    // Triangles at the two ends of the range of doubles.
    for scale in [1e-300, 1e150, 1e300] {
        let scaled = Polygon {
            vertices: triangle.vertices.iter().map(|&v| v * scale).collect(),
        };
        let line = SightLine {
            origin: o,
            direction: -z,
        };
        let found = hits(&[scaled.clone(), scaled], line);
        assert_eq!(
            found.iter().map(|h| (h.primitive, h.t)).collect::<Vec<_>>(),
            [(0, 2.0 * scale), (1, 2.0 * scale)]
        );
    }
}

/// A scene of size 8 at 10¹² to 10¹⁶: corners come out pixels away from where they are, and rays beside their pixels.
#[test]
fn fast_is_plain_far_from_the_origin() {
    let mut state = 88_172_645_463_325_252u64;
    let mut next = || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1u64 << 53) as f64 * 8.0 - 4.0
    };
    for (round, exponent) in (12..17).cycle().take(40).enumerate() {
        let far = libm::pow(10.0, f64::from(exponent)) * DVec3::new(1.0, -0.7, 0.4);
        let scene: Vec<_> = (0..12)
            .map(|_| Polygon {
                vertices: [(); 3]
                    .map(|()| far + DVec3::new(next(), next(), next()))
                    .to_vec(),
            })
            .collect();
        let near = camera(round % 2 == 0, DVec3::new(9.0, 4.0, 12.0), 24);
        let camera = Camera {
            view_projection: near.view_projection * DMat4::from_translation(-far),
            ..near
        };
        assert_eq!(
            cast(&scene, &camera),
            cast_plain(&scene, &camera, &mut ()),
            "{round}"
        );
    }
}

/// A line is its pixel's where neither its beginning nor its end is seen beside it.
#[test]
fn lines_beside_their_pixel_are_told() {
    for parallel in [false, true] {
        let camera = camera(parallel, DVec3::new(9.0, 4.0, 12.0), 24);
        let pixel = UVec2::new(7, 13);
        let line = |x: f64, y: f64| camera.sight_line(DVec2::new(x, y)).unwrap();
        let own = line(7.5, 13.5);
        let is_own = |line| is_true(line, Some(19.0), pixel, &camera);
        assert!(is_own(own) && is_own(line(7.9, 13.1)));
        for (x, y) in [(6.5, 13.5), (8.5, 13.5), (7.5, 12.5), (7.5, 14.5)] {
            let other = line(x, y);
            assert!(!is_own(other), "{x} {y}");
            // From the one to the other.
            let end = other.origin + 19.0 * other.direction;
            let direction = (end - own.origin) / 19.0;
            let slanted = SightLine { direction, ..own };
            assert!(!is_own(slanted), "{x} {y}");
            assert!(
                parallel
                    || !is_own(SightLine {
                        origin: other.origin,
                        ..own
                    }),
                "{x} {y}"
            );
        }
        assert!(!parallel || !is_true(own, None, pixel, &camera));
    }
}

#[test]
fn what_cannot_be_cast() {
    let good = camera(false, DVec3::new(3.0, 2.0, 5.0), 4);
    let with = |view_projection: DMat4| Camera {
        view_projection,
        ..good
    };
    for matrix in [
        DMat4::ZERO,
        DMat4::NAN,
        DMat4::from_diagonal(DVec4::new(1.0, 0.0, 1.0, 1.0)),
    ] {
        let plain = |polygons: &[Polygon], camera: &Camera| cast_plain(polygons, camera, &mut ());
        for cast in [cast, plain] {
            let error = cast(&[], &with(matrix)).unwrap_err();
            assert!(matches!(error, PictureError::NoEye { .. }), "{error}");
        }
    }
    let viewport = Viewport {
        width: u32::MAX,
        height: u32::MAX,
    };
    let error = cast(&[], &Camera { viewport, ..good }).unwrap_err();
    assert!(matches!(error, PictureError::Buffer(_)), "{error}");
    for (width, height) in [(0, 0), (0, 5), (5, 0)] {
        let viewport = Viewport { width, height };
        let empty = cast(&[], &Camera { viewport, ..good }).unwrap();
        assert_eq!(empty.dimensions(), (width, height));
    }
    assert!(cast(&[], &good).unwrap().pixels().all(|p| p.0 == [NOTHING]));
}

/// The near plane is parallel to the sight lines of the middle column: none of them begins anywhere.
#[test]
fn the_error_is_that_of_the_first_pixel() {
    let rows = [
        DVec4::X,
        DVec4::Y,
        DVec4::new(1.0, 0.0, 1.0, 0.5),
        DVec4::NEG_Z,
    ];
    let [x, y, z, w] = rows;
    let camera = Camera {
        view_projection: DMat4::from_cols(x, y, z, w).transpose(),
        viewport: Viewport {
            width: 3,
            height: 200,
        },
    };
    let pixel = UVec2::new(1, 0);
    for _ in 0..20 {
        let error = Err(PictureError::NoSightLine { pixel });
        assert_eq!(cast(&[], &camera), error);
        assert_eq!(cast_plain(&[], &camera, &mut ()), error);
    }
}

/// t is 10⁻⁴⁰⁰ and the like, in front of the origin and behind it.
#[test]
fn a_parameter_below_the_smallest_double_keeps_its_sign() {
    let at = |z: f64| polygon(&[(-1.0, -1.0, z), (1.0, -1.0, z), (0.0, 1.0, z)]);
    let smallest = f64::from_bits(1);
    for size in [1e30, 1e200, f64::MAX] {
        for turn in [1.0, -1.0] {
            let scene = [
                0.0,
                turn * smallest,
                -turn * smallest,
                2.0 * turn * smallest,
            ]
            .map(at);
            let line = SightLine {
                origin: DVec3::ZERO,
                direction: DVec3::new(0.0, 0.0, turn * size),
            };
            let found: Vec<_> = hits(&scene, line).iter().map(|hit| hit.primitive).collect();
            assert!(
                found.contains(&0) && found.contains(&1) && found.contains(&3),
                "{found:?}"
            );
            assert!(!found.contains(&2), "{found:?}");
        }
    }
}

/// Thousands whose t round to a few doubles, the farther submitted first: sorted, not exchanged two by two.
#[test]
fn many_at_one_depth_come_in_their_order() {
    let n = 3000;
    let tilted = |i: usize| {
        let far = -1.0 - f64::EPSILON * i as f64;
        polygon(&[(-1e6, -1.0, -1.0), (1.0, -1.0, far), (1.0, 2.0, far)])
    };
    let mut scene: Vec<_> = (0..n).rev().map(tilted).collect();
    // Equal ones as submitted.
    scene.extend((0..n).map(|_| tilted(0)));
    let line = SightLine {
        origin: DVec3::new(-999_000.0, -0.9999, 0.0),
        direction: DVec3::NEG_Z,
    };
    let found: Vec<_> = hits(&scene, line).iter().map(|hit| hit.primitive).collect();
    let expected = (n - 1..2 * n).chain((0..n - 1).rev());
    assert!(found.into_iter().eq(expected));
}

#[test]
fn work_is_counted_where_it_happens() {
    let scene = polygons(&torus(2.0, 0.7, 16, 8).unwrap());
    let camera = camera(false, DVec3::new(4.0, 5.0, 6.0), 40);
    let (mut plain, mut fast) = (Work::default(), Work::default());
    let pictures = [
        cast_plain(&scene, &camera, &mut plain).unwrap(),
        counted::cast(&scene, &camera, &mut fast).unwrap(),
    ];
    assert_eq!(pictures[0], pictures[1]);
    assert_eq!((plain.rays, plain.intersections), (1600, 1600 * 256));
    // The boxes leave out all but the primitives about each pixel.
    assert!(
        fast.rays == 1600 && fast.intersections < 1600 * 256 / 10,
        "{fast}"
    );
    let mut line = Work::default();
    let seen = pictures[0]
        .enumerate_pixels()
        .find(|(.., p)| p.0 != [NOTHING]);
    let (x, y, _) = seen.unwrap();
    let sight = camera
        .sight_line(UVec2::new(x, y).as_dvec2() + 0.5)
        .unwrap();
    assert!(!counted::hits(&scene, sight, &mut line).is_empty());
    assert_eq!((line.rays, line.intersections), (1, 256));
}

#[test]
fn an_eye_in_a_solid_sees_its_inside() {
    let scene = polygons(&cuboid(DVec3::splat(-2.0), DVec3::splat(2.0)).unwrap());
    let camera = camera(false, DVec3::new(0.5, -0.25, 0.75), 16);
    let picture = cast(&scene, &camera).unwrap();
    assert!(picture.pixels().all(|p| p.0 != [NOTHING]));
    assert_eq!(picture, cast_plain(&scene, &camera, &mut ()).unwrap());
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1500))]

    #[test]
    fn hits_are_the_exact_ones(
        scene in prop::collection::vec(any_polygon(), 0..6),
        origin in point(),
        direction in point(),
        scale in prop_oneof![4 => Just(0), 1 => -200..200i32],
    ) {
        // Powers of two change nothing but the exponents.
        let scaled = |p: DVec3| DVec3::from_array(p.to_array().map(|x| libm::scalbn(x, scale)));
        let scene: Vec<_> = scene
            .iter()
            .map(|polygon| Polygon { vertices: polygon.vertices.iter().map(|&v| scaled(v)).collect() })
            .collect();
        let line = SightLine { origin: scaled(origin), direction };
        check(&scene, line);
    }

}

proptest! {
    // Rationals of full doubles take some 10 ms a case.
    #![proptest_config(ProptestConfig::with_cases(80))]

    /// Triangles with common corners, and a line that passes an edge or a corner as closely as doubles allow: depths and
    /// sides that rounding does not tell.
    #[test]
    fn hits_at_common_edges_are_the_exact_ones(
        corners in prop::array::uniform5(prop::array::uniform3(-10.0..10.0f64)),
        triangles in prop::collection::vec(prop::sample::subsequence(vec![0, 1, 2, 3, 4], 3).prop_shuffle(), 1..6),
        origin in prop::array::uniform3(-10.0..10.0f64),
        share in prop_oneof![1 => Just(0.0), 3 => 0.0..1.0f64],
    ) {
        let corners = corners.map(DVec3::from);
        let scene: Vec<_> = triangles
            .iter()
            .map(|t| Polygon { vertices: t.iter().map(|&i| corners[i]).collect() })
            .collect();
        let target = corners[triangles[0][0]].lerp(corners[triangles[0][1]], share);
        let origin = DVec3::from(origin);
        for direction in [target - origin, (target - origin).normalize()] {
            check(&scene, SightLine { origin, direction });
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(150))]

    /// The fast form is the plain one; and both are the first hit of each sight line.
    #[test]
    fn fast_is_plain(
        scene in prop::collection::vec(any_polygon(), 0..7),
        eye in prop::array::uniform3(-5.0..5.0f64),
        parallel: bool,
    ) {
        let camera = camera(parallel, DVec3::from(eye), 12);
        let picture = cast(&scene, &camera).unwrap();
        prop_assert_eq!(&picture, &cast_plain(&scene, &camera, &mut ()).unwrap());
        for (x, y, pixel) in picture.enumerate_pixels() {
            let line = camera.sight_line(UVec2::new(x, y).as_dvec2() + 0.5).unwrap();
            // The far plane is 20 away, nothing of the scene more than 12√3; farther along the slanted lines of the rim.
            let first = hits(&scene, line).first().map_or(NOTHING, |hit| hit.primitive as u32);
            prop_assert_eq!(pixel.0, [first]);
        }
    }

    /// Painted alone, a primitive covers the pixels whose rays meet it, save on its border.
    #[test]
    fn a_primitive_is_where_its_rays_are(
        scene in any_polygon(),
        eye in prop::array::uniform3(-5.0..5.0f64),
        parallel: bool,
    ) {
        let camera = camera(parallel, DVec3::from(eye), 24);
        let scene = [scene];
        let painted = paint([(0, &scene[0])], &camera).unwrap();
        let difference = compare(&painted, &cast(&scene, &camera).unwrap(), &scene, &camera).unwrap();
        // 24 pixels, and coordinates some 20 times the near distance: a few dozen roundings.
        prop_assert!(difference.farthest <= 1024.0 * 24.0 * f64::EPSILON, "{:?}", difference);
    }

    #[test]
    fn never_panics(
        corners in prop::collection::vec(prop::array::uniform3(ANY), 0..10),
        o in prop::array::uniform3(ANY),
        d in prop::array::uniform3(ANY),
        m in prop::array::uniform16(ANY),
        near in -3.0..3.0f64,
    ) {
        let scene: Vec<_> = corners
            .chunks(4)
            .map(|c| Polygon { vertices: c.iter().map(|&v| DVec3::from(v)).collect() })
            .collect();
        let line = SightLine { origin: DVec3::from(o), direction: DVec3::from(d) };
        let _ = hits(&scene, line);
        let viewport = Viewport { width: 3, height: 2 };
        for view_projection in [
            DMat4::from_cols_array(&m),
            perspective(near, 1.0, 0.1, 1e9).unwrap_or(DMat4::IDENTITY),
        ] {
            let camera = Camera { view_projection, viewport };
            let _ = cast(&scene, &camera);
            let _ = cast_plain(&scene, &camera, &mut ());
        }
    }
}
