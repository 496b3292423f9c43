//! Where the parts of a chart lie, and its axes around the curves.

use ombra_math::glam::DVec2;

use super::Chart;
use super::names::Names;
use super::span::{Span, Tick};
use crate::colour::Role;
use crate::drawing::{Pen, THIN};
use crate::error::FigureError;
use crate::path::{Path, Rect};
use crate::sheet::{Align, Sheet};
use crate::text::{LABEL, Line, NOTE, wrapped};

/// From one baseline to the next, in ems.
pub(super) const LEADING: f64 = 1.25;
/// From a tick's label to its axis.
const TICK_GAP: f64 = 16.0;
/// Below the axis, where the lowest label of the other one reaches into the corner.
const BELOW: f64 = 32.0;
/// Between two labels on an axis, at least, and from the lowest of them to the band of zeros.
const APART: f64 = 22.0;
/// The least side of the area of curves, and the height for which names go on shrinking.
const LEAST: f64 = 150.0;
const ENOUGH: f64 = 300.0;
/// The height of a lane of the band of zeros, and its least height.
const LANE: f64 = 30.0;
const BAND: f64 = 64.0;

/// Where the parts of a chart lie.
pub(super) struct Layout {
    /// Where curves lie, the band of zeros with them.
    pub(super) area: Rect,
    /// Where values lie that the axes measure.
    pub(super) scaled: Rect,
    /// Of each series its lane in the band of zeros.
    lanes: Vec<Option<f64>>,
    /// The names of curves.
    pub(super) names: Names,
    /// Lines with their size and colour, each with the middle of its left edge.
    titles: Vec<(Line, DVec2, Role)>,
    /// Which ticks have labels.
    labelled: [Vec<bool>; 2],
}

impl Layout {
    /// Divides the sheet: above, the settings and the title of the upright axis; below, ticks, the other title and
    /// perhaps the list of names; to the left ticks; to the right perhaps the column of names.
    pub(super) fn new(
        chart: &Chart,
        sheet: &Sheet,
        [x, y]: [&Span; 2],
    ) -> Result<Layout, FigureError> {
        let frame = sheet.frame();
        let mut titles = Vec::new();
        let mut area = frame;
        let above = [
            (chart.y.words(), LABEL, Role::Text),
            (chart.settings.clone(), NOTE, Role::Note),
        ];
        for (words, size, ink) in above {
            if words.is_empty() {
                continue;
            }
            for line in wrapped(&words, size, frame.size().x)? {
                let height = (LEADING * size).max(line.ascent + line.descent);
                titles.push((
                    line,
                    DVec2::new(frame.min.x, area.min.y + 0.5 * height),
                    ink,
                ));
                area.min.y += height;
            }
        }
        // The uppermost tick's label reaches half its height above the axis.
        area.min.y += 0.7 * NOTE;

        let mut best: Option<Layout> = None;
        for names in Names::ways(chart, frame, area.min.y)? {
            let layout = Layout::around(chart, frame, area, titles.clone(), names, [x, y])?;
            let height = |layout: &Layout| layout.scaled.size().y;
            if best
                .as_ref()
                .is_none_or(|best| height(&layout) > height(best))
            {
                best = Some(layout);
            }
            if best.as_ref().is_some_and(|best| height(best) >= ENOUGH) {
                break;
            }
        }
        let has_room =
            |layout: &Layout| layout.area.size().x >= LEAST && layout.scaled.size().y >= LEAST;
        best.filter(has_room).ok_or_else(|| FigureError::Chart {
            reason: format!(
                "the chart {} has no room beside its labels on this canvas",
                chart.id
            ),
        })
    }

    /// What `titles` above the `area` and the names leave.
    fn around(
        chart: &Chart,
        frame: Rect,
        mut area: Rect,
        mut titles: Vec<(Line, DVec2, Role)>,
        names: Names,
        [x, y]: [&Span; 2],
    ) -> Result<Layout, FigureError> {
        area.max.x -= names.beside();
        area.max.y -= names.below();
        let title = wrapped(&chart.x.words(), LABEL, frame.size().x)?;
        let heights = title
            .iter()
            .map(|line| (LEADING * LABEL).max(line.ascent + line.descent));
        let heights: Vec<f64> = heights.collect();
        area.max.y -= heights.iter().sum::<f64>();
        let top = area.max.y;
        area.max.y -= BELOW + 1.3 * NOTE;
        area.min.x += widest(y.ticks.iter(), NOTE)?.max(0.5 * LABEL) + TICK_GAP + 4.0;
        // The last label of the axis to the right reaches beyond it.
        let last = x.ticks.last().map_or(Ok(0.0), |tick| {
            Line::new(&tick.text, NOTE).map(|line| line.width)
        })?;
        // It keeps clear of the names beside it.
        let end = frame.max.x - names.beside() + names.spare();
        area.max.x = area.max.x.min(end - 0.5 * last);

        let mut middle = top;
        for (line, height) in title.into_iter().zip(heights) {
            let half = 0.5 * line.width;
            let centre = area
                .centre()
                .x
                .min(frame.max.x - half)
                .max(frame.min.x + half);
            titles.push((
                line,
                DVec2::new(centre - half, middle + 0.5 * height),
                Role::Text,
            ));
            middle += height;
        }

        let (scaled, lanes) = lanes(chart, area, y.zeros);
        let share = |size: f64, length: f64| (size + APART) / length;
        let across = x
            .ticks
            .iter()
            .map(|tick| Ok(share(Line::new(&tick.text, NOTE)?.width, scaled.size().x)));
        let across: Vec<f64> = across.collect::<Result<_, FigureError>>()?;
        let upwards = vec![share(NOTE, scaled.size().y); y.ticks.len()];
        let labelled = [x.labelled(&across), y.labelled(&upwards)];
        Ok(Layout {
            area,
            scaled,
            lanes,
            names,
            titles,
            labelled,
        })
    }

