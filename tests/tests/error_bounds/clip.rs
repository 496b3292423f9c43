//! What ombra-clip states. The forms of the slides answer the same, which their own tests see to.

use ombra_clip::box3::{self, Box3};
use ombra_clip::homogeneous::{self, Vertex, ViewPlane};
use ombra_clip::sutherland_hodgman::{
    self, HalfPlane, clip_against_line, clip_against_plane, clip_homogeneous,
};
use ombra_clip::{
    Segment, Window, cohen_sutherland, crossing, cyrus_beck, direct, liang_barsky, pieces,
};
use ombra_math::glam::{DVec2, DVec3, DVec4};
use ombra_math::plane::Plane;
use ombra_oracle::Exact;
use ombra_oracle::interval::{between, not_negative};
use ombra_oracle::vector::{dot, exact};
use ombra_tests::cases::Random;

use super::share::{Share, Worst, eps, q3};
use super::to_300_bits::{q, quotient};

const CASES: u32 = 400;

pub fn shares() -> Vec<Share> {
    let mut random = Random::new(11);
    [
        crossings(&mut random),
        in_the_plane(&mut random),
        in_space(&mut random),
        polygons(&mut random),
        against_one(&mut random),
    ]
    .concat()
}

fn number(random: &mut Random) -> f64 {
    random.exponential(-4, 3)
}
fn point(random: &mut Random) -> DVec2 {
    DVec2::new(number(random), number(random))
}
fn place(random: &mut Random) -> DVec3 {
    DVec3::new(number(random), number(random), number(random))
}

/// The ends of what none of the linear `functions` makes negative, compared with what was found.
fn ends<const N: usize>(
    worst: &mut Worst,
    found: Option<[[f64; N]; 2]>,
    [a, b]: [[f64; N]; 2],
    functions: &[[Exact; 2]],
) {
    let right = not_negative(functions);
    assert_eq!(found.is_some(), right.is_some(), "{a:?} {b:?}");
    let (Some(found), Some(right)) = (found, right) else {
        return;
    };
    for (found, t) in found.iter().zip(right) {
        for i in 0..N {
            worst.see_nearest(found[i], &between(&t, &q(a[i]), &q(b[i])));
        }
    }
}

fn crossings(random: &mut Random) -> Vec<Share> {
    let mut worst = Worst::default();
    for _ in 0..CASES {
        let [a, b] = [point(random), point(random)];
        let y = a.y + random.between(0.0, 1.0) * (b.y - a.y);
        let Some(found) = crossing::at_y(Segment::new(a, b), y) else {
            continue;
        };
        let t = quotient(&(q(y) - q(a.y)), &(q(b.y) - q(a.y)));
        worst.see_nearest(found, &between(&t, &q(a.x), &q(b.x)));
    }
    vec![worst.of("ombra_clip::crossing::at_y")]
}

fn in_the_plane(random: &mut Random) -> Vec<Share> {
    let mut worst: [Worst; 4] = Default::default();
    for _ in 0..CASES {
        let (p, r, s) = (
            point(random),
            point(random),
            Segment::new(point(random), point(random)),
        );
        let window = Window {
            min: p.min(r),
            max: p.max(r),
        };
        let mut sides = Vec::new();
        for i in 0..2 {
            sides.push([s.a, s.b].map(|end| q(end[i]) - q(window.min[i])));
            sides.push([s.a, s.b].map(|end| q(window.max[i]) - q(end[i])));
        }
        let found = [
            direct::clip_segment(&window, s),
            cohen_sutherland::clip_segment(&window, s),
            liang_barsky::clip_segment(&window, s),
            cyrus_beck::clip_segment(&window.corners(), s),
        ];
        for (worst, found) in worst.iter_mut().zip(found) {
            let found = found.map(|s| [s.a, s.b].map(<[f64; 2]>::from));
            ends(worst, found, [s.a, s.b].map(<[f64; 2]>::from), &sides);
        }
    }
    let names = ["direct", "cohen_sutherland", "liang_barsky", "cyrus_beck"];
    let all = worst.iter().zip(names);
    all.map(|(worst, name)| worst.of(&format!("ombra_clip::{name}::clip_segment")))
        .collect()
}

