//! Scenes that have no order.

use ombra_math::predicates::orient_3d;

use super::checks::{check_pieces, check_sight};
use super::scenes::{point_of, polygon, square, sticks};
use super::*;
use crate::pair::tolerance;

#[test]
fn three_sticks_in_a_cycle() {
    let scene = sticks();
    for eye in [ABOVE, DVec4::new(3.0, 3.0, 40.0, 1.0)] {
        assert_eq!(hiding_pairs(&scene, eye), [[0, 2], [1, 0], [2, 1]]);
        let cycle = order(&scene, eye).unwrap_err();
        assert_eq!(cycle.primitives, [0, 2, 1]);
        assert_eq!(
            cycle.to_string(),
            "no order back to front: primitive 0 hides part of 2, 2 of 1, 1 of 0"
        );
        assert_eq!(order_plain(&scene, eye, &mut ()), Err(cycle));
        // Any two have an order, and so have four pieces.
        for i in 0..3 {
            let mut two = scene.to_vec();
            two.remove(i);
            assert!(order(&two, eye).is_ok());
        }
        let pieces = order_by_cutting(&scene, eye);
        assert_eq!(pieces.len(), 4, "{:?}", numbers(&pieces));
        check_pieces(&scene, &pieces).unwrap();
    }
}

#[test]
fn two_that_cross() {
    // z = x and z = −x over the same square.
    let rising = polygon(&[
        [-1.0, -1.0, -1.0],
        [1.0, -1.0, 1.0],
        [1.0, 1.0, 1.0],
        [-1.0, 1.0, -1.0],
    ]);
    let falling = polygon(&[
        [-1.0, -1.0, 1.0],
        [1.0, -1.0, -1.0],
        [1.0, 1.0, -1.0],
        [-1.0, 1.0, 1.0],
    ]);
    let scene = [rising, falling.clone()];
    let cycle = order(&scene, ABOVE).unwrap_err();
    assert_eq!(cycle.primitives, [0, 1]);
    assert_eq!(
        cycle.to_string(),
        "no order back to front: primitives 0 and 1 each hide part of the other"
    );
    let half = |x: f64| polygon(&[[0.0, -1.0, 0.0], [x, -1.0, x], [x, 1.0, x], [0.0, 1.0, 0.0]]);
    let pieces = order_by_cutting(&scene, ABOVE);
    assert_eq!(numbers(&pieces), [0, 1, 0]);
    assert_eq!(pieces[1].1, falling);
    let sorted = |p: &Polygon| {
        let mut v: Vec<_> = p.vertices.iter().map(|v| v.to_array()).collect();
        v.sort_by(|a, b| a.partial_cmp(b).unwrap());
        v
    };
    assert_eq!(sorted(&pieces[0].1), sorted(&half(-1.0)));
    assert_eq!(sorted(&pieces[2].1), sorted(&half(1.0)));
}

/// Of three sheets each lies within the tolerance of the next, the last one over the first by more: a ring, of which
/// nothing is cut, and which has an order as soon as sides are settled.
#[test]
fn a_ring_of_near_ties() {
    let delta = tolerance(1.0);
    let scene = [0.0, 0.75, 1.5].map(|height| square(0.0, 0.0, height * delta, 1.0));
    let cycle = order(&scene, ABOVE).unwrap_err();
    assert_eq!(cycle.primitives, [0, 1, 2]);
    assert_eq!(order_plain(&scene, ABOVE, &mut ()), Err(cycle));
    let pieces = order_by_cutting(&scene, ABOVE);
    let mut sorted = numbers(&pieces);
    sorted.sort_unstable();
    assert_eq!(sorted, [0, 1, 2]);
    // The last is over the first, whatever becomes of the ties.
    let place = |source: usize| pieces.iter().position(|(i, _)| *i == source);
    assert!(place(0) < place(2));
}

/// Halves of the first, numbered after all wholes, still come before others at the same distance.
#[test]
fn halves_keep_the_place_of_their_primitive() {
    let tilted = |slope: f64| {
        polygon(&[
            [-1.0, -1.0, -slope],
            [1.0, -1.0, slope],
            [1.0, 1.0, slope],
            [-1.0, 1.0, -slope],
        ])
    };
    // Apart from both, and as far away as the lower halves.
    let beside = square(9.0, 0.0, -1.0, 1.0);
    let scene = [tilted(1.0), beside, tilted(-1.0)];
    let pieces = order_by_cutting(&scene, ABOVE);
    assert_eq!(numbers(&pieces), [0, 1, 2, 0]);
}

