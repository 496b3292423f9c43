//! How curves are told apart.

use ombra_math::glam::DVec2;

use crate::colour::Role;
use crate::drawing::{NORMAL, Pen, THIN};
use crate::marks::DOT;
use crate::path::Path;
use crate::sheet::Sheet;

/// The colour of the n-th curve.
pub(super) fn curve(n: usize) -> u8 {
    (n % 6) as u8
}

/// The mark of a curve's points: each curve has its own shape, so that a grey print still teaches.
pub(super) fn mark(sheet: &mut Sheet, at: DVec2, curve: u8) {
    let r = 1.15 * DOT;
    let corners = |offsets: &[(f64, f64)]| {
        Path::polygon(
            &offsets
                .iter()
                .map(|&(x, y)| at + DVec2::new(x, y) * r)
                .collect::<Vec<_>>(),
        )
    };
    let path = match curve {
        0 | 5 => Path::circle(at, 0.95 * r),
        1 => corners(&[(-0.85, -0.85), (0.85, -0.85), (0.85, 0.85), (-0.85, 0.85)]),
        2 => corners(&[(0.0, -1.15), (1.1, 0.75), (-1.1, 0.75)]),
        3 => corners(&[(0.0, -1.2), (1.2, 0.0), (0.0, 1.2), (-1.2, 0.0)]),
        _ => corners(&[(0.0, 1.15), (1.1, -0.75), (-1.1, -0.75)]),
    };
    // The last of the six is hollow, since its shape is the first one's.
    let inside = if curve == 5 {
        Role::Paper
    } else {
        Role::Curve(curve)
    };
    sheet.avoid(&path);
    sheet.fill_unmarked(path, inside, Pen::new(Role::Curve(curve), THIN));
}

/// From one quartile to the other, with a short line across each end.
pub(super) fn bar(sheet: &mut Sheet, (from, to): (DVec2, DVec2), curve: u8) {
    let across = 0.9 * DOT * (to - from).normalize_or_zero().perp();
    let mut path = Path::line(from, to);
    path.add_polyline(&[from - across, from + across]);
    path.add_polyline(&[to - across, to + across]);
    sheet.stroke(path, Pen::new(Role::Curve(curve), THIN));
}

/// An upright bar behind the last point of a curve that ends before the others.
pub(super) fn stop(sheet: &mut Sheet, end: DVec2, curve: u8) {
    let at = end + DVec2::new(2.4 * DOT, 0.0);
    let half = DVec2::new(0.0, 2.6 * DOT);
    let pen = Pen::new(Role::Curve(curve), NORMAL);
    sheet.line(end, at, pen.clone());
    sheet.line(at - half, at + half, pen);
}
