//! Pixels and clipped segments a second time, from the documentation alone: each promise against an oracle of another kind
//! than those beside it.
//!
//! Every double is a whole number of 2⁻¹⁰⁷⁴, so whole numbers are all the arithmetic there is: no exponents, no fractions
//! that are reduced. A double is not computed to be compared, but held against the two points half way to its neighbours.
//! Insides are told by a ray upwards, where the crates look to the left; triangles by tilings of the whole picture.
#![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use std::collections::{BTreeMap, BTreeSet};

use num_bigint::BigInt;
use ombra_clip::{Segment, Window, cohen_sutherland, cyrus_beck, direct, liang_barsky};
use ombra_math::glam::{DVec2, IVec2};
use ombra_raster::bresenham;
use ombra_raster::polygon::{Edge, FillRule, fill};
use ombra_raster::span::Span;
use ombra_raster::triangle::cover;
use ombra_tests::cases::Random;

/// x · 2¹⁰⁷⁴.
fn whole(x: f64) -> BigInt {
    let (field, fraction) = ((x.to_bits() >> 52) & 0x7ff, x.to_bits() & ((1 << 52) - 1));
    let magnitude = match field {
        0 => BigInt::from(fraction),
        _ => BigInt::from(fraction | 1 << 52) << (field - 1),
    };
    if x < 0.0 { -magnitude } else { magnitude }
}

fn sign(x: &BigInt) -> i32 {
    x.cmp(&BigInt::ZERO) as i32
}

/// Whether `y` is the double nearest to `n` / `d` · 2⁻¹⁰⁷⁴: no further than half way to either neighbour, and only an
/// even one as far as that.
fn is_nearest(y: f64, n: &BigInt, d: &BigInt) -> bool {
    let (n, d) = (n * sign(d) * 2, d * sign(d));
    let here = whole(y);
    let reach = |neighbour: f64| match neighbour.is_finite() {
        true => (whole(neighbour) + &here) * &d,
        false => {
            (&here * 2 + (whole(f64::MAX) - whole(f64::MAX.next_down())) * y.signum() as i32) * &d
        }
    };
    let (low, high) = (reach(y.next_down()), reach(y.next_up()));
    match y.to_bits() % 2 {
        0 => low <= n && n <= high,
        _ => low < n && n < high,
    }
}

/// A number of one of five kinds: on the grid of a window 0…8, halves, doubles about it, within two ulps of the grid,
/// and of any size.
fn number(random: &mut Random, kind: u32) -> f64 {
    let grid = f64::from(random.below(17)) - 4.0;
    match kind {
        0 => grid,
        1 => grid + 0.5,
        2 => random.between(-4.0, 12.0),
        3 => [
            grid.next_up(),
            grid.next_down(),
            grid.next_up().next_up(),
            grid,
        ][random.below(4) as usize],
        _ => match random.below(3) {
            0 => random.exponential(-1074, 1022),
            1 => [f64::MAX, -f64::MAX, 5e-324, -0.0][random.below(4) as usize],
            _ => random.between(-4.0, 12.0),
        },
    }
}

/// Mostly of one kind, now and then of another.
fn point(random: &mut Random, kind: u32) -> DVec2 {
    let mut one = || {
        let kind = if random.below(8) == 0 {
            random.below(5)
        } else {
            kind
        };
        number(random, kind)
    };
    DVec2::new(one(), one())
}

fn edges(polygon: &[DVec2]) -> impl Iterator<Item = (DVec2, DVec2)> + '_ {
    polygon
        .iter()
        .copied()
        .zip(polygon.iter().copied().cycle().skip(1))
}

/// (b − a) × (p − a).
fn turn(a: DVec2, b: DVec2, p: DVec2) -> BigInt {
    let [ax, ay, bx, by, px, py] = [a.x, a.y, b.x, b.y, p.x, p.y].map(whole);
    (bx - &ax) * (py - &ay) - (by - ay) * (px - ax)
}

