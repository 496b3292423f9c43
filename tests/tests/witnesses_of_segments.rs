//! Other crates as witnesses of segments: hands that wrote the same answers independently of ours. Where a witness
//! differs, exact numbers say who is right, and what the witness gets wrong stands beside it.
#![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use ombra_clip::{Segment, Window, cohen_sutherland, cyrus_beck, direct, liang_barsky};
use ombra_math::glam::{DVec2, IVec2};
use ombra_raster::bresenham;
use ombra_tests::cases::Random;
use ombra_tests::clipping::of_segment;
use ombra_tests::pixel;

fn within(random: &mut Random, limit: i32) -> IVec2 {
    let span = 2 * limit.unsigned_abs() + 1;
    IVec2::new(
        random.below(span) as i32 - limit,
        random.below(span) as i32 - limit,
    )
}

/// How often the line meets a midpoint between two pixels, by the greatest common divisor g of dx and dy: g times if
/// dx/g is even, else never.
fn ties(a: IVec2, b: IVec2) -> usize {
    let d = (b - a).abs();
    let (run, rise) = (d.max_element(), d.min_element());
    let (mut g, mut rest) = (run, rise);
    while rest != 0 {
        (g, rest) = (rest, g % rest);
    }
    if run > 0 && (run / g) % 2 == 0 {
        g as usize
    } else {
        0
    }
}

/// `line_drawing::Midpoint` and `clipline` differ from ours at ties, at every tie and nowhere else: they take the pixel
/// farther from the start.
#[test]
fn segments_differ_at_ties_alone() {
    let mut random = Random::new(41);
    let (mut pixels, mut tied) = (0, 0);
    for _ in 0..4000 {
        let (a, b) = (within(&mut random, 200), within(&mut random, 200));
        let ours: Vec<IVec2> = bresenham::segment(a, b).collect();
        let [start, end] = [a, b].map(|p| (f64::from(p.x), f64::from(p.y)));
        let midpoint: Vec<IVec2> = line_drawing::Midpoint::<f64, i32>::new(start, end)
            .map(|(x, y)| IVec2::new(x, y))
            .collect();
        // clipline's segments leave out their last pixel.
        let mut clipline: Vec<IVec2> = clipline::LineB::<i32>::new(a.x, a.y, b.x, b.y)
            .map(|(x, y)| IVec2::new(x, y))
            .collect();
        clipline.push(b);
        for (name, theirs) in [("Midpoint", midpoint), ("clipline", clipline)] {
            assert_eq!(theirs.len(), ours.len(), "{name}, {a}→{b}");
            let mut differences = 0;
            for ((i, &p), &q) in (0..).zip(&ours).zip(&theirs) {
                let tie = pixel::is_tie(a, b, i);
                assert_eq!(p != q, tie, "{name}, {a}→{b}: {p} and {q}");
                if tie {
                    // The other of the two pixels that are half a pixel off.
                    let (offset, run) = pixel::doubled_offset(a, b, q);
                    assert_eq!(offset, run, "{name}, {a}→{b}: {q}");
                    assert!((q - a).length_squared() > (p - a).length_squared());
                }
                differences += usize::from(tie);
            }
            assert_eq!(differences, ties(a, b), "{name}, {a}→{b}");
        }
        pixels += ours.len();
        tied += ties(a, b);
    }
    assert!(pixels > 500_000 && tied > 1000, "{pixels} {tied}");
}

/// `line_drawing::Bresenham` cuts off where it should round: its error starts at dy − dx, without the half. Most of its
/// segments have a pixel more than half a pixel off the line. Ours and Midpoint's have none.
#[test]
fn one_witness_is_wrong() {
    let y: Vec<i32> = line_drawing::Bresenham::new((0, 0), (3, 1))
        .map(|p| p.1)
        .collect();
    assert_eq!(y, [0, 0, 0, 1]);
    // y = 2/3 at x = 2 is nearer to 1.
    let right: Vec<i32> = bresenham::segment(IVec2::ZERO, IVec2::new(3, 1))
        .map(|p| p.y)
        .collect();
    assert_eq!(right, [0, 0, 1, 1]);

    let mut random = Random::new(42);
    let mut wrong = [0; 3];
    let count = 5000;
    for _ in 0..count {
        let (a, b) = (within(&mut random, 50), within(&mut random, 50));
        let off = |p: IVec2| {
            let (offset, run) = pixel::doubled_offset(a, b, p);
            offset > run
        };
        let [start, end] = [a, b].map(|p| (f64::from(p.x), f64::from(p.y)));
        let any_off = [
            line_drawing::Bresenham::new((a.x, a.y), (b.x, b.y))
                .any(|(x, y)| off(IVec2::new(x, y))),
            line_drawing::Midpoint::<f64, i32>::new(start, end).any(|(x, y)| off(IVec2::new(x, y))),
            bresenham::segment(a, b).any(off),
        ];
        for (sum, any) in wrong.iter_mut().zip(any_off) {
            *sum += usize::from(any);
        }
        assert!(
            bresenham::segment(a, b).eq(pixel::of_segment(a, b)),
            "{a}→{b}"
        );
    }
    // More than nine in ten: all but those without a fraction above ½, the flat, the diagonal and the very short.
    assert!(
        wrong[0] > count * 9 / 10 && wrong[1..] == [0, 0],
        "{wrong:?}"
    );
}

