//! Outlines of pieces, convex to the last bit as seen from the eye.
//!
//! New vertices are rounded. Two that lie next to each other, where three planes meet, make an edge of any direction at all,
//! and the plane through it and the eye may pass through the middle of the piece; but comparing takes such planes for
//! its sides.

use core::cmp::Ordering;

use ombra_math::exact::Sum;
use ombra_math::glam::{DVec3, DVec4};
use ombra_math::homogeneous::project;
use ombra_math::predicates::orient_3d;

/// The outline without the vertices where it does not turn as it should, or not at all; empty if none are left.
pub(super) fn convex(mut outline: Vec<DVec3>, eye: DVec4, turning: Ordering) -> Vec<DVec3> {
    let is_wrong = |outline: &[DVec3], i: usize| {
        let n = outline.len();
        let at = |i: usize| outline.get(i % n).copied();
        let corner = at(i + n - 1).zip(at(i)).zip(at(i + 1));
        corner.is_some_and(|((a, b), c)| turn(a, b, c, eye) != Some(turning))
    };
    while let Some(wrong) = (0..outline.len()).find(|&i| is_wrong(&outline, i)) {
        outline.remove(wrong);
    }
    outline
}

/// How a b c turn as seen from the eye, exactly: `Greater` counter-clockwise.
fn turn(a: DVec3, b: DVec3, c: DVec3, eye: DVec4) -> Option<Ordering> {
    if eye.w != 0.0 {
        return orient_3d(a, b, c, project(eye)?);
    }
    // (AB × AC)·e, multiplied out.
    let minor = |p: DVec3, q: DVec3| {
        [(0, 1, 2), (1, 2, 0), (2, 0, 1)]
            .map(|(i, j, k)| [[p[i], q[j], eye[k]], [-p[j], q[i], eye[k]]])
            .concat()
    };
    Sum::of(&[minor(a, b), minor(b, c), minor(c, a)].concat()).sign()
}
