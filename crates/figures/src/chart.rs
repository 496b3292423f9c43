//! Charts: curves named beside their ends, ticks at round values, the Pareto front as a stepped line.
//!
//! plotters maps the values and draws the curves; its backend here is the display list, in hundredths, so that SVG and
//! PNG agree. Axes, ticks and words are the kit's own.
//!
//! - Names stand in a column to the right, each at the height of its curve's end; where the canvas is no wider than high,
//!   in a list below. They shrink to the smallest letters before a chart has no room.
//! - A logarithmic axis that [shows zeros](Axis::with_zero) has a band below for them, a lane a curve, so that curves
//!   that are all exact do not hide each other.
//! - A curve that ends before the others has a bar across its end, and [says why](Series::end).
//! - Upright bars reach from one quartile to the other, where a series [has them](Series::quartiles).
//!
//! ```
//! use ombra_figures::chart::{Axis, Chart, Scale, Series};
//! use ombra_figures::style::Style;
//!
//! let chart = Chart {
//!     id: "trade/planar-precision".to_owned(),
//!     title: "Error against cost".to_owned(),
//!     x: Axis::new("cost", "ns", Scale::Log),
//!     y: Axis::new("error", "", Scale::Log),
//!     series: vec![Series::new("matrix", vec![(2.0, 1e-7), (3.0, 1e-16)])],
//!     pareto: None,
//!     settings: "2000 vertices".to_owned(),
//! };
//! let drawing = chart.draw(&Style::default())?;
//! assert!(drawing.labels.iter().any(|label| label.text == "matrix"));
//! # Ok::<(), ombra_figures::error::FigureError>(())
//! ```

mod axes;
mod curve;
mod front;
mod names;
mod plotted;
mod span;
mod strokes;

use self::axes::Layout;
use self::curve::{curve, mark};
use self::plotted::Plotted;
use self::span::Span;
use crate::drawing::Drawing;
use crate::error::FigureError;
use crate::sheet::Sheet;
use crate::style::Style;

/// How values lie along an axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scale {
    /// Equal differences are equal lengths.
    Linear,
    /// Equal ratios are equal lengths; values are above 0.
    Log,
}

/// An axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// What it counts, in the markup of [`crate::text`].
    pub title: String,
    /// In what unit; empty for a pure number.
    pub unit: String,
    /// How values lie along it.
    pub scale: Scale,
    /// Whether a logarithmic axis that goes upwards has a band of its own for exact zeros. It is drawn where there are some.
    pub zero: bool,
    /// Where a linear axis has its ticks, which it does not reach beyond; round values where there are none.
    pub at: Vec<f64>,
}

impl Axis {
    /// An axis of that title, unit and scale.
    pub fn new(title: impl Into<String>, unit: impl Into<String>, scale: Scale) -> Axis {
        Axis {
            title: title.into(),
            unit: unit.into(),
            scale,
            zero: false,
            at: Vec::new(),
        }
    }

    /// With a band for exact zeros.
    pub fn with_zero(self) -> Axis {
        Axis { zero: true, ..self }
    }

    /// With ticks at these values, where it is linear.
    pub fn with_ticks(self, at: Vec<f64>) -> Axis {
        Axis { at, ..self }
    }

    /// Whether `value` lies in the band of zeros.
    fn is_zero(&self, value: f64) -> bool {
        self.zero && self.scale == Scale::Log && value == 0.0
    }

    fn words(&self) -> String {
        match self.unit.as_str() {
            "" => self.title.clone(),
            unit => format!("{} ({unit})", self.title),
        }
    }
}

/// A curve.
#[derive(Clone, Debug, PartialEq)]
pub struct Series {
    /// Its label, in the markup of [`crate::text`].
    pub name: String,
    /// Its points in the order they are joined.
    pub points: Vec<(f64, f64)>,
    /// Whether a line joins them.
    pub joined: bool,
    /// What the points are held against, such as a formula: a line without marks, in the same colour. Empty for none.
    pub line: Vec<(f64, f64)>,
    /// What else is said below its name, such as what is lost there. Empty for nothing.
    pub note: String,
    /// Why it ends where it does, said below its name; a bar stands across its end. Empty where it just ends.
    pub end: String,
    /// Bars through points: where, from which lower to which upper quartile.
    pub quartiles: Vec<Bar>,
}

