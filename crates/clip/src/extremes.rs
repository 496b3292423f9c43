//! Segments at the extremes, which every method answers alike.

use ombra_math::glam::DVec2;

use crate::{Segment, Window};

pub(crate) fn segment(a: (f64, f64), b: (f64, f64)) -> Segment {
    Segment::new(a.into(), b.into())
}

/// The lecture's window, from 0 to 10.
pub(crate) fn lecture() -> Window {
    Window::new(DVec2::ZERO, DVec2::splat(10.0)).unwrap()
}

/// What is left of segments in the lecture's window.
fn in_the_lectures_window() -> Vec<(Segment, Option<Segment>)> {
    let (huge, tiny) = (f64::MAX, 5e-324);
    let kept = |a, b, c, d| (segment(a, b), Some(segment(c, d)));
    let whole = |a, b| kept(a, b, a, b);
    let nothing = |a, b| (segment(a, b), None);
    vec![
        // A point: inside, on a side, on corners, outside.
        whole((5.0, 5.0), (5.0, 5.0)),
        whole((10.0, 5.0), (10.0, 5.0)),
        whole((0.0, 10.0), (0.0, 10.0)),
        whole((10.0, 0.0), (10.0, 0.0)),
        nothing((5.0, -1.0), (5.0, -1.0)),
        nothing((11.0, 5.0), (11.0, 5.0)),
        nothing((-1.0, 11.0), (-1.0, 11.0)),
        // Parallel to two sides: along one, between them, beside them, beyond its end.
        kept((-5.0, 0.0), (15.0, 0.0), (0.0, 0.0), (10.0, 0.0)),
        kept((-5.0, 10.0), (15.0, 10.0), (0.0, 10.0), (10.0, 10.0)),
        kept((0.0, 15.0), (0.0, -5.0), (0.0, 10.0), (0.0, 0.0)),
        kept((5.0, -5.0), (5.0, 15.0), (5.0, 0.0), (5.0, 10.0)),
        kept((-5.0, 5.0), (15.0, 5.0), (0.0, 5.0), (10.0, 5.0)),
        nothing((-5.0, 11.0), (15.0, 11.0)),
        nothing((-1.0, 15.0), (-1.0, -5.0)),
        nothing((11.0, 10.0), (15.0, 10.0)),
        // Ends on two sides; one end on a side, on a corner.
        whole((0.0, 5.0), (10.0, 6.0)),
        kept((10.0, 5.0), (15.0, 5.0), (10.0, 5.0), (10.0, 5.0)),
        kept((15.0, 15.0), (10.0, 10.0), (10.0, 10.0), (10.0, 10.0)),
        // In and out at one point, the corner (10, 10); past it by one double.
        kept((5.0, 15.0), (15.0, 5.0), (10.0, 10.0), (10.0, 10.0)),
        nothing((5.0, 15.0), (15.0, 5.0_f64.next_up())),
        // In through one corner and out through the other.
        kept((-3.0, -3.0), (13.0, 13.0), (0.0, 0.0), (10.0, 10.0)),
        // Beyond what differences of doubles hold.
        kept((-huge, 5.0), (huge, 5.0), (0.0, 5.0), (10.0, 5.0)),
        kept((-huge, -huge), (huge, huge), (0.0, 0.0), (10.0, 10.0)),
        kept((-1e308, 0.0), (1e308, 10.0), (0.0, 5.0), (10.0, 5.0)),
        nothing((-huge, huge), (huge, huge)),
        nothing((huge, -huge), (huge, huge)),
        // The smallest numbers.
        kept((-tiny, tiny), (tiny, tiny), (0.0, tiny), (tiny, tiny)),
        nothing((-tiny, 5.0), (-tiny, 6.0)),
        nothing((-tiny, -tiny), (-tiny, 20.0)),
        nothing((-5.0, -tiny), (15.0, -tiny)),
    ]
}

/// What any method has to give.
pub(crate) fn check(clip: impl Fn(&Window, Segment) -> Option<Segment>) {
    let cases = in_the_lectures_window();
    for &(s, expected) in &cases {
        assert_eq!(clip(&lecture(), s), expected, "{s:?}");
        let turned = expected.map(Segment::reversed);
        assert_eq!(clip(&lecture(), s.reversed()), turned, "{s:?}");
    }
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for k in 0..4 {
            let mut x = [5.0; 4];
            x[k] = bad;
            let s = segment((x[0], x[1]), (x[2], x[3]));
            assert_eq!(clip(&lecture(), s), None, "{x:?}");
        }
    }
    // A window that is a point.
    let dot = Window::new(DVec2::splat(5.0), DVec2::splat(5.0)).unwrap();
    let point = Some(segment((5.0, 5.0), (5.0, 5.0)));
    for (a, b) in [
        ((0.0, 0.0), (10.0, 10.0)),
        ((5.0, 0.0), (5.0, 9.0)),
        ((-5.0, 4.0), (15.0, 6.0)),
        ((4.0, -5.0), (6.0, 15.0)),
    ] {
        assert_eq!(clip(&dot, segment(a, b)), point, "{a:?} {b:?}");
    }
    let beside = segment((0.0, 0.0), (10.0, 10.0_f64.next_up()));
    assert_eq!(clip(&dot, beside), None);
    // Windows made by hand.
    let (min, max) = (DVec2::new(10.0, 0.0), DVec2::new(0.0, 10.0));
    for (min, max) in [
        (min, max),
        (max, min),
        (DVec2::ONE, DVec2::ZERO),
        (DVec2::NAN, max),
        (DVec2::ZERO, DVec2::NAN),
    ] {
        let by_hand = Window { min, max };
        for &(s, _) in &cases {
            assert_eq!(clip(&by_hand, s), None, "{by_hand:?} {s:?}");
        }
    }
}
