//! The faces of a solid, painted from back to front as the painter's algorithm orders them.

use ombra_hsr::painter::order_by_cutting;
use ombra_hsr::polygon::Polygon;

use super::Solid;
use crate::drawing::Pen;
use crate::path::Path;
use crate::sheet::Sheet;
use crate::space::View;

/// Draws the faces, cut where there is no order without.
pub(super) fn draw(sheet: &mut Sheet, view: &View, solid: &Solid) {
    let faces = solid.faces.iter().map(|face| Polygon {
        vertices: face.corners.to_vec(),
    });
    let faces: Vec<Polygon> = faces.collect();
    let pieces = order_by_cutting(&faces, view.eye().extend(1.0));
    let mut tinted = pieces
        .iter()
        .filter_map(|(face, piece)| {
            Some((solid.faces.get(*face)?.ink, view.contour(&piece.vertices)?))
        })
        .peekable();
    while let Some((ink, corners)) = tinted.next() {
        // Neighbours in the order that look alike become one path.
        let mut path = Path::polygon(&corners);
        while let Some((_, corners)) = tinted.next_if(|(other, _)| *other == ink) {
            path.add_polygon(&corners);
        }
        // A hairline of its own colour closes the seams to its neighbours.
        sheet.fill_unmarked(path, ink, Pen::new(ink, 1.0));
    }
}
