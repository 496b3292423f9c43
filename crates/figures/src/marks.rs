//! The marks that roles have in all figures: sun, parallel arrows, eye, points, arrows, rays, normals.

use ombra_math::glam::DVec2;

use crate::colour::{Ink, Role};
use crate::drawing::{EMPHASIS, NORMAL, Pen, THIN};
use crate::path::{Path, Segment};
use crate::sheet::Sheet;

/// Radius of a point's dot.
pub const DOT: f64 = 7.0;
/// How far the sun reaches around its place.
pub const SUN: f64 = 34.0;

/// A light at a place: a disc with eight rays.
pub fn sun(sheet: &mut Sheet, at: DVec2) {
    sheet.dot(at, 0.47 * SUN, Role::Light);
    let mut rays = Path::new();
    // Eighths of a circle from (1, 0), without a sine.
    let (s, diagonal) = (1.0, core::f64::consts::FRAC_1_SQRT_2);
    for (x, y) in [
        (s, 0.0),
        (0.0, s),
        (diagonal, diagonal),
        (diagonal, -diagonal),
    ] {
        let d = DVec2::new(x, y);
        for d in [d, -d] {
            rays.add_polyline(&[at + d * (0.68 * SUN), at + d * SUN]);
        }
    }
    sheet.stroke(rays, Pen::new(Role::Light, NORMAL));
}

/// A light at infinity: parallel arrows along the light's travel, each from its start to its tip.
pub fn bundle(sheet: &mut Sheet, arrows: &[(DVec2, DVec2)]) {
    for &(from, to) in arrows {
        arrow(sheet, from, to, Role::Light, NORMAL);
    }
}

/// An arrow whose tip is at `to`.
pub fn arrow(sheet: &mut Sheet, from: DVec2, to: DVec2, ink: impl Into<Ink>, width: f64) {
    let ink = ink.into();
    let Some(along) = (to - from).try_normalize() else {
        return;
    };
    let (head, half) = (12.0 + 2.5 * width, 3.0 + 1.25 * width);
    let head = head.min((to - from).length());
    let base = to - along * head;
    sheet.line(from, base + along * (0.3 * head), Pen::new(ink, width));
    let side = along.perp() * half;
    sheet.fill(
        Path::polygon(&[to, base + side, base + along * (0.2 * head), base - side]),
        ink,
    );
    sheet.avoid(&Path::line(from, to));
}

/// A ray: solid as far as light travels.
pub fn ray(sheet: &mut Sheet, from: DVec2, to: DVec2) {
    sheet.line(from, to, Pen::new(Role::Ray, THIN));
}

/// A ray from a sun at `sun`, from the rim of the mark on.
pub fn ray_from_sun(sheet: &mut Sheet, sun: DVec2, to: DVec2) {
    let along = to - sun;
    let rim = SUN + 6.0;
    if along.length() > rim {
        ray(sheet, sun + along.normalize_or_zero() * rim, to);
    }
}

/// What a ray would have gone on to: dashed.
pub fn stopped_ray(sheet: &mut Sheet, from: DVec2, to: DVec2) {
    sheet.line(from, to, Pen::new(Role::Ray, THIN).dashed());
}

/// A length between two places: a thin line with a stroke across at both ends, `aside` off the line between them.
/// Returns its middle.
pub fn dimension(sheet: &mut Sheet, a: DVec2, b: DVec2, aside: DVec2) -> DVec2 {
    let (a, b) = (a + aside, b + aside);
    let across = (b - a).normalize_or_zero().perp() * 9.0;
    let mut path = Path::line(a, b);
    path.add_polyline(&[a - across, a + across]);
    path.add_polyline(&[b - across, b + across]);
    sheet.stroke(path, Pen::new(Role::Note, THIN));
    (a + b) * 0.5
}

/// A normal: a green arrow.
pub fn normal(sheet: &mut Sheet, from: DVec2, to: DVec2) {
    arrow(sheet, from, to, Role::Normal, NORMAL);
}

/// A point, filled, with a rim of paper so that it stands out on lines.
pub fn point(sheet: &mut Sheet, at: DVec2, ink: impl Into<Ink>) {
    sheet.fill(Path::circle(at, DOT + 2.5), Role::Paper);
    sheet.dot(at, DOT, ink.into());
}

/// A point still to be decided: hollow.
pub fn hollow_point(sheet: &mut Sheet, at: DVec2, ink: impl Into<Ink>) {
    sheet.fill(Path::circle(at, DOT + 2.5), Role::Paper);
    sheet.stroke(Path::circle(at, DOT - 1.0), Pen::new(ink.into(), NORMAL));
}

/// The eye: a small open eye at `at` that looks along `towards`.
pub fn eye(sheet: &mut Sheet, at: DVec2, towards: DVec2) {
    let along = towards.normalize_or(DVec2::X);
    let place = |x: f64, y: f64| at + along * x + along.perp() * y;
    let mut lids = Path::new();
    for side in [-1.0, 1.0] {
        lids.segments.push(Segment::Move(place(-26.0, 0.0)));
        lids.segments.push(Segment::Quad(
            place(2.0, 26.0 * side),
            place(26.0, 6.0 * side),
        ));
    }
    sheet.stroke(lids, Pen::new(Role::Eye, NORMAL));
    sheet.stroke(
        Path::polyline(&[place(22.0, -9.0), place(25.0, 0.0), place(22.0, 9.0)]),
        Pen::new(Role::Eye, THIN),
    );
    sheet.dot(place(12.0, 0.0), 1.1 * EMPHASIS, Role::Eye);
}
