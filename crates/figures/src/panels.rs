//! Steps: panels from left to right, each with its number and one short line below.

use ombra_math::glam::DVec2;

use crate::colour::Role;
use crate::drawing::{Pen, THIN};
use crate::error::FigureError;
use crate::path::{Path, Rect};
use crate::sheet::{Align, Sheet};
use crate::text::{LABEL, NOTE, wrapped};

/// Free space between two panels.
pub const GUTTER: f64 = 44.0;
/// Radius of the ring around a panel's number.
const RING: f64 = 21.0;
/// From the ring to the line beside it.
const SPACE: f64 = 14.0;
/// From a panel to its line, and from one line to the next.
const DROP: f64 = 30.0;
const LEADING: f64 = 1.3 * LABEL;

/// Divides the sheet's frame into one panel a line of `lines` (markup), sets number and line below each, and returns
/// where the panels may draw. All are equally large, at most `tallest` times as high as wide; the lines begin at one
/// height and are broken where they are too long.
///
/// # Errors
///
/// Those of the lines' markup.
pub fn panels(sheet: &mut Sheet, lines: &[&str], tallest: f64) -> Result<Vec<Rect>, FigureError> {
    let frame = sheet.frame();
    let count = lines.len().max(1) as f64;
    let width = (frame.size().x - GUTTER * (count - 1.0)) / count;
    let room = width - 2.0 * RING - SPACE;

    let mut most = 1;
    for line in lines {
        most = most.max(wrapped(line, LABEL, room)?.len());
    }
    let text = 2.0 * RING + LEADING * (most as f64 - 1.0);
    let height = (frame.size().y - text - DROP).min(tallest * width);
    let top = frame.centre().y - 0.5 * (height + DROP + text);
    let bottom = top + height;

    let mut panels = Vec::with_capacity(lines.len());
    for (i, line) in lines.iter().enumerate() {
        let left = frame.min.x + i as f64 * (width + GUTTER);
        let panel = Rect::new(DVec2::new(left, top), DVec2::new(left + width, bottom));
        // Ring and text together stand in the middle of the panel.
        let set = wrapped(line, LABEL, room)?;
        let widest = set.iter().map(|line| line.width).fold(0.0, f64::max);
        let start = panel.centre().x - 0.5 * (2.0 * RING + SPACE + widest);
        let ring = DVec2::new(start + RING, bottom + DROP + RING);
        sheet.stroke(Path::circle(ring, RING), Pen::new(Role::Text, THIN));
        sheet.text(ring, Align::Centre, &(i + 1).to_string(), NOTE, Role::Text)?;
        for (j, line) in set.into_iter().enumerate() {
            let start = ring + DVec2::new(RING + SPACE, LEADING * j as f64);
            sheet.set_line(line, start, Role::Text);
        }
        panels.push(panel);
    }
    // A thin line between neighbours keeps each to itself.
    for pair in panels.windows(2) {
        if let [a, b] = pair {
            let x = 0.5 * (a.max.x + b.min.x);
            let ends = [top, bottom + DROP + text].map(|y| DVec2::new(x, y));
            sheet.line(ends[0], ends[1], Pen::new(Role::Grid, THIN));
        }
    }
    Ok(panels)
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
