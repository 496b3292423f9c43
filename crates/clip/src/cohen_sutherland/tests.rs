use super::*;
use crate::extremes::{check, lecture, segment};
use crate::oracle::{self, is_nearest, r, window_and_segment};
use crate::{direct, liang_barsky};
use ombra_math::work::Work;
use proptest::prelude::*;

/// The answer of every method, which must be one.
fn clip(window: &Window, s: Segment) -> Option<Segment> {
    let answers = [
        clip_segment(window, s),
        clip_segment_plain(window, s, &mut ()),
        direct::clip_segment(window, s),
        liang_barsky::clip_segment(window, s),
        liang_barsky::clip_segment_plain(window, s, &mut ()),
        trace(window, s)
            .last()
            .filter(|step| step.decision == Decision::Accept)
            .map(|step| step.segment),
    ];
    let bits = |s: Option<Segment>| s.map(|s| [s.a.x, s.a.y, s.b.x, s.b.y].map(f64::to_bits));
    for other in answers {
        assert_eq!(
            bits(answers[0]),
            bits(other),
            "{window:?} {s:?}: {answers:?}"
        );
    }
    answers[0]
}

#[test]
fn the_lectures_segments() {
    let w = lecture();
    assert_eq!(
        clip(&w, segment((-5.0, 5.0), (15.0, 5.0))),
        Some(segment((0.0, 5.0), (10.0, 5.0)))
    );
    assert_eq!(
        clip(&w, segment((2.0, 14.0), (8.0, -4.0))),
        Some(segment((10.0 / 3.0, 10.0), (20.0 / 3.0, 0.0)))
    );
    assert_eq!(clip(&w, segment((4.0, 14.0), (14.0, 8.0))), None);
}

#[test]
fn the_lectures_codes() {
    let w = lecture();
    let code = |x: f64, y: f64| outcode(&w, DVec2::new(x, y));
    let expected = [
        ["1001", "1000", "1010"],
        ["0001", "0000", "0010"],
        ["0101", "0100", "0110"],
    ];
    for (row, y) in expected.iter().zip([15.0, 5.0, -5.0]) {
        for (code_, x) in row.iter().zip([-5.0, 5.0, 15.0]) {
            assert_eq!(code(x, y).to_string(), *code_);
        }
    }
    let and = |p: (f64, f64), q: (f64, f64)| (code(p.0, p.1) & code(q.0, q.1)).to_string();
    assert_eq!(and((-5.0, 15.0), (15.0, 15.0)), "1000");
    assert_eq!(and((2.0, -5.0), (8.0, -5.0)), "0100");
    assert_eq!(and((-5.0, 5.0), (-5.0, -5.0)), "0001");
    assert_eq!((code(-5.0, 15.0) | code(15.0, 5.0)).to_string(), "1011");
}

#[test]
fn the_lectures_iterations() {
    let steps = trace(&lecture(), segment((2.0, 14.0), (8.0, -4.0)));
    let cut = |side, replaces_a| Decision::Cut { side, replaces_a };
    let decisions: Vec<_> = steps.iter().map(|step| step.decision).collect();
    assert_eq!(
        decisions,
        [
            cut(Side::Above, true),
            cut(Side::Below, false),
            Decision::Accept
        ]
    );
    assert_eq!(steps[1].segment, segment((10.0 / 3.0, 10.0), (8.0, -4.0)));
    // Errata E22: AND is tested again after the cut.
    let steps = trace(&lecture(), segment((4.0, 14.0), (14.0, 8.0)));
    assert_eq!(steps.len(), 2);
    assert_eq!(steps[1].segment.a, DVec2::new(32.0 / 3.0, 10.0));
    assert_eq!(steps[1].codes.map(|c| c.to_string()), ["0010", "0010"]);
    assert_eq!(steps[1].decision, Decision::Reject);
}

#[test]
fn beside_a_corner() {
    let w = lecture();
    // Through (0, 10) exactly; then the far end one double up, and one down.
    let through = segment((-3.0, 7.0), (5.0, 15.0));
    let corner = DVec2::new(0.0, 10.0);
    assert_eq!(clip(&w, through), Some(Segment::new(corner, corner)));
    assert_eq!(
        clip(&w, segment((-3.0, 7.0), (5.0, 15.0_f64.next_up()))),
        None
    );
    let inside = clip(&w, segment((-3.0, 7.0), (5.0, 15.0_f64.next_down()))).unwrap();
    assert!(w.contains(inside.a) && w.contains(inside.b));
}

