//! Steps: panels side by side or in rows, each with its number and one short line below.

use ombra_math::glam::DVec2;

use crate::colour::Role;
use crate::drawing::{Pen, THIN};
use crate::error::FigureError;
use crate::path::{Path, Rect};
use crate::sheet::{Align, Sheet};
use crate::text::{LABEL, NOTE};

/// Free space between two panels.
pub const GUTTER: f64 = 44.0;
/// Radius of the ring around a panel's number.
const RING: f64 = 30.0;
/// From the ring to the line beside it.
const SPACE: f64 = 14.0;
/// From a panel to its line, and from one line to the next.
const DROP: f64 = 30.0;
const LEADING: f64 = 1.3 * LABEL;
/// Another arrangement must make the panels larger by this.
const WORTH: f64 = 1.05;

/// How panels are arranged.
#[derive(Clone, Copy)]
struct Arrangement {
    columns: usize,
    /// A panel's width and height.
    size: DVec2,
    /// Height of the lines below a panel.
    text: f64,
}

/// Divides the sheet's frame into one panel a line of `lines` (markup), sets number and line below each, and returns
/// where the panels may draw. All are equally large, at most `tallest` times as high as wide, side by side or in several
/// rows, whichever leaves them larger; the lines begin at one height and are broken where they are too long.
///
/// Each panel's number and line come with its step, the first with step 1; what is drawn into it should, too
/// ([`Sheet::panel`]).
///
/// # Errors
///
/// Those of the lines' markup.
pub fn panels(sheet: &mut Sheet, lines: &[&str], tallest: f64) -> Result<Vec<Rect>, FigureError> {
    let frame = sheet.frame();
    let mut best = arranged(sheet, lines, tallest, lines.len().max(1))?;
    for columns in 1..lines.len() {
        let other = arranged(sheet, lines, tallest, columns)?;
        let side = |a: &Arrangement| a.size.x.min(a.size.y / tallest);
        if side(&other) > side(&best) * WORTH {
            best = other;
        }
    }
    let Arrangement {
        columns,
        size,
        text,
    } = best;
    let rows = lines.len().div_ceil(columns);
    let row = size.y + DROP + text;
    let whole = DVec2::new(
        columns as f64 * (size.x + GUTTER) - GUTTER,
        rows as f64 * (row + GUTTER) - GUTTER,
    );
    let corner = frame.centre() - 0.5 * whole;

    let mut panels = Vec::with_capacity(lines.len());
    for (i, line) in lines.iter().enumerate() {
        sheet.step(i + 1);
        let (x, y) = ((i % columns) as f64, (i / columns) as f64);
        let min = corner + DVec2::new(x * (size.x + GUTTER), y * (row + GUTTER));
        let panel = Rect::new(min, min + size);
        // Ring and text together stand in the middle of the panel.
        let set = sheet.wrapped(line, LABEL, size.x - 2.0 * RING - SPACE)?;
        let widest = set.iter().map(|line| line.width).fold(0.0, f64::max);
        let start = panel.centre().x - 0.5 * (2.0 * RING + SPACE + widest);
        let ring = DVec2::new(start + RING, panel.max.y + DROP + RING);
        sheet.stroke(Path::circle(ring, RING), Pen::new(Role::Text, THIN));
        sheet.text(ring, Align::Centre, &(i + 1).to_string(), NOTE, Role::Text)?;
        for (j, line) in set.into_iter().enumerate() {
            let start = ring + DVec2::new(RING + SPACE, LEADING * j as f64);
            sheet.set_line(line, start, Role::Text);
        }
        panels.push(panel);
    }
    // Thin lines between neighbours keep each to itself.
    sheet.step(0);
    for column in 1..columns {
        let x = corner.x + column as f64 * (size.x + GUTTER) - 0.5 * GUTTER;
        let ends = [corner.y, corner.y + whole.y].map(|y| DVec2::new(x, y));
        sheet.line(ends[0], ends[1], Pen::new(Role::Grid, THIN));
    }
    for below in 1..rows {
        let y = corner.y + below as f64 * (row + GUTTER) - 0.5 * GUTTER;
        let ends = [corner.x, corner.x + whole.x].map(|x| DVec2::new(x, y));
        sheet.line(ends[0], ends[1], Pen::new(Role::Grid, THIN));
    }
    Ok(panels)
}

/// The panels' size with so many beside each other.
fn arranged(
    sheet: &Sheet,
    lines: &[&str],
    tallest: f64,
    columns: usize,
) -> Result<Arrangement, FigureError> {
    let frame = sheet.frame().size();
    let rows = lines.len().div_ceil(columns).max(1) as f64;
    let across = columns as f64;
    let width = (frame.x - GUTTER * (across - 1.0)) / across;
    let mut most = 1;
    for line in lines {
        let set = sheet.wrapped(line, LABEL, width - 2.0 * RING - SPACE)?;
        most = most.max(set.len());
    }
    let text = 2.0 * RING + LEADING * (most as f64 - 1.0);
    let height = (frame.y - GUTTER * (rows - 1.0)) / rows - text - DROP;
    Ok(Arrangement {
        columns,
        size: DVec2::new(width, height.min(tallest * width)),
        text,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::style::Style;

    #[test]
    fn panels_are_alike_side_by_side_and_inside() {
        let mut sheet = Sheet::new(&Style::default(), "").unwrap();
        let frame = sheet.frame();
        let long = "a line so long that it must be broken to stay below its own panel";
        let panels = panels(&mut sheet, &["short", long, "*t* > 1"], 2.0).unwrap();
        assert_eq!(panels.len(), 3);
        for pair in panels.windows(2) {
            assert!((pair[0].size() - pair[1].size()).length() < 1e-9);
            assert!((pair[1].min.x - pair[0].max.x - GUTTER).abs() < 1e-9);
        }
        assert!(panels.iter().all(|panel| frame.grown(1e-9).contains(panel)));
        let drawing = sheet.finish("a/b", "").unwrap();
        for label in &drawing.labels {
            assert!(frame.contains(&label.bounds), "{}", label.text);
            assert!(label.bounds.min.y > panels[0].max.y, "{}", label.text);
            let below = panels.iter().any(|panel| {
                panel.min.x <= label.bounds.min.x && label.bounds.max.x <= panel.max.x
            });
            assert!(below, "{}", label.text);
        }
    }

    #[test]
    fn low_panels_stand_in_the_middle() {
        let mut sheet = Sheet::new(&Style::default(), "").unwrap();
        let panel = panels(&mut sheet, &["a", "b"], 0.5).unwrap()[0];
        assert!((panel.size().y - 0.5 * panel.size().x).abs() < 1e-9);
        assert!(panel.min.y > sheet.frame().min.y + 100.0);
    }
}
