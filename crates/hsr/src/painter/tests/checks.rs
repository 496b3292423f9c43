//! Whether an order is back to front, and pieces make up their primitives.

use proptest::prelude::*;

use super::scenes::{Meeting, area, meeting};
use super::*;

pub(super) fn hides(scene: &[Polygon], front: usize, back: usize, eye: DVec4) -> bool {
    let first = front.min(back);
    match compare(&scene[first], &scene[front.max(back)], eye) {
        Pair::Apart => false,
        Pair::Crossing => true,
        Pair::FirstNearer | Pair::Coplanar => front == first,
        Pair::SecondNearer => back == first,
    }
}

pub(super) fn is_back_to_front(order: &[usize], pairs: &[[usize; 2]]) -> bool {
    let place = |i: usize| order.iter().position(|&p| p == i);
    pairs
        .iter()
        .all(|&[front, back]| place(back) < place(front))
}

/// Whether any permutation of what is left, put after `painted`, is back to front.
pub(super) fn some_order(painted: &mut Vec<usize>, k: usize, pairs: &[[usize; 2]]) -> bool {
    if painted.len() == k {
        return is_back_to_front(painted, pairs);
    }
    (0..k).any(|i| {
        if painted.contains(&i) {
            return false;
        }
        painted.push(i);
        let found = some_order(painted, k, pairs);
        painted.pop();
        found
    })
}

/// The pieces are convex, keep to their primitive's plane and outline, and their areas add up.
pub(super) fn check_pieces(
    scene: &[Polygon],
    pieces: &[(usize, Polygon)],
) -> Result<(), TestCaseError> {
    for (i, whole) in scene.iter().enumerate() {
        let of_it = || {
            pieces
                .iter()
                .filter(|(source, _)| *source == i)
                .map(|(_, p)| p)
        };
        let expected = area(whole);
        let found: DVec3 = of_it().map(area).sum();
        // A few roundings a vertex of coordinates up to 16, times the length of an edge up to 16.
        let tolerance = 1e3 * f64::EPSILON * 256.0;
        prop_assert!(
            (found - expected).length() <= tolerance,
            "{i}: {found} {expected}"
        );
        let Some(normal) = expected.try_normalize() else {
            continue;
        };
        for piece in of_it() {
            let v = &piece.vertices;
            for j in 0..v.len() {
                let (a, b, c) = (v[j], v[(j + 1) % v.len()], v[(j + 2) % v.len()]);
                prop_assert!((b - a).cross(c - b).dot(normal) >= -tolerance, "{i}: {v:?}");
                prop_assert!(normal.dot(a - whole.vertices[0]).abs() <= tolerance);
            }
        }
    }
    Ok(())
}

/// Along a sight line, what is painted last is what is nearest.
pub(super) fn check_sight(
    scene: &[Polygon],
    pieces: &[(usize, Polygon)],
    eye: DVec4,
    target: DVec3,
) -> Result<(), TestCaseError> {
    let mut met = Vec::new();
    for (i, primitive) in scene.iter().enumerate() {
        match meeting(primitive, eye, target) {
            Meeting::Beside => {}
            Meeting::At(t) => met.push((t, i)),
            Meeting::Unclear => return Ok(()),
        }
    }
    met.sort_by(|a, b| a.partial_cmp(b).unwrap());
    let last = pieces
        .iter()
        .rev()
        .find_map(|(source, piece)| match meeting(piece, eye, target) {
            Meeting::Beside => None,
            Meeting::At(_) => Some(Some(*source)),
            Meeting::Unclear => Some(None),
        });
    match (met.as_slice(), last) {
        ([], last) => prop_assert_eq!(last, None),
        // The border between two pieces.
        (_, Some(None)) => {}
        ([(t, _), (u, _), ..], _) if u - t < 1e-6 => {}
        ([(_, nearest), ..], last) => prop_assert_eq!(last, Some(Some(*nearest)), "{:?}", met),
    }
    Ok(())
}
