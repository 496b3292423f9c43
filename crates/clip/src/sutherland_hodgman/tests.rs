use super::*;
use crate::extremes::lecture;
use crate::oracle::{self, area, is_nearest, r, small_window, winding};
use ombra_math::work::Work;
use ombra_oracle::vector::doubled_area;
use proptest::prelude::*;

/// Both forms, which must agree.
fn clip(window: &Window, polygon: &[DVec2]) -> Vec<DVec2> {
    let fast = clip_polygon(window, polygon);
    let plain = clip_polygon_plain(window, polygon, &mut ());
    let bits =
        |p: &[DVec2]| -> Vec<_> { p.iter().map(|p| p.to_array().map(f64::to_bits)).collect() };
    assert_eq!(bits(&fast), bits(&plain), "{window:?} {polygon:?}");
    fast
}

fn points<const N: usize>(p: [(f64, f64); N]) -> Vec<DVec2> {
    p.map(DVec2::from).to_vec()
}

#[test]
fn the_lectures_triangle() {
    let triangle = points([(5.0, 5.0), (15.0, 5.0), (5.0, 15.0)]);
    let square = points([(5.0, 5.0), (10.0, 5.0), (10.0, 10.0), (5.0, 10.0)]);
    assert_eq!(clip(&lecture(), &triangle), square);
    assert_eq!(area(&square), 50);
}

#[test]
fn convex_concave_and_around() {
    let w = lecture();
    let around = points([(-5.0, -5.0), (20.0, -5.0), (20.0, 20.0), (-5.0, 20.0)]);
    assert_eq!(area(&clip(&w, &around)), 200);
    assert_eq!(clip(&w, &w.corners()), w.corners());
    // The letter U: one outline, its arms joined along the side.
    let u = points([
        (1.0, -5.0),
        (9.0, -5.0),
        (9.0, 5.0),
        (7.0, 5.0),
        (7.0, -3.0),
        (3.0, -3.0),
        (3.0, 5.0),
        (1.0, 5.0),
    ]);
    let arms = points([
        (9.0, 0.0),
        (9.0, 5.0),
        (7.0, 5.0),
        (7.0, 0.0),
        (3.0, 0.0),
        (3.0, 5.0),
        (1.0, 5.0),
        (1.0, 0.0),
    ]);
    assert_eq!(clip(&w, &u), arms);
}

#[test]
fn degenerate() {
    let w = lecture();
    let huge = f64::MAX;
    let nothing: [Vec<DVec2>; 9] = [
        points([]),
        points([(5.0, 5.0)]),
        points([(5.0, 5.0), (6.0, 6.0)]),
        vec![DVec2::splat(5.0); 7],
        points([(11.0, 5.0), (15.0, 5.0), (11.0, 9.0)]),
        // It touches a corner; a side; a side in three points.
        points([(10.0, 10.0), (15.0, 10.0), (10.0, 15.0)]),
        points([(10.0, 2.0), (15.0, 2.0), (15.0, 8.0), (10.0, 8.0)]),
        points([(10.0, 2.0), (15.0, 5.0), (10.0, 8.0), (10.0, 5.0)]),
        // Round a corner of the window, without meeting it.
        points([(-5.0, 9.0), (1.0, 15.0), (-5.0, 15.0)]),
    ];
    for polygon in nothing {
        assert_eq!(clip(&w, &polygon), [], "{polygon:?}");
    }
    let wide = points([(-huge, -huge), (huge, -huge), (huge, huge), (-huge, huge)]);
    assert_eq!(area(&clip(&w, &wide)), 200);
    let repeated = points([
        (1.0, 1.0),
        (1.0, 1.0),
        (9.0, 1.0),
        (9.0, 1.0),
        (9.0, 9.0),
        (1.0, 1.0),
    ]);
    assert_eq!(
        clip(&w, &repeated),
        points([(1.0, 1.0), (9.0, 1.0), (9.0, 9.0)])
    );
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for p in [DVec2::new(bad, 5.0), DVec2::new(5.0, bad)] {
            assert_eq!(clip(&w, &[DVec2::ONE, DVec2::X, p, DVec2::Y]), []);
        }
    }
    let triangle = points([(-5.0, -5.0), (15.0, -5.0), (5.0, 15.0)]);
    for thin in [
        (DVec2::ZERO, DVec2::X * 10.0),
        (DVec2::splat(5.0), DVec2::splat(5.0)),
    ] {
        assert_eq!(clip(&Window::new(thin.0, thin.1).unwrap(), &triangle), []);
    }
    let by_hand = Window {
        min: w.max,
        max: w.min,
    };
    assert_eq!(clip(&by_hand, &triangle), []);
}

#[test]
fn counts_each_pass() {
    let mut work = Work::default();
    let triangle = points([(5.0, 5.0), (15.0, 5.0), (5.0, 15.0)]);
    let _ = clip_polygon_plain(&lecture(), &triangle, &mut work);
    // Above: 3 vertices, cut twice, 4 left. Below: 4. Right: 4, one beyond; an edge meets it in the corner. Left: 4.
    assert_eq!((work.vertices, work.divisions), (15, 3));
    // One for each vertex and side, the first of each pass twice.
    assert_eq!((work.comparisons, work.multiplications), (15 + 4, 0));
}