/// From a lower to an upper quartile.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bar {
    /// The lower end, as a point of the chart.
    pub from: (f64, f64),
    /// The upper end.
    pub to: (f64, f64),
}

impl Series {
    /// Points joined by a line.
    pub fn new(name: impl Into<String>, points: Vec<(f64, f64)>) -> Series {
        Series {
            name: name.into(),
            points,
            joined: true,
            line: Vec::new(),
            note: String::new(),
            end: String::new(),
            quartiles: Vec::new(),
        }
    }
}

/// A chart.
#[derive(Clone, Debug, PartialEq)]
pub struct Chart {
    /// The figure's id, `trade/planar-precision`.
    pub id: String,
    /// One line that says what it shows.
    pub title: String,
    /// To the right.
    pub x: Axis,
    /// Upwards.
    pub y: Axis,
    /// Curves; each has its own colour and mark.
    pub series: Vec<Series>,
    /// The points that nothing beats in both directions, named; less is better on both axes.
    pub pareto: Option<Vec<(String, (f64, f64))>>,
    /// At which settings it was made, in the markup of [`crate::text`]: a line above the axes. Empty for none.
    pub settings: String,
}

impl Chart {
    /// Draws it.
    ///
    /// # Errors
    ///
    /// [`FigureError::Chart`] for a value that an axis cannot show or a chart without points; those of labels.
    pub fn draw(&self, style: &Style) -> Result<Drawing, FigureError> {
        let mut sheet = Sheet::new(style, &self.title)?;
        self.draw_on(&mut sheet)?;
        sheet.finish(&self.id, &self.title)
    }

