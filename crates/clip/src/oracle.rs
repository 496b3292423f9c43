//! What the tests compare with: exact numbers, and shapes next to degenerate ones.

use core::cmp::Ordering;

use ombra_math::glam::DVec2;
use ombra_math::predicates::orient_2d;
pub(crate) use ombra_oracle::Exact;
use ombra_oracle::interval::between;
pub(crate) use ombra_oracle::interval::not_negative;
use ombra_oracle::vector::{doubled_area, exact, minus};
use proptest::prelude::*;

use crate::{Segment, Window};

pub(crate) fn r(x: f64) -> Exact {
    Exact::new(x).unwrap()
}

/// Whether `x` is the double nearest to `exact`; of two as near, the one with the even last bit.
pub(crate) fn is_nearest(x: f64, exact: &Exact) -> bool {
    x.is_finite() && x == exact.nearest()
}

pub(crate) type Point = [Exact; 2];

/// The clipped segment: the interval of t that fulfils all four inequalities.
pub(crate) fn clip(window: &Window, s: Segment) -> Option<[Point; 2]> {
    let [a, b, min, max] = [s.a, s.b, window.min, window.max].map(|p| exact(p).unwrap());
    let inside = |p| minus(p, &min).into_iter().chain(minus(&max, p));
    let sides: Vec<_> = inside(&a).zip(inside(&b)).map(Into::into).collect();
    let at = |t: Exact| [0, 1].map(|i| between(&t, &a[i], &b[i]));
    Some(not_negative(&sides)?.map(at))
}

/// Twice the signed area.
pub(crate) fn area(polygon: &[DVec2]) -> Exact {
    let polygon: Vec<Point> = polygon.iter().map(|&p| exact(p).unwrap()).collect();
    doubled_area(&polygon)
}

/// The winding number of the polygon around p; `None` on its boundary.
pub(crate) fn winding(polygon: &[DVec2], p: DVec2) -> Option<i64> {
    let mut winding = 0;
    for (i, &a) in polygon.iter().enumerate() {
        let b = polygon[(i + 1) % polygon.len()];
        let side = orient_2d(a, b, p)?;
        let within = |a: f64, b: f64, p: f64| (a <= p && p <= b) || (b <= p && p <= a);
        if side == Ordering::Equal && within(a.x, b.x, p.x) && within(a.y, b.y, p.y) {
            return None;
        }
        if a.y <= p.y && b.y > p.y && side == Ordering::Greater {
            winding += 1;
        } else if a.y > p.y && b.y <= p.y && side == Ordering::Less {
            winding -= 1;
        }
    }
    Some(winding)
}

/// Numbers of all exponents, small integers (so that ends meet sides), and the middle of the range.
pub(crate) fn number() -> impl Strategy<Value = f64> {
    prop_oneof![
        4 => (-12i32..24).prop_map(f64::from),
        4 => -12.0..24.0f64,
        1 => (-1.0..1.0f64, -1070..1020i32).prop_map(|(m, e)| libm::scalbn(m, e)),
        1 => (-3i32..4).prop_map(|k| f64::from(k) * 2.5e307),
    ]
}

pub(crate) fn point() -> impl Strategy<Value = DVec2> {
    (number(), number()).prop_map(DVec2::from)
}

pub(crate) fn window() -> impl Strategy<Value = Window> {
    let any = (point(), point()).prop_map(|(p, q)| Window::new(p.min(q), p.max(q)).unwrap());
    let lecture = Window::new(DVec2::ZERO, DVec2::splat(10.0)).unwrap();
    prop_oneof![
        3 => Just(lecture),
        2 => any,
        1 => point().prop_map(|p| Window::new(p, p).unwrap()),
        1 => (point(), number()).prop_map(|(p, x)| {
            let q = DVec2::new(x, p.y);
            Window::new(p.min(q), p.max(q)).unwrap()
        }),
    ]
}

/// `x`, moved by a few ulps.
pub(crate) fn beside(x: f64, ulps: i64) -> f64 {
    let moved = match ulps {
        0 => x,
        _ if x == 0.0 => ulps as f64 * 1e-13,
        _ => x + (x * f64::EPSILON * ulps as f64),
    };
    if moved.is_finite() { moved } else { x }
}