#[test]
fn degenerate() {
    check(clip);
}

#[test]
fn counts_its_work() {
    let count = |s| {
        let w = lecture();
        let [mut fast, mut steps, mut direct, mut by_t] = [Work::default(); 4];
        let _ = counted::clip_segment(&w, s, &mut fast);
        let _ = clip_segment_plain(&w, s, &mut steps);
        let _ = direct::counted::clip_segment(&w, s, &mut direct);
        let _ = liang_barsky::counted::clip_segment(&w, s, &mut by_t);
        [fast, steps, direct, by_t].map(|w| (w.divisions, w.comparisons, w.multiplications))
    };
    // Inside, all codes or inequalities and nothing else; so beyond one side, but for the direct method.
    assert_eq!(
        count(segment((1.0, 1.0), (2.0, 2.0))),
        [(0, 8, 0), (0, 8, 0), (0, 8, 0), (0, 8, 0)]
    );
    assert_eq!(
        count(segment((-5.0, 15.0), (-6.0, 5.0))),
        // It meets y = 10, in vain. Liang and Barsky see no end beyond the sides but one above and both to the left.
        [(0, 8, 0), (0, 8, 0), (1, 22, 0), (0, 8, 0)]
    );
    // In above and out below, both level.
    assert_eq!(
        count(segment((2.0, 14.0), (8.0, -4.0))),
        [(2, 16, 4), (2, 12, 0), (2, 24, 0), (2, 9, 0)]
    );
    // Above at x ≈ 9.3, below at x ≈ −0.2, so left too; the direct method also meets x = 10, in vain. Liang and Barsky
    // compare below with left, above with right, and the later entry with the earlier exit.
    assert_eq!(
        count(segment((-5.0, -5.0), (15.0, 16.0))),
        [(2, 16, 4), (3, 14, 0), (4, 28, 0), (2, 11, 6)]
    );
}

#[test]
fn the_textbooks_forms_round() {
    let w = lecture();
    let both = |s| {
        [
            textbook(&w, s, &mut ()),
            liang_barsky::textbook(&w, s, &mut ()),
        ]
    };
    for (s, left) in [
        (
            segment((2.0, 14.0), (8.0, -4.0)),
            Some(segment((10.0 / 3.0, 10.0), (20.0 / 3.0, 0.0))),
        ),
        (segment((4.0, 14.0), (14.0, 8.0)), None),
        (
            segment((-5.0, 5.0), (15.0, 5.0)),
            Some(segment((0.0, 5.0), (10.0, 5.0))),
        ),
        (
            segment((1.0, 2.0), (3.0, 4.0)),
            Some(segment((1.0, 2.0), (3.0, 4.0))),
        ),
        (segment((-1.0, 12.0), (11.0, 12.0)), None),
    ] {
        for answer in both(s) {
            assert_eq!(answer.is_some(), left.is_some(), "{s:?}");
            if let (Some(answer), Some(left)) = (answer, left) {
                // A few roundings of numbers below 16.
                let off = (answer.a - left.a).abs().max((answer.b - left.b).abs());
                assert!(off.max_element() <= 16.0 * f64::EPSILON * 4.0, "{answer:?}");
            }
        }
    }
    // What their pages tell.
    let far = segment((-1e12, 1.0 - 1e12), (1e12, 1e12));
    let [steps, _] = both(far);
    assert_eq!(clip(&w, far).unwrap().a, DVec2::new(0.0, 0.5));
    assert!((steps.unwrap().a.y - 0.49988).abs() < 5e-6, "{steps:?}");
    let far = segment((-3e12, 3.0 - 1e12), (3e12, 3.0 + 1e12));
    let [_, by_t] = both(far);
    assert_eq!(clip(&w, far).unwrap().b, DVec2::new(10.0, 19.0 / 3.0));
    assert!((by_t.unwrap().b.y - 6.33337).abs() < 5e-6, "{by_t:?}");
    let beside = segment((-0.1, 9.5), (0.225, 11.125));
    assert_eq!(clip(&w, beside), None);
    assert!(both(beside).iter().all(Option::is_some));
}

