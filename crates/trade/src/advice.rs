//! Sentences from numbers: which technique to take where.

use crate::report::Measured;

/// A range of a sweep over which one technique is the one to take.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stretch {
    /// The cheapest technique that keeps the tolerance; `None` where none does.
    pub technique: Option<&'static str>,
    /// The easiest setting of the range.
    pub from: f64,
    /// The hardest.
    pub to: f64,
    /// The smallest and the largest of its times over the baseline's; NaN where there is no technique.
    pub ratios: (f64, f64),
}

/// Divides a sweep into the ranges over which the cheapest technique that keeps `tolerance` is the same.
///
/// # Properties
///
/// A technique keeps the tolerance at a setting when its error there, by the study's first measure, does not exceed it.
/// Which of
/// two is cheaper is decided once for the sweep, by the median of their ratios to the baseline, so that the noise of
/// single times does not make the advice waver.
#[must_use]
pub fn stretches(sweep: &Measured, tolerance: f64) -> Vec<Stretch> {
    let mut by_cost = sweep.techniques();
    by_cost.sort_by(|a, b| sweep.typical_ratio(a).total_cmp(&sweep.typical_ratio(b)));
    let mut stretches: Vec<Stretch> = Vec::new();
    for question in &sweep.questions {
        // Of several settings of one technique in one question, the cheapest that keeps it.
        let keeps = |technique: &&str| {
            let good = question
                .rows
                .iter()
                .filter(|row| row.technique == *technique && row.error <= tolerance);
            good.min_by(|a, b| a.ratio.total_cmp(&b.ratio))
        };
        let best = by_cost.iter().find_map(keeps);
        let Some(setting) = best.or(question.rows.first()).map(|row| row.setting) else {
            continue;
        };
        let (technique, ratio) = (
            best.map(|row| row.technique),
            best.map_or(f64::NAN, |row| row.ratio),
        );
        match stretches.last_mut() {
            Some(last) if last.technique == technique => {
                last.to = setting;
                last.ratios = (last.ratios.0.min(ratio), last.ratios.1.max(ratio));
            }
            _ => stretches.push(Stretch {
                technique,
                from: setting,
                to: setting,
                ratios: (ratio, ratio),
            }),
        }
    }
    stretches
}

/// `a`, `a and b`, `a, b and c`.
#[must_use]
pub fn listed(parts: &[String]) -> String {
    match parts {
        [] => String::new(),
        [one] => one.clone(),
        [most @ .., last] => format!("{} and {last}", most.join(", ")),
    }
}

/// A power of ten as people write it: `10⁻⁹`; other numbers with two digits, `2.5·10⁻⁹`.
#[must_use]
pub fn power_of_ten(x: f64) -> String {
    let text = format!("{x:.1e}");
    let (digits, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    let power: String = exponent
        .chars()
        .map(|c| match c {
            '-' => '⁻',
            '1' => '¹',
            '2' => '²',
            '3' => '³',
            digit => digit
                .to_digit(10)
                .and_then(|d| char::from_u32('⁰' as u32 + d))
                .unwrap_or(digit),
        })
        .collect();
    match (digits, exponent) {
        ("1.0", "0") => "1".to_owned(),
        ("1.0", "1") => "10".to_owned(),
        ("1.0", _) => format!("10{power}"),
        (digits, "0") => digits.trim_end_matches(".0").to_owned(),
        (digits, _) => format!("{}·10{power}", digits.trim_end_matches(".0")),
    }
}

/// A ratio of times with two digits, one decimal below 10: `0.6`, `49`.
#[must_use]
pub fn times(ratio: f64) -> String {
    if ratio < 9.95 {
        format!("{ratio:.1}")
    } else {
        format!("{ratio:.0}")
    }
}

/// A share in percent with two digits: `0.0031 %`, `4.2 %`, `87 %`.
#[must_use]
pub fn percent(share: f64) -> String {
    let percent = 100.0 * share;
    // The power of ten of the first digit, after rounding to two.
    let text = format!("{percent:.1e}");
    let exponent = text
        .split_once('e')
        .and_then(|(_, e)| e.parse::<i32>().ok());
    let decimals = (1 - exponent.unwrap_or(1)).clamp(0, 9) as usize;
    match percent {
        0.0 => "0 %".to_owned(),
        100.0 => "100 %".to_owned(),
        _ => format!("{percent:.decimals$} %"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::deviation::Deviation;
    use crate::report::{Answered, Row};
    use crate::statistics::Quartiles;
    use ombra_math::work::Work;

    fn row(technique: &'static str, setting: f64, ratio: f64, error: Option<f64>) -> Row {
        Row {
            technique,
            setting,
            // Without an error, one of two answers is missing and the other right.
            error: Deviation::of([Some(0.0), error]).worst(),
            deviation: Deviation::of([Some(0.0), error]),
            faults: vec![],
            work: Work::default(),
            nanoseconds: Quartiles::of(&[ratio]),
            ratio,
            on_front: false,
        }
    }

    fn sweep(questions: Vec<Vec<Row>>) -> Measured {
        let questions = questions.into_iter().map(|rows| Answered {
            inputs: String::new(),
            units: 1,
            rows,
        });
        Measured {
            name: "",
            knob: "",
            charted: 0,
            questions: questions.collect(),
        }
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

    #[test]
    fn one_noisy_time_does_not_change_the_advice() {
        let at =
            |k: f64, a: f64, b: f64| vec![row("a", k, a, Some(0.0)), row("b", k, b, Some(0.0))];
        let mixed = sweep(vec![
            at(1.0, 1.0, 2.0),
            at(2.0, 3.0, 2.0),
            at(3.0, 1.0, 2.0),
        ]);
        let found = stretches(&mixed, 0.5);
        assert_eq!(
            (found.len(), found[0].technique, found[0].ratios),
            (1, Some("a"), (1.0, 3.0))
        );
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
            (times(0.635), times(9.94), times(48.9)),
            ("0.6".into(), "9.9".into(), "49".into())
        );
        for (share, text) in [
            (0.0, "0 %"),
            (1.0, "100 %"),
            (0.5, "50 %"),
            (0.0423, "4.2 %"),
            (0.0999, "10 %"),
            (3.1e-5, "0.0031 %"),
        ] {
            assert_eq!(percent(share), text);
        }
        let parts = ["a", "b", "c"].map(str::to_owned);
        assert_eq!(listed(&parts), "a, b and c");
        assert_eq!(listed(&parts[..2]), "a and b");
        assert_eq!(listed(&parts[..1]), "a");
        assert_eq!(listed(&[]), "");
    }
}