    /// Draws it as a part of a figure.
    ///
    /// # Errors
    ///
    /// As [`Chart::draw`].
    pub fn draw_on(&self, sheet: &mut Sheet) -> Result<(), FigureError> {
        let front = self.front();
        let every = || {
            self.series
                .iter()
                .flat_map(|series| {
                    let bars = series.quartiles.iter().flat_map(|bar| [&bar.from, &bar.to]);
                    series.points.iter().chain(&series.line).chain(bars)
                })
                .chain(front.iter().map(|(_, p)| p))
        };
        // A curve may begin on the upright axis, single points may not.
        let x = Span::new(&self.x, every().map(|p| p.0), self.pareto.is_some())?;
        let y = Span::new(&self.y, every().map(|p| p.1), true)?;

        let layout = Layout::new(self, sheet, [&x, &y])?;
        let canvas = sheet.frame().max + sheet.frame().min;
        let Plotted {
            lines,
            ticks,
            points,
            bars,
            front: steps,
        } = self.plot(canvas, &layout, [&x, &y], &front)?;

        layout.draw_axes(sheet, [&x, &y], &ticks)?;
        front::draw_steps(sheet, &steps);
        for (path, pen) in lines {
            sheet.stroke(path, pen);
        }
        for (i, bars) in bars.iter().enumerate() {
            for &ends in bars {
                curve::bar(sheet, ends, curve(i));
            }
        }
        for (i, (points, series)) in points.iter().zip(&self.series).enumerate() {
            for &p in points {
                mark(sheet, p, curve(i));
            }
            if let Some(&end) = points.last().filter(|_| !series.end.is_empty()) {
                curve::stop(sheet, end, curve(i));
            }
        }
        front::name_points(sheet, &front, &steps, layout.area);
        layout.draw_names(sheet, &points);
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use ombra_math::glam::DVec2;

    use super::*;
    use crate::colour::Role;
    use crate::drawing::NORMAL;
    use crate::path::Path;

    fn chart(points: Vec<(f64, f64)>, scale: Scale) -> Chart {
        Chart {
            id: "trade/test".to_owned(),
            title: "Test".to_owned(),
            x: Axis::new("cost", "ns", scale),
            y: Axis::new("error", "", scale),
            series: vec![Series::new("curve", points)],
            pareto: None,
            settings: String::new(),
        }
    }

    fn texts(drawing: &Drawing) -> Vec<&str> {
        drawing
            .labels
            .iter()
            .map(|label| label.text.as_str())
            .collect()
    }

    #[test]
    fn every_decade_is_labelled_the_lowest_too() {
        let drawing = chart(vec![(1.0, 2e-16), (900.0, 3e-12)], Scale::Log)
            .draw(&Style::default())
            .unwrap();
        let texts = texts(&drawing);
        for tick in [
            "1", "10", "100", "1000", "10−16", "10−15", "10−14", "10−13", "10−12", "10−11",
        ] {
            assert!(texts.contains(&tick), "{tick} in {texts:?}");
        }
        assert!(
            texts.contains(&"cost (ns)") && texts.contains(&"error") && texts.contains(&"curve")
        );
    }

    #[test]
    fn a_log_axis_lies_below_its_lowest_point_but_a_curve_may_begin_at_the_side() {
        // 1.2 · 10⁻⁵ is 0.08 decades above 10⁻⁵, 1.6 · 10⁻⁵ is 0.2.
        for (lowest, first) in [(1.2e-5, "10−6"), (1.6e-5, "10−5")] {
            let points = vec![(1.0, lowest), (1e3, 0.3)];
            let drawing = chart(points, Scale::Log).draw(&Style::default()).unwrap();
            let texts = texts(&drawing);
            assert_eq!(texts.contains(&"10−6"), first == "10−6", "{texts:?}");
            assert!(texts.contains(&first) && !texts.contains(&"0.1"));
        }
        // The tick at 1 moves away from the upright axis.
        let mut single = chart(vec![(1.0, 3.0), (500.0, 9.0)], Scale::Log);
        let one = |chart: &Chart| {
            let drawing = chart.draw(&Style::default()).unwrap();
            let tick = drawing.labels.iter().find(|label| label.text == "1");
            tick.map(|label| label.bounds.centre().x).unwrap()
        };
        let at_the_side = one(&single);
        single.pareto = Some(vec![]);
        assert!(one(&single) > at_the_side + 50.0);
    }

    #[test]
    fn an_axis_of_one_or_two_decades_begins_and_ends_within_them() {
        let drawing = chart(vec![(0.4, 3.0), (1.3, 60.0)], Scale::Log)
            .draw(&Style::default())
            .unwrap();
        let texts = texts(&drawing);
        for tick in ["0.2", "0.5", "1", "2", "5", "10", "100"] {
            assert!(texts.contains(&tick), "{tick} in {texts:?}");
        }
        assert!(!texts.contains(&"0.1") && !texts.contains(&"200"));
    }

    #[test]
    fn linear_ticks_are_round() {
        let drawing = chart(vec![(0.0, 0.0), (11.0, 0.3)], Scale::Linear)
            .draw(&Style::default())
            .unwrap();
        let texts = texts(&drawing);
        for tick in ["0", "2", "12", "0.05", "0.3"] {
            assert!(texts.contains(&tick), "{tick} in {texts:?}");
        }
    }

    #[test]
    fn a_log_axis_maps_equal_ratios_to_equal_lengths() {
        let drawing = chart(vec![(1.0, 1.0), (10.0, 10.0), (100.0, 100.0)], Scale::Log);
        let drawing = drawing.draw(&Style::default()).unwrap();
        let curve = drawing.items.iter().find_map(|item| match item {
            crate::drawing::Item::Shape {
                path,
                stroke: Some(pen),
                ..
            } if pen.paint == Role::Curve(0).into() && pen.width == NORMAL => Some(path.clone()),
            _ => None,
        });
        let points: Vec<DVec2> = curve.unwrap().points().collect();
        let (first, second) = (points[1] - points[0], points[2] - points[1]);
        // plotters places points on whole hundredths.
        assert!((first - second).abs().max_element() <= 0.021, "{points:?}");
        assert!(first.x > 0.0 && first.y < 0.0);
    }

    #[test]
    fn a_line_runs_past_the_points_held_against_it() {
        let mut chart = chart(vec![(2.0, 2.0)], Scale::Log);
        let curves = |chart: &Chart| -> Vec<Path> {
            let drawing = chart.draw(&Style::default()).unwrap();
            let curve = |item| match item {
                crate::drawing::Item::Shape {
                    path,
                    stroke: Some(pen),
                    ..
                } if pen.paint == Role::Curve(0).into() && pen.width == NORMAL => Some(path),
                _ => None,
            };
            drawing.items.into_iter().filter_map(curve).collect()
        };
        chart.series[0].joined = false;
        assert!(curves(&chart).is_empty());
        chart.series[0].line = vec![(1.0, 1.0), (10.0, 10.0), (1000.0, 1000.0)];
        let drawn = curves(&chart);
        assert_eq!(drawn.len(), 1);
        assert_eq!(drawn[0].points().count(), 3);
        // The axes reach as far as the line.
        let drawing = chart.draw(&Style::default()).unwrap();
        assert!(texts(&drawing).contains(&"1000"));
    }

    #[test]
    fn values_no_axis_can_show_are_named() {
        for (points, scale, says) in [
            (vec![(1.0, f64::NAN)], Scale::Linear, "NaN"),
            (vec![(f64::INFINITY, 1.0)], Scale::Log, "inf"),
            (
                vec![(0.0, 1.0)],
                Scale::Log,
                "0 cannot be shown on the axis 'cost'",
            ),
            (vec![(1.0, -3.0)], Scale::Log, "-3"),
            (vec![], Scale::Linear, "no values"),
            (
                vec![(-f64::MAX, 0.0), (f64::MAX, 0.0)],
                Scale::Linear,
                "too far apart",
            ),
        ] {
            let error = chart(points, scale)
                .draw(&Style::default())
                .unwrap_err()
                .to_string();
            assert!(error.contains(says), "{error}");
        }
        // One point, and values at the ends of the range, are shown.
        for points in [
            vec![(5.0, 5.0)],
            vec![(1e-300, 1.0), (1e300, 2.0)],
            vec![(1.0, 1e-307), (2.0, 1e-306)],
        ] {
            assert!(
                chart(points.clone(), Scale::Log)
                    .draw(&Style::default())
                    .is_ok(),
                "{points:?}"
            );
        }
        assert!(
            chart(vec![(0.0, 0.0)], Scale::Linear)
                .draw(&Style::default())
                .is_ok()
        );
    }

    #[test]
    fn a_zero_lies_in_a_band_of_its_own_and_only_where_there_is_one() {
        let mut zeros = chart(
            vec![(1.0, 0.0), (10.0, 0.0), (100.0, 1e-3), (200.0, 2e-9)],
            Scale::Log,
        );
        assert!(zeros.draw(&Style::default()).is_err());
        zeros.y = zeros.y.with_zero();
        // Another curve that is exact where the first is lies in a lane of its own.
        zeros
            .series
            .push(Series::new("other", vec![(1.0, 0.0), (10.0, 0.0)]));
        let drawing = zeros.draw(&Style::default()).unwrap();
        assert!(texts(&drawing).contains(&"0"));
        let height = |curve: u8, width: f64| -> Vec<f64> {
            let of = |item: &crate::drawing::Item| match item {
                crate::drawing::Item::Shape {
                    path,
                    stroke: Some(pen),
                    ..
                } if pen.paint == Role::Curve(curve).into()
                    && pen.width == width
                    && pen.dash.is_none() =>
                {
                    Some(path.points().map(|p| p.y).collect::<Vec<_>>())
                }
                _ => None,
            };
            drawing.items.iter().filter_map(of).flatten().collect()
        };
        let all = height(0, NORMAL);
        let (above, first) = all.split_at(2);
        let other = height(1, NORMAL);
        assert!(above.iter().all(|y| *y < first[0]), "{above:?} {first:?}");
        assert!(first[0] == first[1] && other[0] == other[1] && first[0] < other[0]);
        // No error is 0: no band.
        zeros.series[0].points.retain(|p| p.1 > 0.0);
        zeros.series.truncate(1);
        assert!(!texts(&zeros.draw(&Style::default()).unwrap()).contains(&"0"));
        // All are.
        zeros.series[0].points = vec![(1.0, 0.0), (5.0, 0.0)];
        assert!(texts(&zeros.draw(&Style::default()).unwrap()).contains(&"0"));
    }
}
