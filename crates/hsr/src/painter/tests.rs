use ombra_math::glam::{DVec3, DVec4};
use ombra_math::predicates::orient_3d;
use ombra_math::work::Work;
use proptest::prelude::*;

use super::cut::Scene;
use super::extent::View;
use super::piece::{Knife, Piece};
use super::tree::Tree;
use super::*;
use crate::pair::{Pair, compare};
use scenes::{Meeting, area, meeting, point_of, polygon, scene, square, sticks};

mod scenes;

const ABOVE: DVec4 = DVec4::new(0.0, 0.0, 1.0, 0.0);

fn numbers(pieces: &[(usize, Polygon)]) -> Vec<usize> {
    pieces.iter().map(|(source, _)| *source).collect()
}

#[test]
fn farther_first() {
    let at = |z: f64| square(0.0, 0.0, z, 1.0);
    let scene = [at(2.0), at(-1.0), at(5.0), at(0.0)];
    let from_above = [1, 3, 0, 2];
    assert_eq!(order(&scene, ABOVE), Ok(from_above.to_vec()));
    assert_eq!(
        order(&scene, DVec4::new(0.0, 0.0, 50.0, 1.0)),
        Ok(from_above.to_vec())
    );
    assert_eq!(order(&scene, -ABOVE), Ok(vec![2, 0, 3, 1]));
    // The same place, whatever its w.
    assert_eq!(
        order(&scene, DVec4::new(0.0, 0.0, -100.0, -2.0)),
        Ok(from_above.to_vec())
    );
}

#[test]
fn equal_distances_stay_as_submitted() {
    let scene = [3.0, 0.0, 6.0, -3.0].map(|x| square(x, 0.0, 0.0, 1.0));
    assert_eq!(order(&scene, ABOVE), Ok(vec![0, 1, 2, 3]));
    // Mirrored about the eye: the same distance, by other coordinates.
    let round = [
        square(3.0, 1.0, 2.0, 0.5),
        square(-1.0, 3.0, 2.0, 0.5),
        square(1.0, -3.0, 2.0, 0.5),
        square(-3.0, -1.0, -2.0, 0.5),
    ];
    assert_eq!(order(&round, DVec4::W), Ok(vec![0, 1, 2, 3]));
}

#[test]
fn of_two_at_one_depth_the_first_is_seen() {
    let scene = [
        square(0.0, 0.0, 1.0, 1.0),
        square(1.0, 1.0, 1.0, 1.0),
        square(0.0, 0.0, 1.0, 1.0),
    ];
    assert_eq!(order(&scene, ABOVE), Ok(vec![2, 1, 0]));
    assert_eq!(hiding_pairs(&scene, ABOVE), [[0, 1], [0, 2], [1, 2]]);
}

/// The floor's far corner is farther away than the box on it: by distance alone, the floor would come after what is
/// under it and the box's lid before the floor.
#[test]
fn a_nearer_primitive_may_reach_farther() {
    let eye = DVec4::new(0.0, 0.0, 10.0, 1.0);
    // A large tilted sheet that ends at depth 12, over a small square at depth 10.5.
    let sheet = polygon(&[
        [-9.0, -2.0, 4.0],
        [9.0, -2.0, -2.0],
        [9.0, 2.0, -2.0],
        [-9.0, 2.0, 4.0],
    ]);
    let under = square(-5.0, 0.0, -0.5, 0.5);
    assert_eq!(order(&[sheet.clone(), under.clone()], eye), Ok(vec![1, 0]));
    assert_eq!(order(&[under, sheet], eye), Ok(vec![0, 1]));
}

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
        assert_eq!(order_plain(&scene, eye), Err(cycle));
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
    assert_eq!(order_plain(&scene, ABOVE), Err(cycle));
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