    /// How high a zero of a series lies.
    pub(super) fn lane(&self, series: usize) -> f64 {
        let lane = self.lanes.get(series).copied().flatten();
        lane.unwrap_or(self.area.max.y)
    }

    /// The grid, both axes with their ticks and titles, the band of zeros, and the settings.
    pub(super) fn draw_axes(
        &self,
        sheet: &mut Sheet,
        [x, y]: [&Span; 2],
        [ticks_x, ticks_y]: &[Vec<DVec2>; 2],
    ) -> Result<(), FigureError> {
        let (area, scaled) = (self.area, self.scaled);
        if y.zeros {
            let top = DVec2::new(area.min.x, scaled.max.y + APART);
            let corners = [
                top,
                DVec2::new(area.max.x, top.y),
                area.max,
                DVec2::new(area.min.x, area.max.y),
            ];
            sheet.fill(Path::polygon(&corners), Role::Ground);
            let middle = DVec2::new(area.min.x - TICK_GAP, 0.5 * (top.y + area.max.y));
            sheet.text(middle, Align::Right, "0", NOTE, Role::Note)?;
        }
        let mut grid = Path::new();
        for p in ticks_x {
            grid.add_polyline(&[DVec2::new(p.x, area.min.y), DVec2::new(p.x, scaled.max.y)]);
        }
        for p in ticks_y {
            grid.add_polyline(&[DVec2::new(area.min.x, p.y), DVec2::new(area.max.x, p.y)]);
        }
        sheet.stroke(grid, Pen::new(Role::Grid, THIN));
        let mut axes = Path::polyline(&[area.min, DVec2::new(area.min.x, scaled.max.y)]);
        if y.zeros {
            // Broken above the band: no length leads to 0.
            axes.add_polyline(&[
                DVec2::new(area.min.x, scaled.max.y + APART),
                DVec2::new(area.min.x, area.max.y),
            ]);
        }
        axes.add_polyline(&[DVec2::new(area.min.x, area.max.y), area.max]);
        sheet.stroke(axes, Pen::new(Role::Axis, THIN));
        let [across, upwards] = &self.labelled;
        for ((tick, p), _) in x
            .ticks
            .iter()
            .zip(ticks_x)
            .zip(across)
            .filter(|(_, shown)| **shown)
        {
            let below = DVec2::new(p.x, area.max.y + BELOW);
            sheet.text(below, Align::Below, &tick.text, NOTE, Role::Note)?;
        }
        for ((tick, p), _) in y
            .ticks
            .iter()
            .zip(ticks_y)
            .zip(upwards)
            .filter(|(_, shown)| **shown)
        {
            let beside = DVec2::new(area.min.x - TICK_GAP, p.y);
            sheet.text(beside, Align::Right, &tick.text, NOTE, Role::Note)?;
        }
        for (line, at, ink) in &self.titles {
            let centre = *at + DVec2::new(0.5 * line.width, 0.0);
            sheet.set_at(line.clone(), line.centred(centre), (*ink).into());
        }
        Ok(())
    }

    /// The names of the curves; `points` are those of each series.
    pub(super) fn draw_names(&self, sheet: &mut Sheet, points: &[Vec<DVec2>]) {
        self.names.draw(sheet, self.area, points);
    }
}

/// Where values above 0 lie, and of each series with zeros its lane in the band below them.
fn lanes(chart: &Chart, area: Rect, zeros: bool) -> (Rect, Vec<Option<f64>>) {
    let has_zeros = |points: &[(f64, f64)]| points.iter().any(|p| chart.y.is_zero(p.1));
    let mut lane = 0;
    let numbered: Vec<Option<u32>> = chart
        .series
        .iter()
        .map(|series| {
            has_zeros(&series.points).then(|| {
                lane += 1;
                lane - 1
            })
        })
        .collect();
    if !zeros {
        return (area, vec![None; chart.series.len()]);
    }
    let height = BAND.max(LANE * f64::from(lane));
    let step = height / f64::from(lane.max(1));
    let scaled = Rect::new(area.min, area.max - DVec2::new(0.0, height + APART));
    let middle = |lane: u32| area.max.y - height + step * (f64::from(lane) + 0.5);
    (
        scaled,
        numbered.into_iter().map(|lane| lane.map(middle)).collect(),
    )
}

/// The width of the widest of some ticks' labels.
fn widest<'a>(mut ticks: impl Iterator<Item = &'a Tick>, size: f64) -> Result<f64, FigureError> {
    ticks.try_fold(0.0_f64, |most, tick| {
        Ok(most.max(Line::new(&tick.text, size)?.width))
    })
}
