//! Scenes of many that are one over the other, or cross: what they cost, and that the picture is right.

use ombra_math::camera::Camera;
use ombra_math::mesh::Mesh;
use ombra_math::solids;
use ombra_math::view::{Viewport, look_at, perspective};

use super::scenes::square;
use super::*;
use crate::image_space::cast;
use crate::pair::tolerance;
use crate::picture::{self, paint, polygons};

/// What is counted for sheets one over the other at these heights.
fn count(heights: impl Iterator<Item = f64>, eye: DVec4) -> (Vec<usize>, Work) {
    let scene: Vec<_> = heights.map(|z| square(0.0, 0.0, z, 1.0)).collect();
    let mut work = Work::default();
    let pieces = counted::order_by_cutting(&scene, eye, &mut work);
    assert_eq!(pieces.len(), scene.len(), "nothing to cut");
    (numbers(&pieces), work)
}

/// At most every two compared, either way round, and every two extents a few times.
fn is_quadratic(work: &Work, n: u64) -> bool {
    work.pairs <= n * n && work.comparisons <= 3 * n * n
}

#[test]
fn equal_sheets_keep_their_order() {
    for eye in [
        ABOVE,
        DVec4::new(1.0, 2.0, 3.0, 0.0),
        DVec4::new(0.1, 0.2, 9.0, 1.0),
    ] {
        for n in [2, 32, 128, 512] {
            let (found, work) = count((0..n).map(|_| 0.5), eye);
            // The first submitted is seen.
            assert!(found.into_iter().eq((0..n).rev()));
            assert!(is_quadratic(&work, n as u64), "{n}: {work}");
        }
    }
}

/// Each within the tolerance of some others and not of all: rings upon rings.
#[test]
fn sheets_about_the_tolerance_are_not_cut() {
    let delta = tolerance(1.0);
    for eye in [
        ABOVE,
        DVec4::new(1.0, 2.0, 3.0, 0.0),
        DVec4::new(0.1, 0.2, 9.0, 1.0),
    ] {
        for n in [32, 128, 512u32] {
            let steps = [0.75, 3.0 / f64::from(n)].map(|share| share * delta);
            for step in steps {
                for shuffle in [1, 197] {
                    let heights = (0..n).map(|i| f64::from(i * shuffle % n) * step);
                    let (mut found, work) = count(heights, eye);
                    assert!(is_quadratic(&work, n.into()), "{n}: {work}");
                    found.sort_unstable();
                    assert!(found.into_iter().eq(0..n as usize));
                }
            }
        }
    }
}

/// A floor, and walls through it that cross each other, upright or not.
fn floor_and_walls(n: u32, lean: f64) -> Vec<Polygon> {
    let mut state = 1u64;
    let mut random = |half: f64| {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        ((state >> 11) as f64 / (1u64 << 52) as f64 - 1.0) * half
    };
    let mut scene = vec![Polygon {
        vertices: [
            (-100.0, -100.0),
            (-100.0, 100.0),
            (100.0, 100.0),
            (100.0, -100.0),
        ]
        .map(|(x, z)| DVec3::new(x, 0.0, z))
        .to_vec(),
    }];
    for _ in 0..n {
        let angle = random(core::f64::consts::FRAC_PI_2);
        let along = DVec3::new(libm::cos(angle), 0.0, libm::sin(angle));
        let middle = DVec3::new(random(20.0), 0.0, random(20.0));
        let up = DVec3::new(random(lean), 1.0, random(lean));
        scene.push(Polygon {
            vertices: [(-80.0, -20.0), (80.0, -20.0), (80.0, 40.0), (-80.0, 40.0)]
                .map(|(s, t)| middle + s * along + t * up)
                .to_vec(),
        });
    }
    scene
}

fn camera(eye: DVec3, size: u32) -> Camera {
    let view = look_at(eye, DVec3::ZERO, DVec3::Y).unwrap();
    Camera {
        view_projection: perspective(0.7, 1.0, 1.0, 1000.0).unwrap() * view,
        viewport: Viewport {
            width: size,
            height: size,
        },
    }
}

/// Painted back to front, the pieces give the picture of the rays, but for pixels at an edge.
fn check_picture(scene: &[Polygon], pieces: &[(usize, Polygon)], camera: &Camera) {
    let painted = paint(pieces.iter().map(|(i, piece)| (*i, piece)), camera).unwrap();
    let seen = cast(scene, camera).unwrap();
    let difference = picture::compare(&painted, &seen, scene, camera).unwrap();
    assert!(difference.farthest <= 1e-6, "{difference:?}");
    assert!(difference.pixels <= 20, "{difference:?}");
}

#[test]
fn walls_that_cross_make_no_more_pieces_than_their_lines() {
    let eye = DVec3::new(60.0, 90.0, 200.0);
    for (n, lean, most) in [
        (16, 0.0, 330),
        (128, 0.0, 17_000),
        (16, 0.5, 700),
        (32, 0.5, 4_500),
    ] {
        let scene = floor_and_walls(n, lean);
        let mut work = Work::default();
        let pieces = counted::order_by_cutting(&scene, eye.extend(1.0), &mut work);
        assert!(pieces.len() <= most, "{n}: {}", pieces.len());
        // As long as rings are few, each cut compares with what lies about; then planes divide.
        let k = u64::from(n) + 1;
        assert!(work.pairs <= 16 * k * k, "{n}: {work}");
        assert!(work.comparisons <= 64 * pieces.len() as u64, "{n}: {work}");
        check_picture(&scene, &pieces, &camera(eye, 48));
    }
}

/// What has an order is not cut, however large: closed solids, and boxes that touch.
#[test]
fn solids_are_not_cut() {
    let tower = || {
        let boxes = [
            (DVec3::new(-10.0, 0.0, -10.0), DVec3::new(10.0, 2.0, 10.0)),
            (DVec3::new(-2.5, 2.0, -2.5), DVec3::new(2.5, 10.0, 2.5)),
        ];
        let faces = boxes.map(|(min, max)| polygons(&solids::cuboid(min, max).unwrap()));
        faces.concat()
    };
    let of = |mesh: Result<Mesh, solids::SolidError>| polygons(&mesh.unwrap());
    for (scene, most) in [
        (tower(), 40),
        (of(solids::sphere(10.0, 32, 33)), 8),
        (of(solids::torus(10.0, 3.0, 48, 24)), 8),
    ] {
        for eye in [DVec3::new(30.0, 25.0, 40.0), DVec3::new(-7.0, -50.0, 3.0)] {
            let mut work = Work::default();
            let pieces = counted::order_by_cutting(&scene, eye.extend(1.0), &mut work);
            assert_eq!(pieces.len(), scene.len());
            assert!(work.pairs <= most * scene.len() as u64, "{work}");
            check_picture(&scene, &pieces, &camera(eye, 48));
        }
    }
}
