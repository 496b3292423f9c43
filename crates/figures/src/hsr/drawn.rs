//! What tests ask of a drawing.

use crate::colour::Ink;
use crate::drawing::{Drawing, Item, Paint};
use crate::error::FigureError;
use crate::path::Path;
use crate::sheet::Sheet;
use crate::style::Style;

pub(super) fn drawn(draw: impl Fn(&mut Sheet) -> Result<(), FigureError>) -> Drawing {
    let mut sheet = Sheet::new(&Style::default(), "").unwrap();
    draw(&mut sheet).unwrap();
    sheet.finish("hsr/test", "").unwrap()
}

pub(super) fn shapes(drawing: &Drawing) -> Vec<Item> {
    let is_shape = |item: &&Item| matches!(item, Item::Shape { .. });
    drawing.items.iter().filter(is_shape).cloned().collect()
}

/// Every area with its ink, from the back to the front.
pub(super) fn fills(drawing: &Drawing) -> Vec<(Ink, &Path)> {
    let fill = |item| match item {
        &Item::Shape {
            ref path,
            fill: Some((Paint::Solid(ink), _)),
            ..
        } => Some((ink, path)),
        _ => None,
    };
    drawing.items.iter().filter_map(fill).collect()
}

/// How many areas have one ink.
pub(super) fn areas(drawing: &Drawing, ink: Ink) -> usize {
    let fills = fills(drawing);
    fills.iter().filter(|(of, _)| *of == ink).count()
}
