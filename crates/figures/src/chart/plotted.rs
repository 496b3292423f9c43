//! What plotters makes of a chart's values: curves, and where ticks and points lie.

use ombra_math::glam::DVec2;
use plotters::prelude::*;

use super::Chart;
use super::curve::curve;
use super::front::Named;
use super::span::Span;
use super::strokes::{Strokes, hundredths};
use crate::drawing::NORMAL;
use crate::error::FigureError;
use crate::path::{Path, Rect};

/// Values on the canvas.
pub(super) struct Plotted {
    /// Each line with the colour of its curve and its width.
    pub(super) lines: Vec<(Path, u8, f64)>,
    /// Ticks to the right, and upwards.
    pub(super) ticks: [Vec<DVec2>; 2],
    /// The points of each series.
    pub(super) points: Vec<Vec<DVec2>>,
    /// The points of the front.
    pub(super) front: Vec<DVec2>,
}

impl Chart {
    /// Maps the values of `x` and `y` onto `area` of a canvas, and draws the lines of all series.
    pub(super) fn plot(
        &self,
        canvas: DVec2,
        area: Rect,
        [x, y]: [&Span; 2],
        front: &[Named],
    ) -> Result<Plotted, FigureError> {
        let mut lines: Vec<(Path, u8, f64)> = Vec::new();
        let root = Strokes {
            size: canvas,
            drawn: &mut lines,
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
            of.map(move |points| (i, series, points))
        });
        for (i, series, points) in curves.filter(|(.., points)| !points.is_empty()) {
            let points = points.iter().map(|&(px, py)| (x.place(px), y.place(py)));
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
        let ticks_x = x.ticks.iter().map(|tick| place((tick.value, y.low)));
        let ticks_y = y.ticks.iter().map(|tick| place((x.low, tick.value)));
        let ticks = [ticks_x.collect(), ticks_y.collect()];
        let series = self.series.iter();
        let points = series.map(|series| series.points.iter().map(|&p| place(p)).collect());
        let points = points.collect();
        let front = front.iter().map(|&(_, p)| place(p)).collect();
        drop(chart);
        drop(root);
        Ok(Plotted {
            lines,
            ticks,
            points,
            front,
        })
    }
}
