//! Figures of the hidden surfaces lecture.

mod back_face;
mod depth_precision;
mod image_space_ray;
mod object_space_pairs;
mod painter_cycle;
mod painter_steps;
mod stage;
mod zbuffer_steps;

use crate::colour::Role;
use crate::figure::Figure;

/// In the order of the lecture.
pub(crate) const FIGURES: &[Figure] = &[
    object_space_pairs::FIGURE,
    image_space_ray::FIGURE,
    painter_steps::FIGURE,
    painter_cycle::FIGURE,
    zbuffer_steps::FIGURE,
    depth_precision::FIGURE,
    back_face::FIGURE,
];

/// Names and colours of primitives.
const PRIMITIVES: [(&str, Role); 4] = [
    ("*A*", Role::Occluder),
    ("*B*", Role::Receiver),
    ("*C*", Role::Curve(3)),
    ("*D*", Role::Curve(2)),
];

/// Share of its colour in the area of a primitive.
const AREA: f64 = 0.34;

/// What tests ask of a drawing.
#[cfg(test)]
mod drawn {
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
}