fn in_space(random: &mut Random) -> Vec<Share> {
    let mut worst: [Worst; 3] = Default::default();
    for _ in 0..CASES {
        let (p, r, s) = (place(random), place(random), [place(random), place(random)]);
        let bounds = Box3 {
            min: p.min(r),
            max: p.max(r),
        };
        let mut sides = Vec::new();
        for i in 0..3 {
            sides.push(s.map(|end| q(end[i]) - q(bounds.min[i])));
            sides.push(s.map(|end| q(bounds.max[i]) - q(end[i])));
        }
        let found = box3::clip_segment(&bounds, s).map(|ends| ends.map(<[f64; 3]>::from));
        ends(&mut worst[0], found, s.map(<[f64; 3]>::from), &sides);

        // A tetrahedron's worth of planes in front of the middle of the segment.
        let middle = s[0] * 0.5 + s[1] * 0.5;
        let planes = [(); 4].map(|()| {
            let normal = place(random);
            let d = number(random).abs() - normal.dot(middle);
            Plane { normal, d }
        });
        let value = |plane: &Plane, p: DVec3| dot(&q3(plane.normal), &q3(p)) + q(plane.d);
        let sides: Vec<_> = planes
            .iter()
            .map(|plane| s.map(|p| value(plane, p)))
            .collect();
        let found = cyrus_beck::clip_segment_3d(&planes, s).map(|ends| ends.map(<[f64; 3]>::from));
        ends(&mut worst[1], found, s.map(<[f64; 3]>::from), &sides);

        let s = s.map(|p| p.extend(number(random)));
        let sides: Vec<_> = (0..6)
            .map(|k| {
                let sign = if k % 2 == 0 { q(1.0) } else { q(-1.0) };
                s.map(|p| q(p.w) + &sign * q(p[k / 2]))
            })
            .collect();
        let found = homogeneous::clip_segment(s).map(|ends| ends.map(<[f64; 4]>::from));
        ends(&mut worst[2], found, s.map(<[f64; 4]>::from), &sides);
    }
    vec![
        worst[0].of("ombra_clip::box3::clip_segment"),
        worst[1].of("ombra_clip::cyrus_beck::clip_segment_3d"),
        worst[2].of("ombra_clip::homogeneous::clip_segment"),
    ]
}

/// Where the sign of the linear function with these values at the corners changes, in the order of the edges.
fn cuts<const N: usize>(corners: &[[Exact; N]], values: &[Exact]) -> Vec<[Exact; N]> {
    let n = corners.len();
    let edges = (0..n).map(|i| (i, (i + 1) % n));
    edges
        .filter(|&(i, j)| values[i].sign() == values[j].sign().reverse() && values[i] != 0)
        .map(|(i, j)| {
            let t = quotient(&values[i], &(&values[i] - &values[j]));
            std::array::from_fn(|k| between(&t, &corners[i][k], &corners[j][k]))
        })
        .collect()
}

/// Each coordinate of what was found is nearest to that of one of the `places`.
fn among<const N: usize>(worst: &mut Worst, found: [f64; N], places: &[[Exact; N]]) {
    let place = places
        .iter()
        .find(|place| (0..N).all(|k| place[k].nearest() == found[k]));
    let place = place.unwrap_or_else(|| panic!("{found:?} is no vertex"));
    for k in 0..N {
        worst.see_nearest(found[k], &place[k]);
    }
}

fn polygons(random: &mut Random) -> Vec<Share> {
    let mut worst: [Worst; 2] = Default::default();
    for _ in 0..CASES {
        let (p, r) = (point(random), point(random));
        let window = Window {
            min: p.min(r),
            max: p.max(r),
        };
        let polygon = [(); 5].map(|()| point(random));
        let corners = polygon.map(|p| exact(p).unwrap());
        // Its own vertices, the window's, and what the window's sides cut.
        let mut places = corners.to_vec();
        places.extend(window.corners().map(|p| exact(p).unwrap()));
        for (i, side) in [
            (0, window.min.x),
            (0, window.max.x),
            (1, window.min.y),
            (1, window.max.y),
        ] {
            let values = corners.each_ref().map(|p| &p[i] - q(side));
            places.extend(cuts(&corners, &values));
        }
        for v in sutherland_hodgman::clip_polygon(&window, &polygon) {
            among(&mut worst[0], v.to_array(), &places);
        }
        for v in pieces::clip_polygon(&window, &polygon).concat() {
            among(&mut worst[1], v.to_array(), &places);
        }
    }
    vec![
        worst[0].of("ombra_clip::sutherland_hodgman::clip_polygon"),
        worst[1].of("ombra_clip::pieces::clip_polygon"),
    ]
}

/// What is in `found` and not in `given`.
fn new<V: PartialEq + Copy>(found: Vec<V>, given: &[V]) -> Vec<V> {
    found.into_iter().filter(|v| !given.contains(v)).collect()
}

