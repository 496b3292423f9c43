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

use core::convert::Infallible;
use core::ops::Range;

use ombra_math::glam::DVec2;
use plotters::prelude::*;
use plotters_backend::{BackendColor, BackendCoord, BackendStyle, DrawingErrorKind};

use crate::colour::{Ink, Role};
use crate::drawing::{Drawing, EMPHASIS, NORMAL, Pen, THIN};
use crate::error::FigureError;
use crate::marks::DOT;
use crate::number::decimal;
use crate::number::round_step;
use crate::path::{Path, Rect};
use crate::sheet::{Align, Label, Sheet};
use crate::style::Style;
use crate::text::{LABEL, Line, NOTE};

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
}

impl Series {
    /// Points joined by a line.
    pub fn new(name: impl Into<String>, points: Vec<(f64, f64)>) -> Series {
        Series {
            name: name.into(),
            points,
            joined: true,
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
                .flat_map(|series| &series.points)
                .chain(front.iter().map(|(_, p)| p))
        };
        let x = Span::new(&self.x, every().map(|p| p.0))?;
        let y = Span::new(&self.y, every().map(|p| p.1))?;

        let area = self.area(sheet, &y)?;
        let canvas = sheet.frame().max + sheet.frame().min;
        let mut drawn: Vec<(Path, u8, f64)> = Vec::new();
        let at = {
            let root = Strokes {
                size: canvas,
                drawn: &mut drawn,
            }
            .into_drawing_area();
            let failed = |_| FigureError::Chart {
                reason: format!("the chart {} has no room on this canvas", self.id),
            };
            let mut chart = ChartBuilder::on(&root)
                .margin_left(hundredths(area.min.x))
                .margin_top(hundredths(area.min.y))
                .margin_right(hundredths(canvas.x - area.max.x))
                .margin_bottom(hundredths(canvas.y - area.max.y))
                .build_cartesian_2d(x.range(), y.range())
                .map_err(failed)?;
            for (i, series) in self
                .series
                .iter()
                .enumerate()
                .filter(|(_, series)| series.joined)
            {
                let points = series
                    .points
                    .iter()
                    .map(|&(px, py)| (x.place(px), y.place(py)));
                let colour = Color::stroke_width(&RGBColor(curve(i), 0, 0), hundredths(NORMAL));
                chart
                    .draw_series(LineSeries::new(points, colour))
                    .map_err(|error| FigureError::Chart {
                        reason: format!("the curve {} cannot be drawn: {error}", series.name),
                    })?;
            }
            let place = |(px, py): (f64, f64)| {
                let (column, row) = chart.backend_coord(&(x.place(px), y.place(py)));
                DVec2::new(f64::from(column), f64::from(row)) / 100.0
            };
            let ticks_x: Vec<DVec2> = x
                .ticks
                .iter()
                .map(|tick| place((tick.value, y.low)))
                .collect();
            let ticks_y: Vec<DVec2> = y
                .ticks
                .iter()
                .map(|tick| place((x.low, tick.value)))
                .collect();
            let series: Vec<Vec<DVec2>> = self
                .series
                .iter()
                .map(|series| series.points.iter().map(|&p| place(p)).collect())
                .collect();
            let front: Vec<DVec2> = front.iter().map(|&(_, p)| place(p)).collect();
            (ticks_x, ticks_y, series, front)
        };
        let (ticks_x, ticks_y, places, steps) = at;

        self.draw_axes(sheet, area, (&x, &ticks_x), (&y, &ticks_y))?;
        // The front lies below the curves, broad and pale.
        let corners = steps
            .iter()
            .zip(steps.iter().skip(1))
            .flat_map(|(a, b)| [*a, DVec2::new(b.x, a.y)]);
        let mut staircase: Vec<DVec2> = corners.collect();
        staircase.extend(steps.last());
        sheet.stroke_unmarked(
            Path::polyline(&staircase),
            Pen::new(Ink::of(Role::Chosen).tint(0.5), EMPHASIS),
        );
        for (path, colour, width) in drawn {
            sheet.stroke(path, Pen::new(Role::Curve(colour), width));
        }
        for (i, points) in places.iter().enumerate() {
            for &p in points {
                mark(sheet, p, curve(i));
            }
        }
        for ((name, _), &at) in front.iter().zip(&steps) {
            sheet.stroke(Path::circle(at, 1.9 * DOT), Pen::new(Role::Chosen, NORMAL));
            let label = Label::new(at, name.as_str()).reach(1.9 * DOT).size(NOTE);
            sheet.label(label.towards(DVec2::new(-1.0, 1.0)));
        }
        for (i, (series, points)) in self.series.iter().zip(&places).enumerate() {
            if let Some(&end) = points.last() {
                sheet.label(
                    Label::new(end, series.name.as_str())
                        .reach(DOT + 4.0)
                        .ink(Role::Curve(curve(i))),
                );
            }
        }
        Ok(())
    }

