//! Charts: curves labelled at their ends, ticks at round values, the Pareto front as a stepped line.
//!
//! plotters maps the values and draws the curves; its backend here is the display list, in hundredths, so that SVG and
//! PNG agree. Axes, ticks and words are the kit's own.
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
//! };
//! let drawing = chart.draw(&Style::default())?;
//! assert!(drawing.labels.iter().any(|label| label.text == "matrix"));
//! # Ok::<(), ombra_figures::error::FigureError>(())
//! ```

mod axes;
mod curve;
mod front;
mod plotted;
mod span;
mod strokes;

use self::curve::{curve, mark};
use self::plotted::Plotted;
use self::span::Span;
use crate::colour::Role;
use crate::drawing::{Drawing, Pen};
use crate::error::FigureError;
use crate::marks::DOT;
use crate::sheet::{Label, Sheet};
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
}

impl Axis {
    /// An axis of that title, unit and scale.
    pub fn new(title: impl Into<String>, unit: impl Into<String>, scale: Scale) -> Axis {
        Axis {
            title: title.into(),
            unit: unit.into(),
            scale,
        }
    }

    fn words(&self) -> String {
        match self.unit.as_str() {
            "" => self.title.clone(),
            unit => format!("{} / {unit}", self.title),
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
}

impl Series {
    /// Points joined by a line.
    pub fn new(name: impl Into<String>, points: Vec<(f64, f64)>) -> Series {
        Series {
            name: name.into(),
            points,
            joined: true,
            line: Vec::new(),
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
                .flat_map(|series| series.points.iter().chain(&series.line))
                .chain(front.iter().map(|(_, p)| p))
        };
        // A curve may begin on the upright axis, single points may not.
        let x = Span::new(&self.x, every().map(|p| p.0), self.pareto.is_some())?;
        let y = Span::new(&self.y, every().map(|p| p.1), true)?;

        let area = self.area(sheet, &y)?;
        let canvas = sheet.frame().max + sheet.frame().min;
        let Plotted {
            lines,
            ticks: [ticks_x, ticks_y],
            points,
            front: steps,
        } = self.plot(canvas, area, [&x, &y], &front)?;

        self.draw_axes(sheet, area, (&x, &ticks_x), (&y, &ticks_y))?;
        front::draw_steps(sheet, &steps);
        for (path, colour, width) in lines {
            sheet.stroke(path, Pen::new(Role::Curve(colour), width));
        }
        for (i, points) in points.iter().enumerate() {
            for &p in points {
                mark(sheet, p, curve(i));
            }
        }
        front::name_points(sheet, &front, &steps);
        for (i, (series, points)) in self.series.iter().zip(&points).enumerate() {
            if let Some(&end) = points.last() {
                let label = Label::new(end, series.name.as_str()).reach(DOT + 4.0);
                sheet.label(label.ink(Role::Curve(curve(i))));
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use ombra_math::glam::DVec2;

    use super::*;
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
        let drawing = chart(vec![(2.0, 1e-16), (900.0, 3e-13)], Scale::Log)
            .draw(&Style::default())
            .unwrap();
        let texts = texts(&drawing);
        for tick in [
            "1", "10", "100", "1000", "10−16", "10−15", "10−14", "10−13", "10−12",
        ] {
            assert!(texts.contains(&tick), "{tick} in {texts:?}");
        }
        assert!(
            texts.contains(&"cost / ns") && texts.contains(&"error") && texts.contains(&"curve")
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
        let mut single = chart(vec![(1.0, 1.0), (500.0, 9.0)], Scale::Log);
        let starts_at_one = |chart: &Chart| {
            let drawing = chart.draw(&Style::default()).unwrap();
            !texts(&drawing).contains(&"0.1")
        };
        assert!(starts_at_one(&single));
        single.pareto = Some(vec![]);
        assert!(!starts_at_one(&single));
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
}
