//! Outlines convex to the last bit as seen from the eye.
//!
//! New vertices are rounded. Two that lie next to each other, where three planes meet, make an edge of any direction at
//! all, and the plane through it and the eye may pass through the middle of the polygon; but comparing takes such
//! planes for its sides.

use core::cmp::Ordering;

use ombra_math::glam::{DVec3, DVec4};

use super::eye::Eye;

/// The outline without the vertices where it does not turn as it should, or not at all; empty if none are left, or
/// there is no eye.
pub(crate) fn convex(outline: Vec<DVec3>, eye: DVec4, turning: Ordering) -> Vec<DVec3> {
    Eye::new(eye).map_or_else(Vec::new, |eye| convex_from(outline, eye, turning))
}

/// [`convex`], from an eye that is one.
pub(super) fn convex_from(mut outline: Vec<DVec3>, eye: Eye, turning: Ordering) -> Vec<DVec3> {
    let is_wrong = |outline: &[DVec3], i: usize| {
        let n = outline.len();
        let at = |i: usize| outline.get(i % n).copied();
        let corner = at(i + n - 1).zip(at(i)).zip(at(i + 1));
        corner.is_some_and(|((a, b), c)| eye.turn(a, b, c) != Some(turning))
    };
    while let Some(wrong) = (0..outline.len()).find(|&i| is_wrong(&outline, i)) {
        outline.remove(wrong);
    }
    outline
}
