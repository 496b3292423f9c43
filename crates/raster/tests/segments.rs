//! Segments against the definition, in exact integers: in each column (or row) the pixel nearest to the line, a tie to
//! the pixel nearer the start.

use ombra_math::glam::IVec2;
use ombra_math::work::Work;
use ombra_raster::bresenham::Choice;
use ombra_raster::{analytic, bresenham, dda};
use proptest::prelude::*;
use proptest::test_runner::FileFailurePersistence::WithSource;

/// Pixel `i` of the segment: 2 |dx y − dy i| is compared by quotient and remainder, in `i128`.
fn exact(a: IVec2, b: IVec2, i: u64) -> IVec2 {
    let [ax, ay, bx, by] = [a.x, a.y, b.x, b.y].map(i128::from);
    let (dx, dy) = (bx - ax, by - ay);
    let n = dx.abs().max(dy.abs());
    let nearest = |d: i128| {
        if n == 0 {
            return 0;
        }
        let product = d.abs() * i128::from(i);
        let (below, rest) = (product / n, product % n);
        let steps = if 2 * rest > n { below + 1 } else { below };
        d.signum() * steps
    };
    let place = |from: i128, d: i128| (from + nearest(d)) as i32;
    IVec2::new(place(ax, dx), place(ay, dy))
}

/// All pixels by search: of every pixel in the column (row), the one nearest to the line.
fn searched(a: IVec2, b: IVec2) -> Vec<IVec2> {
    let d = b - a;
    let flat = d.x.abs() >= d.y.abs();
    let n = d.x.abs().max(d.y.abs());
    let (along, across) = if flat { (d.x, d.y) } else { (d.y, d.x) };
    (0..=n)
        .map(|i| {
            let near = (-n..=n)
                .min_by_key(|&j| ((n * j - across * i).abs(), j.abs()))
                .unwrap_or(0); // the range is not empty
            let far = along.signum() * i;
            a + if flat {
                IVec2::new(far, near)
            } else {
                IVec2::new(near, far)
            }
        })
        .collect()
}

/// `cases` cases; a failing one is kept beside this file.
fn config(cases: u32) -> ProptestConfig {
    ProptestConfig {
        failure_persistence: Some(Box::new(WithSource("proptest-regressions"))),
        ..ProptestConfig::with_cases(cases)
    }
}

fn all_short(mut check: impl FnMut(IVec2, IVec2)) {
    for (ax, ay) in [(0, 0), (-12, 12), (5, -7)] {
        for i in 0..25 * 25 {
            check(IVec2::new(ax, ay), IVec2::new(i % 25 - 12, i / 25 - 12));
        }
    }
}

/// The slide's form, and its work.
fn plain(a: IVec2, b: IVec2) -> (Vec<IVec2>, Work) {
    let (mut pixels, mut work) = (Vec::new(), Work::default());
    bresenham::segment_plain(a, b, &mut work, |p| pixels.push(p));
    (pixels, work)
}

fn moves(a: IVec2, b: IVec2) -> u64 {
    u64::from(a.x.abs_diff(b.x).max(a.y.abs_diff(b.y)))
}

#[test]
fn short_segments_are_the_nearest_pixels() {
    all_short(|a, b| {
        let expected = searched(a, b);
        assert_eq!(expected.len() as u64, moves(a, b) + 1);
        for (i, &p) in expected.iter().enumerate() {
            assert_eq!(p, exact(a, b, i as u64), "the two oracles, {a} to {b}");
        }
        assert_eq!(plain(a, b).0, expected, "the slide's form, {a} to {b}");
        assert!(
            bresenham::segment(a, b).eq(expected.iter().copied()),
            "Bresenham, {a} to {b}"
        );
        assert!(
            analytic::segment(a, b).eq(expected.iter().copied()),
            "analytic, {a} to {b}"
        );
        assert!(
            dda::segment(a, b).eq(expected.iter().copied()),
            "DDA, {a} to {b}"
        );
        assert!(
            dda::segment_f32(a, b).eq(expected.iter().copied()),
            "DDA f32, {a} to {b}"
        );
    });
}

