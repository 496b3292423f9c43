//! Up to which length floating point gives the exact pixels, and what comes after.

use ombra_math::glam::IVec2;
use ombra_raster::{analytic, bresenham, dda};

/// No segment with up to 298 moves goes wrong in f32, and the next length has one that does.
#[test]
fn f32_sums_hold_up_to_298_moves() {
    for dx in 0..=298 {
        for dy in 0..=dx {
            let b = IVec2::new(dx, dy);
            assert!(
                dda::segment_f32(IVec2::ZERO, b).eq(bresenham::segment(IVec2::ZERO, b)),
                "{b}"
            );
        }
    }
    let b = IVec2::new(299, 231);
    let wrong = dda::segment_f32(IVec2::ZERO, b).zip(bresenham::segment(IVec2::ZERO, b));
    let wrong: Vec<_> = wrong.filter(|(p, q)| p != q).map(|(p, _)| p.x).collect();
    assert_eq!(wrong, [288]);
}

#[test]
fn f32_sums_end_at_the_end_up_to_4000_moves_and_drift_beyond() {
    for dy in (0..4000).step_by(7) {
        let b = IVec2::new(4000, dy);
        assert_eq!(dda::segment_f32(IVec2::ZERO, b).last(), Some(b));
    }
    // After a million sums of ⅓, hundreds of pixels.
    let b = IVec2::new(1_000_000, 333_333);
    let off = dda::segment_f32(IVec2::ZERO, b)
        .zip(bresenham::segment(IVec2::ZERO, b))
        .map(|(p, q)| (p.y - q.y).abs());
    assert!(off.max() > Some(100));
}

#[test]
fn f64_sums_hold_up_to_165_000_moves_but_not_for_ever() {
    let agree = |b| dda::segment(IVec2::ZERO, b).eq(bresenham::segment(IVec2::ZERO, b));
    for k in 0..60 {
        // The longest, nearly diagonal: the largest sums; odd and even lengths, with a tie in the middle or none.
        assert!(agree(IVec2::new(165_000 - k % 2, 164_999 - 977 * k)), "{k}");
    }
    assert!(!agree(IVec2::new(222_240, 209_800)));
}

/// Half a pixel is missed much later than the nearest of two: the largest sums, and a slope that is no double.
#[test]
fn f64_sums_end_at_the_end_up_to_90_million_moves() {
    for dy in [89_999_999, 30_000_001] {
        let b = IVec2::new(90_000_000, dy);
        assert_eq!(dda::segment(IVec2::ZERO, b).last(), Some(b));
    }
}

#[test]
fn products_hold_up_to_27_million_moves_but_not_for_ever() {
    let wrong_at = |b: IVec2, i: usize| {
        analytic::segment(IVec2::ZERO, b).nth(i) != bresenham::segment(IVec2::ZERO, b).nth(i)
    };
    assert!(wrong_at(IVec2::new(67_111_622, 67_110_111), 33_555_811));
    // As long as is proved, at the tie in the middle of even lengths and around it.
    for dy in (13_000_001..27_000_000).step_by(1022) {
        for i in 13_499_990..13_500_010 {
            assert!(!wrong_at(IVec2::new(27_000_000, dy), i), "{dy} at {i}");
        }
    }
}

/// Sums that drift past the end of `i32` stay there.
#[test]
fn drift_does_not_overflow() {
    let d = IVec2::new(8_000_000, 6_400_001);
    let end = |a: IVec2, b: IVec2| dda::segment_f32(a, b).last().unwrap();
    let above = end(IVec2::ZERO, d).y - d.y;
    assert!(above > 0);
    assert_eq!(end(IVec2::MAX - d, IVec2::MAX).y, i32::MAX);
    assert_eq!(end(IVec2::MIN + d, IVec2::MIN).y, i32::MIN);
    // One pixel of room, or just as much as it takes.
    assert_eq!(end(IVec2::MAX - d - 1, IVec2::MAX - 1).y, i32::MAX);
    assert_eq!(end(IVec2::MAX - d - above, IVec2::MAX - above).y, i32::MAX);
    assert_eq!(
        end(IVec2::MAX - d - above - 1, IVec2::MAX - above - 1).y,
        i32::MAX - 1
    );
}
