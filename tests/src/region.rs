//! Where a point lies against a convex polygon whose corners may be at infinity, and whether a polygon blocks
//! the light: by exact signs, with a stated slack for corners that were rounded.
//!
//! Points are homogeneous with w ≥ 0 and lie in one plane, so one coordinate can be dropped: what is left is
//! (u, v, w), and an edge's side is the sign of a 3 × 3 determinant.

use core::cmp::Ordering;

use ombra_math::glam::{DVec3, DVec4};
use ombra_oracle::Exact;
use ombra_oracle::vector::{abs, cross, dot, exact, minus};

/// A homogeneous point without rounding.
pub type Point = [Exact; 4];

/// Where a point lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Location {
    /// Inside by more than the slack.
    Inside,
    /// On the border, or too near to say.
    Border,
    /// Outside by more than the slack.
    Outside,
}

/// The corners' relative error that is forgiven: 2⁻⁴⁵ is some hundred roundings, and five digits below
/// anything that a wrong sign or a missing cut moves.
const SLACK: i64 = -45;

/// The sum of `points` times whole `weights`: inside their hull where no weight is negative.
#[must_use]
pub fn combine(points: &[Point], weights: &[i32]) -> Point {
    let terms = || points.iter().zip(weights);
    core::array::from_fn(|k| {
        terms()
            .map(|(p, &weight)| &p[k] * Exact::from(weight))
            .sum()
    })
}

/// Where `p` (w > 0) lies against the convex polygon with these `corners`, in a plane of the given `normal`.
#[must_use]
pub fn locate(corners: &[Point], normal: DVec3, p: &Point) -> Location {
    if corners.len() < 3 {
        return Location::Outside;
    }
    let keep = kept_coordinates(normal);
    let flat = |p: &Point| keep.map(|k| p[k].clone());
    let p = flat(p);
    let corners: Vec<[Exact; 3]> = corners.iter().map(flat).collect();
    let (mut left, mut right, mut near) = (false, false, false);
    let next = corners.iter().cycle().skip(1);
    for (a, b) in corners.iter().zip(next) {
        if a == b {
            continue;
        }
        match side(a, b, &p) {
            Ordering::Less => right = true,
            Ordering::Equal => near = true,
            Ordering::Greater => left = true,
        }
    }
    if left && right {
        Location::Outside
    } else if near || left == right {
        Location::Border
    } else {
        Location::Inside
    }
}

/// Where the line from `p` to the homogeneous `light` passes the convex `caster`: inside if the caster blocks
/// the light, outside if it misses the caster or meets its plane behind `p` or beyond the light.
#[must_use]
pub fn blocked(p: &Point, light: DVec4, caster: &[DVec3]) -> Option<Location> {
    let light = if light.w < 0.0 { -light } else { light };
    let light = exact(light)?;
    let corners: Vec<Point> = caster
        .iter()
        .map(|v| exact(v.extend(1.0)))
        .collect::<Option<_>>()?;
    let [a, b, c, ..] = corners.as_slice() else {
        return Some(Location::Outside);
    };
    let plane = plane_through(a, b, c);
    let (at_light, at_light_size) = incidence(&plane, &light);
    let (at_p, at_p_size) = incidence(&plane, p);

    // The line p + k L meets the caster's plane at (C·L) p − (C·p) L: between the two where the signs differ.
    let signs = (
        sign_beyond(&at_light, &at_light_size),
        sign_beyond(&at_p, &at_p_size),
    );
    match signs {
        (Ordering::Equal, _) | (_, Ordering::Equal) => return Some(Location::Border),
        (l, p) if l == p => return Some(Location::Outside),
        _ => {}
    }
    let turned = signs.0 == Ordering::Less;
    let hit: Point = core::array::from_fn(|k| {
        let x = &at_light * &p[k] - &at_p * &light[k];
        if turned { -x } else { x }
    });
    let [x, y, z, _] = abs(&plane);
    let largest = x.max(y).max(z);
    let normal = DVec3::from_array(core::array::from_fn(|k| {
        // Only the largest matters, so a rounded quotient will do.
        plane[k].ratio(&largest)
    }));
    Some(locate(&corners, normal, &hit))
}

/// Whether the homogeneous `light` is so nearly in the plane of a flat `polygon` that the polygon casts, or
/// catches, no more than a line: within 2⁻³⁰ of the terms that decide. Also true where there is no such plane.
#[must_use]
pub fn edge_on(polygon: &[DVec3], light: DVec4) -> bool {
    let corners: Option<Vec<Point>> = polygon.iter().map(|v| exact(v.extend(1.0))).collect();
    let (Some(corners), Some(light)) = (corners, exact(light)) else {
        return true;
    };
    let [a, b, c, ..] = corners.as_slice() else {
        return true;
    };
    let (at_light, size) = incidence(&plane_through(a, b, c), &light);
    at_light.abs() <= size.scaled(-30)
}

/// The plane through three places, as coefficients.
fn plane_through(a: &Point, b: &Point, c: &Point) -> Point {
    let place = |[x, y, z, _]: &Point| [x, y, z].map(Exact::clone);
    let a = place(a);
    let n = cross(&minus(&place(b), &a), &minus(&place(c), &a));
    let offset = -dot(&n, &a);
    let [x, y, z] = n;
    [x, y, z, offset]
}

/// π·P, and the sum of the absolute values of its products.
fn incidence(plane: &Point, p: &Point) -> (Exact, Exact) {
    (dot(plane, p), dot(&abs(plane), &abs(p)))
}

