//! Sheets at one depth within the tolerance, which no order by pairs fits: none may be lost, none seen twice.

use super::sight_lines::{Hit, hit};
use super::*;
use crate::pair::tolerance;

/// The distance up to which planes of these scenes count as equally deep: coordinates reach 4.
fn delta() -> f64 {
    tolerance(4.0)
}

/// The areas of what is seen from above, of each source.
fn seen_from_above(scene: &[Polygon]) -> Vec<f64> {
    let parts = visible_parts(scene, DVec4::Z);
    let flat = |p: &Polygon| {
        let vertices = p.vertices.iter().map(|v| v.with_z(0.0)).collect();
        Polygon { vertices }.area()
    };
    let of = |source: usize| {
        let own = parts.iter().filter(move |(i, _)| *i == source);
        own.map(|(_, part)| flat(part)).sum()
    };
    (0..scene.len()).map(of).collect()
}

/// Of three sheets each lies within the tolerance of the next, the last one nearer than the first by more.
#[test]
fn three_sheets_in_a_ring() {
    let sheet = |x: f64, y: f64, height: f64| square(x, y, height * delta(), 4.0);
    let [a, b, c] = [0.0, 0.6, 1.2].map(|height| sheet(-2.0, -2.0, height));
    // The first two tie, so the first is seen; the third is nearer than it.
    assert_eq!(visible_parts(&[a, b, c.clone()], DVec4::Z), [(2, c)]);
    // Side by side in part: [−2, 2]², [−1, 3]² and [0, 4] × [−2, 2].
    let scene = [
        sheet(-2.0, -2.0, 0.0),
        sheet(-1.0, -1.0, 0.6),
        sheet(0.0, -2.0, 1.2),
    ];
    let areas = seen_from_above(&scene);
    // The first keeps what the third leaves of it. Of the second, 16 − 9 is not under the first, and there it is
    // seen before the third.
    for (area, expected) in areas.iter().zip([8.0, 7.0, 13.0]) {
        close(*area, expected, 16.0);
    }
}

fn ground() -> Polygon {
    square(-5.0, -5.0, -4.0, 10.0)
}

/// Sheets up to a few tolerances apart, level or tilted as little, over a ground.
fn stack(numbers: &mut Numbers, sheets: usize) -> Vec<Polygon> {
    let mut scene = vec![ground()];
    for _ in 0..sheets {
        let mut at = || 3.0 * numbers.next();
        let [x, y, z] = [at() - 1.5, at() - 1.5, at()];
        let [w, d] = [0.5 + at(), 0.5 + at()];
        let slope = if at() < 1.5 { 0.0 } else { at() - 1.5 };
        let turn = at();
        let (s, c) = (libm::sin(turn), libm::cos(turn));
        // Its middle at most 2.2 from that of the ground, its corners 2.5 from there.
        let corners = [[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], [-0.5, 0.5]].map(|[i, j]| {
            let [i, j] = [w * i, d * j];
            DVec3::new(
                x + c * i - s * j,
                y + s * i + c * j,
                (z + slope * i) * delta(),
            )
        });
        let vertices = corners.to_vec();
        let at = (numbers.next() * (scene.len() + 1) as f64) as usize;
        scene.insert(at, Polygon { vertices });
    }
    scene
}

/// What is seen from above makes up the ground, once.
#[test]
fn near_ties_leave_no_hole() {
    let mut numbers = Numbers(1_234_567_891);
    for round in 0..300 {
        let scene = stack(&mut numbers, 2 + round % 9);
        let parts = visible_parts(&scene, DVec4::Z).len();
        let sum: f64 = seen_from_above(&scene).iter().sum();
        // All corners within a few ε of where they belong, along all edges.
        let tolerance = 64.0 * f64::EPSILON * 10.0 * parts as f64;
        assert!(
            (sum - 100.0).abs() <= tolerance,
            "{round}: {:e}",
            sum - 100.0
        );
    }
}

/// From a place as well: each sight line meets one part.
#[test]
fn near_ties_from_a_place() {
    let mut numbers = Numbers(987_654_321);
    let mut told = 0;
    for round in 0..60 {
        let scene = stack(&mut numbers, 3 + round % 6);
        let eye = DVec3::new(
            numbers.next() - 0.5,
            numbers.next() - 0.5,
            2.0 + numbers.next(),
        );
        let parts = visible_parts(&scene, eye.extend(1.0));
        for _ in 0..100 {
            let through = DVec3::new(numbers.next() * 7.0 - 3.5, numbers.next() * 7.0 - 3.5, 0.0);
            let direction = (through - eye).normalize();
            let (mut met, mut clear) = (0, true);
            for (_, part) in &parts {
                match hit(part, eye, direction, 0.0) {
                    Hit::Unclear => clear = false,
                    Hit::At(_) => met += 1,
                    Hit::Missed => {}
                }
            }
            // Under everything lies the ground, seen or not as far as it reaches.
            let on_ground = hit(&ground(), eye, direction, 0.0);
            if clear && matches!(on_ground, Hit::At(_)) {
                assert_eq!(met, 1, "{round}: {through}");
                told += 1;
            }
        }
    }
    assert!(told > 1000, "{told}");
}

/// A sliver no higher than the tolerance lies within it of two walls that cross there; it ties nothing but itself.
#[test]
fn a_sliver_ties_no_others() {
    let low = square(-2.0, -2.0, 0.0, 4.0);
    let steep = polygon([
        [0.0, -1.0, 0.0],
        [2.0, -1.0, 2.0],
        [2.0, 1.0, 2.0],
        [0.0, 1.0, 0.0],
    ]);
    let sliver = |x: f64| {
        let h = 0.5 * delta();
        polygon([[x - h, -0.5, -h], [x + h, -0.5, h], [x, 0.5, h]])
    };
    for scene in [
        [low.clone(), sliver(0.0), steep.clone()],
        [steep.clone(), sliver(0.0), low.clone()],
        [sliver(0.0), low.clone(), steep.clone()],
    ] {
        let areas = seen_from_above(&scene);
        let at = |p: &Polygon| scene.iter().position(|q| q == p).unwrap();
        close(areas[at(&steep)], 4.0, 16.0);
        close(areas[at(&low)], 12.0, 16.0);
    }
}
