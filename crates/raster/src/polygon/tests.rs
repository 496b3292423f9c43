use super::*;
use num_bigint::BigInt;
use num_rational::BigRational;
use ombra_math::work::Work;
use proptest::num::f64::ANY;
use proptest::prelude::*;
use std::iter::once;

const RULES: [FillRule; 2] = [FillRule::EvenOdd, FillRule::NonZero];

type Contours = Vec<Vec<DVec2>>;

fn contour(vertices: &[(f64, f64)]) -> Vec<DVec2> {
    vertices.iter().copied().map(DVec2::from).collect()
}

fn spans(contours: &[Vec<DVec2>], rule: FillRule, width: u32, height: u32) -> Vec<Span> {
    fill(contours, rule, width, height).unwrap().collect()
}

fn picture(spans: impl IntoIterator<Item = Span>, width: u32, height: u32) -> Vec<String> {
    let mut rows = vec![vec!['.'; width as usize]; height as usize];
    for pixel in spans.into_iter().flat_map(|span| span.pixels()) {
        let cell = &mut rows[pixel.y as usize][pixel.x as usize];
        assert_eq!(*cell, '.', "{pixel} is filled twice");
        *cell = '#';
    }
    rows.into_iter().map(String::from_iter).collect()
}

/// The picture by both forms, which must agree.
fn grid(contours: &[Vec<DVec2>], rule: FillRule, width: u32, height: u32) -> Vec<String> {
    let fast = spans(contours, rule, width, height);
    let plain: Vec<_> = fill_plain(contours, rule, width, height).unwrap().collect();
    assert_eq!(fast, plain);
    picture(fast, width, height)
}

/// 2¹⁶⁰⁰ x, an integer.
fn integer(x: f64) -> BigInt {
    let x: BigRational = BigRational::from_float(x).unwrap() * (BigInt::from(1) << 60usize);
    assert!(x.is_integer());
    x.to_integer() << 1540usize
}

/// The winding number of a centre, really shifted: by 2⁻⁴⁰⁰ to the right and 2⁻⁸⁰⁰ down. For coordinates that are
/// multiples of 2⁻⁶⁰ below 2⁸⁰ no edge passes between the centre and there, so nothing here can be a tie.
fn winding_oracle(contours: &[Vec<[BigInt; 2]>], column: u32, row: u32) -> i64 {
    let shift = |bits: usize| BigInt::from(1) << (1600 - bits);
    let x = integer(f64::from(column) + 0.5) + shift(400);
    let y = integer(f64::from(row) + 0.5) + shift(800);
    let mut winding = 0;
    for vertices in contours {
        for (i, [ax, ay]) in vertices.iter().enumerate() {
            let [bx, by] = &vertices[(i + 1) % vertices.len()];
            assert!(*ay != y && *by != y);
            if (*ay < y) == (*by < y) {
                continue;
            }
            let side = (bx - ax) * (&y - ay) - (by - ay) * (&x - ax);
            assert!(side != BigInt::from(0));
            let down = by > ay;
            if (side < BigInt::from(0)) == down {
                winding += if down { 1 } else { -1 };
            }
        }
    }
    winding
}

fn oracle(contours: &[Vec<DVec2>], rule: FillRule, width: u32, height: u32) -> Vec<String> {
    let contours: Vec<Vec<_>> = contours
        .iter()
        .map(|contour| contour.iter().map(|v| v.to_array().map(integer)).collect())
        .collect();
    let cell = |x, y| match rule {
        FillRule::EvenOdd => winding_oracle(&contours, x, y) % 2 != 0,
        FillRule::NonZero => winding_oracle(&contours, x, y) != 0,
    };
    let row = |y| {
        (0..width)
            .map(|x| if cell(x, y) { '#' } else { '.' })
            .collect()
    };
    (0..height).map(row).collect()
}

// The lecture's kinds, as pictures worked out by hand.

#[test]
fn convex() {
    let house = contour(&[(0.0, 0.0), (6.0, 0.0), (6.0, 3.0), (3.0, 6.0), (0.0, 3.0)]);
    // The slanted sides run through centres: those of the left side are in, those of the right side out.
    let expected = [
        "######.", "######.", "######.", "#####..", ".###...", "..#....",
    ];
    for rule in RULES {
        assert_eq!(grid(std::slice::from_ref(&house), rule, 7, 6), expected);
    }
}

