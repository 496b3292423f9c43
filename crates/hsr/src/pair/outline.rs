//! Outlines convex to the last bit as seen from the eye.
//!
//! New vertices are rounded. Two that lie next to each other, where three planes meet, make an edge of any direction at
//! all, and the plane through it and the eye may pass through the middle of the polygon; but comparing takes such
//! planes for its sides.

use core::cmp::Ordering;
use std::collections::VecDeque;

use ombra_math::glam::{DVec3, DVec4};

use super::eye::Eye;

/// The outline without the vertices where it does not turn as it should, or not at all; empty if none are left, or
/// there is no eye.
pub(crate) fn convex(outline: Vec<DVec3>, eye: DVec4, turning: Ordering) -> Vec<DVec3> {
    Eye::new(eye).map_or_else(Vec::new, |eye| convex_from(outline, eye, turning))
}

/// [`convex`], from an eye that is one.
pub(super) fn convex_from(outline: Vec<DVec3>, eye: Eye, turning: Ordering) -> Vec<DVec3> {
    let is_wrong = |[a, b, c]: [DVec3; 3]| eye.turn(a, b, c) != Some(turning);
    // Along the outline, going back over what a new vertex shows to be wrong.
    let mut kept: VecDeque<DVec3> = VecDeque::with_capacity(outline.len());
    for c in outline {
        while let Some([a, b]) = last_two(&kept)
            && is_wrong([a, b, c])
        {
            kept.pop_back();
        }
        kept.push_back(c);
    }
    // Where it closes, from both ends.
    while let (Some([a, b]), Some(&c), Some(&d)) = (last_two(&kept), kept.front(), kept.get(1)) {
        if is_wrong([a, b, c]) {
            kept.pop_back();
        } else if is_wrong([b, c, d]) {
            kept.pop_front();
        } else {
            break;
        }
    }
    kept.into()
}

fn last_two(kept: &VecDeque<DVec3>) -> Option<[DVec3; 2]> {
    let (a, b) = (kept.len().checked_sub(2)?, kept.len().checked_sub(1)?);
    Some([*kept.get(a)?, *kept.get(b)?])
}
