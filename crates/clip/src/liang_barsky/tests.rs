use super::*;
use ombra_math::glam::DVec2;
use ombra_math::work::Work;

fn segment(a: (f64, f64), b: (f64, f64)) -> Segment {
    Segment::new(a.into(), b.into())
}

fn lecture() -> Window {
    Window::new(DVec2::ZERO, DVec2::splat(10.0)).unwrap()
}

#[test]
fn degenerate() {
    let (huge, tiny) = (f64::MAX, 5e-324);
    let cases = [
        // All p_k = 0: a point inside, on a side, outside.
        (
            segment((5.0, 5.0), (5.0, 5.0)),
            Some(segment((5.0, 5.0), (5.0, 5.0))),
        ),
        (
            segment((10.0, 5.0), (10.0, 5.0)),
            Some(segment((10.0, 5.0), (10.0, 5.0))),
        ),
        (segment((5.0, 11.0), (5.0, 11.0)), None),
        // Two p_k = 0: along a side, between the sides, beside them.
        (
            segment((0.0, 15.0), (0.0, -5.0)),
            Some(segment((0.0, 10.0), (0.0, 0.0))),
        ),
        (
            segment((-5.0, 5.0), (15.0, 5.0)),
            Some(segment((0.0, 5.0), (10.0, 5.0))),
        ),
        (segment((-1.0, 15.0), (-1.0, -5.0)), None),
        // Entry and exit at one t, in the corner (10, 10); the exit first, by one double.
        (
            segment((5.0, 15.0), (15.0, 5.0)),
            Some(segment((10.0, 10.0), (10.0, 10.0))),
        ),
        (segment((5.0, 15.0), (15.0, 5.0_f64.next_up())), None),
        // Two entries at one t, and two exits: along the diagonal.
        (
            segment((-3.0, -3.0), (13.0, 13.0)),
            Some(segment((0.0, 0.0), (10.0, 10.0))),
        ),
        // p_k beyond the largest double, and below what t can tell from 0.
        (
            segment((-huge, 5.0), (huge, 5.0)),
            Some(segment((0.0, 5.0), (10.0, 5.0))),
        ),
        (
            segment((-huge, -huge), (huge, huge)),
            Some(segment((0.0, 0.0), (10.0, 10.0))),
        ),
        (
            segment((tiny, tiny), (-tiny, tiny)),
            Some(segment((tiny, tiny), (0.0, tiny))),
        ),
        (segment((-tiny, -tiny), (-tiny, 20.0)), None),
    ];
    for (s, expected) in cases {
        assert_eq!(clip_segment(&lecture(), s), expected, "{s:?}");
        let turned = expected.map(Segment::reversed);
        assert_eq!(clip_segment(&lecture(), s.reversed()), turned, "{s:?}");
    }
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for k in 0..4 {
            let mut x = [5.0; 4];
            x[k] = bad;
            let s = segment((x[0], x[1]), (x[2], x[3]));
            assert_eq!(clip_segment(&lecture(), s), None, "{x:?}");
        }
    }
    let across = segment((4.0, -5.0), (6.0, 15.0));
    let dot = Window::new(DVec2::splat(5.0), DVec2::splat(5.0)).unwrap();
    assert_eq!(
        clip_segment(&dot, across),
        Some(segment((5.0, 5.0), (5.0, 5.0)))
    );
    for (min, max) in [(DVec2::ONE, DVec2::ZERO), (DVec2::ZERO, DVec2::NAN)] {
        assert_eq!(clip_segment(&Window { min, max }, across), None);
    }
}

#[test]
fn only_what_is_left_is_intersected() {
    let count = |s| {
        let mut work = Work::default();
        let _ = clip_segment_counted(&lecture(), s, &mut work);
        [work.divisions, work.multiplications]
    };
    // Entry and exit are parallel sides, their t compared without a product; then sides at an angle.
    assert_eq!(count(segment((-5.0, 5.0), (15.0, 5.0))), [2, 0]);
    assert_eq!(count(segment((-5.0, 5.0), (5.0, 15.0))), [2, 2]);
    assert_eq!(count(segment((-6.0, 5.0), (5.0, 16.0))), [0, 2]);
}
