//! The contour of many triangles that share corners.

use std::collections::BTreeMap;

/// Closed contours that wind around every point as often as `triangles` do together: edges that two of them share in
/// opposite directions cancel. Corners are indices; turn the triangles to one winding before.
pub fn contours(triangles: impl Iterator<Item = [u32; 3]>) -> Vec<Vec<u32>> {
    // From each corner, how often an edge to each other one is left.
    let mut edges: BTreeMap<u32, BTreeMap<u32, u32>> = BTreeMap::new();
    for [i, j, k] in triangles {
        for (from, to) in [(i, j), (j, k), (k, i)] {
            if from == to {
                continue;
            }
            if !take(&mut edges, to, from) {
                *edges.entry(from).or_default().entry(to).or_default() += 1;
            }
        }
    }

    // As many edges lead to a corner as leave it, so every walk comes back to its start.
    let mut contours = Vec::new();
    while let Some((&start, _)) = edges.first_key_value() {
        let mut contour = vec![start];
        let mut at = start;
        while let Some(&next) = edges.get(&at).and_then(|ends| ends.keys().next()) {
            take(&mut edges, at, next);
            at = next;
            if at == start {
                break;
            }
            contour.push(at);
        }
        contours.push(contour);
    }
    contours
}

/// Removes one edge; whether there was one.
fn take(edges: &mut BTreeMap<u32, BTreeMap<u32, u32>>, from: u32, to: u32) -> bool {
    let Some(ends) = edges.get_mut(&from) else {
        return false;
    };
    let Some(count) = ends.get_mut(&to) else {
        return false;
    };
    *count -= 1;
    if *count == 0 {
        ends.remove(&to);
    }
    if ends.is_empty() {
        edges.remove(&from);
    }
    true
}

#[cfg(test)]
mod tests {
    use super::*;
    use ombra_math::solids;

    fn of(triangles: &[[u32; 3]]) -> Vec<Vec<u32>> {
        contours(triangles.iter().copied())
    }

    #[test]
    fn a_square_of_two_triangles_loses_its_diagonal() {
        assert_eq!(of(&[[0, 1, 2], [0, 2, 3]]), [[0, 1, 2, 3]]);
    }

    #[test]
    fn a_closed_mesh_has_no_contour_and_one_side_of_it_has_one() {
        let sphere = solids::sphere(1.0, 24, 12).unwrap();
        assert!(of(&sphere.triangles).is_empty());
        let upper: Vec<[u32; 3]> = (0..sphere.triangles.len())
            .filter(|&i| {
                let [a, b, c] = sphere.triangle(i).unwrap();
                a.y + b.y + c.y > 0.0
            })
            .map(|i| sphere.triangles[i])
            .collect();
        let contours = of(&upper);
        assert_eq!(contours.len(), 1);
        assert_eq!(contours[0].len(), 24);
    }

    #[test]
    fn what_lies_double_counts_double() {
        let twice = of(&[[0, 1, 2], [0, 1, 2]]);
        assert_eq!(twice.iter().map(Vec::len).sum::<usize>(), 6);
        assert!(of(&[[0, 1, 2], [2, 1, 0]]).is_empty());
        assert!(of(&[[4, 4, 4]]).is_empty());
    }
}
