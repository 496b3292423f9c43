use super::*;
use crate::pair::compare;
use core::f64::consts::PI;
use ombra_math::glam::{DMat3, DQuat};
use ombra_math::work::Work;
use proptest::num::f64::ANY;
use proptest::prelude::*;

fn polygon<const N: usize>(vertices: [[f64; 3]; N]) -> Polygon {
    Polygon {
        vertices: vertices.map(DVec3::from).to_vec(),
    }
}

/// [x, x + size] × [y, y + size] at the height z.
fn square(x: f64, y: f64, z: f64, size: f64) -> Polygon {
    let corners = [[0.0, 0.0], [size, 0.0], [size, size], [0.0, size]];
    polygon(corners.map(|[i, j]| [x + i, y + j, z]))
}

/// The faces of [0, 1]³, turned by `turn` and moved.
fn cube(turn: DQuat, shift: DVec3) -> Vec<Polygon> {
    let faces = [
        [0, 2, 3, 1],
        [4, 5, 7, 6],
        [0, 1, 5, 4],
        [2, 6, 7, 3],
        [0, 4, 6, 2],
        [1, 3, 7, 5],
    ];
    let bit = |i: usize, k: usize| f64::from(u8::from(i >> k & 1 == 1));
    let corner = |i: usize| turn * DVec3::new(bit(i, 0), bit(i, 1), bit(i, 2)) + shift;
    faces
        .map(|face| Polygon {
            vertices: face.map(corner).to_vec(),
        })
        .to_vec()
}

fn place(x: f64, y: f64, z: f64) -> DVec4 {
    DVec4::new(x, y, z, 1.0)
}

fn areas(parts: &[(usize, Polygon)], source: usize) -> f64 {
    let of_source = parts.iter().filter(|(i, _)| *i == source);
    of_source.map(|(_, part)| part.area()).sum()
}

fn close(x: f64, expected: f64, scale: f64) {
    // Some ten cuts, each corner within a few ε of the coordinates.
    assert!(
        (x - expected).abs() <= 64.0 * f64::EPSILON * scale,
        "{x} instead of {expected}"
    );
}

#[test]
fn a_square_over_the_half_of_another() {
    let scene = [square(0.0, 0.0, 0.0, 2.0), square(1.0, 0.0, 1.0, 2.0)];
    let parts = visible_parts(&scene, DVec4::Z);
    let left = polygon([
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [1.0, 2.0, 0.0],
        [0.0, 2.0, 0.0],
    ]);
    assert_eq!(parts, [(0, left), (1, scene[1].clone())]);
    // From below the first is the nearer one.
    assert_eq!(visible_parts(&scene, -DVec4::Z)[0], (0, scene[0].clone()));
}

#[test]
fn every_size() {
    for e in [-1040, -1000, -530, 530, 1000, 1021] {
        let s = libm::scalbn(1.0, e);
        let scaled = |p: &Polygon| Polygon {
            vertices: p.vertices.iter().map(|&v| s * v).collect(),
        };
        // The largest reach from −4 s to 4 s, ± the largest double but for rounding up.
        let scene = [
            square(-4.0, -4.0, 0.0, 7.875),
            square(0.0, -4.0, 1.0, 3.875),
        ];
        let crossing = [
            scene[0].clone(),
            polygon([
                [0.0, -3.0, -1.0],
                [2.0, -3.0, 1.0],
                [2.0, 3.0, 1.0],
                [0.0, 3.0, -1.0],
            ]),
        ];
        for (scene, eye) in [
            (&scene, DVec4::Z),
            (&scene, place(0.0, 0.0, 3.0)),
            (&crossing, DVec4::Z),
        ] {
            let expected: Vec<_> = visible_parts(scene, eye)
                .iter()
                .map(|(i, part)| (*i, scaled(part)))
                .collect();
            let place = (if eye.w == 0.0 {
                eye.truncate()
            } else {
                s * eye.truncate()
            })
            .extend(eye.w);
            let parts = visible_parts(&scene.each_ref().map(scaled), place);
            assert_eq!(parts.len(), expected.len(), "{e} {eye}");
            for ((i, part), (j, other)) in parts.iter().zip(&expected) {
                assert_eq!(
                    (i, part.vertices.len()),
                    (j, other.vertices.len()),
                    "{e} {eye}"
                );
                for (v, w) in part.vertices.iter().zip(&other.vertices) {
                    // Below the normal doubles, a few of the smallest.
                    let off = (*v - *w).abs().max_element();
                    assert!(
                        off <= 4.0 * f64::EPSILON * 4.0 * s + 32.0 * f64::from_bits(1),
                        "{e} {eye}: {v} {w}"
                    );
                }
            }
        }
    }
}

