//! The eye, and how three points turn as seen from it.

use core::cmp::Ordering;

use ombra_math::double_double::{DoubleDouble, UNIT_ROUNDOFF};
use ombra_math::exact::{Sum, relative};
use ombra_math::glam::{BVec3, DVec3, DVec4};
use ombra_math::homogeneous::project;
use ombra_math::plane::Plane;
use ombra_math::predicates::orient_3d;

/// Where from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Eye {
    /// At a place.
    Place(DVec3),
    /// In this direction, infinitely far.
    Towards(DVec3),
}

impl Eye {
    /// `None` for the zero vector and for numbers that are not finite.
    pub(crate) fn new(eye: DVec4) -> Option<Self> {
        if eye.w != 0.0 {
            return project(eye).map(Self::Place);
        }
        let towards = eye.truncate();
        (towards.is_finite() && towards != DVec3::ZERO).then_some(Self::Towards(towards))
    }

    /// How a b c turn as seen: `Greater` counter-clockwise, `Equal` in line or all on one plane with the eye. Exact;
    /// `None` if a coordinate is not finite.
    ///
    /// ```text
    /// sign of (AB × AC)·AE,   from a direction e   of (AB × AC)·e
    /// ```
    pub(crate) fn turn(self, a: DVec3, b: DVec3, c: DVec3) -> Option<Ordering> {
        match self {
            Self::Place(place) => orient_3d(a, b, c, place),
            Self::Towards(towards) => turn_along(a, b, c, towards),
        }
    }

    /// Whether two points are in line with the eye, where that is plain: they are one, or differ along the axis that
    /// this is a view along.
    pub(super) fn sees_as_one(self, a: DVec3, b: DVec3) -> bool {
        let across = match self {
            Self::Towards(towards) if is_along_axis(towards) => towards.cmpeq(DVec3::ZERO),
            _ => BVec3::TRUE,
        };
        (a.cmpeq(b) | !across).all()
    }

    /// The plane through two points and the eye, in front of it what turns left: `None` where they are in line with
    /// the eye.
    pub(super) fn plane_through(self, a: DVec3, b: DVec3) -> Option<Plane> {
        match self {
            Self::Place(place) => Plane::of_triangle(a, b, place).map(|plane| plane.turned()),
            Self::Towards(towards) => plane_along(a, b, towards).map(|plane| plane.turned()),
        }
    }

    /// The plane of the eye and the line in which two planes cross: π(E) ρ − ρ(E) π, each coefficient rounded once.
    pub(super) fn plane_of_pencil(self, pi: Plane, rho: Plane) -> Option<Plane> {
        let eye = match self {
            Self::Place(place) => place.extend(1.0),
            Self::Towards(towards) => towards.extend(0.0),
        };
        let (pi, rho) = (pi.coefficients(), rho.coefficients());
        let minor = |i: usize, j: usize| {
            let factor = eye[j];
            [[pi[j], factor, rho[i]], [-rho[j], factor, pi[i]]]
        };
        let coefficient = |i: usize| Sum::of(&[0, 1, 2, 3].map(|j| minor(i, j)).concat());
        plane_of([0, 1, 2, 3].map(coefficient))
    }
}

fn is_along_axis(v: DVec3) -> bool {
    v.cmpeq(DVec3::ZERO).bitmask().count_ones() == 2
}

/// The sign of (AB × AC)·e.
fn turn_along(a: DVec3, b: DVec3, c: DVec3, e: DVec3) -> Option<Ordering> {
    let in_range = |p: DVec3| p.to_array().into_iter().all(DoubleDouble::in_range);
    if [a, b, c, e].into_iter().all(in_range) {
        let (u, v) = (b - a, c - a);
        let products = |i: usize, j: usize| (u[i] * v[j], u[j] * v[i]);
        let (mut sum, mut size) = (0.0, 0.0);
        for (i, j, k) in [(1, 2, 0), (2, 0, 1), (0, 1, 2)] {
            let (x, y) = products(i, j);
            sum += (x - y) * e[k];
            size += (x.abs() + y.abs()) * e[k].abs();
        }
        // Seven roundings at most on the way of each of the six products: differences, products, sums.
        if sum.abs() > 16.0 * UNIT_ROUNDOFF * size {
            return sum.partial_cmp(&0.0);
        }
    }
    let minor = |p: DVec3, q: DVec3| {
        [(0, 1, 2), (1, 2, 0), (2, 0, 1)]
            .map(|(i, j, k)| [[p[i], q[j], e[k]], [-p[j], q[i], e[k]]])
            .concat()
    };
    Sum::of(&[minor(a, b), minor(b, c), minor(c, a)].concat()).sign()
}

/// The plane through A and B along e: n = AB × e, d = −n·A = −(A × B)·e … each coefficient rounded once.
fn plane_along(a: DVec3, b: DVec3, e: DVec3) -> Option<Plane> {
    let component = |i: usize, j: usize| {
        let [u, v] = [(i, j, 1.0), (j, i, -1.0)];
        let minor = |(i, j, sign): (usize, usize, f64)| {
            [[sign * b[i], e[j], 1.0], [-sign * a[i], e[j], 1.0]]
        };
        Sum::of(&[minor(u), minor(v)].concat())
    };
    // −(AB × e)·A = −(B × e)·A = (A × e)·B … the determinant of A, B, e with its sign turned.
    let determinant = [(0, 1, 2), (1, 2, 0), (2, 0, 1)]
        .map(|(i, j, k)| [[-a[i], b[j], e[k]], [a[j], b[i], e[k]]])
        .concat();
    plane_of([
        component(1, 2),
        component(2, 0),
        component(0, 1),
        Sum::of(&determinant),
    ])
}

/// The plane of these coefficients, each rounded once; `None` for no plane.
fn plane_of(coefficients: [Sum; 4]) -> Option<Plane> {
    let scaled = coefficients.each_ref().map(Sum::to_scaled);
    let plane = match *relative(&scaled) {
        [x, y, z, d] => Plane {
            normal: DVec3::new(x, y, z),
            d,
        },
        _ => return None,
    };
    (plane.normal.is_finite() && plane.d.is_finite() && plane.normal != DVec3::ZERO)
        .then_some(plane)
}
