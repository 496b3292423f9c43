//! Hidden surfaces read a second time: every answer of object space, the painter, rays and back faces, in scenes with
//! whole-number corners, against integer arithmetic that shares nothing with the crates.
//!
//! Two primitives are related by cutting the one down to what lies in the cone of the other: corners of the remainder
//! are whole-number homogeneous points, and which plane they lie in front of is a sign. Sight lines run through
//! whole-number mixtures of corners. Corners are few and small, so that shared edges, common planes, equal depths, eyes
//! in planes, on edges and at corners are frequent.
#![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use std::cmp::Ordering;

use ombra_hsr::image_space::hits;
use ombra_hsr::object_space::visible_parts;
use ombra_hsr::pair::{Pair, compare};
use ombra_hsr::polygon::Polygon;
use ombra_hsr::{back_face, painter};
use ombra_math::camera::{Camera, SightLine};
use ombra_math::glam::{DVec2, DVec3, DVec4, dmat4, dvec2, dvec3, dvec4};
use ombra_math::mesh::Mesh;
use ombra_math::solids::slide_cube;
use ombra_math::view::Viewport;
use ombra_tests::cases::Random;

type Whole = [i128; 3];

fn sub(a: Whole, b: Whole) -> Whole {
    [0, 1, 2].map(|k| a[k] - b[k])
}

fn cross(a: Whole, b: Whole) -> Whole {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| a[i] * b[j] - a[j] * b[i])
}

fn dot(a: Whole, b: Whole) -> i128 {
    (0..3).map(|k| a[k] * b[k]).sum()
}

fn gcd(a: i128, b: i128) -> i128 {
    if b == 0 { a.abs() } else { gcd(b, a % b) }
}

fn whole(random: &mut Random, range: u32) -> i128 {
    i128::from(random.below(2 * range + 1)) - i128::from(range)
}

fn corner(random: &mut Random, range: u32) -> Whole {
    [(); 3].map(|()| whole(random, range))
}

fn double(v: Whole) -> DVec3 {
    DVec3::from(v.map(|x| x as f64))
}

#[derive(Clone, Debug)]
struct Face(Vec<Whole>);

impl Face {
    fn normal(&self) -> Whole {
        let fan = (1..self.0.len() - 1).map(|i| [i, i + 1].map(|i| sub(self.0[i], self.0[0])));
        fan.fold([0; 3], |n, [a, b]| {
            let c = cross(a, b);
            [0, 1, 2].map(|k| n[k] + c[k])
        })
    }

    fn sides(&self) -> impl Iterator<Item = [Whole; 2]> {
        (0..self.0.len()).map(|i| [self.0[i], self.0[(i + 1) % self.0.len()]])
    }

    fn polygon(&self) -> Polygon {
        Polygon::new(self.0.iter().copied().map(double).collect()).unwrap()
    }
}

/// A triangle, a box's side, or a hexagon laid out along two whole-number vectors; now and then made of the last one.
fn face(random: &mut Random, last: Option<&Face>) -> Face {
    loop {
        let [a, b, o] = [(); 3].map(|()| corner(random, 3));
        let along = |shape: &[(i128, i128)], a: Whole, b: Whole| {
            let place = |&(i, j): &(i128, i128)| [0, 1, 2].map(|k| o[k] + i * a[k] + j * b[k]);
            Face(shape.iter().map(place).collect())
        };
        let made = match (random.below(5), last) {
            (0, Some(last)) => Face(vec![last.0[0], last.0[1], o]),
            (1, Some(last)) => {
                let by = sub(last.0[1], last.0[0]);
                Face(
                    last.0
                        .iter()
                        .map(|v| [0, 1, 2].map(|k| v[k] + by[k]))
                        .collect(),
                )
            }
            (2, _) => {
                let axis = random.below(3) as usize;
                let [mut a, mut b] = [[0; 3]; 2];
                a[axis] = 1 + i128::from(random.below(4));
                b[(axis + 1) % 3] = 1 + i128::from(random.below(4));
                along(&[(0, 0), (1, 0), (1, 1), (0, 1)], a, b)
            }
            (3, _) => along(&[(0, 0), (2, 0), (3, 1), (3, 2), (1, 3), (0, 2)], a, b),
            _ => Face(vec![a, b, o]),
        };
        if made.normal() != [0; 3] {
            return made;
        }
    }
}

/// A viewer: a place, or the direction towards it.
#[derive(Clone, Copy, Debug)]
struct Viewer {
    at: Whole,
    place: bool,
}

impl Viewer {
    fn random(random: &mut Random, faces: &[Face]) -> Self {
        let near = faces.first().map(|face| [face.0[0], face.0[1]]);
        let (at, place) = match (random.below(6), near) {
            (0, Some([a, _])) => (a, true),
            (1, Some([a, b])) => ([0, 1, 2].map(|k| 2 * a[k] - b[k]), true),
            (2, _) => (corner(random, 3), true),
            (3, _) => (corner(random, 12), true),
            _ => (corner(random, 3), false),
        };
        if place || at != [0; 3] {
            Self { at, place }
        } else {
            Self {
                at: [1, 2, 3],
                place,
            }
        }
    }