/// Sides once settled come before any comparison, whichever of the two they were settled for, and about whatever plane.
#[test]
fn settled_sides_come_first() {
    // Two that cross, z = x and z = −x; the first reaches higher, the second lower.
    let crossing = |slope: f64, [from, to]: [f64; 2]| {
        polygon(&[
            [from, -1.0, slope * from],
            [to, -1.0, slope * to],
            [to, 1.0, slope * to],
            [from, 1.0, slope * from],
        ])
    };
    let (rising, falling) = (crossing(1.0, [-1.0, 2.0]), crossing(-1.0, [-1.0, 2.0]));
    let level = |z: f64| square(0.0, 0.0, z, 5.0);
    let scene = [rising, falling, level(0.0), level(-9.0)];
    let view = View::of(ABOVE);
    let knife = |i: usize| Knife::new(i, &scene[i], ABOVE).unwrap();
    let piece = |i: usize, settled: &[usize]| {
        let mut piece = Piece::whole(i, &scene[i], &view);
        for &source in settled {
            assert!(piece.settle(&knife(source)));
            assert!(!piece.settle(&knife(source)));
        }
        piece
    };
    let compared = |first: &[usize], second: &[usize]| {
        let (first, second) = (piece(0, first), piece(1, second));
        let mut work = Work::default();
        let pair = first.compare(&second, ABOVE, &mut work);
        let swapped = second.compare(&first, ABOVE, &mut work);
        assert_eq!(swapped, pair.swapped());
        (pair, work.pairs)
    };
    assert_eq!(compared(&[], &[]), (Pair::Crossing, 2));
    // Up to 2 the first lies above the second's plane, and the second below the first's.
    assert_eq!(compared(&[1], &[]), (Pair::FirstNearer, 2));
    assert_eq!(compared(&[], &[0]), (Pair::FirstNearer, 2));
    assert_eq!(compared(&[2], &[2]), (Pair::FirstNearer, 2));
    // Known about one of them only, or both on one side: no news.
    assert_eq!(compared(&[2], &[]), (Pair::Crossing, 2));
    assert_eq!(compared(&[3], &[3]), (Pair::Crossing, 2));
    // The other way round, seen from below.
    let below = |first: &[usize], second: &[usize]| {
        let settled = |i: usize, of: &[usize]| {
            let mut piece = Piece::whole(i, &scene[i], &view);
            for &source in of {
                piece.settle(&Knife::new(source, &scene[source], -ABOVE).unwrap());
            }
            piece
        };
        settled(0, first).compare(&settled(1, second), -ABOVE, &mut ())
    };
    assert_eq!(below(&[1], &[]), Pair::SecondNearer);
    assert_eq!(below(&[], &[0]), Pair::SecondNearer);
    assert_eq!(below(&[2], &[2]), Pair::SecondNearer);
    // In the plane of one submitted later: on the eye's side. And what is cut passes on what it knew.
    let twins = [scene[2].clone(), scene[2].clone(), scene[0].clone()];
    for (piece, plane) in [(0, 1), (1, 0)] {
        let settled = || {
            let mut settled = Piece::whole(piece, &twins[piece], &view);
            settled.settle(&Knife::new(plane, &twins[plane], ABOVE).unwrap());
            settled
        };
        let other = Piece::whole(plane, &twins[plane], &view);
        let nearer = [Pair::FirstNearer, Pair::SecondNearer][piece];
        assert_eq!(settled().compare(&other, ABOVE, &mut ()), nearer);
        let whole_scene = Scene {
            polygons: &twins,
            eye: ABOVE,
            view: View::of(ABOVE),
        };
        let [knife, own] = [2, piece].map(|i| Knife::new(i, &twins[i], ABOVE).unwrap());
        for mut half in settled().cut(&knife, &own, &whole_scene).unwrap() {
            assert_eq!(half.compare(&other, ABOVE, &mut ()), nearer);
            let plane = Knife::new(plane, &twins[plane], ABOVE).unwrap();
            assert!(!half.settle(&knife) && !half.settle(&plane));
        }
    }
}

/// Nearer by one plane and farther by another, two pieces share no sight line: known without a comparison.
#[test]
fn on_two_sides_of_two_planes() {
    let at = |x: f64, z: f64| square(x, 0.0, z, 1.0);
    // Planes between them that lean to either side: the first is above one of them and below the other.
    let leaning = |slope: f64| {
        polygon(&[
            [-9.0, -9.0, -9.0 * slope],
            [9.0, -9.0, 9.0 * slope],
            [9.0, 9.0, 9.0 * slope],
            [-9.0, 9.0, -9.0 * slope],
        ])
    };
    let scene = [at(-3.0, 0.0), at(3.0, 0.0), leaning(1.0), leaning(-1.0)];
    let view = View::of(ABOVE);
    let piece = |i: usize, settled: &[usize]| {
        let mut piece = Piece::whole(i, &scene[i], &view);
        for &source in settled {
            piece.settle(&Knife::new(source, &scene[source], ABOVE).unwrap());
        }
        piece
    };
    for (settled, compared) in [(&[][..], 1), (&[2], 1), (&[3], 1), (&[2, 3], 0)] {
        let mut work = Work::default();
        let pair = piece(0, settled).compare(&piece(1, settled), ABOVE, &mut work);
        assert_eq!((pair, work.pairs), (Pair::Apart, compared), "{settled:?}");
    }
}

