//! The sheet a figure draws on: shapes go on at once, labels find their places when it is finished.

mod centres;
mod label;

pub use self::centres::Centres;
pub use self::label::Label;

use ombra_math::glam::DVec2;

use crate::colour::{Ink, Role};
use crate::drawing::{Drawing, FillRule, HALO, Item, LabelBox, MARGIN, Paint, Pen, Picture, THIN};
use crate::error::FigureError;
use crate::path::{Path, Rect, round, round_length};
use crate::place::{Drawn, Wanted, place};
use crate::style::Style;
use crate::text::{CAPITALS, LABEL, Line, NOTE, wrapped};

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

/// Letters stand out on an area mixed of less ink than this and paper.
const PALE: f64 = 0.25;

/// What is drawn below the labels: where they lie over some of it they need a rim of paper. Elsewhere a rim would show
/// on a transparent background, and on the ground.
#[derive(Default)]
struct Under {
    lines: Vec<(DVec2, DVec2)>,
    areas: Vec<Rect>,
}

impl Under {
    fn of(items: &[Item]) -> Under {
        let mut under = Under::default();
        for item in items {
            let (path, fill, stroke) = match item {
                Item::Shape { path, fill, stroke } => (path, fill, stroke),
                Item::Picture { place, .. } => {
                    under.areas.push(*place);
                    continue;
                }
                Item::Text { .. } => continue,
            };
            let pale = |paint: &Paint| match paint {
                Paint::Solid(ink) => {
                    matches!(ink.role, Role::Paper | Role::Ground) || ink.share < PALE
                }
                _ => false,
            };
            if fill.as_ref().is_some_and(|(paint, _)| !pale(paint)) {
                under.areas.extend(path.bounds());
            }
            if stroke.is_some() {
                under.lines.extend(path.chords());
            }
        }
        under
    }

    fn disturbs(&self, bounds: &Rect) -> bool {
        self.areas.iter().any(|area| area.meets(bounds))
            || self
                .lines
                .iter()
                .any(|&(a, b)| bounds.length_within(a, b) > 0.0)
    }
}

/// A figure being drawn.
pub struct Sheet {
    style: Style,
    canvas: DVec2,
    frame: Rect,
    items: Vec<Item>,
    fixed: Vec<Item>,
    boxes: Vec<LabelBox>,
    labels: Vec<Label>,
    drawn: Vec<Drawn>,
    /// Grids of points and how many items lie below each.
    centres: Vec<(usize, Centres)>,
}

impl Sheet {
    /// An empty sheet; `caption` is set along its lower border where the style asks for it.
    ///
    /// # Errors
    ///
    /// Those of a label's markup.
    pub fn new(style: &Style, caption: &str) -> Result<Sheet, FigureError> {
        let shorter = f64::from(style.size.shorter());
        let side = |pixels: u32| round_length(f64::from(pixels) * 1000.0 / shorter);
        let canvas = DVec2::new(side(style.size.width()), side(style.size.height()));
        let mut sheet = Sheet {
            style: *style,
            canvas,
            frame: Rect::new(DVec2::splat(MARGIN), canvas - DVec2::splat(MARGIN)),
            items: Vec::new(),
            fixed: Vec::new(),
            boxes: Vec::new(),
            labels: Vec::new(),
            drawn: Vec::new(),
            centres: Vec::new(),
        };
        if style.caption && !caption.is_empty() {
            let lines = wrapped(caption, NOTE, sheet.frame.size().x)?;
            for line in lines.into_iter().rev() {
                let leading = NOTE * 1.35;
                let centre = DVec2::new(canvas.x * 0.5, sheet.frame.max.y - leading * 0.5);
                sheet.set(line, centre, Role::Text.into());
                sheet.frame.max.y -= leading;
            }
            sheet.frame.max.y -= NOTE;
        }
        Ok(sheet)
    }

    /// What the instructor chose.
    pub fn style(&self) -> &Style {
        &self.style
    }

    /// Width and height in thousandths of the shorter side.
    pub fn canvas(&self) -> DVec2 {
        self.canvas
    }

