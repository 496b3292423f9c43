//! Marks at points of space, where these can be seen.

use ombra_math::glam::{DVec2, DVec3};

use crate::colour::Ink;
use crate::drawing::{NORMAL, Pen};
use crate::marks;
use crate::path::Path;
use crate::sheet::{Label, Sheet};
use crate::space::View;

/// A named point of space, if it can be seen.
pub(super) fn point(
    sheet: &mut Sheet,
    view: &View,
    p: DVec3,
    ink: impl Into<Ink>,
    label: Option<(&str, DVec2)>,
) {
    let Some(at) = view.project(p) else { return };
    marks::point(sheet, at, ink);
    if let Some((name, towards)) = label {
        sheet.label(Label::new(at, name).towards(towards).beside());
    }
}

/// A line through points of space, if all can be seen.
pub(super) fn polyline(sheet: &mut Sheet, view: &View, points: &[DVec3], pen: Pen) {
    if let Some(points) = view.contour(points) {
        sheet.stroke(Path::polyline(&points), pen);
    }
}

/// An arrow between points of space.
pub(super) fn arrow(sheet: &mut Sheet, view: &View, from: DVec3, to: DVec3, ink: impl Into<Ink>) {
    if let Some((from, to)) = view.segment(from, to) {
        marks::arrow(sheet, from, to, ink, NORMAL);
    }
}
