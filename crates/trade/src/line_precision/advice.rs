//! The study's sentence.

use crate::advice::{extent, listed, percent, power_of_ten, times};
use crate::report::{Measured, Row};

/// The cheapest technique that is right everywhere, what the others that are cost, and where the rest goes wrong.
pub fn advice(sweeps: &[Measured]) -> String {
    let Some(sweep) = sweeps.first() else {
        return String::new();
    };
    let (mut right, wrong): (Vec<_>, Vec<_>) = sweep
        .techniques()
        .into_iter()
        .partition(|technique| sweep.rows_of(technique).all(|row| row.error == 0.0));
    right.sort_by(|a, b| sweep.typical_ratio(a).total_cmp(&sweep.typical_ratio(b)));
    let longest = power_of_ten(extent(sweep.rows().map(|row| row.setting)).1);
    let faults: Vec<String> = wrong.iter().map(|name| fault(sweep, name)).collect();
    let Some((best, others)) = right.split_first() else {
        return format!(
            "No technique has every pixel of segments of up to {longest} moves right: {}.",
            listed(&faults)
        );
    };
    let cost = |name: &&str| {
        let ratio = sweep.typical_ratio(name) / sweep.typical_ratio(best);
        format!("{name} is right too, in {} times its time", times(ratio))
    };
    let also: Vec<String> = others.iter().map(cost).chain(faults).collect();
    let mut said = format!(
        "For segments of up to {longest} moves use {best}, the cheapest that is right in every pixel"
    );
    if !also.is_empty() {
        said = format!("{said}; {}", listed(&also));
    }
    said + "."
}

/// `DDA f32 has wrong pixels from 10³ on (99 % of them at 10⁷, up to 10⁴ beside the right one)`
fn fault(sweep: &Measured, technique: &str) -> String {
    let is_wrong = |row: &&Row| row.error != 0.0;
    let first = sweep.rows_of(technique).find(is_wrong);
    let (Some(first), Some(last)) = (first, sweep.rows_of(technique).last()) else {
        return String::new();
    };
    format!(
        "{technique} has wrong pixels from {} on ({} of them at {}, up to {} beside the right one)",
        power_of_ten(first.setting),
        percent(last.deviation.wrong_share()),
        power_of_ten(last.setting),
        last.deviation.max,
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::deviation::Deviation;
    use crate::report::made_up;

    /// Two pixels of segments of 10 and of 1000 moves.
    fn sweep(techniques: &[(&'static str, f64, [[f64; 2]; 2])]) -> Measured {
        let question = |i: usize| {
            let rows = techniques.iter().map(|&(technique, ratio, errors)| {
                let deviation = Deviation::of(errors[i].map(Some));
                Row {
                    deviation,
                    ..made_up::row(technique, [10.0, 1000.0][i], ratio, Some(deviation.max))
                }
            });
            rows.collect()
        };
        made_up::sweep("length", vec![question(0), question(1)])
    }

    #[test]
    fn the_cheapest_right_one_the_others_and_the_wrong_ones() {
        let zero = [[0.0; 2]; 2];
        let late = [[0.0; 2], [0.0, 7.0]];
        assert_eq!(
            advice(&[sweep(&[
                ("slow", 2.0, zero),
                ("sum", 0.1, late),
                ("quick", 0.5, zero)
            ])]),
            "For segments of up to 10³ moves use quick, the cheapest that is right in every pixel; \
             slow is right too, in 4.0 times its time and sum has wrong pixels from 10³ on (50 % of them at 10³, up to 7 beside the right one)."
        );
        assert_eq!(
            advice(&[sweep(&[("only", 1.0, zero)])]),
            "For segments of up to 10³ moves use only, the cheapest that is right in every pixel."
        );
        assert_eq!(
            advice(&[sweep(&[("sum", 1.0, late)])]),
            "No technique has every pixel of segments of up to 10³ moves right: \
             sum has wrong pixels from 10³ on (50 % of them at 10³, up to 7 beside the right one)."
        );
        assert_eq!(advice(&[]), "");
    }
}
