//! What a sight line meets, and what object space and the painter show along it, in scenes with whole-number corners: against
//! integer arithmetic. Sight lines run through whole-number mixtures of corners.
#![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use std::cmp::Ordering;

use ombra_hsr::image_space::hits;
use ombra_hsr::object_space::visible_parts;
use ombra_hsr::painter;
use ombra_hsr::polygon::Polygon;
use ombra_math::camera::SightLine;
use ombra_math::glam::{DVec2, DVec3, dvec2};
use ombra_tests::cases::Random;
use ombra_tests::whole_faces::{Face, Whole, corner, cross, dot, double, scene, sub};

#[derive(Clone, Copy, PartialEq)]
enum Meets {
    Inside,
    Border,
    No,
}

/// How a line from `from` meets a face, and where: the parameter as a fraction with a positive denominator.
fn meets(face: &Face, from: Whole, direction: Whole) -> (Meets, [i128; 2]) {
    let normal = face.normal();
    let through = dot(normal, direction);
    if through == 0 {
        return (Meets::No, [0, 1]);
    }
    let turns = face.sides().filter(|[a, b]| a != b).map(|[a, b]| {
        let turn = dot(direction, cross(sub(a, from), sub(b, from)));
        turn * through.signum()
    });
    let how = match turns.min().unwrap().cmp(&0) {
        Ordering::Less => Meets::No,
        Ordering::Equal => Meets::Border,
        Ordering::Greater => Meets::Inside,
    };
    (
        how,
        [
            dot(normal, sub(face.0[0], from)) * through.signum(),
            through.abs(),
        ],
    )
}

fn earlier(a: [i128; 2], b: [i128; 2]) -> Ordering {
    (a[0] * b[1]).cmp(&(b[0] * a[1]))
}