/// Similar triangles: from the height h = 4, a square of side s at height 1 hides one of side s h / (h − 1) on the
/// ground.
#[test]
fn similar_triangles() {
    let ground = square(-4.0, -4.0, 0.0, 8.0);
    for (s, hidden) in [(1.5, 4.0), (3.0, 16.0), (6.0, 64.0), (9.0, 64.0)] {
        let near = square(-s / 2.0, -s / 2.0, 1.0, s);
        for scene in [
            [ground.clone(), near.clone()],
            [near.clone(), ground.clone()],
        ] {
            let parts = visible_parts(&scene, place(0.0, 0.0, 4.0));
            let of_ground = usize::from(scene[1] == ground);
            close(areas(&parts, of_ground), 64.0 - hidden, 64.0);
            close(areas(&parts, 1 - of_ground), s * s, 64.0);
        }
    }
    // In the middle it leaves a frame of four.
    let parts = visible_parts(
        &[ground, square(-0.75, -0.75, 1.0, 1.5)],
        place(0.0, 0.0, 4.0),
    );
    assert_eq!(parts.len(), 5);
}

#[test]
fn few_primitives() {
    assert_eq!(visible_parts(&[], DVec4::Z), []);
    let one = square(0.0, 0.0, 0.0, 1.0);
    assert_eq!(
        visible_parts(core::slice::from_ref(&one), DVec4::Z),
        [(0, one)]
    );
}

#[test]
fn every_pair_once() {
    for (k, pairs) in [(0, 0), (1, 0), (2, 1), (3, 3), (10, 45), (100, 4950)] {
        let scene: Vec<_> = (0..k)
            .map(|i| square(0.0, 0.0, f64::from(i), 1.0))
            .collect();
        let mut work = Work::default();
        let parts = visible_parts_counted(&scene, DVec4::Z, &mut work);
        assert_eq!((work.pairs, parts.len()), (pairs, usize::from(k > 0)));
    }
}

#[test]
fn faces_that_touch_cut_nothing() {
    let eye = DVec3::new(3.0, 4.0, 5.0);
    for k in 0..300 {
        let axis = DVec3::new(1.0, f64::from(k % 7) - 3.0, 0.5).normalize();
        let (turn, shift) = (
            DQuat::from_axis_angle(axis, 0.1 * f64::from(k)),
            DVec3::splat(0.3 * f64::from(k % 5)),
        );
        let faces = cube(turn, shift);
        for w in [0.0, 1.0] {
            let seen_from = (turn * eye + w * shift).extend(w);
            // Outside, the three faces at the corner (1, 1, 1).
            let expected: Vec<_> = [1, 3, 5].map(|i| (i, faces[i].clone())).to_vec();
            let parts = visible_parts(&faces, seen_from);
            assert_eq!(parts, expected, "{k} {w}");
        }
        // Inside, all six.
        let inside = visible_parts(
            &faces,
            (turn * DVec3::new(0.3, 0.6, 0.2) + shift).extend(1.0),
        );
        assert_eq!(
            inside,
            faces.iter().cloned().enumerate().collect::<Vec<_>>()
        );
    }
}