/// Every segment with all coordinates from −12 to 12 is one of those above, moved. What moves it must not change it.
#[test]
fn moving_a_segment_moves_its_pixels() {
    all_short(|a, b| {
        for by in [
            IVec2::splat(1_000_000_007),
            IVec2::new(i32::MIN + 12, i32::MAX - 12),
        ] {
            let moved = |pixels: Vec<IVec2>| pixels.into_iter().map(|p| p + by).collect::<Vec<_>>();
            let there = (a + by, b + by);
            assert_eq!(
                moved(bresenham::segment(a, b).collect()),
                bresenham::segment(there.0, there.1).collect::<Vec<_>>()
            );
            assert_eq!(
                moved(analytic::segment(a, b).collect()),
                analytic::segment(there.0, there.1).collect::<Vec<_>>()
            );
            assert_eq!(
                moved(dda::segment(a, b).collect()),
                dda::segment(there.0, there.1).collect::<Vec<_>>()
            );
        }
    });
}

fn picture(b: [i32; 2]) -> Vec<String> {
    let mut rows = vec![vec!['.'; 9]; 9];
    for p in bresenham::segment(IVec2::splat(4), IVec2::splat(4) + IVec2::from(b)) {
        rows[p.y as usize][p.x as usize] = '#';
    }
    rows.into_iter()
        .map(|row| row.into_iter().collect())
        .collect()
}

/// The start in the middle, ties at 1 and 3: always the pixel on the start's side.
#[test]
fn ties_in_every_octant() {
    let rows = |rows: [&str; 9]| rows.map(String::from).to_vec();
    let e_se = rows([
        ".........",
        ".........",
        ".........",
        ".........",
        "....##...",
        "......##.",
        "........#",
        ".........",
        ".........",
    ]);
    assert_eq!(picture([4, 2]), e_se);
    let s_se = rows([
        ".........",
        ".........",
        ".........",
        ".........",
        "....#....",
        "....#....",
        ".....#...",
        ".....#...",
        "......#..",
    ]);
    assert_eq!(picture([2, 4]), s_se);
    // The other six are mirror images.
    for (sx, sy) in [(-1, 1), (1, -1), (-1, -1)] {
        for (b, rows) in [([4, 2], &e_se), ([2, 4], &s_se)] {
            let mut mirrored = rows.clone();
            if sx < 0 {
                mirrored = mirrored.iter().map(|r| r.chars().rev().collect()).collect();
            }
            if sy < 0 {
                mirrored.reverse();
            }
            assert_eq!(picture([b[0] * sx, b[1] * sy]), mirrored);
        }
    }
}

/// Any two points; the exponents of their differences spread; every third nearly level, diagonal or at a tie.
fn far_apart() -> impl Strategy<Value = (IVec2, IVec2)> {
    (any::<[i32; 4]>(), 0..32_u32, 0..32_u32, 0..9_u32, -2..3_i32).prop_map(
        |([ax, ay, x, y], shift_x, shift_y, kind, near)| {
            let a = IVec2::new(ax, ay);
            let run = x >> shift_x;
            let rise = match kind {
                0 => near,
                1 => run.saturating_add(near),
                2 => run / 2 + near,
                _ => y >> shift_y,
            };
            let d = if y & 1 == 0 {
                IVec2::new(run, rise)
            } else {
                IVec2::new(rise, run)
            };
            (
                a,
                if kind > 6 {
                    IVec2::new(x, y)
                } else {
                    a.saturating_add(d)
                },
            )
        },
    )
}

