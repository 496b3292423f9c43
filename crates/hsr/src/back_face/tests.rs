use super::*;
use crate::picture::counted::paint;
use crate::picture::polygons;
use ombra_math::solids::{cuboid, slide_cube, sphere, tetrahedron, torus};
use ombra_math::triangle::normal;
use ombra_math::view::{Viewport, frustum, look_at, orthographic, perspective};
use ombra_math::work::Work;
use ombra_oracle::Exact;
use proptest::num::f64::ANY;
use proptest::prelude::*;

fn camera(parallel: bool, eye: DVec3) -> Camera {
    let projection = if parallel {
        orthographic(-4.0, 4.0, -4.0, 4.0, 0.5, 90.0)
    } else {
        perspective(0.9, 1.0, 0.5, 90.0)
    };
    Camera {
        view_projection: projection.unwrap() * look_at(eye, DVec3::ZERO, DVec3::Y).unwrap(),
        viewport: Viewport {
            width: 97,
            height: 97,
        },
    }
}

/// Closed, with their faces outward, within 4 of the origin.
fn closed() -> Vec<(&'static str, Mesh)> {
    vec![
        ("tetrahedron", scaled(tetrahedron(), 1.7)),
        (
            "cuboid",
            cuboid(DVec3::NEG_ONE, DVec3::new(2.0, 1.0, 0.5)).unwrap(),
        ),
        ("sphere", sphere(1.5, 24, 12).unwrap()),
        ("torus", torus(1.2, 0.5, 32, 16).unwrap()),
    ]
}

fn scaled(mut mesh: Mesh, factor: f64) -> Mesh {
    for p in &mut mesh.positions {
        *p *= factor;
    }
    mesh
}

#[test]
fn the_slide_cube() {
    let cube = slide_cube();
    let eye = DVec3::new(30.0, 40.0, 50.0);
    let kept = visible(&cube, eye.extend(1.0));
    assert_eq!(kept.len(), 6);
    // By hand: the eye is beyond x = 10, y = 30 and z = 10, and not beyond the three opposite faces.
    for i in 0..12 {
        let corners = cube.triangle(i).unwrap();
        let on = |axis: usize, at: f64| corners.iter().all(|p| p[axis] == at);
        let expected = on(0, 10.0) || on(1, 30.0) || on(2, 10.0);
        assert_eq!(kept.contains(&i), expected, "{corners:?}");
        let n = normal(corners[0], corners[1], corners[2]);
        assert_eq!(is_front_facing(n, eye - corners[0]), expected);
    }
    // Under the light of the decks, at infinity and at a place in whose direction x = 0 is edge-on.
    assert_eq!(visible(&cube, DVec4::new(10.0, 10.0, 10.0, 0.0)).len(), 6);
    let edge_on = visible(&cube, DVec4::new(0.0, 100.0, 100.0, 1.0));
    assert_eq!(edge_on.len(), 6);
    // From the middle: none.
    assert_eq!(visible(&cube, DVec4::new(5.0, 25.0, 5.0, 1.0)), []);
}

#[test]
fn towards_the_viewer_not_the_direction_of_view() {
    // Errata E13. The wall z = 0 faces an eye that looks along −z from z = 5.
    let (wall, eye) = (DVec3::Z, DVec3::new(0.0, 0.0, 5.0));
    let direction_of_view = -DVec3::Z;
    assert!(is_front_facing(wall, eye - DVec3::ZERO));
    assert!(!is_front_facing(wall, direction_of_view));
}

#[test]
fn the_sign_of_z_is_that_of_a_parallel_view() {
    // Errata E31. A triangle about (10, 0, −5) with the normal (1, 0, ½), by hand: (0, 4, 0) × (−1, 0, 2) = (8, 0, 4).
    let corners = [(10.0, -2.0, -5.0), (10.0, 2.0, -5.0), (9.0, -2.0, -3.0)].map(DVec3::from);
    let n = normal(corners[0], corners[1], corners[2]);
    assert_eq!(n, DVec3::new(8.0, 0.0, 4.0));
    let mesh = Mesh::new(corners.to_vec(), vec![[0, 1, 2]]).unwrap();
    assert_eq!(visible(&mesh, DVec4::W), []);
    assert_eq!(visible(&mesh, DVec4::Z), [0]);
    let projection = frustum(-3.0, 3.0, -3.0, 3.0, 1.0, 10.0).unwrap();
    let clip = corners.map(|p| projection * p.extend(1.0));
    assert!(!is_front_facing_in_clip_space(clip));
    // Turned round it is seen, and its plane taken along to NDC points to where z is small: to the viewer.
    let [a, b, c] = corners;
    assert_eq!(
        visible(
            &Mesh {
                positions: vec![a, c, b],
                ..mesh
            },
            DVec4::W
        ),
        [0]
    );
    assert!(is_front_facing_in_clip_space([clip[0], clip[2], clip[1]]));
    let plane = (-n).extend(n.dot(a));
    let taken_along = projection.inverse().transpose() * plane;
    assert!(taken_along.z < 0.0, "{taken_along}");
    assert_eq!((b, c), (corners[1], corners[2]));
}