/// A spiral staircase of which each stair begins over the end of the next.
#[test]
fn a_long_ring_is_named_whole() {
    let n = 300;
    let at = |i: f64| {
        let angle = core::f64::consts::TAU * i / n as f64;
        DVec3::new(libm::cos(angle), libm::sin(angle), 0.0)
    };
    let stair = |i: usize| {
        let i = i as f64;
        let across = at(i + 0.7);
        let (high, low) = (7.0 * at(i) + DVec3::Z, 7.0 * at(i + 1.4) - DVec3::Z);
        Polygon {
            vertices: vec![high - across, high + across, low + across, low - across],
        }
    };
    let scene: Vec<_> = (0..n).map(stair).collect();
    let cycle = order(&scene, ABOVE).unwrap_err();
    // i + 1 hides i.
    let expected: Vec<_> = core::iter::once(0).chain((1..n).rev()).collect();
    assert_eq!(cycle.primitives, expected);
    assert_eq!(order_plain(&scene, ABOVE, &mut ()), Err(cycle));
    let pieces = order_by_cutting(&scene, ABOVE);
    check_pieces(&scene, &pieces).unwrap();
    // One cut is enough to open a ring.
    assert_eq!(pieces.len(), n + 1);
}

/// Rounded vertices where three planes meet lie next to each other, in any direction; and pieces of two primitives in
/// one plane lie in it but for rounding, which is no reason to cut.
#[test]
fn where_three_planes_meet() {
    let one_point = [
        polygon(&[[1.0, 0.0, 2.0], [-1.0, -1.0, 2.0], [2.0, -2.0, -1.0]]),
        polygon(&[[0.0, 2.0, 2.0], [1.0, -2.0, 1.0], [-1.0, 2.0, -2.0]]),
        polygon(&[
            [1.0, 1.0, 1.0],
            [0.0, -1.0, 1.0],
            [-1.0, 0.0, 1.0],
            [0.0, 2.0, 1.0],
        ]),
        polygon(&[[2.0, 0.0, 0.0], [2.0, -2.0, 0.0], [0.0, 0.0, 2.0]]),
        polygon(&[
            [2.0, -2.0, 1.0],
            [0.0, 0.0, 2.0],
            [-1.0, 0.0, 1.0],
            [1.0, -2.0, 0.0],
        ]),
    ];
    let one_plane = [
        polygon(&[
            [-1.0, 1.0, 1.0],
            [1.0, 0.0, -1.0],
            [0.0, 1.0, 1.0],
            [-2.0, 2.0, 3.0],
        ]),
        polygon(&[[-2.0, 0.0, 1.0], [-1.0, 1.0, -2.0], [1.0, -2.0, 0.0]]),
        polygon(&[
            [1.0, 2.0, 1.0],
            [2.0, -2.0, 0.0],
            [-2.0, -2.0, -2.0],
            [-3.0, 2.0, -1.0],
        ]),
        polygon(&[
            [0.0, 0.0, 0.0],
            [0.0, -1.0, 2.0],
            [0.0, 0.0, 2.0],
            [0.0, 1.0, 0.0],
        ]),
        polygon(&[
            [-2.0, -2.0, -2.0],
            [-1.0, 2.0, 0.0],
            [1.0, 2.0, 1.0],
            [0.0, -2.0, -1.0],
        ]),
    ];
    for (scene, eye) in [
        (
            one_point,
            DVec4::new(
                -7.433360669941228,
                -5.353480748535674,
                -14.73240681186807,
                1.0,
            ),
        ),
        (one_plane, DVec4::new(2.4129092137951957, 0.0, 0.0, 1.0)),
    ] {
        let pieces = order_by_cutting(&scene, eye);
        check_pieces(&scene, &pieces).unwrap();
        // Convex to the last bit as seen: every corner of a piece turns the same way.
        for (_, piece) in pieces.iter().filter(|(i, p)| *p != scene[*i]) {
            let v = &piece.vertices;
            let at = |i: usize| v[i % v.len()];
            let turn = |i| orient_3d(at(i), at(i + 1), at(i + 2), eye.truncate()).unwrap();
            assert!((0..v.len()).all(|i| turn(i).is_ne() && turn(i) == turn(0)));
        }
        for primitive in &scene {
            for i in 1..20 {
                for j in 1..20 {
                    let (u, v) = (f64::from(i) / 20.0, f64::from(j) / 20.0);
                    let weights = [u * v, u * (1.0 - v), 1.0 - u, 0.0];
                    check_sight(&scene, &pieces, eye, point_of(primitive, weights)).unwrap();
                }
            }
        }
    }
}
