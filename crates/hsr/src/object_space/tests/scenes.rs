//! Scenes worked out by hand.

use ombra_math::work::Work;

use super::*;

#[test]
fn a_square_over_the_half_of_another() {
    let scene = [square(0.0, 0.0, 0.0, 2.0), square(1.0, 0.0, 1.0, 2.0)];
    let parts = visible_parts(&scene, DVec4::Z);
    let left = polygon([
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [1.0, 2.0, 0.0],
        [0.0, 2.0, 0.0],
    ]);
    assert_eq!(parts, [(0, left), (1, scene[1].clone())]);
    // From below the first is the nearer one.
    assert_eq!(visible_parts(&scene, -DVec4::Z)[0], (0, scene[0].clone()));
}

/// Similar triangles: from the height h = 4, a square of side s at height 1 hides one of side s h / (h − 1) on the
/// ground.
#[test]
fn similar_triangles() {
    let ground = square(-4.0, -4.0, 0.0, 8.0);
    for (s, hidden) in [(1.5, 4.0), (3.0, 16.0), (6.0, 64.0), (9.0, 64.0)] {
        let near = square(-s / 2.0, -s / 2.0, 1.0, s);
        for scene in [
            [ground.clone(), near.clone()],
            [near.clone(), ground.clone()],
        ] {
            let parts = visible_parts(&scene, place(0.0, 0.0, 4.0));
            let of_ground = usize::from(scene[1] == ground);
            close(areas(&parts, of_ground), 64.0 - hidden, 64.0);
            close(areas(&parts, 1 - of_ground), s * s, 64.0);
        }
    }
    // In the middle it leaves a frame of four.
    let parts = visible_parts(
        &[ground, square(-0.75, -0.75, 1.0, 1.5)],
        place(0.0, 0.0, 4.0),
    );
    assert_eq!(parts.len(), 5);
}

#[test]
fn few_primitives() {
    assert_eq!(visible_parts(&[], DVec4::Z), []);
    let one = square(0.0, 0.0, 0.0, 1.0);
    assert_eq!(
        visible_parts(core::slice::from_ref(&one), DVec4::Z),
        [(0, one)]
    );
}

#[test]
fn every_pair_once() {
    for (k, pairs) in [(0, 0), (1, 0), (2, 1), (3, 3), (10, 45), (100, 4950)] {
        let scene: Vec<_> = (0..k)
            .map(|i| square(0.0, 0.0, f64::from(i), 1.0))
            .collect();
        let mut work = Work::default();
        let parts = visible_parts_plain(&scene, DVec4::Z, &mut work);
        assert_eq!((work.pairs, parts.len()), (pairs, usize::from(k > 0)));
    }
}

#[test]
fn equal_depths_show_the_first() {
    let [a, b] = [square(0.0, 0.0, 0.0, 2.0), square(1.0, 1.0, 0.0, 2.0)];
    for eye in [DVec4::Z, -DVec4::Z, place(0.5, 2.0, 3.0)] {
        for scene in [[a.clone(), b.clone()], [b.clone(), a.clone()]] {
            let parts = visible_parts(&scene, eye);
            assert_eq!(parts[0], (0, scene[0].clone()));
            close(areas(&parts, 1), 3.0, 4.0);
        }
        assert_eq!(
            visible_parts(&[a.clone(), a.clone(), a.clone()], eye),
            [(0, a.clone())]
        );
    }
}

/// n strips over n strips: k = 2n primitives, and n + n (n + 1) parts, which grow as k² does.
#[test]
fn a_grating_has_many_parts() {
    for n in [1, 2, 5, 20] {
        let strip = |i: i32| [f64::from(4 * i), f64::from(4 * i + 1)];
        let end = f64::from(4 * n);
        let along = |i: i32| {
            let [a, b] = strip(i);
            polygon([[-4.0, a, 0.0], [end, a, 0.0], [end, b, 0.0], [-4.0, b, 0.0]])
        };
        let over = |i: i32| {
            let [a, b] = strip(i);
            polygon([[a, -4.0, 1.0], [b, -4.0, 1.0], [b, end, 1.0], [a, end, 1.0]])
        };
        let scene: Vec<_> = (0..n).map(along).chain((0..n).map(over)).collect();
        let parts = visible_parts(&scene, DVec4::Z);
        assert_eq!(parts.len() as i32, n + n * (n + 1));
        let area: f64 = parts.iter().map(|(_, part)| part.area()).sum();
        assert_eq!(area, f64::from(2 * n * (4 * n + 4) - n * n));
    }
}

