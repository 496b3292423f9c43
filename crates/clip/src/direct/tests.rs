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
        // A point inside, on a corner, outside.
        (
            segment((5.0, 5.0), (5.0, 5.0)),
            Some(segment((5.0, 5.0), (5.0, 5.0))),
        ),
        (
            segment((0.0, 10.0), (0.0, 10.0)),
            Some(segment((0.0, 10.0), (0.0, 10.0))),
        ),
        (segment((5.0, -1.0), (5.0, -1.0)), None),
        // Parallel to two sides: along one, between them, beside them.
        (
            segment((-5.0, 0.0), (15.0, 0.0)),
            Some(segment((0.0, 0.0), (10.0, 0.0))),
        ),
        (
            segment((5.0, -5.0), (5.0, 15.0)),
            Some(segment((5.0, 0.0), (5.0, 10.0))),
        ),
        (segment((-5.0, 11.0), (15.0, 11.0)), None),
        // Ends on two sides; collinear with a side, but beyond its end; with an end on a corner.
        (
            segment((0.0, 5.0), (10.0, 6.0)),
            Some(segment((0.0, 5.0), (10.0, 6.0))),
        ),
        (segment((11.0, 10.0), (15.0, 10.0)), None),
        (
            segment((15.0, 15.0), (10.0, 10.0)),
            Some(segment((10.0, 10.0), (10.0, 10.0))),
        ),
        // The largest numbers, the smallest.
        (
            segment((-huge, -huge), (huge, huge)),
            Some(segment((0.0, 0.0), (10.0, 10.0))),
        ),
        (segment((huge, -huge), (huge, huge)), None),
        (
            segment((-tiny, tiny), (tiny, tiny)),
            Some(segment((0.0, tiny), (tiny, tiny))),
        ),
        (segment((-tiny, 5.0), (-tiny, 6.0)), None),
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
    let across = segment((-5.0, 4.0), (15.0, 6.0));
    let dot = Window::new(DVec2::splat(5.0), DVec2::splat(5.0)).unwrap();
    assert_eq!(
        clip_segment(&dot, across),
        Some(segment((5.0, 5.0), (5.0, 5.0)))
    );
    for (min, max) in [(DVec2::ONE, DVec2::ZERO), (DVec2::NAN, DVec2::ONE)] {
        assert_eq!(clip_segment(&Window { min, max }, across), None);
    }
}

#[test]
fn parallel_sides_are_not_intersected() {
    let count = |s| {
        let mut work = Work::default();
        let _ = clip_segment_counted(&lecture(), s, &mut work);
        work.divisions
    };
    assert_eq!(count(segment((-5.0, 5.0), (15.0, 5.0))), 2);
    assert_eq!(count(segment((-5.0, 15.0), (15.0, -6.0))), 4);
    assert_eq!(count(segment((1.0, 1.0), (1.0, 1.0))), 0);
}