/// The eye on the plane of a face but for the rounding of its corners: the face may be seen, at an angle of 10⁻¹⁶.
#[test]
fn faces_edge_on_but_for_rounding() {
    for k in 0..300 {
        let axis = DVec3::new(1.0, f64::from(k % 7) - 3.0, 0.5).normalize();
        let (turn, shift) = (
            DQuat::from_axis_angle(axis, 0.1 * f64::from(k)),
            DVec3::splat(0.3 * f64::from(k % 5)),
        );
        let faces = cube(turn, shift);
        let place = (turn * DVec3::new(3.0, 0.5, 1.0) + shift).extend(1.0);
        let direction = (turn * DVec3::new(1.0, 0.2, 0.0)).extend(0.0);
        for (eye, seen, hidden) in [
            (place, [5, 5], [0, 2, 3, 4]),
            (direction, [3, 5], [0, 0, 2, 4]),
        ] {
            let parts = visible_parts(&faces, eye);
            for source in seen {
                close(areas(&parts, source), 1.0, 4.0);
            }
            let angle = |p: &Polygon| {
                let away = p.centroid().unwrap() - eye.truncate();
                let ray = if eye.w == 0.0 { eye.truncate() } else { away };
                p.plane()
                    .unwrap()
                    .normal
                    .normalize()
                    .dot(ray.normalize())
                    .abs()
            };
            for (source, part) in &parts {
                // What else is seen is a face in line with the eye.
                let flat = angle(&faces[*source]) < 1e-15 * 16.0;
                assert!(seen.contains(source) || flat, "{k}: {source} {part:?}");
                assert!(
                    !hidden.contains(source) || eye.w == 0.0 && flat,
                    "{k}: {source}"
                );
            }
        }
    }
}

#[test]
fn equal_depths_show_the_first() {
    let [a, b] = [square(0.0, 0.0, 0.0, 2.0), square(1.0, 1.0, 0.0, 2.0)];
    for eye in [DVec4::Z, -DVec4::Z, place(0.5, 2.0, 3.0)] {
        for scene in [[a.clone(), b.clone()], [b.clone(), a.clone()]] {
            let parts = visible_parts(&scene, eye);
            assert_eq!(parts[0], (0, scene[0].clone()));
            close(areas(&parts, 1), 3.0, 4.0);
        }
        assert_eq!(
            visible_parts(&[a.clone(), a.clone(), a.clone()], eye),
            [(0, a.clone())]
        );
    }
}

#[test]
fn crossing_primitives_are_cut_by_each_others_plane() {
    // Roofs z = x and z = −x over the same square: the higher half of each.
    let rise = |s: f64| {
        polygon([
            [-1.0, -1.0, -s],
            [1.0, -1.0, s],
            [1.0, 1.0, s],
            [-1.0, 1.0, -s],
        ])
    };
    let scene = [rise(1.0), rise(-1.0)];
    let parts = visible_parts(&scene, DVec4::Z);
    let half = |s: f64| {
        polygon([
            [0.0, -1.0, 0.0],
            [s, -1.0, 1.0],
            [s, 1.0, 1.0],
            [0.0, 1.0, 0.0],
        ])
    };
    assert_eq!(parts.len(), 2);
    for (part, s) in parts.iter().zip([1.0, -1.0]) {
        let mut corners = part.1.vertices.clone();
        for v in half(s).vertices {
            corners.retain(|c| *c != v);
        }
        assert!(corners.is_empty() && part.1.vertices.len() == 4, "{part:?}");
    }
    // Three planes through one line, 60° apart: of six half squares the two highest are seen from above.
    let turned = |angle: f64| {
        let turn = DQuat::from_axis_angle(DVec3::Y, angle);
        let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
        Polygon {
            vertices: corners.map(|[x, y]| turn * DVec3::new(x, y, 0.0)).to_vec(),
        }
    };
    let star = [-PI / 3.0, 0.0, PI / 3.0].map(turned);
    let parts = visible_parts(&star, DVec4::Z);
    // Both lean 60°; outside x = ½ they end, and the level one shows.
    close(areas(&parts, 0), 2.0, 4.0);
    close(areas(&parts, 1), 2.0, 4.0);
    close(areas(&parts, 2), 2.0, 4.0);
}

