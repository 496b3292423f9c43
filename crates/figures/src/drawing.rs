//! The display list that SVG, PNG and PDF are written from.
//!
//! Lengths are thousandths of the canvas's shorter side, so a figure holds at any size; the origin is the upper left
//! corner, x points right, y down. Coordinates are rounded to hundredths when they enter the list ([`round`]), so that
//! all writers see the same numbers and the bytes are the same on every machine.

use ombra_math::glam::DVec2;

use crate::colour::Ink;
use crate::path::{Path, Rect, round, round_length};
use crate::style::Style;
use crate::text::Line;

/// Line width of grids, rays and dashes.
pub const THIN: f64 = 2.5;
/// Line width of what the figure is about.
pub const NORMAL: f64 = 4.0;
/// Line width of what is to be seen first.
pub const EMPHASIS: f64 = 7.0;
/// Free border of the canvas.
pub const MARGIN: f64 = 40.0;
/// Width of the rim of paper around a label.
pub const HALO: f64 = 5.0;

/// What fills an area or colours a line.
#[derive(Clone, Debug, PartialEq)]
pub enum Paint {
    /// One ink.
    Solid(Ink),
    /// Inks along a line.
    Linear {
        /// Where offset 0 lies.
        from: DVec2,
        /// Where offset 1 lies.
        to: DVec2,
        /// Offsets in 0..=1, rising, with their inks.
        stops: Vec<(f64, Ink)>,
    },
    /// Inks from a centre outwards.
    Radial {
        /// Where offset 0 lies.
        centre: DVec2,
        /// Distance of offset 1.
        radius: f64,
        /// Offsets in 0..=1, rising, with their inks.
        stops: Vec<(f64, Ink)>,
    },
}

impl<T: Into<Ink>> From<T> for Paint {
    fn from(ink: T) -> Paint {
        Paint::Solid(ink.into())
    }
}

impl Paint {
    /// Every length times `zoom`.
    pub(crate) fn zoomed(self, zoom: f64) -> Paint {
        match self {
            Paint::Solid(ink) => Paint::Solid(ink),
            Paint::Linear { from, to, stops } => Paint::Linear {
                from: from * zoom,
                to: to * zoom,
                stops,
            },
            Paint::Radial {
                centre,
                radius,
                stops,
            } => Paint::Radial {
                centre: centre * zoom,
                radius: radius * zoom,
                stops,
            },
        }
    }

    /// Every length to hundredths.
    pub(crate) fn rounded(self) -> Paint {
        match self {
            Paint::Solid(ink) => Paint::Solid(ink),
            Paint::Linear { from, to, stops } => Paint::Linear {
                from: round(from),
                to: round(to),
                stops,
            },
            Paint::Radial {
                centre,
                radius,
                stops,
            } => Paint::Radial {
                centre: round(centre),
                radius: round_length(radius),
                stops,
            },
        }
    }
}

/// Which points of a path with several contours are inside.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FillRule {
    /// Those that contours wind around at all.
    NonZero,
    /// Those that contours cross an odd number of times on the way out.
    EvenOdd,
}

/// How a line is drawn; ends and corners are round.
#[derive(Clone, Debug, PartialEq)]
pub struct Pen {
    /// Its colour.
    pub paint: Paint,
    /// Its width.
    pub width: f64,
    /// Lengths of dash and gap; round ends make the dash longer by the width.
    pub dash: Option<(f64, f64)>,
}

impl Pen {
    /// A full line.
    pub fn new(paint: impl Into<Paint>, width: f64) -> Pen {
        Pen {
            paint: paint.into(),
            width,
            dash: None,
        }
    }

    /// The same line dashed, in the house's one rhythm.
    pub fn dashed(self) -> Pen {
        Pen {
            dash: Some((9.0, 11.0)),
            ..self
        }
    }

    /// The paint's lengths and the dashes times `zoom`; the width stays, so that no line gets too thin to be seen.
    pub(crate) fn zoomed(self, zoom: f64) -> Pen {
        Pen {
            paint: self.paint.zoomed(zoom),
            width: self.width,
            dash: self.dash.map(|(dash, gap)| (dash * zoom, gap * zoom)),
        }
    }

    /// Every length to hundredths.
    pub(crate) fn rounded(self) -> Pen {
        Pen {
            paint: self.paint.rounded(),
            width: round_length(self.width),
            dash: self
                .dash
                .map(|(dash, gap)| (round_length(dash), round_length(gap))),
        }
    }

    /// The same line dotted.
    pub fn dotted(self) -> Pen {
        Pen {
            dash: Some((0.01, 10.0)),
            ..self
        }
    }
}

/// Pixels, row by row from the upper left: red, green, blue, each times how opaque the pixel is, and that.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// Pixels across and down.
    pub size: (u32, u32),
    /// Four bytes a pixel.
    pub rgba: Vec<u8>,
}

/// One thing drawn.
#[derive(Clone, Debug, PartialEq)]
pub enum Item {
    /// An outline, filled, stroked or both.
    Shape {
        /// The outline.
        path: Path,
        /// What fills it.
        fill: Option<(Paint, FillRule)>,
        /// What is drawn along it, above the filling.
        stroke: Option<Pen>,
    },
    /// A picture made of pixels.
    Picture {
        /// Where it goes.
        place: Rect,
        /// Its pixels.
        picture: Picture,
    },
    /// A label.
    Text {
        /// Its letters.
        line: Line,
        /// Start of its baseline.
        at: DVec2,
        /// Their colour.
        ink: Ink,
        /// Whether a rim of paper runs around them.
        halo: bool,
    },
}

/// Where a label lies, for tests that no two meet.
#[derive(Clone, Debug, PartialEq)]
pub struct LabelBox {
    /// Its extent, rim included.
    pub bounds: Rect,
    /// Its smallest letters.
    pub smallest: f64,
    /// What it says.
    pub text: String,
}

/// A figure ready to be written: [`crate::svg::svg`], [`crate::png::png`], [`crate::pdf::pdf`].
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Drawing {
    /// The figure's id, `shadows/cube-infinity`.
    pub id: String,
    /// One line that says what it shows.
    pub title: String,
    /// What it was drawn for.
    pub style: Style,
    /// Width and height in thousandths of the shorter side.
    pub canvas: DVec2,
    /// From the back to the front.
    pub items: Vec<Item>,
    /// Where its labels lie.
    pub labels: Vec<LabelBox>,
    /// What labels say for which there is no place.
    pub over: Vec<String>,
}
