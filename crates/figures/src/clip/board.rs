//! What the figures of clipping share: a window and the part of the plane around it, and how they are asked for.

use ombra_clip::Window;
use ombra_math::glam::DVec2;

use crate::colour::{Ink, Role};
use crate::drawing::{NORMAL, Pen, THIN};
use crate::error::FigureError;
use crate::input::Ask;
use crate::path::{Path, Rect};
use crate::section::Section;
use crate::sheet::{Label, Sheet};
use crate::words::words;

/// Depth of the hatched strip beyond a line.
const BEYOND: f64 = 16.0;

/// A window on the canvas and the part of the plane shown around it.
pub(super) struct Board {
    pub(super) window: Window,
    pub(super) section: Section,
    pub(super) shown: Window,
}

impl Board {
    /// `shown` as large as it fits into `frame`.
    ///
    /// # Errors
    ///
    /// Those of [`Section::fit`].
    pub(super) fn fit(window: Window, shown: Window, frame: Rect) -> Result<Board, FigureError> {
        Ok(Board {
            window,
            section: Section::fit(&[shown.min, shown.max], frame)?,
            shown,
        })
    }

    pub(super) fn at(&self, p: DVec2) -> DVec2 {
        self.section.at(p)
    }

    pub(super) fn contour(&self, polygon: &[DVec2]) -> Vec<DVec2> {
        polygon.iter().map(|&p| self.at(p)).collect()
    }

    /// The window: its area and border.
    pub(super) fn draw_window(&self, sheet: &mut Sheet) {
        let border = Path::polygon(&self.contour(&corners(&self.window)));
        sheet.fill(border.clone(), Role::Ground);
        sheet.stroke(border, Pen::new(Role::Receiver, NORMAL));
    }

    /// Its border alone.
    pub(super) fn draw_border(&self, sheet: &mut Sheet) {
        let border = Path::polygon(&self.contour(&corners(&self.window)));
        sheet.stroke(border, Pen::new(Role::Receiver, NORMAL));
    }

    /// A hatched strip beyond a line of [`Board::lines`], as far as it is shown.
    pub(super) fn draw_beyond(&self, sheet: &mut Sheet, line: usize) {
        let Some(&[a, b]) = self.lines().get(line) else {
            return;
        };
        let [a, b] = [a, b].map(|p| self.at(p));
        let out = [DVec2::NEG_Y, DVec2::Y, DVec2::X, DVec2::NEG_X];
        let out = out.get(line).copied().unwrap_or_default() * BEYOND;
        let hatches = Path::hatching(&[a, b, b + out, a + out], 12.0);
        sheet.stroke_unmarked(hatches, Pen::new(Role::Note, THIN));
        sheet.line(a, b, Pen::new(Role::Text, NORMAL));
    }

    /// The lines that its sides lie on, across all that is shown.
    pub(super) fn draw_lines(&self, sheet: &mut Sheet) {
        for line in self.lines() {
            let [a, b] = line.map(|p| self.at(p));
            sheet.line(a, b, Pen::new(Role::Receiver, THIN).dashed());
        }
    }

    /// Those lines: above, below, right, left.
    pub(super) fn lines(&self) -> [[DVec2; 2]; 4] {
        let Board { window, shown, .. } = self;
        let level = |y| [DVec2::new(shown.min.x, y), DVec2::new(shown.max.x, y)];
        let upright = |x| [DVec2::new(x, shown.min.y), DVec2::new(x, shown.max.y)];
        [
            level(window.max.y),
            level(window.min.y),
            upright(window.max.x),
            upright(window.min.x),
        ]
    }

    /// What is kept of a polygon.
    pub(super) fn draw_kept(&self, sheet: &mut Sheet, polygon: &[DVec2]) {
        if polygon.is_empty() {
            return;
        }
        let outline = Path::polygon(&self.contour(polygon));
        sheet.fill(outline.clone(), Ink::of(Role::Chosen).alpha(0.28));
        sheet.stroke(outline, Pen::new(Role::Chosen, NORMAL));
    }

    /// The outline of what is clipped.
    pub(super) fn draw_cut_off(&self, sheet: &mut Sheet, polygon: &[DVec2]) {
        let outline = Path::polygon(&self.contour(polygon));
        sheet.stroke(outline, Pen::new(Role::Rejected, THIN).dashed());
    }

    /// A name beside a place.
    pub(super) fn name(
        &self,
        sheet: &mut Sheet,
        p: DVec2,
        name: impl Into<String>,
        towards: DVec2,
    ) {
        let towards = DVec2::new(towards.x, -towards.y);
        sheet.label(Label::new(self.at(p), name).towards(towards));
    }
}

/// A window of the figures; all are written out with the lower corner first.
pub(super) const fn window(min_x: f64, min_y: f64, max_x: f64, max_y: f64) -> Window {
    Window {
        min: DVec2::new(min_x, min_y),
        max: DVec2::new(max_x, max_y),
    }
}

/// Counter-clockwise from the lower left.
pub(super) fn corners(window: &Window) -> [DVec2; 4] {
    let (a, b) = (window.min, window.max);
    [a, DVec2::new(b.x, a.y), b, DVec2::new(a.x, b.y)]
}

/// Names of the lines in the order of [`Board::lines`].
pub(super) const NAMES: [&str; 4] = ["*y*_{max}", "*y*_{min}", "*x*_{max}", "*x*_{min}"];

words! {
    /// An input.
    WINDOW_WORD {
        en: "two opposite corners of the window",
        it: "due vertici opposti del rettangolo di clipping",
        cs: "dva protilehlé rohy okna",
        hr: "dva nasuprotna vrha prozora",
    }

    /// An input.
    pub(super) POLYGON_WORD {
        en: "corners of the polygon",
        it: "vertici del poligono",
        cs: "vrcholy polygonu",
        hr: "vrhovi poligona",
    }

    /// An input.
    pub(super) FIRST_END {
        en: "the first end of the segment",
        it: "il primo estremo del segmento",
        cs: "první konec úsečky",
        hr: "prvi kraj dužine",
    }

    /// An input.
    pub(super) LAST_END {
        en: "the last end of the segment",
        it: "il secondo estremo del segmento",
        cs: "druhý konec úsečky",
        hr: "drugi kraj dužine",
    }
}

/// Where points and corners may lie.
pub(super) const RANGE: [[f64; 2]; 2] = [[-40.0; 2], [40.0; 2]];

/// A window to be asked for.
pub(super) const fn asked(default: &'static [[f64; 2]; 2]) -> Ask<Vec<DVec2>> {
    Ask::polygon("window", "", WINDOW_WORD, default, [2, 2], RANGE)
}

/// The window between two corners.
pub(super) fn between(corners: &[DVec2]) -> Window {
    let (a, b) = match corners {
        [a, b, ..] => (*a, *b),
        _ => (DVec2::ZERO, DVec2::ZERO),
    };
    Window {
        min: a.min(b),
        max: a.max(b),
    }
}

/// What is shown of the plane: the window and `points`, with `around` of the longer side free on every side.
pub(super) fn shown(window: &Window, points: &[DVec2], around: f64) -> Window {
    let (min, max) = points
        .iter()
        .fold((window.min, window.max), |(min, max), &p| {
            (min.min(p), max.max(p))
        });
    // A single point has no size of its own.
    let side = (max - min).max_element();
    let free = DVec2::splat(around * if side > 0.0 { side } else { 1.0 });
    Window {
        min: min - free,
        max: max + free,
    }
}
