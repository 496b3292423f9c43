//! The study's sentence.

use crate::advice::{Stretch, listed, percent, power_of_ten, stretches, times};
use crate::report::Measured;

/// A rounding of coordinates of the window's own size.
const TOLERANCE: f64 = f64::EPSILON;

/// The cheapest exact technique, by the share outside, and what the textbook forms gain and lose.
pub fn advice(sweeps: &[Measured]) -> String {
    let find = |name: &str| sweeps.iter().find(|sweep| sweep.name == name);
    let (Some(outside), Some(far)) = (find("outside"), find("far-ends")) else {
        return String::new();
    };
    // A textbook form may stay within a rounding while ends are near, but not by itself.
    let is_exact = |technique: &&str| far.rows_of(technique).all(|row| row.error <= TOLERANCE);
    let (exact, rest): (Vec<&str>, Vec<&str>) = far.techniques().into_iter().partition(is_exact);
    let mut choice = outside.clone();
    for question in &mut choice.questions {
        question.rows.retain(|row| exact.contains(&row.technique));
    }
    let found = stretches(&choice, TOLERANCE);
    let Some(best) = found.first().and_then(|stretch| stretch.technique) else {
        return "No technique rounds every end only once.".to_owned();
    };
    let choice = |stretch: &Stretch| match found.len() {
        1 => stretch.name().to_owned(),
        _ => format!("{} for {} outside", stretch.name(), stretch.range(percent)),
    };
    let choices: Vec<String> = found.iter().map(choice).collect();
    let cost = |name: &str| times(outside.typical_ratio(name) / outside.typical_ratio(best));
    let slower = exact.iter().filter(|name| **name != best);
    let slower = slower.map(|name| format!("{name} takes {}", cost(name)));
    let rest = rest.iter().map(|name| loss(far, name, &cost(name)));
    let times: Vec<String> = slower.chain(rest).collect();
    let mut said = format!("For ends rounded once use {}", listed(&choices));
    if !times.is_empty() {
        said = format!("{said}; with the time of {best} as 1, {}", times.join(", "));
    }
    said + "."
}

/// What a technique that rounds at every step gains, and what it errs by near and far.
fn loss(far: &Measured, name: &str, cost: &str) -> String {
    let rows: Vec<_> = far.rows_of(name).collect();
    let (Some(near), Some(last)) = (rows.first(), rows.last()) else {
        return String::new();
    };
    let away = power_of_ten(last.setting);
    let but = match last.deviation.missing {
        0 => format!(
            "misses the exact ends by {} of the window's size where segments end {away} window sizes away ({} at {})",
            power_of_ten(last.error),
            power_of_ten(near.error),
            power_of_ten(near.setting),
        ),
        _ => format!(
            "decides wrongly about {} of the segments that end {away} window sizes away",
            percent(last.deviation.missing_share()),
        ),
    };
    format!("{name} takes {cost}, but {but}")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::made_up::{self, row};

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
            ("slow", [1.0, 1.0], good),
            ("quick", [0.5, 0.5], good),
            ("textbook", [0.2, 0.2], bad),
        ];
        let near = far.map(|(name, ratios, _)| (name, ratios, good));
        let sweeps = [
            sweep("outside", [0.0, 1.0], &near),
            sweep("far-ends", [1.0, 1e6], &far),
        ];
        assert_eq!(
            advice(&sweeps),
            "For ends rounded once use quick; with the time of quick as 1, slow takes 2.0, textbook takes 0.4, but misses the \
             exact ends by 2·10⁻⁹ of the window's size where segments end 10⁶ window sizes away (10⁻¹⁵ at 1)."
        );
        assert_eq!(advice(&[]), "");
        let wrong = [
            sweep("outside", [0.0, 1.0], &far),
            sweep("far-ends", [1.0, 1e6], &far[2..]),
        ];
        assert_eq!(advice(&wrong), "No technique rounds every end only once.");
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
            advice(&[three("outside"), three("far-ends")]),
            "For ends rounded once use a for 0 % outside and b for 50 % to 100 % outside; \
             with the time of a as 1, b takes 0.5."
        );
    }
}
