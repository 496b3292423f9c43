//! The sheet a figure draws on: shapes go on at once, labels find their places when it is finished.

mod centres;
mod finish;
mod label;

pub use self::centres::Centres;
pub use self::label::Label;

use ombra_math::glam::DVec2;

use crate::colour::{Ink, Role};
use crate::drawing::{Drawing, FillRule, Item, MARGIN, Paint, Pen, Picture};
use crate::error::FigureError;
use crate::panels::GUTTER;
use crate::path::{Path, Rect};
use crate::place::Drawn;
use crate::room::{Room, Settled};
use crate::style::Style;
use crate::text::{CAPITALS, LABEL, Line, NOTE, SMALLEST, wrapped_no_smaller};

/// Which point of a fixed text its position names.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Align {
    /// The middle of its left edge.
    Left,
    /// Its middle.
    Centre,
    /// The middle of its right edge.
    Right,
    /// The middle of its upper edge.
    Below,
    /// The middle of its lower edge.
    Above,
}

/// The steps of a build-up at which something is there; the whole figure shows what stays to the end.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
struct Steps {
    /// The first; 0 for always.
    from: u32,
    /// Whether it is gone after that.
    only: bool,
}

impl Steps {
    /// Whether it is shown when `step` steps are, 0 for all of them.
    fn shown(self, step: u32) -> bool {
        match (self.only, step) {
            (true, _) => step == self.from,
            (false, 0) => true,
            (false, _) => self.from <= step,
        }
    }

    /// Whether the two are ever seen together.
    fn meet(self, other: Steps) -> bool {
        match (self.only, other.only) {
            (true, true) => self.from == other.from,
            (true, false) => other.from <= self.from,
            (false, true) => self.from <= other.from,
            (false, false) => true,
        }
    }
}

/// Text at a fixed place.
struct Fixed {
    steps: Steps,
    line: Line,
    at: DVec2,
    ink: Ink,
}

/// A figure being drawn.
///
/// Lengths are thousandths of the canvas's shorter side as long as there is room for letters of the usual size. Where
/// there is not, the same figure is drawn on a larger sheet and made smaller as a whole, lines excepted: so a figure
/// only ever knows letters of [`LABEL`] and [`NOTE`].
pub struct Sheet {
    style: Style,
    pub(crate) room: Room,
    canvas: DVec2,
    pub(crate) frame: Rect,
    now: Steps,
    /// Where labels must stay, unless they say otherwise; none for the whole frame.
    within: Option<Rect>,
    items: Vec<(Steps, Item)>,
    fixed: Vec<Fixed>,
    labels: Vec<(Steps, Label)>,
    drawn: Vec<Drawn>,
    /// Grids of points and how many items lie below each.
    centres: Vec<(usize, Steps, Centres)>,
    /// The last step of all.
    last: u32,
}

impl Sheet {
    /// An empty sheet with letters of the usual size; `caption` is set along its lower border where the style asks for
    /// it.
    ///
    /// # Errors
    ///
    /// Those of a label's markup.
    pub fn new(style: &Style, caption: &str) -> Result<Sheet, FigureError> {
        Sheet::with_room(style, caption, &Room::usual(style))
    }

    pub(crate) fn with_room(
        style: &Style,
        caption: &str,
        room: &Room,
    ) -> Result<Sheet, FigureError> {
        let shorter = f64::from(style.size.shorter()) * room.zoom;
        let side = |pixels: u32| f64::from(pixels) * 1000.0 / shorter;
        let canvas = DVec2::new(side(style.size.width()), side(style.size.height()));
        let margin = DVec2::splat(MARGIN / room.zoom);
        let mut sheet = Sheet {
            style: *style,
            room: room.clone(),
            canvas,
            frame: Rect::new(margin, canvas - margin),
            now: Steps::default(),
            within: None,
            items: Vec::new(),
            fixed: Vec::new(),
            labels: Vec::new(),
            drawn: Vec::new(),
            centres: Vec::new(),
            last: 0,
        };
        if style.caption && !caption.is_empty() {
            let lines = sheet.wrapped(caption, NOTE, sheet.frame.size().x)?;
            for line in lines.into_iter().rev() {
                let leading = NOTE.max(sheet.least()) * 1.35;
                let centre = DVec2::new(canvas.x * 0.5, sheet.frame.max.y - leading * 0.5);
                let at = line.centred(centre);
                sheet.set_at(line, at, Role::Text.into());
                sheet.frame.max.y -= leading;
            }
            sheet.frame.max.y -= NOTE;
        }
        sheet.reserve_strip()?;
        Ok(sheet)
    }