/// How often the contours run round `p`, moved to (x + δ, y + δ²): by the edges that a ray towards smaller y crosses,
/// with the sign that an edge running down gives to its right.
fn winding(contours: &[Vec<DVec2>], p: DVec2) -> i64 {
    let mut sum = 0;
    for (a, b) in contours.iter().flat_map(|c| edges(c)) {
        let rightwards = b.x > p.x;
        if (a.x > p.x) == rightwards {
            continue;
        }
        // Moving p adds −(b.y − a.y) δ + (b.x − a.x) δ² to the turn.
        let side = match (sign(&turn(a, b, p)), a.y.total_cmp(&b.y) as i32) {
            (0, 0) => {
                if rightwards {
                    1
                } else {
                    -1
                }
            }
            (0, falls) => falls,
            (side, _) => side,
        };
        if rightwards && side > 0 {
            sum -= 1;
        } else if !rightwards && side < 0 {
            sum += 1;
        }
    }
    sum
}

fn centre(x: u32, y: u32) -> DVec2 {
    DVec2::new(f64::from(x) + 0.5, f64::from(y) + 0.5)
}

fn raster(spans: impl Iterator<Item = Span>) -> BTreeSet<(u32, u32)> {
    spans
        .flat_map(|s| s.pixels().map(|p| (p.x, p.y)).collect::<Vec<_>>())
        .collect()
}

/// Fill by both rules: the pixels whose centres the contours run round, edges through centres, shared edges, spikes and
/// vertices of any size among them. Edges by themselves: the crossing is the nearest double, its column the first centre
/// not left of it.
#[test]
fn filled_pixels_by_a_ray_upwards() {
    let mut random = Random::new(301);
    let mut inside = 0;
    for _ in 0..1200 {
        let kind = random.below(5);
        let mut contours: Vec<Vec<DVec2>> = (0..1 + random.below(2))
            .map(|_| {
                (0..random.below(8))
                    .map(|_| point(&mut random, kind))
                    .collect()
            })
            .collect();
        // Back along an edge, and a second contour on the other side of it.
        if let Some(&[a, b, ..]) = contours.first().map(Vec::as_slice) {
            match random.below(4) {
                0 => contours[0].extend([a, b]),
                1 => contours.push(vec![b, a, point(&mut random, kind)]),
                _ => {}
            }
        }
        let wound: BTreeMap<(u32, u32), i64> = (0..9)
            .flat_map(|y| (0..10).map(move |x| (x, y)))
            .map(|(x, y)| ((x, y), winding(&contours, centre(x, y))))
            .collect();
        for (rule, is_in) in [
            (FillRule::EvenOdd, (|w| w % 2 != 0) as fn(i64) -> bool),
            (FillRule::NonZero, |w| w != 0),
        ] {
            let expected: BTreeSet<(u32, u32)> = wound
                .iter()
                .filter(|(_, w)| is_in(**w))
                .map(|(p, _)| *p)
                .collect();
            let got = raster(fill(&contours, rule, 10, 9).unwrap());
            assert_eq!(got, expected, "{rule:?} {contours:?}");
            inside += got.len();
        }
        for (a, b) in contours.iter().flat_map(|c| edges(c)) {
            let Some(edge) = Edge::new(a, b, 9) else {
                continue;
            };
            let row = edge.rows.start;
            let y = whole(centre(0, row).y);
            let [tx, ty, bx, by] =
                [edge.top.x, edge.top.y, edge.bottom.x, edge.bottom.y].map(whole);
            let (n, d) = (tx * (&by - &y) + bx * (&y - &ty), by - ty);
            assert!(is_nearest(edge.x(row), &n, &d), "{edge:?}");
            let first = (0..10)
                .find(|&x| whole(centre(x, 0).x) * &d >= n)
                .unwrap_or(10);
            assert_eq!(edge.column(row, 10), first, "{edge:?}");
        }
    }
    assert!(inside > 10_000, "{inside}");
}