/// What is put into the tree later is found, also beyond the box of what it is a piece of: rounding may put it there.
#[test]
fn the_tree_finds_what_was_put_in() {
    let view = View::of(ABOVE);
    let extent = |x: f64, z: f64| view.extent(&square(x, 0.0, z, 1.0)).unwrap();
    let extents: Vec<_> = (0..40)
        .map(|i| Some(extent(4.0 * f64::from(i), 0.0)))
        .collect();
    let mut tree = Tree::new(&extents);
    let found = |tree: &Tree, at: extent::Extent| {
        let mut found = tree.may_be_hidden(&at, &mut ());
        found.sort_unstable();
        found
    };
    assert_eq!(found(&tree, extent(40.0, 0.0)), [10]);
    // Beside all boxes, below all of them, and a piece of that piece.
    tree.insert(40, extent(-50.0, 0.0), 10);
    tree.insert(41, extent(40.0, -7.0), 10);
    tree.insert(42, extent(-90.0, 0.0), 40);
    assert_eq!(found(&tree, extent(-50.0, 0.0)), [40]);
    assert_eq!(found(&tree, extent(40.0, 0.0)), [10, 41]);
    assert_eq!(found(&tree, extent(40.0, -1.0)), [41]);
    assert_eq!(found(&tree, extent(-90.0, 0.0)), [42]);
    for i in [10, 40] {
        tree.remove(i);
    }
    assert_eq!(found(&tree, extent(-50.0, 0.0)), [0; 0]);
    assert_eq!(found(&tree, extent(40.0, 0.0)), [41]);
    assert_eq!(found(&tree, extent(-90.0, 0.0)), [42]);
}

#[test]
fn degenerate() {
    let unit = square(0.0, 0.0, 0.0, 1.0);
    let eye = DVec4::new(0.0, 0.0, 5.0, 1.0);
    let empty: [Polygon; 0] = [];
    let huge = square(0.0, 0.0, 0.0, f64::MAX);
    let tiny = square(0.0, 0.0, 0.0, 5e-324);
    let nan = square(f64::NAN, 0.0, 0.0, 1.0);
    let infinite = square(0.0, 0.0, f64::INFINITY, 1.0);
    let point = square(1.0, 1.0, 1.0, 0.0);
    let none = Polygon::default();
    let edge_on = polygon(&[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]);
    let behind = square(0.0, 0.0, 9.0, 1.0);
    for (scene, eye, expected) in [
        (&empty[..], eye, &[][..]),
        (core::slice::from_ref(&unit), eye, &[0]),
        // All behind the eye: seen by looking back, the farthest first.
        (&[behind.clone(), square(0.0, 0.0, 10.0, 1.0)], eye, &[1, 0]),
        // On both sides of the eye: by distance.
        (&[behind.clone(), unit.clone()], eye, &[1, 0]),
        (&[unit.clone(), unit.clone(), unit.clone()], eye, &[2, 1, 0]),
        // What cannot be seen hides nothing; without a distance it comes first.
        (&[unit.clone(), nan.clone()], eye, &[1, 0]),
        (
            &[unit.clone(), infinite.clone(), none.clone()],
            eye,
            &[1, 2, 0],
        ),
        (&[unit.clone(), edge_on.clone()], eye, &[0, 1]),
        (&[edge_on.clone(), unit.clone()], eye, &[1, 0]),
        (&[point.clone(), unit.clone()], eye, &[1, 0]),
        // The eye in the plane of one, and at a corner.
        (
            &[unit.clone(), behind.clone()],
            DVec4::new(0.5, 0.5, 0.0, 1.0),
            &[1, 0],
        ),
        (
            &[unit.clone(), behind.clone()],
            DVec4::new(1.0, 1.0, 0.0, 1.0),
            &[1, 0],
        ),
        (
            &[tiny.clone(), huge.clone()],
            DVec4::new(0.0, 0.0, 1.0, 1.0),
            &[1, 0],
        ),
        // No eye: as submitted.
        (&[unit.clone(), behind.clone()], DVec4::ZERO, &[0, 1]),
        (&[unit.clone(), behind.clone()], DVec4::NAN, &[0, 1]),
        (
            &[unit.clone(), behind.clone()],
            DVec4::new(f64::INFINITY, 0.0, 0.0, 1.0),
            &[0, 1],
        ),
    ] {
        assert_eq!(order(scene, eye), Ok(expected.to_vec()), "{scene:?} {eye}");
        assert_eq!(
            order_plain(scene, eye),
            Ok(expected.to_vec()),
            "{scene:?} {eye}"
        );
        let pieces = order_by_cutting(scene, eye);
        assert_eq!(numbers(&pieces), expected, "{scene:?} {eye}");
    }
}

