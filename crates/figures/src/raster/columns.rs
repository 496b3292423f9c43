//! What the figures of rasterization share: one segment, and its pixels in columns or rows beside a table.

use ombra_math::glam::{DVec2, IVec2};
use ombra_raster::bresenham::{Step, trace};
use ombra_raster::span::Span;

use crate::colour::Role;
use crate::drawing::{Pen, THIN};
use crate::error::FigureError;
use crate::figure::About;
use crate::input::{Ask, Inputs};
use crate::pixels::{BESIDE, Grid, NUMBERS, Orientation};
use crate::sheet::{Align, Sheet};
use crate::style::Language;
use crate::text::{LABEL, NOTE};
use crate::words::{Word, words};

words! {
    /// An input.
    pub(super) FIRST_END {
        en: "the first pixel of the segment",
        it: "il primo pixel del segmento",
        cs: "první pixel úsečky",
        hr: "prvi piksel dužine",
    }

    /// An input.
    pub(super) LAST_END {
        en: "the last pixel of the segment",
        it: "l’ultimo pixel del segmento",
        cs: "poslední pixel úsečky",
        hr: "zadnji piksel dužine",
    }

    /// An input.
    AT_WORD {
        en: "the move that is shown first, counted from 0",
        it: "il passo mostrato per primo, contando da 0",
        cs: "krok, který je ukázán první, počítáno od 0",
        hr: "korak koji se prvi prikazuje, brojeći od 0",
    }

    /// A caption.
    pub(super) SINGLE {
        en: "The two ends are one pixel: there is nothing to decide.",
        it: "I due estremi sono lo stesso pixel: non c’è nulla da decidere.",
        cs: "Oba konce jsou týž pixel: není co rozhodovat.",
        hr: "Oba su kraja isti piksel: nema se što odlučivati.",
    }

    /// A sentence for captions.
    OCTANT {
        en: "E is a move along the longer axis, NE one along both.",
        it: "E è un passo lungo l’asse maggiore, NE lungo entrambi.",
        cs: "E je krok podél delší osy, NE podél obou.",
        hr: "E je korak uzduž dulje osi, NE uzduž obiju.",
    }

    /// One pixel.
    ONE_PIXEL {
        en: "pixel",
        it: "pixel",
        cs: "pixel",
        hr: "piksel",
    }

    /// Two, three or four pixels.
    FEW_PIXELS {
        en: "pixels",
        it: "pixel",
        cs: "pixely",
        hr: "piksela",
    }

    /// Five pixels or more, or none.
    MANY_PIXELS {
        en: "pixels",
        it: "pixel",
        cs: "pixelů",
        hr: "piksela",
    }
}

/// Pixels after their number, on one line with it.
pub(super) fn counted(count: usize, language: Language) -> String {
    // Croatian counts by the last digit, but for those from eleven to nineteen.
    let last = match language {
        Language::Hr if count % 100 / 10 != 1 => count % 10,
        _ => count,
    };
    let word = match last {
        1 => ONE_PIXEL,
        2..=4 => FEW_PIXELS,
        _ => MANY_PIXELS,
    };
    format!("{count}\u{a0}{}", word.text(language))
}

/// `%1`, `%2` … of a word, filled in.
pub(super) fn filled(word: Word, language: Language, values: &[&str]) -> String {
    let mut text = word.text(language).to_owned();
    for (i, value) in values.iter().enumerate() {
        text = text.replace(&format!("%{}", i + 1), value);
    }
    text
}

/// A fraction on one line instead of two.
pub(super) fn inline(number: &str) -> String {
    number.replace(['{', '}'], "").replace('|', "/")
}

/// Where the ends of segments may lie.
const RANGE: [[i32; 2]; 2] = [[0, 0], [12, 12]];
/// The segment of all figures, as in Grafica 3, «Algoritmo di Bresenham».
pub(super) const A: Ask<IVec2> = Ask::pixel("a", "*A*", FIRST_END, [0, 0], RANGE);
/// Its other end.
pub(super) const B: Ask<IVec2> = Ask::pixel("b", "*B*", LAST_END, [8, 3], RANGE);
/// A move of it.
pub(super) const AT: Ask<i32> = Ask::whole("at", "*i*", AT_WORD, 2, [0, 11]);

/// Both ends of a segment.
#[derive(Clone, Copy)]
pub(super) struct Ends {
    pub(super) a: IVec2,
    pub(super) b: IVec2,
}

impl Ends {
    /// Those asked for.
    pub(super) fn of(inputs: &Inputs) -> Ends {
        let (a, b) = (inputs.get(&A), inputs.get(&B));
        Ends { a, b }
    }