/// A plane cut into triangles at random points, whose edges often run through centres: each pixel has one owner.
#[test]
fn triangles_that_tile_own_each_pixel_once() {
    let mut random = Random::new(302);
    for case in 0..150 {
        // A grid of points, the inner ones moved by less than a quarter of its step: no triangle turns over.
        let step = [4.0, 3.0, 2.5][random.below(3) as usize];
        let mut grid = [[DVec2::ZERO; 6]; 6];
        for (j, row) in grid.iter_mut().enumerate() {
            for (i, p) in row.iter_mut().enumerate() {
                let mut moved = || match case % 3 {
                    0 => 0.0,
                    1 => 0.5 * (f64::from(random.below(3)) - 1.0),
                    _ => random.between(-0.6, 0.6),
                };
                *p = DVec2::new(i as f64 * step + moved(), j as f64 * step + moved());
            }
        }
        let far = [
            DVec2::splat(-1e9),
            DVec2::new(1e9, -1e9),
            DVec2::splat(1e9),
            DVec2::new(-1e9, 1e9),
        ];
        let mut owners: BTreeMap<(u32, u32), u32> = BTreeMap::new();
        let mut own = |a, b, c| {
            let turned = if random.below(2) == 0 {
                [a, b, c]
            } else {
                [c, b, a]
            };
            for p in raster(cover(turned, 16, 16).unwrap()) {
                *owners.entry(p).or_default() += 1;
            }
        };
        for (j, i) in (0..5).flat_map(|j| (0..5).map(move |i| (j, i))) {
            let [a, b, c, d] = [
                grid[j][i],
                grid[j][i + 1],
                grid[j + 1][i + 1],
                grid[j + 1][i],
            ];
            own(a, b, c);
            own(a, c, d);
        }
        // Around the grid out to far corners: the rest of the picture.
        let border: Vec<DVec2> = (0..5)
            .map(|i| grid[0][i])
            .chain((0..5).map(|j| grid[j][5]))
            .chain((0..5).map(|i| grid[5][5 - i]))
            .chain((0..5).map(|j| grid[5 - j][0]))
            .collect();
        for (k, (a, b)) in edges(&border).enumerate() {
            own(a, b, far[k / 5]);
            if k % 5 == 4 {
                own(b, far[k / 5], far[(k / 5 + 1) % 4]);
            }
        }
        assert!(
            owners.len() == 256 && owners.values().all(|&n| n == 1),
            "{grid:?} {owners:?}"
        );
    }
}

/// The pixel after j moves is the exact line rounded, halves towards the start: at the ends of i32, in all octants, by a
/// jump, and in a window as those of its columns and rows that are in it.
#[test]
fn pixels_at_the_ends_of_i32() {
    let mut random = Random::new(303);
    let mut entered = 0;
    for _ in 0..20_000 {
        let mut coordinate = || {
            let bits = random.bits();
            match bits % 4 {
                0 => i32::MIN + (bits >> 62) as i32,
                1 => i32::MAX - (bits >> 62) as i32,
                _ => (bits >> 32) as i32,
            }
        };
        let [a, b] = [0, 1].map(|_| IVec2::new(coordinate(), coordinate()));
        let d = [
            i128::from(b.x) - i128::from(a.x),
            i128::from(b.y) - i128::from(a.y),
        ];
        let steep = d[0].abs() < d[1].abs();
        let (run, rise) = if steep { (d[1], d[0]) } else { (d[0], d[1]) };
        let (n, rise, signs) = (run.abs(), rise.abs(), [run.signum(), rise.signum()]);
        let at = |j: i128| {
            let k = (2 * rise * j - n).div_euclid(2 * n)
                + i128::from((2 * rise * j - n).rem_euclid(2 * n) != 0);
            let (along, across) = if steep { (a.y, a.x) } else { (a.x, a.y) };
            let p = [
                i128::from(along) + j * signs[0],
                i128::from(across) + k * signs[1],
            ]
            .map(|v| v as i32);
            if steep {
                IVec2::new(p[1], p[0])
            } else {
                IVec2::from_array(p)
            }
        };
        if n == 0 {
            continue;
        }
        let j = i128::from(random.bits()) % (n + 1);
        let whole = bresenham::segment(a, b);
        assert_eq!(whole.clone().nth(j as usize), Some(at(j)), "{a} → {b}, {j}");
        assert_eq!((whole.len() as i128, whole.last()), (n + 1, Some(b)));

        let min =
            at(j).saturating_add(IVec2::new(random.below(20) as i32, random.below(20) as i32) - 15);
        let max = min.saturating_add(IVec2::new(random.below(12) as i32, random.below(12) as i32));
        let mut moves: Vec<i128> = match steep {
            true => (min.y..=max.y)
                .map(|y| (i128::from(y) - i128::from(a.y)) * signs[0])
                .collect(),
            false => (min.x..=max.x)
                .map(|x| (i128::from(x) - i128::from(a.x)) * signs[0])
                .collect(),
        };
        moves.sort_unstable();
        let expected: Vec<IVec2> = moves
            .into_iter()
            .filter(|j| (0..=n).contains(j))
            .map(at)
            .filter(|p| p.cmpge(min).all() && p.cmple(max).all())
            .collect();
        let clipped: Vec<IVec2> = bresenham::clipped(a, b, min, max).collect();
        assert_eq!(clipped, expected, "{a} → {b} in {min} … {max}");
        entered += usize::from(!clipped.is_empty());
    }
    assert!(entered > 5000, "{entered}");
}

