//! The study's advice.

use crate::advice::{
    Advice, Choice, Stretch, between, digits, extent, percent, power_of_ten, stretches, times,
};
use crate::report::Measured;

/// A rounding of coordinates of the window's own size.
const TOLERANCE: f64 = f64::EPSILON;

/// The cheapest exact technique, by the share outside, what the other exact ones cost, and what the textbook forms gain
/// and lose.
pub fn advice(sweeps: &[Measured]) -> Advice {
    let find = |name: &str| sweeps.iter().find(|sweep| sweep.name == name);
    let (Some(outside), Some(far)) = (find("outside"), find("far-ends")) else {
        return Advice::default();
    };
    // A textbook form may stay within a rounding while ends are near, but not by itself.
    let is_exact = |technique: &&str| far.rows_of(technique).all(|row| row.error <= TOLERANCE);
    let (exact, rest): (Vec<_>, Vec<_>) = far.techniques().into_iter().partition(is_exact);
    let mut choice = outside.clone();
    for question in &mut choice.questions {
        question.rows.retain(|row| exact.contains(&row.technique));
    }
    let found = stretches(&choice, TOLERANCE);
    let baseline = found
        .iter()
        .find_map(|stretch| stretch.technique)
        .or(rest.first().copied());
    let baseline = baseline.unwrap_or("");
    let cost = |name: &str, (from, to): (f64, f64)| {
        let ratios = outside.rows_of(name).filter_map(|row| {
            let of = outside
                .rows_of(baseline)
                .find(|other| other.setting == row.setting)?;
            (from <= row.setting && row.setting <= to).then_some(row.ratio / of.ratio)
        });
        between(extent(ratios), times)
    };
    let taken = |stretch: &Stretch| Choice {
        need: "ends rounded once".to_owned(),
        method: stretch.name().to_owned(),
        setting: match found.len() {
            1 => "any segments".to_owned(),
            _ => format!("{} outside", stretch.range(percent)),
        },
        cost: stretch
            .technique
            .map_or_else(String::new, |name| cost(name, (stretch.from, stretch.to))),
        loss: match stretch.technique {
            Some(_) => "half a last digit".to_owned(),
            None => String::new(),
        },
    };
    let mut rows: Vec<Choice> = found.iter().map(taken).collect();
    let all = (f64::NEG_INFINITY, f64::INFINITY);
    let others = exact
        .iter()
        .filter(|name| !found.iter().any(|stretch| stretch.technique == Some(name)));
    rows.extend(others.map(|name| Choice {
        need: "the same ends, another way".to_owned(),
        method: (*name).to_owned(),
        setting: "any segments".to_owned(),
        cost: cost(name, all),
        loss: "half a last digit".to_owned(),
    }));
    rows.extend(rest.iter().map(|name| Choice {
        need: "speed, ends near the window".to_owned(),
        method: (*name).to_owned(),
        setting: "ends few window sizes away".to_owned(),
        cost: cost(name, all),
        loss: loss(far, name),
    }));
    Advice { baseline, rows }
}

/// What a technique that rounds at every step errs by near and far, in window sizes.
fn loss(far: &Measured, name: &str) -> String {
    let rows: Vec<_> = far.rows_of(name).collect();
    let (Some(near), Some(last)) = (rows.first(), rows.last()) else {
        return String::new();
    };
    let away = power_of_ten(last.setting);
    let at_last = match last.deviation.missing {
        0 => format!("{} at {away}", digits(last.error)),
        _ => format!(
            "{} decided wrongly at {away}",
            percent(last.deviation.missing_share())
        ),
    };
    format!(
        "off by {} of the window at {}, {at_last}",
        digits(near.error),
        power_of_ten(near.setting),
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::made_up::{self, lines, row};

    /// Two questions; of each technique its ratio and error in both.
    fn sweep(
        name: &'static str,
        settings: [f64; 2],
        techniques: &[(&'static str, [f64; 2], [f64; 2])],
    ) -> Measured {
        let question = |i: usize| {
            let rows = techniques.iter();
            let row = |&(technique, ratios, errors): &(_, [f64; 2], [f64; 2])| {
                row(technique, settings[i], ratios[i], Some(errors[i]))
            };
            rows.map(row).collect()
        };
        made_up::sweep(name, vec![question(0), question(1)])
    }

    #[test]
    fn the_cheapest_exact_one_and_the_price() {
        let (good, bad) = ([1e-17; 2], [1e-15, 2e-9]);
        let far = [
            ("slow", [1.0, 1.5], good),
            ("quick", [0.5, 0.5], good),
            ("textbook", [0.2, 0.2], bad),
        ];
        let near = far.map(|(name, ratios, _)| (name, ratios, good));
        let sweeps = [
            sweep("outside", [0.0, 1.0], &near),
            sweep("far-ends", [1.0, 1e6], &far),
        ];
        let found = advice(&sweeps);
        assert_eq!(found.baseline, "quick");
        assert_eq!(
            lines(&found),
            [
                "ends rounded once | quick | any segments | 1.0 | half a last digit",
                "the same ends, another way | slow | any segments | 2.0 to 3.0 | half a last digit",
                "speed, ends near the window | textbook | ends few window sizes away | 0.4 | off by 10⁻¹⁵ of the window at 1, 2·10⁻⁹ at 10⁶",
            ]
        );
        assert_eq!(advice(&[]), Advice::default());
        let wrong = [
            sweep("outside", [0.0, 1.0], &far[2..]),
            sweep("far-ends", [1.0, 1e6], &far[2..]),
        ];
        let found = lines(&advice(&wrong));
        assert!(
            found.len() == 1 && found[0].starts_with("speed, "),
            "{found:?}"
        );
    }

    #[test]
    fn another_where_most_is_outside() {
        let good = [1e-17; 2];
        let techniques = [("a", [1.0, 1.0], good), ("b", [2.0, 0.5], good)];
        let three = |name| {
            let mut all = sweep(name, [0.0, 0.5], &techniques);
            all.questions
                .push(sweep(name, [0.5, 1.0], &techniques).questions.remove(1));
            all
        };
        assert_eq!(
            lines(&advice(&[three("outside"), three("far-ends")])),
            [
                "ends rounded once | a | 0 % outside | 1.0 | half a last digit",
                "ends rounded once | b | 50 % to 100 % outside | 0.5 | half a last digit",
            ]
        );
    }
}