/// Two planes that cross at 10⁻¹³: what is left of both near their line lies at one depth for all coordinates can tell.
#[test]
fn crossing_at_no_angle() {
    let tilt = |s: f64| {
        polygon([
            [-1.0, -1.0, -s],
            [1.0, -1.0, s],
            [1.0, 1.0, s],
            [-1.0, 1.0, -s],
        ])
    };
    let covers = [
        square(-2.0, -1.5, 1.0, 1.95),
        square(0.05, -1.5, 1.0, 1.95),
        square(-1.5, 0.25, 1.0, 3.0),
    ];
    let scene = [&covers[..], &[tilt(1e-13), tilt(-1e-13)]].concat();
    assert_eq!(compare(&scene[3], &scene[4], DVec4::Z), Pair::Crossing);
    let parts = visible_parts(&scene, DVec4::Z);
    // x from −0.05 to 0.05, y from −1 to 0.25.
    close(areas(&parts, 3), 0.125, 4.0);
    assert_eq!(areas(&parts, 4), 0.0);
}

/// Beside a corner: no side of the square is between, and yet nothing is hidden and nothing to be cut.
#[test]
fn what_misses_a_corner_stays_whole() {
    let near = Seen::new(&square(0.0, 0.0, 1.0, 2.0), DVec4::Z).unwrap();
    let beside = |sum: f64| {
        [
            DVec3::new(1.0, sum - 1.0, 0.0),
            DVec3::new(3.0, sum - 3.0, 0.0),
            DVec3::new(3.0, 3.0, 0.0),
        ]
    };
    assert!(peel(&beside(4.25), &near, None, 0.0).is_none());
    assert!(peel(&beside(4.0), &near, None, 0.0).is_none());
    assert_eq!(
        peel(&beside(3.75), &near, None, 0.0).map(|pieces| pieces.len()),
        Some(2)
    );
}

/// n strips over n strips: k = 2n primitives, and n + n (n + 1) parts, which grow as k² does.
#[test]
fn a_grating_has_many_parts() {
    for n in [1, 2, 5, 20] {
        let strip = |i: i32| [f64::from(4 * i), f64::from(4 * i + 1)];
        let end = f64::from(4 * n);
        let along = |i: i32| {
            let [a, b] = strip(i);
            polygon([[-4.0, a, 0.0], [end, a, 0.0], [end, b, 0.0], [-4.0, b, 0.0]])
        };
        let over = |i: i32| {
            let [a, b] = strip(i);
            polygon([[a, -4.0, 1.0], [b, -4.0, 1.0], [b, end, 1.0], [a, end, 1.0]])
        };
        let scene: Vec<_> = (0..n).map(along).chain((0..n).map(over)).collect();
        let parts = visible_parts(&scene, DVec4::Z);
        assert_eq!(parts.len() as i32, n + n * (n + 1));
        let area: f64 = parts.iter().map(|(_, part)| part.area()).sum();
        assert_eq!(area, f64::from(2 * n * (4 * n + 4) - n * n));
    }
}

/// Each of three sticks lies over the next: no order of painting, but parts.
#[test]
fn sticks_in_a_circle() {
    let stick = |k: i32| {
        let turn = DQuat::from_axis_angle(DVec3::Z, f64::from(k) * 2.0 * PI / 3.0);
        let corners = [
            [-4.0, 1.0, -1.0],
            [4.0, 1.0, 1.0],
            [4.0, 2.0, 1.0],
            [-4.0, 2.0, -1.0],
        ];
        Polygon {
            vertices: corners.map(|v| turn * DVec3::from(v)).to_vec(),
        }
    };
    let scene = [0, 1, 2].map(stick);
    let parts = visible_parts(&scene, DVec4::Z);
    // A strip of width 1 crosses another one at 60° in an area of 1 / sin 60° as seen; z = x / 4.
    let slope = libm::sqrt(1.0 + 1.0 / 16.0);
    for source in 0..3 {
        let expected = (8.0 - 2.0 / libm::sqrt(3.0)) * slope;
        close(areas(&parts, source), expected, 16.0);
        assert_eq!(parts.iter().filter(|(i, _)| *i == source).count(), 2);
    }
}

