//! The study's sentence.

use crate::advice::{Stretch, between, listed, power_of_ten, stretches, times};
use crate::report::Measured;

/// The error that the advice keeps to.
const TOLERANCE: f64 = 1e-9;

/// One technique to take, and where to take another.
pub fn advice(sweeps: &[Measured]) -> String {
    let found: Vec<_> = sweeps
        .iter()
        .map(|sweep| (sweep, stretches(sweep, TOLERANCE)))
        .collect();
    let usual = found
        .iter()
        .flat_map(|(_, stretches)| stretches)
        .find_map(|stretch| stretch.technique);
    let keep = power_of_ten(TOLERANCE);
    let Some(usual) = usual else {
        return format!("No technique keeps every shadow within {keep} of the exact one.");
    };
    let exceptions: Vec<String> = found
        .iter()
        .flat_map(|(sweep, stretches)| stretches.iter().map(move |stretch| (sweep, stretch)))
        .filter(|(_, stretch)| stretch.technique != Some(usual))
        .map(|(sweep, stretch)| exception(sweep, stretch))
        .collect();
    match exceptions.as_slice() {
        [] => format!("Use {usual}: it keeps every shadow within {keep} of the exact one."),
        some => {
            format!(
                "To keep every shadow within {keep} of the exact one, use {usual}, but {}.",
                listed(some)
            )
        }
    }
}

/// `cast (49 to 2200 times its time) where the light's distance over its height is 10⁶ to 10¹⁵`
fn exception(sweep: &Measured, stretch: &Stretch) -> String {
    let mut technique = stretch.name().to_owned();
    if stretch.technique.is_some() {
        technique = format!(
            "{technique} ({} times its time)",
            between(stretch.ratios, times)
        );
    }
    let range = stretch.range(power_of_ten);
    let place = match sweep.name {
        "towards-plane" => format!("where the light's distance over its height is {range}"),
        "to-infinity" => format!("where the light's 1/w is {range}"),
        _ => format!("where the scene's distance from the origin over its size is {range}"),
    };
    format!("{technique} {place}")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::made_up::{self, row};

    /// A sweep over 1, 10, 100, … with the errors of a technique that takes 1 and one that takes 40.
    fn sweep(name: &'static str, errors: &[(f64, f64)]) -> Measured {
        let question = |(i, &(quick, slow)): (usize, &(f64, f64))| {
            let k = 10f64.powi(i as i32);
            vec![
                row("quick", k, 1.0, Some(quick)),
                row("slow", k, 40.0 + i as f64, Some(slow)),
            ]
        };
        made_up::sweep(name, errors.iter().enumerate().map(question).collect())
    }

    #[test]
    fn the_usual_technique_and_its_exceptions() {
        let (good, bad) = (1e-9, 2e-9);
        let sweeps = [
            sweep(
                "towards-plane",
                &[(good, good), (good, good), (bad, good), (bad, good)],
            ),
            sweep("to-infinity", &[(good, bad), (bad, bad), (good, bad)]),
            sweep("far-from-origin", &[(bad, good), (bad, good), (good, good)]),
        ];
        assert_eq!(
            advice(&sweeps),
            "To keep every shadow within 10⁻⁹ of the exact one, use quick, \
             but slow (42 to 43 times its time) where the light's distance over its height is 10² to 10³, \
             none that is measured here where the light's 1/w is 10 \
             and slow (40 to 41 times its time) where the scene's distance from the origin over its size is 1 to 10."
        );
        assert_eq!(
            advice(&[sweep("to-infinity", &[(good, good)])]),
            "Use quick: it keeps every shadow within 10⁻⁹ of the exact one."
        );
        let none = "No technique keeps every shadow within 10⁻⁹ of the exact one.";
        assert_eq!(advice(&[sweep("to-infinity", &[(bad, bad)])]), none);
        assert_eq!(advice(&[]), none);
    }
}
