//! The study's sentence.

use crate::advice::{listed, percent, power_of_ten, stretches, times};
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
    let ranges: Vec<String> = found
        .iter()
        .map(|stretch| {
            let name = stretch.technique.unwrap_or("none that is measured here");
            if found.len() == 1 {
                return name.to_owned();
            }
            let (from, to) = (percent(stretch.from), percent(stretch.to));
            format!("{name} from {from} to {to} outside")
        })
        .collect();
    let best = found.first().and_then(|stretch| stretch.technique);
    let times_best = |name: &str| {
        let best = best.map_or(f64::NAN, |best| outside.typical_ratio(best));
        times(outside.typical_ratio(name) / best)
    };
    let slower = exact.iter().filter(|name| Some(**name) != best);
    let slower = slower.map(|name| format!("{name} takes {} times its time", times_best(name)));
    let losses = rest.iter().map(|name| {
        let rows: Vec<_> = far.rows_of(name).collect();
        let (Some(near), Some(last)) = (rows.first(), rows.last()) else {
            return String::new();
        };
        let error = if last.deviation.missing > 0 {
            let share = percent(last.deviation.missing_share());
            format!("decides wrongly about {share} of the segments")
        } else {
            format!("by {}", power_of_ten(last.error))
        };
        format!(
            "{name} takes {} times its time and errs by {} of the window for ends at {} of its sizes, {error} at {}",
            times_best(name),
            power_of_ten(near.error),
            power_of_ten(near.setting),
            power_of_ten(last.setting),
        )
    });
    let more: Vec<String> = slower.chain(losses).collect();
    let mut said = format!("For ends rounded once use {}", listed(&ranges));
    if !more.is_empty() {
        said = format!("{said}; {}", listed(&more));
    }
    said + "."
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::deviation::Deviation;
    use crate::report::{Answered, Row};
    use crate::statistics::Quartiles;
    use ombra_math::work::Work;

    /// Two questions; of each technique its ratio and error in both.
    fn sweep(
        name: &'static str,
        settings: [f64; 2],
        techniques: &[(&'static str, [f64; 2], [f64; 2])],
    ) -> Measured {
        let question = |i: usize| Answered {
            inputs: String::new(),
            units: 1,
            rows: techniques
                .iter()
                .map(|&(technique, ratios, errors)| Row {
                    technique,
                    setting: settings[i],
                    error: errors[i],
                    deviation: Deviation::of([Some(errors[i])]),
                    faults: vec![],
                    work: Work::default(),
                    nanoseconds: Quartiles::of(&[ratios[i]]),
                    ratio: ratios[i],
                    on_front: false,
                })
                .collect(),
        };
        Measured {
            name,
            knob: "",
            charted: 0,
            questions: vec![question(0), question(1)],
        }
    }

    #[test]
    fn the_cheapest_exact_one_and_the_price() {
        let (good, bad) = ([1e-17; 2], [1e-15, 2e-9]);
        let techniques = [
            ("slow", [1.0, 1.0], good),
            ("quick", [0.5, 0.5], good),
            ("textbook", [0.2, 0.2], bad),
        ];
        let near = [
            ("slow", [1.0; 2], good),
            ("quick", [0.5; 2], good),
            ("textbook", [0.2; 2], good),
        ];
        let sweeps = [
            sweep("outside", [0.0, 1.0], &near),
            sweep("far-ends", [1.0, 1e6], &techniques),
        ];
        assert_eq!(
            advice(&sweeps),
            "For ends rounded once use quick; slow takes 2.0 times its time and textbook takes 0.4 times its time \
             and errs by 10⁻¹⁵ of the window for ends at 1 of its sizes, by 2·10⁻⁹ at 10⁶."
        );
        assert_eq!(advice(&[]), "");
    }
}
