//! Two convex polygons compared in rationals, along another way: the rays that bound the region seen through both.

use core::cmp::Ordering;

use num_bigint::BigInt;
use num_rational::BigRational;
use ombra_math::glam::{DVec3, DVec4};

use super::Pair;
use crate::polygon::Polygon;

type Number = BigRational;
type Vector = [Number; 3];

fn zero() -> Number {
    Number::from_integer(BigInt::from(0))
}

pub(super) fn exact(v: DVec3) -> Vector {
    v.to_array().map(|x| Number::from_float(x).unwrap())
}

fn dot(a: &Vector, b: &Vector) -> Number {
    &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2]
}

fn cross(a: &Vector, b: &Vector) -> Vector {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| &a[i] * &b[j] - &a[j] * &b[i])
}

fn minus(a: &Vector, b: &Vector) -> Vector {
    [0, 1, 2].map(|i| &a[i] - &b[i])
}

fn mix(s: &Number, a: &Vector, t: &Number, b: &Vector) -> Vector {
    [0, 1, 2].map(|i| s * &a[i] + t * &b[i])
}

/// What an exact eye sees: sight lines are vectors r, cones of them are bounded by planes through 0.
enum View {
    Place(Vector),
    /// The direction, and two at right angles to it and each other.
    Parallel(Box<[Vector; 3]>),
}

impl View {
    fn new(eye: DVec4) -> Self {
        let e = exact(eye.truncate());
        if eye.w != 0.0 {
            assert_eq!(eye.w, 1.0);
            return Self::Place(e);
        }
        let axes = [DVec3::X, DVec3::Y].map(exact);
        let f = axes
            .iter()
            .map(|axis| cross(&e, axis))
            .find(|f| dot(f, f) != zero())
            .unwrap();
        let g = cross(&e, &f);
        Self::Parallel(Box::new([e, f, g]))
    }

    /// The sight line through a point.
    fn ray(&self, v: &Vector) -> Vector {
        match self {
            Self::Place(e) => minus(v, e),
            Self::Parallel(axes) => {
                let [_, f, g] = axes.as_ref();
                [dot(f, v), dot(g, v), Number::from_integer(BigInt::from(1))]
            }
        }
    }

    /// How far from the viewer the plane n·X = c is on the sight line `ray`.
    fn depth(&self, n: &Vector, c: &Number, ray: &Vector) -> Number {
        match self {
            Self::Place(e) => (c - dot(n, e)) / dot(n, ray),
            Self::Parallel(axes) => {
                let [e, f, g] = axes.as_ref();
                let (u, v) = (&ray[0] / &ray[2] / dot(f, f), &ray[1] / &ray[2] / dot(g, g));
                (dot(n, &mix(&u, f, &v, g)) - c) / dot(n, e)
            }
        }
    }
}

/// The rays of a polygon's corners, turning one way, and its plane n·X = c; `None` seen edge-on.
fn cone(polygon: &Polygon, view: &View) -> Option<(Vec<Vector>, Vector, Number)> {
    let vertices: Vec<Vector> = polygon.vertices.iter().map(|&v| exact(v)).collect();
    let n = cross(
        &minus(&vertices[1], &vertices[0]),
        &minus(&vertices[2], &vertices[0]),
    );
    let c = dot(&n, &vertices[0]);
    let mut rays: Vec<Vector> = vertices.iter().map(|v| view.ray(v)).collect();
    match dot(&cross(&rays[0], &rays[1]), &rays[2]).cmp(&zero()) {
        Ordering::Equal => return None,
        Ordering::Less => rays.reverse(),
        Ordering::Greater => {}
    }
    Some((rays, n, c))
}

/// The corners of a cone cut by the plane through 0 with the normal `n`.
fn cut(rays: &[Vector], n: &Vector) -> Vec<Vector> {
    let mut kept = Vec::new();
    for (i, a) in rays.iter().enumerate() {
        let b = &rays[(i + 1) % rays.len()];
        let (s, t) = (dot(n, a), dot(n, b));
        if s >= zero() {
            kept.push(a.clone());
        }
        if &s * &t < zero() {
            let (s, t) = if s > zero() { (s, -t) } else { (-s, t) };
            kept.push(mix(&t, a, &s, b));
        }
    }
    kept
}

/// The answer [`compare`](super::compare) has to give, with no tolerance.
pub(super) fn compare(first: &Polygon, second: &Polygon, eye: DVec4) -> Pair {
    let view = View::new(eye);
    let (Some((p, n_p, c_p)), Some((q, n_q, c_q))) = (cone(first, &view), cone(second, &view))
    else {
        return Pair::Apart;
    };
    let mut shared = p;
    for (i, a) in q.iter().enumerate() {
        shared = cut(&shared, &cross(a, &q[(i + 1) % q.len()]));
    }
    let solid = shared.iter().enumerate().any(|(i, a)| {
        shared[..i].iter().enumerate().any(|(j, b)| {
            let n = cross(a, b);
            shared[..j].iter().any(|c| dot(&n, c) != zero())
        })
    });
    if !solid {
        return Pair::Apart;
    }
    let depths = shared.iter().map(|ray| {
        let depth = |n, c| view.depth(n, c, ray);
        depth(&n_p, &c_p).cmp(&depth(&n_q, &c_q))
    });
    let depths: Vec<_> = depths.collect();
    let any = |o| depths.contains(&o);
    match (any(Ordering::Less), any(Ordering::Greater)) {
        (false, false) => Pair::Coplanar,
        (true, false) => Pair::FirstNearer,
        (false, true) => Pair::SecondNearer,
        (true, true) => Pair::Crossing,
    }
}
