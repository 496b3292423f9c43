//! Clipped segments of any size: kept ends bit for bit, new ones held against the points half way to their neighbours.
#![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use ombra_clip::{Segment, Window, cohen_sutherland, cyrus_beck, direct, liang_barsky};
use ombra_math::glam::DVec2;
use ombra_oracle::interval::{between, not_negative};
use ombra_oracle::vector::{exact, minus};
use ombra_tests::cases::{Random, point_near_grid};
use ombra_tests::halfway::is_nearest;

fn bits(s: Option<Segment>) -> Option<[u64; 4]> {
    s.map(|s| [s.a.x, s.a.y, s.b.x, s.b.y].map(f64::to_bits))
}

/// Segments of any size against windows, flat ones too: kept ends bit for bit, new ones nearest, −0 and direction as
/// given, and all methods alike; clipping again, or backwards, gives the same.
#[test]
fn clipped_segments_are_nearest() {
    let mut random = Random::new(304);
    let mut cut = 0;
    for _ in 0..20_000 {
        let kind = random.below(5);
        let [p, q, mut a, mut b] = [0; 4].map(|_| point_near_grid(&mut random, kind));
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
        let [low, high, from, to] = [window.min, window.max, a, b].map(|p| exact(p).unwrap());
        let [[al, ar], [bl, br]] = [&from, &to].map(|p| [minus(p, &low), minus(&high, p)]);
        let sides = [0, 1].map(|k| {
            [
                [al[k].clone(), bl[k].clone()],
                [ar[k].clone(), br[k].clone()],
            ]
        });
        let expected = not_negative(&sides.concat());
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
            for k in 0..2 {
                let crossing = between(t, &from[k], &to[k]);
                assert!(is_nearest(p[k], &crossing), "{window:?} {s:?}: {p}");
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