    /// What the instructor chose.
    pub fn style(&self) -> &Style {
        &self.style
    }

    /// Width and height.
    pub fn canvas(&self) -> DVec2 {
        self.canvas
    }

    /// Where the figure may draw: the canvas without margin and caption.
    pub fn frame(&self) -> Rect {
        self.frame
    }

    /// Letters may not be smaller.
    fn least(&self) -> f64 {
        SMALLEST / self.room.zoom
    }

    /// Lays out `markup` for this sheet.
    ///
    /// # Errors
    ///
    /// Those of the markup.
    pub fn lay_out(&self, markup: &str, size: f64) -> Result<Line, FigureError> {
        Line::no_smaller(markup, size, self.least())
    }

    /// [`crate::text::wrapped`] for this sheet.
    ///
    /// # Errors
    ///
    /// Those of the markup.
    pub fn wrapped(&self, markup: &str, size: f64, width: f64) -> Result<Vec<Line>, FigureError> {
        wrapped_no_smaller(markup, size, self.least(), width)
    }

    /// What is drawn from now on comes with the `step`-th step of a build-up and stays; 0: it is always there.
    pub fn step(&mut self, step: usize) {
        self.now = Steps {
            from: u32::try_from(step).unwrap_or(u32::MAX),
            only: false,
        };
        self.last = self.last.max(self.now.from);
    }

    /// What is drawn from now on belongs to the `i`-th panel, counted from 0: it comes with step i + 1, and labels stay in
    /// the panel or right beside it.
    pub fn panel(&mut self, i: usize, panel: Rect) {
        self.step(i + 1);
        let around = panel.grown(0.45 * GUTTER);
        self.within = Some(Rect::new(
            around.min.max(self.frame.min),
            around.max.min(self.frame.max),
        ));
    }

    /// What is drawn from now on belongs to no step and no panel.
    pub fn whole(&mut self) {
        self.step(0);
        self.within = None;
    }

    /// What is drawn from now on is there at the `step`-th step alone; the whole figure is without it.
    pub fn step_alone(&mut self, step: usize) {
        self.step(step);
        self.now.only = true;
    }

    /// Fills `path` by the non-zero rule.
    pub fn fill(&mut self, path: Path, paint: impl Into<Paint>) {
        self.shape(path, Some((paint.into(), FillRule::NonZero)), None);
    }

    /// Draws along `path`; labels keep off it.
    pub fn stroke(&mut self, path: Path, pen: Pen) {
        self.shape(path, None, Some(pen));
    }

    /// Draws a line; labels keep off it.
    pub fn line(&mut self, a: DVec2, b: DVec2, pen: Pen) {
        self.stroke(Path::line(a, b), pen);
    }

    /// Fills and draws along `path`. Labels keep off the line, but not off a grid.
    pub fn shape(&mut self, path: Path, fill: Option<(Paint, FillRule)>, stroke: Option<Pen>) {
        let of_a_grid =
            |pen: &Pen| matches!(pen.paint, Paint::Solid(Ink { role, .. }) if role.is_area());
        if let Some(pen) = stroke.as_ref().filter(|pen| !of_a_grid(pen)) {
            // A label may sooner cover a piece of a dashed line.
            self.keep_off(&path, if pen.dash.is_some() { 0.15 } else { 2.0 });
        }
        self.push(path, fill, stroke);
    }

    /// Fills `path` and draws along it in a way that labels may cover.
    pub fn fill_unmarked(&mut self, path: Path, fill: impl Into<Paint>, stroke: Pen) {
        self.push(path, Some((fill.into(), FillRule::NonZero)), Some(stroke));
    }

    /// Draws along `path` in a way that labels may cover.
    pub fn stroke_unmarked(&mut self, path: Path, stroke: Pen) {
        self.push(path, None, Some(stroke));
    }

    /// Puts a shape on the list.
    fn push(&mut self, path: Path, fill: Option<(Paint, FillRule)>, stroke: Option<Pen>) {
        let item = Item::Shape { path, fill, stroke };
        self.items.push((self.now, item));
    }

