use super::*;
use crate::oracle::{self, Exact, beside, is_nearest, number, r};
use ombra_math::work::Work;
use proptest::prelude::*;

fn cube() -> Box3 {
    Box3::new(DVec3::ZERO, DVec3::splat(10.0)).unwrap()
}

fn v(x: f64, y: f64, z: f64) -> DVec3 {
    DVec3::new(x, y, z)
}

#[test]
fn the_lectures_segments_at_one_depth() {
    let clip = |a: DVec3, b: DVec3| clip_segment(&cube(), [a, b]);
    assert_eq!(
        clip(v(2.0, 14.0, 5.0), v(8.0, -4.0, 5.0)),
        Some([v(10.0 / 3.0, 10.0, 5.0), v(20.0 / 3.0, 0.0, 5.0)])
    );
    assert_eq!(clip(v(4.0, 14.0, 5.0), v(14.0, 8.0, 5.0)), None);
    assert_eq!(clip(v(2.0, 14.0, 11.0), v(8.0, -4.0, 11.0)), None);
}

#[test]
fn codes_of_the_27_regions() {
    let mut seen = std::collections::BTreeSet::new();
    for x in [-1.0, 5.0, 11.0] {
        for y in [-1.0, 5.0, 11.0] {
            for z in [-1.0, 5.0, 11.0] {
                let code = outcode(&cube(), v(x, y, z));
                let bit = |is: bool, text: &'static str| if is { text } else { "0" };
                let expected = [y > 10.0, y < 0.0, x > 10.0, x < 0.0, z > 10.0, z < 0.0]
                    .map(|is| bit(is, "1"))
                    .concat();
                assert_eq!(code.to_string(), expected);
                seen.insert(code.bits());
            }
        }
    }
    assert_eq!(seen.len(), 27);
}

#[test]
fn degenerate() {
    let (huge, tiny) = (f64::MAX, 5e-324);
    let corner = v(10.0, 10.0, 10.0);
    let cases = [
        ([corner, corner], Some([corner, corner])),
        ([v(10.0, 10.0, 11.0); 2], None),
        // Along an edge; through a corner; past it by one double.
        (
            [v(10.0, 10.0, -5.0), v(10.0, 10.0, 15.0)],
            Some([v(10.0, 10.0, 0.0), corner]),
        ),
        (
            [v(5.0, 15.0, 10.0), v(15.0, 5.0, 10.0)],
            Some([corner, corner]),
        ),
        ([v(5.0, 15.0, 10.0), v(15.0, 5.0_f64.next_up(), 10.0)], None),
        (
            [v(-huge, 5.0, 5.0), v(huge, 5.0, 5.0)],
            Some([v(0.0, 5.0, 5.0), v(10.0, 5.0, 5.0)]),
        ),
        (
            [v(-huge, -huge, -huge), v(huge, huge, huge)],
            Some([DVec3::ZERO, corner]),
        ),
        ([v(-tiny, 5.0, 5.0), v(-tiny, 6.0, 5.0)], None),
    ];
    for (s, expected) in cases {
        assert_eq!(clip_segment(&cube(), s), expected, "{s:?}");
    }
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for k in 0..3 {
            let mut p = DVec3::splat(5.0);
            p[k] = bad;
            assert_eq!(clip_segment(&cube(), [p, DVec3::ONE]), None);
            assert_eq!(clip_segment(&cube(), [DVec3::ONE, p]), None);
            assert!(!cube().contains(p) && !outcode(&cube(), p).is_inside());
            assert!(matches!(Box3::new(p, p), Err(Box3Error::NotFinite { .. })));
        }
    }
    let swapped = Box3::new(v(0.0, 1.0, 0.0), v(1.0, 0.0, 1.0)).unwrap_err();
    assert!(swapped.to_string().contains("[0, 1, 0]"), "{swapped}");
    let by_hand = Box3 {
        min: DVec3::splat(10.0),
        max: DVec3::ZERO,
    };
    assert_eq!(
        clip_segment(&by_hand, [v(-5.0, 5.0, 5.0), v(15.0, 5.0, 5.0)]),
        None
    );
}

