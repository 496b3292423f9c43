//! Where rings are many, planes order the pieces instead of pairs.
//!
//! What lies beyond the plane of a primitive hides nothing on the eye's side of it. So the plane divides the pieces, in
//! two wherever it passes through one, and each side is ordered in the same way:
//!
//! ```text
//! back to front:    what lies beyond the plane, what lies in it, what lies on the eye's side
//! ```
//!
//! That needs no ring and no pair, only sides, which are settled once, however vertices are rounded: a primitive is
//! done with when its plane has divided, and the pieces left are of fewer primitives on both sides. But a plane cuts
//! also what pairs would have ordered whole. So pieces are first told apart by pairs, into knots that lead to each
//! other, where a plane would cut and that was not done of late.

use ombra_math::work::{Count, Counter};

use super::cut::Planes;
use super::piece::{Knife, Piece};
use super::tree::Tree;
use crate::pair::rings;
use crate::polygon::Polygon;

/// Planes tried for a division.
const TRIED: usize = 8;

/// Pieces that are divided without being told apart.
const SMALL: usize = 16;

/// Pieces to be ordered.
struct Group<'a> {
    pieces: Vec<Piece<'a>>,
    /// How many they were when they were last told apart; 0 for pieces in one plane, which need no order.
    knot: usize,
}

/// The pieces back to front, as they are handed out.
pub(super) fn by_planes<'a>(
    planes: &Planes<'a>,
    pieces: Vec<Piece<'a>>,
    work: &mut impl Count,
) -> Vec<(usize, Polygon)> {
    let mut painted = Vec::with_capacity(pieces.len());
    // The next on top.
    let mut open = vec![Group {
        pieces,
        knot: usize::MAX,
    }];
    while let Some(group) = open.pop() {
        let n = group.pieces.len();
        let best = (n > 1 && group.knot > 0).then(|| best_plane(planes, &group.pieces, work));
        let Some((knife, division)) = best.flatten() else {
            // One, those of one plane, or none that is seen.
            painted.extend(group.pieces.into_iter().map(Piece::into_part));
            continue;
        };
        let is_free = division.cuts == 0 && division.near.min(division.far) >= n / TRIED;
        let is_large = n >= SMALL && n <= group.knot / 2;
        if !is_free && (is_large || group.knot == usize::MAX) {
            open.extend(knots(planes, group.pieces, work));
        } else {
            open.extend(divided(planes, group, knife));
        }
    }
    painted
}

/// What a plane would make of pieces.
#[derive(Default)]
struct Division {
    near: usize,
    far: usize,
    cuts: usize,
}

impl Division {
    /// A cut costs a piece; sides that are uneven, many divisions.
    fn cost(&self) -> usize {
        self.cuts + self.near.abs_diff(self.far) / TRIED
    }
}

/// The best of a few planes.
fn best_plane<'k>(
    planes: &'k Planes,
    pieces: &[Piece],
    work: &mut impl Count,
) -> Option<(&'k Knife, Division)> {
    let n = pieces.len();
    let tried = (0..TRIED.min(n)).filter_map(|i| pieces.get((2 * i + 1) * n / (2 * TRIED.min(n))));
    let knives = tried.filter_map(|piece| planes.knife(piece.source));
    let divisions = knives.map(|knife| {
        work.add(Counter::Comparisons, n as u64);
        (knife, division(pieces, knife))
    });
    let best = divisions.min_by_key(|(_, division)| division.cost());
    // Of pieces of which none is seen in the middle, any that is.
    best.or_else(|| {
        let knife = pieces.iter().find_map(|piece| planes.knife(piece.source))?;
        Some((knife, division(pieces, knife)))
    })
}

fn division(pieces: &[Piece], knife: &Knife) -> Division {
    let mut division = Division::default();
    for piece in pieces.iter().filter(|piece| piece.source != knife.source) {
        let side = piece.side_of(knife);
        division.cuts += usize::from(side.is_across);
        division.near += usize::from(side.is_near || side.is_across);
        division.far += usize::from(!side.is_near || side.is_across);
    }
    division
}

/// The pieces on the eye's side of a plane, in it, and beyond it.
fn divided<'a>(planes: &Planes<'a>, group: Group<'a>, knife: &Knife) -> [Group<'a>; 3] {
    let [mut near, mut on, mut far] = [(); 3].map(|()| Vec::new());
    for piece in group.pieces {
        if piece.source == knife.source {
            on.push(piece);
            continue;
        }
        let side = piece.side_of(knife);
        let own = planes.knife(piece.source).filter(|_| side.is_across);
        match own.and_then(|own| piece.halves(knife, own, planes.eye, &planes.view)) {
            Some([before, beyond]) => {
                near.push(before);
                far.push(beyond);
            }
            // Rounding may leave nothing of a half.
            None if side.is_near => near.push(piece),
            None => far.push(piece),
        }
    }
    let knot = group.knot;
    [(near, knot), (on, 0), (far, knot)].map(|(pieces, knot)| Group { pieces, knot })
}

/// The pieces by what hides what: knots of which each piece leads to all others of it, the nearest first.
fn knots<'a>(planes: &Planes<'a>, pieces: Vec<Piece<'a>>, work: &mut impl Count) -> Vec<Group<'a>> {
    let rings = rings(&hidden_by_each(planes, &pieces, work));
    let mut knots: Vec<Vec<Piece>> = pieces.iter().map(|_| Vec::new()).collect();
    for (ring, mut piece) in rings.into_iter().zip(pieces) {
        piece.forget_sight();
        knots[ring].push(piece);
    }
    knots.retain(|pieces| !pieces.is_empty());
    let knot = |pieces: Vec<_>| Group {
        knot: pieces.len(),
        pieces,
    };
    knots.into_iter().map(knot).collect()
}

/// What each piece hides.
fn hidden_by_each(planes: &Planes, pieces: &[Piece], work: &mut impl Count) -> Vec<Vec<usize>> {
    let extents: Vec<_> = pieces.iter().map(|piece| piece.extent).collect();
    let tree = Tree::new(&extents);
    let mut hides = vec![Vec::new(); pieces.len()];
    for (i, piece) in pieces.iter().enumerate() {
        let Some(extent) = piece.extent else { continue };
        for j in tree.may_be_hidden(&extent, work) {
            let other = &pieces[j];
            // Found both ways, they are compared once.
            let is_found_again = other.extent.is_some_and(|e| extent.farthest >= e.nearest);
            if i == j || (j < i && is_found_again) {
                continue;
            }
            let pair = piece.compare(other, planes.eye, work);
            if pair.first_hides() {
                hides[i].push(j);
            }
            if pair.second_hides() {
                hides[j].push(i);
            }
        }
    }
    hides
}
