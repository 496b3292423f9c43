//! A short list of labels in columns, for what would crowd the things it names.

use ombra_math::glam::DVec2;

use crate::colour::Role;
use crate::error::FigureError;
use crate::sheet::Sheet;
use crate::text::{LABEL, Line};

/// From one column to the next.
const GUTTER: f64 = 54.0;
/// Between the highest letters of a row and the lowest of the one above.
const LEADING: f64 = 16.0;

/// Lines of the usual size, filled column by column.
#[derive(Clone, Debug)]
pub struct Table {
    lines: Vec<Line>,
    /// Rows a column.
    rows: usize,
    widths: Vec<f64>,
    ascent: f64,
    height: f64,
}

impl Table {
    /// Sets `lines` (markup) in as many columns as `width` allows, at least one.
    ///
    /// # Errors
    ///
    /// Those of the markup.
    pub fn new(sheet: &Sheet, lines: &[String], width: f64) -> Result<Table, FigureError> {
        let lines: Vec<Line> = lines
            .iter()
            .map(|line| sheet.lay_out(line, LABEL))
            .collect::<Result<_, _>>()?;
        let largest = |of: fn(&Line) -> f64| lines.iter().map(of).fold(0.0, f64::max);
        let (widest, ascent) = (largest(|line| line.width), largest(|line| line.ascent));
        let height = ascent + largest(|line| line.descent) + LEADING;
        let most = ((width + GUTTER) / (widest + GUTTER)).clamp(1.0, 16.0) as usize;
        let rows = lines.len().div_ceil(most).max(1);
        let widths = lines
            .chunks(rows)
            .map(|column| column.iter().map(|line| line.width).fold(0.0, f64::max))
            .collect();
        Ok(Table {
            lines,
            rows,
            widths,
            ascent,
            height,
        })
    }

    /// Width and height.
    pub fn size(&self) -> DVec2 {
        let gutters = GUTTER * self.widths.len().saturating_sub(1) as f64;
        DVec2::new(
            self.widths.iter().sum::<f64>() + gutters,
            self.height * self.rows as f64 - LEADING,
        )
    }

    /// Draws it, its upper left corner at `corner`.
    pub fn draw(self, sheet: &mut Sheet, corner: DVec2) {
        let mut left = corner.x;
        let mut lines = self.lines.into_iter();
        for width in self.widths {
            for (row, line) in lines.by_ref().take(self.rows).enumerate() {
                let baseline = corner.y + self.ascent + self.height * row as f64;
                sheet.set_at(line, DVec2::new(left, baseline), Role::Text.into());
            }
            left += width + GUTTER;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::style::Style;

    fn lines(n: usize) -> Vec<String> {
        (1..=n)
            .map(|i| format!("*P*_{{{i}}} (0, {{{i}|7}})"))
            .collect()
    }

    #[test]
    fn it_is_as_large_as_it_says_and_no_two_lines_meet() {
        for (n, width) in [(1, 0.0), (8, 0.0), (8, 600.0), (7, 1600.0), (16, 900.0)] {
            let mut sheet = Sheet::new(&Style::default(), "").unwrap();
            let table = Table::new(&sheet, &lines(n), width).unwrap();
            let size = table.size();
            let corner = sheet.frame().min;
            table.draw(&mut sheet, corner);
            let labels = sheet.finish("a/b", "").unwrap().labels;
            assert_eq!(labels.len(), n);
            for (i, label) in labels.iter().enumerate() {
                assert!(label.bounds.min.cmpge(corner - 0.01).all());
                assert!(
                    label.bounds.max.cmple(corner + size + 0.01).all(),
                    "{n} {width}"
                );
                assert!(
                    labels[..i]
                        .iter()
                        .all(|other| !other.bounds.meets(&label.bounds))
                );
            }
            assert!(width == 0.0 || size.x <= width);
        }
    }

    #[test]
    fn nothing_is_a_table_too() {
        let sheet = Sheet::new(&Style::default(), "").unwrap();
        assert!(Table::new(&sheet, &[], 500.0).unwrap().size().is_finite());
    }
}