/// The six faces of a cube seen from within, and from without.
#[test]
fn inside_a_cube() {
    let mut faces = Vec::new();
    for axis in 0..3 {
        for side in [-1.0, 1.0] {
            let turn = |v: [f64; 3]| [v[(3 - axis) % 3], v[(4 - axis) % 3], v[(5 - axis) % 3]];
            faces.push(polygon(
                &[
                    [side, -1.0, -1.0],
                    [side, 1.0, -1.0],
                    [side, 1.0, 1.0],
                    [side, -1.0, 1.0],
                ]
                .map(turn),
            ));
        }
    }
    assert_eq!(
        hiding_pairs(&faces, DVec4::new(0.5, 0.25, -0.75, 1.0)),
        [[0; 2]; 0]
    );
    let outside = DVec4::new(3.0, 4.0, 5.0, 1.0);
    let found = order(&faces, outside).unwrap();
    let place = |face: usize| found.iter().position(|&f| f == face).unwrap();
    for back in [0, 2, 4] {
        for front in [1, 3, 5] {
            assert!(place(back) < place(front), "{found:?}");
        }
    }
}

#[test]
fn counted() {
    let scene: Vec<_> = (0..100)
        .map(|i| square(3.0 * f64::from(i), 0.0, 0.0, 1.0))
        .collect();
    let mut work = Work::default();
    let all = order_plain_counted(&scene, ABOVE, &mut work);
    assert_eq!(work.pairs, 100 * 99 / 2);
    let mut work = Work::default();
    assert_eq!(order_counted(&scene, ABOVE, &mut work), all);
    // Side by side: no two extents overlap.
    assert_eq!(work.pairs, 0);
    assert!(work.comparisons > 0);
    // Behind one another with depths apart: the sort is right, and no pair needs to be compared.
    let stack: Vec<_> = (0..100)
        .map(|i| square(0.0, 0.0, f64::from(i), 1.0))
        .collect();
    let mut work = Work::default();
    assert_eq!(
        order_counted(&stack, ABOVE, &mut work),
        Ok((0..100).collect())
    );
    assert_eq!(work.pairs, 0);
}

/// 10⁵ primitives in a cube, as small as lets them overlap a few others in the view.
#[test]
fn a_hundred_thousand() {
    let k = 100_000;
    let mut state = 1u64;
    let mut random = || {
        state = state
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        (state >> 11) as f64 / (1u64 << 53) as f64 * 2.0 - 1.0
    };
    let mut vector = || DVec3::new(random(), random(), random());
    let scene: Vec<_> = (0..k)
        .map(|_| {
            let (a, b, c) = (vector(), vector(), vector());
            Polygon {
                vertices: vec![a, a + 0.005 * b, a + 0.005 * c],
            }
        })
        .collect();
    for eye in [DVec4::W, DVec4::new(1.0, 2.0, 5.0, 1.0), ABOVE] {
        let mut work = Work::default();
        let pieces = order_by_cutting_counted(&scene, eye, &mut work);
        assert!(pieces.len() >= k);
        assert!(work.pairs < 20 * k as u64, "{eye}: {work}");
    }
}

fn hides(scene: &[Polygon], front: usize, back: usize, eye: DVec4) -> bool {
    let first = front.min(back);
    match compare(&scene[first], &scene[front.max(back)], eye) {
        Pair::Apart => false,
        Pair::Crossing => true,
        Pair::FirstNearer | Pair::Coplanar => front == first,
        Pair::SecondNearer => back == first,
    }
}

fn is_back_to_front(order: &[usize], pairs: &[[usize; 2]]) -> bool {
    let place = |i: usize| order.iter().position(|&p| p == i);
    pairs
        .iter()
        .all(|&[front, back]| place(back) < place(front))
}

