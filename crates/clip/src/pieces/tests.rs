use super::*;
use crate::oracle::{self, Exact, area, r, small_window, winding};
use crate::outline::edges;
use proptest::prelude::*;

fn points<const N: usize>(p: [(f64, f64); N]) -> Vec<DVec2> {
    p.map(DVec2::from).to_vec()
}

fn lecture() -> Window {
    Window::new(DVec2::ZERO, DVec2::splat(10.0)).unwrap()
}

#[test]
fn the_lectures_cases() {
    let w = lecture();
    // A, convex.
    let triangle = points([(5.0, 5.0), (15.0, 5.0), (5.0, 15.0)]);
    let square = points([(5.0, 5.0), (10.0, 5.0), (10.0, 10.0), (5.0, 10.0)]);
    assert_eq!(clip_polygon(&w, &triangle), [square]);
    // B, concave: the letter U falls into two arms, both ways round.
    let mut u = points([
        (1.0, -5.0),
        (9.0, -5.0),
        (9.0, 5.0),
        (7.0, 5.0),
        (7.0, -3.0),
        (3.0, -3.0),
        (3.0, 5.0),
        (1.0, 5.0),
    ]);
    let arm = |x: f64| points([(x + 2.0, 0.0), (x + 2.0, 5.0), (x, 5.0), (x, 0.0)]);
    assert_eq!(clip_polygon(&w, &u), [arm(7.0), arm(1.0)]);
    u.reverse();
    let reversed = |x: f64| {
        let mut arm = arm(x);
        arm.reverse();
        arm
    };
    // It starts inside the left arm now, at (1, 5).
    let mut left = reversed(1.0);
    left.rotate_left(1);
    assert_eq!(clip_polygon(&w, &u), [left, reversed(7.0)]);
}

#[test]
fn corners_inside_the_polygon() {
    let w = lecture();
    // From the right side round three corners of the window to its left side.
    let c = points([
        (12.0, 8.0),
        (12.0, -2.0),
        (-2.0, -2.0),
        (-2.0, 12.0),
        (12.0, 12.0),
        (12.0, 9.0),
        (5.0, 9.0),
        (5.0, 8.0),
    ]);
    let mut c = c;
    c.reverse();
    let pieces = clip_polygon(&w, &c);
    assert_eq!(pieces.len(), 1);
    assert_eq!(
        pieces[0],
        points([
            (5.0, 8.0),
            (5.0, 9.0),
            (10.0, 9.0),
            (10.0, 10.0),
            (0.0, 10.0),
            (0.0, 0.0),
            (10.0, 0.0),
            (10.0, 8.0)
        ])
    );
}

#[test]
fn two_edges_through_one_double() {
    // Two lobes on stalks that all cross y = 0 within half an ulp u of (5, 0): at −3/8, −1/8, 3/32 and 7/32 u. By the
    // directions of the stalks alone the lobes would be taken for one.
    let w = lecture();
    let u = 8.0 * f64::EPSILON / 2.0;
    let x = |ulps: f64| 5.0 + ulps * u;
    let lobes = points([
        (x(-2.0), -15.0),
        (5.0, 1.0),
        (4.0, 4.0),
        (1.0, 4.0),
        (1.0, 1.5),
        (x(-1.0), 1.0),
        (x(9.0), -15.0),
        (x(-24.0), -15.5),
        (x(1.0), 0.5),
        (9.0, 0.6),
        (9.0, 4.0),
        (6.0, 4.0),
        (5.0, 0.5),
        (x(3.0), -15.5),
    ]);
    let mut one = lobes[1..6].to_vec();
    one.insert(0, DVec2::new(5.0, 0.0));
    let mut other = lobes[8..13].to_vec();
    other.insert(0, DVec2::new(5.0, 0.0));
    assert_eq!(clip_polygon(&w, &lobes), [one, other]);
}