/// The two coordinates that are kept beside w: all but the one in which the plane is steepest.
fn kept_coordinates(normal: DVec3) -> [usize; 3] {
    let n = normal.abs();
    if n.x >= n.y && n.x >= n.z {
        [1, 2, 3]
    } else if n.y >= n.z {
        [2, 0, 3]
    } else {
        [0, 1, 3]
    }
}

/// The side of the directed line ab on which p lies; equal within the slack.
fn side(a: &[Exact; 3], b: &[Exact; 3], p: &[Exact; 3]) -> Ordering {
    let (mut det, mut size) = (Exact::ZERO, Exact::ZERO);
    for [i, j, k] in [[0, 1, 2], [1, 2, 0], [2, 0, 1]] {
        let (plus, minus) = (&a[i] * &b[j] * &p[k], &a[j] * &b[i] * &p[k]);
        size += plus.abs() + minus.abs();
        det += plus - minus;
    }
    sign_beyond(&det, &size)
}

/// The sign of `x`, or equal where it is within the slack of the terms it was summed from.
fn sign_beyond(x: &Exact, size: &Exact) -> Ordering {
    if x.abs() > size.scaled(SLACK) {
        x.sign()
    } else {
        Ordering::Equal
    }
}

#[cfg(test)]
mod tests {
    use super::{Location, blocked, combine, edge_on, locate};
    use ombra_math::glam::{DVec3, DVec4};
    use ombra_oracle::vector::exact;

    fn at(x: f64, z: f64) -> DVec4 {
        DVec4::new(x, 0.0, z, 1.0)
    }

    // A square, and the quarter plane x ≥ 1, z ≥ 1 as a triangle with two corners at infinity.
    #[test]
    fn places_and_corners_at_infinity() {
        let inside = |polygon: &[DVec4], p: DVec4| {
            let polygon: Vec<_> = polygon.iter().map(|&q| exact(q).unwrap()).collect();
            locate(&polygon, DVec3::Y, &exact(p).unwrap())
        };
        let square = [at(0.0, 0.0), at(1.0, 0.0), at(1.0, 1.0), at(0.0, 1.0)];
        let quarter = [
            at(1.0, 1.0),
            DVec4::new(1.0, 0.0, 0.0, 0.0),
            DVec4::new(0.0, 0.0, 1.0, 0.0),
        ];
        for turned in [false, true] {
            let turn = |polygon: &[DVec4]| {
                let mut polygon = polygon.to_vec();
                if turned {
                    polygon.reverse();
                }
                polygon
            };
            let (square, quarter) = (turn(&square), turn(&quarter));
            assert_eq!(inside(&square, at(0.25, 0.5)), Location::Inside);
            assert_eq!(inside(&square, at(1.0, 0.5)), Location::Border);
            assert_eq!(inside(&square, at(1.25, 0.5)), Location::Outside);
            assert_eq!(inside(&square, at(-3.0, -3.0)), Location::Outside);
            assert_eq!(inside(&quarter, at(1e9, 2.0)), Location::Inside);
            assert_eq!(inside(&quarter, at(1e9, 0.0)), Location::Outside);
            // The mirror image through the corner satisfies every edge with the other sign, except at infinity.
            assert_eq!(inside(&quarter, at(-1e9, -2.0)), Location::Outside);
        }
    }

    #[test]
    fn blocks_only_between_point_and_light() {
        let caster = [
            DVec3::new(-1.0, 5.0, -1.0),
            DVec3::new(1.0, 5.0, -1.0),
            DVec3::new(0.0, 5.0, 1.0),
        ];
        let from = |y: f64, light: DVec4| {
            blocked(
                &exact(DVec4::new(0.0, y, 0.0, 1.0)).unwrap(),
                light,
                &caster,
            )
        };
        let above = DVec4::new(0.0, 10.0, 0.0, 1.0);
        let sky = DVec4::new(0.0, 1.0, 0.0, 0.0);
        assert_eq!(from(0.0, above), Some(Location::Inside));
        assert_eq!(from(0.0, -above), Some(Location::Inside));
        assert_eq!(from(6.0, above), Some(Location::Outside));
        assert_eq!(
            from(0.0, DVec4::new(0.0, 4.0, 0.0, 1.0)),
            Some(Location::Outside)
        );
        assert_eq!(from(0.0, sky), Some(Location::Inside));
        assert_eq!(from(0.0, -sky), Some(Location::Outside));
        assert_eq!(
            from(0.0, DVec4::new(9.0, 10.0, 0.0, 1.0)),
            Some(Location::Outside)
        );
        assert_eq!(from(5.0, sky), Some(Location::Border));
    }

    #[test]
    fn edges_towards_the_light() {
        let wall = [DVec3::ZERO, DVec3::Y, DVec3::Z];
        assert!(edge_on(&wall, DVec4::new(0.0, 3.0, 4.0, 1.0)));
        assert!(edge_on(&wall, DVec4::new(0.0, 3.0, 4.0, 0.0)));
        assert!(!edge_on(&wall, DVec4::new(1e-6, 3.0, 4.0, 1.0)));
        assert!(edge_on(&[DVec3::ZERO, DVec3::Y, -DVec3::Y], DVec4::X));
        assert!(edge_on(&wall[..2], DVec4::X));
    }

    #[test]
    fn combinations() {
        let [a, b] = [at(0.0, 0.0), at(4.0, 8.0)].map(|p| exact(p).unwrap());
        let sum = combine(&[a, b], &[3, 1]);
        let expected = exact(DVec4::new(4.0, 0.0, 8.0, 4.0)).unwrap();
        assert_eq!(sum, expected);
    }
}