fn against_one(random: &mut Random) -> Vec<Share> {
    let mut worst: [Worst; 4] = Default::default();
    for _ in 0..CASES {
        let half = HalfPlane {
            normal: point(random),
            offset: number(random),
        };
        let polygon = [(); 3].map(|()| point(random));
        let corners = polygon.map(|p| exact(p).unwrap());
        let normal = exact(half.normal).unwrap();
        let values = corners.each_ref().map(|p| dot(&normal, p) - q(half.offset));
        let places = cuts(&corners, &values);
        for v in new(clip_against_line(&polygon, half), &polygon) {
            among(&mut worst[0], v.to_array(), &places);
        }

        let (plane, polygon) = (
            Plane {
                normal: place(random),
                d: number(random),
            },
            [(); 3].map(|()| place(random)),
        );
        let corners = polygon.map(q3);
        let normal = q3(plane.normal);
        let values = corners.each_ref().map(|p| dot(&normal, p) + q(plane.d));
        let (places, found) = (
            cuts(&corners, &values),
            new(clip_against_plane(&polygon, &plane), &polygon),
        );
        assert_eq!(places.len(), found.len());
        // Each against the cut of its own edge, the nearest one.
        let edges = (0..3).map(|i| [polygon[i], polygon[(i + 1) % 3]]);
        let edges = edges
            .zip(0..3)
            .filter(|&(_, i)| values[i].sign() != values[(i + 1) % 3].sign());
        let own: Vec<_> = edges.map(|(edge, _)| edge).zip(&places).collect();
        for v in &found {
            let off = |place: &[Exact; 3]| (0..3).map(|k| (q(v[k]) - &place[k]).abs()).max();
            let (edge, place) = own.iter().min_by_key(|(_, place)| off(place)).unwrap();
            for k in 0..3 {
                let larger = q(edge[0][k].abs().max(edge[1][k].abs()));
                worst[1].see(v[k], &place[k], &(eps(4.0) * larger));
            }
        }

        homogeneous_cuts(random, &mut worst[2]);

        let triangle = [(); 3].map(|()| Vertex {
            position: place(random).extend(number(random)),
            attributes: [number(random)],
        });
        let all = |v: &Vertex<1>| {
            let [x, y, z, w] = v.position.to_array();
            [x, y, z, w, v.attributes[0]]
        };
        let corners = triangle.each_ref().map(|v| all(v).map(q));
        let values = corners.each_ref().map(|v| &v[3] + &v[2]);
        let mut places = cuts(&corners, &values);
        places.extend(corners);
        for v in homogeneous::clip_polygon_to(&triangle, &[ViewPlane::Near]) {
            among(&mut worst[3], all(&v), &places);
        }
    }
    vec![
        worst[0].of("ombra_clip::sutherland_hodgman::clip_against_line"),
        worst[1].of("ombra_clip::sutherland_hodgman::clip_against_plane"),
        worst[2].of("ombra_clip::sutherland_hodgman::clip_homogeneous"),
        worst[3].of("ombra_clip::homogeneous::clip_polygon_to"),
    ]
}

/// Each crossing of a triangle's edges is s_A B − s_B A, with A inside, times a power of two.
fn homogeneous_cuts(random: &mut Random, worst: &mut Worst) {
    let [plane, a, b, c] = [(); 4].map(|()| place(random).extend(number(random)));
    let triangle = [a, b, c];
    let of = |p: DVec4| exact::<4>(p).unwrap();
    let side = |p: DVec4| dot(&of(plane), &of(p));
    let edges = [[a, b], [b, c], [c, a], [b, a], [c, b], [a, c]];
    let cut = edges.iter().filter(|[a, b]| side(*a) > 0 && side(*b) < 0);
    let terms: Vec<[[Exact; 2]; 4]> = cut
        .map(|&[a, b]| std::array::from_fn(|k| [side(a) * q(b[k]), -(side(b) * q(a[k]))]))
        .collect();
    for v in new(clip_homogeneous(&triangle, plane), &triangle) {
        // Share of the bound, and all that it was made of, for the edge that v is on.
        let largest = v.abs().max_position();
        let on = terms.iter().map(|terms| {
            let right = terms.each_ref().map(|[s, t]| s + t);
            let sizes = terms.each_ref().map(|[s, t]| s.abs() + t.abs());
            let power = (q(v[largest]).ratio(&right[largest])).abs().log2().round();
            let scale = Exact::power_of_two(power as i64);
            let off: Exact = (0..4).map(|k| (q(v[k]) - &right[k] * &scale).abs()).sum();
            (off, right, sizes, scale)
        });
        let (_, right, sizes, scale) = on.min_by(|a, b| a.0.cmp(&b.0)).unwrap();
        for k in 0..4 {
            worst.see(
                v[k],
                &(&right[k] * &scale),
                &(eps(3.0) * &sizes[k] * &scale),
            );
        }
    }
}