#[test]
fn edge_on_and_without_an_eye() {
    let floor = square(0.0, 0.0, 0.0, 2.0);
    let wall = polygon([
        [0.0, 1.0, 0.0],
        [2.0, 1.0, 0.0],
        [2.0, 1.0, 2.0],
        [0.0, 1.0, 2.0],
    ]);
    let scene = [floor.clone(), wall.clone()];
    for eye in [DVec4::Z, place(1.0, 1.0, 5.0), place(1.0, 1.0, 1.0)] {
        assert_eq!(visible_parts(&scene, eye), [(0, floor.clone())]);
    }
    assert_eq!(visible_parts(&scene, place(1.0, 0.5, 0.0)), [(1, wall)]);
    for eye in [
        DVec4::ZERO,
        DVec4::NAN,
        DVec4::INFINITY,
        place(0.0, f64::NAN, 0.0),
        place(0.0, f64::INFINITY, 0.0),
    ] {
        assert_eq!(visible_parts(&scene, eye), [], "{eye}");
    }
    let none = [
        polygon([]),
        polygon([[0.0; 3], [1.0; 3]]),
        polygon([[1.0; 3]; 4]),
        polygon([[0.0, 0.0, 1.0], [1.0, 1.0, 1.0], [2.0, 2.0, 1.0]]),
        polygon([[0.0, 0.0, 1.0], [f64::NAN, 1.0, 1.0], [2.0, 0.0, 1.0]]),
    ];
    for bad in none {
        assert_eq!(
            visible_parts(&[bad, floor.clone()], DVec4::Z),
            [(1, floor.clone())]
        );
    }
}

#[test]
fn before_and_behind_the_eye_at_once() {
    let pair = [square(-1.0, -1.0, -1.0, 2.0), square(-1.0, -1.0, 1.0, 2.0)];
    let parts = visible_parts(&pair, place(0.0, 0.0, 0.0));
    assert_eq!(parts, [(0, pair[0].clone()), (1, pair[1].clone())]);
    assert_eq!(visible_parts(&pair, DVec4::Z), [(1, pair[1].clone())]);
}

/// A source of numbers in 0 … 1, the same on every run.
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    fn vector(&mut self) -> DVec3 {
        DVec3::new(self.next(), self.next(), self.next())
    }

    /// A triangle or a regular polygon of up to seven corners in [−1, 1]³.
    fn polygon(&mut self, size: f64) -> Polygon {
        let centre = self.vector() * 2.0 - 1.0;
        let turn = DQuat::from_axis_angle(
            (self.vector() - 0.5).normalize_or(DVec3::X),
            6.0 * self.next(),
        );
        let n = 3 + (5.0 * self.next()) as usize;
        let at = |k: usize| {
            let angle = 2.0 * PI * k as f64 / n as f64;
            size * DVec3::new(libm::cos(angle), libm::sin(angle), 0.0)
        };
        let shift = centre * (1.0 - size);
        Polygon {
            vertices: (0..n).map(|k| turn * at(k) + shift).collect(),
        }
    }
}

/// The solid angle of a polygon from the origin, from its triangles: A. Van Oosterom, J. Strackee, «The solid angle
/// of a plane triangle», 1983.
fn solid_angle(polygon: &Polygon, eye: DVec3) -> f64 {
    let rays: Vec<_> = polygon
        .vertices
        .iter()
        .map(|&v| (v - eye).normalize())
        .collect();
    let triangles = (1..rays.len() - 1).map(|i| {
        let [a, b, c] = [rays[0], rays[i], rays[i + 1]];
        let volume = DMat3::from_cols(a, b, c).determinant();
        2.0 * libm::atan2(volume.abs(), 1.0 + a.dot(b) + b.dot(c) + c.dot(a))
    });
    triangles.sum()
}

