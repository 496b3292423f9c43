//! Pixels: cells with their centre points, those that are on filled, numbers along the border.

use ombra_math::glam::{DVec2, IVec2};

use crate::colour::{Ink, Role};
use crate::drawing::{Pen, THIN};
use crate::error::FigureError;
use crate::path::{Path, Rect};
use crate::sheet::{Align, Centres, Sheet};
use crate::text::NOTE;

/// What the numbers of columns take up below the cells.
pub const NUMBERS: f64 = 1.7 * NOTE;
/// What the numbers of rows, of two digits, take up beside them.
pub const BESIDE: f64 = 2.2 * NOTE;
/// Share of its colour in a pixel that is on: the ideal line and letters stay readable above it.
const ON: f64 = 0.5;
/// Cells smaller than this have no centre points.
const SMALL: f64 = 18.0;

/// Which way y points, and where whole coordinates lie.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Orientation {
    /// y up, (x, y) the centre of pixel (x, y): segments.
    Mathematical,
    /// y down, (x, y) the upper left corner of pixel (x, y), (x + ½, y + ½) its centre: triangles.
    Picture,
    /// y up, (x, y) the lower left corner of pixel (x, y), (x + ½, y + ½) its centre: polygons.
    Raised,
}

/// A rectangle of pixels on the canvas.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grid {
    min: IVec2,
    max: IVec2,
    orientation: Orientation,
    cell: f64,
    /// Its upper left corner on the canvas.
    corner: DVec2,
}

impl Grid {
    /// The pixels from `min` to `max`, both included, as large as they fit into `frame`, in its middle.
    pub fn fit(min: IVec2, max: IVec2, orientation: Orientation, frame: Rect) -> Grid {
        let count = (max - min + 1).max(IVec2::ONE).as_dvec2();
        let ratio = frame.size() / count;
        let cell = ratio.x.min(ratio.y).max(0.0);
        Grid {
            min,
            max,
            orientation,
            cell,
            corner: frame.centre() - 0.5 * cell * count,
        }
    }

    /// Width and height of a pixel.
    pub fn cell(&self) -> f64 {
        self.cell
    }

    /// Where a point of the plane appears.
    pub fn at(&self, p: DVec2) -> DVec2 {
        // In cells from the upper left corner.
        let p = match self.orientation {
            Orientation::Mathematical => DVec2::new(
                p.x - f64::from(self.min.x) + 0.5,
                f64::from(self.max.y) + 0.5 - p.y,
            ),
            Orientation::Picture => p - self.min.as_dvec2(),
            Orientation::Raised => DVec2::new(
                p.x - f64::from(self.min.x),
                f64::from(self.max.y) + 1.0 - p.y,
            ),
        };
        self.corner + self.cell * p
    }

    /// Where a pixel's centre appears.
    pub fn centre(&self, pixel: IVec2) -> DVec2 {
        self.at(match self.orientation {
            Orientation::Mathematical => pixel.as_dvec2(),
            Orientation::Picture | Orientation::Raised => pixel.as_dvec2() + 0.5,
        })
    }

    /// A polygon of the plane on the canvas.
    pub fn contour(&self, polygon: &[DVec2]) -> Vec<DVec2> {
        polygon.iter().map(|&p| self.at(p)).collect()
    }

    /// What the cells cover of the canvas.
    pub fn bounds(&self) -> Rect {
        let count = (self.max - self.min + 1).max(IVec2::ONE).as_dvec2();
        Rect::new(self.corner, self.corner + self.cell * count)
    }

    /// The cells and their centres; of `on`, each set of pixels filled in its ink.
    pub fn draw(&self, sheet: &mut Sheet, on: &[(Ink, &[IVec2])]) {
        self.draw_cells(sheet);
        for &(ink, pixels) in on {
            self.fill(sheet, pixels, ink);
        }
        self.draw_centres(sheet);
    }

    /// The borders of all cells.
    pub fn draw_cells(&self, sheet: &mut Sheet) {
        let Rect { min, max } = self.bounds();
        let mut lines = Path::new();
        for x in 0..=self.max.x.abs_diff(self.min.x).saturating_add(1) {
            let x = min.x + self.cell * f64::from(x);
            lines.add_polyline(&[DVec2::new(x, min.y), DVec2::new(x, max.y)]);
        }
        for y in 0..=self.max.y.abs_diff(self.min.y).saturating_add(1) {
            let y = min.y + self.cell * f64::from(y);
            lines.add_polyline(&[DVec2::new(min.x, y), DVec2::new(max.x, y)]);
        }
        sheet.stroke(lines, Pen::new(Role::Grid, THIN));
    }

