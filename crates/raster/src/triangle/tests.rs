use super::*;
use crate::polygon::{self, FillRule, fill};
use ombra_math::work::Work;
use ombra_oracle::Exact;
use proptest::num::f64::ANY;
use proptest::prelude::*;
use std::collections::BTreeSet;

fn triangle(corners: [(f64, f64); 3]) -> [DVec2; 3] {
    corners.map(DVec2::from)
}

fn spans(triangle: [DVec2; 3], width: u32, height: u32) -> Vec<Span> {
    cover(triangle, width, height).unwrap().collect()
}

fn pixels(spans: &[Span]) -> Vec<UVec2> {
    spans.iter().flat_map(Span::pixels).collect()
}

fn plain(triangle: [DVec2; 3], rule: EdgeRule, width: u32, height: u32) -> Vec<UVec2> {
    let mut pixels = Vec::new();
    cover_plain(triangle, rule, width, height, &mut (), |pixel| {
        pixels.push(pixel)
    })
    .unwrap();
    pixels
}

/// The picture by both forms, which must agree.
fn grid(triangle: [DVec2; 3], width: u32, height: u32) -> Vec<String> {
    let fast = spans(triangle, width, height);
    assert_eq!(
        pixels(&fast),
        plain(triangle, EdgeRule::TopLeft, width, height)
    );
    let mut rows = vec![vec!['.'; width as usize]; height as usize];
    for span in fast {
        rows[span.y as usize][span.x.start as usize..span.x.end as usize].fill('#');
    }
    rows.into_iter().map(String::from_iter).collect()
}

#[test]
fn the_two_halves_of_a_square() {
    // The diagonal through the centres is a left edge of the upper half, a right edge of the lower.
    let upper = triangle([(0.0, 0.0), (4.0, 0.0), (4.0, 4.0)]);
    let lower = triangle([(0.0, 0.0), (4.0, 4.0), (0.0, 4.0)]);
    assert_eq!(grid(upper, 5, 4), ["####.", ".###.", "..##.", "...#."]);
    assert_eq!(grid(lower, 5, 4), [".....", "#....", "##...", "###.."]);
    // Split along a row of centres: the lower half owns them, by its top edge.
    let above = triangle([(0.0, 2.5), (2.0, 0.5), (4.0, 2.5)]);
    let below = triangle([(0.0, 2.5), (4.0, 2.5), (2.0, 4.5)]);
    assert_eq!(
        grid(above, 5, 5),
        [".....", ".##..", ".....", ".....", "....."]
    );
    assert_eq!(
        grid(below, 5, 5),
        [".....", ".....", "####.", ".##..", "....."]
    );
}

#[test]
fn without_the_rule_pixels_are_drawn_twice_or_never() {
    let [a, b, c, d] = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)].map(DVec2::from);
    let count = |rule| -> usize {
        let halves = [[a, b, c], [a, c, d]];
        halves.iter().map(|&t| plain(t, rule, 4, 4).len()).sum()
    };
    let counts = [EdgeRule::TopLeft, EdgeRule::Closed, EdgeRule::Open].map(count);
    assert_eq!(counts, [16, 20, 12]);
}

#[test]
fn slivers() {
    // 20 long, half a pixel high at its end, of area 5: 13 pixels.
    let sliver = triangle([(0.0, 0.25), (20.0, 0.5), (20.0, 1.0)]);
    // The lower side, y = 0.25 + 0.0375 x, reaches the centres of row 0 at x = 6⅔; the upper one at x = 20.
    assert_eq!(
        grid(sliver, 21, 2),
        [".......#############.", "....................."]
    );
    let missed = triangle([(0.0, 0.6), (20.0, 0.7), (20.0, 1.2)]);
    assert!(spans(missed, 21, 2).is_empty());
    // One ulp wide: the centres on its left side are in.
    let x = 3.5f64;
    let needle = triangle([(x, 0.0), (x, 8.0), (x.next_up(), 4.0)]);
    assert_eq!(
        spans(needle, 8, 8),
        (0..8).map(|y| Span { y, x: 3..4 }).collect::<Vec<_>>()
    );
    let beside = triangle([(x, 0.0), (x, 8.0), (x.next_down(), 4.0)]);
    assert!(spans(beside, 8, 8).is_empty());
}