    /// Whether y is the longer axis.
    pub(super) fn is_steep(self) -> bool {
        let extent = (self.b - self.a).abs();
        extent.y > extent.x
    }

    /// dx and dy of the slide's octant: along the longer axis and along the other.
    pub(super) fn extent(self) -> [i32; 2] {
        let extent = (self.b - self.a).abs();
        [extent.max_element(), extent.min_element()]
    }

    /// A move E, and what NE adds to it.
    pub(super) fn moves(self) -> [IVec2; 2] {
        let towards = |length: i32| if length < 0 { -1 } else { 1 };
        let d = self.b - self.a;
        let (x, y) = (IVec2::X * towards(d.x), IVec2::Y * towards(d.y));
        if self.is_steep() { [y, x] } else { [x, y] }
    }

    /// The point of the line that lies `along` from `a` along the longer axis.
    pub(super) fn on_line(self, along: f64) -> DVec2 {
        let [longer, shorter] = self.extent().map(f64::from);
        let m = if longer > 0.0 { shorter / longer } else { 0.0 };
        let [east, north] = self.moves().map(|step| step.as_dvec2());
        self.a.as_dvec2() + along * east + along * m * north
    }

    /// The line from `from` to `to` along the longer axis, as far as `grid` shows it.
    pub(super) fn draw_line(self, sheet: &mut Sheet, grid: &Grid, [from, to]: [f64; 2]) {
        let [from, to] = [from, to].map(|along| grid.at(self.on_line(along)));
        if let Some((from, to)) = grid.bounds().cut(from, to) {
            sheet.line(from, to, Pen::new(Role::Text, THIN));
        }
    }

    /// The move asked for, and the first of the other kind after it, or else before it.
    ///
    /// # Errors
    ///
    /// [`FigureError::Scene`] where the segment has no such move.
    pub(super) fn two_moves(self, at: i32) -> Result<Vec<(i32, Step)>, FigureError> {
        let moves: Vec<(i32, Step)> = (0..).zip(trace(self.a, self.b)).collect();
        let Ends { a, b } = self;
        let Some(first) = moves.iter().find(|(i, _)| *i == at).copied() else {
            let reason = match moves.len() {
                0 => format!(
                    "there is no move to decide: both ends of the segment are the pixel ({}, {})",
                    a.x, a.y
                ),
                count => format!(
                    "there is no move {at}: the segment from ({}, {}) to ({}, {}) has {count}, counted from 0",
                    a.x, a.y, b.x, b.y
                ),
            };
            return Err(FigureError::Scene { reason });
        };
        let (before, after) = moves.split_at(at.max(0) as usize);
        let other = |(_, step): &&(i32, Step)| step.choice != first.1.choice;
        let second = after.iter().find(other).or(before.iter().rev().find(other));
        Ok([Some(first), second.copied()]
            .into_iter()
            .flatten()
            .collect())
    }

    /// The pixels shown: all between the ends, and no fewer than two across.
    pub(super) fn shown(self) -> [IVec2; 2] {
        let (min, max) = (self.a.min(self.b), self.a.max(self.b));
        [min, max.max(min + IVec2::ONE)]
    }

    /// The caption; another where there is nothing to decide, and a word on other octants.
    pub(super) fn about(self, about: About, language: Language) -> About {
        let d = self.b - self.a;
        if d == IVec2::ZERO {
            let caption = SINGLE.text(language).to_owned();
            return About { caption, ..about };
        }
        let slides = 0 <= d.y && d.y <= d.x;
        about.and((!slides).then(|| OCTANT.text(language)))
    }
}

/// The pixels of spans.
pub(super) fn pixels(spans: impl IntoIterator<Item = Span>) -> Vec<IVec2> {
    let pixels = spans.into_iter().flat_map(|span| span.pixels());
    pixels.map(|pixel| pixel.as_ivec2()).collect()
}

/// A row of the table below columns of pixels; beside rows of pixels, a column.
pub(super) struct Row {
    pub(super) heading: String,
    pub(super) role: Role,
    pub(super) cells: Vec<Cell>,
}

/// What a table says of a pixel.
pub(super) struct Cell {
    pub(super) pixel: IVec2,
    pub(super) words: String,
    /// The step with which it comes.
    pub(super) step: usize,
}

/// Between a table and what is beside it.
const SPACE: f64 = 0.6 * NOTE;
/// Between two rows of the table, and between two columns.
const LEADING: f64 = 0.4 * LABEL;
const GUTTER: f64 = 0.9 * LABEL;

