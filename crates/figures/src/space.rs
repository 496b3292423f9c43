//! Figures of space: one house perspective, ground grid, axes, meshes.
//!
//! The eye always looks from the same side (from the left of +z, a little above), so that a student who has read one
//! figure has read the axes of all. What is shown is fitted to the canvas; the distance grows with it, so that the
//! perspective is equally strong in every figure.

use ombra_math::glam::{DVec2, DVec3};
use ombra_math::mesh::{Edge, Mesh};

use crate::colour::{Ink, Role};
use crate::drawing::{NORMAL, Pen, THIN};
use crate::error::FigureError;
use crate::path::{Path, Rect};
use crate::sheet::{Label, Sheet};
use crate::style::Theme;

/// From the scene towards the eye; its length does not matter.
const TOWARDS_EYE: DVec3 = DVec3::new(-0.50, 0.46, 0.80);
/// Distance of the eye from the middle of the scene, in radii of the scene.
const DISTANCE: f64 = 4.5;
/// The same where perspective is not to show: sizes differ by a millionth at most.
const AFAR: f64 = 1e6;
/// Two faces that meet under less than this cosine show their edge: 30°.
const CREASE: f64 = 0.866_025_403_784_438_6;

/// The house perspective, fitted to what a figure shows.
#[derive(Clone, Copy, Debug)]
pub struct View {
    eye: DVec3,
    right: DVec3,
    up: DVec3,
    forward: DVec3,
    radius: f64,
    scale: f64,
    offset: DVec2,
}

impl View {
    /// Fits `shown` into `frame`.
    ///
    /// # Errors
    ///
    /// [`FigureError::Scene`] when `shown` is empty, a single point, or too large to compute with.
    pub fn fit(shown: &[DVec3], frame: Rect) -> Result<View, FigureError> {
        View::fit_from(shown, frame, DISTANCE)
    }

    /// The same from so far away that nothing shrinks with its distance.
    ///
    /// # Errors
    ///
    /// Those of [`View::fit`].
    pub fn fit_from_afar(shown: &[DVec3], frame: Rect) -> Result<View, FigureError> {
        View::fit_from(shown, frame, AFAR)
    }

    /// From the scene towards the eye, of length 1.
    pub fn towards_eye() -> DVec3 {
        TOWARDS_EYE.normalize()
    }

    fn fit_from(shown: &[DVec3], frame: Rect, distance: f64) -> Result<View, FigureError> {
        let wrong = || {
            FigureError::Scene {
            reason: "nothing to show: the points of the figure are too few, too far or too close together".to_owned(),
        }
        };
        let first = *shown.first().ok_or_else(wrong)?;
        let (min, max) = shown
            .iter()
            .fold((first, first), |(min, max), &p| (min.min(p), max.max(p)));
        let centre = min * 0.5 + max * 0.5;
        let radius = shown.iter().map(|p| p.distance(centre)).fold(0.0, f64::max);
        let forward = -TOWARDS_EYE.normalize();
        let right = forward.cross(DVec3::Y).normalize();
        let mut view = View {
            eye: centre - forward * (radius * distance),
            right,
            up: right.cross(forward),
            forward,
            radius,
            scale: 1.0,
            offset: DVec2::ZERO,
        };
        let flat: Vec<DVec2> = shown.iter().filter_map(|&p| view.project(p)).collect();
        let start = *flat.first().ok_or_else(wrong)?;
        let (low, high) = flat
            .iter()
            .fold((start, start), |(low, high), &p| (low.min(p), high.max(p)));
        let ratio = frame.size() / (high - low);
        view.scale = ratio.x.min(ratio.y);
        view.offset = frame.centre() - (low + high) * 0.5 * view.scale;
        let usable =
            radius > 0.0 && radius.is_finite() && view.scale.is_finite() && view.offset.is_finite();
        if usable { Ok(view) } else { Err(wrong()) }
    }

    /// Where a point appears; none for what is not well in front of the eye.
    pub fn project(&self, p: DVec3) -> Option<DVec2> {
        let d = p - self.eye;
        let depth = d.dot(self.forward);
        let at =
            DVec2::new(d.dot(self.right), -d.dot(self.up)) * (self.radius / depth) * self.scale
                + self.offset;
        (depth > 0.1 * self.radius && at.is_finite()).then_some(at)
    }

    /// How large things appear; only views of the same points compare.
    pub fn scale(&self) -> f64 {
        self.scale
    }

    /// Where the eye is.
    pub fn eye(&self) -> DVec3 {
        self.eye
    }

    /// Distance from the eye along the view.
    pub fn depth(&self, p: DVec3) -> f64 {
        (p - self.eye).dot(self.forward)
    }

    /// A contour on the canvas; none if a point of it cannot be seen.
    pub fn contour(&self, points: &[DVec3]) -> Option<Vec<DVec2>> {
        points.iter().map(|&p| self.project(p)).collect()
    }

    /// The part of a segment in front of the eye.
    pub fn segment(&self, a: DVec3, b: DVec3) -> Option<(DVec2, DVec2)> {
        let near = 0.2 * self.radius;
        let (da, db) = (self.depth(a), self.depth(b));
        let cut = |from: DVec3, to: DVec3, d_from: f64, d_to: f64| {
            from + (to - from) * ((near - d_from) / (d_to - d_from))
        };
        let (a, b) = match (da > near, db > near) {
            (true, true) => (a, b),
            (true, false) => (a, cut(b, a, db, da)),
            (false, true) => (cut(a, b, da, db), b),
            (false, false) => return None,
        };
        Some((self.project(a)?, self.project(b)?))
    }
}