/// The work counted, and the spans.
fn with_work(triangle: [DVec2; 3], width: u32, height: u32) -> (Work, Vec<Span>) {
    let mut work = Work::default();
    let spans = counted::cover(triangle, width, height, &mut work).unwrap();
    let spans = spans.collect();
    (work, spans)
}

/// Fragments, edge records, exact fallbacks.
fn counts(work: &Work) -> [u64; 3] {
    [work.fragments, work.edge_records, work.exact_fallbacks]
}

#[test]
fn work_is_counted() {
    // Two sides cross rows, the horizontal one none. The slanted one, x = 4 − 2y, crosses the rows of centres at 3
    // and 1: 3 + 1 pixels, nothing in doubt. 2 records for the sides, 2 for each of the rows.
    let wide = triangle([(0.0, 0.0), (4.0, 0.0), (0.0, 2.0)]);
    let (work, _) = with_work(wide, 8, 8);
    assert_eq!((work.vertices, counts(&work)), (3, [4, 6, 0]));
    // x = 4 − y runs through a centre in each row; the centre belongs to what lies right of it: 3 + 2 + 1 + 0.
    let steep = triangle([(0.0, 0.0), (4.0, 0.0), (0.0, 4.0)]);
    let (work, spans) = with_work(steep, 8, 8);
    assert_eq!((spans.len(), counts(&work)), (3, [6, 10, 4]));
    // A picture of the two upper rows; one of the two left columns, where two rows are as wide as it is.
    assert_eq!(counts(&with_work(steep, 8, 2).0), [5, 2 + 4, 2]);
    assert_eq!(with_work(steep, 2, 8).0.fragments, 2 + 2 + 1);
    // Three sides that cross rows, and 4 rows.
    let leaning = triangle([(1.0, 0.0), (5.0, 2.0), (2.0, 4.0)]);
    assert_eq!(with_work(leaning, 8, 8).0.edge_records, 3 + 2 * 4);
    // Beside the picture no row is looked at, above it no side enters.
    let shifted = |x, y| steep.map(|p| p + DVec2::new(x, y));
    assert_eq!(counts(&with_work(shifted(9.0, 0.0), 8, 8).0), [0, 2, 0]);
    assert_eq!(counts(&with_work(shifted(-9.0, 0.0), 8, 8).0), [0, 2, 0]);
    assert_eq!(counts(&with_work(shifted(0.0, -9.0), 8, 8).0), [0, 0, 0]);
    // However tall: the rows of the picture.
    let tower = triangle([(1.0, -1e9), (1e9, 0.0), (1.0, 1e9)]);
    // Where its slanted side comes, on half columns far to the right, there is nothing to decide.
    assert_eq!(counts(&with_work(tower, 4, 100).0), [300, 2 + 2 * 100, 0]);
}

#[test]
fn work_is_counted_as_spans_are_asked_for() {
    let steep = triangle([(0.0, 0.0), (4.0, 0.0), (0.0, 4.0)]);
    let mut work = Work::default();
    let mut spans = counted::cover(steep, 8, 8, &mut work).unwrap();
    assert_eq!(spans.next(), Some(Span { y: 0, x: 0..3 }));
    drop(spans);
    assert_eq!((work.vertices, counts(&work)), (3, [3, 2 + 2, 1]));
}

/// About a picture of 12 pixels: a third on centres, a third within 10⁻¹² of them.
fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![
        2 => (-2i32..15).prop_map(|k| f64::from(k) + 0.5),
        2 => (-2i32..15, -9i32..10).prop_map(|(k, m)| f64::from(k) + 0.5 + f64::from(m) * 1e-13),
        1 => -3.0..15.0f64,
        1 => (-8i32..60).prop_map(|k| f64::from(k) / 4.0),
    ]
}

