//! Each sight line meets one part, by brute force.

use super::*;

/// What a sight line meets.
pub(super) enum Hit {
    /// Nothing, by a margin.
    Missed,
    /// At this distance from where the line starts.
    At(f64),
    /// Too near an edge to tell.
    Unclear,
}

/// A brute-force hit of the line origin + t · direction, t > `from`.
pub(super) fn hit(polygon: &Polygon, origin: DVec3, direction: DVec3, from: f64) -> Hit {
    const MARGIN: f64 = 1e-9;
    let normal: DVec3 = {
        let v = &polygon.vertices;
        (1..v.len() - 1)
            .map(|i| (v[i] - v[0]).cross(v[i + 1] - v[0]))
            .sum()
    };
    let slope = normal.normalize_or_zero().dot(direction);
    if slope.abs() < MARGIN {
        return Hit::Unclear;
    }
    let centre = polygon.vertices.iter().sum::<DVec3>() / polygon.vertices.len() as f64;
    let t = normal.normalize().dot(centre - origin) / slope;
    let x = origin + t * direction;
    let n = polygon.vertices.len();
    let inside = (0..n).map(|i| {
        let (a, b) = (polygon.vertices[i], polygon.vertices[(i + 1) % n]);
        if a == b {
            return f64::INFINITY;
        }
        normal.normalize().cross((b - a).normalize()).dot(x - a)
    });
    let depth = inside.fold(f64::INFINITY, f64::min);
    if depth.abs() < MARGIN || (depth > 0.0 && (t - from).abs() < MARGIN) {
        Hit::Unclear
    } else if depth > 0.0 && t > from {
        Hit::At(t)
    } else {
        Hit::Missed
    }
}

/// The first polygon with the nearest hit; `None` where an edge is too near to tell.
fn nearest(scene: &[Polygon], origin: DVec3, direction: DVec3, from: f64) -> Option<Option<usize>> {
    let mut best: Option<(usize, f64)> = None;
    for (i, polygon) in scene.iter().enumerate() {
        match hit(polygon, origin, direction, from) {
            Hit::Unclear => return None,
            Hit::Missed => {}
            Hit::At(t) => match best {
                Some((_, least)) if t >= least - 1e-12 => {
                    if t - least > 1e-12 && t - least < 1e-9 {
                        return None;
                    }
                }
                Some((_, least)) if t > least - 1e-9 => return None,
                _ => best = Some((i, t)),
            },
        }
    }
    Some(best.map(|(i, _)| i))
}

/// Sight lines through the scene's polygons and beside them: each meets one part, of the polygon that is hit first.
fn check_sight_lines(
    scene: &[Polygon],
    eye: DVec4,
    lines: usize,
    numbers: &mut Numbers,
) -> [usize; 2] {
    let parts = visible_parts(scene, eye);
    for (source, part) in &parts {
        inside_its_source(part, &scene[*source]);
    }
    let (mut told, mut empty) = (0, 0);
    for line in 0..lines {
        let through = if line % 4 == 0 {
            numbers.vector() * 4.0 - 2.0
        } else {
            let p = &scene[line % scene.len()].vertices;
            let weights: Vec<_> = p.iter().map(|_| numbers.next()).collect();
            p.iter().zip(&weights).map(|(&v, &w)| v * w).sum::<DVec3>()
                / weights.iter().sum::<f64>()
        };
        let (direction, from) = if eye.w == 0.0 {
            (-eye.truncate().normalize(), f64::NEG_INFINITY)
        } else {
            ((through - eye.truncate()).normalize(), 0.0)
        };
        let origin = if eye.w == 0.0 {
            through
        } else {
            eye.truncate()
        };
        let Some(expected) = nearest(scene, origin, direction, from) else {
            continue;
        };
        let mut met = Vec::new();
        let mut clear = true;
        for (source, part) in &parts {
            match hit(part, origin, direction, from) {
                Hit::Unclear => clear = false,
                Hit::At(_) => met.push(*source),
                Hit::Missed => {}
            }
        }
        if clear {
            assert_eq!(
                met,
                Vec::from_iter(expected),
                "{scene:?} from {eye} through {through}"
            );
            told += 1;
            empty += usize::from(expected.is_none());
        }
    }
    [told, empty]
}

/// Corners of a part lie on its polygon's plane and inside its edges, within the rounding of their making.
pub(super) fn inside_its_source(part: &Polygon, source: &Polygon) {
    let plane = source.plane().unwrap();
    let normal = plane.normal.normalize();
    let n = source.vertices.len();
    let scale = source
        .vertices
        .iter()
        .map(|v| v.abs().max_element())
        .fold(0.0, f64::max);
    for v in &part.vertices {
        let off = plane.signed_distance(*v).abs();
        assert!(off <= 64.0 * f64::EPSILON * scale, "{off:e}");
        for i in 0..n {
            let (a, b) = (source.vertices[i], source.vertices[(i + 1) % n]);
            let inside = normal.cross((b - a).normalize()).dot(*v - a);
            assert!(inside >= -64.0 * f64::EPSILON * scale, "{inside:e}");
        }
    }
    assert!(part.plane().unwrap().normal.dot(normal) > 0.0);
    assert!(part.area() > 0.0);
    assert!(Polygon::new(part.vertices.clone()).is_ok(), "{part:?}");
}

#[test]
fn each_sight_line_meets_one_part() {
    let mut numbers = Numbers(362436069);
    let mut told = [0; 2];
    for round in 0..120 {
        let k = 2 + round % 15;
        let size = [0.3, 0.6, 0.9][round % 3];
        let scene: Vec<_> = (0..k).map(|_| numbers.polygon(size)).collect();
        // Far away, in the middle of it all, and parallel.
        let at = numbers.vector() * 2.0 - 1.0;
        let eye = [(at * 5.0).extend(1.0), at.extend(1.0), at.extend(0.0)][round % 7 % 3];
        let [a, b] = check_sight_lines(&scene, eye, 100, &mut numbers);
        told = [told[0] + a, told[1] + b];
    }
    assert!(told[0] > 11_000 && told[1] > 500, "{told:?}");
}

/// On a lattice corners, edges and planes meet, and polygons lie in one plane.
#[test]
fn each_sight_line_meets_one_part_where_much_touches() {
    let mut numbers = Numbers(521288629);
    let mut told = [0; 2];
    for round in 0..400 {
        let mut whole = || (numbers.vector() * 5.0).floor() - 2.0;
        let mut scene = Vec::new();
        while scene.len() < 2 + round % 9 {
            let [a, b, c] = [whole(), whole(), whole()];
            let vertices = if round % 2 == 0 {
                vec![a, b, c]
            } else {
                vec![a, b, c, a + c - b]
            };
            scene.extend(Polygon::new(vertices));
        }
        let eye = [
            (3.0 * whole()).extend(1.0),
            whole().extend(1.0),
            whole().extend(0.0),
        ][round % 3];
        if eye != DVec4::ZERO {
            let [a, b] = check_sight_lines(&scene, eye, 50, &mut numbers);
            told = [told[0] + a, told[1] + b];
        }
    }
    assert!(told[0] > 10_000 && told[1] > 500, "{told:?}");
}
