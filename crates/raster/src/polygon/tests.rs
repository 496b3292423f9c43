use super::*;
use ombra_math::work::Work;
use std::iter::once;

const RULES: [FillRule; 2] = [FillRule::EvenOdd, FillRule::NonZero];

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

fn plain(contours: &[Vec<DVec2>], rule: FillRule, width: u32, height: u32) -> Vec<Span> {
    let mut spans = Vec::new();
    fill_plain(contours, rule, width, height, &mut (), |span| {
        spans.push(span)
    })
    .unwrap();
    spans
}

/// The picture by both forms, which must agree.
fn grid(contours: &[Vec<DVec2>], rule: FillRule, width: u32, height: u32) -> Vec<String> {
    let fast = spans(contours, rule, width, height);
    assert_eq!(fast, plain(contours, rule, width, height));
    picture(fast, width, height)
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
fn beyond_the_left_border() {
    // Two rectangles that begin left of the picture: it begins wound round twice, and two edges are left to cross.
    let rectangle = |right| contour(&[(-4.0, 1.0), (right, 1.0), (right, 3.0), (-4.0, 3.0)]);
    let contours = [rectangle(3.0), rectangle(5.0)];
    let rows = |row| [".......", row, row, "......."];
    assert_eq!(grid(&contours, FillRule::NonZero, 7, 4), rows("#####.."));
    assert_eq!(grid(&contours, FillRule::EvenOdd, 7, 4), rows("...##.."));
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
        let spans = counted::fill(contours, FillRule::NonZero, width, height, &mut work)
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
    let spans = counted::fill(&wedge, FillRule::EvenOdd, 40_000, 20_000, &mut work).unwrap();
    for (y, span) in (1..).zip(spans) {
        assert_eq!(span, Span { y, x: 0..3 * y });
    }
    assert_eq!(
        (work.fragments, work.exact_fallbacks),
        (3 * 9999 * 10_000 / 2, 9999)
    );
}

/// Edges that are stepped for longer than fixed point is trusted; each of their sides leans by less than a pixel in 10⁴ rows.
#[test]
fn edges_of_very_many_rows() {
    const HEIGHT: u32 = 200_000;
    let comb: Vec<_> = (0..24)
        .map(|i| {
            let y = if i % 2 == 0 { -0.3 } else { 199_999.8 };
            DVec2::new(10.0 + 8.3 * f64::from(i), y)
        })
        .collect();
    let table = edge_table(std::slice::from_ref(&comb), HEIGHT).unwrap();
    let mut found = spans(&[comb], FillRule::NonZero, 180, HEIGHT)
        .into_iter()
        .peekable();
    for y in 0..HEIGHT {
        let row: Vec<_> = std::iter::from_fn(|| found.next_if(|span| span.y == y))
            .map(|span| span.x)
            .collect();
        // One row in 97, and the rows about every 2¹⁶.
        if y % 97 == 0 || (y + 2) % (1 << 16) < 4 {
            let crossings = active_edges(&table, y, 180);
            assert_eq!(
                row,
                spans_between(&crossings, FillRule::NonZero, 180),
                "row {y}"
            );
        }
    }
    assert_eq!(found.next(), None);
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

/// Crossings that are not numbers have a place in the order too, the last of their column.
#[test]
fn records_with_nan_are_ordered() {
    let edge = |x: f64| Edge {
        top: DVec2::new(x, 0.0),
        bottom: DVec2::new(x, 9.0),
        winding: 1,
        rows: 0..9,
    };
    // All in column 0: 0.3, 0.2, 0.1 and NaN in turn.
    let table: Vec<_> = (0..100)
        .map(|i| edge([0.3, f64::NAN, 0.2, f64::NAN, 0.1][i % 5]))
        .collect();
    let x: Vec<_> = active_edges(&table, 4, 5)
        .iter()
        .map(|crossing| crossing.x)
        .collect();
    let numbers = x.iter().take_while(|x| !x.is_nan()).count();
    assert!(
        numbers == 60 && x[..numbers].is_sorted() && x[numbers..].iter().all(|x| x.is_nan()),
        "{x:?}"
    );
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
        assert!(fill_plain(&contours, FillRule::EvenOdd, 4, 4, &mut (), |_| {}).is_err());
        assert!(edge_table(&contours, 4).is_err());
    }
}

mod outline;
mod properties;