#[test]
fn the_textbooks_count_alike() {
    let count = |s| {
        let [mut steps, mut by_t] = [Work::default(); 2];
        let _ = textbook(&lecture(), s, &mut steps);
        let _ = liang_barsky::textbook(&lecture(), s, &mut by_t);
        [steps, by_t].map(|w| [w.divisions, w.comparisons, w.multiplications, w.additions])
    };
    // Two codes; then a crossing and its code for each end. Four sides; then a point for each end.
    assert_eq!(
        count(segment((2.0, 14.0), (8.0, -4.0))),
        [[2, 8 + 2 * 4, 2, 2 * 4], [4, 4 * 3, 2 * 2, 2 + 4 + 2 * 2]]
    );
    assert_eq!(
        count(segment((1.0, 2.0), (3.0, 4.0))),
        [[0, 8, 0, 0], [4, 12, 0, 6]]
    );
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(6000))]

    #[test]
    fn all_methods_give_the_nearest_doubles((w, s) in window_and_segment()) {
        let clipped = clip(&w, s);
        let expected = oracle::clip(&w, s);
        prop_assert_eq!(clipped.is_some(), expected.is_some(), "{:?}", expected);
        if let (Some(clipped), Some(expected)) = (clipped, expected) {
            for (p, q) in [clipped.a, clipped.b].iter().zip(&expected) {
                prop_assert!(is_nearest(p.x, &q[0]) && is_nearest(p.y, &q[1]), "{p}");
                prop_assert!(w.contains(*p));
            }
            prop_assert!(!w.contains(s.a) || clipped.a == s.a);
            prop_assert!(!w.contains(s.b) || clipped.b == s.b);
            prop_assert_eq!(clip(&w, clipped), Some(clipped));
            // Its direction: no coordinate turns round.
            let (d, e) = (s.b - s.a, clipped.b - clipped.a);
            prop_assert!(d.x.signum() * e.x >= 0.0 && d.y.signum() * e.y >= 0.0);
        }
        prop_assert_eq!(clip(&w, s.reversed()), clipped.map(Segment::reversed));
    }

    #[test]
    fn every_cut_is_at_the_nearest_double((w, s) in window_and_segment()) {
        let steps = trace(&w, s);
        for (before, after) in steps.iter().zip(steps.iter().skip(1)) {
            let Decision::Cut { side, replaces_a } = before.decision else {
                return Err(TestCaseError::fail("a step after the last"));
            };
            let p = if replaces_a { after.segment.a } else { after.segment.b };
            let across = match w.line(side) {
                Line::Vertical(x) => (p.x == x, crate::crossing::at_x(s, x) == Some(p.y)),
                Line::Horizontal(y) => (p.y == y, crate::crossing::at_y(s, y) == Some(p.x)),
            };
            prop_assert_eq!(across, (true, true));
        }
    }

    #[test]
    fn codes_and_inequalities_agree((w, s) in window_and_segment()) {
        prop_assert_eq!(outcode(&w, s.a).is_inside(), w.contains(s.a));
        for side in Side::ALL {
            prop_assert_eq!(outcode(&w, s.a).has(side), w.is_beyond(side, s.a));
        }
    }

    #[test]
    fn never_panics(x in prop::collection::vec(proptest::num::f64::ANY, 8)) {
        let (p, q) = (DVec2::new(x[0], x[1]), DVec2::new(x[2], x[3]));
        let s = segment((x[4], x[5]), (x[6], x[7]));
        for w in [Window { min: p, max: q }, Window { min: p.min(q), max: p.max(q) }] {
            if let Some(clipped) = clip(&w, s) {
                prop_assert!(w.contains(clipped.a) && w.contains(clipped.b));
            }
            prop_assert_eq!(outcode(&w, s.a).is_inside(), w.contains(s.a));
            let _ = (textbook(&w, s, &mut ()), liang_barsky::textbook(&w, s, &mut ()));
        }
    }

    #[test]
    fn crossings_are_nearest_doubles((w, s) in window_and_segment(), x in oracle::number()) {
        for x in [x, w.min.x] {
            let between = (s.a.x <= x && x <= s.b.x) || (s.b.x <= x && x <= s.a.x);
            let y = crate::crossing::at_x(s, x);
            prop_assert_eq!(y.is_some(), between && s.a.x != s.b.x);
            if let Some(y) = y {
                let t = (r(x) - r(s.a.x)).over(&(r(s.b.x) - r(s.a.x))).unwrap();
                prop_assert!(is_nearest(y, &(r(s.a.y) + t * (r(s.b.y) - r(s.a.y)))));
                let turned = segment((s.a.y, s.a.x), (s.b.y, s.b.x));
                prop_assert_eq!(crate::crossing::at_y(turned, x), Some(y));
            }
        }
    }
}
