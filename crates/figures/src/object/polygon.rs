//! Faces cut into triangles, ear by ear.
//!
//! A face is cut as it appears along the normal of its best plane (Newell's). Every ear (a, b, c) turns left, so the
//! triangles' areas add up to the face's: what a slit leaves open stays open, and nothing is covered twice. Every
//! corner of the face stays a corner of its triangles, also one in the middle of a side: neighbours share it.

mod boxes;
mod ears;

use ombra_math::glam::{DVec2, DVec3};

/// The triangles of the face with these corners, n − 2 of them, less those that name a corner twice. `steps` counts
/// the tests.
///
/// A face that crosses itself, or has no area, gets as many triangles with the same border; which, is not said.
pub(super) fn triangles(corners: &[u32], positions: &[DVec3], steps: &mut u64) -> Vec<[u32; 3]> {
    let named =
        |[a, b, c]: [usize; 3]| Some([*corners.get(a)?, *corners.get(b)?, *corners.get(c)?]);
    let place = |i: &u32| positions.get(*i as usize).copied().unwrap_or_default();
    let cut = match corners.len() {
        0..=2 => Vec::new(),
        3 => vec![[0, 1, 2]],
        _ => {
            let places: Vec<DVec3> = corners.iter().map(place).collect();
            ears::cut(&flat(&places), steps)
        }
    };
    let distinct = |[a, b, c]: &[u32; 3]| a != b && b != c && c != a;
    cut.into_iter().filter_map(named).filter(distinct).collect()
}

/// The corners along the normal of their best plane, running counter-clockwise.
fn flat(places: &[DVec3]) -> Vec<DVec2> {
    let origin = places.first().copied().unwrap_or_default();
    let next = places.iter().cycle().skip(1);
    let normal: DVec3 = places
        .iter()
        .zip(next)
        .map(|(&p, &q)| (p - origin).cross(q - origin))
        .sum();
    let normal = normal.normalize_or(DVec3::Z);
    let size = places.iter().map(|p| p.abs().max_element());
    let size = size.fold(0.0, f64::max);
    // Rounding of coordinates of this size: in a face flat but for that, no coordinate is touched, so that corners
    // in one line stay so.
    let rounding = 16.0 * f64::EPSILON * size;
    let is_flat = places
        .iter()
        .all(|&p| normal.dot(p - origin).abs() <= rounding);

    let k = normal.abs().max_position();
    let [n, along, across] = [normal[k], normal[(k + 1) % 3], normal[(k + 2) % 3]];
    let project = |p: &DVec3| {
        let (x, y, depth) = (p[(k + 1) % 3], p[(k + 2) % 3], p[k] - origin[k]);
        let seen = match is_flat {
            true => DVec2::new(x, y),
            // Where the line through p along the normal meets the plane of two axes.
            false => DVec2::new(x - depth * (along / n), y - depth * (across / n)),
        };
        if n < 0.0 {
            DVec2::new(seen.y, seen.x)
        } else {
            seen
        }
    };
    places.iter().map(project).collect()
}

#[cfg(test)]
mod tests;
