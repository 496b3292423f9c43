//! The outline of a solid cut across, face by face.

use core::cmp::Ordering;
use std::collections::BTreeMap;

use ombra_math::glam::{DVec2, DVec3};
use ombra_math::mesh::Mesh;
use ombra_math::predicates::orient_2d;

use crate::path::Rect;

/// A face of the solid, cut.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Face {
    /// From one end to the other, the solid on the left.
    pub(super) ends: [DVec2; 2],
    /// Out of the solid.
    pub(super) normal: DVec2,
}

impl Face {
    pub(super) fn middle(&self) -> DVec2 {
        let [a, b] = self.ends;
        (a + b) * 0.5
    }
}

/// Faces that follow each other.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Chain {
    pub(super) faces: Vec<Face>,
    /// Whether the first follows the last.
    pub(super) closed: bool,
}

/// A prism across its faces, its corners counter-clockwise.
pub(super) fn of_prism(corners: &[DVec2]) -> Chain {
    let ends = corners.iter().zip(corners.iter().cycle().skip(1));
    let face = |(&a, &b): (&DVec2, &DVec2)| Face {
        ends: [a, b],
        normal: -(b - a).perp(),
    };
    Chain {
        faces: ends.map(face).collect(),
        closed: true,
    }
}

/// The corners of a polygon counter-clockwise, if its sides neither cross nor touch but at the corners between two of
/// them, and it bounds an area. A corner given twice running is one.
pub(super) fn simple(polygon: &[DVec2]) -> Option<Vec<DVec2>> {
    let mut corners = polygon.to_vec();
    corners.dedup();
    if corners.len() > 1 && corners.first() == corners.last() {
        corners.pop();
    }
    let n = corners.len();
    if n < 3 {
        return None;
    }
    let ends = corners
        .iter()
        .copied()
        .zip(corners.iter().copied().cycle().skip(1));
    let sides: Vec<(DVec2, DVec2)> = ends.collect();
    for (i, &(a, b)) in sides.iter().enumerate() {
        for (j, &(c, d)) in sides.iter().enumerate().skip(i + 1) {
            let parted = if j == i + 1 || (i == 0 && j == n - 1) {
                // Neighbours: they may go on, but not back.
                let (from, corner, to) = if b == c { (a, b, d) } else { (c, d, b) };
                side(from, corner, to)? != Ordering::Equal || (corner - from).dot(to - corner) > 0.0
            } else {
                !meet([a, b], [c, d])?
            };
            if !parted {
                return None;
            }
        }
    }
    let area: f64 = sides.iter().map(|(a, b)| a.perp_dot(*b)).sum();
    if area < 0.0 {
        corners.reverse();
    }
    (area != 0.0).then_some(corners)
}

/// Whether two segments have a point in common.
fn meet([a, b]: [DVec2; 2], [c, d]: [DVec2; 2]) -> Option<bool> {
    let of_first = [side(a, b, c)?, side(a, b, d)?];
    let of_second = [side(c, d, a)?, side(c, d, b)?];
    if of_first == [Ordering::Equal; 2] {
        // On one line: told apart by their boxes.
        let apart = a.max(b).cmplt(c.min(d)) | c.max(d).cmplt(a.min(b));
        return Some(!apart.any());
    }
    let parts = |[one, other]: [Ordering; 2]| one != other;
    Some(parts(of_first) && parts(of_second))
}

fn side(a: DVec2, b: DVec2, p: DVec2) -> Option<Ordering> {
    orient_2d(a, b, p)
}

/// Planes to cut an object by, the first that meets it: across z, x, y. The axis, and what points right and up.
const CUTS: [[DVec3; 3]; 3] = [
    [DVec3::Z, DVec3::X, DVec3::Y],
    [DVec3::X, DVec3::NEG_Z, DVec3::Y],
    [DVec3::Y, DVec3::Z, DVec3::X],
];

/// An object cut through the middle of its box; nothing if no such plane parts any of its triangles.
pub(super) fn of_mesh(mesh: &Mesh) -> Vec<Chain> {
    let Some([low, high]) = mesh.bounds() else {
        return Vec::new();
    };
    let centre = low * 0.5 + high * 0.5;
    let cuts = CUTS.iter().map(|[axis, right, up]| {
        let flat = |p: DVec3| DVec2::new(p.dot(*right), p.dot(*up));
        cut(mesh, |p| (p - centre).dot(*axis), flat)
    });
    cuts.into_iter()
        .find(|chains| !chains.is_empty())
        .unwrap_or_default()
}