#[test]
fn counts_its_work() {
    let count = |a, b| {
        let mut work = Work::default();
        let answer = counted::clip_segment(&cube(), [a, b], &mut work);
        assert_eq!(answer, clip_segment(&cube(), [a, b]));
        let mut steps = Work::default();
        assert_eq!(clip_segment_plain(&cube(), [a, b], &mut steps), answer);
        // Four of a crossing's coordinates' limits are new.
        assert_eq!(steps.comparisons, 12 + 4 * steps.divisions);
        assert!(steps.divisions >= work.divisions);
        [work.comparisons, work.multiplications, work.divisions]
    };
    // Two codes of six, which say what each end lies beyond.
    assert_eq!(count(v(1.0, 1.0, 1.0), v(2.0, 2.0, 2.0)), [12, 0, 0]);
    assert_eq!(count(v(11.0, 1.0, 1.0), v(12.0, 20.0, 2.0)), [12, 0, 0]);
    assert_eq!(count(v(5.0, 5.0, 5.0), v(15.0, 5.0, 5.0)), [12, 0, 1]);
    // Entry and exit along one axis; along two.
    assert_eq!(count(v(-5.0, 5.0, 5.0), v(15.0, 5.0, 5.0)), [12 + 1, 0, 2]);
    assert_eq!(count(v(-5.0, 5.0, 5.0), v(5.0, 15.0, 5.0)), [12 + 1, 2, 2]);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(3000))]

    #[test]
    fn nearest_doubles(
        p in prop::array::uniform3(number()), q in prop::array::uniform3(number()), a in prop::array::uniform3(number()),
        lecture: bool, corner in prop::array::uniform3(any::<bool>()), t in 0.0..3.0f64, ulps in prop::array::uniform3(-2i64..3),
        c in prop::array::uniform3(number()), kind in 0u8..3,
    ) {
        let (p, q, a) = (DVec3::from(p), DVec3::from(q), DVec3::from(a));
        let bounds = if lecture { cube() } else { Box3::new(p.min(q), p.max(q)).unwrap() };
        // Through a corner, through an edge, anywhere.
        let through = DVec3::from_array([0, 1, 2].map(|k| if corner[k] { bounds.max[k] } else { bounds.min[k] }));
        let b = through + (through - a) * t;
        let b = DVec3::from_array([0, 1, 2].map(|k| if kind == 2 || (kind == 1 && k == 2) { c[k] } else { beside(b[k], ulps[k]) }));
        prop_assume!(b.is_finite());
        let sides: Vec<[Exact; 2]> = (0..3)
            .flat_map(|k| [
                [r(a[k]) - r(bounds.min[k]), r(b[k]) - r(bounds.min[k])],
                [r(bounds.max[k]) - r(a[k]), r(bounds.max[k]) - r(b[k])],
            ])
            .collect();
        let expected = oracle::not_negative(&sides);
        let clipped = clip_segment(&bounds, [a, b]);
        prop_assert_eq!(clip_segment_plain(&bounds, [a, b], &mut ()), clipped);
        prop_assert_eq!(clipped.is_some(), expected.is_some());
        if let (Some(clipped), Some(t)) = (clipped, expected) {
            for (p, t) in clipped.iter().zip(&t) {
                prop_assert!(bounds.contains(*p));
                for k in 0..3 {
                    prop_assert!(is_nearest(p[k], &oracle::at(t, a[k], b[k])));
                }
            }
            prop_assert!(!bounds.contains(a) || clipped[0] == a);
            prop_assert_eq!(clip_segment(&bounds, clipped), Some(clipped));
            prop_assert_eq!(clip_segment(&bounds, [b, a]), Some([clipped[1], clipped[0]]));
        }
    }

    #[test]
    fn never_panics(x in prop::collection::vec(proptest::num::f64::ANY, 12)) {
        let p: Vec<DVec3> = x.chunks_exact(3).map(DVec3::from_slice).collect();
        for bounds in [Box3 { min: p[0], max: p[1] }, Box3 { min: p[0].min(p[1]), max: p[0].max(p[1]) }] {
            let clipped = clip_segment(&bounds, [p[2], p[3]]);
            prop_assert_eq!(clip_segment_plain(&bounds, [p[2], p[3]], &mut ()), clipped);
            if let Some(clipped) = clipped {
                prop_assert!(clipped.iter().all(|&p| bounds.contains(p)));
            }
            prop_assert_eq!(outcode(&bounds, p[2]).is_inside(), bounds.contains(p[2]));
        }
    }
}
