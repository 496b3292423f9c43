use super::*;
use crate::report::made_up::{self, row};

fn sweep(questions: Vec<Vec<Row>>) -> Measured {
    made_up::sweep("", questions)
}

#[test]
fn the_cheapest_that_keeps_the_tolerance() {
    let at = |k: f64, fast: Option<f64>, slow: Option<f64>| {
        vec![
            row("slow", k, 8.0 + k, slow),
            row("fast", k, 1.0 + k / 100.0, fast),
        ]
    };
    let mixed = sweep(vec![
        at(1.0, Some(1e-9), Some(0.0)),
        at(2.0, Some(1e-9), Some(0.0)),
        at(3.0, Some(2e-9), Some(0.0)),
        // A missing answer is no answer.
        at(4.0, None, Some(0.0)),
        at(5.0, None, Some(1.0)),
    ]);
    let found = stretches(&mixed, 1e-9);
    let plain: Vec<_> = found.iter().map(|s| (s.technique, s.from, s.to)).collect();
    assert_eq!(
        plain,
        [
            (Some("fast"), 1.0, 2.0),
            (Some("slow"), 3.0, 4.0),
            (None, 5.0, 5.0)
        ]
    );
    assert_eq!(
        (found[0].ratios, found[1].ratios),
        ((1.01, 1.02), (11.0, 12.0))
    );
    assert!(found[2].ratios.0.is_nan());
    assert_eq!(stretches(&sweep(vec![vec![]]), 1.0), []);
}

/// Both always right; their times over the settings 0, 1, 2, …
fn timed(a: &[f64], b: &[f64]) -> Vec<(Option<&'static str>, f64, f64)> {
    let questions = a.iter().zip(b).enumerate();
    let questions = questions.map(|(k, (&a, &b))| {
        let k = k as f64;
        vec![row("a", k, a, Some(0.0)), row("b", k, b, Some(0.0))]
    });
    let found = stretches(&sweep(questions.collect()), 0.0);
    found.iter().map(|s| (s.technique, s.from, s.to)).collect()
}

#[test]
fn one_noisy_time_does_not_change_the_advice() {
    let all = [(Some("a"), 0.0, 2.0)];
    assert_eq!(timed(&[1.0, 3.0, 1.0], &[2.0; 3]), all);
    // Nor does a technique that is hardly cheaper at one end.
    assert_eq!(timed(&[1.0, 1.0, 1.2], &[1.2, 1.2, 1.0]), all);
    assert_eq!(timed(&[1.2, 1.0, 1.0], &[1.0, 1.2, 1.2]), all);
}

#[test]
fn where_two_techniques_cross_the_advice_changes() {
    let crossed = timed(&[1.0, 2.0, 4.0, 8.0], &[3.0; 4]);
    assert_eq!(crossed, [(Some("a"), 0.0, 1.0), (Some("b"), 2.0, 3.0)]);
    let at_the_last = timed(&[1.0, 1.0, 4.0], &[3.0; 3]);
    assert_eq!(at_the_last, [(Some("a"), 0.0, 1.0), (Some("b"), 2.0, 2.0)]);
}

#[test]
fn of_a_knob_within_one_question_the_cheapest_setting_is_taken() {
    let samples = |n: f64, error| row("samples", n, n, Some(error));
    let sweep = sweep(vec![vec![
        samples(16.0, 0.001),
        samples(4.0, 0.01),
        samples(1.0, 0.1),
    ]]);
    assert_eq!(stretches(&sweep, 0.02)[0].from, 4.0);
}

#[test]
fn words() {
    for (x, text) in [
        (1e-9, "10⁻⁹"),
        (1e15, "10¹⁵"),
        (1.0, "1"),
        (2.5e-4, "2.5·10⁻⁴"),
        (4.0, "4"),
        (3e20, "3·10²⁰"),
        (10.0, "10"),
    ] {
        assert_eq!(power_of_ten(x), text);
    }
    assert_eq!(
        [0.043, 0.635, 9.94, 48.9].map(times),
        ["0.04", "0.6", "9.9", "49"]
    );
    for (share, text) in [
        (0.0, "0 %"),
        (1.0, "100 %"),
        (0.5, "50 %"),
        (0.0423, "4.2 %"),
        (0.0999, "10 %"),
        (0.99, "99 %"),
        (0.9987, "99.87 %"),
        (1.0 - 2f64.powi(-20), "99.999905 %"),
        (1e-20, "0.0000000000000000010 %"),
        (3.1e-5, "0.0031 %"),
    ] {
        assert_eq!(percent(share), text);
    }
    let range = |low, high| between((low, high), times);
    assert_eq!(
        (range(0.5, 1.4), range(0.51, 0.54)),
        ("0.5 to 1.4".into(), "0.5".into())
    );
    assert_eq!(extent([3.0, 1.0, 2.0]), (1.0, 3.0));
    let parts = ["a", "b", "c"].map(str::to_owned);
    assert_eq!(listed(&parts), "a, b and c");
    assert_eq!(listed(&parts[..2]), "a and b");
    assert_eq!(listed(&parts[..1]), "a");
    assert_eq!(listed(&[]), "");
}