#[test]
fn counts_what_the_fast_form_does() {
    let count = |polygon: &[DVec2]| {
        let mut work = Work::default();
        let _ = counted::clip_polygon(&lecture(), polygon, &mut work);
        [
            work.vertices,
            work.comparisons,
            work.multiplications,
            work.divisions,
        ]
    };
    // Four comparisons a vertex.
    assert_eq!(
        count(&points([(1.0, 1.0), (2.0, 1.0), (1.0, 2.0)])),
        [3, 12, 0, 0]
    );
    // The edge through the corner is held against x = 10 at y = 10, where it crosses; the others cross once.
    assert_eq!(
        count(&points([(5.0, 5.0), (15.0, 5.0), (5.0, 15.0)])),
        [3, 13, 2, 3]
    );
    // Round the corner without touching: decided by the corner, nothing computed.
    assert_eq!(
        count(&points([(-5.0, 9.0), (1.0, 15.0), (-5.0, 15.0)])),
        [3, 13, 2, 0]
    );
}

#[test]
fn the_textbooks_form_rounds() {
    let w = lecture();
    let square = points([(5.0, 5.0), (15.0, 5.0), (15.0, 15.0), (5.0, 15.0)]);
    let corner = points([(5.0, 10.0), (5.0, 5.0), (10.0, 5.0), (10.0, 10.0)]);
    let mut work = Work::default();
    assert_eq!(textbook(&w, &square, &mut work), corner);
    // Two crossings on the right and two above; 4 vertices come to each pass.
    assert_eq!((work.divisions, work.vertices), (4, 16));
    let narrow = |p: &[DVec2]| -> Vec<_> { p.iter().map(|p| p.as_vec2()).collect() };
    assert_eq!(textbook_f32(&w, &narrow(&square), &mut ()), narrow(&corner));
    let beside: Vec<DVec2> = square.iter().map(|&p| p + 20.0).collect();
    assert_eq!(textbook(&w, &beside, &mut ()), []);
    assert_eq!(textbook(&w, &[], &mut ()), []);
    // What its page tells.
    let triangle = points([(2.1, 1.0), (11.0, 0.0), (2.0, 9.0)]);
    assert_eq!(textbook(&w, &triangle, &mut ())[1].x, 10.0_f64.next_up());
    assert!(clip(&w, &triangle).iter().all(|&p| w.contains(p)));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn vertices_are_the_nearest_doubles_to_the_true_ones(polygon in oracle::polygon()) {
        let w = small_window();
        let clipped = clip(&w, &polygon);
        let mut expected: Vec<DVec2> = Vec::new();
        for [x, y] in oracle::sutherland_hodgman(&w, &polygon) {
            let nearest = |p: &&DVec2| is_nearest(p.x, &x) && is_nearest(p.y, &y);
            // What is not near any vertex must not be there: then nothing is left but a side, or two points.
            let Some(&p) = clipped.iter().find(nearest) else {
                prop_assert_eq!(&clipped, &[]);
                continue;
            };
            if expected.last() != Some(&p) {
                expected.push(p);
            }
        }
        while expected.len() > 1 && expected.first() == expected.last() {
            expected.pop();
        }
        prop_assert_eq!(&clipped, &expected);
        prop_assert!(clipped.iter().all(|&p| w.contains(p)));
        prop_assert_eq!(clip(&w, &clipped), clipped);
    }

    #[test]
    fn points_keep_their_winding_number(polygon in oracle::grid_polygon()) {
        let w = small_window();
        let clipped = clip(&w, &polygon);
        for p in oracle::samples() {
            let expected = winding(&polygon, p);
            prop_assert!(expected.is_none() || winding(&clipped, p) == expected, "{}", p);
        }
    }

    #[test]
    fn what_vanishes_has_no_area(polygon in oracle::polygon()) {
        let w = small_window();
        let exact = oracle::sutherland_hodgman(&w, &polygon);
        let true_area = doubled_area(&exact);
        // Up to 4 crossings an edge, each off by half an ulp of 8 in x and y, times twice the window's size.
        let bound = r(14.0 * 4.0 * f64::EPSILON * 4.0 * 2.0 * 12.0);
        prop_assert!((area(&clip(&w, &polygon)) - true_area).abs() <= bound);
    }

    #[test]
    fn never_panics(x in prop::collection::vec(proptest::num::f64::ANY, 12), n in 0usize..5) {
        let p: Vec<DVec2> = x.chunks_exact(2).map(DVec2::from_slice).collect();
        let (polygon, corners) = p.split_at(n.min(4));
        let w = Window { min: corners[0], max: corners[1] };
        let clipped = clip(&w, polygon);
        prop_assert!(clipped.iter().all(|&p| w.contains(p)));
        let _ = textbook(&w, polygon, &mut ());
    }
}