#[test]
fn touching_itself_and_the_border() {
    let w = lecture();
    // A slit from outside into the polygon has no width, and leaves no trace.
    let mut slit = points([
        (-5.0, -5.0),
        (15.0, -5.0),
        (15.0, 15.0),
        (-5.0, 15.0),
        (-5.0, 5.0),
        (5.0, 5.0),
        (-5.0, 5.0),
    ]);
    let mut corners = w.corners();
    assert_eq!(clip_polygon(&w, &slit), [corners]);
    slit.reverse();
    corners.reverse();
    assert_eq!(clip_polygon(&w, &slit), [corners]);
    // A reflex corner on the border parts two pieces that touch there.
    let m = points([(1.0, -5.0), (9.0, -5.0), (9.0, 5.0), (5.0, 0.0), (1.0, 5.0)]);
    let parts = clip_polygon(&w, &m);
    assert_eq!(parts.len(), 2, "{parts:?}");
    assert_eq!(parts[0], points([(9.0, 0.0), (9.0, 5.0), (5.0, 0.0)]));
    assert_eq!(parts[1], points([(5.0, 0.0), (1.0, 5.0), (1.0, 0.0)]));
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
        points([(10.0, 10.0), (15.0, 10.0), (10.0, 15.0)]),
        points([(10.0, 2.0), (15.0, 2.0), (15.0, 8.0), (10.0, 8.0)]),
        points([(0.0, 2.0), (0.0, 5.0), (0.0, 8.0)]),
        points([(-5.0, 9.0), (1.0, 15.0), (-5.0, 15.0)]),
    ];
    for polygon in nothing {
        assert!(clip_polygon(&w, &polygon).is_empty(), "{polygon:?}");
    }
    let corners = w.corners();
    assert_eq!(clip_polygon(&w, &corners), [corners]);
    let mut wide = points([(-huge, -huge), (huge, -huge), (huge, huge), (-huge, huge)]);
    assert_eq!(clip_polygon(&w, &wide), [corners]);
    wide.reverse();
    assert_eq!(area(&clip_polygon(&w, &wide)[0]), -200);
    // Twice round the window.
    let twice = wide.repeat(2);
    assert_eq!(clip_polygon(&w, &twice).len(), 2);
    // A spike from the border and back.
    let spike = points([(-5.0, 5.0), (5.0, 5.0), (-5.0, 5.0), (-6.0, 9.0)]);
    assert!(clip_polygon(&w, &spike).is_empty());
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let polygon = [DVec2::ONE, DVec2::X, DVec2::new(5.0, bad), DVec2::Y];
        assert!(clip_polygon(&w, &polygon).is_empty());
    }
    let triangle = points([(-5.0, -5.0), (15.0, -5.0), (5.0, 15.0)]);
    let [p, q] = [DVec2::splat(5.0), DVec2::new(5.0, 9.0)];
    for thin in [
        Window { min: p, max: p },
        Window { min: p, max: q },
        Window {
            min: w.max,
            max: w.min,
        },
    ] {
        assert!(clip_polygon(&thin, &triangle).is_empty());
    }
}

fn check(w: &Window, polygon: &[DVec2]) -> Result<Vec<Vec<DVec2>>, TestCaseError> {
    let pieces = clip_polygon(w, polygon);
    for piece in &pieces {
        prop_assert!(piece.len() >= 3);
        prop_assert!(piece.iter().all(|&p| w.contains(p)));
        for (a, b) in edges(piece) {
            prop_assert_ne!(a, b);
        }
        prop_assert_eq!(&clip_polygon(w, piece), std::slice::from_ref(piece));
    }
    Ok(pieces)
}

/// A comb: columns two wide between a lower and an upper height, as a counter-clockwise outline.
fn comb(columns: &[(i32, i32)]) -> Vec<DVec2> {
    let at = |x: usize, y: i32| DVec2::new(2.0 * x as f64 - 4.0, y.into());
    let mut outline = Outline::default();
    for (i, &(low, _)) in columns.iter().enumerate() {
        outline.points.push(at(i, low));
        outline.points.push(at(i + 1, low));
    }
    for (i, &(low, height)) in columns.iter().enumerate().rev() {
        outline.points.push(at(i + 1, low + height));
        outline.points.push(at(i, low + height));
    }
    outline.close(&Window {
        min: DVec2::NAN,
        max: DVec2::NAN,
    })
}

