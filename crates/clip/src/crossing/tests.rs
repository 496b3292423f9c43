use super::*;

fn segment(a: (f64, f64), b: (f64, f64)) -> Segment {
    Segment::new(a.into(), b.into())
}

#[test]
fn degenerate() {
    let (huge, tiny) = (f64::MAX, 5e-324);
    let cases = [
        // Between the ends, at either, beyond them.
        (segment((0.0, 1.0), (3.0, 2.0)), 1.0, Some(4.0 / 3.0)),
        (segment((0.1, 0.7), (0.3, 0.2)), 0.1, Some(0.7)),
        (segment((0.1, 0.7), (0.3, 0.2)), 0.3, Some(0.2)),
        (segment((0.1, 0.7), (0.3, 0.2)), 0.3_f64.next_up(), None),
        // Parallel to the line: on it, beside it; a point on it.
        (segment((1.0, 0.0), (1.0, 5.0)), 1.0, None),
        (segment((1.0, 0.0), (1.0, 5.0)), 2.0, None),
        (segment((1.0, 2.0), (1.0, 2.0)), 1.0, None),
        // Level: its own y.
        (segment((-7.0, 0.1), (3.0, 0.1)), 0.3, Some(0.1)),
        // Differences that overflow; that are smaller than any normal double.
        (segment((-huge, 0.0), (huge, 10.0)), 0.0, Some(5.0)),
        (segment((-huge, -huge), (huge, huge)), 3.0, Some(3.0)),
        (segment((-huge, huge), (huge, -huge)), huge, Some(-huge)),
        (
            segment((0.0, 0.0), (3.0 * tiny, 3.0 * tiny)),
            2.0 * tiny,
            Some(2.0 * tiny),
        ),
        // Half of the smallest double goes to even, 0.
        (segment((0.0, 0.0), (2.0, tiny)), 1.0, Some(0.0)),
        (segment((0.0, 0.0), (4.0, tiny)), 3.0, Some(tiny)),
        // −0 is 0.
        (segment((-1.0, -1.0), (1.0, 1.0)), -0.0, Some(0.0)),
    ];
    for (s, x, y) in cases {
        let bits = |y: Option<f64>| y.map(f64::to_bits);
        assert_eq!(bits(at_x(s, x)), bits(y), "{s:?} {x}");
        assert_eq!(bits(at_x(s.reversed(), x)), bits(y), "{s:?} {x}");
        let turned = Segment::new(s.a.yx(), s.b.yx());
        assert_eq!(bits(at_y(turned, x)), bits(y), "{s:?} {x}");
    }
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for k in 0..5 {
            let mut x = [0.0, 1.0, 4.0, 3.0, 2.0];
            assert_eq!(at_x(segment((x[0], x[1]), (x[2], x[3])), x[4]), Some(2.0));
            x[k] = bad;
            assert_eq!(
                at_x(segment((x[0], x[1]), (x[2], x[3])), x[4]),
                None,
                "{x:?}"
            );
        }
    }
}

#[test]
fn quick_comparison_is_the_exact_one() {
    let (huge, tiny) = (f64::MAX, 5e-324);
    let near = |x: f64| [x.next_down(), x, x.next_up()];
    for s in [
        segment((0.0, 0.0), (3.0, 3.0)),
        segment((0.1, 0.3), (0.7, 0.9)),
        segment((0.7, 0.9), (0.1, -0.3)),
        segment((-huge, -huge), (huge, huge)),
        segment((-tiny, tiny), (3.0 * tiny, -tiny)),
        segment((-1e-200, 1e-200), (3e-200, 5e-200)),
        segment((0.0, 1e300), (1e-300, -1e300)),
    ] {
        for x in near(0.5 * s.a.x + 0.5 * s.b.x) {
            let line = Line::Vertical(x);
            for y in near(0.5 * s.a.y + 0.5 * s.b.y) {
                let exact = compare_exactly(s, line, y);
                assert_eq!(compare_quickly(s, line, y), exact, "{s:?} {x} {y}");
                let turned = Segment::new(s.a.yx(), s.b.yx());
                let line = Line::Horizontal(x);
                assert_eq!(compare_quickly(turned, line, y), exact, "{s:?} {x} {y}");
            }
        }
    }
}
