//! Bresenham's pixels at the ends of `i32`, against the exact line.
#![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use ombra_math::glam::IVec2;
use ombra_raster::bresenham;
use ombra_tests::cases::Random;

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