/// From inside a closed room every sight line ends somewhere, so the parts fill the sphere of directions: 4π.
#[test]
fn the_parts_fill_the_sphere() {
    let mut numbers = Numbers(2463534242);
    for round in 0..60 {
        let walls = cube(DQuat::IDENTITY, DVec3::splat(-0.5));
        let room = walls.iter().map(|p| Polygon {
            vertices: p.vertices.iter().map(|&v| 4.0 * v).collect(),
        });
        let mut scene: Vec<_> = room.collect();
        for _ in 0..round {
            let at = (scene.len() as f64 * numbers.next()) as usize;
            scene.insert(at, numbers.polygon(0.6));
        }
        let eye = numbers.vector() * 2.0 - 1.0;
        let parts = visible_parts(&scene, eye.extend(1.0));
        let sum: f64 = parts.iter().map(|(_, part)| solid_angle(part, eye)).sum();
        // Corners within 64 ε of where they belong, seen from 10⁻³ at the nearest, along all edges.
        let tolerance = 64.0 * f64::EPSILON * 1e3 * parts.len() as f64;
        assert!(
            (sum - 4.0 * PI).abs() <= tolerance,
            "{round}: {:e}",
            sum - 4.0 * PI
        );
    }
}

/// In a parallel view over a ground that lies under everything, the parts' pictures make up the ground's.
#[test]
fn the_parts_fill_the_picture() {
    let mut numbers = Numbers(88172645463325252);
    for round in 0..60 {
        let mut scene = vec![square(-4.0, -4.0, -4.0, 8.0)];
        for _ in 0..round {
            let at = (scene.len() as f64 * numbers.next()) as usize;
            scene.insert(at, numbers.polygon(0.9));
        }
        let eye = (DVec3::Z + 0.5 * numbers.vector()).extend(0.0);
        let parts = visible_parts(&scene, eye);
        let picture = |p: &Polygon| {
            let flat = p
                .vertices
                .iter()
                .map(|v| *v - eye.truncate() * (v.z / eye.z));
            Polygon {
                vertices: flat.collect(),
            }
            .area()
        };
        let sum: f64 = parts.iter().map(|(_, part)| picture(part)).sum();
        let tolerance = 64.0 * f64::EPSILON * 8.0 * parts.len() as f64;
        assert!((sum - 64.0).abs() <= tolerance, "{round}: {:e}", sum - 64.0);
    }
}

/// What a sight line meets.
enum Hit {
    /// Nothing, by a margin.
    Missed,
    /// At this distance from where the line starts.
    At(f64),
    /// Too near an edge to tell.
    Unclear,
}

/// A brute-force hit of the line origin + t · direction, t > `from`.
fn hit(polygon: &Polygon, origin: DVec3, direction: DVec3, from: f64) -> Hit {
    const MARGIN: f64 = 1e-9;
    let normal: DVec3 = {
        let v = &polygon.vertices;
        (1..v.len() - 1)
            .map(|i| (v[i] - v[0]).cross(v[i + 1] - v[0]))
            .sum()
    };
    let slope = normal.normalize_or_zero().dot(direction);
    if slope.abs() < MARGIN {
        return Hit::Unclear;
    }
    let centre = polygon.vertices.iter().sum::<DVec3>() / polygon.vertices.len() as f64;
    let t = normal.normalize().dot(centre - origin) / slope;
    let x = origin + t * direction;
    let n = polygon.vertices.len();
    let inside = (0..n).map(|i| {
        let (a, b) = (polygon.vertices[i], polygon.vertices[(i + 1) % n]);
        if a == b {
            return f64::INFINITY;
        }
        normal.normalize().cross((b - a).normalize()).dot(x - a)
    });
    let depth = inside.fold(f64::INFINITY, f64::min);
    if depth.abs() < MARGIN || (depth > 0.0 && (t - from).abs() < MARGIN) {
        Hit::Unclear
    } else if depth > 0.0 && t > from {
        Hit::At(t)
    } else {
        Hit::Missed
    }
}