    /// Pixels that are on.
    pub fn fill(&self, sheet: &mut Sheet, pixels: &[IVec2], ink: Ink) {
        let cells = self.cells(pixels);
        sheet.fill_unmarked(cells, ink.tint(ON * ink.share), Pen::new(ink, THIN));
    }

    /// The squares of `pixels`.
    pub fn cells(&self, pixels: &[IVec2]) -> Path {
        let mut cells = Path::new();
        for &pixel in pixels {
            let (centre, half) = (self.centre(pixel), 0.5 * self.cell);
            let corner = |x, y| centre + half * DVec2::new(x, y);
            cells.add_polygon(&[
                corner(-1.0, -1.0),
                corner(1.0, -1.0),
                corner(1.0, 1.0),
                corner(-1.0, 1.0),
            ]);
        }
        cells
    }

    /// The centre points of all cells but those below labels.
    pub fn draw_centres(&self, sheet: &mut Sheet) {
        if self.cell < SMALL {
            return;
        }
        let pixels = (self.max - self.min + 1).max(IVec2::ZERO);
        sheet.centres(Centres {
            first: self.corner + 0.5 * self.cell,
            step: self.cell,
            count: pixels.as_uvec2(),
            width: (0.09 * self.cell).clamp(4.0, 8.0),
        });
    }

    /// A cross through each of `pixels`: what should be otherwise.
    pub fn cross(&self, sheet: &mut Sheet, pixels: &[IVec2], pen: Pen) {
        let mut crosses = Path::new();
        for &pixel in pixels {
            let (centre, half) = (self.centre(pixel), 0.3 * self.cell);
            for across in [DVec2::ONE, DVec2::new(1.0, -1.0)] {
                crosses.add_polyline(&[centre - half * across, centre + half * across]);
            }
        }
        sheet.stroke_unmarked(crosses, pen);
    }

    /// Slanted lines across each of `pixels`: a fill that a grey print tells from another.
    pub fn hatch(&self, sheet: &mut Sheet, pixels: &[IVec2], pen: Pen) {
        for &pixel in pixels {
            let (centre, half) = (self.centre(pixel), 0.5 * self.cell);
            let square = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
            let square = square.map(|(x, y)| centre + half * DVec2::new(x, y));
            sheet.stroke_unmarked(Path::hatching(&square, 0.25 * self.cell), pen.clone());
        }
    }

    /// From one number of a border to the next: every cell, or fewer where they would touch.
    fn every(&self) -> i32 {
        [1, 2, 5]
            .into_iter()
            .find(|&n| self.cell * f64::from(n) >= 1.3 * NOTE)
            .unwrap_or(10)
    }

    /// The numbers of the columns, below.
    ///
    /// # Errors
    ///
    /// None that the digits of an integer could give.
    pub fn number_columns(&self, sheet: &mut Sheet) -> Result<(), FigureError> {
        let y = self.bounds().max.y + 0.4 * NOTE;
        let every = self.every();
        for x in (self.min.x..=self.max.x).filter(|x| x % every == 0) {
            let at = DVec2::new(self.centre(IVec2::new(x, self.min.y)).x, y);
            sheet.text(at, Align::Below, &x.to_string(), NOTE, Role::Note)?;
        }
        Ok(())
    }

    /// The numbers of the rows, on the left.
    ///
    /// # Errors
    ///
    /// As [`Grid::number_columns`].
    pub fn number_rows(&self, sheet: &mut Sheet) -> Result<(), FigureError> {
        let x = self.bounds().min.x - 0.6 * NOTE;
        let every = self.every();
        for y in (self.min.y..=self.max.y).filter(|y| y % every == 0) {
            let at = DVec2::new(x, self.centre(IVec2::new(self.min.x, y)).y);
            sheet.text(at, Align::Right, &y.to_string(), NOTE, Role::Note)?;
        }
        Ok(())
    }

    /// The ideal line, above the pixels that stand for it.
    pub fn line(&self, sheet: &mut Sheet, a: DVec2, b: DVec2) {
        sheet.line(self.at(a), self.at(b), ideal());
    }