    /// The front from the cheapest on.
    fn front(&self) -> Vec<(String, (f64, f64))> {
        let mut front = self.pareto.clone().unwrap_or_default();
        front.sort_by(|a, b| a.1.0.total_cmp(&b.1.0).then(b.1.1.total_cmp(&a.1.1)));
        front
    }

    /// Where curves lie: the frame without ticks, titles and the labels at the curves' ends.
    fn area(&self, sheet: &Sheet, y: &Span) -> Result<Rect, FigureError> {
        let frame = sheet.frame();
        let mut area = frame;
        area.min.x += widest(y.ticks.iter().map(|tick| tick.text.as_str()), NOTE)? + 18.0;
        area.max.x -= widest(self.series.iter().map(|series| series.name.as_str()), LABEL)? + 36.0;
        area.min.y += 1.9 * LABEL;
        area.max.y -= 1.6 * NOTE + 1.6 * LABEL;
        if area.size().cmpgt(DVec2::splat(200.0)).all() {
            Ok(area)
        } else {
            Err(FigureError::Chart {
                reason: format!(
                    "the chart {} has no room beside its labels on this canvas",
                    self.id
                ),
            })
        }
    }

    fn draw_axes(
        &self,
        sheet: &mut Sheet,
        area: Rect,
        (x, ticks_x): (&Span, &[DVec2]),
        (y, ticks_y): (&Span, &[DVec2]),
    ) -> Result<(), FigureError> {
        let mut grid = Path::new();
        for p in ticks_x {
            grid.add_polyline(&[DVec2::new(p.x, area.min.y), DVec2::new(p.x, area.max.y)]);
        }
        for p in ticks_y {
            grid.add_polyline(&[DVec2::new(area.min.x, p.y), DVec2::new(area.max.x, p.y)]);
        }
        sheet.stroke(grid, Pen::new(Role::Grid, THIN));
        let corner = DVec2::new(area.min.x, area.max.y);
        sheet.stroke(
            Path::polyline(&[area.min, corner, area.max]),
            Pen::new(Role::Axis, THIN),
        );
        for (tick, p) in x.ticks.iter().zip(ticks_x) {
            sheet.text(
                DVec2::new(p.x, area.max.y + 14.0),
                Align::Below,
                &tick.text,
                NOTE,
                Role::Note,
            )?;
        }
        for (tick, p) in y.ticks.iter().zip(ticks_y) {
            sheet.text(
                DVec2::new(area.min.x - 12.0, p.y),
                Align::Right,
                &tick.text,
                NOTE,
                Role::Note,
            )?;
        }
        let below = DVec2::new(area.centre().x, sheet.frame().max.y);
        sheet.text(below, Align::Above, &self.x.words(), LABEL, Role::Text)?;
        let above = DVec2::new(sheet.frame().min.x, sheet.frame().min.y + 0.5 * LABEL);
        sheet.text(above, Align::Left, &self.y.words(), LABEL, Role::Text)?;
        Ok(())
    }
}

/// The width of the widest of some labels.
fn widest<'a>(mut texts: impl Iterator<Item = &'a str>, size: f64) -> Result<f64, FigureError> {
    texts.try_fold(0.0_f64, |most, text| {
        Ok(most.max(Line::new(text, size)?.width))
    })
}

/// The colour of the n-th curve.
fn curve(n: usize) -> u8 {
    (n % 6) as u8
}