/// Whether any permutation of what is left, put after `painted`, is back to front.
fn some_order(painted: &mut Vec<usize>, k: usize, pairs: &[[usize; 2]]) -> bool {
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
fn check_pieces(scene: &[Polygon], pieces: &[(usize, Polygon)]) -> Result<(), TestCaseError> {
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
fn check_sight(
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

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    #[test]
    fn an_order_is_found_where_there_is_one(scene in scene(6), eye in scenes::eye()) {
        let pairs = hiding_pairs(&scene, eye);
        let found = order(&scene, eye);
        prop_assert_eq!(found.is_ok(), some_order(&mut Vec::new(), scene.len(), &pairs));
        match found {
            Ok(found) => {
                let mut sorted = found.clone();
                sorted.sort_unstable();
                prop_assert!(sorted.into_iter().eq(0..scene.len()));
                prop_assert!(is_back_to_front(&found, &pairs));
                // The lecture's sort, wherever that is an order.
                let distance = |i: usize| {
                    let of = |v: &DVec3| {
                        if eye.w == 0.0 { -eye.truncate().dot(*v) } else { (*v - eye.truncate()).length() }
                    };
                    scene[i].vertices.iter().map(of).fold(f64::NEG_INFINITY, f64::max)
                };
                let mut by_distance: Vec<_> = (0..scene.len()).collect();
                by_distance.sort_by(|&a, &b| distance(b).total_cmp(&distance(a)));
                let unclear = by_distance.windows(2).any(|w| (distance(w[0]) - distance(w[1])).abs() < 1e-9);
                if !unclear && is_back_to_front(&by_distance, &pairs) {
                    prop_assert_eq!(found, by_distance);
                }
            }
            Err(cycle) => {
                let ring = cycle.primitives;
                for (i, &a) in ring.iter().enumerate() {
                    for (j, &b) in ring.iter().enumerate() {
                        if i != j {
                            let next = j == (i + 1) % ring.len();
                            prop_assert_eq!(hides(&scene, a, b, eye), next, "{:?}", ring);
                        }
                    }
                }
            }
        }
    }

    #[test]
    fn both_forms_agree(scene in prop_oneof![scene(8), scene(40)], eye in scenes::eye()) {
        let found = order(&scene, eye);
        prop_assert_eq!(&found, &order_plain(&scene, eye));
        // The same place by another w.
        if eye.w == 1.0 {
            prop_assert_eq!(&found, &order(&scene, eye * -2.0));
        }
    }

    /// Primitives whose extents say that they need no comparison do not hide each other: near and far, large and small,
    /// of any size.
    #[test]
    fn extents_leave_out_nothing(scene in scene(8), eye in scenes::eye(), exponent in -300..300) {
        let size = libm::scalbn(1.0, exponent);
        let grown = |p: &Polygon| Polygon { vertices: p.vertices.iter().map(|&v| v * size).collect() };
        let scene: Vec<_> = scene.iter().map(grown).collect();
        let eye = if eye.w == 1.0 { (eye.truncate() * size).extend(1.0) } else { eye };
        let view = View::of(eye);
        let extents: Vec<_> = scene.iter().map(|p| view.extent(p)).collect();
        for [front, back] in hiding_pairs(&scene, eye) {
            let (front, back) = (extents[front].unwrap(), extents[back].unwrap());
            prop_assert!(front.overlaps(&back), "{front:?} {back:?}");
            prop_assert!(back.farthest >= front.nearest, "{front:?} {back:?}");
        }
    }

    #[test]
    fn what_is_painted_last_is_nearest(
        scene in scene(12),
        eye in scenes::eye(),
        sights in prop::collection::vec((any::<prop::sample::Index>(), prop::array::uniform4(0.01..1.0)), 40),
    ) {
        let pieces = order_by_cutting(&scene, eye);
        check_pieces(&scene, &pieces)?;
        let whole = order(&scene, eye);
        if let Ok(found) = &whole {
            // Nothing is cut without a ring.
            prop_assert_eq!(&numbers(&pieces), found);
        } else {
            prop_assert!(pieces.len() > scene.len());
        }
        // k − 1 lines cut a convex polygon into 1 + (k − 1) + (k − 1)(k − 2)/2 parts at most.
        let k = scene.len();
        for i in 0..k {
            let parts = pieces.iter().filter(|(source, _)| *source == i).count();
            prop_assert!(parts <= (k * k - k + 2) / 2, "{i}: {parts}");
        }
        for (index, weights) in sights {
            if let Some(primitive) = (k > 0).then(|| index.get(&scene)) {
                check_sight(&scene, &pieces, eye, point_of(primitive, weights))?;
            }
        }
    }

    #[test]
    fn never_panics(
        numbers in prop::collection::vec(prop::array::uniform3(proptest::num::f64::ANY), 0..24),
        sizes in prop::collection::vec(0usize..6, 0..6),
        eye in prop::array::uniform4(proptest::num::f64::ANY),
    ) {
        let mut rest = numbers.as_slice();
        let mut scene = Vec::new();
        for n in sizes {
            let (vertices, after) = rest.split_at(n.min(rest.len()));
            scene.push(polygon(vertices));
            rest = after;
        }
        for eye in [DVec4::from_array(eye), DVec4::Z, DVec4::W] {
            let found = order(&scene, eye);
            prop_assert_eq!(&found, &order_plain(&scene, eye));
            let pieces = order_by_cutting(&scene, eye);
            prop_assert!(pieces.len() >= scene.len());
        }
    }
}