/// A window and a segment, two times in three through a corner or along a side, or next to that.
pub(crate) fn window_and_segment() -> impl Strategy<Value = (Window, Segment)> {
    let how = (0u8..6, 0usize..4, -4i64..5, -4i64..5, 0.0..3.0f64);
    (window(), point(), point(), how).prop_map(|(window, a, b, (kind, k, i, j, t))| {
        let corner = window.corners()[k];
        let b = match kind {
            // From a through the corner and beyond.
            0 | 1 => {
                let b = corner + (corner - a) * t;
                DVec2::new(beside(b.x, i), beside(b.y, j))
            }
            // At the height of a side.
            2 => DVec2::new(b.x, beside(corner.y, i)),
            _ => b,
        };
        let a = match kind {
            2 => DVec2::new(a.x, beside(corner.y, j)),
            3 => DVec2::new(beside(corner.x, i), a.y),
            _ => a,
        };
        let b = if kind == 3 {
            DVec2::new(beside(corner.x, j), b.y)
        } else {
            b
        };
        let b = if b.is_finite() { b } else { corner };
        (window, Segment::new(a, b))
    })
}

/// Corners on a small grid that meets the sides of `small_window`, so that edges run along sides and through corners.
pub(crate) fn grid_polygon() -> impl Strategy<Value = Vec<DVec2>> {
    prop::collection::vec((-2i32..9, -2i32..9), 3..14).prop_map(|points| {
        points
            .into_iter()
            .map(|(x, y)| DVec2::new(x.into(), y.into()))
            .collect()
    })
}

pub(crate) fn small_window() -> Window {
    Window::new(DVec2::ZERO, DVec2::new(6.0, 5.0)).unwrap()
}

/// Grid polygons with some corners moved by a few ulps, or by anything.
pub(crate) fn polygon() -> impl Strategy<Value = Vec<DVec2>> {
    let moves = prop::collection::vec((0u8..8, -3i64..4, -3i64..4, point()), 14);
    (grid_polygon(), moves).prop_map(|(mut polygon, moves)| {
        for (p, (kind, i, j, q)) in polygon.iter_mut().zip(moves) {
            match kind {
                0..3 => *p = DVec2::new(beside(p.x, i), beside(p.y, j)),
                3 => *p = q,
                _ => {}
            }
        }
        polygon
    })
}

/// Points of `small_window`, some of them next to its sides.
pub(crate) fn samples() -> impl Iterator<Item = DVec2> {
    let along = |k: i32| match k % 4 {
        0 => f64::from(k / 4) + 1.0 / 101.0,
        1 => f64::from(k / 4) + 0.29,
        2 => f64::from(k / 4) + 0.63,
        _ => f64::from(k / 4) + 136.0 / 137.0,
    };
    (0..24).flat_map(move |i| (0..20).map(move |j| DVec2::new(along(i), along(j) + 1e-4)))
}

/// Sutherland–Hodgman without rounding: inside where sign (v − limit) ≥ 0, side after side, the first vertex last.
pub(crate) fn sutherland_hodgman(window: &Window, polygon: &[DVec2]) -> Vec<Point> {
    let mut points: Vec<Point> = polygon.iter().map(|&p| exact(p).unwrap()).collect();
    let sides = [
        (1, -1, r(window.max.y)),
        (1, 1, r(window.min.y)),
        (0, -1, r(window.max.x)),
        (0, 1, r(window.min.x)),
    ];
    for (axis, sign, limit) in sides {
        let side = |p: &Point| (&p[axis] - &limit) * Exact::from(sign);
        let mut kept = Vec::new();
        for (i, p) in points.iter().enumerate() {
            let next = &points[(i + 1) % points.len()];
            let (s, t) = (side(p), side(next));
            if s >= 0 {
                kept.push(p.clone());
            }
            if (s > 0 && t < 0) || (s < 0 && t > 0) {
                let share = s.over(&(&s - &t)).unwrap();
                kept.push([0, 1].map(|k| between(&share, &p[k], &next[k])));
            }
        }
        points = kept;
    }
    points
}

/// a + t (b − a).
pub(crate) fn at(t: &Exact, a: f64, b: f64) -> Exact {
    between(t, &r(a), &r(b))
}