#[test]
fn culling_halves_the_fragments_of_closed_solids() {
    for (name, mesh) in closed() {
        for (parallel, eye) in [
            (false, DVec3::new(3.0, 2.0, 5.0)),
            (false, DVec3::new(-4.0, 1.5, 0.75)),
            (true, DVec3::new(1.0, -3.0, 2.0)),
        ] {
            let camera = camera(parallel, eye);
            let (all, kept) = (polygons(&mesh), visible_on_screen(&mesh, &camera));
            let fragments = |ids: &[usize]| {
                let mut work = Work::default();
                paint(ids.iter().map(|&i| (i, &all[i])), &camera, &mut work).unwrap();
                work.fragments
            };
            let everything: Vec<usize> = (0..all.len()).collect();
            // A sight line comes out of a closed solid as often as it goes in, and shared corners are rounded alike:
            // exactly half, at every pixel.
            let front = fragments(&kept);
            assert!(front > 400, "{name}: {front}");
            assert_eq!(fragments(&everything), 2 * front, "{name} from {eye}");
            let share = kept.len() as f64 / all.len() as f64;
            assert!((0.2..=0.8).contains(&share), "{name}: {share}");
            assert_eq!(
                visible(&mesh, camera.eye().unwrap()),
                kept,
                "{name} from {eye}"
            );
        }
    }
}

#[test]
fn degenerate() {
    let (o, x, y, z) = (DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z);
    let mesh = |corners: [DVec3; 3]| Mesh {
        positions: corners.to_vec(),
        triangles: vec![[0, 1, 2]],
    };
    let eye = DVec4::new(0.0, 0.0, 1.0, 1.0);
    let cases = [
        ("seen", [o, x, y], eye, true),
        ("from behind", [o, y, x], eye, false),
        ("edge-on", [o, x, z], eye, true),
        ("no area", [o, x, 2.0 * x], eye, true),
        ("one point", [o, o, o], eye, true),
        ("NaN", [o, x, y * f64::NAN], eye, false),
        ("infinite", [o, x, y * f64::INFINITY], eye, false),
        ("tiny", [o, x * 5e-324, y * 5e-324], eye, true),
        ("huge", [o, x * 1e300, y * 1e300], eye, true),
        ("the same place, w = −1", [o, x, y], -eye, true),
        ("the same place, w = 2", [o, y, x], 2.0 * eye, false),
        ("a direction", [o, x, y], DVec4::Z, true),
        ("the opposite one", [o, x, y], -DVec4::Z, false),
        ("a direction along the face", [o, x, y], DVec4::X, true),
        ("a tiny direction", [o, x, y], -5e-324 * DVec4::Z, false),
        ("no eye", [o, x, y], DVec4::ZERO, false),
        ("an eye that is not finite", [o, x, y], DVec4::NAN, false),
        ("an infinite one", [o, x, y], DVec4::INFINITY, false),
        (
            "a direction that is not finite",
            [o, x, y],
            DVec4::new(0.0, 0.0, f64::INFINITY, 0.0),
            false,
        ),
    ];
    for (name, corners, eye, expected) in cases {
        assert_eq!(visible(&mesh(corners), eye).len() == 1, expected, "{name}");
    }
    let missing = Mesh {
        positions: vec![o, x],
        triangles: vec![[0, 1, 2]],
    };
    assert_eq!(visible(&missing, eye), []);
    for (n, v, expected) in [
        (z, z, true),
        (z, x, true),
        (z, -z, false),
        (o, z, true),
        (z * 5e-324, z * 5e-324, true),
        (z * 5e-324, -z * 5e-324, false),
        (
            DVec3::new(1e300, 1e300, 5e-324),
            DVec3::new(1e300, -1e300, -5e-324),
            false,
        ),
        (DVec3::NAN, z, false),
        (z, DVec3::INFINITY, false),
    ] {
        assert_eq!(is_front_facing(n, v), expected, "{n} {v}");
    }
    let p = |x: f64, y: f64| DVec2::new(x, y);
    // On a screen, y down, clockwise is what counter-clockwise is with y up.
    assert!(is_front_facing_on_screen([
        p(0.0, 9.0),
        p(9.0, 9.0),
        p(0.0, 0.0)
    ]));
    assert!(!is_front_facing_on_screen([
        p(0.0, 9.0),
        p(0.0, 0.0),
        p(9.0, 9.0)
    ]));
    assert!(is_front_facing_on_screen([p(0.0, 0.0); 3]));
    assert!(!is_front_facing_on_screen([
        p(0.0, f64::NAN),
        p(1.0, 0.0),
        p(0.0, 1.0)
    ]));
}