/// A part of a segment as two parameters: first and last t with all `sides`, linear from one end to the other, not
/// negative.
fn part(sides: &[[BigInt; 2]]) -> Option<[(BigInt, BigInt); 2]> {
    let before = |p: &(BigInt, BigInt), q: &(BigInt, BigInt)| &p.0 * &q.1 < &q.0 * &p.1;
    let [mut first, mut last] = [0, 1].map(|t| (BigInt::from(t), BigInt::from(1)));
    for [a, b] in sides {
        let fall = a - b;
        match sign(&fall) {
            0 if sign(a) < 0 => return None,
            0 => {}
            falls => {
                let t = (a * falls, fall * falls);
                if falls > 0 && before(&t, &last) {
                    last = t;
                } else if falls < 0 && before(&first, &t) {
                    first = t;
                }
            }
        }
    }
    (!before(&last, &first)).then_some([first, last])
}

fn bits(s: Option<Segment>) -> Option<[u64; 4]> {
    s.map(|s| [s.a.x, s.a.y, s.b.x, s.b.y].map(f64::to_bits))
}

/// Segments of any size against windows, flat ones too: kept ends bit for bit, new ones nearest, −0 and direction as
/// given, and all methods alike; clipping again, or backwards, gives the same.
#[test]
fn clipped_segments_in_whole_numbers() {
    let mut random = Random::new(304);
    let mut cut = 0;
    for _ in 0..20_000 {
        let kind = random.below(5);
        let [p, q, mut a, mut b] = [0; 4].map(|_| point(&mut random, kind));
        let window = Window::new(p.min(q), p.max(q)).unwrap();
        let corner = window.corners()[random.below(4) as usize];
        match random.below(5) {
            0 => b = corner + (corner - a),
            1 => a.x = corner.x,
            2 => b = DVec2::new(a.x, b.y),
            _ => {}
        }
        if !b.is_finite() {
            b = a;
        }
        let s = Segment::new(a, b);
        let got = cohen_sutherland::clip_segment(&window, s);
        for other in [
            direct::clip_segment(&window, s),
            liang_barsky::clip_segment(&window, s),
        ] {
            assert_eq!(bits(other), bits(got), "{window:?} {s:?}");
        }
        if window.min.cmplt(window.max).all() {
            let [c, d] = [window.min, window.max];
            let clockwise = [c, DVec2::new(c.x, d.y), d, DVec2::new(d.x, c.y)];
            assert_eq!(
                bits(cyrus_beck::clip_segment(&clockwise, s)),
                bits(got),
                "{window:?} {s:?}"
            );
        }
        let axis = |a: f64, b: f64, low: f64, high: f64| {
            let [a, b, low, high] = [a, b, low, high].map(whole);
            [[&a - &low, &b - &low], [&high - a, high - b]]
        };
        let [x, y] = [
            axis(a.x, b.x, window.min.x, window.max.x),
            axis(a.y, b.y, window.min.y, window.max.y),
        ];
        let expected = part(&[x, y].concat());
        assert_eq!(got.is_some(), expected.is_some(), "{window:?} {s:?}");
        let (Some(got), Some(expected)) = (got, expected) else {
            continue;
        };
        for ((p, end), t) in [(got.a, a), (got.b, b)].into_iter().zip(&expected) {
            assert!(window.contains(p), "{window:?} {s:?} {p}");
            if window.contains(end) {
                assert_eq!(
                    p.to_array().map(f64::to_bits),
                    end.to_array().map(f64::to_bits),
                    "{window:?} {s:?}"
                );
                continue;
            }
            cut += 1;
            for (p, a, b) in [(p.x, a.x, b.x), (p.y, a.y, b.y)] {
                let n = &t.1 * whole(a) + &t.0 * (whole(b) - whole(a));
                assert!(is_nearest(p, &n, &t.1), "{window:?} {s:?}: {p:e}");
            }
        }
        assert_eq!(
            bits(cohen_sutherland::clip_segment(&window, got)),
            bits(Some(got))
        );
        let back = cohen_sutherland::clip_segment(&window, s.reversed()).map(Segment::reversed);
        assert_eq!(bits(back), bits(Some(got)), "{window:?} {s:?}");
    }
    assert!(cut > 4000, "{cut}");
}
