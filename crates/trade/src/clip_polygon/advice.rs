//! The study's sentence.

use crate::advice::{Stretch, listed, percent, power_of_ten, stretches, times};
use crate::report::Measured;

/// The error that the advice keeps to.
const TOLERANCE: f64 = 1e-12;

/// The cheapest technique, where another is to be taken, what lies outside, and what pieces cost.
pub fn advice(sweeps: &[Measured]) -> String {
    let found: Vec<_> = sweeps
        .iter()
        .flat_map(|sweep| {
            let stretches = stretches(sweep, TOLERANCE);
            stretches.into_iter().map(move |stretch| (sweep, stretch))
        })
        .collect();
    let keep = power_of_ten(TOLERANCE);
    let Some(usual) = found.iter().find_map(|(_, stretch)| stretch.technique) else {
        return format!("No technique keeps areas within {keep}.");
    };
    let mut said = format!("To keep areas within {keep} use {usual}");
    let exceptions: Vec<String> = found
        .iter()
        .filter(|(_, stretch)| stretch.technique != Some(usual))
        .map(|(sweep, stretch)| exception(sweep, stretch))
        .collect();
    if !exceptions.is_empty() {
        said = format!("{said}, but {}", listed(&exceptions));
    }
    let more: Vec<String> = pieces(sweeps).into_iter().chain(outside(sweeps)).collect();
    if !more.is_empty() {
        said = format!("{said}; {}", listed(&more));
    }
    said + "."
}

/// `pieces where vertices are 10³ window sizes away or more`
fn exception(sweep: &Measured, stretch: &Stretch) -> String {
    let name = stretch.technique.unwrap_or("none that is measured here");
    let settings = sweep.questions.iter().flat_map(|q| &q.rows);
    let last = settings.map(|row| row.setting).fold(0.0, f64::max);
    let (from, to) = (power_of_ten(stretch.from), power_of_ten(stretch.to));
    let range = |unit: &str| {
        if last == stretch.to {
            format!("{from} {unit} or more")
        } else if from == to {
            format!("{from} {unit}")
        } else {
            format!("{from} to {to} {unit}")
        }
    };
    if sweep.name == "far-star" {
        format!("{name} where vertices are {}", range("window sizes away"))
    } else {
        format!("{name} for a {} of {}", sweep.name, range("vertices"))
    }
}

/// What separate pieces cost against one outline.
fn pieces(sweeps: &[Measured]) -> Option<String> {
    let ratios = || sweeps.iter().map(|sweep| sweep.typical_ratio("pieces"));
    let (low, high) = (
        ratios().fold(f64::INFINITY, f64::min),
        ratios().fold(0.0, f64::max),
    );
    let baseline = sweeps.first()?.techniques().first().copied()?;
    let range = if times(low) == times(high) {
        times(low)
    } else {
        format!("{} to {}", times(low), times(high))
    };
    Some(format!(
        "separate pieces take {range} times the time of {baseline}"
    ))
}

/// Who leaves vertices outside, and how many of all that come in at most.
fn outside(sweeps: &[Measured]) -> Vec<String> {
    let techniques = sweeps.first().map(Measured::techniques).unwrap_or_default();
    let share = |technique: &str| {
        let questions = sweeps.iter().flat_map(|sweep| &sweep.questions);
        let shares = questions.flat_map(|question| {
            let rows = question.rows.iter();
            let mine = rows.filter(|row| row.technique == technique);
            let vertices = mine.flat_map(|row| &row.faults).map(|fault| fault.1);
            vertices.map(|number| number as f64 / question.units.max(1) as f64)
        });
        shares.fold(0.0, f64::max)
    };
    let leaving = techniques.into_iter().map(|name| (name, share(name)));
    leaving
        .filter(|&(_, share)| share > 0.0)
        .map(|(name, share)| {
            format!(
                "{name} leaves up to {} vertices outside the window for 100 that it gets",
                percent(share).trim_end_matches(" %")
            )
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::deviation::Deviation;
    use crate::report::{Answered, Row};
    use crate::statistics::Quartiles;
    use ombra_math::work::Work;

    fn sweep(name: &'static str, techniques: &[(&'static str, f64, [f64; 2], u64)]) -> Measured {
        let question = |i: usize| Answered {
            inputs: String::new(),
            units: 50,
            rows: techniques
                .iter()
                .map(|&(technique, ratio, errors, outside)| Row {
                    technique,
                    setting: [10.0, 1000.0][i],
                    error: errors[i],
                    deviation: Deviation::of([Some(errors[i])]),
                    faults: vec![("vertices outside", outside)],
                    work: Work::default(),
                    nanoseconds: Quartiles::of(&[ratio]),
                    ratio,
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
    fn the_cheapest_its_exceptions_and_the_price_of_pieces() {
        let (good, late) = ([1e-16; 2], [1e-13, 1e-9]);
        let sweeps = [
            sweep(
                "star",
                &[
                    ("outline", 1.0, good, 0),
                    ("pieces", 1.5, good, 0),
                    ("rough", 0.5, good, 6),
                ],
            ),
            sweep(
                "far-star",
                &[
                    ("outline", 1.0, good, 0),
                    ("pieces", 0.8, good, 0),
                    ("rough", 0.5, late, 2),
                ],
            ),
        ];
        assert_eq!(
            advice(&sweeps),
            "To keep areas within 10⁻¹² use rough, but pieces where vertices are 10³ window sizes away or more; \
             separate pieces take 0.8 to 1.5 times the time of outline \
             and rough leaves up to 12 vertices outside the window for 100 that it gets."
        );
        assert_eq!(advice(&[]), "No technique keeps areas within 10⁻¹².");
    }
}