    fn eye(self) -> DVec4 {
        double(self.at).extend(if self.place { 1.0 } else { 0.0 })
    }

    /// On which side of a face's plane it is.
    fn side(self, face: &Face) -> i128 {
        let towards = if self.place {
            sub(self.at, face.0[0])
        } else {
            self.at
        };
        dot(face.normal(), towards).signum()
    }
}

/// Homogeneous, of whole numbers without a common factor.
type Point = [i128; 4];

fn height(normal: Whole, d: i128, p: Point) -> i128 {
    dot(normal, [p[0], p[1], p[2]]) + d * p[3]
}

/// What of `second` lies in the cone of `first`: nothing where only borders meet, or one is edge-on.
fn within(first: &Face, second: &Face, viewer: Viewer) -> Vec<Point> {
    if viewer.side(first) == 0 || viewer.side(second) == 0 {
        return vec![];
    }
    let mut left: Vec<Point> = second.0.iter().map(|v| [v[0], v[1], v[2], 1]).collect();
    for [a, b] in first.sides() {
        let normal = if viewer.place {
            cross(sub(a, viewer.at), sub(b, viewer.at))
        } else {
            cross(sub(b, a), viewer.at)
        };
        let d = -dot(normal, a);
        let inward = first
            .0
            .iter()
            .map(|&v| dot(normal, v) + d)
            .sum::<i128>()
            .signum();
        let height = |p: Point| inward * height(normal, d, p);
        let mut kept = vec![];
        for (i, &p) in left.iter().enumerate() {
            let q = left[(i + 1) % left.len()];
            let (hp, hq) = (height(p), height(q));
            if hp >= 0 {
                kept.push(p);
            }
            if hp.signum() * hq.signum() < 0 {
                let cut = [0, 1, 2, 3].map(|k| p[k] * hq.abs() + q[k] * hp.abs());
                let factor = cut.into_iter().fold(0, gcd);
                kept.push(cut.map(|x| x / factor));
            }
        }
        left = kept;
    }
    let flat = |p: Point| {
        let from = left[0];
        let difference = [0, 1, 2].map(|k| p[k] * from[3] - from[k] * p[3]);
        let factor = difference.into_iter().fold(0, gcd).max(1);
        difference.map(|x| x / factor)
    };
    let away: Vec<Whole> = left.iter().map(|&p| flat(p)).collect();
    let wide = away
        .iter()
        .any(|&u| away.iter().any(|&v| cross(u, v) != [0; 3]));
    if wide { left } else { vec![] }
}

fn related(first: &Face, second: &Face, viewer: Viewer) -> Pair {
    let normal = first.normal();
    let d = -dot(normal, first.0[0]);
    let shared = within(first, second, viewer);
    let signs: Vec<i128> = shared
        .iter()
        .map(|&p| height(normal, d, p).signum() * viewer.side(first))
        .collect();
    match (shared.is_empty(), signs.contains(&1), signs.contains(&-1)) {
        (true, ..) => Pair::Apart,
        (_, true, true) => Pair::Crossing,
        (_, true, false) => Pair::SecondNearer,
        (_, false, true) => Pair::FirstNearer,
        _ => Pair::Coplanar,
    }
}

fn scene(random: &mut Random, most: u32) -> (Vec<Face>, Viewer) {
    let mut faces: Vec<Face> = vec![];
    for _ in 0..random.below(most + 1) {
        let next = face(random, faces.last());
        faces.push(next);
    }
    let viewer = Viewer::random(random, &faces);
    (faces, viewer)
}

/// Whether some order puts every face before those that hide it, by trying all orders.
fn some_order(hides: &[Vec<bool>], taken: &mut Vec<usize>) -> bool {
    let all = 0..hides.len();
    taken.len() == hides.len()
        || all.clone().any(|next| {
            let ready = !taken.contains(&next) && taken.iter().all(|&before| !hides[before][next]);
            if !ready {
                return false;
            }
            taken.push(next);
            let found = some_order(hides, taken);
            taken.pop();
            found
        })
}

