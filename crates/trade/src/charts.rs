//! The charts of a study: error, time and counted work over the knob, and cost against error.

use ombra_figures::chart::{Axis, Bar, Chart, Scale, Series};
use ombra_figures::drawing::Drawing;
use ombra_figures::number::decimal;
use ombra_figures::style::Style;
use ombra_figures::text::escape;

use crate::advice::{digits, number, percent, power_of_ten, times};
use crate::deviation::Measure;
use crate::error::TradeError;
use crate::report::{Answered, Measured, Report, Row};
use crate::study::{Shown, What};

impl Report {
    /// The charts that the study [shows](crate::study::Study::charts), as far as there are values for them.
    ///
    /// # Errors
    ///
    /// [`TradeError::Figure`] when a chart cannot be drawn.
    pub fn charts(&self, style: &Style) -> Result<Vec<Drawing>, TradeError> {
        let charts = self.shown.iter().filter_map(|shown| self.chart(shown));
        let full =
            charts.filter(|chart| chart.series.iter().any(|series| !series.points.is_empty()));
        full.map(|chart| Ok(chart.draw(style)?)).collect()
    }

    fn chart(&self, shown: &Shown) -> Option<Chart> {
        let sweep = self.sweeps.iter().find(|sweep| sweep.name == shown.sweep)?;
        let (kind, over, mut settings) = match shown.what {
            What::Error(0) => (
                "error",
                Some(self.error_over_knob(sweep, 0)?),
                settings(sweep),
            ),
            What::Error(i) => {
                let kind = match self.errors.get(i)? {
                    Measure::Largest(_) => "largest",
                    Measure::Share(_) => "share",
                };
                (kind, Some(self.error_over_knob(sweep, i)?), settings(sweep))
            }
            What::Time => ("time", Some(self.time_over_knob(sweep)), settings(sweep)),
            What::Work => ("work", Some(self.work_over_knob(sweep)), settings(sweep)),
            What::Cost(place) => ("cost", None, inputs(sweep.questions.get(place)?).join(" ")),
        };
        let timed = match shown.what {
            What::Time => "medians; bars: quartiles",
            What::Cost(_) => "ringed: Pareto front; bars: quartiles",
            What::Error(_) | What::Work => "",
        };
        let (x, y, series, pareto, title) = match (over, shown.what) {
            (Some((title, y, series)), _) => {
                let knob = knob_axis(sweep);
                let title = format!("{}: {title} over {}", self.summary, sweep.knob);
                (knob, y, series, None, title)
            }
            (None, What::Cost(place)) => {
                let (x, y, series, front) =
                    self.against_cost(sweep, sweep.questions.get(place)?)?;
                let title = format!("{}: {} against time", self.summary, self.errors.first()?);
                (x, y, series, Some(front), title)
            }
            (None, _) => return None,
        };
        let title = format!("{title}; {settings}");
        for more in [timed].into_iter().filter(|more| !more.is_empty()) {
            settings = format!("{settings}; {more}");
        }
        Some(Chart {
            id: format!("trade/{}/{}-{kind}", self.study, sweep.name),
            title,
            x,
            y,
            series,
            pareto,
            settings: markup(&settings),
        })
    }

    /// A curve a technique: its error over the knob. It ends where answers go missing; one that never begins stays in the
    /// list, so that a technique has the same colour in all charts of its sweep.
    fn error_over_knob(
        &self,
        sweep: &Measured,
        place: usize,
    ) -> Option<(String, Axis, Vec<Series>)> {
        let measure = *self.errors.get(place)?;
        let series = sweep.techniques().into_iter().map(|technique| {
            let errors = sweep
                .rows_of(technique)
                .map(|row| (row.setting, on_axis(measure, measure.of(&row.deviation))));
            let points = errors.filter(|(_, error)| error.is_finite());
            Series {
                end: self.why_it_ends(sweep, technique, |row| measure.of(&row.deviation)),
                ..Series::new(escape(technique), from_left_to_right(points.collect()))
            }
        });
        Some((
            measure.to_string(),
            error_axis(measure),
            coinciding_as_one(series.collect()),
        ))
    }

    /// A curve a technique: its time over the knob, right or wrong.
    fn time_over_knob(&self, sweep: &Measured) -> (String, Axis, Vec<Series>) {
        let is_shown =
            |row: &&Row| row.nanoseconds.median > 0.0 && row.nanoseconds.median.is_finite();
        let series = sweep.techniques().into_iter().map(|technique| {
            let rows = || sweep.rows_of(technique).filter(is_shown);
            let points = rows().map(|row| (row.setting, row.nanoseconds.median));
            let quartiles = rows().filter_map(|row| {
                let times = row.nanoseconds;
                (times.lower > 0.0 && times.upper.is_finite()).then_some(Bar {
                    from: (row.setting, times.lower),
                    to: (row.setting, times.upper),
                })
            });
            Series {
                end: self.why_it_ends(sweep, technique, |row| row.nanoseconds.median),
                quartiles: quartiles.collect(),
                ..Series::new(escape(technique), from_left_to_right(points.collect()))
            }
        });
        let title = format!("time per {}", self.unit);
        (
            title.clone(),
            Axis::new(title, "ns", Scale::Log),
            series.collect(),
        )
    }

