//! The charts of a sweep: error, time and counted work over the knob, and cost against error.

use ombra_figures::chart::{Axis, Chart, Scale, Series};
use ombra_figures::drawing::Drawing;
use ombra_figures::style::Style;

use crate::deviation::Measure;
use crate::error::TradeError;
use crate::report::{Measured, Report, Row};

impl Report {
    /// The charts: for each sweep the errors, the time and perhaps the counted work over the knob, and cost against
    /// error with the Pareto front.
    ///
    /// # Errors
    ///
    /// [`TradeError::Figure`] when a chart cannot be drawn.
    pub fn charts(&self, style: &Style) -> Result<Vec<Drawing>, TradeError> {
        let charts = self.sweeps.iter().flat_map(|sweep| {
            let errors = self.errors.iter().enumerate();
            let mut charts: Vec<_> = errors
                .map(|(i, &measure)| error_over_knob(self, sweep, measure, i == 0))
                .collect();
            charts.push(time_over_knob(self, sweep));
            charts.push(work_over_knob(self, sweep));
            charts.push(against_cost(self, sweep));
            charts
        });
        let shown =
            charts.filter(|chart| chart.series.iter().any(|series| !series.points.is_empty()));
        shown.map(|chart| Ok(chart.draw(style)?)).collect()
    }
}

/// A curve a technique: its error over the knob. It ends where answers go missing; one that never begins stays in the
/// list, so that a technique has the same colour in all charts of its study.
fn error_over_knob(report: &Report, sweep: &Measured, measure: Measure, is_first: bool) -> Chart {
    let (y, floor) = error_axis(measure, sweep.rows());
    let error = |row: &Row| measure.of(&row.deviation);
    let series = sweep.techniques().into_iter().map(|technique| {
        let points = shown(sweep.rows_of(technique), error, floor);
        let points = points.map(|(row, error)| (row.setting, error));
        Series::new(technique, from_left_to_right(points.collect()))
    });
    let kind = match measure {
        _ if is_first => "error",
        Measure::Largest(_) => "largest",
        Measure::Share(_) => "share",
    };
    Chart {
        id: format!("trade/{}/{}-{kind}", report.study, sweep.name),
        title: format!("{}: {measure} over {}", report.summary, sweep.knob),
        x: knob_axis(sweep),
        y,
        series: coinciding_as_one(series.collect()),
        pareto: None,
    }
}

/// A curve a technique: its time over the knob, right or wrong.
fn time_over_knob(report: &Report, sweep: &Measured) -> Chart {
    let series = sweep.techniques().into_iter().map(|technique| {
        let times = sweep
            .rows_of(technique)
            .map(|row| (row.setting, row.nanoseconds.median));
        let points = times.filter(|&(_, time)| time > 0.0 && time.is_finite());
        Series::new(technique, from_left_to_right(points.collect()))
    });
    Chart {
        id: format!("trade/{}/{}-time", report.study, sweep.name),
        title: format!(
            "{}: time a {} over {}",
            report.summary, report.unit, sweep.knob
        ),
        x: knob_axis(sweep),
        y: Axis::new(format!("time a {}", report.unit), "ns", Scale::Log),
        series: series.collect(),
        pareto: None,
    }
}

/// A curve a technique: over the knob, the first of the study's charted counters that it moves.
fn work_over_knob(report: &Report, sweep: &Measured) -> Chart {
    let series = sweep.techniques().into_iter().map(|technique| {
        let Some(what) = sweep.first_moved(technique, report.charted_work) else {
            return Series::new(technique, vec![]);
        };
        let counts = sweep
            .rows_of(technique)
            .map(|row| (row.setting, row.work.get(what) as f64));
        let points = counts.filter(|&(_, count)| count > 0.0);
        let name = format!("{technique}: {}", what.name());
        Series::new(name, from_left_to_right(points.collect()))
    });
    Chart {
        id: format!("trade/{}/{}-work", report.study, sweep.name),
        title: format!("{}: counted work over {}", report.summary, sweep.knob),
        x: knob_axis(sweep),
        y: Axis::new("counted", "", Scale::Log),
        series: coinciding_as_one(series.collect()),
        pareto: None,
    }
}

