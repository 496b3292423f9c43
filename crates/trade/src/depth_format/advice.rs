//! The study's sentence.

use crate::advice::{listed, power_of_ten, times};
use crate::report::{Measured, Row};

/// The gap, over the distance, that the advice wants told apart: two millimetres a metre away.
const GAP: f64 = 2e-3;

/// How far each format goes, and what the best one costs.
pub fn advice(sweeps: &[Measured]) -> String {
    let Some(sweep) = sweeps.first() else {
        return String::new();
    };
    let reaches: Vec<(&'static str, usize)> = sweep
        .techniques()
        .into_iter()
        .map(|format| (format, reach(sweep, format)))
        .collect();
    // Of those that go as far, the one named last is not the usual one.
    let Some(&(best, most)) = reaches.iter().max_by_key(|(_, reach)| *reach) else {
        return String::new();
    };
    let gap = power_of_ten(GAP);
    let aim = format!("To tell surfaces apart that are {gap} of their distance apart");
    if most == 0 {
        return format!("{aim}, no format is enough.");
    }
    let others: Vec<String> = reaches
        .iter()
        .filter(|(format, _)| *format != best)
        .map(|&(format, reach)| match last(sweep, format, reach) {
            Some(row) if reach == most => {
                format!("{format} does too, to {}", power_of_ten(row.setting))
            }
            Some(row) => format!(
                "{format} goes no farther than {}",
                power_of_ten(row.setting)
            ),
            None => format!("{format} is never enough"),
        })
        .collect();
    let (Some(end), Some(hardest)) = (
        last(sweep, best, most),
        sweep.questions.len().checked_sub(1),
    ) else {
        return String::new();
    };
    let mut said = format!(
        "{aim}, {best} is enough for near / far down to {}, at {} times the time of {}",
        power_of_ten(end.setting),
        times(sweep.typical_ratio(best)),
        sweep.techniques().first().copied().unwrap_or("")
    );
    if !others.is_empty() {
        said = format!("{said}; {}", listed(&others));
    }
    let gaps: Vec<String> = reaches
        .iter()
        .filter_map(|&(format, _)| {
            let rows = &sweep.questions.get(hardest)?.rows;
            let row = rows.iter().find(|row| row.technique == format)?;
            Some(format!("{} by {format}", power_of_ten(row.error)))
        })
        .collect();
    let setting = sweep.questions.get(hardest).and_then(|q| q.rows.first());
    match setting {
        Some(row) => format!(
            "{said}; at {} what may not be told apart is up to {} of the distance.",
            power_of_ten(row.setting),
            listed(&gaps)
        ),
        None => said + ".",
    }
}

/// How many settings, from the easiest on, a format tells the gap apart at.
fn reach(sweep: &Measured, format: &str) -> usize {
    sweep
        .rows_of(format)
        .take_while(|row| row.error < GAP)
        .count()
}

fn last<'a>(sweep: &'a Measured, format: &str, reach: usize) -> Option<&'a Row> {
    sweep.rows_of(format).take(reach).last()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::made_up::{self, row};

    fn sweep(formats: &[(&'static str, f64, [f64; 3])]) -> Measured {
        let question = |i: usize| {
            let setting = [0.1, 0.01, 0.001][i];
            let rows = formats.iter();
            rows.map(|&(format, ratio, errors)| row(format, setting, ratio, Some(errors[i])))
                .collect()
        };
        made_up::sweep("behind", (0..3).map(question).collect())
    }

    #[test]
    fn how_far_each_goes() {
        let sweep = sweep(&[
            ("24 bits", 1.0, [1e-6, 1e-4, 3e-3]),
            ("16 bits", 1.1, [3e-3, 1e-4, 0.25]),
            ("reversed", 0.9, [1e-7; 3]),
        ]);
        assert_eq!(
            advice(&[sweep]),
            "To tell surfaces apart that are 2·10⁻³ of their distance apart, reversed is enough for near / far down to \
             10⁻³, at 0.9 times the time of 24 bits; 24 bits goes no farther than 10⁻² and 16 bits is never enough; \
             at 10⁻³ what may not be told apart is up to 3·10⁻³ by 24 bits, 2.5·10⁻¹ by 16 bits and 10⁻⁷ by reversed \
             of the distance."
        );
    }

    #[test]
    fn none_and_nothing() {
        let bad = sweep(&[("16 bits", 1.0, [2e-3; 3])]);
        assert_eq!(
            advice(&[bad]),
            "To tell surfaces apart that are 2·10⁻³ of their distance apart, no format is enough."
        );
        assert_eq!(advice(&[]), "");
    }
}