#[test]
fn concave() {
    let fork = contour(&[
        (0.0, 0.0),
        (7.0, 0.0),
        (7.0, 5.0),
        (5.0, 5.0),
        (5.0, 2.0),
        (2.0, 2.0),
        (2.0, 5.0),
        (0.0, 5.0),
    ]);
    let expected = ["#######.", "#######.", "##...##.", "##...##.", "##...##."];
    for rule in RULES {
        assert_eq!(grid(std::slice::from_ref(&fork), rule, 8, 5), expected);
    }
}

#[test]
fn self_intersecting() {
    // The halves of a bow tie run in opposite directions: both rules take both. Row j is crossed at 0, j + ½,
    // 7½ − j and 8; the centres on the diagonals belong to what lies right of them.
    let bow = contour(&[(0.0, 0.0), (8.0, 8.0), (8.0, 0.0), (0.0, 8.0)]);
    let upper = [".......#", "#.....##", "##...###", "###.####"];
    let expected: Vec<_> = upper.into_iter().chain(upper.into_iter().rev()).collect();
    for rule in RULES {
        assert_eq!(grid(std::slice::from_ref(&bow), rule, 8, 8), expected);
    }
}

#[test]
fn wound_twice() {
    // A square gone round twice: nothing for even-odd.
    let once = [(1.0, 1.0), (4.0, 1.0), (4.0, 3.0), (1.0, 3.0)];
    let twice = [contour(&[once, once].concat())];
    assert_eq!(grid(&twice, FillRule::EvenOdd, 5, 4), ["....."; 4]);
    assert_eq!(
        grid(&twice, FillRule::NonZero, 5, 4),
        [".....", ".###.", ".###.", "....."]
    );
}

#[test]
fn several_contours() {
    let square = |a: f64, b: f64| contour(&[(a, a), (b, a), (b, b), (a, b)]);
    let mut hole = square(2.0, 4.0);
    let ring = ["######", "######", "##..##", "##..##", "######", "######"];
    // In the same direction the hole counts for even-odd alone; turned round, for both.
    let contours = [square(0.0, 6.0), hole.clone()];
    assert_eq!(grid(&contours, FillRule::EvenOdd, 6, 6), ring);
    assert_eq!(grid(&contours, FillRule::NonZero, 6, 6), ["######"; 6]);
    hole.reverse();
    let contours = [square(0.0, 6.0), hole];
    assert_eq!(grid(&contours, FillRule::EvenOdd, 6, 6), ring);
    assert_eq!(grid(&contours, FillRule::NonZero, 6, 6), ring);
}

#[test]
fn centres_on_edges_and_vertices() {
    // A square with its sides through centres takes its top and left ones, as often as its area says.
    let square = [contour(&[(1.5, 0.5), (3.5, 0.5), (3.5, 2.5), (1.5, 2.5)])];
    assert_eq!(
        grid(&square, FillRule::NonZero, 5, 4),
        [".##..", ".##..", ".....", "....."]
    );
    // Of a diamond with its corners on centres, the left corner is in and the others are not: the shift to the
    // right counts more than the shift down.
    let diamond = [contour(&[(2.5, 0.5), (4.5, 2.5), (2.5, 4.5), (0.5, 2.5)])];
    let expected = [".....", ".##..", "####.", ".##..", "....."];
    assert_eq!(grid(&diamond, FillRule::NonZero, 5, 5), expected);
}