/// Each of three sticks lies over the next: no order of painting, but parts.
#[test]
fn sticks_in_a_circle() {
    let stick = |k: i32| {
        let turn = DQuat::from_axis_angle(DVec3::Z, f64::from(k) * 2.0 * PI / 3.0);
        let corners = [
            [-4.0, 1.0, -1.0],
            [4.0, 1.0, 1.0],
            [4.0, 2.0, 1.0],
            [-4.0, 2.0, -1.0],
        ];
        Polygon {
            vertices: corners.map(|v| turn * DVec3::from(v)).to_vec(),
        }
    };
    let scene = [0, 1, 2].map(stick);
    let parts = visible_parts(&scene, DVec4::Z);
    // A strip of width 1 crosses another one at 60° in an area of 1 / sin 60° as seen; z = x / 4.
    let slope = libm::sqrt(1.0 + 1.0 / 16.0);
    for source in 0..3 {
        let expected = (8.0 - 2.0 / libm::sqrt(3.0)) * slope;
        close(areas(&parts, source), expected, 16.0);
        assert_eq!(parts.iter().filter(|(i, _)| *i == source).count(), 2);
    }
}

/// Beside a corner: no side of the square is between, and yet nothing is hidden and nothing to be cut.
#[test]
fn what_misses_a_corner_stays_whole() {
    let near = Seen::new(&square(0.0, 0.0, 1.0, 2.0), DVec4::Z).unwrap();
    let beside = |sum: f64| {
        [
            DVec3::new(1.0, sum - 1.0, 0.0),
            DVec3::new(3.0, sum - 3.0, 0.0),
            DVec3::new(3.0, 3.0, 0.0),
        ]
    };
    assert!(peel(&beside(4.25), &near, None, 0.0).is_none());
    assert!(peel(&beside(4.0), &near, None, 0.0).is_none());
    assert_eq!(
        peel(&beside(3.75), &near, None, 0.0).map(|pieces| pieces.len()),
        Some(2)
    );
}

#[test]
fn edge_on_and_without_an_eye() {
    let floor = square(0.0, 0.0, 0.0, 2.0);
    let wall = polygon([
        [0.0, 1.0, 0.0],
        [2.0, 1.0, 0.0],
        [2.0, 1.0, 2.0],
        [0.0, 1.0, 2.0],
    ]);
    let scene = [floor.clone(), wall.clone()];
    for eye in [DVec4::Z, place(1.0, 1.0, 5.0), place(1.0, 1.0, 1.0)] {
        assert_eq!(visible_parts(&scene, eye), [(0, floor.clone())]);
    }
    assert_eq!(visible_parts(&scene, place(1.0, 0.5, 0.0)), [(1, wall)]);
    for eye in [
        DVec4::ZERO,
        DVec4::NAN,
        DVec4::INFINITY,
        place(0.0, f64::NAN, 0.0),
        place(0.0, f64::INFINITY, 0.0),
    ] {
        assert_eq!(visible_parts(&scene, eye), [], "{eye}");
    }
    let none = [
        polygon([]),
        polygon([[0.0; 3], [1.0; 3]]),
        polygon([[1.0; 3]; 4]),
        polygon([[0.0, 0.0, 1.0], [1.0, 1.0, 1.0], [2.0, 2.0, 1.0]]),
        polygon([[0.0, 0.0, 1.0], [f64::NAN, 1.0, 1.0], [2.0, 0.0, 1.0]]),
    ];
    for bad in none {
        assert_eq!(
            visible_parts(&[bad, floor.clone()], DVec4::Z),
            [(1, floor.clone())]
        );
    }
}

#[test]
fn before_and_behind_the_eye_at_once() {
    let pair = [square(-1.0, -1.0, -1.0, 2.0), square(-1.0, -1.0, 1.0, 2.0)];
    let parts = visible_parts(&pair, place(0.0, 0.0, 0.0));
    assert_eq!(parts, [(0, pair[0].clone()), (1, pair[1].clone())]);
    assert_eq!(visible_parts(&pair, DVec4::Z), [(1, pair[1].clone())]);
}