/// Small integers, so that faces are often exactly edge-on, and a few that are a little off.
fn point() -> impl Strategy<Value = DVec3> {
    let coordinate = || {
        prop_oneof![
            4 => (-4..5i32).prop_map(f64::from),
            1 => (-4..5i32, -1e-14..1e-14f64).prop_map(|(i, off)| f64::from(i) + off),
        ]
    };
    [coordinate(), coordinate(), coordinate()].prop_map(DVec3::from_array)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    /// (AB × AC)·(E − w A) without rounding.
    #[test]
    fn visible_by_the_exact_sign(corners in [point(), point(), point()], eye in point(), place: bool) {
        let r = |x: f64| Exact::new(x).unwrap();
        let w = if place { r(1.0) } else { r(0.0) };
        let [a, b, c] = corners;
        let side = |p: DVec3, i: usize| r(p[i]) - r(a[i]);
        let v = |i: usize| r(eye[i]) - &w * r(a[i]);
        let det: Exact = [(0, 1, 2), (1, 2, 0), (2, 0, 1)]
            .into_iter()
            .map(|(i, j, k)| (side(b, i) * side(c, j) - side(b, j) * side(c, i)) * v(k))
            .sum();
        let mesh = Mesh { positions: corners.to_vec(), triangles: vec![[0, 1, 2]] };
        let kept = visible(&mesh, eye.extend(if place { 1.0 } else { 0.0 }));
        let expected = det >= 0 && (place || eye != DVec3::ZERO);
        prop_assert_eq!(kept.len() == 1, expected);
    }

    /// n·v, the eye, the corners on screen and those in clip space say the same, save within rounding of edge-on.
    #[test]
    fn object_and_screen_agree(
        corners in prop::array::uniform3(prop::array::uniform3(-1.0..1.0f64)),
        eye in prop::array::uniform3(2.0..5.0f64),
        parallel: bool,
    ) {
        let camera = camera(parallel, DVec3::from(eye));
        let corners = corners.map(DVec3::from);
        let mesh = Mesh { positions: corners.to_vec(), triangles: vec![[0, 1, 2]] };
        let n = normal(corners[0], corners[1], corners[2]);
        let eye = camera.eye().unwrap();
        let towards = eye.truncate() - eye.w * corners[0];
        let cosine = n.normalize_or_zero().dot(towards.normalize());
        // Clip coordinates round a few times at the scale of the scene, 8; the normal of a thin triangle is as much
        // less certain as its area is smaller than 1.
        prop_assume!(cosine.abs() > 256.0 * f64::EPSILON * 8.0 / n.length());
        let expected = cosine > 0.0;
        prop_assert_eq!(is_front_facing(n, towards), expected);
        prop_assert_eq!(visible(&mesh, eye).len() == 1, expected);
        prop_assert_eq!(visible_on_screen(&mesh, &camera).len() == 1, expected);
        let pixels = corners.map(|p| camera.to_pixel(p).unwrap().truncate());
        prop_assert_eq!(is_front_facing_on_screen(pixels), expected);
    }

    /// Behind the eye the division by w turns a triangle over; the test without it does not.
    #[test]
    fn behind_the_eye(corners in prop::array::uniform3(prop::array::uniform3(-9..10i32))) {
        let corners = corners.map(|p| DVec3::from(p.map(f64::from)));
        let projection = frustum(-1.0, 1.0, -1.0, 1.0, 1.0, 3.0).unwrap();
        let mesh = Mesh { positions: corners.to_vec(), triangles: vec![[0, 1, 2]] };
        // x, y and w of these integers are exact: x, y and −z.
        let clip = corners.map(|p| projection * p.extend(1.0));
        prop_assert_eq!(is_front_facing_in_clip_space(clip), visible(&mesh, DVec4::W).len() == 1);
    }

    #[test]
    fn never_panics(p in prop::array::uniform9(ANY), eye in prop::array::uniform4(ANY), m in prop::array::uniform16(ANY)) {
        let corners = [0, 3, 6].map(|i| DVec3::new(p[i], p[i + 1], p[i + 2]));
        let mesh = Mesh { positions: corners.to_vec(), triangles: vec![[0, 1, 2]] };
        let camera = Camera {
            view_projection: ombra_math::glam::DMat4::from_cols_array(&m),
            viewport: Viewport { width: 3, height: 3 },
        };
        let _ = (visible(&mesh, DVec4::from(eye)), visible_on_screen(&mesh, &camera));
        let _ = is_front_facing(corners[0], corners[1]);
        let _ = is_front_facing_on_screen(corners.map(DVec3::truncate));
    }
}
