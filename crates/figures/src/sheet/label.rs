//! What is asked of a label.

use ombra_math::glam::DVec2;

use crate::colour::{Ink, Role};
use crate::path::Rect;
use crate::text::LABEL;

/// A label for the sheet to place.
#[derive(Clone, Debug)]
pub struct Label {
    /// Its words in the markup of [`crate::text`].
    pub markup: String,
    /// What it stands beside.
    pub anchor: DVec2,
    /// How far the thing reaches around its anchor.
    pub reach: f64,
    /// The side it would rather have.
    pub towards: DVec2,
    /// Whether it may stand so far away that a line must lead to it, although it has a place beside its thing.
    pub may_lead: bool,
    /// Whether it may be left out where there is no place for it.
    pub optional: bool,
    /// Where it must stay; none for the whole sheet.
    pub within: Option<Rect>,
    /// Letter size.
    pub size: f64,
    /// Its colour.
    pub ink: Ink,
}

impl Label {
    /// A label of the usual size and colour, to the right of `anchor` if it is free there.
    pub fn new(anchor: DVec2, markup: impl Into<String>) -> Label {
        Label {
            markup: markup.into(),
            anchor,
            reach: 8.0,
            towards: DVec2::X,
            may_lead: true,
            optional: false,
            within: None,
            size: LABEL,
            ink: Role::Text.into(),
        }
    }

    /// The side it would rather have; y points down.
    pub fn towards(self, towards: DVec2) -> Label {
        Label { towards, ..self }
    }

    /// How far the labelled thing reaches around the anchor.
    pub fn reach(self, reach: f64) -> Label {
        Label { reach, ..self }
    }

    /// Right beside its thing, as long as there is any place.
    pub fn beside(self) -> Label {
        Label {
            may_lead: false,
            ..self
        }
    }

    /// Left out where there is no place for it.
    pub fn optional(self) -> Label {
        Label {
            optional: true,
            ..self
        }
    }

    /// Nowhere but in `frame`, such as its panel.
    pub fn within(self, frame: Rect) -> Label {
        Label {
            within: Some(frame),
            ..self
        }
    }

    /// Another colour.
    pub fn ink(self, ink: impl Into<Ink>) -> Label {
        Label {
            ink: ink.into(),
            ..self
        }
    }

    /// Another letter size.
    pub fn size(self, size: f64) -> Label {
        Label { size, ..self }
    }
}
