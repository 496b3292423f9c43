//! Pictures of solids: faces tinted by orientation, edges where they fold or end.

mod edges;
mod painted;
mod pixels;
pub mod sight;

use ombra_math::glam::{DVec2, DVec3};
use ombra_math::mesh::{Edge, Mesh};

use crate::colour::{Ink, Role};
use crate::drawing::{NORMAL, Pen, THIN};
use crate::error::FigureError;
use crate::object::LABELLED;
use crate::path::Path;
use crate::sheet::Sheet;
use crate::space::View;
use crate::style::Theme;
use crate::words::{Word, words};

/// Two faces that meet under less than this cosine show their edge: 30°.
const CREASE: f64 = 0.866_025_403_784_438_6;

/// The edges where a mesh folds or ends, as pairs of vertices.
pub fn creases(mesh: &Mesh) -> Vec<[usize; 2]> {
    let normal = |face: Option<u32>| {
        let [a, b, c] = mesh.triangle(usize::try_from(face?).ok()?)?;
        Some((b - a).cross(c - a).normalize_or_zero())
    };
    let folds = |edge: &Edge| match (normal(edge.left), normal(edge.right)) {
        (Some(left), Some(right)) => left.dot(right) < CREASE,
        _ => true,
    };
    let ends = |edge: Edge| {
        let end = |i: u32| usize::try_from(i).ok();
        Some([end(edge.from)?, end(edge.to)?])
    };
    let edges = mesh.edges();
    edges.into_iter().filter(folds).filter_map(ends).collect()
}

/// Draws a mesh, whatever of it is in front hiding what is behind. Back edges are dashed for a mesh of at most 16
/// vertices and left out otherwise.
///
/// # Errors
///
/// [`FigureError::Scene`] when a mesh of more than [`MOST_PAINTED`] triangles cannot be drawn by the z-buffer.
pub fn mesh(sheet: &mut Sheet, view: &View, mesh: &Mesh, role: Role) -> Result<(), FigureError> {
    let solid = Solid::new(view, mesh, role, sheet.style().theme);
    let edges = if is_painted(mesh) {
        painted::draw(sheet, view, &solid);
        edges::visible(view, &solid)
    } else {
        pixels::draw(sheet, view, &solid)?
    };
    sheet.stroke(edges, Pen::new(role, NORMAL));
    if mesh.positions.len() <= LABELLED {
        let pen = Pen::new(Ink::of(role).tint(0.8), THIN).dashed();
        sheet.stroke(solid.back, pen);
    }
    Ok(())
}

/// Most triangles of a solid whose faces are shapes of their own, in the order of the painter's algorithm. The picture
/// of a larger one is made of pixels, by a z-buffer: its file would grow beyond what is shown at once, and faces that
/// cross are cut into very many pieces.
pub const MOST_PAINTED: usize = 4096;

fn is_painted(mesh: &Mesh) -> bool {
    mesh.triangles.len() <= MOST_PAINTED
}

words! {
    /// Below a figure of a solid too large to paint.
    BY_PIXELS {
        en: "The object has so many faces that its picture comes from a z-buffer.",
        it: "L’oggetto ha così tante facce che la sua immagine viene da uno z-buffer.",
        cs: "Těleso má tolik stěn, že jeho obraz pochází ze z-bufferu.",
        hr: "Objekt ima toliko stranica da njegova slika dolazi iz z-spremnika.",
    }
}

/// What the caption has to say of how the picture of a solid is made.
pub(crate) fn note(mesh: &Mesh) -> Option<Word> {
    (!is_painted(mesh)).then_some(BY_PIXELS)
}

/// A mesh as the eye sees it.
struct Solid {
    /// The triangles that can be seen: of a closed mesh those turned to the eye, of an open one its inside too.
    faces: Vec<Face>,
    /// The ends of edges where the mesh folds or ends, unless it is turned away on both sides.
    edges: Vec<[DVec3; 2]>,
    /// The edges between faces that are turned away.
    back: Path,
}

/// A triangle, and its tint.
struct Face {
    corners: [DVec3; 3],
    ink: Ink,
}

impl Solid {
    fn new(view: &View, mesh: &Mesh, role: Role, theme: Theme) -> Solid {
        /// A triangle in front of the eye.
        struct Seen {
            normal: DVec3,
            front: bool,
        }
        let flat: Vec<Option<DVec2>> = mesh.positions.iter().map(|&p| view.project(p)).collect();
        let at = |i: u32| flat.get(usize::try_from(i).ok()?).copied().flatten();
        let edges = mesh.edges();
        let is_closed = edges
            .iter()
            .all(|edge| edge.left.is_some() && edge.right.is_some());

        let mut faces = Vec::new();
        let seen: Vec<Option<Seen>> = (0..)
            .zip(&mesh.triangles)
            .map(|(i, &[p, q, r])| {
                let corners = mesh.triangle(i)?;
                let ([a, b, c], [u, v, w]) = (corners, [at(p)?, at(q)?, at(r)?]);
                let normal = (b - a).cross(c - a).normalize_or_zero();
                // Counter-clockwise in space is the negative side on a canvas whose y points down.
                let front = (v - u).perp_dot(w - u) < 0.0;
                if front || !is_closed {
                    let ink = tint(role, if front { normal } else { -normal }, theme);
                    faces.push(Face { corners, ink });
                }
                Some(Seen { normal, front })
            })
            .collect();

        let (mut folds, mut back) = (Vec::new(), Path::new());
        for edge in &edges {
            let beside = |face: Option<u32>| seen.get(usize::try_from(face?).ok()?)?.as_ref();
            let sides = [edge.left, edge.right].map(beside);
            let (shown, turned_away) = match sides {
                [Some(a), Some(b)] => (
                    a.front != b.front || a.normal.dot(b.normal) < CREASE,
                    !a.front && !b.front,
                ),
                _ => (true, false),
            };
            let (true, Some(from), Some(to)) = (shown, at(edge.from), at(edge.to)) else {
                continue;
            };
            if turned_away {
                back.add_polyline(&[from, to]);
                continue;
            }
            let end = |i: u32| mesh.positions.get(usize::try_from(i).ok()?).copied();
            if let (Some(a), Some(b)) = (end(edge.from), end(edge.to)) {
                folds.push([a, b]);
            }
        }
        Solid {
            faces,
            edges: folds,
            back,
        }
    }
}

/// The tint of a face: the more it looks up and to the front, the lighter; 64 steps.
fn tint(role: Role, normal: DVec3, theme: Theme) -> Ink {
    const LIT_FROM: DVec3 = DVec3::new(-0.05, 0.86, 0.50);
    let lit = (normal.dot(LIT_FROM) * 0.5 + 0.5).clamp(0.0, 1.0);
    let step = (lit * 64.0).round() / 64.0;
    let share = match theme {
        Theme::Light => 0.82 - 0.72 * step,
        Theme::Dark => 0.10 + 0.55 * step,
    };
    Ink::of(role).tint(share)
}

#[cfg(test)]
mod tests;