/// How far inside the outline of `part`, seen along the line, it passes: negative outside. In doubles.
fn depth_inside(part: &Polygon, from: DVec3, direction: DVec3) -> f64 {
    let (x, y) = direction.normalize().any_orthonormal_pair();
    let seen: Vec<DVec2> = part
        .vertices
        .iter()
        .map(|&v| dvec2((v - from).dot(x), (v - from).dot(y)))
        .collect();
    let (mut nearest, mut inside) = (f64::INFINITY, false);
    for (i, &a) in seen.iter().enumerate() {
        let b = seen[(i + 1) % seen.len()];
        let side = b - a;
        let share = (-a.dot(side) / side.length_squared().max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
        nearest = nearest.min((a + share * side).length());
        if (a.y > 0.0) != (b.y > 0.0) && a.x - side.x * a.y / side.y > 0.0 {
            inside = !inside;
        }
    }
    if inside { nearest } else { -nearest }
}

#[test]
fn each_sight_line_sees_the_nearest_once() {
    let mut random = Random::new(42);
    let (mut seen, mut unclear, mut several) = (0, 0, 0);
    for case in 0..700 {
        let (faces, viewer) = scene(&mut random, 8);
        let polygons: Vec<Polygon> = faces
            .iter()
            .map(|face| Polygon::new(face.doubles()).unwrap())
            .collect();
        let parts = visible_parts(&polygons, viewer.eye());
        let pieces = painter::order_by_cutting(&polygons, viewer.eye());
        let mut areas = vec![0.0; faces.len()];
        for (source, piece) in &pieces {
            areas[*source] += piece.area();
        }
        for (polygon, area) in polygons.iter().zip(areas) {
            // 4 ε of the coordinates, at most 20, for each of a few dozen cuts of sides of at most 20.
            assert!((polygon.area() - area).abs() < 1e-11, "{case}");
        }
        for target in &faces {
            let shares: Vec<i128> = target
                .0
                .iter()
                .map(|_| 1 + i128::from(random.below(97)))
                .collect();
            let all: i128 = shares.iter().sum();
            let mixed =
                [0, 1, 2].map(|k| target.0.iter().zip(&shares).map(|(v, s)| v[k] * s).sum());
            let scaled = viewer.at.map(|x| x * all);
            let (from, direction) = if viewer.place {
                (scaled, sub(mixed, scaled))
            } else {
                (mixed, viewer.at.map(|x| -x * all))
            };
            if direction == [0; 3] {
                continue;
            }
            let found = faces.iter().map(|face| {
                let grown = Face(face.0.iter().map(|v| v.map(|x| x * all)).collect());
                meets(&grown, from, direction)
            });
            let ahead = |t: [i128; 2]| !viewer.place || t[0] > 0;
            let found: Vec<_> = found
                .enumerate()
                .filter(|(_, (how, t))| *how != Meets::No && ahead(*t))
                .collect();
            if found.iter().any(|(_, (how, _))| *how == Meets::Border) {
                unclear += 1;
                continue;
            }
            // The first of equally near ones.
            let nearest = found
                .iter()
                .min_by(|(_, (_, s)), (_, (_, t))| earlier(*s, *t))
                .map(|(i, _)| *i);
            let [from, direction] = [from, direction].map(|v| double(v) / all as f64);
            let met = |parts: &[(usize, Polygon)]| -> Option<Vec<usize>> {
                let mut met = vec![];
                for (source, part) in parts
                    .iter()
                    .filter(|(i, _)| found.iter().any(|(j, _)| i == j))
                {
                    // A few dozen roundings of coordinates of at most 20, under no small angle.
                    match depth_inside(part, from, direction) {
                        inside if inside.abs() < 1e-9 => return None,
                        inside if inside > 0.0 => met.push(*source),
                        _ => {}
                    }
                }
                Some(met)
            };
            let (Some(visible), Some(painted)) = (met(&parts), met(&pieces)) else {
                unclear += 1;
                continue;
            };
            assert_eq!(
                visible,
                nearest.into_iter().collect::<Vec<_>>(),
                "{case}: object space"
            );
            assert_eq!(painted.last().copied(), nearest, "{case}: painter");
            seen += 1;
            several += usize::from(found.len() > 1);
        }
    }
    assert!(
        seen > 2000 && several > 600 && unclear < seen / 8,
        "{seen} {several} {unclear}"
    );
}

#[test]
fn rays_meet_what_whole_numbers_say() {
    let mut random = Random::new(43);
    let (mut met, mut ties) = (0, 0);
    for case in 0..1500 {
        let (faces, _) = scene(&mut random, 8);
        // Far from the origin differences cancel; scaled by 2²⁴⁰ or 2⁻²⁴⁰ products of three come near the ends of the doubles.
        let scale = [1.0, 2.0_f64.powi(240), 2.0_f64.powi(-240)];
        let (scale, off) = (scale[case % 3], [0, 12_345, 1 << 26][case / 3 % 3]);
        let moved = |v: Whole| [v[0] + off, v[1] - off / 3, v[2] + off / 7];
        let faces: Vec<Face> = faces
            .iter()
            .map(|face| Face(face.0.iter().copied().map(moved).collect()))
            .collect();
        let polygons: Vec<Polygon> = faces
            .iter()
            .map(|face| Polygon {
                vertices: face.0.iter().map(|&v| scale * double(v)).collect(),
            })
            .collect();
        for face in &faces {
            let (a, b) = (face.0[0], face.0[1]);
            let ends = [
                moved(corner(&mut random, 4)),
                a,
                [0, 1, 2].map(|k| 2 * b[k] - a[k]),
                moved(corner(&mut random, 4)),
            ];
            let [from, to] = [(); 2].map(|()| ends[random.below(4) as usize]);
            let direction = sub(to, from);
            let line = SightLine {
                origin: scale * double(from),
                direction: scale * double(direction),
            };
            let mut expected: Vec<(usize, [i128; 2])> = faces
                .iter()
                .map(|face| meets(face, from, direction))
                .enumerate()
                .filter(|(_, (how, t))| *how != Meets::No && t[0] >= 0)
                .map(|(i, (_, t))| (i, t))
                .collect();
            expected.sort_by(|(_, s), (_, t)| earlier(*s, *t));
            let found = hits(&polygons, line);
            let (expected_order, found_order): (Vec<usize>, Vec<usize>) = (
                expected.iter().map(|e| e.0).collect(),
                found.iter().map(|h| h.primitive).collect(),
            );
            assert_eq!(found_order, expected_order, "{case}");
            for ((_, [n, d]), hit) in expected.iter().zip(&found) {
                let t = *n as f64 / *d as f64;
                // The stated 2⁻⁴⁰, and three roundings of t itself.
                assert!(
                    (hit.t - t).abs() <= t * 1.001 / 2f64.powi(40),
                    "{case}: {} for {t}",
                    hit.t
                );
            }
            met += found.len();
            ties += expected
                .windows(2)
                .filter(|w| earlier(w[0].1, w[1].1) == Ordering::Equal)
                .count();
        }
    }
    assert!(met > 3000 && ties > 300, "{met} {ties}");
}