/// The same, and everything a double can be.
fn any_coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![
        4 => coordinate(),
        1 => ANY.prop_filter("finite", |x| x.is_finite()),
        1 => (-9i32..10).prop_map(|k| f64::from(k) * 1e9),
        1 => (-9i32..10).prop_map(|k| f64::from(k) * 1e300),
        1 => (-9i32..10).prop_map(|k| f64::from(k) * libm::scalbn(1.0, 33)),
    ]
}

fn points(coordinate: impl Strategy<Value = f64>, n: usize) -> impl Strategy<Value = Vec<DVec2>> {
    prop::collection::vec(coordinate, 2 * n)
        .prop_map(|v| v.chunks(2).map(DVec2::from_slice).collect())
}

/// Cuts a triangle again and again at points inside it: a mesh in which every inner edge is shared.
fn mesh(outer: [DVec2; 3], cuts: &[DVec2]) -> Vec<[DVec2; 3]> {
    let mut mesh = vec![outer];
    for &p in cuts {
        if let Some(i) = mesh.iter().position(|&t| contains(t, p, EdgeRule::Closed)) {
            let [a, b, c] = mesh.swap_remove(i);
            // A cut on an edge leaves a degenerate triangle, which owns nothing.
            mesh.extend([[a, b, p], [b, c, p], [c, a, p]]);
        }
    }
    mesh
}

