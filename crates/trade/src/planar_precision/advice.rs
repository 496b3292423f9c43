//! The study's sentence.

use crate::advice::{Stretch, listed, power_of_ten, stretches, times};
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

/// `cast (49 to 2200 times its time) for a light 10⁶ times as far as high or more`
fn exception(sweep: &Measured, stretch: &Stretch) -> String {
    let technique = match (stretch.technique, stretch.ratios) {
        (None, _) => "none that is measured here".to_owned(),
        (Some(name), (low, high)) if times(low) == times(high) => {
            format!("{name} ({} times its time)", times(low))
        }
        (Some(name), (low, high)) => {
            format!("{name} ({} to {} times its time)", times(low), times(high))
        }
    };
    let last = sweep
        .questions
        .iter()
        .flat_map(|q| &q.rows)
        .next_back()
        .map(|row| row.setting);
    let (from, to) = (power_of_ten(stretch.from), power_of_ten(stretch.to));
    let range = match last {
        Some(last) if last == stretch.to => format!("{from} or more"),
        _ if from == to => from,
        _ => format!("{from} to {to}"),
    };
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
    use crate::deviation::Deviation;
    use crate::report::{Answered, Row};
    use crate::statistics::Quartiles;
    use ombra_math::work::Work;

    /// A sweep over 1, 10, 100, … with the errors of a technique that takes 1 and one that takes 40.
    fn sweep(name: &'static str, errors: &[(f64, f64)]) -> Measured {
        let question = |(i, &(quick, slow)): (usize, &(f64, f64))| {
            let row = |technique, ratio, error| Row {
                technique,
                setting: 10f64.powi(i as i32),
                error,
                deviation: Deviation::of([Some(error)]),
                faults: vec![],
                work: Work::default(),
                nanoseconds: Quartiles::of(&[ratio]),
                ratio,
                on_front: false,
            };
            let rows = vec![row("quick", 1.0, quick), row("slow", 40.0 + i as f64, slow)];
            Answered {
                inputs: String::new(),
                units: 1,
                rows,
            }
        };
        let questions = errors.iter().enumerate().map(question).collect();
        Measured {
            name,
            knob: "",
            charted: 0,
            questions,
        }
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
             but slow (42 to 43 times its time) where the light's distance over its height is 10² or more, \
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