/// Every case of the charted question, and its front.
fn against_cost(report: &Report, sweep: &Measured) -> Chart {
    let question = sweep.questions.get(sweep.charted);
    let rows = || question.into_iter().flat_map(|q| &q.rows);
    let measure = report
        .errors
        .first()
        .copied()
        .unwrap_or(Measure::Largest("error"));
    let (y, floor) = error_axis(measure, rows());
    let error = |row: &Row| row.error;
    let series = sweep.techniques().into_iter().map(|technique| {
        let mine = rows().filter(|row| row.technique == technique);
        let points: Vec<_> = shown(mine, error, floor)
            .map(|(row, error)| (row.ratio, error))
            .collect();
        Series {
            joined: points.len() > 1,
            ..Series::new(technique, points)
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
    let front = shown(rows().filter(|row| row.on_front), error, floor)
        .map(|(row, error)| (name(row), (row.ratio, error)));
    let inputs = question.map_or("", |q| &q.inputs);
    let baseline = rows().next().map_or("", |row| row.technique);
    Chart {
        id: format!("trade/{}/{}-cost", report.study, sweep.name),
        title: format!("{}: {measure} against time, {inputs}", report.summary),
        x: Axis::new(
            format!("time a {} / that of {baseline}", report.unit),
            "",
            Scale::Log,
        ),
        y,
        series: series.collect(),
        pareto: Some(front.collect()),
    }
}

fn knob_axis(sweep: &Measured) -> Axis {
    Axis::new(sweep.knob, "", scale(sweep.rows().map(|row| row.setting)))
}

/// By the knob, whatever is easy or hard: a curve's name stands at its right end, where there is room for it.
fn from_left_to_right(mut points: Vec<(f64, f64)>) -> Vec<(f64, f64)> {
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    points
}

/// Curves that lie on one another all along become one with all names, one below the other; it keeps its place, and with
/// it its colour.
fn coinciding_as_one(mut series: Vec<Series>) -> Vec<Series> {
    for i in 0..series.len() {
        let (before, rest) = series.split_at_mut(i + 1);
        let Some(this) = before.last_mut().filter(|this| !this.points.is_empty()) else {
            continue;
        };
        let same = rest.iter_mut().filter(|other| other.points == this.points);
        for other in same {
            other.points.clear();
            this.name.push('\n');
            this.name.push_str(&core::mem::take(&mut other.name));
        }
    }
    series
}

/// Rows that have an error, and where it is drawn.
fn shown<'a>(
    rows: impl Iterator<Item = &'a Row>,
    error: impl Fn(&Row) -> f64,
    floor: f64,
) -> impl Iterator<Item = (&'a Row, f64)> {
    rows.map(move |row| (row, error(row)))
        .filter(|(_, error)| error.is_finite())
        .map(move |(row, error)| (row, error.max(floor)))
}

/// The axis of errors, and the place of an error of 0, which a logarithm does not have: below all others, and above the
/// axis, where its name would stand among the ticks.
fn error_axis<'a>(measure: Measure, rows: impl Iterator<Item = &'a Row>) -> (Axis, f64) {
    let errors: Vec<f64> = rows
        .map(|row| measure.of(&row.deviation))
        .filter(|e| e.is_finite())
        .collect();
    let least = errors
        .iter()
        .copied()
        .filter(|&e| e > 0.0)
        .fold(f64::INFINITY, f64::min);
    let (title, floor) = if !errors.contains(&0.0) {
        (measure.to_string(), 0.0)
    } else if least.is_finite() {
        // A third of a decade above one that is whole: the axis begins at that.
        let below = libm::exp10(libm::floor(libm::log10(least)) - 1.0);
        (
            format!("{measure} (0: lowest marks)"),
            (2.0 * below).max(f64::MIN_POSITIVE),
        )
    } else {
        (format!("{measure} (all 0)"), 2.0)
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
