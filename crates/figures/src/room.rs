//! Room for labels: ever smaller letters, then a numbered list in a margin, so that a figure never fails for want of it.
//!
//! A figure is drawn with letters of the usual size. If a label finds no place, or only one across a line, it is drawn
//! again with letters a tenth smaller, down to [`SMALLEST`]. Labels that have no place even then get a number, and a
//! list in a strip along the longer side says what they say; the strip takes up to half of the canvas. What finds no
//! place there either is spelled out in the description of the SVG, in the caption, and for the person who draws.

use ombra_math::glam::DVec2;

use crate::colour::Role;
use crate::drawing::{Drawing, Pen, THIN};
use crate::error::FigureError;
use crate::sheet::Sheet;
use crate::style::Style;
use crate::text::{LABEL, Line, SMALLEST, escape};

/// From one size of letters to the next that is tried.
const SMALLER: f64 = 0.9;
/// Fewer labels across lines are worth smaller letters: one by a tenth, two down to the smallest.
const PER_CROSSED: f64 = 6.0;
/// Times that more labels are put into the list.
const ROUNDS: usize = 6;
/// Share of the frame that the list may take.
const MOST: f64 = 0.5;
/// Between the figure and its list.
const GUTTER: f64 = 40.0;
/// From one line of the list to the next.
const LEADING: f64 = 1.35 * LABEL;

/// How large letters are, and what is said in a list instead.
#[derive(Clone, Debug)]
pub(crate) struct Room {
    /// Size of letters, 1 for [`LABEL`].
    pub(crate) zoom: f64,
    /// Labels that have a number instead, by their markup; the first has number 1.
    listed: Vec<String>,
    /// What finds no place in the list.
    pub(crate) overflow: Vec<String>,
}

impl Room {
    /// Letters of the usual size.
    pub(crate) fn usual(style: &Style) -> Room {
        Room::of(style.text_scale.factor())
    }

    fn of(zoom: f64) -> Room {
        let (listed, overflow) = (Vec::new(), Vec::new());
        Room {
            zoom,
            listed,
            overflow,
        }
    }

    /// The number of a label that is in the list.
    pub(crate) fn key(&self, markup: &str) -> Option<usize> {
        let at = self.listed.iter().position(|listed| listed == markup)?;
        Some(at + 1)
    }
}

/// What stands for a label in the list.
pub(crate) fn key(number: usize) -> String {
    format!("[{number}]")
}

/// A figure drawn in some room, and how well it went.
#[derive(Debug, Default)]
pub(crate) struct Settled {
    pub(crate) drawing: Drawing,
    /// Labels without a place: their markup, and what they say.
    pub(crate) unplaced: Vec<(String, String)>,
    /// How many labels lie across a line.
    pub(crate) crossed: usize,
    /// The last step of its build-up; 0 if there is none.
    pub(crate) last: u32,
}

impl Settled {
    fn is_whole(&self) -> bool {
        self.unplaced.is_empty() && self.drawing.over.is_empty()
    }
}

/// A figure to be drawn once or more often.
pub(crate) struct Plan<'a> {
    pub(crate) id: &'a str,
    pub(crate) title: &'a str,
    pub(crate) caption: &'a str,
    pub(crate) style: &'a Style,
    /// How many steps are shown; 0 for all.
    pub(crate) step: u32,
}

impl Plan<'_> {
    /// Draws it in the largest letters for which there is room.
    ///
    /// # Errors
    ///
    /// Those of `draw` where it fails in every size.
    pub(crate) fn settled(
        &self,
        draw: impl Fn(&mut Sheet) -> Result<(), FigureError>,
    ) -> Result<Settled, FigureError> {
        let attempt = |caption: &str, room: &Room| {
            let mut sheet = Sheet::with_room(self.style, caption, room)?;
            draw(&mut sheet)?;
            sheet.settle(self.id, self.title, self.step)
        };

        let start = self.style.text_scale.factor();
        let least = SMALLEST / LABEL;
        let mut best: Option<(f64, Settled)> = None;
        let (mut drawn, mut refused) = (false, None);
        let mut zoom = start;
        loop {
            match attempt(self.caption, &Room::of(zoom)) {
                Err(error) => {
                    refused.get_or_insert(error);
                }
                Ok(settled) if settled.is_whole() => {
                    let cost = settled.crossed as f64 + PER_CROSSED * (1.0 - zoom / start);
                    if settled.crossed == 0 && best.is_none() {
                        return Ok(settled);
                    }
                    if best.as_ref().is_none_or(|(least, _)| cost < *least) {
                        best = Some((cost, settled));
                    }
                }
                Ok(_) => drawn = true,
            }
            if zoom <= least {
                break;
            }
            // The usual size is one of those that are tried.
            let smaller = (zoom * SMALLER).max(least);
            zoom = if zoom > 1.0 {
                smaller.max(1.0)
            } else {
                smaller
            };
        }
        if let Some((_, settled)) = best {
            return Ok(settled);
        }
        if let (false, Some(error)) = (drawn, refused) {
            return Err(error);
        }
        let settled = self.with_list(least, self.caption, attempt)?;
        if !self.style.caption || settled.drawing.over.is_empty() {
            return Ok(settled);
        }
        let over = escape(&settled.drawing.over.join("; "));
        self.with_list(least, &format!("{} [{over}]", self.caption), attempt)
    }

    /// Draws it in the smallest letters, with a list of the labels for which there is no place.
    fn with_list(
        &self,
        zoom: f64,
        caption: &str,
        attempt: impl Fn(&str, &Room) -> Result<Settled, FigureError>,
    ) -> Result<Settled, FigureError> {
        let mut room = Room::of(zoom);
        let mut settled = attempt(caption, &room)?;
        for _ in 0..ROUNDS {
            let before = room.listed.len();
            for (markup, _) in &settled.unplaced {
                if room.key(markup).is_none() {
                    room.listed.push(markup.clone());
                }
            }
            if room.listed.len() == before {
                break;
            }
            match attempt(caption, &room) {
                // A figure that the strip leaves no room at all stays as it was.
                Err(_) => break,
                Ok(next) => settled = next,
            }
        }
        let unplaced = core::mem::take(&mut settled.unplaced);
        let over = unplaced.into_iter().map(|(_, plain)| plain);
        settled.drawing.over.extend(over);
        Ok(settled)
    }
}

