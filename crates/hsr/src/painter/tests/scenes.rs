//! Scenes, and what brute force sees of them along one sight line.

use ombra_math::glam::{DVec3, DVec4};
use proptest::prelude::*;

use crate::polygon::Polygon;

pub(super) fn polygon(vertices: &[[f64; 3]]) -> Polygon {
    Polygon {
        vertices: vertices.iter().copied().map(DVec3::from_array).collect(),
    }
}

/// A square of half side `r` round (x, y) at height z.
pub(super) fn square(x: f64, y: f64, z: f64, r: f64) -> Polygon {
    polygon(&[
        [x - r, y - r, z],
        [x + r, y - r, z],
        [x + r, y + r, z],
        [x - r, y + r, z],
    ])
}

/// Three sticks round a triangle; seen from above, each begins over the end of the one before.
pub(super) fn sticks() -> [Polygon; 3] {
    [
        polygon(&[
            [-2.0, 0.0, 1.0],
            [10.0, 0.0, -1.0],
            [10.0, 1.0, -1.0],
            [-2.0, 1.0, 1.0],
        ]),
        polygon(&[
            [9.0, -2.0, 1.0],
            [8.0, -2.0, 1.0],
            [8.0, 10.0, -1.0],
            [9.0, 10.0, -1.0],
        ]),
        polygon(&[
            [10.0, 9.0, 1.0],
            [9.0, 10.0, 1.0],
            [-2.0, 1.0, -1.0],
            [-1.0, 0.0, -1.0],
        ]),
    ]
}

/// A triangle, or a parallelogram, on the same three points.
fn triangle_or_more([a, b, c]: [DVec3; 3], four: bool) -> Polygon {
    let mut vertices = vec![a, b, c];
    if four {
        vertices.push(a + c - b);
    }
    Polygon { vertices }
}

/// Places in the cube of half side 4, or few of them, so that vertices, edges and planes are shared.
fn place(whole: bool) -> impl Strategy<Value = DVec3> {
    let coordinate = if whole {
        (-2i32..=2).prop_map(f64::from).boxed()
    } else {
        (-4.0..4.0).boxed()
    };
    [coordinate.clone(), coordinate.clone(), coordinate].prop_map(DVec3::from_array)
}

/// Large primitives that cross and surround the eye, small ones, or ones on few places.
pub(super) fn scene(most: usize) -> impl Strategy<Value = Vec<Polygon>> {
    let large = ([place(false), place(false), place(false)], any::<bool>())
        .prop_map(|(p, four)| triangle_or_more(p, four));
    let small = ([place(false), place(false), place(false)], any::<bool>())
        .prop_map(|([a, b, c], four)| triangle_or_more([a, a + b * 0.4, a + c * 0.4], four));
    let whole = ([place(true), place(true), place(true)], any::<bool>())
        .prop_map(|(p, four)| triangle_or_more(p, four));
    // The same but for a few last places: planes that all but coincide, edges that all but touch.
    let nearly = (
        [place(true), place(true), place(true)],
        prop::array::uniform3(-4..4i64),
        any::<bool>(),
    )
        .prop_map(|(p, ulps, four)| {
            let moved = |x: f64, n: i64| f64::from_bits(x.to_bits().wrapping_add_signed(n));
            let [a, b, c] = p;
            let a = DVec3::new(moved(a.x - 0.5, ulps[0]), a.y, a.z);
            let b = DVec3::new(b.x, moved(b.y + 0.25, ulps[1]), b.z);
            let c = DVec3::new(c.x, c.y, moved(c.z + 0.125, ulps[2]));
            triangle_or_more([a, b, c], four)
        });
    prop_oneof![
        prop::collection::vec(nearly, 0..=most),
        prop::collection::vec(large, 0..=most),
        prop::collection::vec(small, 0..=most),
        prop::collection::vec(whole, 0..=most),
    ]
}

/// Among the primitives, away from them, on a vertex, and in a parallel view along an axis or not.
pub(super) fn eye() -> impl Strategy<Value = DVec4> {
    prop_oneof![
        place(false).prop_map(|p| p.extend(1.0)),
        place(true).prop_map(|p| p.extend(1.0)),
        place(false).prop_map(|p| (p * 4.0).extend(1.0)),
        place(false).prop_map(|p| p.extend(0.0)),
        prop::sample::select(vec![DVec4::Z, DVec4::NEG_X, DVec4::new(1.0, 1.0, 0.0, 0.0)]),
    ]
}

/// Where the sight line through `target` meets a primitive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Meeting {
    /// It does not.
    Beside,
    /// Its inside, at this distance; compared along one sight line only.
    At(f64),
    /// Its edge, or nearly, or edge-on: nothing can be said.
    Unclear,
}

/// How far from an edge, in units of the scene, a sight line is clear.
const CLEAR: f64 = 1e-6;

pub(super) fn meeting(primitive: &Polygon, eye: DVec4, target: DVec3) -> Meeting {
    let vertices = &primitive.vertices;
    let (origin, direction) = if eye.w == 0.0 {
        (target, -eye.truncate().normalize())
    } else {
        let at = eye.truncate() / eye.w;
        (at, (target - at).normalize())
    };
    let Some(normal) = area(primitive).try_normalize() else {
        return Meeting::Unclear;
    };
    let slope = normal.dot(direction);
    if slope.is_nan() || slope.abs() <= 1e-3 {
        return Meeting::Unclear;
    }
    let t = normal.dot(vertices[0] - origin) / slope;
    let hit = origin + t * direction;
    let next = vertices.iter().cycle().skip(1);
    // Two rounded vertices where three planes meet make an edge of no direction; its neighbours are enough.
    let edges = vertices
        .iter()
        .zip(next)
        .filter(|(a, b)| a.distance(**b) > 1e-12);
    let inside = edges.map(|(&a, &b)| {
        let inwards = normal.cross(b - a).normalize_or_zero();
        inwards.dot(hit - a)
    });
    let least = inside.fold(f64::INFINITY, f64::min);
    if least < -CLEAR || (eye.w != 0.0 && t < -CLEAR) {
        Meeting::Beside
    } else if least > CLEAR && (eye.w == 0.0 || t > CLEAR) {
        Meeting::At(t)
    } else {
        Meeting::Unclear
    }
}

/// The area, along the normal.
pub(super) fn area(p: &Polygon) -> DVec3 {
    let v = &p.vertices;
    let twice = |i: usize| (v[i] - v[0]).cross(v[i + 1] - v[0]);
    (1..v.len() - 1).map(twice).sum::<DVec3>() * 0.5
}

/// The mean of the vertices, with these weights.
pub(super) fn point_of(primitive: &Polygon, weights: [f64; 4]) -> DVec3 {
    let shares = primitive.vertices.iter().zip(weights);
    let (sum, all) = shares.fold((DVec3::ZERO, 0.0), |(sum, all), (&v, w)| {
        (sum + w * v, all + w)
    });
    sum / all
}