#[test]
fn pairs_and_orders_of_whole_number_scenes() {
    let mut random = Random::new(41);
    let (mut ordered, mut rings, mut kinds) = (0, 0, [0; 5]);
    for case in 0..900 {
        let (faces, viewer) = scene(&mut random, 6);
        let polygons: Vec<Polygon> = faces.iter().map(Face::polygon).collect();
        let eye = viewer.eye();
        let mut hides = vec![vec![false; faces.len()]; faces.len()];
        for i in 0..faces.len() {
            for j in 0..i {
                let pair = related(&faces[j], &faces[i], viewer);
                assert_eq!(
                    compare(&polygons[j], &polygons[i], eye),
                    pair,
                    "{case}: {j}, {i}"
                );
                assert_eq!(
                    compare(&polygons[i], &polygons[j], eye),
                    pair.swapped(),
                    "{case}: {i}, {j}"
                );
                // Of two at one depth the one submitted first is seen.
                hides[j][i] = matches!(pair, Pair::FirstNearer | Pair::Crossing | Pair::Coplanar);
                hides[i][j] = matches!(pair, Pair::SecondNearer | Pair::Crossing);
                kinds[pair as usize] += 1;
            }
        }
        for answer in [
            painter::order(&polygons, eye),
            painter::order_plain(&polygons, eye),
        ] {
            match answer {
                Ok(order) => {
                    ordered += 1;
                    let mut sorted = order.clone();
                    sorted.sort_unstable();
                    assert_eq!(sorted, (0..faces.len()).collect::<Vec<_>>(), "{case}");
                    for (at, &i) in order.iter().enumerate() {
                        assert!(
                            order[at..].iter().all(|&later| !hides[i][later]),
                            "{case}: {order:?}"
                        );
                    }
                    let pieces = painter::order_by_cutting(&polygons, eye);
                    let uncut: Vec<_> = order.iter().map(|&i| (i, polygons[i].clone())).collect();
                    assert_eq!(pieces, uncut, "{case}");
                }
                Err(cycle) => {
                    rings += 1;
                    assert!(!some_order(&hides, &mut vec![]), "{case}: {cycle}");
                    let ring = &cycle.primitives;
                    assert!(ring.len() >= 2, "{case}: {cycle}");
                    for (at, &i) in ring.iter().enumerate() {
                        let next = ring[(at + 1) % ring.len()];
                        let hidden: Vec<usize> =
                            ring.iter().copied().filter(|&j| hides[i][j]).collect();
                        assert_eq!(hidden, [next], "{case}: {cycle}");
                    }
                }
            }
        }
    }
    assert!(
        ordered > 500 && rings > 300 && kinds.iter().all(|&n| n > 30),
        "{ordered} {rings} {kinds:?}"
    );
}

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
        let polygons: Vec<Polygon> = faces.iter().map(Face::polygon).collect();
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
        let scale = [
            1.0,
            ombra_tests::dyadic::power_of_two(240),
            ombra_tests::dyadic::power_of_two(-240),
        ];
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

#[test]
fn back_faces_by_whole_numbers() {
    let mut random = Random::new(44);
    let mut on_edge = 0;
    for _ in 0..400 {
        let faces: Vec<Face> = (0..20)
            .map(|_| Face([(); 3].map(|()| corner(&mut random, 4)).to_vec()))
            .collect();
        let positions = faces
            .iter()
            .flat_map(|face| face.0.iter().copied().map(double))
            .collect();
        let mesh = Mesh::new(
            positions,
            (0..20).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect(),
        )
        .unwrap();
        let viewer = Viewer::random(&mut random, &faces);
        let kept: Vec<usize> = (0..20).filter(|&i| viewer.side(&faces[i]) >= 0).collect();
        assert_eq!(back_face::visible(&mesh, viewer.eye()), kept);
        if !viewer.place {
            // From the other side all others are seen, and those edge-on again: halves, exactly.
            let edge_on = (0..20).filter(|&i| viewer.side(&faces[i]) == 0).count();
            let others = back_face::visible(&mesh, -viewer.eye()).len();
            assert_eq!(kept.len() + others, 20 + edge_on);
            on_edge += edge_on;
        }
    }
    assert!(on_edge > 50, "{on_edge}");
}

/// A camera of whole numbers looking along −z from a whole-number eye: clip coordinates are exact, so is the sign.
#[test]
fn object_and_screen_test_of_back_faces_agree() {
    let cube = slide_cube();
    let mut random = Random::new(45);
    let mut counts = [0; 4];
    for _ in 0..2000 {
        let eye = double(corner(&mut random, 60));
        let scale = dmat4(
            dvec4(2.0, 0.0, 0.0, 0.0),
            dvec4(0.0, 2.0, 0.0, 0.0),
            dvec4(0.0, 0.0, -1.0, -1.0),
            dvec4(0.0, 0.0, -2.0, 0.0),
        );
        let view = ombra_math::glam::DMat4::from_translation(-eye);
        let camera = Camera {
            view_projection: scale * view,
            viewport: Viewport {
                width: 64,
                height: 64,
            },
        };
        assert_eq!(camera.eye(), Some(eye.extend(1.0)));
        let kept = back_face::visible(&cube, eye.extend(1.0));
        assert_eq!(back_face::visible_on_screen(&cube, &camera), kept);
        // From outside the cube one to three of its sides are turned to the eye, in its planes one more of them edge-on.
        let sides = [0, 1, 2].map(|k| {
            let [low, high] = cube.bounds().unwrap().map(|corner| corner[k]);
            usize::from(eye[k] <= low) + usize::from(eye[k] >= high)
        });
        let expected: usize = sides.iter().sum();
        assert_eq!(kept.len(), 2 * expected, "{eye}");
        counts[expected] += 1;
    }
    assert!(counts.iter().skip(1).all(|&n| n > 20), "{counts:?}");
    // A face behind the eye, and what the slide's sign of the normal alone would say (E31).
    assert!(!back_face::is_front_facing(
        dvec3(1.0, 0.0, 0.5),
        dvec3(-10.0, 0.0, 5.0)
    ));
}
