//! Where the curves of a chart lie, and its axes around them.

use ombra_math::glam::DVec2;

use super::Chart;
use super::span::Span;
use crate::colour::Role;
use crate::drawing::{Pen, THIN};
use crate::error::FigureError;
use crate::path::{Path, Rect};
use crate::sheet::{Align, Sheet};
use crate::text::{LABEL, Line, NOTE};

impl Chart {
    /// Where curves lie: the frame without ticks, titles and the labels at the curves' ends.
    pub(super) fn area(&self, sheet: &Sheet, y: &Span) -> Result<Rect, FigureError> {
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

    pub(super) fn draw_axes(
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
        // Accents rise above the letters.
        let title = Line::new(&self.y.words(), LABEL)?;
        let half = (0.5 * (title.ascent + title.descent)).max(0.5 * LABEL);
        let above = sheet.frame().min + DVec2::new(0.0, half);
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