/// The parts of the cells that the columns cover inside the window, by flooding.
fn parts(columns: &[(i32, i32)], width: i32, height: i32) -> (usize, usize) {
    let covered = |x: i32, y: i32| {
        let column = (x + 4) / 2;
        (0..width).contains(&x)
            && (0..height).contains(&y)
            && columns
                .get(column as usize)
                .is_some_and(|&(low, h)| low <= y && y < low + h)
    };
    let mut cells: std::collections::BTreeSet<(i32, i32)> = (0..width)
        .flat_map(|x| (0..height).map(move |y| (x, y)))
        .filter(|&(x, y)| covered(x, y))
        .collect();
    let (all, mut parts) = (cells.len(), 0);
    while let Some(cell) = cells.pop_first() {
        parts += 1;
        let mut flood = vec![cell];
        while let Some((x, y)) = flood.pop() {
            for next in [(x + 1, y), (x - 1, y), (x, y + 1), (x, y - 1)] {
                if cells.remove(&next) {
                    flood.push(next);
                }
            }
        }
    }
    (parts, all)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn combs_fall_into_the_parts_that_flooding_finds(
        columns in prop::collection::vec((-5i32..7, 1i32..9), 1..9),
        clockwise: bool,
        turn in 0usize..30,
    ) {
        // Neighbours must share some height, or the comb falls apart by itself.
        let mut columns = columns;
        for i in 1..columns.len() {
            let (low, height) = columns[i - 1];
            let (l, h) = columns[i];
            let l = l.clamp(low - h + 1, low + height - 1);
            columns[i] = (l, h);
        }
        let w = small_window();
        let mut polygon = comb(&columns);
        if clockwise {
            polygon.reverse();
        }
        let n = polygon.len();
        polygon.rotate_left(turn % n);
        let pieces = check(&w, &polygon)?;
        let (parts, cells) = parts(&columns, 6, 5);
        prop_assert_eq!(pieces.len(), parts, "{:?}", &pieces);
        let sign = if clockwise { -1 } else { 1 };
        let mut sum = Exact::ZERO;
        for piece in &pieces {
            prop_assert!(area(piece) * Exact::from(sign) > 0);
            sum += area(piece);
        }
        prop_assert_eq!(sum, Exact::from(2 * sign * cells as i64));
    }

    #[test]
    fn points_keep_their_winding_number(polygon in oracle::grid_polygon()) {
        let w = small_window();
        let pieces = check(&w, &polygon)?;
        for p in oracle::samples() {
            let Some(expected) = winding(&polygon, p) else { continue };
            let sum: i64 = pieces.iter().map(|piece| winding(piece, p).unwrap()).sum();
            prop_assert_eq!(sum, expected, "{} {:?}", p, &pieces);
        }
    }

    #[test]
    fn the_area_is_that_of_one_outline(polygon in oracle::polygon()) {
        let w = small_window();
        let pieces = check(&w, &polygon)?;
        let one = area(&crate::sutherland_hodgman::clip_polygon(&w, &polygon));
        let sum: Exact = pieces.iter().map(|piece| area(piece)).sum();
        // Up to 4 crossings an edge, each off by half an ulp of 8 in x and y, times twice the window's size, twice.
        let bound = r(2.0 * 14.0 * 4.0 * f64::EPSILON * 4.0 * 2.0 * 12.0);
        prop_assert!((one - sum).abs() <= bound);
    }

    /// Those of the one outline, which are the nearest doubles to the true ones, and corners.
    #[test]
    fn vertices_are_those_of_one_outline(polygon in oracle::polygon()) {
        let w = small_window();
        let outline = crate::sutherland_hodgman::clip_polygon(&w, &polygon);
        for p in check(&w, &polygon)?.concat() {
            prop_assert!(outline.contains(&p) || w.corners().contains(&p), "{} {:?}", p, &outline);
        }
    }

    #[test]
    fn never_panics(x in prop::collection::vec(proptest::num::f64::ANY, 24), n in 0usize..11) {
        let p: Vec<DVec2> = x.chunks_exact(2).map(DVec2::from_slice).collect();
        let (polygon, corners) = p.split_at(n.min(10));
        for w in [
            Window { min: corners[0], max: corners[1] },
            Window { min: corners[0].min(corners[1]), max: corners[0].max(corners[1]) },
            lecture(),
        ] {
            for piece in clip_polygon(&w, polygon) {
                prop_assert!(piece.iter().all(|&p| w.contains(p)));
            }
        }
    }
}