    /// A curve a technique: over the knob, the first of the study's charted counters that it moves.
    fn work_over_knob(&self, sweep: &Measured) -> (String, Axis, Vec<Series>) {
        let series = sweep.techniques().into_iter().map(|technique| {
            let Some(what) = sweep.first_moved(technique, self.charted_work) else {
                return Series::new(escape(technique), vec![]);
            };
            let count = |row: &Row| row.work.get(what) as f64;
            let points = sweep
                .rows_of(technique)
                .map(|row| (row.setting, count(row)));
            Series {
                end: self.why_it_ends(sweep, technique, count),
                note: what.name().to_owned(),
                ..Series::new(escape(technique), from_left_to_right(points.collect()))
            }
        });
        let axis = Axis::new("counted operations", "", Scale::Log).with_zero();
        (
            "counted work".to_owned(),
            axis,
            coinciding_as_one(series.collect()),
        )
    }

    /// Every case of a question, what each loses, and the front.
    #[expect(clippy::type_complexity, reason = "the parts of one chart")]
    fn against_cost(
        &self,
        sweep: &Measured,
        question: &Answered,
    ) -> Option<(Axis, Axis, Vec<Series>, Vec<(String, (f64, f64))>)> {
        let measure = *self.errors.first()?;
        let is_shown =
            |row: &&Row| row.error.is_finite() && row.ratio > 0.0 && row.ratio.is_finite();
        let rows = || question.rows.iter().filter(is_shown);
        let error = |row: &Row| on_axis(measure, row.error);
        let point = |row: &Row| (row.ratio, error(row));
        let series = sweep.techniques().into_iter().map(|technique| {
            let mine: Vec<&Row> = rows().filter(|row| row.technique == technique).collect();
            let note = match mine.as_slice() {
                [row] => format!("× {}, {}", times(row.ratio), loss(measure, row.error)),
                _ => String::new(),
            };
            let quartiles = mine.iter().filter_map(|row| {
                // The clock's quartiles, as ratios.
                let scale = row.ratio / row.nanoseconds.median;
                let (lower, upper) = (scale * row.nanoseconds.lower, scale * row.nanoseconds.upper);
                (lower > 0.0 && upper.is_finite()).then_some(Bar {
                    from: (lower, error(row)),
                    to: (upper, error(row)),
                })
            });
            Series {
                joined: mine.len() > 1,
                note,
                quartiles: quartiles.collect(),
                ..Series::new(
                    escape(technique),
                    mine.iter().map(|row| point(row)).collect(),
                )
            }
        });
        // A technique's only point is named in the list; several are told apart by their setting.
        let alone = |row: &Row| {
            rows()
                .filter(|other| other.technique == row.technique)
                .count()
                == 1
        };
        let name = |row: &Row| match alone(row) {
            true => String::new(),
            false => format!("{}: {}", decimal(row.setting), loss(measure, row.error)),
        };
        let front = rows()
            .filter(|row| row.on_front)
            .map(|row| (name(row), point(row)));
        let baseline = question.rows.first().map_or("", |row| row.technique);
        let x = Axis::new(
            format!("time per {}", self.unit),
            format!("{} = 1", escape(baseline)),
            Scale::Log,
        );
        Some((x, error_axis(measure), series.collect(), front.collect()))
    }

    /// Why a technique's curve has no value at some settings: the study's reason where it was not asked, or that answers
    /// went missing; nothing where it has one at all.
    fn why_it_ends(
        &self,
        sweep: &Measured,
        technique: &str,
        value: impl Fn(&Row) -> f64,
    ) -> String {
        let rows: Vec<&Row> = sweep.rows_of(technique).collect();
        let Some(last) = rows.iter().rfind(|row| value(row).is_finite()) else {
            return String::new();
        };
        let at = || markup(&number(last.setting));
        if rows.iter().any(|row| !value(row).is_finite()) {
            return format!("beyond {}: no answer", at());
        }
        let asked = sweep
            .questions
            .iter()
            .filter(|question| !question.rows.is_empty());
        let is_asked =
            |question: &Answered| question.rows.iter().any(|row| row.technique == technique);
        let reason = self.ends.iter().find(|(name, _)| *name == technique);
        match reason {
            Some((_, reason)) if asked.into_iter().any(|question| !is_asked(question)) => {
                format!("to {}: {}", at(), markup(reason))
            }
            _ => String::new(),
        }
    }
}

