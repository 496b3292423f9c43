//! The lectures' numbers for segments, rectangles and clipping, from every function that answers them; methods that
//! answer one question against each other; and triangles against exact numbers, pixel by pixel.
#![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use std::collections::BTreeSet;

use ombra_clip::{
    Segment, Window, cohen_sutherland, cyrus_beck, direct, liang_barsky, pieces, sutherland_hodgman,
};
use ombra_math::glam::{DVec2, IVec2};
use ombra_oracle::Exact;
use ombra_raster::bresenham::Choice::{E, NE};
use ombra_raster::polygon::FillRule;
use ombra_raster::span::Span;
use ombra_raster::triangle::EdgeRule;
use ombra_raster::{analytic, bresenham, dda, polygon, rectangle, triangle};
use ombra_tests::cases::Random;
use ombra_tests::clipping::{doubled_area, of_segment};
use ombra_tests::pixel;

/// Every function that draws a segment, by name.
fn segments(a: IVec2, b: IVec2) -> [(&'static str, Vec<IVec2>); 6] {
    // A picture of its own, with a border, for the one that draws.
    let (least, size) = (a.min(b) - 1, (a - b).abs() + 3);
    let mut picture = vec![b'.'; (size.x * size.y) as usize];
    bresenham::draw(&mut picture, size.x as usize, a - least, b - least, b'#');
    let mut drawn: Vec<IVec2> = (0..size.x * size.y)
        .filter(|&i| picture[i as usize] == b'#')
        .map(|i| IVec2::new(i % size.x, i / size.x) + least)
        .collect();
    drawn.sort_by_key(|&p| pixel::moves_to(a, b, p));
    [
        ("analytic", analytic::segment(a, b).collect()),
        ("dda", dda::segment(a, b).collect()),
        ("dda in f32", dda::segment_f32(a, b).collect()),
        ("bresenham", bresenham::segment(a, b).collect()),
        (
            "clipped to i32",
            bresenham::clipped(a, b, IVec2::MIN, IVec2::MAX).collect(),
        ),
        ("drawn", drawn),
    ]
}

/// Grafica 3: (0,0)→(8,3), and the same segment turned and mirrored into the other octants.
#[test]
fn the_lectures_segment() {
    let y = [0, 0, 1, 1, 1, 2, 2, 3, 3];
    let slide: Vec<IVec2> = (0..).zip(y).map(|(x, y)| IVec2::new(x, y)).collect();
    for octant in 0..8 {
        let start = IVec2::new(100, -7);
        let turned = |p: IVec2| {
            let p = if octant & 1 == 0 {
                p
            } else {
                IVec2::new(p.y, p.x)
            };
            let mirror = |bit: i32| if octant & bit == 0 { 1 } else { -1 };
            start + p * IVec2::new(mirror(2), mirror(4))
        };
        let expected: Vec<IVec2> = slide.iter().copied().map(turned).collect();
        let b = turned(IVec2::new(8, 3));
        for (name, pixels) in segments(start, b) {
            assert_eq!(pixels, expected, "{name}, octant {octant}");
        }
        let (decisions, choices): (Vec<i64>, Vec<_>) = bresenham::trace(start, b)
            .map(|step| (step.decision, step.choice))
            .unzip();
        assert_eq!(decisions, [-2, 4, -6, 0, 6, -4, 2, -8], "octant {octant}");
        assert_eq!(choices, [E, NE, E, E, NE, E, NE, E], "octant {octant}");
    }
}

/// Every way to draw a segment gives the pixels of the definition, ties included: all segments with |dx|, |dy| ≤ 20,
/// and random ones as long as f32's sums allow.
#[test]
fn segments_are_the_nearest_pixels() {
    let mut random = Random::new(31);
    let short = (-20..=20).flat_map(|x| (-20..=20).map(move |y| IVec2::new(x, y)));
    let long = (0..2000).map(|_| {
        let mut coordinate = || random.below(2 * 298 + 1) as i32 - 298;
        IVec2::new(coordinate(), coordinate())
    });
    let (mut ties, mut pixels) = (0, 0);
    for d in short.chain(long).collect::<Vec<_>>() {
        let a = IVec2::new(d.y * 3 - 11, 5);
        let expected = pixel::of_segment(a, a + d);
        for (name, found) in segments(a, a + d) {
            assert_eq!(found, expected, "{name}, {a}→{}", a + d);
        }
        pixels += expected.len();
        ties += (0..)
            .zip(&expected)
            .filter(|&(i, _)| pixel::is_tie(a, a + d, i))
            .count();
    }
    assert!(ties > 1000 && pixels > 100_000, "{ties} {pixels}");
}

/// Grafica 3: (2,1)–(6,4), each corner once.
#[test]
fn the_lectures_rectangle() {
    let (min, max) = (IVec2::new(2, 1), IVec2::new(6, 4));
    let sets: [Vec<IVec2>; 2] = [
        rectangle::outline(min, max).collect(),
        rectangle::fill(min, max).collect(),
    ];
    for (pixels, count) in sets.iter().zip([14, 20]) {
        let once: BTreeSet<[i32; 2]> = pixels.iter().map(|p| p.to_array()).collect();
        assert_eq!((pixels.len(), once.len()), (count, count));
    }
    // The outline is that of the polygon through the corners, and the inside that of the polygon round the pixels.
    let corners = [min, IVec2::new(max.x, min.y), max, IVec2::new(min.x, max.y)];
    assert_eq!(polygon::outline(&corners).collect::<Vec<_>>(), sets[0]);
    let round = [(2.0, 1.0), (7.0, 1.0), (7.0, 5.0), (2.0, 5.0)].map(DVec2::from);
    let spans = polygon::fill(&[round.to_vec()], FillRule::NonZero, 20, 20).unwrap();
    let inside: Vec<IVec2> = spans
        .flat_map(|span| span.pixels())
        .map(|p| p.as_ivec2())
        .collect();
    assert_eq!(inside, sets[1]);
}

type ClipSegment = fn(&Window, Segment) -> Option<Segment>;

const METHODS: [(&str, ClipSegment); 4] = [
    ("direct", direct::clip_segment),
    ("Cohen–Sutherland", cohen_sutherland::clip_segment),
    ("Liang–Barsky", liang_barsky::clip_segment),
    ("Cyrus–Beck", |window, s| {
        cyrus_beck::clip_segment(&window.corners(), s)
    }),
];

fn segment(ax: f64, ay: f64, bx: f64, by: f64) -> Segment {
    Segment::new(DVec2::new(ax, ay), DVec2::new(bx, by))
}

fn tenth() -> Window {
    Window::new(DVec2::ZERO, DVec2::splat(10.0)).unwrap()
}

/// Grafica 3: the window 0…10.
#[test]
fn the_lectures_clipping() {
    let window = tenth();
    assert!(window.contains(DVec2::new(0.0, 10.0)));
    assert!(!window.contains(DVec2::new(10.000001, 5.0)));
    assert!(!window.contains(DVec2::new(f64::NAN, 5.0)));
    for (given, inside) in [
        (
            segment(-5.0, 5.0, 15.0, 5.0),
            Some(segment(0.0, 5.0, 10.0, 5.0)),
        ),
        (
            segment(2.0, 14.0, 8.0, -4.0),
            Some(segment(10.0 / 3.0, 10.0, 20.0 / 3.0, 0.0)),
        ),
        (segment(4.0, 14.0, 14.0, 8.0), None),
        // Along a side, and through one corner alone.
        (
            segment(-5.0, 10.0, 15.0, 10.0),
            Some(segment(0.0, 10.0, 10.0, 10.0)),
        ),
        (
            segment(-5.0, 5.0, 5.0, 15.0),
            Some(segment(0.0, 10.0, 0.0, 10.0)),
        ),
    ] {
        for (name, clip) in METHODS {
            assert_eq!(clip(&window, given), inside, "{name}, {given:?}");
        }
    }
    let code = |x, y| cohen_sutherland::outcode(&window, DVec2::new(x, y)).to_string();
    let regions = [11.0, 5.0, -1.0].map(|y| [-1.0, 5.0, 11.0].map(|x| code(x, y)));
    assert_eq!(
        regions,
        [
            ["1001", "1000", "1010"],
            ["0001", "0000", "0010"],
            ["0101", "0100", "0110"],
        ]
    );
    let triangle = [(5.0, 5.0), (15.0, 5.0), (5.0, 15.0)].map(DVec2::from);
    let square = [(5.0, 5.0), (10.0, 5.0), (10.0, 10.0), (5.0, 10.0)].map(DVec2::from);
    assert_eq!(sutherland_hodgman::clip_polygon(&window, &triangle), square);
    assert_eq!(pieces::clip_polygon(&window, &triangle).len(), 1);
    assert_eq!(doubled_area(&square).unwrap(), 50);
}

/// A window and a segment: of one scale anywhere in the range, of all scales at once, or on small whole numbers; half
/// of them led through a corner, or within 10⁻¹² of it.
fn window_and_segment(random: &mut Random) -> (Window, Segment) {
    let kind = random.below(3);
    let scale = random.exponential(-900, 900).abs();
    let mut number = || match kind {
        0 => scale * random.between(-2.0, 2.0),
        1 => random.exponential(-1000, 1000),
        _ => f64::from(random.below(9)) - 4.0,
    };
    let (p, q) = (
        DVec2::new(number(), number()),
        DVec2::new(number(), number()),
    );
    let window = Window::new(p.min(q), p.max(q)).unwrap();
    let mut s = segment(number(), number(), number(), number());
    if random.below(2) == 0 {
        let corner = window.corners()[random.below(4) as usize];
        let off = [0.0, 1e-16, 1e-12][random.below(3) as usize] * random.between(-4.0, 4.0);
        let stretch = [1.0, 0.5, 2.0, random.between(0.1, 4.0)][random.below(4) as usize];
        let b = corner + (corner - s.a) * stretch * (1.0 + off);
        if b.is_finite() {
            s.b = b;
        }
    }
    (window, s)
}

/// All four methods give the exact answer, bit for bit, over the whole range of doubles.
#[test]
fn four_methods_one_answer() {
    let mut random = Random::new(32);
    let (mut inside, mut points, mut outside) = (0, 0, 0);
    for _ in 0..30_000 {
        let (window, s) = window_and_segment(&mut random);
        let exact =
            of_segment([window.min, window.max], [s.a, s.b]).map(|[a, b]| Segment::new(a, b));
        for (name, clip) in METHODS {
            // A polygon without area has no inside for Cyrus and Beck.
            let flat = window.min.x == window.max.x || window.min.y == window.max.y;
            if name == "Cyrus–Beck" && flat {
                assert_eq!(clip(&window, s), None, "{name}: {window:?} {s:?}");
            } else {
                assert_eq!(clip(&window, s), exact, "{name}: {window:?} {s:?}");
            }
        }
        match exact {
            None => outside += 1,
            Some(s) if s.a == s.b => points += 1,
            Some(_) => inside += 1,
        }
    }
    assert!(
        inside > 3000 && points > 500 && outside > 3000,
        "{inside} {points} {outside}"
    );
}

/// One outline or separate pieces: the same area without any rounding, since they have the same new vertices, and
/// bridges have none.
#[test]
fn outline_and_pieces_have_one_area() {
    let mut random = Random::new(33);
    let (mut several, mut left) = (0, 0);
    for _ in 0..5000 {
        let whole = random.below(2) == 0;
        let corners = 3 + random.below(10);
        let polygon: Vec<DVec2> = (0..corners)
            .map(|_| {
                let mut number = || random.between(-8.0, 18.0);
                let p = DVec2::new(number(), number());
                if whole { p.round() } else { p }
            })
            .collect();
        let outline = sutherland_hodgman::clip_polygon(&tenth(), &polygon);
        let parts = pieces::clip_polygon(&tenth(), &polygon);
        let sum: Exact = parts.iter().map(|part| doubled_area(part).unwrap()).sum();
        let area = doubled_area(&outline).unwrap();
        assert_eq!(sum, area, "{polygon:?}\n{outline:?}\n{parts:?}");
        several += usize::from(parts.len() > 1);
        left += usize::from(!parts.is_empty());
    }
    assert!(several > 1000 && left > 3000, "{several} {left}");
}

const PICTURE: (u32, u32) = (12, 10);

/// A triangle about the picture: vertices anywhere, on multiples of ½, or within 10⁻¹² of collinear, and now and then
/// one very far away.
fn random_triangle(random: &mut Random) -> [DVec2; 3] {
    let halves = random.below(3) == 0;
    let mut t: [DVec2; 3] = core::array::from_fn(|_| {
        let mut number = || {
            let x = random.between(-4.0, 16.0);
            if halves { (x * 2.0).round() / 2.0 } else { x }
        };
        DVec2::new(number(), number())
    });
    match random.below(8) {
        // The third vertex on the line through the others, or beside it by some last places.
        0..=2 => {
            let along = [0.0, 0.5, 1.0, 2.0, random.between(-1.0, 2.0)][random.below(5) as usize];
            let off = [0.0, 1e-16, 1e-14, 1e-12][random.below(4) as usize];
            t[2] = t[0] + (t[1] - t[0]) * along;
            t[2].x += off * random.between(-4.0, 4.0);
        }
        // An edge through a centre, or beside it.
        3 | 4 => {
            let mut centre = || f64::from(random.below(10)) + 0.5;
            let through = DVec2::new(centre(), centre());
            let off = [0.0, 1e-16, 1e-12][random.below(3) as usize] * random.between(-4.0, 4.0);
            t[1] = through + (through - t[0]) * (1.0 + off);
        }
        5 => t[0] *= random.power_of_two(0, 990),
        _ => {}
    }
    t
}

fn grid(spans: impl Iterator<Item = Span>) -> Vec<[u32; 2]> {
    spans
        .flat_map(|span| span.pixels())
        .map(|p| p.to_array())
        .collect()
}

/// Triangles as triangles, as polygons and pixel by pixel: the same pixels exactly, and those of the definition.
#[test]
fn triangles_have_the_pixels_of_the_definition() {
    let (width, height) = PICTURE;
    let mut random = Random::new(34);
    let (mut owned, mut empty) = (0, 0);
    for _ in 0..4000 {
        let t = random_triangle(&mut random);
        let expected: Vec<[u32; 2]> = (0..height)
            .flat_map(|y| (0..width).map(move |x| [x, y]))
            .filter(|&[x, y]| pixel::in_triangle(t, x, y).unwrap())
            .collect();
        let contour = [t.to_vec()];
        assert_eq!(
            grid(triangle::cover(t, width, height).unwrap()),
            expected,
            "{t:?}"
        );
        let mut plain = Vec::new();
        triangle::cover_plain(t, EdgeRule::TopLeft, width, height, &mut (), |p| {
            plain.push(p.to_array());
        })
        .unwrap();
        assert_eq!(plain, expected, "{t:?}");
        for rule in [FillRule::EvenOdd, FillRule::NonZero] {
            let fill = polygon::fill(&contour, rule, width, height).unwrap();
            assert_eq!(grid(fill), expected, "{rule:?} {t:?}");
            let mut plain = Vec::new();
            polygon::fill_plain(&contour, rule, width, height, &mut (), |s| plain.push(s)).unwrap();
            assert_eq!(grid(plain.into_iter()), expected, "{rule:?} {t:?}");
        }
        owned += expected.len();
        empty += usize::from(expected.is_empty());
    }
    assert!(owned > 20_000 && empty > 500, "{owned} {empty}");
}

/// The two triangles on either side of an edge own each pixel of their quadrilateral once.
#[test]
fn a_shared_edge_has_one_owner() {
    let (width, height) = PICTURE;
    let mut random = Random::new(35);
    let mut on_the_edge = 0;
    for _ in 0..4000 {
        let [a, b, c] = random_triangle(&mut random);
        // d beyond the edge b c, as seen from a.
        let d = (b + c) * 0.5 + ((b + c) * 0.5 - a) * random.between(0.2, 2.0);
        let quadrilateral = [vec![a, b, d, c]];
        let two = [[a, b, c], [c, b, d]];
        let mut pixels: Vec<[u32; 2]> = two
            .iter()
            .flat_map(|&t| grid(triangle::cover(t, width, height).unwrap()))
            .collect();
        pixels.sort_unstable_by_key(|&[x, y]| (y, x));
        let signed = |t: &[DVec2]| doubled_area(t).unwrap().sign();
        if two.iter().any(|t| signed(t) != signed(&two[0])) || signed(&two[0]).is_eq() {
            // Rounding turned one of two slivers over: no quadrilateral.
            continue;
        }
        let whole = polygon::fill(&quadrilateral, FillRule::NonZero, width, height).unwrap();
        assert_eq!(pixels, grid(whole), "{a} {b} {c} {d}");
        on_the_edge += pixels
            .iter()
            .filter(|&&[x, y]| {
                let centre = DVec2::new(f64::from(x) + 0.5, f64::from(y) + 0.5);
                doubled_area(&[b, c, centre]).unwrap().is_zero()
            })
            .count();
    }
    assert!(on_the_edge > 100, "{on_the_edge}");
}
