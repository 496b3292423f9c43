//! Stretches of t below each other, and what they have in common: clipping by a parameter.

use ombra_math::glam::DVec2;

use crate::colour::{Ink, Role};
use crate::drawing::{NORMAL, Pen, THIN};
use crate::error::FigureError;
use crate::number::exact;
use crate::path::{Path, Rect};
use crate::sheet::{Align, Sheet};
use crate::text::{LABEL, NOTE};

/// The part of all t that is shown.
const SHOWN: [f64; 2] = [-0.3, 1.45];
/// Half the height of a bar.
const HALF: f64 = 15.0;
/// Between a row's name and its bar.
const GAP: f64 = 24.0;

/// Where along the segment something holds.
#[derive(Clone, Debug)]
pub(super) struct Row {
    /// What holds, in markup.
    pub(super) name: String,
    /// From and to in t, infinite where it has no end; from is the greater where it holds nowhere.
    pub(super) holds: [f64; 2],
}

/// Everywhere.
pub(super) const ALWAYS: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];
/// Nowhere.
pub(super) const NEVER: [f64; 2] = [f64::INFINITY, f64::NEG_INFINITY];

/// Where start + t·slope is not negative.
pub(super) fn not_negative(start: f64, slope: f64) -> [f64; 2] {
    let t = -start / slope;
    match () {
        () if slope > 0.0 => [t, f64::INFINITY],
        () if slope < 0.0 => [f64::NEG_INFINITY, t],
        () if start >= 0.0 => ALWAYS,
        () => NEVER,
    }
}

/// The largest of all beginnings and the smallest of all ends.
pub(super) fn in_common(rows: &[Row]) -> [f64; 2] {
    rows.iter().fold(ALWAYS, |[from, to], row| {
        [from.max(row.holds[0]), to.min(row.holds[1])]
    })
}

/// A frame beside or above another, the first with this share of the longer side.
pub(super) fn divided(frame: Rect, share: f64) -> [Rect; 2] {
    let size = frame.size();
    let across = size.x >= 1.15 * size.y;
    let axis = if across { DVec2::X } else { DVec2::Y };
    let cut = frame.min + size * axis * share + size * (DVec2::ONE - axis);
    let gap = axis * 40.0;
    [
        Rect::new(frame.min, cut - gap),
        Rect::new(frame.min + size * axis * share + gap, frame.max),
    ]
}

/// Draws `rows` into `frame`, the i-th with step i + 1, and below them what they have in common, if anything is `left`.
///
/// # Errors
///
/// Those of the names' markup.
pub(super) fn draw(
    sheet: &mut Sheet,
    frame: Rect,
    rows: &[Row],
    all: &str,
    left: bool,
) -> Result<(), FigureError> {
    let mut aside = sheet.lay_out(all, LABEL)?.width;
    for row in rows {
        aside = aside.max(sheet.lay_out(&row.name, LABEL)?.width);
    }
    let start = frame.min.x + aside + GAP;
    let height = (frame.size().y - 1.5 * LABEL) / (rows.len() as f64 + 1.0);
    let level = |i: usize| frame.min.y + height * (i as f64 + 0.5);
    let along = |t: f64| {
        let share = (t.clamp(SHOWN[0], SHOWN[1]) - SHOWN[0]) / (SHOWN[1] - SHOWN[0]);
        start + (frame.max.x - start) * share
    };
    let bottom = frame.min.y + height * (rows.len() as f64 + 1.0);
    for (t, name) in [(0.0, "0"), (1.0, "1")] {
        let [from, to] = [frame.min.y, bottom].map(|y| DVec2::new(along(t), y));
        sheet.stroke_unmarked(Path::line(from, to), Pen::new(Role::Grid, THIN));
        let at = DVec2::new(along(t), bottom + 0.7 * LABEL);
        sheet.text(at, Align::Centre, name, NOTE, Role::Note)?;
    }
    let at = DVec2::new(along(0.5), bottom + 0.7 * LABEL);
    sheet.text(at, Align::Centre, "*t*", LABEL, Role::Note)?;

    let common = in_common(rows);
    for (i, row) in rows.iter().enumerate() {
        sheet.step(i + 1);
        let y = level(i);
        let name = DVec2::new(frame.min.x, y);
        sheet.text(name, Align::Left, &row.name, LABEL, Role::Text)?;
        let [from, to] = row.holds;
        if from > to {
            continue;
        }
        let bar = bar(along(from), along(to), y);
        sheet.fill(Path::polygon(&bar), Ink::of(Role::Receiver).alpha(0.2));
        let hatches = Path::hatching(&bar, 11.0);
        sheet.stroke_unmarked(hatches, Pen::new(Role::Receiver, THIN));
        for (t, align, out) in [(from, Align::Right, -1.0), (to, Align::Left, 1.0)] {
            if !(SHOWN[0] < t && t < SHOWN[1]) {
                continue;
            }
            let at = DVec2::new(along(t), y);
            let tick = DVec2::new(0.0, 1.5 * HALF);
            // The ends that decide are those of the whole.
            let decides = left && common.contains(&t);
            let ink = if decides { Role::Chosen } else { Role::Text };
            sheet.line(at - tick, at + tick, Pen::new(ink, NORMAL));
            let at = at + DVec2::new(14.0 * out, 0.0);
            // It stands beside the segment, too, and is left out where it would lie on a name or the border.
            let reach = at.x + out * sheet.lay_out(&exact(t), NOTE)?.width;
            if start - 0.7 * GAP < reach && reach < frame.max.x {
                sheet.text(at, align, &exact(t), NOTE, ink)?;
            }
        }
    }

    sheet.step(rows.len() + 1);
    let y = level(rows.len());
    let ink = if left { Role::Chosen } else { Role::Note };
    sheet.text(DVec2::new(frame.min.x, y), Align::Left, all, LABEL, ink)?;
    let [from, to] = common;
    if left {
        let area = bar(along(from), along(to), y);
        sheet.fill(Path::polygon(&area), Role::Chosen);
        for t in common.into_iter().filter(|t| t.is_finite()) {
            let down = [frame.min.y, y].map(|y| DVec2::new(along(t), y));
            sheet.stroke_unmarked(
                Path::line(down[0], down[1]),
                Pen::new(Role::Chosen, THIN).dashed(),
            );
        }
    }
    sheet.whole();
    Ok(())
}

fn bar(from: f64, to: f64, y: f64) -> [DVec2; 4] {
    [(from, -HALF), (to, -HALF), (to, HALF), (from, HALF)].map(|(x, up)| DVec2::new(x, y + up))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_is_not_negative_on_one_side_of_its_zero() {
        assert_eq!(not_negative(-3.0, 4.0), [0.75, f64::INFINITY]);
        assert_eq!(not_negative(3.0, -4.0), [f64::NEG_INFINITY, 0.75]);
        assert_eq!(not_negative(0.0, 0.0), ALWAYS);
        assert_eq!(not_negative(-1.0, 0.0), NEVER);
        let row = |holds| Row {
            name: String::new(),
            holds,
        };
        let rows = [
            [0.0, 1.0],
            [0.25, f64::INFINITY],
            ALWAYS,
            [f64::NEG_INFINITY, 0.5],
        ];
        assert_eq!(in_common(&rows.map(row)), [0.25, 0.5]);
    }
}