/// The first polygon with the nearest hit; `None` where an edge is too near to tell.
fn nearest(scene: &[Polygon], origin: DVec3, direction: DVec3, from: f64) -> Option<Option<usize>> {
    let mut best: Option<(usize, f64)> = None;
    for (i, polygon) in scene.iter().enumerate() {
        match hit(polygon, origin, direction, from) {
            Hit::Unclear => return None,
            Hit::Missed => {}
            Hit::At(t) => match best {
                Some((_, least)) if t >= least - 1e-12 => {
                    if t - least > 1e-12 && t - least < 1e-9 {
                        return None;
                    }
                }
                Some((_, least)) if t > least - 1e-9 => return None,
                _ => best = Some((i, t)),
            },
        }
    }
    Some(best.map(|(i, _)| i))
}

/// Sight lines through the scene's polygons and beside them: each meets one part, of the polygon that is hit first.
fn check_sight_lines(
    scene: &[Polygon],
    eye: DVec4,
    lines: usize,
    numbers: &mut Numbers,
) -> [usize; 2] {
    let parts = visible_parts(scene, eye);
    for (source, part) in &parts {
        inside_its_source(part, &scene[*source]);
    }
    let (mut told, mut empty) = (0, 0);
    for line in 0..lines {
        let through = if line % 4 == 0 {
            numbers.vector() * 4.0 - 2.0
        } else {
            let p = &scene[line % scene.len()].vertices;
            let weights: Vec<_> = p.iter().map(|_| numbers.next()).collect();
            p.iter().zip(&weights).map(|(&v, &w)| v * w).sum::<DVec3>()
                / weights.iter().sum::<f64>()
        };
        let (direction, from) = if eye.w == 0.0 {
            (-eye.truncate().normalize(), f64::NEG_INFINITY)
        } else {
            ((through - eye.truncate()).normalize(), 0.0)
        };
        let origin = if eye.w == 0.0 {
            through
        } else {
            eye.truncate()
        };
        let Some(expected) = nearest(scene, origin, direction, from) else {
            continue;
        };
        let mut met = Vec::new();
        let mut clear = true;
        for (source, part) in &parts {
            match hit(part, origin, direction, from) {
                Hit::Unclear => clear = false,
                Hit::At(_) => met.push(*source),
                Hit::Missed => {}
            }
        }
        if clear {
            assert_eq!(
                met,
                Vec::from_iter(expected),
                "{scene:?} from {eye} through {through}"
            );
            told += 1;
            empty += usize::from(expected.is_none());
        }
    }
    [told, empty]
}

/// Corners of a part lie on its polygon's plane and inside its edges, within the rounding of their making.
fn inside_its_source(part: &Polygon, source: &Polygon) {
    let plane = source.plane().unwrap();
    let normal = plane.normal.normalize();
    let n = source.vertices.len();
    let scale = source
        .vertices
        .iter()
        .map(|v| v.abs().max_element())
        .fold(0.0, f64::max);
    for v in &part.vertices {
        let off = plane.signed_distance(*v).abs();
        assert!(off <= 64.0 * f64::EPSILON * scale, "{off:e}");
        for i in 0..n {
            let (a, b) = (source.vertices[i], source.vertices[(i + 1) % n]);
            let inside = normal.cross((b - a).normalize()).dot(*v - a);
            assert!(inside >= -64.0 * f64::EPSILON * scale, "{inside:e}");
        }
    }
    assert!(part.plane().unwrap().normal.dot(normal) > 0.0);
    assert!(part.area() > 0.0);
    assert!(Polygon::new(part.vertices.clone()).is_ok(), "{part:?}");
}

#[test]
fn each_sight_line_meets_one_part() {
    let mut numbers = Numbers(362436069);
    let mut told = [0; 2];
    for round in 0..120 {
        let k = 2 + round % 15;
        let size = [0.3, 0.6, 0.9][round % 3];
        let scene: Vec<_> = (0..k).map(|_| numbers.polygon(size)).collect();
        // Far away, in the middle of it all, and parallel.
        let at = numbers.vector() * 2.0 - 1.0;
        let eye = [(at * 5.0).extend(1.0), at.extend(1.0), at.extend(0.0)][round % 7 % 3];
        let [a, b] = check_sight_lines(&scene, eye, 100, &mut numbers);
        told = [told[0] + a, told[1] + b];
    }
    assert!(told[0] > 11_000 && told[1] > 500, "{told:?}");
}