    /// Where the figure may draw: the canvas without margin and caption.
    pub fn frame(&self) -> Rect {
        self.frame
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

    /// Puts a shape on the list, every length rounded.
    fn push(&mut self, path: Path, fill: Option<(Paint, FillRule)>, stroke: Option<Pen>) {
        let path = path.map(round);
        self.items.push(Item::Shape {
            path,
            fill: fill.map(|(fill, rule)| (fill.rounded(), rule)),
            stroke: stroke.map(Pen::rounded),
        });
    }

    /// Puts a picture on the list, in a way that labels may cover.
    pub fn picture(&mut self, place: Rect, picture: Picture) {
        let place = Rect::new(round(place.min), round(place.max));
        self.items.push(Item::Picture { place, picture });
    }

    /// The centre points of pixels; those below labels are left out.
    pub fn centres(&mut self, centres: Centres) {
        self.centres.push((self.items.len(), centres));
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
        self.labels.push(label);
    }

    /// Text at a fixed place, such as a tick; placed labels keep off it.
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
        let line = Line::new(markup, size)?;
        let half = DVec2::new(line.width * 0.5, (line.ascent + line.descent) * 0.5);
        let centre = match align {
            Align::Left => at + DVec2::new(half.x, 0.0),
            Align::Centre => at,
            Align::Right => at - DVec2::new(half.x, 0.0),
            Align::Below => at + DVec2::new(0.0, half.y),
            Align::Above => at - DVec2::new(0.0, half.y),
        };
        Ok(self.set(line, centre, ink.into()))
    }

    fn set(&mut self, line: Line, centre: DVec2, ink: Ink) -> Rect {
        let at = line.centred(centre);
        self.set_at(line, at, ink)
    }

    /// A laid-out line at a fixed place: its letters' middle at the height of `start`, whatever hangs below or rises.
    pub(crate) fn set_line(&mut self, line: Line, start: DVec2, ink: impl Into<Ink>) -> Rect {
        let at = start + DVec2::new(0.0, 0.5 * CAPITALS * LABEL);
        self.set_at(line, at, ink.into())
    }

    /// A laid-out line whose baseline starts at `at`.
    pub(crate) fn set_at(&mut self, line: Line, at: DVec2, ink: Ink) -> Rect {
        let at = round(at);
        let bounds = line.bounds(at);
        self.boxes.push(LabelBox {
            bounds,
            smallest: line.smallest(),
            text: line.plain.clone(),
        });
        self.fixed.push(Item::Text {
            line,
            at,
            ink,
            halo: false,
        });
        bounds
    }

    /// Places the labels and hands over the drawing.
    ///
    /// # Errors
    ///
    /// Those of the labels' markup; [`FigureError::NoRoom`] for a label without a free place.
    pub fn finish(mut self, id: &str, title: &str) -> Result<Drawing, FigureError> {
        let mut wanted = Vec::with_capacity(self.labels.len());
        for label in &self.labels {
            wanted.push(Wanted {
                line: Line::new(&label.markup, label.size)?,
                anchor: label.anchor,
                reach: label.reach,
                towards: label.towards,
                may_lead: label.may_lead,
                optional: label.optional,
                frame: label.within.unwrap_or(self.frame),
            });
        }
        let taken: Vec<Rect> = self
            .boxes
            .iter()
            .map(|label| label.bounds.grown(HALO))
            .collect();
        let places = place(&wanted, &taken, &self.drawn)?;

        let mut letters = Vec::with_capacity(places.len());
        for ((label, wanted), place) in self.labels.iter().zip(wanted).zip(&places) {
            let Some(place) = place else { continue };
            if let Some((start, end)) = place.leader {
                self.items.push(Item::Shape {
                    path: Path::line(start, end).map(round),
                    fill: None,
                    stroke: Some(Pen::new(Role::Note, THIN)),
                });
            }
            self.boxes.push(LabelBox {
                bounds: place.bounds,
                smallest: wanted.line.smallest(),
                text: wanted.line.plain.clone(),
            });
            letters.push((wanted.line, *place, label.ink));
        }
        for (below, centres) in self.centres.iter().rev() {
            let item = centres.item(&self.boxes);
            self.items.insert((*below).min(self.items.len()), item);
        }
        let under = Under::of(&self.items);
        self.items.append(&mut self.fixed);
        self.items
            .extend(letters.into_iter().map(|(line, place, ink)| Item::Text {
                line,
                at: place.at,
                ink,
                halo: under.disturbs(&place.bounds),
            }));
        Ok(Drawing {
            id: id.to_owned(),
            title: title.to_owned(),
            style: self.style,
            canvas: self.canvas,
            items: self.items,
            labels: self.boxes,
        })
    }
}
