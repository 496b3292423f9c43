use super::*;
use crate::extremes::segment;
use crate::oracle::number;
use fearless_simd::{Fallback, Level, Simd, SimdFrom, SimdMask, dispatch, f64x4};
use proptest::prelude::*;

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

/// Four crossings: across c from the first to the second end, and along.
type Four = [[f64; 4]; 5];

/// [`several_at`] in four lanes: the answers that are certain.
#[inline(always)]
fn four_at<S: Simd>(simd: S, [c, x0, x1, y0, y1]: Four) -> [Option<u64>; 4] {
    let four = |x: [f64; 4]| f64x4::simd_from(simd, x);
    let (y, certain) = several_at(four(c), [x0, x1].map(four), [y0, y1].map(four));
    let certain = certain.to_bitmask();
    core::array::from_fn(|i| (certain >> i & 1 != 0).then(|| y[i].to_bits()))
}

/// The same in two lanes, twice.
fn twice_two_at([c, x0, x1, y0, y1]: Four) -> [Option<u64>; 4] {
    let pair = |x: [f64; 4], i: usize| DVec2::new(x[i], x[i + 1]);
    let at = |i: usize| {
        let ends = |x: [f64; 4], y: [f64; 4]| [pair(x, i), pair(y, i)];
        let (y, certain) = several_at(pair(c, i), ends(x0, x1), ends(y0, y1));
        [0, 1].map(|lane| (certain[lane] != 0).then(|| y[lane].to_bits()))
    };
    let ([p, q], [r, s]) = (at(0), at(2));
    [p, q, r, s]
}

/// Every form, which must agree.
fn certain(four: Four) -> [Option<u64>; 4] {
    let pairs = twice_two_at(four);
    assert_eq!(four_at(Fallback::new(), four), pairs, "{four:?}");
    assert_eq!(
        dispatch!(Level::new(), simd => four_at(simd, four)),
        pairs,
        "{four:?}"
    );
    pairs
}

#[test]
fn what_is_certain_at_once() {
    let third = 1.0 / 3.0;
    let four = [
        [1.0; 4],
        [0.0, 3.0, 0.0, 0.0],
        [3.0, 0.0, 2.0, 2.0],
        [0.0, 0.0, 1.0, 0.0],
        [1.0, 1.0, 1.0, 0.0],
    ];
    // 1/3 and 2/3 of the way; a level segment; one along the axis, where 0 is left to a closer look.
    let expected = [Some(third), Some(2.0 * third), Some(1.0), None];
    assert_eq!(certain(four), expected.map(|y| y.map(f64::to_bits)));
    // Halfway between doubles, past the largest, below the smallest, no number.
    let (tie, huge, tiny) = (1.0_f64.next_up(), f64::MAX, 5e-324);
    let four = [
        [1.0, 0.0, tiny, 1.0],
        [0.0, -huge, 0.0, 0.0],
        [2.0, huge, 2.0 * tiny, f64::NAN],
        [1.0, 0.0, 0.0, 0.0],
        [tie, 1.0, 1.0, 1.0],
    ];
    assert_eq!(certain(four), [None; 4]);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(6000))]

    #[test]
    fn certain_is_the_nearest_double(across in prop::array::uniform4(prop::array::uniform3(number())), y0 in prop::array::uniform4(number()), y1 in prop::array::uniform4(number())) {
        let across = across.map(|mut x| {
            x.sort_by(f64::total_cmp);
            x
        });
        let [x0, c, x1] = [0, 1, 2].map(|k| across.map(|x| x[k]));
        for (i, found) in certain([c, x0, x1, y0, y1]).into_iter().enumerate() {
            let (s0, s1) = ([[x0[i], 1.0], [-c[i], 1.0]], [[x1[i], 1.0], [-c[i], 1.0]]);
            if let Some(found) = found {
                let exact = exact(&s0, &s1, [y0[i], y1[i]]);
                prop_assert_eq!(found, exact.to_bits(), "{} {}", f64::from_bits(found), exact);
            }
        }
    }
}