/// Segments through a window of pixels: clipline's pixels but for ties, from small numbers to all of i32.
#[test]
fn clipped_segments_differ_at_ties_alone() {
    let mut random = Random::new(43);
    let (mut inside, mut tied) = (0, 0);
    for case in 0..40_000 {
        let point = |random: &mut Random| {
            if case % 2 == 0 {
                return within(random, 40);
            }
            let bits = random.bits();
            IVec2::new(bits as i32, (bits >> 32) as i32)
        };
        let (a, b) = (point(&mut random), point(&mut random));
        // On the line or near it, so that one in two of the far ones is met.
        let middle = (a.as_dvec2() * 0.5 + b.as_dvec2() * 0.5).as_ivec2();
        let corner = middle.saturating_add(within(&mut random, 30));
        let size = within(&mut random, 100).abs();
        let (min, max) = (corner, corner.saturating_add(size));

        let ours: Vec<IVec2> = bresenham::clipped(a, b, min, max).collect();
        let viewport = clipline::Viewport::<i32>::from_min_max(min.x, min.y, max.x, max.y).unwrap();
        let theirs: Vec<IVec2> = viewport
            .line_b(a.x, a.y, b.x, b.y)
            .into_iter()
            .flatten()
            .map(|(x, y)| IVec2::new(x, y))
            .chain((min.cmple(b).all() && b.cmple(max).all()).then_some(b))
            .collect();
        let untied = |pixels: &[IVec2]| -> Vec<IVec2> {
            let settled = |p: &&IVec2| !pixel::is_tie(a, b, pixel::moves_to(a, b, **p));
            pixels.iter().filter(settled).copied().collect()
        };
        assert_eq!(untied(&ours), untied(&theirs), "{a}→{b} in {min}…{max}");
        tied += ours.len() - untied(&ours).len();
        inside += ours.len();
    }
    assert!(inside > 200_000 && tied > 500, "{inside} {tied}");
}

fn clip_line(window: &Window, s: Segment) -> Option<Segment> {
    use line_clipping::{LineSegment, Point, Window as Rectangle};
    let line = LineSegment::new(Point::new(s.a.x, s.a.y), Point::new(s.b.x, s.b.y));
    let (min, max) = (window.min, window.max);
    let clipped = line_clipping::cohen_sutherland::clip_line(
        line,
        Rectangle::new(min.x, max.x, min.y, max.y),
    )?;
    let [a, b] = [clipped.p1, clipped.p2].map(|p| DVec2::new(p.x, p.y));
    Some(Segment::new(a, b))
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

/// `line-clipping` computes a crossing in five roundings, from what its last cut left, and up to two cuts an end. Each
/// cut moves the line by at most 3ε of its coordinates (L the largest), across the axis; on a side that the line meets
/// at an angle, the crossing slides by that times the slope:
///
/// ```text
/// |x − x̃| ≤ 8ε L (1 + |dx/dy|)        |y − ỹ| ≤ 8ε L (1 + |dy/dx|)
/// ```
///
/// Where it and ours decide differently, exact numbers side with ours: all such segments pass a corner closer than
/// rounding can tell.
#[test]
fn clipped_ends_against_line_clipping() {
    let window = Window::new(DVec2::ZERO, DVec2::splat(10.0)).unwrap();
    let mut random = Random::new(44);
    let (mut compared, mut undecided) = (0, 0);
    for case in 0..40_000 {
        let mut point = || DVec2::new(random.between(-10.0, 20.0), random.between(-10.0, 20.0));
        let mut s = Segment::new(point(), point());
        if case % 3 == 0 {
            let corner = window.corners()[random.below(4) as usize];
            s.b = corner + (corner - s.a) * random.between(0.1, 2.0);
        }
        let exact =
            of_segment([window.min, window.max], [s.a, s.b]).map(|[a, b]| Segment::new(a, b));
        for (name, clip) in METHODS {
            assert_eq!(clip(&window, s), exact, "{name}: {s:?}");
        }
        let theirs = clip_line(&window, s);
        let (Some(ours), Some(theirs)) = (exact, theirs) else {
            undecided += usize::from(exact.is_some() != theirs.is_some());
            continue;
        };
        compared += 1;
        let d = (s.b - s.a).abs();
        let largest = s.a.abs().max(s.b.abs()).max_element();
        let bound = 8.0 * f64::EPSILON * largest * (1.0 + DVec2::new(d.x / d.y, d.y / d.x));
        for (p, q) in [(ours.a, theirs.a), (ours.b, theirs.b)] {
            assert!((p - q).abs().cmple(bound).all(), "{s:?}: {p} and {q}");
        }
    }
    // Of the 13 000 that aim at a corner.
    assert!(
        compared > 10_000 && undecided > 500,
        "{compared} {undecided}"
    );
}

/// What `line-clipping` gets wrong: NaN is inside, and far ends overflow.
#[test]
fn what_line_clipping_lets_through() {
    let window = Window::new(DVec2::ZERO, DVec2::splat(10.0)).unwrap();
    let nan = Segment::new(DVec2::splat(f64::NAN), DVec2::splat(5.0));
    assert!(clip_line(&window, nan).is_some_and(|s| s.a.is_nan()));
    let far = Segment::new(DVec2::new(-1.5e308, -5.0), DVec2::new(1.5e308, 15.0));
    assert!(clip_line(&window, far).is_some_and(|s| s.a.is_nan() || s.b.is_nan()));
    // x runs 3·10³⁰⁸ for 20 of y, so at x = 0 and at x = 10 it is halfway up.
    let level = Segment::new(DVec2::new(0.0, 5.0), DVec2::new(10.0, 5.0));
    for (name, clip) in METHODS {
        assert_eq!(clip(&window, nan), None, "{name}");
        assert_eq!(clip(&window, far), Some(level), "{name}");
    }
}