/// Three short labelled arrows at the origin, `length` long in space.
pub fn axes(sheet: &mut Sheet, view: &View, length: f64) {
    let Some(origin) = view.project(DVec3::ZERO) else {
        return;
    };
    for (axis, name) in [(DVec3::X, "*x*"), (DVec3::Y, "*y*"), (DVec3::Z, "*z*")] {
        if let Some(tip) = view.project(axis * length) {
            crate::marks::arrow(sheet, origin, tip, Role::Axis, NORMAL);
            let label = Label::new(tip, name).towards(tip - origin).ink(Role::Axis);
            sheet.label(label.beside());
        }
    }
}

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

/// Draws a mesh: faces tinted by orientation from the back to the front, edges where it folds or ends. Back edges are
/// dashed for a mesh of at most 16 vertices and left out otherwise.
pub fn mesh(sheet: &mut Sheet, view: &View, mesh: &Mesh, role: Role) {
    let few = mesh.positions.len() <= crate::object::LABELLED;
    let flat: Vec<Option<DVec2>> = mesh.positions.iter().map(|&p| view.project(p)).collect();

    let face = |&[i, j, k]: &[u32; 3]| {
        let corner = |i: u32| {
            let i = usize::try_from(i).ok()?;
            Some((*mesh.positions.get(i)?, (*flat.get(i)?)?))
        };
        let ((a, a2), (b, b2), (c, c2)) = (corner(i)?, corner(j)?, corner(k)?);
        Some(Face {
            corners: [a2, b2, c2],
            normal: (b - a).cross(c - a).normalize_or_zero(),
            depth: view.depth((a + b + c) / 3.0),
            front: (b2 - a2).perp_dot(c2 - a2) < 0.0,
        })
    };
    let faces: Vec<Option<Face>> = mesh.triangles.iter().map(face).collect();
    let edges = mesh.edges();

    // Painter's order: the farthest first, an edge after the faces it bounds. An open mesh shows its inside too.
    let closed = edges
        .iter()
        .all(|edge| edge.left.is_some() && edge.right.is_some());
    let mut pieces: Vec<(f64, Piece)> = Vec::new();
    for face in faces.iter().flatten().filter(|face| face.front || !closed) {
        let towards_eye = if face.front {
            face.normal
        } else {
            -face.normal
        };
        let ink = tint(role, towards_eye, sheet.style().theme);
        pieces.push((face.depth, Piece::Face(ink, face.corners)));
    }
    let mut back = Path::new();
    for edge in &edges {
        let beside = |face: Option<u32>| faces.get(usize::try_from(face?).ok()?)?.as_ref();
        let sides: Vec<&Face> = [edge.left, edge.right]
            .into_iter()
            .filter_map(beside)
            .collect();
        let (fold, turned_away) = match sides[..] {
            [a, b] => (
                a.front != b.front || a.normal.dot(b.normal) < CREASE,
                !a.front && !b.front,
            ),
            _ => (true, false),
        };
        let end = |i: u32| flat.get(usize::try_from(i).ok()?).copied().flatten();
        let (true, Some(a), Some(b)) = (fold, end(edge.from), end(edge.to)) else {
            continue;
        };
        if turned_away {
            back.add_polyline(&[a, b]);
        } else {
            let depth = sides
                .iter()
                .map(|face| face.depth)
                .fold(f64::INFINITY, f64::min);
            pieces.push((depth, Piece::Edge(a, b)));
        }
    }
    // Stable, and faces came first: at equal depth the edge lies above.
    pieces.sort_by(|a, b| b.0.total_cmp(&a.0));

    // Neighbours in the order that look alike become one path.
    let mut rest = pieces.into_iter().map(|(_, piece)| piece).peekable();
    while let Some(piece) = rest.next() {
        match piece {
            Piece::Face(ink, corners) => {
                let mut path = Path::polygon(&corners);
                while let Some(Piece::Face(_, corners)) =
                    rest.next_if(|next| matches!(next, Piece::Face(other, _) if *other == ink))
                {
                    path.add_polygon(&corners);
                }
                // A hairline of its own colour closes the seams to its neighbours.
                sheet.fill_unmarked(path, ink, Pen::new(ink, 1.0));
            }
            Piece::Edge(a, b) => {
                let mut path = Path::line(a, b);
                while let Some(Piece::Edge(a, b)) =
                    rest.next_if(|next| matches!(next, Piece::Edge(..)))
                {
                    path.add_polyline(&[a, b]);
                }
                sheet.stroke(path, Pen::new(role, NORMAL));
            }
        }
    }
    if few {
        sheet.stroke(back, Pen::new(Ink::of(role).tint(0.8), THIN).dashed());
    }
}

/// A triangle as it appears; a front face runs counter-clockwise in space, so it turns to the negative side on a canvas
/// whose y points down.
struct Face {
    corners: [DVec2; 3],
    normal: DVec3,
    depth: f64,
    front: bool,
}

/// What the painter paints.
enum Piece {
    Face(Ink, [DVec2; 3]),
    Edge(DVec2, DVec2),
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
