//! The two charts of a sweep: error over the knob, and cost against error.

use ombra_figures::chart::{Axis, Chart, Scale, Series};
use ombra_figures::drawing::Drawing;
use ombra_figures::style::Style;

use crate::error::TradeError;
use crate::report::{Measured, Report, Row};

/// Both charts of every sweep that has anything to show in them.
pub fn draw(report: &Report, style: &Style) -> Result<Vec<Drawing>, TradeError> {
    let charts = report
        .sweeps
        .iter()
        .flat_map(|sweep| [over_knob(report, sweep), against_cost(report, sweep)]);
    let shown = charts.filter(|chart| chart.series.iter().any(|series| !series.points.is_empty()));
    shown.map(|chart| Ok(chart.draw(style)?)).collect()
}

/// A curve a technique: its largest error over the knob. It ends where answers go missing; one that never begins
/// stays in the list, so that a technique has the same colour in all charts of its study.
fn over_knob(report: &Report, sweep: &Measured) -> Chart {
    let rows = || sweep.questions.iter().flat_map(|q| &q.rows);
    let (y, floor) = error_axis(report, rows());
    let series = sweep.techniques().into_iter().map(|technique| {
        let points =
            shown(sweep.rows_of(technique), floor).map(|(row, error)| (row.setting, error));
        Series::new(technique, points.collect())
    });
    Chart {
        id: format!("trade/{}/{}-error", report.study, sweep.name),
        title: format!(
            "{}: largest {} over {}",
            report.summary, report.error, sweep.knob
        ),
        x: Axis::new(sweep.knob, "", scale(rows().map(|row| row.setting))),
        y,
        series: series.collect(),
        pareto: None,
    }
}

/// Every case of the charted question, and the front.
fn against_cost(report: &Report, sweep: &Measured) -> Chart {
    let rows = || {
        sweep
            .questions
            .get(sweep.charted)
            .into_iter()
            .flat_map(|q| &q.rows)
    };
    let (y, floor) = error_axis(report, rows());
    let series = sweep.techniques().into_iter().map(|technique| {
        let mine = rows().filter(|row| row.technique == technique);
        let points: Vec<_> = shown(mine, floor)
            .map(|(row, error)| (row.ratio, error))
            .collect();
        Series {
            name: technique.to_owned(),
            joined: points.len() > 1,
            points,
        }
    });
    let alone = |row: &Row| {
        rows()
            .filter(|other| other.technique == row.technique)
            .count()
            == 1
    };
    // A technique's only point has its name already; several are told apart by their setting.
    let name = |row: &Row| {
        if alone(row) {
            format!("× {:.2}", row.ratio)
        } else {
            row.setting.to_string()
        }
    };
    let front = shown(rows().filter(|row| row.on_front), floor)
        .map(|(row, error)| (name(row), (row.ratio, error)));
    let inputs = sweep.questions.get(sweep.charted).map_or("", |q| &q.inputs);
    let baseline = rows().next().map_or("", |row| row.technique);
    Chart {
        id: format!("trade/{}/{}-cost", report.study, sweep.name),
        title: format!(
            "{}: {} against time, {inputs}",
            report.summary, report.error
        ),
        x: Axis::new(
            format!("time a {} / {baseline}'s", report.unit),
            "",
            Scale::Log,
        ),
        y,
        series: series.collect(),
        pareto: Some(front.collect()),
    }
}

/// Rows with all answers, and where their error is drawn.
fn shown<'a>(
    rows: impl Iterator<Item = &'a Row>,
    floor: f64,
) -> impl Iterator<Item = (&'a Row, f64)> {
    rows.filter(|row| row.deviation.worst().is_finite())
        .map(move |row| (row, row.deviation.worst().max(floor)))
}

/// The axis of errors, and the place of an error of 0, which a logarithm does not have: a decade below all others.
fn error_axis<'a>(report: &Report, rows: impl Iterator<Item = &'a Row>) -> (Axis, f64) {
    let worst: Vec<f64> = rows
        .map(|row| row.deviation.worst())
        .filter(|e| e.is_finite())
        .collect();
    let least = worst
        .iter()
        .copied()
        .filter(|&e| e > 0.0)
        .fold(f64::INFINITY, f64::min);
    let (title, floor) = if !worst.contains(&0.0) {
        (format!("largest {}", report.error), 0.0)
    } else if least.is_finite() {
        (
            format!("largest {} (0: lowest line)", report.error),
            (least / 10.0).max(f64::MIN_POSITIVE),
        )
    } else {
        (format!("largest {} (all 0)", report.error), 1.0)
    };
    (Axis::new(title, "", Scale::Log), floor)
}

/// Logarithmic where the knob spans more than two decades.
fn scale(settings: impl Iterator<Item = f64>) -> Scale {
    let (low, high) = settings.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| {
        (low.min(x), high.max(x))
    });
    if low > 0.0 && high / low > 100.0 {
        Scale::Log
    } else {
        Scale::Linear
    }
}