/// The mark of a curve's points: each curve has its own shape, so that a grey print still teaches.
fn mark(sheet: &mut Sheet, at: DVec2, curve: u8) {
    let r = 1.15 * DOT;
    let corners = |offsets: &[(f64, f64)]| {
        Path::polygon(
            &offsets
                .iter()
                .map(|&(x, y)| at + DVec2::new(x, y) * r)
                .collect::<Vec<_>>(),
        )
    };
    let path = match curve {
        0 | 5 => Path::circle(at, 0.95 * r),
        1 => corners(&[(-0.85, -0.85), (0.85, -0.85), (0.85, 0.85), (-0.85, 0.85)]),
        2 => corners(&[(0.0, -1.15), (1.1, 0.75), (-1.1, 0.75)]),
        3 => corners(&[(0.0, -1.2), (1.2, 0.0), (0.0, 1.2), (-1.2, 0.0)]),
        _ => corners(&[(0.0, 1.15), (1.1, -0.75), (-1.1, -0.75)]),
    };
    // The last of the six is hollow, since its shape is the first one's.
    let inside = if curve == 5 {
        Role::Paper
    } else {
        Role::Curve(curve)
    };
    sheet.avoid(&path);
    sheet.fill_unmarked(path, inside, Pen::new(Role::Curve(curve), THIN));
}

#[derive(Debug)]
struct Tick {
    value: f64,
    text: String,
}

/// What an axis shows.
#[derive(Debug)]
struct Span {
    scale: Scale,
    low: f64,
    high: f64,
    ticks: Vec<Tick>,
}

impl Span {
    fn new(axis: &Axis, values: impl Iterator<Item = f64>) -> Result<Span, FigureError> {
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        for value in values {
            let shown =
                value.is_finite() && (axis.scale == Scale::Linear || value >= f64::MIN_POSITIVE);
            if !shown {
                let allowed = match axis.scale {
                    Scale::Linear => "finite numbers",
                    Scale::Log => "finite numbers above 0",
                };
                return Err(FigureError::Chart {
                    reason: format!(
                        "{value} cannot be shown on the axis '{}': it takes {allowed}",
                        axis.title
                    ),
                });
            }
            (low, high) = (low.min(value), high.max(value));
        }
        if low > high {
            return Err(FigureError::Chart {
                reason: format!(
                    "the axis '{}' has no values: a chart is at least one point",
                    axis.title
                ),
            });
        }
        let span = match axis.scale {
            Scale::Linear => Span::linear(low, high),
            Scale::Log => Span::log(low, high),
        };
        span.ok_or_else(|| FigureError::Chart {
            reason: format!(
                "the values {low} to {high} on the axis '{}' are too far apart to show",
                axis.title
            ),
        })
    }

    /// Whole steps of 1, 2 or 5 times a power of ten.
    fn linear(low: f64, high: f64) -> Option<Span> {
        let widened = if low == high {
            0.5 * low.abs().max(1.0)
        } else {
            0.0
        };
        let (low, high) = (low - widened, high + widened);
        let step = round_step((high - low) / 6.0);
        if step == 0.0 {
            return None;
        }
        let (first, last) = ((low / step).floor(), (high / step).ceil());
        if last - first > 20.0 {
            return None;
        }
        let ticks = (0..=(last - first) as u32)
            .map(|i| (first + f64::from(i)) * step)
            .map(|value| Tick {
                value,
                text: decimal(value),
            })
            .collect();
        Some(Span {
            scale: Scale::Linear,
            low: first * step,
            high: last * step,
            ticks,
        })
    }

    /// Whole decades, every one labelled as long as there are few; 1, 2, 5 where there is only one or two.
    fn log(low: f64, high: f64) -> Option<Span> {
        let (mut first, mut last) = (decade(low), decade(high));
        if power(1, last)? < high {
            last += 1;
        }
        if first == last {
            (first, last) = (first - 1, last + 1);
        }
        // The highest label is at the upper end, like the lowest at the lower.
        let every = (last - first + 7) / 8;
        last += (every - (last - first) % every) % every;
        let digits: &[u32] = if last - first <= 2 { &[1, 2, 5] } else { &[1] };
        // Near 1 as plain numbers, otherwise all as powers.
        let plain = first >= -2 && last <= 4;
        let mut ticks = Vec::new();
        for exponent in (first..=last).filter(|e| (e - first) % every == 0) {
            for &digit in digits {
                if exponent == last && digit > 1 {
                    break;
                }
                let text = match digit {
                    _ if plain => decimal(power(digit, exponent)?),
                    1 => format!("10^{{{}}}", format!("{exponent}").replace('-', "−")),
                    _ => format!("{digit}·10^{{{}}}", format!("{exponent}").replace('-', "−")),
                };
                ticks.push(Tick {
                    value: power(digit, exponent)?,
                    text,
                });
            }
        }
        Some(Span {
            scale: Scale::Log,
            low: power(1, first)?,
            high: power(1, last)?,
            ticks,
        })
    }

