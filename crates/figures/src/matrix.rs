//! Matrices and column vectors between brackets.

use ombra_math::glam::DVec2;

use crate::colour::Ink;
use crate::drawing::{NORMAL, Pen};
use crate::error::FigureError;
use crate::path::Path;
use crate::sheet::Sheet;
use crate::text::{LABEL, Line};

/// Between two columns, and between a bracket and what it holds.
const GAP: f64 = 34.0;
const INSIDE: f64 = 14.0;
/// Between the lowest letters of a row and the highest of the next.
const LEADING: f64 = 14.0;
/// Length of a bracket's hooks.
const HOOK: f64 = 12.0;

/// Rows of markup, each column centred.
#[derive(Clone, Debug)]
pub struct Matrix {
    rows: Vec<Vec<Line>>,
    widths: Vec<f64>,
    /// Above and below a row's baseline.
    ascent: f64,
    descent: f64,
}

impl Matrix {
    /// Lays out `rows` for `sheet`.
    ///
    /// # Errors
    ///
    /// Those of the markup.
    pub fn new<const N: usize>(sheet: &Sheet, rows: &[[String; N]]) -> Result<Matrix, FigureError> {
        let line = |entry: &String| sheet.lay_out(entry, LABEL);
        let rows: Vec<Vec<Line>> = rows
            .iter()
            .map(|row| row.iter().map(line).collect())
            .collect::<Result<_, _>>()?;
        let widest = |column: usize| {
            let entries = rows.iter().filter_map(|row| row.get(column));
            entries.map(|line| line.width).fold(0.0, f64::max)
        };
        let all = || rows.iter().flatten();
        Ok(Matrix {
            widths: (0..N).map(widest).collect(),
            ascent: all().map(|line| line.ascent).fold(0.0, f64::max),
            descent: all().map(|line| line.descent).fold(0.0, f64::max),
            rows,
        })
    }

    /// Width and height, brackets included.
    pub fn size(&self) -> DVec2 {
        let gaps = GAP * self.widths.len().saturating_sub(1) as f64;
        let width = self.widths.iter().sum::<f64>() + gaps + 2.0 * INSIDE;
        let rows = self.rows.len() as f64;
        let height = rows * (self.ascent + self.descent + LEADING) - LEADING;
        DVec2::new(width, height.max(0.0) + INSIDE)
    }

    /// Draws it, its upper left corner at `corner`.
    pub fn draw(self, sheet: &mut Sheet, corner: DVec2, ink: impl Into<Ink>) {
        let (size, ink) = (self.size(), ink.into());
        for (x, inwards) in [(corner.x, HOOK), (corner.x + size.x, -HOOK)] {
            let (top, bottom) = (corner.y, corner.y + size.y);
            let bracket = [
                DVec2::new(x + inwards, top),
                DVec2::new(x, top),
                DVec2::new(x, bottom),
                DVec2::new(x + inwards, bottom),
            ];
            sheet.stroke(Path::polyline(&bracket), Pen::new(ink, NORMAL));
        }
        let mut baseline = corner.y + 0.5 * INSIDE + self.ascent;
        for row in self.rows {
            let mut left = corner.x + INSIDE;
            for (line, width) in row.into_iter().zip(&self.widths) {
                let at = DVec2::new(left + 0.5 * (width - line.width), baseline);
                sheet.set_at(line, at, ink);
                left += width + GAP;
            }
            baseline += self.ascent + self.descent + LEADING;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::colour::Role;
    use crate::style::Style;

    #[test]
    fn entries_stand_in_rows_and_columns_within_its_size() {
        let mut sheet = Sheet::new(&Style::default(), "").unwrap();
        let rows =
            [["1", "−{300|7}"], ["100", "0"], ["*x*", "2"]].map(|row| row.map(str::to_owned));
        let matrix = Matrix::new(&sheet, &rows).unwrap();
        let (corner, size) = (sheet.frame().min, matrix.size());
        matrix.draw(&mut sheet, corner, Role::Text);
        let labels = sheet.finish("a/b", "").unwrap().labels;
        assert_eq!(labels.len(), 6);
        for (i, label) in labels.iter().enumerate() {
            assert!(label.bounds.min.cmpge(corner).all());
            assert!(label.bounds.max.cmple(corner + size + 0.01).all());
            for (j, other) in labels[..i].iter().enumerate() {
                assert!(!label.bounds.meets(&other.bounds));
                if i % 2 == j % 2 {
                    let aside = label.bounds.centre().x - other.bounds.centre().x;
                    assert!(aside.abs() < 0.02);
                }
            }
        }
    }
}