fn each_pixel_has_one_owner(outer: [DVec2; 3], cuts: &[DVec2]) -> Result<(), TestCaseError> {
    let whole: BTreeSet<_> = spans(outer, 12, 12)
        .iter()
        .flat_map(Span::pixels)
        .map(|p| (p.y, p.x))
        .collect();
    let mut owned = BTreeSet::new();
    for part in mesh(outer, cuts) {
        for pixel in spans(part, 12, 12).iter().flat_map(Span::pixels) {
            prop_assert!(owned.insert((pixel.y, pixel.x)), "{pixel} has two owners");
        }
    }
    prop_assert_eq!(owned, whole);
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    #[test]
    fn a_mesh_owns_each_pixel_once(corners in points(coordinate(), 3), cuts in points(coordinate(), 40)) {
        each_pixel_has_one_owner([corners[0], corners[1], corners[2]], &cuts)?;
    }

    #[test]
    fn a_huge_mesh_too(corners in points(any_coordinate(), 3), cuts in points(any_coordinate(), 40)) {
        each_pixel_has_one_owner([corners[0], corners[1], corners[2]], &cuts)?;
    }

    /// Edge functions, the fill of polygons and either winding give the same pixels.
    #[test]
    fn all_forms_agree(corners in points(any_coordinate(), 3), width in 0..14u32, height in 0..14u32) {
        let [a, b, c] = [corners[0], corners[1], corners[2]];
        let fast = spans([a, b, c], width, height);
        prop_assert_eq!(pixels(&fast), plain([a, b, c], EdgeRule::TopLeft, width, height));
        prop_assert_eq!(&fast, &spans([c, b, a], width, height));
        prop_assert_eq!(&fast, &spans([b, c, a], width, height));
        for rule in [FillRule::EvenOdd, FillRule::NonZero] {
            let filled: Vec<_> = fill(&[vec![a, b, c]], rule, width, height).unwrap().collect();
            prop_assert_eq!(&fast, &filled);
        }
    }

    /// Inside the picture, the fill of polygons does the same work.
    #[test]
    fn work_is_that_of_the_fill(corners in prop::collection::vec(prop::array::uniform2(4..44i32), 3)) {
        let corners: Vec<_> = corners.iter().map(|&[x, y]| DVec2::new(f64::from(x), f64::from(y)) / 4.0).collect();
        let (work, _) = with_work([corners[0], corners[1], corners[2]], 12, 12);
        let mut filled = Work::default();
        polygon::counted::fill(&[corners], FillRule::NonZero, 12, 12, &mut filled).unwrap().for_each(drop);
        prop_assert_eq!(work, filled);
    }

    #[test]
    fn the_edge_function_is_near_its_exact_sign(corners in points(coordinate(), 3)) {
        let [a, b, p] = [corners[0], corners[1], corners[2]];
        let value = edge_function(a, b, p);
        // Differences up to 18, three roundings each of the two products, one of their difference.
        if value.abs() > 4.0 * f64::EPSILON * 2.0 * 18.0 * 18.0 {
            prop_assert_eq!(value.partial_cmp(&0.0), orient_2d(a, b, p));
        }
    }

    /// Compared with exact numbers, from ordinary triangles to slivers of 10⁻¹³ and over six hundred binary orders.
    #[test]
    fn the_edge_function_keeps_its_bound(corners in points(coordinate(), 3), scale in [-300..300i32, -300..300i32]) {
        let scale = DVec2::new(libm::scalbn(1.0, scale[0]), libm::scalbn(1.0, scale[1]));
        let [a, b, p] = [corners[0] * scale, corners[1] * scale, corners[2] * scale];
        let exact = |x: f64| Exact::new(x).unwrap();
        let [ax, ay, bx, by, px, py] = [a.x, a.y, b.x, b.y, p.x, p.y].map(exact);
        let (down, up) = ((&bx - &ax) * (&py - &ay), (&by - &ay) * (&px - &ax));
        let error = (exact(edge_function(a, b, p)) - (&down - &up)).abs();
        let bound = exact(2.01 * f64::EPSILON) * (down.abs() + up.abs());
        prop_assert!(error <= bound, "{} {}", error, bound);
    }

    /// Snapping is exact: ⌊x · 2ᵇ + ½⌋ / 2ᵇ without rounding, for every double and any number of bits.
    #[test]
    fn snapping_is_exact(x in ANY.prop_filter("finite", |x| x.is_finite()), near in -60..60i32, bits in 0..1100u32) {
        let scaled = |x: f64| libm::scalbn(x, -(bits as i32));
        let tie = f64::from(near) + 0.5;
        let ties = [tie.next_down(), tie, tie.next_up()].map(scaled);
        for x in [x, scaled(libm::scalbn(x, near - libm::ilogb(x).clamp(-1100, 1100)))].into_iter().chain(ties) {
            prop_assume!(x.is_finite());
            let up = Exact::new(x).unwrap() + Exact::power_of_two(-1 - i64::from(bits));
            // Down, where cutting off went up.
            let cut_off = up.truncated(bits);
            let step = Exact::power_of_two(-i64::from(bits));
            let exact = if cut_off > up { cut_off - step } else { cut_off };
            let found = snap(DVec2::splat(x), bits).x;
            prop_assert!(exact == found, "{:e} {}", x, bits);
        }
    }

    #[test]
    fn snapping_moves_half_a_step(x in -1e6..1e6f64, bits in 0..20u32) {
        let step = libm::scalbn(1.0, -(bits as i32));
        let snapped = snap(DVec2::splat(x), bits).x;
        prop_assert!((snapped - x).abs() <= step / 2.0);
        prop_assert_eq!((snapped / step).fract(), 0.0);
        prop_assert_eq!(snap(DVec2::splat(snapped), bits).x, snapped);
    }

    #[test]
    fn never_panics(v in [ANY; 6], width in any::<u32>(), height in 0..3000u32, bits in any::<u32>()) {
        let t = [0, 1, 2].map(|i| DVec2::new(v[2 * i], v[2 * i + 1]));
        let finite = t.iter().all(|p| p.is_finite());
        match cover(t, width, height) {
            Ok(spans) => {
                prop_assert!(finite);
                for span in spans.take(20) {
                    prop_assert!(!span.is_empty() && span.x.end <= width && span.y < height);
                }
            }
            Err(TriangleError::NotFinite { vertex, .. }) => prop_assert!(!t[vertex].is_finite()),
        }
        prop_assert_eq!(contains(t, t[0], EdgeRule::Open), false);
        let _ = (edge_function(t[0], t[1], t[2]), is_top_left(t[0], t[1]), snap(t[0], bits));
    }
}

