//! From what was drawn to a drawing: labels find places, what its step does not show is left out.

use ombra_math::glam::DVec2;

use super::{Fixed, Sheet, Steps};
use crate::colour::Role;
use crate::drawing::{Drawing, HALO, Item, LabelBox, MARGIN, Paint, Pen, THIN};
use crate::error::FigureError;
use crate::path::{Path, Rect, round};
use crate::place::{Wanted, place};
use crate::room::{Settled, key};
use crate::style::Background;
use crate::text::LABEL;

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

/// Text that lies where it lies.
struct Put {
    steps: Steps,
    bounds: Rect,
    smallest: f64,
    plain: String,
    /// Whether a rim of paper may run around it.
    rimmed: bool,
    item: Item,
}

impl Sheet {
    /// Places the labels and hands over the drawing as it is at `step`, with what found no place.
    ///
    /// # Errors
    ///
    /// Those of the labels' markup.
    pub(crate) fn settle(
        mut self,
        id: &str,
        title: &str,
        step: u32,
    ) -> Result<Settled, FigureError> {
        let (fixed, lost) = self.fixed();
        let mut wanted = Vec::with_capacity(self.labels.len());
        for (_, label) in &self.labels {
            let key = self.room.key(&label.markup).map(key);
            let markup = key.as_deref().unwrap_or(&label.markup);
            let size = if key.is_some() { LABEL } else { label.size };
            wanted.push(Wanted {
                line: self.lay_out(markup, size)?,
                anchor: label.anchor,
                reach: label.reach,
                towards: label.towards,
                may_lead: label.may_lead,
                optional: label.optional,
                frame: label.within.unwrap_or(self.frame),
            });
        }
        let taken: Vec<Rect> = fixed.iter().map(|put| put.bounds.grown(HALO)).collect();
        let places = place(&wanted, &taken, &self.drawn);

        let mut settled = Settled {
            last: self.last,
            ..Settled::default()
        };
        let mut letters = Vec::with_capacity(places.len());
        for (((steps, label), wanted), place) in self.labels.iter().zip(wanted).zip(places) {
            let Some(place) = place else {
                if !label.optional {
                    let plain = self.lay_out(&label.markup, label.size)?.plain;
                    settled.unplaced.push((label.markup.clone(), plain));
                }
                continue;
            };
            settled.crossed += usize::from(place.crosses);
            if let Some((start, end)) = place.leader {
                let leader = Item::Shape {
                    path: Path::line(start, end),
                    fill: None,
                    stroke: Some(Pen::new(Role::Note, THIN)),
                };
                self.items.push((*steps, leader));
            }
            letters.push(Put {
                steps: *steps,
                bounds: place.bounds,
                smallest: wanted.line.smallest(),
                plain: wanted.line.plain.clone(),
                rimmed: true,
                item: Item::Text {
                    line: wanted.line,
                    at: place.at,
                    ink: label.ink,
                    halo: false,
                },
            });
        }

        let texts: Vec<Put> = fixed
            .into_iter()
            .chain(letters)
            .filter(|put| put.steps.shown(step))
            .collect();
        let boxes: Vec<Rect> = texts.iter().map(|put| put.bounds).collect();
        for (below, steps, centres) in self.centres.iter().rev() {
            let item = centres.item(&boxes);
            let below = (*below).min(self.items.len());
            self.items.insert(below, (*steps, item));
        }
        let mut items: Vec<Item> = self
            .items
            .into_iter()
            .filter(|(steps, _)| steps.shown(step))
            .map(|(_, item)| item)
            .collect();
        let paperless = self.style.background == Background::Transparent;
        if paperless {
            // Paper that covers nothing but what the slide shows through would be a spot on it.
            items.retain(|item| !is_bare_paper(item));
        }
        let under = Under::of(&items);
        let mut labels = Vec::with_capacity(texts.len());
        for put in texts {
            let mut item = put.item;
            if let Item::Text { halo, .. } = &mut item {
                *halo = put.rimmed && !paperless && under.disturbs(&put.bounds);
            }
            items.push(item);
            labels.push(LabelBox {
                bounds: put.bounds,
                smallest: put.smallest,
                text: put.plain,
            });
        }
        let mut over = self.room.overflow;
        over.extend(lost);
        let drawing = Drawing {
            id: id.to_owned(),
            title: title.to_owned(),
            style: self.style,
            canvas: self.canvas,
            items,
            labels,
            over,
        };
        settled.drawing = drawing.zoomed(self.room.zoom);
        Ok(settled)
    }

    /// The fixed texts that lie within the margin and on no earlier one; and what the others say.
    fn fixed(&mut self) -> (Vec<Put>, Vec<String>) {
        let margin = DVec2::splat(MARGIN / self.room.zoom);
        // Half a hundredth is what rounding may move a box.
        let inside = Rect::new(margin, self.canvas - margin).grown(0.005);
        let (mut kept, mut lost) = (Vec::<Put>::new(), Vec::new());
        for Fixed {
            steps,
            line,
            at,
            ink,
        } in self.fixed.drain(..)
        {
            let bounds = line.bounds(at);
            let free = |other: &Put| !other.bounds.meets(&bounds) || !other.steps.meet(steps);
            if inside.contains(&bounds) && kept.iter().all(free) {
                let (smallest, plain) = (line.smallest(), line.plain.clone());
                let halo = false;
                let item = Item::Text {
                    line,
                    at,
                    ink,
                    halo,
                };
                kept.push(Put {
                    steps,
                    bounds,
                    smallest,
                    plain,
                    rimmed: false,
                    item,
                });
            } else {
                lost.push(line.plain);
            }
        }
        (kept, lost)
    }
}

/// Whether a shape is nothing but paper.
fn is_bare_paper(item: &Item) -> bool {
    match item {
        Item::Shape {
            fill: Some((Paint::Solid(ink), _)),
            stroke: None,
            ..
        } => ink.role == Role::Paper,
        _ => false,
    }
}

impl Drawing {
    /// Everything times `zoom` but the widths of lines, every length rounded.
    fn zoomed(self, zoom: f64) -> Drawing {
        let rect = |r: Rect| Rect::new(round(r.min * zoom), round(r.max * zoom));
        let item = |item: Item| match item {
            Item::Shape { path, fill, stroke } => Item::Shape {
                path: path.map(|p| round(p * zoom)),
                fill: fill.map(|(paint, rule)| (paint.zoomed(zoom).rounded(), rule)),
                stroke: stroke.map(|pen| pen.zoomed(zoom).rounded()),
            },
            Item::Picture { place, picture } => Item::Picture {
                place: rect(place),
                picture,
            },
            Item::Text {
                line,
                at,
                ink,
                halo,
            } => Item::Text {
                line: line.scaled(zoom),
                at: round(at * zoom),
                ink,
                halo,
            },
        };
        let label = |label: LabelBox| LabelBox {
            bounds: rect(label.bounds),
            smallest: label.smallest * zoom,
            text: label.text,
        };
        Drawing {
            canvas: round(self.canvas * zoom),
            items: self.items.into_iter().map(item).collect(),
            labels: self.labels.into_iter().map(label).collect(),
            ..self
        }
    }
}