#[test]
fn edge_table_and_active_edges() {
    let fork = contour(&[(0.0, 2.0), (4.0, 0.0), (4.0, 4.0), (8.0, 0.0), (8.0, 6.0)]);
    let table = edge_table(&[fork], 8).unwrap();
    let records: Vec<_> = table
        .iter()
        .map(|e| (e.rows.clone(), e.winding, e.top.x, e.bottom.x))
        .collect();
    assert_eq!(
        records,
        [
            (0..2, -1, 4.0, 0.0), // (0, 2) → (4, 0)
            (0..4, 1, 4.0, 4.0),
            (0..4, -1, 8.0, 4.0),
            (0..6, 1, 8.0, 8.0),
            (2..6, -1, 0.0, 8.0), // the closing edge (8, 6) → (0, 2)
        ]
    );
    let crossings = active_edges(&table, 3, 10);
    // y = 3.5: the closing edge at 2 · 1.5 = 3, then 4, 4.5 and 8.
    let found: Vec<_> = crossings
        .iter()
        .map(|c| (c.edge, c.x, c.column, c.winding))
        .collect();
    assert_eq!(
        found,
        [
            (4, 3.0, 3, -1),
            (1, 4.0, 4, 1),
            (2, 4.5, 4, -1),
            (3, 8.0, 8, 1)
        ]
    );
    assert!(
        spans_between(&crossings, FillRule::EvenOdd, 10)
            .into_iter()
            .eq(once(3..8))
    );
    assert!(
        spans_between(&crossings, FillRule::EvenOdd, 6)
            .into_iter()
            .eq(once(3..6))
    );
    assert!(active_edges(&table, 6, 10).is_empty());
}

/// A coordinate about a picture of 8 pixels, a multiple of 2⁻⁶⁰ below 2⁸⁰: on centres, within 10⁻¹² of them, between
/// them, and far away.
fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![
        3 => (-2i32..11).prop_map(|k| f64::from(k) + 0.5),
        3 => (-2i32..11, -4i32..5).prop_map(|(k, m)| f64::from(k) + 0.5 + f64::from(m) * libm::scalbn(1.0, -43)),
        2 => (-8i32..44).prop_map(|k| f64::from(k) / 4.0),
        2 => (-3.0..11.0f64).prop_map(|x| (x * libm::scalbn(1.0, 45)).floor() * libm::scalbn(1.0, -45)),
        1 => (-9i32..10).prop_map(|k| f64::from(k) * 1e9),
        1 => (-9i32..10).prop_map(|k| f64::from(k) * libm::scalbn(1.0, 70)),
    ]
}

fn contours(vertices: Range<usize>) -> impl Strategy<Value = Contours> {
    let vertex = [coordinate(), coordinate()].prop_map(DVec2::from_array);
    prop::collection::vec(prop::collection::vec(vertex, vertices), 0..3)
}

/// Any finite double, or one at a scale where slopes through the picture occur.
fn finite() -> impl Strategy<Value = f64> {
    prop_oneof![
        1 => ANY.prop_filter("finite", |x| x.is_finite()),
        2 => coordinate(),
        1 => (-9i32..10).prop_map(|k| f64::from(k) * 1e300),
        1 => (-9i32..10).prop_map(|k| f64::from(k) * 1e-300),
        1 => (-9i32..10, 1u64..1 << 40).prop_map(|(k, m)| f64::from(k) * libm::scalbn(1.0, 33) + m as f64),
    ]
}

fn any_contours(vertices: Range<usize>) -> impl Strategy<Value = Contours> {
    let vertex = [finite(), finite()].prop_map(DVec2::from_array);
    prop::collection::vec(prop::collection::vec(vertex, vertices), 0..3)
}