    /// The ideal polygon, above the pixels that stand for it.
    pub fn polygon(&self, sheet: &mut Sheet, polygon: &[DVec2]) {
        sheet.stroke(Path::polygon(&self.contour(polygon)), ideal());
    }
}

/// How the ideal is drawn.
fn ideal() -> Pen {
    Pen::new(Role::Text, THIN)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drawing::Item;
    use crate::style::Style;

    const FRAME: Rect = Rect::new(DVec2::new(40.0, 40.0), DVec2::new(1040.0, 840.0));

    #[test]
    fn pixels_fill_the_frame_and_lie_where_their_coordinates_say() {
        let (min, max) = (IVec2::new(-1, 2), IVec2::new(8, 5));
        // 10 × 4 pixels in 1000 × 800: 100 each, 200 free above and below.
        let up = Grid::fit(min, max, Orientation::Mathematical, FRAME);
        assert_eq!(up.cell(), 100.0);
        assert_eq!(
            up.bounds(),
            Rect::new(DVec2::new(40.0, 240.0), DVec2::new(1040.0, 640.0))
        );
        assert_eq!(up.centre(min), DVec2::new(90.0, 590.0));
        assert_eq!(up.at(min.as_dvec2()), up.centre(min));
        let down = Grid::fit(min, max, Orientation::Picture, FRAME);
        assert_eq!(down.centre(min), DVec2::new(90.0, 290.0));
        assert_eq!(down.at(min.as_dvec2()), DVec2::new(40.0, 240.0));
        assert_eq!(down.at(min.as_dvec2() + 0.5), down.centre(min));
        // The lowest row is the first; its corner is the lower left one.
        let raised = Grid::fit(min, max, Orientation::Raised, FRAME);
        assert_eq!(raised.centre(min), DVec2::new(90.0, 590.0));
        assert_eq!(raised.at(min.as_dvec2()), DVec2::new(40.0, 640.0));
        assert_eq!(raised.at(min.as_dvec2() + 0.5), raised.centre(min));
    }

    #[test]
    fn a_pixel_that_is_on_is_the_square_around_its_centre() {
        let grid = Grid::fit(IVec2::ZERO, IVec2::new(9, 7), Orientation::Picture, FRAME);
        let pixel = IVec2::new(3, 4);
        let cell = grid.cells(&[pixel]).bounds().unwrap();
        assert_eq!(
            (cell.centre(), cell.size()),
            (grid.centre(pixel), DVec2::splat(100.0))
        );
        assert_eq!(cell.min, grid.at(pixel.as_dvec2()));
    }

    /// One dot a cell: the dash starts at the first centre and the line ends before the next dash would.
    #[test]
    fn every_cell_has_its_centre_point() {
        let grid = Grid::fit(IVec2::ZERO, IVec2::new(6, 2), Orientation::Picture, FRAME);
        let mut sheet = Sheet::new(&Style::default(), "").unwrap();
        grid.draw_centres(&mut sheet);
        let drawing = sheet.finish("a/b", "").unwrap();
        let Item::Shape {
            path,
            stroke: Some(pen),
            ..
        } = &drawing.items[0]
        else {
            panic!("{:?}", drawing.items);
        };
        let (dash, gap) = pen.dash.unwrap();
        let rows = path.chords();
        assert_eq!(rows.len(), 3);
        for (row, (from, to)) in (0..).zip(rows) {
            assert!((from - grid.centre(IVec2::new(0, row))).length() < 0.01);
            let dots = ((to - from).x / (dash + gap)).floor() as i32 + 1;
            assert_eq!(dots, 7);
            // Roundings of the gap add up along the row.
            let last = from + DVec2::new(6.0 * (dash + gap), 0.0);
            assert!((last - grid.centre(IVec2::new(6, row))).length() < 0.1);
        }
    }

    #[test]
    fn a_grid_without_room_or_pixels_is_no_trouble() {
        for (max, frame) in [
            (IVec2::new(-5, -5), FRAME),
            (
                IVec2::new(3, 3),
                Rect::new(DVec2::splat(9.0), DVec2::splat(1.0)),
            ),
        ] {
            let grid = Grid::fit(IVec2::ZERO, max, Orientation::Mathematical, frame);
            let mut sheet = Sheet::new(&Style::default(), "").unwrap();
            grid.draw(&mut sheet, &[(Role::Chosen.into(), &[IVec2::ZERO])]);
            assert!(sheet.finish("a/b", "").is_ok());
        }
    }
}