proptest! {
    #![proptest_config(config(20_000))]

    #[test]
    fn long_segments_are_the_nearest_pixels((a, b) in far_apart(), places: [u64; 8], hop in 0..1000_usize) {
        let n = moves(a, b);
        let sampled = places.map(|p| p % (n + 1)).into_iter().chain([0, 1.min(n), n / 2, n - 1.min(n), n]);
        for i in sampled {
            let p = exact(a, b, i);
            let Ok(skipped) = usize::try_from(i) else { continue };
            prop_assert_eq!(bresenham::segment(a, b).nth(skipped), Some(p));
            // On from there, one by one and by jumps.
            let mut rest = bresenham::segment(a, b);
            rest.nth(skipped);
            for j in i + 1..(i + 4).min(n + 1) {
                prop_assert_eq!(rest.next(), Some(exact(a, b, j)));
            }
            let jumped = (i + 4).min(n + 1) + hop as u64;
            prop_assert_eq!(rest.nth(hop), (jumped <= n).then(|| exact(a, b, jumped)));
            if n <= 27_000_000 {
                prop_assert_eq!(analytic::segment(a, b).nth(skipped), Some(p));
            }
            // The decision is 2F of the definition.
            let step = bresenham::trace(a, b).nth(skipped);
            prop_assert_eq!(step.is_some(), i < n);
            if let Some(step) = step {
                let d = [a.x.abs_diff(b.x), a.y.abs_diff(b.y)].map(i128::from);
                let minor = if d[0] >= d[1] { a.y.abs_diff(p.y) } else { a.x.abs_diff(p.x) };
                let f2 = 2 * d[0].min(d[1]) * i128::from(i + 1) - d[0].max(d[1]) * (2 * i128::from(minor) + 1);
                prop_assert_eq!(i128::from(step.decision), f2);
                prop_assert_eq!(step.pixel, p);
                let turned = exact(a, b, i + 1) - p;
                prop_assert_eq!(step.choice == Choice::NE, turned.x != 0 && turned.y != 0);
            }
        }
        prop_assert_eq!(bresenham::segment(a, b).last(), Some(b));
        prop_assert_eq!(bresenham::segment(a, b).count() as u64, n + 1);
    }

    /// Short pieces anywhere in `i32`: the slide's form, one by one, is the iterator, in pixels, decisions and work.
    #[test]
    fn the_slides_form_is_the_fast_one(a in any::<[i32; 2]>(), by in prop::array::uniform2(-300..301_i32), thin in 0..9_u32) {
        let a = IVec2::from(a);
        for by in [[by[0], by[1] >> thin], [by[0] >> thin, by[1]], [by[0], by[0]], [by[0], by[0] / 2]] {
            let b = a.saturating_add(by.into());
            let (pixels, work) = plain(a, b);
            let mut counted = Work::default();
            prop_assert!(bresenham::counted::segment(a, b, &mut counted).eq(pixels.iter().copied()));
            prop_assert_eq!(work, counted);
            for (step, pair) in bresenham::trace(a, b).zip(pixels.windows(2)) {
                let both = pair[0].x != pair[1].x && pair[0].y != pair[1].y;
                prop_assert_eq!((step.pixel, step.choice == Choice::NE), (pair[0], both));
            }
        }
    }

    /// One by one, all at once, and the number told beforehand.
    #[test]
    fn all_ways_through_agree(a in prop::array::uniform2(-99..99_i32), b in prop::array::uniform2(-99..99_i32), taken in 0..250_usize) {
        let (a, b) = (IVec2::from(a), IVec2::from(b));
        let mut pixels = bresenham::segment(a, b);
        for _ in 0..taken {
            pixels.next();
        }
        let mut one_by_one = vec![];
        let mut rest = pixels.clone();
        for p in rest.by_ref() {
            one_by_one.push(p);
        }
        prop_assert_eq!(rest.next(), None);
        prop_assert_eq!(pixels.size_hint(), (one_by_one.len(), Some(one_by_one.len())));
        prop_assert_eq!(pixels.clone().count(), one_by_one.len());
        prop_assert_eq!(pixels.clone().last(), one_by_one.last().copied());
        prop_assert_eq!(pixels.clone().trace().count(), one_by_one.len().saturating_sub(1));
        prop_assert_eq!(pixels.fold(vec![], |mut all, p| { all.push(p); all }), one_by_one);
        let mut analytic = analytic::segment(a, b);
        prop_assert_eq!(analytic.nth(taken), bresenham::segment(a, b).nth(taken));
        prop_assert!(analytic.eq(bresenham::segment(a, b).skip(taken + 1)));
        let whole = bresenham::segment(a, b).len();
        prop_assert_eq!(dda::segment(a, b).size_hint(), (whole, Some(whole)));
    }
}

