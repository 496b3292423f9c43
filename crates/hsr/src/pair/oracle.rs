//! Two convex polygons compared without rounding, along another way: the rays that bound the region seen through both.

use core::cmp::Ordering;

use ombra_math::glam::{DVec3, DVec4};
use ombra_oracle::Exact;
use ombra_oracle::vector::{cross, dot, minus, mix};

use super::Pair;
use crate::polygon::Polygon;

type Vector = [Exact; 3];

pub(super) fn exact(v: DVec3) -> Vector {
    ombra_oracle::vector::exact(v).unwrap()
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
            .find(|f| dot(f, f) != 0)
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
                [dot(f, v), dot(g, v), Exact::from(1)]
            }
        }
    }

    /// How far from the viewer the plane n·X = c is on the sight line `ray`.
    fn depth(&self, n: &Vector, c: &Exact, ray: &Vector) -> Exact {
        match self {
            Self::Place(e) => (c - dot(n, e)).over(&dot(n, ray)).unwrap(),
            Self::Parallel(axes) => {
                let [e, f, g] = axes.as_ref();
                let place = |x: &Exact, axis| x.over(&(&ray[2] * dot(axis, axis))).unwrap();
                let (u, v) = (place(&ray[0], f), place(&ray[1], g));
                (dot(n, &mix(&u, f, &v, g)) - c).over(&dot(n, e)).unwrap()
            }
        }
    }
}

/// The rays of a polygon's corners, turning one way, and its plane n·X = c; `None` seen edge-on.
fn cone(polygon: &Polygon, view: &View) -> Option<(Vec<Vector>, Vector, Exact)> {
    let vertices: Vec<Vector> = polygon.vertices.iter().map(|&v| exact(v)).collect();
    let n = cross(
        &minus(&vertices[1], &vertices[0]),
        &minus(&vertices[2], &vertices[0]),
    );
    let c = dot(&n, &vertices[0]);
    let mut rays: Vec<Vector> = vertices.iter().map(|v| view.ray(v)).collect();
    match dot(&cross(&rays[0], &rays[1]), &rays[2]).sign() {
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
        if s >= 0 {
            kept.push(a.clone());
        }
        if &s * &t < 0 {
            let (s, t) = if s > 0 { (s, -t) } else { (-s, t) };
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
            shared[..j].iter().any(|c| dot(&n, c) != 0)
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