/// The pixels of a segment with their numbers and a table: below them, or beside them where y is the longer axis.
///
/// # Errors
///
/// Those of text.
pub(super) fn columns(sheet: &mut Sheet, ends: Ends, table: &[Row]) -> Result<Grid, FigureError> {
    let mut widths = Vec::new();
    let mut heights = Vec::new();
    let mut widest = 0.0_f64;
    let mut highest = 0.0_f64;
    for row in table {
        let heading = sheet.lay_out(&row.heading, LABEL)?;
        widest = widest.max(heading.width);
        highest = highest.max(heading.ascent + heading.descent);
        let (mut width, mut height) = (heading.width, heading.ascent + heading.descent);
        for cell in &row.cells {
            let line = sheet.lay_out(&cell.words, LABEL)?;
            width = width.max(line.width);
            height = height.max(line.ascent + line.descent);
        }
        widths.push(width + GUTTER);
        heights.push(height + LEADING);
    }
    let steep = ends.is_steep();
    let mut frame = sheet.frame();
    if steep {
        frame.min.x += BESIDE;
        frame.max.x -= SPACE + widths.iter().sum::<f64>();
        frame.min.y += highest + SPACE;
        frame.max.y -= NUMBERS;
    } else {
        frame.min.x += BESIDE.max(widest + SPACE);
        frame.max.y -= NUMBERS + heights.iter().sum::<f64>();
    }
    let [min, max] = ends.shown();
    let grid = Grid::fit(min, max, Orientation::Mathematical, frame);
    grid.draw_cells(sheet);
    grid.number_columns(sheet)?;
    grid.number_rows(sheet)?;

    let bounds = grid.bounds();
    let mut beside = bounds.max.x + SPACE;
    let mut below = bounds.max.y + NUMBERS;
    for ((row, width), height) in table.iter().zip(widths).zip(heights) {
        let middle = DVec2::new(beside + 0.5 * width, below + 0.5 * height);
        sheet.step(0);
        if steep {
            let at = DVec2::new(middle.x, bounds.min.y - SPACE - 0.4 * highest);
            sheet.text(at, Align::Centre, &row.heading, LABEL, Role::Text)?;
        } else {
            let at = DVec2::new(bounds.min.x - SPACE, middle.y);
            sheet.text(at, Align::Right, &row.heading, LABEL, Role::Text)?;
        }
        for cell in &row.cells {
            let pixel = grid.centre(cell.pixel);
            let at = if steep {
                DVec2::new(middle.x, pixel.y)
            } else {
                DVec2::new(pixel.x, middle.y)
            };
            sheet.step(cell.step);
            sheet.text(at, Align::Centre, &cell.words, LABEL, row.role)?;
        }
        (beside, below) = (beside + width, below + height);
    }
    sheet.step(0);
    Ok(grid)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pixels_are_counted_as_people_do() {
        let of = |language| [0, 1, 2, 5, 11, 21, 24, 112].map(|n| counted(n, language));
        let words = |line: &str| line.split(' ').map(str::to_owned).collect::<Vec<_>>();
        let said =
            |language| of(language).map(|text| text.split('\u{a0}').nth(1).map(str::to_owned));
        let expect = |text: &str| words(text).into_iter().map(Some).collect::<Vec<_>>();
        assert_eq!(
            said(Language::Cs).to_vec(),
            expect("pixelů pixel pixely pixelů pixelů pixelů pixelů pixelů")
        );
        assert_eq!(
            said(Language::Hr).to_vec(),
            expect("piksela piksel piksela piksela piksela piksel piksela piksela")
        );
        assert_eq!(of(Language::En)[1], "1\u{a0}pixel");
    }

    /// Every octant: the moves lead from one end to the other, and the line through both.
    #[test]
    fn moves_and_line_lead_from_end_to_end() {
        for (x, y) in [
            (8, 3),
            (3, 8),
            (-3, 8),
            (-8, 3),
            (-8, -3),
            (-3, -8),
            (3, -8),
            (8, -3),
            (5, 5),
            (0, -4),
            (7, 0),
        ] {
            let (a, b) = (IVec2::new(2, 1), IVec2::new(2 + x, 1 + y));
            let ends = Ends { a, b };
            let ([dx, dy], [east, north]) = (ends.extent(), ends.moves());
            assert_eq!(a + dx * east + dy * north, b);
            assert_eq!(ends.on_line(f64::from(dx)), b.as_dvec2());
            let middle = (a + b).as_dvec2() * 0.5;
            assert!((ends.on_line(0.5 * f64::from(dx)) - middle).length() < 1e-12);
        }
    }
}