/// An edge of the mesh, the lower corner first.
type Edge = (u32, u32);

/// The part of a triangle in the plane, between two of its edges.
struct Piece {
    from: Edge,
    to: Edge,
    face: Face,
}

/// The mesh where `height` is 0.
fn cut(mesh: &Mesh, height: impl Fn(DVec3) -> f64, flat: impl Fn(DVec3) -> DVec2) -> Vec<Chain> {
    let crossing = |i: u32, a: DVec3, j: u32, b: DVec3| {
        // Both triangles of an edge compute the same point.
        let ((i, a), (j, b)) = if i < j {
            ((i, a), (j, b))
        } else {
            ((j, b), (i, a))
        };
        let (above, below) = (height(a), height(b));
        ((i, j), flat(a + (b - a) * (above / (above - below))))
    };
    let piece = |index: usize| {
        let corners = mesh.triangle(index)?;
        let numbers = *mesh.triangles.get(index)?;
        // A corner in the plane counts as above it, so a triangle has two edges through it or none.
        let is_above = corners.map(|p| height(p) >= 0.0);
        let edge = |from: usize| {
            let to = (from + 1) % 3;
            let (i, j) = (*numbers.get(from)?, *numbers.get(to)?);
            Some(crossing(i, *corners.get(from)?, j, *corners.get(to)?))
        };
        let side = |at: usize| is_above.get(at).copied();
        let leaves = (0..3).find(|&k| side(k) == Some(true) && side((k + 1) % 3) == Some(false))?;
        let enters = (0..3).find(|&k| side(k) == Some(false) && side((k + 1) % 3) == Some(true))?;
        let ((from, a), (to, b)) = (edge(leaves)?, edge(enters)?);
        let [p, q, r] = corners;
        let normal = flat((q - p).cross(r - p));
        let ends = [a, b];
        Some(Piece {
            from,
            to,
            face: Face { ends, normal },
        })
    };
    chains((0..mesh.triangles.len()).filter_map(piece).collect())
}

/// Pieces in the order in which they share edges.
fn chains(pieces: Vec<Piece>) -> Vec<Chain> {
    let mut left: BTreeMap<Edge, Vec<Piece>> = BTreeMap::new();
    let mut entered: BTreeMap<Edge, usize> = BTreeMap::new();
    for piece in pieces {
        *entered.entry(piece.to).or_default() += 1;
        left.entry(piece.from).or_default().push(piece);
    }
    let mut chains = Vec::new();
    // Those that nothing leads to begin open chains; all others lie on closed ones.
    let starts = left.keys().filter(|edge| !entered.contains_key(edge));
    let starts: Vec<Edge> = starts.copied().collect();
    let mut starts = starts.into_iter();
    loop {
        let start = starts.next().or_else(|| left.keys().next().copied());
        let Some(start) = start else { return chains };
        let (mut faces, mut at) = (Vec::new(), start);
        while let Some(piece) = take(&mut left, at) {
            at = piece.to;
            let [a, b] = piece.face.ends;
            // What only touches the plane has no length in it.
            if a != b && piece.face.normal.try_normalize().is_some() {
                faces.push(piece.face);
            }
            if at == start {
                break;
            }
        }
        if !faces.is_empty() {
            let closed = at == start;
            chains.push(Chain { faces, closed });
        }
    }
}

fn take(left: &mut BTreeMap<Edge, Vec<Piece>>, at: Edge) -> Option<Piece> {
    let pieces = left.get_mut(&at)?;
    let piece = pieces.pop();
    if pieces.is_empty() {
        left.remove(&at);
    }
    piece
}

/// The box around all faces.
pub(super) fn bounds(chains: &[Chain]) -> Option<Rect> {
    let ends = chains
        .iter()
        .flat_map(|chain| &chain.faces)
        .flat_map(|face| face.ends);
    ends.map(|p| Rect::new(p, p))
        .reduce(|a, b| Rect::new(a.min.min(b.min), a.max.max(b.max)))
}
