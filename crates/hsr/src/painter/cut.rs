//! Which piece of a ring is cut, and by whose plane.

use core::cell::OnceCell;

use ombra_math::glam::DVec4;
use ombra_math::work::Count;

use super::extent::View;
use super::piece::{Knife, Piece};
use crate::polygon::Polygon;

/// The planes of the primitives, and what pieces are seen from.
pub(super) struct Planes<'a> {
    polygons: &'a [Polygon],
    pub(super) eye: DVec4,
    pub(super) view: View,
    /// Each made when it is first asked for.
    knives: Vec<OnceCell<Option<Knife>>>,
}

impl<'a> Planes<'a> {
    pub(super) fn new(polygons: &'a [Polygon], eye: DVec4) -> Self {
        Self {
            polygons,
            eye,
            view: View::of(eye),
            knives: polygons.iter().map(|_| OnceCell::new()).collect(),
        }
    }

    /// The place in the ring of a piece to cut, and its halves; `None` if no plane of one passes through another.
    ///
    /// ```text
    /// ring: P₀ hides P₁ hides … hides P₀
    /// cut:  Pᵢ by the plane of another, its neighbours' first
    /// best: no half of Pᵢ hides Pᵢ₊₁ and is hidden by Pᵢ₋₁, so the ring is open
    /// ```
    ///
    /// Any cut will do in the end; one that opens the ring at once saves pieces.
    pub(super) fn cut(
        &self,
        ring: &[&Piece<'a>],
        work: &mut impl Count,
    ) -> Option<(usize, [Piece<'a>; 2])> {
        let n = ring.len();
        let knife = |i: usize| self.knife(ring[i % n].source);
        let steps = (1..n).map(|k| if k % 2 == 1 { k.div_ceil(2) } else { n - k / 2 });
        let mut any = None;
        for step in steps {
            for i in 0..n {
                let (before, after) = (ring[(i + n - 1) % n], ring[(i + 1) % n]);
                let both = knife(i + step).zip(knife(i));
                let halves =
                    both.and_then(|(knife, own)| ring[i].cut(knife, own, self.eye, &self.view));
                let Some(halves) = halves else { continue };
                let mut closes =
                    |half: &Piece| self.hides(before, half, work) && self.hides(half, after, work);
                if !halves.iter().any(&mut closes) {
                    return Some((i, halves));
                }
                any = any.or(Some((i, halves)));
            }
        }
        any
    }

    /// The plane of a primitive.
    pub(super) fn knife(&self, source: usize) -> Option<&Knife> {
        let knife = || Knife::new(source, &self.polygons[source], self.eye);
        self.knives[source].get_or_init(knife).as_ref()
    }

    /// Whether a piece hides part of another.
    pub(super) fn hides(&self, front: &Piece, back: &Piece, work: &mut impl Count) -> bool {
        front.compare(back, self.eye, work).first_hides()
    }
}
