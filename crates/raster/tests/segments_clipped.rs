//! Windows on a segment: exactly the whole segment's pixels, without walking to them.

use ombra_math::glam::{IVec2, Vec2Swizzles};
use ombra_math::work::Work;
use ombra_raster::bresenham::{clipped, counted, segment, trace};
use proptest::prelude::*;
use proptest::test_runner::FileFailurePersistence::WithSource;

/// `cases` cases; a failing one is kept beside this file.
fn config(cases: u32) -> ProptestConfig {
    ProptestConfig {
        failure_persistence: Some(Box::new(WithSource("proptest-regressions"))),
        ..ProptestConfig::with_cases(cases)
    }
}

fn inside(p: IVec2, min: IVec2, max: IVec2) -> bool {
    min.x <= p.x && p.x <= max.x && min.y <= p.y && p.y <= max.y
}

#[test]
fn every_window_on_short_segments() {
    for b in (0..13 * 13).map(|i| IVec2::new(i % 13 - 6, i / 13 - 6)) {
        let a = IVec2::new(1, -2);
        let whole: Vec<_> = segment(a, b).collect();
        for corners in (0..10 * 10 * 10 * 10)
            .map(|i| [i % 10, i / 10 % 10, i / 100 % 10, i / 1000].map(|c| c - 5))
        {
            let (min, max) = (
                IVec2::new(corners[0], corners[1]),
                IVec2::new(corners[2], corners[3]),
            );
            let expected = whole.iter().copied().filter(|&p| inside(p, min, max));
            assert!(
                clipped(a, b, min, max).eq(expected),
                "{a} to {b} in {min} … {max}"
            );
        }
    }
}

/// Pixel `i` of the segment in exact integers, as in segments.rs, by rounding a half down.
fn exact(a: IVec2, b: IVec2, i: i128) -> IVec2 {
    let d = [(a.x, b.x), (a.y, b.y)].map(|(a, b)| i128::from(b) - i128::from(a));
    let n = d[0].abs().max(d[1].abs()).max(1);
    let [x, y] = d.map(|d| d.signum() * (2 * d.abs() * i + n - 1).div_euclid(2 * n));
    IVec2::new((i128::from(a.x) + x) as i32, (i128::from(a.y) + y) as i32)
}

proptest! {
    #![proptest_config(config(20_000))]

    /// Small windows anywhere: on the line, beside it, at an end, on the end of `i32`.
    #[test]
    fn small_windows_on_long_segments(
        a: [i32; 2], b: [i32; 2], narrow in 0..32_u32,
        place: u64, beside in prop::array::uniform2(-12..12_i32), size in prop::array::uniform2(-1..24_i32), edge in 0..8_u32,
    ) {
        let a = IVec2::from(a);
        let b = IVec2::new(a.x.saturating_add(b[0] >> narrow), b[1]);
        let n = a.x.abs_diff(b.x).max(a.y.abs_diff(b.y));
        let on_line = match edge {
            0 => a,
            1 => b,
            _ => exact(a, b, i128::from(place % (u64::from(n) + 1))),
        };
        let min = on_line.saturating_add(beside.into());
        let max = min.saturating_add(size.into());
        // Where the window could hold pixels, along the longer axis.
        let (start, from, to) = if a.x.abs_diff(b.x) >= a.y.abs_diff(b.y) {
            (a.x, min.x, max.x)
        } else {
            (a.y, min.y, max.y)
        };
        let mut candidates: Vec<_> = (from..=to)
            .map(|u| i128::from(u.abs_diff(start)))
            .filter(|&i| i <= i128::from(n))
            .map(|i| (i, exact(a, b, i)))
            .filter(|&(_, p)| inside(p, min, max))
            .collect();
        candidates.sort_by_key(|&(i, _)| i);
        candidates.dedup();

        let mut work = Work::default();
        let got: Vec<_> = counted::clipped(a, b, min, max, &mut work).collect();
        prop_assert_eq!(&got, &candidates.iter().map(|c| c.1).collect::<Vec<_>>());
        // An addition a move inside; what is outside costs at most three divisions, four products.
        prop_assert_eq!(work.additions, (got.len() as u64).saturating_sub(1));
        prop_assert!(work.divisions <= 3 && work.multiplications <= 4, "{}", work);

        // The decisions inside are the whole segment's.
        if let Some(&(entry, _)) = candidates.first() {
            let whole = trace(a, b);
            let here = clipped(a, b, min, max).trace();
            let Ok(skipped) = usize::try_from(entry) else { return Ok(()) };
            let from_entry = if skipped == 0 { whole } else {
                let mut whole = whole;
                whole.nth(skipped - 1);
                whole
            };
            prop_assert!(here.eq(from_entry.take(got.len() - 1)));
        }
    }

    /// Windows of any size, by their first and last pixels: what comes before and after is outside.
    #[test]
    fn large_windows_on_long_segments(a: [i32; 2], b: [i32; 2], p: [i32; 2], q: [i32; 2]) {
        let [a, b, p, q] = [a, b, p, q].map(IVec2::from);
        let (min, max) = (p.min(q), p.max(q));
        let part = clipped(a, b, min, max);
        let n = a.x.abs_diff(b.x).max(a.y.abs_diff(b.y));
        let index = |p: IVec2| i128::from(a.x.abs_diff(p.x).max(a.y.abs_diff(p.y)));
        let ends = (part.clone().next(), part.clone().last());
        if let (Some(first), Some(last)) = ends {
            prop_assert_eq!(exact(a, b, index(first)), first);
            prop_assert_eq!(exact(a, b, index(last)), last);
            prop_assert!(inside(first, min, max) && inside(last, min, max));
            prop_assert_eq!(part.count() as i128, index(last) - index(first) + 1);
            prop_assert!(index(first) == 0 || !inside(exact(a, b, index(first) - 1), min, max));
            prop_assert!(index(last) == i128::from(n) || !inside(exact(a, b, index(last) + 1), min, max));
        } else {
            prop_assert!(!inside(a, min, max) && !inside(b, min, max));
            for i in 0..64 {
                prop_assert!(!inside(exact(a, b, i128::from(n) * i / 63), min, max));
            }
        }
    }
}

