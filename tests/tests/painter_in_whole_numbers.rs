//! Pairs of primitives and the painter's orders in scenes with whole-number corners, against integer arithmetic.
//!
//! Two primitives are related by cutting the one down to what lies in the cone of the other: corners of the remainder
//! are whole-number homogeneous points, and which plane they lie in front of is a sign.
#![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use ombra_hsr::painter;
use ombra_hsr::pair::{Pair, compare};
use ombra_hsr::polygon::Polygon;
use ombra_tests::cases::Random;
use ombra_tests::whole_faces::{Face, Viewer, Whole, cross, dot, scene, sub};

fn gcd(a: i128, b: i128) -> i128 {
    if b == 0 { a.abs() } else { gcd(b, a % b) }
}

/// Homogeneous, of whole numbers without a common factor.
type Point = [i128; 4];

fn height(normal: Whole, d: i128, p: Point) -> i128 {
    dot(normal, [p[0], p[1], p[2]]) + d * p[3]
}

/// What of `second` lies in the cone of `first`: nothing where only borders meet, or one is edge-on.
fn within(first: &Face, second: &Face, viewer: Viewer) -> Vec<Point> {
    if viewer.side(first) == 0 || viewer.side(second) == 0 {
        return vec![];
    }
    let mut left: Vec<Point> = second.0.iter().map(|v| [v[0], v[1], v[2], 1]).collect();
    for [a, b] in first.sides() {
        let normal = if viewer.place {
            cross(sub(a, viewer.at), sub(b, viewer.at))
        } else {
            cross(sub(b, a), viewer.at)
        };
        let d = -dot(normal, a);
        let inward = first
            .0
            .iter()
            .map(|&v| dot(normal, v) + d)
            .sum::<i128>()
            .signum();
        let height = |p: Point| inward * height(normal, d, p);
        let mut kept = vec![];
        for (i, &p) in left.iter().enumerate() {
            let q = left[(i + 1) % left.len()];
            let (hp, hq) = (height(p), height(q));
            if hp >= 0 {
                kept.push(p);
            }
            if hp.signum() * hq.signum() < 0 {
                let cut = [0, 1, 2, 3].map(|k| p[k] * hq.abs() + q[k] * hp.abs());
                let factor = cut.into_iter().fold(0, gcd);
                kept.push(cut.map(|x| x / factor));
            }
        }
        left = kept;
    }
    let flat = |p: Point| {
        let from = left[0];
        let difference = [0, 1, 2].map(|k| p[k] * from[3] - from[k] * p[3]);
        let factor = difference.into_iter().fold(0, gcd).max(1);
        difference.map(|x| x / factor)
    };
    let away: Vec<Whole> = left.iter().map(|&p| flat(p)).collect();
    let wide = away
        .iter()
        .any(|&u| away.iter().any(|&v| cross(u, v) != [0; 3]));
    if wide { left } else { vec![] }
}

fn related(first: &Face, second: &Face, viewer: Viewer) -> Pair {
    let normal = first.normal();
    let d = -dot(normal, first.0[0]);
    let shared = within(first, second, viewer);
    let signs: Vec<i128> = shared
        .iter()
        .map(|&p| height(normal, d, p).signum() * viewer.side(first))
        .collect();
    match (shared.is_empty(), signs.contains(&1), signs.contains(&-1)) {
        (true, ..) => Pair::Apart,
        (_, true, true) => Pair::Crossing,
        (_, true, false) => Pair::SecondNearer,
        (_, false, true) => Pair::FirstNearer,
        _ => Pair::Coplanar,
    }
}

/// Whether some order puts every face before those that hide it, by trying all orders.
fn some_order(hides: &[Vec<bool>], taken: &mut Vec<usize>) -> bool {
    let all = 0..hides.len();
    taken.len() == hides.len()
        || all.clone().any(|next| {
            let ready = !taken.contains(&next) && taken.iter().all(|&before| !hides[before][next]);
            if !ready {
                return false;
            }
            taken.push(next);
            let found = some_order(hides, taken);
            taken.pop();
            found
        })
}

#[test]
fn pairs_and_orders_of_whole_number_scenes() {
    let mut random = Random::new(41);
    let (mut ordered, mut rings, mut kinds) = (0, 0, [0; 5]);
    for case in 0..900 {
        let (faces, viewer) = scene(&mut random, 6);
        let polygons: Vec<Polygon> = faces
            .iter()
            .map(|face| Polygon::new(face.doubles()).unwrap())
            .collect();
        let eye = viewer.eye();
        let mut hides = vec![vec![false; faces.len()]; faces.len()];
        for i in 0..faces.len() {
            for j in 0..i {
                let pair = related(&faces[j], &faces[i], viewer);
                assert_eq!(
                    compare(&polygons[j], &polygons[i], eye),
                    pair,
                    "{case}: {j}, {i}"
                );
                assert_eq!(
                    compare(&polygons[i], &polygons[j], eye),
                    pair.swapped(),
                    "{case}: {i}, {j}"
                );
                // Of two at one depth the one submitted first is seen.
                hides[j][i] = matches!(pair, Pair::FirstNearer | Pair::Crossing | Pair::Coplanar);
                hides[i][j] = matches!(pair, Pair::SecondNearer | Pair::Crossing);
                kinds[pair as usize] += 1;
            }
        }
        for answer in [
            painter::order(&polygons, eye),
            painter::order_plain(&polygons, eye, &mut ()),
        ] {
            match answer {
                Ok(order) => {
                    ordered += 1;
                    let mut sorted = order.clone();
                    sorted.sort_unstable();
                    assert_eq!(sorted, (0..faces.len()).collect::<Vec<_>>(), "{case}");
                    for (at, &i) in order.iter().enumerate() {
                        assert!(
                            order[at..].iter().all(|&later| !hides[i][later]),
                            "{case}: {order:?}"
                        );
                    }
                    let pieces = painter::order_by_cutting(&polygons, eye);
                    let uncut: Vec<_> = order.iter().map(|&i| (i, polygons[i].clone())).collect();
                    assert_eq!(pieces, uncut, "{case}");
                }
                Err(cycle) => {
                    rings += 1;
                    assert!(!some_order(&hides, &mut vec![]), "{case}: {cycle}");
                    let ring = &cycle.primitives;
                    assert!(ring.len() >= 2, "{case}: {cycle}");
                    for (at, &i) in ring.iter().enumerate() {
                        let next = ring[(at + 1) % ring.len()];
                        let hidden: Vec<usize> =
                            ring.iter().copied().filter(|&j| hides[i][j]).collect();
                        assert_eq!(hidden, [next], "{case}: {cycle}");
                    }
                }
            }
        }
    }
    assert!(
        ordered > 500 && rings > 300 && kinds.iter().all(|&n| n > 30),
        "{ordered} {rings} {kinds:?}"
    );
}