    /// Position along the axis in its own measure.
    fn place(&self, value: f64) -> f64 {
        match self.scale {
            Scale::Linear => value,
            Scale::Log => libm::log10(value),
        }
    }

    fn range(&self) -> Range<f64> {
        self.place(self.low)..self.place(self.high)
    }
}

/// The greatest k with 10ᵏ ≤ value, by the printed exponent, which is exact.
fn decade(value: f64) -> i32 {
    format!("{value:e}")
        .split_once('e')
        .and_then(|(_, e)| e.parse().ok())
        .unwrap_or(0)
}

/// digit · 10ᵏ, the nearest double; none where there is no normal one.
fn power(digit: u32, exponent: i32) -> Option<f64> {
    let value: f64 = format!("{digit}e{exponent}").parse().ok()?;
    value.is_normal().then_some(value)
}

/// Lengths of the display list as plotters' pixels.
fn hundredths(length: f64) -> u32 {
    (length * 100.0).round() as u32
}

/// plotters' backend: it collects lines; colours are numbers of curves.
struct Strokes<'a> {
    size: DVec2,
    drawn: &'a mut Vec<(Path, u8, f64)>,
}

impl Strokes<'_> {
    fn push(
        &mut self,
        points: impl IntoIterator<Item = BackendCoord>,
        colour: BackendColor,
        width: u32,
    ) {
        let points: Vec<DVec2> = points
            .into_iter()
            .map(|(x, y)| DVec2::new(f64::from(x), f64::from(y)) / 100.0)
            .collect();
        self.drawn.push((
            Path::polyline(&points),
            colour.rgb.0,
            f64::from(width) / 100.0,
        ));
    }
}

type Drawn = Result<(), DrawingErrorKind<Infallible>>;

impl DrawingBackend for Strokes<'_> {
    type ErrorType = Infallible;

    fn get_size(&self) -> (u32, u32) {
        (hundredths(self.size.x), hundredths(self.size.y))
    }

    fn ensure_prepared(&mut self) -> Drawn {
        Ok(())
    }

    fn present(&mut self) -> Drawn {
        Ok(())
    }

    fn draw_pixel(&mut self, point: BackendCoord, color: BackendColor) -> Drawn {
        self.push([point, point], color, 1);
        Ok(())
    }

    fn draw_line<S: BackendStyle>(
        &mut self,
        from: BackendCoord,
        to: BackendCoord,
        style: &S,
    ) -> Drawn {
        self.push([from, to], style.color(), style.stroke_width());
        Ok(())
    }

    fn draw_path<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(
        &mut self,
        path: I,
        style: &S,
    ) -> Drawn {
        self.push(path, style.color(), style.stroke_width());
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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
    fn the_front_is_a_staircase_from_the_cheapest_on() {
        let mut chart = chart(vec![(1.0, 9.0), (3.0, 3.0), (5.0, 1.0)], Scale::Linear);
        chart.pareto = Some(vec![
            ("c".into(), (5.0, 1.0)),
            ("a".into(), (1.0, 9.0)),
            ("b".into(), (3.0, 3.0)),
        ]);
        let drawing = chart.draw(&Style::default()).unwrap();
        let front = drawing.items.iter().find_map(|item| match item {
            crate::drawing::Item::Shape {
                path,
                stroke: Some(pen),
                ..
            } if pen.width == EMPHASIS => Some(path.clone()),
            _ => None,
        });
        let points: Vec<DVec2> = front.unwrap().points().collect();
        assert_eq!(points.len(), 5);
        for pair in points.windows(2) {
            let step = pair[1] - pair[0];
            assert!(
                (step.x > 0.0 && step.y == 0.0) || (step.x == 0.0 && step.y > 0.0),
                "{step}"
            );
        }
        for name in ["a", "b", "c"] {
            assert!(texts(&drawing).contains(&name));
        }
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
        for points in [vec![(5.0, 5.0)], vec![(1e-300, 1.0), (1e300, 2.0)]] {
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
