//! What plotters makes of a chart's values: curves, and where ticks and points lie.

use ombra_math::glam::DVec2;
use plotters::prelude::*;

use super::axes::Layout;
use super::curve::curve;
use super::front::Named;
use super::span::Span;
use super::strokes::{Strokes, hundredths};
use super::{Bar, Chart};
use crate::colour::Role;
use crate::drawing::{NORMAL, Pen, THIN};
use crate::error::FigureError;
use crate::path::Path;

/// Values on the canvas.
pub(super) struct Plotted {
    /// Each line.
    pub(super) lines: Vec<(Path, Pen)>,
    /// Ticks to the right, and upwards.
    pub(super) ticks: [Vec<DVec2>; 2],
    /// The points of each series.
    pub(super) points: Vec<Vec<DVec2>>,
    /// The ends of the bars of each series.
    pub(super) bars: Vec<Vec<(DVec2, DVec2)>>,
    /// The points of the front.
    pub(super) front: Vec<DVec2>,
}

type Point = (f64, f64);

impl Chart {
    /// Maps the values of `x` and `y` onto a canvas, and draws the lines of all series.
    pub(super) fn plot(
        &self,
        canvas: DVec2,
        layout: &Layout,
        [x, y]: [&Span; 2],
        front: &[Named],
    ) -> Result<Plotted, FigureError> {
        let area = layout.scaled;
        let mut strokes: Vec<(Path, u8, f64)> = Vec::new();
        let root = Strokes {
            size: canvas,
            drawn: &mut strokes,
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
        let curves = self.series.iter().enumerate().flat_map(|(i, series)| {
            let joined = series.joined.then_some(&series.points);
            let of = joined.into_iter().chain([&series.line]);
            of.flat_map(move |points| self.above_zero(points))
                .map(move |points| (i, series, points))
        });
        for (i, series, points) in curves {
            let points = points.iter().map(|&(px, py)| (x.place(px), y.place(py)));
            let colour = Color::stroke_width(&RGBColor(curve(i), 0, 0), hundredths(NORMAL));
            chart
                .draw_series(LineSeries::new(points, colour))
                .map_err(|error| FigureError::Chart {
                    reason: format!("the curve {} cannot be drawn: {error}", series.name),
                })?;
        }
        let place = |(px, py): Point| {
            let (column, row) = chart.backend_coord(&(x.place(px), y.place(py)));
            DVec2::new(f64::from(column), f64::from(row)) / 100.0
        };
        let ticks_x = x
            .ticks
            .iter()
            .map(|tick| DVec2::new(place((tick.value, y.low)).x, layout.area.max.y));
        let ticks_y = y.ticks.iter().map(|tick| place((x.low, tick.value)));
        let ticks = [ticks_x.collect(), ticks_y.collect()];
        // A zero lies in its series' lane of the band.
        let shown = |series: usize, p: Point| {
            if self.y.is_zero(p.1) {
                DVec2::new(place((p.0, y.low)).x, layout.lane(series))
            } else {
                place(p)
            }
        };
        let series = self.series.iter().enumerate();
        let points: Vec<Vec<DVec2>> = series
            .map(|(i, series)| series.points.iter().map(|&p| shown(i, p)).collect())
            .collect();
        let ends = |bar: &Bar| (place(bar.from), place(bar.to));
        let is_above = |bar: &&Bar| ![bar.from, bar.to].iter().any(|p| self.y.is_zero(p.1));
        let bars = self.series.iter().map(|series| {
            let bars = series.quartiles.iter().filter(is_above);
            bars.map(ends).filter(|(from, to)| from != to).collect()
        });
        let bars = bars.collect();
        let front = front.iter().map(|(_, p)| {
            let mut named = self.series.iter().enumerate();
            let of = named.find(|(_, series)| series.points.contains(p));
            shown(of.map_or(0, |(i, _)| i), *p)
        });
        let front = front.collect();
        drop(chart);
        drop(root);
        let above = strokes.into_iter();
        let mut lines: Vec<(Path, Pen)> = above
            .map(|(path, colour, width)| (path, Pen::new(Role::Curve(colour), width)))
            .collect();
        lines.extend(self.through_zero(&points));
        Ok(Plotted {
            lines,
            ticks,
            points,
            bars,
            front,
        })
    }

    /// The pieces of a line between its zeros.
    fn above_zero<'a>(&'a self, points: &'a [Point]) -> impl Iterator<Item = &'a [Point]> {
        let pieces = points.split(|p| self.y.is_zero(p.1));
        pieces.filter(|piece| !piece.is_empty())
    }

    /// Lines along the lanes of the band of zeros; dashed, those that come out of it.
    fn through_zero(&self, points: &[Vec<DVec2>]) -> Vec<(Path, Pen)> {
        let mut lines = Vec::new();
        for (i, (series, points)) in self.series.iter().zip(points).enumerate() {
            if !series.joined {
                continue;
            }
            let steps = series.points.iter().zip(points);
            let next = series.points.iter().zip(points).skip(1);
            for ((from, a), (to, b)) in steps.zip(next) {
                let pen = match (self.y.is_zero(from.1), self.y.is_zero(to.1)) {
                    (false, false) => continue,
                    (true, true) => Pen::new(Role::Curve(curve(i)), NORMAL),
                    _ => Pen::new(Role::Curve(curve(i)), THIN).dashed(),
                };
                lines.push((Path::line(*a, *b), pen));
            }
        }
        lines
    }
}