impl Sheet {
    /// Sets the list into a strip of the frame, and leaves the rest to the figure.
    ///
    /// # Errors
    ///
    /// Those of the labels' markup.
    pub(crate) fn reserve_strip(&mut self) -> Result<(), FigureError> {
        if self.room.listed.is_empty() {
            return Ok(());
        }
        let frame = self.frame;
        let aside = frame.size().x >= frame.size().y;
        let widest = if aside {
            MOST * frame.size().x - GUTTER
        } else {
            frame.size().x
        };
        let mut entries: Vec<Vec<Line>> = Vec::new();
        for (i, markup) in self.room.listed.iter().enumerate() {
            let words = format!("{}\u{a0}{}", key(i + 1), markup.replace('\n', " "));
            entries.push(self.wrapped(&words, LABEL, widest)?);
        }
        let width = entries
            .iter()
            .flatten()
            .map(|line| line.width)
            .fold(0.0, f64::max);
        let columns = if aside {
            1.0
        } else {
            ((widest + GUTTER) / (width + GUTTER))
                .floor()
                .clamp(1.0, 6.0)
        };
        let most = if aside {
            frame.size().y
        } else {
            MOST * frame.size().y - GUTTER
        };

        // Column by column, each as high as it must be.
        let lines: usize = entries.iter().map(Vec::len).sum();
        let rows = (lines as f64 / columns).ceil().max(1.0);
        let mut height = (rows * LEADING).min(most);
        let tallest = entries.iter().map(Vec::len).max().unwrap_or(1) as f64 * LEADING;
        height = height.max(tallest).min(most);
        let corner = if aside {
            DVec2::new(frame.max.x - width, frame.min.y)
        } else {
            DVec2::new(frame.min.x, frame.max.y - height)
        };
        let (mut column, mut down) = (0.0, 0.0);
        let mut overflow = Vec::new();
        for entry in entries {
            let needs = entry.len() as f64 * LEADING;
            if down + needs > height + 0.01 && column + 1.0 < columns {
                (column, down) = (column + 1.0, 0.0);
            }
            if down + needs > most + 0.01 {
                overflow.extend(entry.into_iter().map(|line| line.plain));
                continue;
            }
            for line in entry {
                let start = corner + DVec2::new(column * (width + GUTTER), down + LEADING);
                let baseline = start - DVec2::new(0.0, 0.3 * LABEL);
                self.set_at(line, baseline, Role::Text.into());
                down += LEADING;
            }
        }
        self.room.overflow = overflow;
        if aside {
            self.frame.max.x -= width + GUTTER;
            let x = self.frame.max.x + 0.5 * GUTTER;
            let ends = [frame.min.y, frame.max.y].map(|y| DVec2::new(x, y));
            self.line(ends[0], ends[1], Pen::new(Role::Grid, THIN));
        } else {
            self.frame.max.y -= height + GUTTER;
            let y = self.frame.max.y + 0.5 * GUTTER;
            let ends = [frame.min.x, frame.max.x].map(|x| DVec2::new(x, y));
            self.line(ends[0], ends[1], Pen::new(Role::Grid, THIN));
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drawing::Item;
    use crate::path::Rect;
    use crate::sheet::Label;
    use crate::style::Size;

    /// `count` labels beside points in two rows, each with so many words.
    fn crowd(style: &Style, count: usize, words: usize) -> Drawing {
        let plan = Plan {
            id: "a/b",
            title: "",
            caption: "A caption.",
            style,
            step: 0,
        };
        let draw = |sheet: &mut Sheet| {
            for i in 0..count {
                let (row, column) = ((i % 2) as f64, (i / 2) as f64);
                let place = DVec2::new(0.03 * column - 0.15, 0.08 * row);
                let at = sheet.frame().centre() + sheet.frame().size() * place;
                let words = format!("label {i} {}", "and more ".repeat(words));
                sheet.label(Label::new(at, words.trim()));
            }
            Ok(())
        };
        plan.settled(draw).unwrap().drawing
    }

    fn texts(drawing: &Drawing) -> Vec<&str> {
        let labels = drawing.labels.iter();
        labels.map(|label| label.text.as_str()).collect()
    }

    fn smallest(drawing: &Drawing) -> f64 {
        let sizes = drawing.labels.iter().map(|label| label.smallest);
        sizes.fold(f64::INFINITY, f64::min)
    }

    fn check_apart(drawing: &Drawing) {
        let canvas = Rect::new(DVec2::ZERO, drawing.canvas);
        for (i, label) in drawing.labels.iter().enumerate() {
            assert!(canvas.contains(&label.bounds), "{}", label.text);
            let meets =
                |other: &&crate::drawing::LabelBox| label.bounds.grown(-0.02).meets(&other.bounds);
            assert!(
                !drawing.labels[..i].iter().any(|other| meets(&other)),
                "{}",
                label.text
            );
        }
    }

    #[test]
    fn where_there_is_room_letters_keep_their_size() {
        let drawing = crowd(&Style::default(), 2, 1);
        assert_eq!(smallest(&drawing), LABEL);
        assert!(drawing.over.is_empty());
    }

    #[test]
    fn then_letters_get_smaller_and_never_below_the_smallest() {
        let sizes: Vec<f64> = (2..16)
            .map(|count| smallest(&crowd(&Style::default(), count, 1)))
            .collect();
        assert!(sizes.iter().any(|&size| size < LABEL && size > SMALLEST));
        assert!(sizes.iter().all(|&size| size >= SMALLEST - 1e-9));
    }

    #[test]
    fn then_numbers_stand_for_labels_and_a_list_says_what_they_mean() {
        let drawing = crowd(&Style::default(), 12, 4);
        check_apart(&drawing);
        assert!(drawing.over.is_empty(), "{:?}", drawing.over);
        let said = texts(&drawing).join(" ");
        // Every label is said, in its place or in the list, and every number of the list stands in the picture.
        for i in 0..12 {
            assert!(said.contains(&format!("label {i} and")), "{i}: {said}");
        }
        let keys: Vec<&str> = texts(&drawing)
            .into_iter()
            .filter(|text| text.len() <= 4 && text.starts_with('['))
            .collect();
        assert!(!keys.is_empty());
        for key in keys {
            assert_eq!(said.matches(key).count(), 2, "{key}: {said}");
        }
    }

    #[test]
    fn what_is_still_over_is_spelled_out_and_nothing_is_lost() {
        for caption in [false, true] {
            let size = Size::new(360, 240).unwrap();
            let style = Style {
                size,
                caption,
                ..Style::default()
            };
            let drawing = crowd(&style, 24, 6);
            check_apart(&drawing);
            assert!(!drawing.over.is_empty());
            let said = format!("{} {}", texts(&drawing).join(" "), drawing.over.join(" "));
            for i in 0..24 {
                assert!(said.contains(&format!("label {i} and")), "{i}");
            }
            let svg = crate::svg::svg(&drawing).unwrap();
            assert!(svg.contains("<desc>") && svg.contains(&drawing.over[0]));
        }
    }

    #[test]
    fn lines_keep_their_width_however_small_letters_get() {
        let plan = |words: usize| {
            let style = Style::default();
            let plan = Plan {
                id: "a/b",
                title: "",
                caption: "",
                style: &style,
                step: 0,
            };
            plan.settled(|sheet| {
                let frame = sheet.frame();
                sheet.line(frame.min, frame.max, Pen::new(Role::Text, THIN));
                for _ in 0..words {
                    sheet.label(
                        Label::new(frame.centre(), "some words to be placed").towards(DVec2::X),
                    );
                }
                Ok(())
            })
            .unwrap()
            .drawing
        };
        for words in [1, 12] {
            let drawing = plan(words);
            let mut lines = drawing.items.iter().rev().filter_map(|item| match item {
                Item::Shape {
                    path,
                    stroke: Some(pen),
                    ..
                } if pen.paint == Role::Text.into() => Some((path, pen)),
                _ => None,
            });
            let (path, pen) = lines.next().unwrap();
            assert_eq!(pen.width, THIN);
            // The margin is the same, too, to a hundredth.
            let start = path.points().next().unwrap();
            assert!(
                (start - DVec2::splat(crate::drawing::MARGIN))
                    .abs()
                    .max_element()
                    < 0.011
            );
        }
    }
}