#[test]
fn degenerate() {
    let m = f64::MAX;
    let cases = [
        ("a point", [(3.5, 3.5); 3]),
        ("an edge", [(0.5, 0.5), (0.5, 0.5), (7.5, 7.5)]),
        (
            "collinear through centres",
            [(0.5, 0.5), (3.5, 3.5), (7.5, 7.5)],
        ),
        ("a row of centres", [(0.5, 2.5), (3.5, 2.5), (7.5, 2.5)]),
        ("a column of centres", [(2.5, 0.5), (2.5, 3.5), (2.5, 7.5)]),
        (
            "collinear over the whole range",
            [(-m, -m), (0.0, 0.0), (m, m)],
        ),
        ("subnormal", [(0.0, 0.0), (5e-324, 0.0), (0.0, 5e-324)]),
        ("above", [(0.0, -9.0), (9.0, -9.0), (0.0, 0.4)]),
        ("left", [(-9.0, 0.0), (0.4, 9.0), (-9.0, 9.0)]),
        ("right", [(8.0, 0.0), (1e9, 0.0), (8.0, 1e9)]),
    ];
    for (name, corners) in cases {
        assert_eq!(grid(triangle(corners), 8, 8), ["........"; 8], "{name}");
    }
    let everything = triangle([(-m, -m), (m, -m), (0.0, m)]);
    assert_eq!(grid(everything, 8, 2), ["########"; 2]);
    let mut rows = cover(everything, u32::MAX, u32::MAX).unwrap();
    assert_eq!(
        rows.next(),
        Some(Span {
            y: 0,
            x: 0..u32::MAX
        })
    );
    for (width, height) in [(0, 0), (0, u32::MAX), (u32::MAX, 0)] {
        assert!(
            cover(everything, width, height)
                .unwrap()
                .take(9)
                .next()
                .is_none()
        );
    }
    // At the far corner of the largest picture.
    let far = f64::from(u32::MAX);
    let corner = triangle([(far - 2.0, far - 2.0), (far, far - 2.0), (far - 2.0, far)]);
    let found = spans(corner, u32::MAX, u32::MAX);
    const M: u32 = u32::MAX;
    // Its slanted side runs through the centres (far − ½ − k, far − 3/2 + k), and as a right side leaves them out.
    assert_eq!(
        found,
        [Span {
            y: M - 2,
            x: M - 2..M - 1
        }]
    );
}

#[test]
fn snapping_ties_and_extremes() {
    let at = |x: f64, bits| snap(DVec2::splat(x), bits).x;
    // A tie goes up; 0.49…9 + ½ would round to 1.
    assert_eq!([at(0.5, 0), at(-0.5, 0), at(1.5, 0)], [1.0, 0.0, 2.0]);
    assert_eq!([at(0.375, 2), at(-0.375, 2)], [0.5, -0.25]);
    assert_eq!(at(0.5_f64.next_down(), 0), 0.0);
    for x in [0.1, 1e300, -f64::MAX, 5e-324] {
        assert_eq!(at(x, u32::MAX), x);
    }
    assert!(at(f64::NAN, 4).is_nan() && at(f64::INFINITY, 4) == f64::INFINITY);
}

#[test]
fn a_bad_vertex_is_named() {
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let error = cover(triangle([(0.0, 0.0), (2.0, bad), (0.0, 1.0)]), 4, 4)
            .err()
            .unwrap();
        assert_eq!(
            error.to_string(),
            format!("vertex 1 of the triangle is (2, {bad}): both coordinates must be finite")
        );
    }
    // The largest finite doubles are not bad, though their differences overflow.
    let nan = triangle([(f64::NAN, 0.0), (1.0, 0.0), (0.0, 1.0)]);
    assert!(
        cover_plain(nan, EdgeRule::TopLeft, 4, 4, &mut (), |_| {}).is_err()
            && !contains(nan, DVec2::ZERO, EdgeRule::Closed)
    );
}
