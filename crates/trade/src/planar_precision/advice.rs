//! The study's advice.

use crate::advice::{
    Advice, Choice, Stretch, between, digits, extent, power_of_ten, stretches, times,
};
use crate::report::{Measured, Row};

/// The error that the advice keeps to.
const TOLERANCE: f64 = 1e-9;

/// One technique to take, and where to take another.
pub fn advice(sweeps: &[Measured]) -> Advice {
    let rows = sweeps.iter().flat_map(|sweep| {
        let stretches = stretches(sweep, TOLERANCE);
        stretches
            .iter()
            .map(|stretch| choice(sweep, stretch))
            .collect::<Vec<_>>()
    });
    let first = sweeps.iter().flat_map(Measured::rows).next();
    Advice {
        baseline: first.map_or("", |row| row.technique),
        rows: rows.collect(),
    }
}

/// `light low over the plane | cast | 10⁶ to 10¹⁵ | 49 to 2200 | …`
fn choice(sweep: &Measured, stretch: &Stretch) -> Choice {
    let keep = power_of_ten(TOLERANCE);
    let (need, knob) = match sweep.name {
        "towards-plane" => ("low light", "distance / height of the light"),
        "to-infinity" => ("far light", "1/w of the light"),
        _ => ("far scene", "distance / size of the scene"),
    };
    let within = |row: &&Row| stretch.from <= row.setting && row.setting <= stretch.to;
    let technique = stretch.technique.unwrap_or("");
    let most = extent(sweep.rows_of(technique).filter(within).map(|row| row.error)).1;
    Choice {
        need: format!("{need}, shadow to {keep}"),
        method: stretch.name().to_owned(),
        setting: format!("{knob} {}", stretch.range(power_of_ten)),
        cost: stretch
            .technique
            .map_or_else(String::new, |_| between(stretch.ratios, times)),
        loss: stretch
            .technique
            .map_or_else(String::new, |_| format!("off by up to {}", digits(most))),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::made_up::{self, lines, row};

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
                &[(good, 1e-12), (1e-10, 1e-12), (bad, 1e-12), (bad, 1e-12)],
            ),
            sweep("to-infinity", &[(good, bad), (bad, bad), (good, bad)]),
            sweep("far-from-origin", &[(bad, good), (bad, good), (good, good)]),
        ];
        let found = advice(&sweeps);
        assert_eq!(found.baseline, "quick");
        assert_eq!(
            lines(&found),
            [
                "low light, shadow to 10⁻⁹ | quick | distance / height of the light 1 to 10 | 1.0 | off by up to 10⁻⁹",
                "low light, shadow to 10⁻⁹ | slow | distance / height of the light 10² to 10³ | 42 to 43 | off by up to 10⁻¹²",
                "far light, shadow to 10⁻⁹ | quick | 1/w of the light 1 | 1.0 | off by up to 10⁻⁹",
                "far light, shadow to 10⁻⁹ | none that is measured here | 1/w of the light 10 |  | ",
                "far light, shadow to 10⁻⁹ | quick | 1/w of the light 10² | 1.0 | off by up to 10⁻⁹",
                "far scene, shadow to 10⁻⁹ | slow | distance / size of the scene 1 to 10 | 40 to 41 | off by up to 10⁻⁹",
                "far scene, shadow to 10⁻⁹ | quick | distance / size of the scene 10² | 1.0 | off by up to 10⁻⁹",
            ]
        );
        assert_eq!(advice(&[]), Advice::default());
    }
}
