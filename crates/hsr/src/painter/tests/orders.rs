//! Scenes that have an order, large ones, and none at all.

use super::scenes::{polygon, square};
use super::*;

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
            order_plain(scene, eye, &mut ()),
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
fn what_is_counted() {
    let scene: Vec<_> = (0..100)
        .map(|i| square(3.0 * f64::from(i), 0.0, 0.0, 1.0))
        .collect();
    let mut work = Work::default();
    let all = order_plain(&scene, ABOVE, &mut work);
    assert_eq!(work.pairs, 100 * 99 / 2);
    let mut work = Work::default();
    assert_eq!(counted::order(&scene, ABOVE, &mut work), all);
    // Side by side: no two extents overlap.
    assert_eq!(work.pairs, 0);
    assert!(work.comparisons > 0);
    // Behind one another with depths apart: the sort is right, and no pair needs to be compared.
    let stack: Vec<_> = (0..100)
        .map(|i| square(0.0, 0.0, f64::from(i), 1.0))
        .collect();
    let mut work = Work::default();
    assert_eq!(
        counted::order(&stack, ABOVE, &mut work),
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
        let pieces = counted::order_by_cutting(&scene, eye, &mut work);
        assert!(pieces.len() >= k);
        assert!(work.pairs < 20 * k as u64, "{eye}: {work}");
    }
}