/// Cut at x = 1 and rounded, the segment of the lecture starts at (1, 0) and has another slope.
#[test]
fn cutting_the_ends_first_moves_pixels() {
    let (a, b) = (IVec2::ZERO, IVec2::new(8, 3));
    let y = |pixels: Vec<IVec2>| pixels.iter().map(|p| p.y).collect::<Vec<_>>();
    let window = (IVec2::new(1, 0), IVec2::new(8, 3));
    assert_eq!(
        y(clipped(a, b, window.0, window.1).collect()),
        [0, 1, 1, 1, 2, 2, 3, 3]
    );
    assert_eq!(y(segment(window.0, b).collect()), [0, 0, 1, 1, 2, 2, 3, 3]);
}

#[test]
fn tiles_fit_together() {
    let (a, b) = (IVec2::new(-1_000_000, 123), IVec2::new(1_000_000, 98_765));
    let (middle, size) = (IVec2::new(0, 49_444), 16);
    let whole: Vec<_> = clipped(a, b, middle - 64, middle + 63).collect();
    let mut tiled: Vec<_> = (0..8 * 8)
        .map(|i| middle - 64 + IVec2::new(i % 8, i / 8) * size)
        .flat_map(|min| clipped(a, b, min, min + (size - 1)))
        .collect();
    tiled.sort_by_key(|p| (p.x, p.y));
    assert_eq!(whole.len(), 128);
    assert_eq!(tiled, whole);
}

#[test]
fn extremes() {
    let (lo, hi) = (IVec2::MIN, IVec2::MAX);
    let count = |a, b, min, max| clipped(a, b, min, max).size_hint().1;
    // An empty window, in one or both directions, also where the segment passes.
    for (min, max) in [([1, 0], [0, 5]), ([0, 5], [5, 4]), ([3, 3], [2, 2])] {
        assert_eq!(clipped(lo, hi, min.into(), max.into()).next(), None);
    }
    assert_eq!(clipped(lo, hi, hi, lo).next(), None);
    // The window is everything, one pixel, an end.
    if usize::BITS == 64 {
        assert_eq!(count(lo, hi, lo, hi), Some(1 << 32));
        assert_eq!(count(lo, IVec2::new(i32::MAX, 0), lo, hi), Some(1 << 32));
    }
    assert_eq!(
        clipped(lo, hi, IVec2::ZERO, IVec2::ZERO).collect::<Vec<_>>(),
        [IVec2::ZERO]
    );
    assert_eq!(clipped(lo, hi, hi, hi).collect::<Vec<_>>(), [hi]);
    assert_eq!(clipped(hi, lo, hi, hi).collect::<Vec<_>>(), [hi]);
    // A window of one pixel, in the middle of a segment as long as there is and beside it: what lies outside costs nothing
    // but the entry.
    let (a, b) = (lo, IVec2::new(i32::MAX, i32::MAX - 1));
    for x in [-2, -1, 0, 1] {
        for y in x - 2..=x + 2 {
            let p = IVec2::new(x, y);
            let mut work = Work::default();
            let found: Vec<_> = counted::clipped(a, b, p, p, &mut work).collect();
            let i = i128::from(x) - i128::from(i32::MIN);
            let expected = if exact(a, b, i) == p { vec![p] } else { vec![] };
            assert_eq!(found, expected, "{p}");
            assert!(work.additions == 0 && work.divisions <= 3 && work.multiplications <= 4);
        }
    }
    // A point, inside and outside.
    assert_eq!(clipped(hi, hi, lo, hi).collect::<Vec<_>>(), [hi]);
    assert_eq!(clipped(hi, hi, lo, hi - 1).next(), None);
    // Level and upright, beside the window and through it.
    let level = |y| (IVec2::new(i32::MIN, y), IVec2::new(i32::MAX, y));
    for (y, pixels) in [
        (-1, 0),
        (0, 10),
        (9, 10),
        (10, 0),
        (i32::MAX, 0),
        (i32::MIN, 0),
    ] {
        let (a, b) = level(y);
        for (a, b) in [(a, b), (b, a), (a.yx(), b.yx()), (b.yx(), a.yx())] {
            assert_eq!(
                count(a, b, IVec2::ZERO, IVec2::splat(9)),
                Some(pixels),
                "{a} to {b}"
            );
        }
    }
}