/// Spans in order, not empty, in the picture, and none touching the next.
fn are_in_form(spans: &[Span], width: u32, height: u32) -> bool {
    let each = spans
        .iter()
        .all(|span| !span.is_empty() && span.x.end <= width && span.y < height);
    each && spans
        .windows(2)
        .all(|pair| (pair[0].y, pair[0].x.end) < (pair[1].y, pair[1].x.start))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn agrees_with_a_real_shift(contours in contours(0..9)) {
        for rule in RULES {
            let found = grid(&contours, rule, 8, 8);
            prop_assert_eq!(found, oracle(&contours, rule, 8, 8), "{:?}", rule);
        }
    }

    #[test]
    fn forms_agree_at_every_scale(contours in any_contours(0..9), width in 0..20u32, height in 0..20u32) {
        for rule in RULES {
            let fast = spans(&contours, rule, width, height);
            let plain: Vec<_> = fill_plain(&contours, rule, width, height).unwrap().collect();
            prop_assert!(are_in_form(&fast, width, height));
            prop_assert_eq!(fast, plain);
        }
    }

    /// Neither the vertex a contour begins with, nor the order of contours, nor all directions turned count.
    #[test]
    fn only_the_contours_count(contours in contours(1..9), turn in 0..9usize) {
        let mut other = contours.clone();
        other.reverse();
        for contour in &mut other {
            let turn = turn % contour.len();
            contour.rotate_left(turn);
            contour.reverse();
        }
        for rule in RULES {
            prop_assert_eq!(spans(&contours, rule, 8, 8), spans(&other, rule, 8, 8));
        }
    }

    /// A picture further right and down is the same, moved: the corner of the largest picture.
    #[test]
    fn moves_with_the_picture(vertices in prop::collection::vec([0..40i32, 0..40], 3..8)) {
        let at = |offset: f64| -> Contours {
            vec![vertices.iter().map(|&[x, y]| DVec2::new(f64::from(x), f64::from(y)) / 4.0 + offset).collect()]
        };
        const FAR: u32 = u32::MAX - 10;
        for rule in RULES {
            let near = spans(&at(0.0), rule, 10, 10);
            let far = spans(&at(f64::from(FAR)), rule, u32::MAX, u32::MAX);
            let moved: Vec<_> = far
                .iter()
                .map(|span| Span { y: span.y - FAR, x: span.x.start - FAR..span.x.end - FAR })
                .collect();
            prop_assert_eq!(near, moved);
        }
    }

    #[test]
    fn never_panics(vertices in prop::collection::vec([ANY, ANY], 0..12), width in any::<u32>(), height in 0..3000u32) {
        let contours = [vertices.into_iter().map(DVec2::from_array).collect::<Vec<_>>()];
        for rule in RULES {
            match fill(&contours, rule, width, height) {
                Ok(spans) => {
                    let spans: Vec<_> = spans.take(20).collect();
                    prop_assert!(are_in_form(&spans, width, height));
                }
                Err(PolygonError::NotFinite { contour, vertex, .. }) => {
                    prop_assert!(!contours[contour][vertex].is_finite());
                    prop_assert!(contours[contour][..vertex].iter().all(|v| v.is_finite()));
                }
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]

    /// So many edges that a band is marked, in a narrow picture; in a wide one crossings are sorted.
    #[test]
    fn forms_agree_with_many_edges(contours in any_contours(20..60), scale in prop_oneof![Just(1.0), Just(9.7)],
                                   wide in any::<bool>()) {
        let contours: Contours = contours.iter().map(|c| c.iter().map(|&v| v * scale).collect()).collect();
        prop_assume!(contours.iter().flatten().all(|v| v.is_finite()));
        let width = if wide { marks::WIDEST + 1 } else { 83 };
        for rule in RULES {
            let fast = spans(&contours, rule, width, 90);
            let plain: Vec<_> = fill_plain(&contours, rule, width, 90).unwrap().collect();
            prop_assert!(are_in_form(&fast, width, 90));
            prop_assert_eq!(fast, plain);
        }
    }
}

#[test]
fn a_disc_has_its_area() {
    let disc: Vec<_> = (0..1000)
        .map(|i| {
            let (sin, cos) = libm::sincos(f64::from(i) * std::f64::consts::TAU / 1000.0);
            DVec2::new(100.0 + 90.3 * cos, 100.0 + 90.3 * sin)
        })
        .collect();
    let pixels: u32 = spans(&[disc], FillRule::NonZero, 200, 200)
        .iter()
        .map(Span::len)
        .sum();
    let area = 500.0 * 90.3 * 90.3 * libm::sin(std::f64::consts::TAU / 1000.0);
    // The error of counting centres in a disc of radius r is far below its circumference.
    assert!(
        (f64::from(pixels) - area).abs() < 90.0,
        "{pixels} for {area}"
    );
}

#[test]
fn cost_follows_edges_and_crossings() {
    let counted = |contours: &[Vec<DVec2>], width, height| {
        let mut work = Work::default();
        let spans = fill_counted(contours, FillRule::NonZero, width, height, &mut work)
            .unwrap()
            .count();
        (work, spans)
    };
    // A comb of 10⁵ teeth, 2·10⁹ tall: all edges cross all of the 100 rows, none costs more.
    let comb: Vec<_> = (0..100_000)
        .map(|i| {
            DVec2::new(
                1.0 + f64::from(i) * 98e-5,
                if i % 2 == 0 { -1e9 } else { 1e9 },
            )
        })
        .collect();
    let (work, _) = counted(&[comb], 100, 100);
    assert_eq!((work.vertices, work.edge_records), (100_000, 100_000 * 101));

    // 10⁵ edges round a disc: only those that cross a row of centres count, and the spans' ends.
    let disc: Vec<_> = (0..100_000)
        .map(|i| {
            let (sin, cos) = libm::sincos(f64::from(i) * std::f64::consts::TAU / 1e5);
            DVec2::new(50.0 + 40.2 * cos, 50.0 + 40.2 * sin)
        })
        .collect();
    let (work, spans) = counted(&[disc], 100, 100);
    assert_eq!((spans, work.edge_records), (80, 160 + 160));

    // The same comb left of the picture, right of it, above and below: no row is walked along.
    let comb = |x: f64, y: f64| -> Vec<_> {
        (0..100_000)
            .map(|i| DVec2::new(x + f64::from(i), if i % 2 == 0 { y - 1e8 } else { y + 1e8 }))
            .collect()
    };
    for (x, y, records) in [
        (-1e6, 0.0, 100_000),
        (1e6, 0.0, 100_000),
        (0.0, -1e9, 0),
        (0.0, 1e9, 0),
    ] {
        let (work, spans) = counted(&[comb(x, y)], 100, 100);
        assert_eq!(
            (work.edge_records, work.fragments, spans),
            (records, 0, 0),
            "{x} {y}"
        );
    }

    // A small triangle low in the tallest picture: the rows above cost nothing.
    let low = contour(&[(1.0, 4e9), (4.0, 4e9), (1.0, 4e9 + 3.0)]);
    let (work, spans) = counted(&[low], 100, u32::MAX);
    // Its slanted side runs through centres, as a right one: 2, 1 and 0 pixels.
    assert_eq!((spans, work.fragments, work.edge_records), (2, 3, 2 + 6));
}

#[test]
fn rounding_is_settled_exactly() {
    // A side through a centre in each of 10⁴ rows: rounding alone would lose some. In the first row that is the
    // leftmost centre, and nothing to decide.
    let wedge = [contour(&[
        (0.5, 0.5),
        (30_000.5, 10_000.5),
        (0.5, 10_000.5),
    ])];
    let mut work = Work::default();
    let spans = fill_counted(&wedge, FillRule::EvenOdd, 40_000, 20_000, &mut work).unwrap();
    for (y, span) in (1..).zip(spans) {
        assert_eq!(span, Span { y, x: 0..3 * y });
    }
    assert_eq!(
        (work.fragments, work.exact_fallbacks),
        (3 * 9999 * 10_000 / 2, 9999)
    );
}

#[test]
fn degenerate() {
    let point = (3.5, 3.5);
    let cases: [(&str, Vec<(f64, f64)>); 9] = [
        ("no vertex", vec![]),
        ("one vertex", vec![point]),
        ("one vertex, thrice", vec![point; 3]),
        ("an edge there and back", vec![(0.0, 0.0), (9.0, 8.0)]),
        (
            "a horizontal line",
            vec![(0.0, 2.5), (9.0, 2.5), (4.0, 2.5)],
        ),
        ("a vertical line", vec![(2.5, 0.0), (2.5, 9.0), (2.5, 4.0)]),
        ("collinear", vec![(0.0, 0.0), (3.0, 3.0), (9.0, 9.0)]),
        (
            "between two rows",
            vec![(0.0, 0.6), (9.0, 0.6), (9.0, 1.4), (0.0, 1.4)],
        ),
        ("subnormal", vec![(0.0, 0.0), (5e-324, 0.0), (0.0, 5e-324)]),
    ];
    for (name, vertices) in cases {
        for rule in RULES {
            assert!(
                spans(&[contour(&vertices)], rule, 8, 8).is_empty(),
                "{name}"
            );
        }
    }
    let square = [contour(&[(0.0, 0.0), (8.0, 0.0), (8.0, 8.0), (0.0, 8.0)])];
    let repeated = [contour(&[
        (0.0, 0.0),
        (0.0, 0.0),
        (8.0, 0.0),
        (8.0, 8.0),
        (8.0, 8.0),
        (0.0, 8.0),
        (0.0, 0.0),
    ])];
    let m = f64::MAX;
    let everything = [contour(&[(-m, -m), (m, -m), (m, m), (-m, m)])];
    for rule in RULES {
        assert_eq!(spans(&square, rule, 8, 8), spans(&repeated, rule, 8, 8));
        assert_eq!(grid(&everything, rule, 3, 2), ["###"; 2]);
        for (width, height) in [(0, 0), (0, 9), (9, 0), (0, u32::MAX), (u32::MAX, 0)] {
            assert!(spans(&square, rule, width, height).is_empty());
            assert!(spans(&everything, rule, width, height).is_empty());
        }
        // Spans as they are asked for: 2⁶⁴ pixels take no memory.
        let mut all = fill(&everything, rule, u32::MAX, u32::MAX).unwrap();
        assert_eq!(
            all.next(),
            Some(Span {
                y: 0,
                x: 0..u32::MAX
            })
        );
        assert_eq!(
            all.next(),
            Some(Span {
                y: 1,
                x: 0..u32::MAX
            })
        );
    }
    assert!(spans(&[], FillRule::NonZero, 8, 8).is_empty());
}

#[test]
fn a_bad_vertex_is_named() {
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let good = contour(&[(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)]);
        let mut broken = good.clone();
        broken[2].x = bad;
        let contours = [good, broken];
        let error = fill(&contours, FillRule::EvenOdd, 4, 4).err().unwrap();
        assert_eq!(
            error.to_string(),
            format!("vertex 2 of contour 1 is ({bad}, 1): both coordinates must be finite")
        );
        assert!(fill_plain(&contours, FillRule::EvenOdd, 4, 4).is_err());
        assert!(edge_table(&contours, 4).is_err());
    }
}

mod outlines {
    use super::*;

    fn pixels(vertices: &[(i32, i32)]) -> Vec<(i32, i32)> {
        let vertices: Vec<_> = vertices.iter().copied().map(IVec2::from).collect();
        outline(&vertices).map(|p| (p.x, p.y)).collect()
    }

    #[test]
    fn a_square_has_each_pixel_once() {
        let found = pixels(&[(1, 1), (4, 1), (4, 3), (1, 3)]);
        let round = [
            (1, 1),
            (2, 1),
            (3, 1),
            (4, 1),
            (4, 2),
            (4, 3),
            (3, 3),
            (2, 3),
            (1, 3),
            (1, 2),
        ];
        assert_eq!(found, round);
    }

    #[test]
    fn degenerate() {
        assert_eq!(pixels(&[]), []);
        assert_eq!(pixels(&[(5, -2)]), [(5, -2)]);
        assert_eq!(pixels(&[(5, -2); 4]), [(5, -2)]);
        // There and back, both ends once.
        assert_eq!(pixels(&[(0, 0), (2, 0)]), [(0, 0), (1, 0), (2, 0), (1, 0)]);
        assert_eq!(
            pixels(&[(0, 0), (0, 0), (2, 0), (2, 0)]),
            [(0, 0), (1, 0), (2, 0), (1, 0)]
        );
        let (min, max) = (i32::MIN, i32::MAX);
        let found: Vec<_> = outline(&[IVec2::new(min, min), IVec2::new(max, max)])
            .take(2)
            .collect();
        assert_eq!(found, [IVec2::splat(min), IVec2::splat(min + 1)]);
    }

    proptest! {
        /// A closed chain: each pixel beside the next, the last beside the first, as many as the edges' steps.
        #[test]
        fn is_a_closed_chain(vertices in prop::collection::vec([-20..20i32, -20..20], 1..8)) {
            let vertices: Vec<_> = vertices.into_iter().map(IVec2::from_array).collect();
            let chain: Vec<_> = outline(&vertices).collect();
            let steps: i32 = (0..vertices.len())
                .map(|i| (vertices[(i + 1) % vertices.len()] - vertices[i]).abs().max_element())
                .sum();
            prop_assert_eq!(chain.len(), steps.max(1) as usize);
            prop_assert_eq!(chain[0], vertices[0]);
            if chain.len() > 1 {
                for (i, pixel) in chain.iter().enumerate() {
                    prop_assert_eq!((*pixel - chain[(i + 1) % chain.len()]).abs().max_element(), 1);
                }
            }
            prop_assert!(vertices.iter().all(|vertex| chain.contains(vertex)));
        }
    }
}