/// What a technique loses: `exact`, `off by 6·10⁻⁷`, `0.034 % wrong pixels`, in the markup of labels.
fn loss(measure: Measure, error: f64) -> String {
    match measure {
        _ if error == 0.0 => "exact".to_owned(),
        Measure::Largest(_) => format!("off by {}", markup(&digits(error))),
        Measure::Share(what) => format!("{} {}", percent(error), escape(what)),
    }
}

/// The words of a question's inputs, large numbers by their power of ten.
fn inputs(question: &Answered) -> Vec<String> {
    let word = |word: &str| match word.parse::<u32>() {
        Ok(large @ 10_000..) => power_of_ten(f64::from(large)),
        _ => word.to_owned(),
    };
    question.inputs.split(' ').map(word).collect()
}

/// What the questions of a sweep have in common, and from what to what the rest goes: `4000 segments with ends 1 … 10¹²
/// window sizes away`.
fn settings(sweep: &Measured) -> String {
    let (Some(first), Some(last)) = (sweep.questions.first(), sweep.questions.last()) else {
        return String::new();
    };
    let (first, last) = (inputs(first), inputs(last));
    if first.len() != last.len() {
        return format!("{} … {}", first.join(" "), last.join(" "));
    }
    let pairs = first.iter().zip(&last);
    let ranges = pairs.map(|(from, to)| {
        let is_number = |c: char| !matches!(c, ',' | ';' | ')');
        let bare = from.trim_end_matches(|c| !is_number(c));
        match from == to {
            true => from.clone(),
            false => format!("{bare} … {to}"),
        }
    });
    ranges.collect::<Vec<_>>().join(" ")
}

/// Words in the markup of labels: raised digits as such.
fn markup(words: &str) -> String {
    const RAISED: [(char, char); 11] = [
        ('⁰', '0'),
        ('¹', '1'),
        ('²', '2'),
        ('³', '3'),
        ('⁴', '4'),
        ('⁵', '5'),
        ('⁶', '6'),
        ('⁷', '7'),
        ('⁸', '8'),
        ('⁹', '9'),
        ('⁻', '−'),
    ];
    let plain = |c: char| {
        RAISED
            .iter()
            .find(|(raised, _)| *raised == c)
            .map(|(_, plain)| *plain)
    };
    let mut marked = String::new();
    let mut above = false;
    for character in escape(words).chars() {
        let digit = plain(character);
        match (above, digit.is_some()) {
            (false, true) => marked.push_str("^{"),
            (true, false) => marked.push('}'),
            _ => {}
        }
        above = digit.is_some();
        marked.push(digit.unwrap_or(character));
    }
    if above {
        marked.push('}');
    }
    marked
}

fn knob_axis(sweep: &Measured) -> Axis {
    let mut settings: Vec<f64> = sweep.rows().map(|row| row.setting).collect();
    settings.sort_by(f64::total_cmp);
    settings.dedup();
    let axis = Axis::new(escape(sweep.knob), "", scale(settings.iter().copied()));
    if settings.len() <= MOST_TICKS {
        axis.with_ticks(settings)
    } else {
        axis
    }
}

/// Up to so many settings each have their tick.
const MOST_TICKS: usize = 6;

/// The axis of errors: an error of 0, which a logarithm does not have, lies in a band of its own.
fn error_axis(measure: Measure) -> Axis {
    let axis = match measure {
        Measure::Largest(_) => Axis::new(escape(&measure.to_string()), "", Scale::Log),
        Measure::Share(what) => Axis::new(escape(what), "%", Scale::Log),
    };
    axis.with_zero()
}

/// An error on its axis: a share in percent.
fn on_axis(measure: Measure, error: f64) -> f64 {
    match measure {
        Measure::Largest(_) => error,
        Measure::Share(_) => 100.0 * error,
    }
}

/// By the knob, whatever is easy or hard: a curve's name stands at its right end, where there is room for it.
fn from_left_to_right(mut points: Vec<(f64, f64)>) -> Vec<(f64, f64)> {
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    points
}

/// Curves of one kind that lie on one another all along become one with all names; it keeps its place, and with it its colour.
fn coinciding_as_one(mut series: Vec<Series>) -> Vec<Series> {
    for i in 0..series.len() {
        let (before, rest) = series.split_at_mut(i + 1);
        let Some(this) = before.last_mut().filter(|this| !this.points.is_empty()) else {
            continue;
        };
        let same = rest
            .iter_mut()
            .filter(|other| other.points == this.points && other.note == this.note);
        for other in same {
            other.points.clear();
            this.name.push_str(", ");
            this.name.push_str(&core::mem::take(&mut other.name));
        }
    }
    series
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