/// On a lattice corners, edges and planes meet, and polygons lie in one plane.
#[test]
fn each_sight_line_meets_one_part_where_much_touches() {
    let mut numbers = Numbers(521288629);
    let mut told = [0; 2];
    for round in 0..400 {
        let mut whole = || (numbers.vector() * 5.0).floor() - 2.0;
        let mut scene = Vec::new();
        while scene.len() < 2 + round % 9 {
            let [a, b, c] = [whole(), whole(), whole()];
            let vertices = if round % 2 == 0 {
                vec![a, b, c]
            } else {
                vec![a, b, c, a + c - b]
            };
            scene.extend(Polygon::new(vertices));
        }
        let eye = [
            (3.0 * whole()).extend(1.0),
            whole().extend(1.0),
            whole().extend(0.0),
        ][round % 3];
        if eye != DVec4::ZERO {
            let [a, b] = check_sight_lines(&scene, eye, 50, &mut numbers);
            told = [told[0] + a, told[1] + b];
        }
    }
    assert!(told[0] > 10_000 && told[1] > 500, "{told:?}");
}

/// Many cuts of cuts: triangles of a mesh before another mesh.
#[test]
fn meshes_leave_no_slivers() {
    let grid = |z: f64, shift: f64, turn: f64| {
        let turn = DQuat::from_axis_angle(DVec3::new(0.1, 0.2, 1.0).normalize(), turn);
        let at = move |i: i32, j: i32| turn * DVec3::new(f64::from(i) + shift, f64::from(j), z);
        let cells = (0..36).map(move |k| (k % 6 - 3, k / 6 - 3));
        cells.flat_map(move |(i, j)| {
            let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            [vec![a, b, c], vec![a, c, d]].map(|vertices| Polygon { vertices })
        })
    };
    let scene: Vec<_> = grid(0.0, 0.0, 0.0).chain(grid(1.0, 0.25, 0.3)).collect();
    for eye in [DVec4::Z, place(0.1, 0.2, 9.0)] {
        let parts = visible_parts(&scene, eye);
        for (source, part) in &parts {
            inside_its_source(part, &scene[*source]);
            // Real slivers are rare here: 10⁻⁹ is far above rounding and far below the cells.
            assert!(part.area() > 1e-9, "{} {:e}", source, part.area());
        }
        let whole: f64 = parts
            .iter()
            .filter(|(i, _)| *i >= 72)
            .map(|(_, p)| p.area())
            .sum();
        close(whole, 36.0, 36.0 * 36.0);
    }
}

proptest! {
    #[test]
    fn never_panics(
        scene in prop::collection::vec(prop::collection::vec(prop::array::uniform3(ANY), 0..6), 0..5),
        eye in prop::array::uniform4(ANY), w in 0usize..3,
    ) {
        let polygon = |v: Vec<[f64; 3]>| Polygon { vertices: v.into_iter().map(DVec3::from).collect() };
        let scene: Vec<_> = scene.into_iter().map(polygon).collect();
        let mut eye = DVec4::from(eye);
        eye.w = [eye.w, 0.0, 1.0][w];
        for (source, part) in visible_parts(&scene, eye) {
            prop_assert!(source < scene.len() && part.vertices.iter().all(|v| v.is_finite()));
        }
    }

    /// Not planar, not convex, thin, repeated corners: some answer, and finite.
    #[test]
    fn unchecked_polygons(
        scene in prop::collection::vec(prop::collection::vec(prop::array::uniform3(-2i32..3), 3..7), 0..6),
        eye in prop::array::uniform4(-3i32..4),
    ) {
        let vector = |v: [i32; 3]| DVec3::from(v.map(f64::from));
        let polygon = |v: Vec<[i32; 3]>| Polygon { vertices: v.into_iter().map(vector).collect() };
        let scene: Vec<_> = scene.into_iter().map(polygon).collect();
        for (source, part) in visible_parts(&scene, DVec4::from(eye.map(f64::from))) {
            prop_assert!(source < scene.len() && part.vertices.iter().all(|v| v.is_finite()));
        }
    }
}