    /// Puts a picture on the list, in a way that labels may cover.
    pub fn picture(&mut self, place: Rect, picture: Picture) {
        self.items
            .push((self.now, Item::Picture { place, picture }));
    }

    /// The centre points of pixels; those below labels are left out.
    pub fn centres(&mut self, centres: Centres) {
        self.centres.push((self.items.len(), self.now, centres));
    }

    /// Makes labels keep well off the lines of `path`, curves taken by their chords.
    pub fn avoid(&mut self, path: &Path) {
        self.keep_off(path, 4.0);
    }

    fn keep_off(&mut self, path: &Path, weight: f64) {
        let drawn = |(a, b)| Drawn { a, b, weight };
        self.drawn.extend(path.chords().into_iter().map(drawn));
    }

    /// A round point; labels keep off it.
    pub fn dot(&mut self, at: DVec2, radius: f64, paint: impl Into<Paint>) {
        let path = Path::circle(at, radius);
        self.avoid(&path);
        self.fill(path, paint);
    }

    /// Asks for a label, placed when the sheet is finished; earlier ones choose first.
    pub fn label(&mut self, label: Label) {
        let within = label.within.or(self.within);
        self.labels.push((self.now, Label { within, ..label }));
    }

    /// Text at a fixed place, such as a tick; placed labels keep off it. Beside its position (left, middle, right) the
    /// middle of its capitals is level with it, so that neighbours stand on one baseline.
    ///
    /// # Errors
    ///
    /// Those of its markup.
    pub fn text(
        &mut self,
        at: DVec2,
        align: Align,
        markup: &str,
        size: f64,
        ink: impl Into<Ink>,
    ) -> Result<Rect, FigureError> {
        let line = self.lay_out(markup, size)?;
        let size = line.runs.iter().map(|run| run.size).fold(0.0, f64::max);
        let several = markup.contains('\n');
        let middle = if several {
            0.5 * (line.ascent - line.descent)
        } else {
            0.5 * CAPITALS * size
        };
        let half = 0.5 * line.width;
        let start = match align {
            Align::Left => at + DVec2::new(0.0, middle),
            Align::Centre => at + DVec2::new(-half, middle),
            Align::Right => at + DVec2::new(-line.width, middle),
            Align::Below => at + DVec2::new(-half, line.ascent),
            Align::Above => at - DVec2::new(half, line.descent),
        };
        Ok(self.set_at(line, start, ink.into()))
    }

    /// A laid-out line at a fixed place: its letters' middle at the height of `start`, whatever hangs below or rises.
    pub(crate) fn set_line(&mut self, line: Line, start: DVec2, ink: impl Into<Ink>) -> Rect {
        let at = start + DVec2::new(0.0, 0.5 * CAPITALS * LABEL);
        self.set_at(line, at, ink.into())
    }

    /// A laid-out line whose baseline starts at `at`.
    pub(crate) fn set_at(&mut self, line: Line, at: DVec2, ink: Ink) -> Rect {
        let bounds = line.bounds(at);
        // An empty cell of a table is no text.
        if line.runs.is_empty() {
            return bounds;
        }
        let steps = self.now;
        self.fixed.push(Fixed {
            steps,
            line,
            at,
            ink,
        });
        bounds
    }

    /// A line in the middle of the upper border; the frame then begins below it.
    ///
    /// # Errors
    ///
    /// Those of its markup.
    pub fn heading(&mut self, markup: &str) -> Result<(), FigureError> {
        let line = self.lay_out(markup, LABEL)?;
        let start = DVec2::new(
            self.frame.centre().x - 0.5 * line.width,
            self.frame.min.y + line.ascent,
        );
        self.frame.min.y += line.ascent + line.descent + 0.6 * LABEL;
        self.set_at(line, start, Role::Text.into());
        Ok(())
    }

    /// Places the labels and hands over the drawing; what finds no place is in its [`Drawing::over`].
    ///
    /// # Errors
    ///
    /// Those of the labels' markup.
    pub fn finish(self, id: &str, title: &str) -> Result<Drawing, FigureError> {
        let Settled {
            mut drawing,
            unplaced,
            ..
        } = self.settle(id, title, 0)?;
        drawing
            .over
            .extend(unplaced.into_iter().map(|(_, plain)| plain));
        Ok(drawing)
    }
}