/// The largest common divisor.
fn gcd(a: u64, b: u64) -> u64 {
    if b == 0 { a } else { gcd(b, a % b) }
}

#[test]
fn reversing_moves_the_ties_alone() {
    let mut most = 0;
    all_short(|a, b| {
        let forth: Vec<_> = bresenham::segment(a, b).collect();
        let back: Vec<_> = bresenham::segment(b, a).collect();
        let ties: Vec<_> = bresenham::trace(a, b).filter(|s| s.decision == 0).collect();
        let moved: Vec<_> = forth
            .iter()
            .zip(back.iter().rev())
            .enumerate()
            .filter(|(_, (p, q))| p != q)
            .collect();
        // A decision at P is about the pixel after P, and the other pixel is one step across.
        assert_eq!(ties.len(), moved.len());
        for (tie, &(i, (&p, &q))) in ties.iter().zip(&moved) {
            assert_eq!(tie.pixel, forth[i - 1]);
            assert_eq!((p - q).abs().element_sum(), 1);
        }
        let d = [a.x.abs_diff(b.x), a.y.abs_diff(b.y)].map(u64::from);
        let (dx, g) = (d[0].max(d[1]), gcd(d[0], d[1]));
        let expected = if g > 0 && dx / g % 2 == 0 { g } else { 0 };
        assert_eq!(ties.len() as u64, expected, "{a} to {b}");
        assert!(2 * expected <= dx);
        most = most.max(expected);
    });
    assert!(most > 0);
    let steepest = bresenham::trace(IVec2::ZERO, IVec2::new(8, 4)).filter(|s| s.decision == 0);
    assert_eq!(steepest.count(), 8 / 2);
}

/// a, b, and the number of pixels.
#[test]
fn extremes() {
    let (lo, hi) = (i32::MIN, i32::MAX);
    let longest = 1_u64 << 32;
    #[rustfmt::skip]
    let table = [
        ([0, 0], [0, 0], 1),
        ([hi, hi], [hi, hi], 1),
        ([lo, lo], [lo, lo], 1),
        ([hi, lo], [hi - 1, lo + 1], 2),
        ([lo, 0], [hi, 0], longest),
        ([hi, 0], [lo, 0], longest),
        ([0, hi], [0, lo], longest),
        ([lo, lo], [hi, hi], longest),
        ([hi, lo], [lo, hi], longest),
        ([lo, lo], [hi, hi - 1], longest),
        ([lo, lo], [hi - 1, hi], longest),
        ([lo, hi], [hi, lo + 1], longest),
        ([lo, 0], [hi, 1], longest),
        ([lo, lo], [hi, -1], longest),
        ([lo, 5], [lo + 4, hi], hi as u64 - 4),
    ];
    for (a, b, pixels) in table {
        let (a, b) = (IVec2::from(a), IVec2::from(b));
        let segment = bresenham::segment(a, b);
        if let Ok(pixels) = usize::try_from(pixels) {
            assert_eq!(segment.size_hint(), (pixels, Some(pixels)), "{a} to {b}");
            assert_eq!(analytic::segment(a, b).size_hint(), (pixels, Some(pixels)));
            assert_eq!(dda::segment(a, b).size_hint(), (pixels, Some(pixels)));
            assert_eq!(segment.clone().nth(pixels), None);
            assert_eq!(analytic::segment(a, b).nth(pixels), None);
            assert_eq!(analytic::segment(a, b).nth(pixels - 1), Some(b));
            assert_eq!(segment.clone().nth(pixels - 1), Some(b));
            assert_eq!(
                segment.clone().nth((pixels - 1) / 2),
                Some(exact(a, b, (pixels as u64 - 1) / 2))
            );
        }
        assert_eq!(segment.last(), Some(b), "{a} to {b}");
        for (i, p) in bresenham::segment(a, b).take(5).enumerate() {
            assert_eq!(p, exact(a, b, i as u64), "{a} to {b}");
        }
        assert_eq!(analytic::segment(a, b).next(), Some(a));
        assert!(
            dda::segment(a, b)
                .take(5)
                .eq(bresenham::segment(a, b).take(5))
        );
        assert_eq!(dda::segment_f32(a, b).next(), Some(a));
    }
}
