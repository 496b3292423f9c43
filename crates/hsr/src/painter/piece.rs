//! A primitive or a part of one, and which of two hides part of the other.

use core::cell::OnceCell;
use core::cmp::Ordering;
use std::borrow::Cow;

use ombra_clip::sutherland_hodgman::clip_against_plane;
use ombra_math::exact::dot;
use ombra_math::glam::{DVec3, DVec4};
use ombra_math::plane::Plane;
use ombra_math::work::{Count, Counter};

use super::extent::{Extent, View};
use crate::pair::{CutPlane, Pair, Seen, compare_seen, convex, tolerance};
use crate::polygon::Polygon;

/// A primitive, or a part of one.
#[derive(Clone, Default)]
pub(super) struct Piece<'a> {
    pub(super) polygon: Cow<'a, Polygon>,
    /// The number of the primitive.
    pub(super) source: usize,
    pub(super) extent: Option<Extent>,
    /// The cuts it was made by, in the order of the primitives whose planes made them.
    pub(super) cuts: Vec<CutBy>,
    /// Made when it is first compared.
    seen: OnceCell<Option<Box<Seen>>>,
}

/// On which side of the plane of a primitive a piece was cut off.
#[derive(Clone, Copy)]
pub(super) struct CutBy {
    pub(super) source: usize,
    pub(super) is_near: bool,
}

/// The plane of a primitive that cuts others.
pub(super) struct Knife {
    pub(super) source: usize,
    /// Its front towards the eye.
    plane: Plane,
    /// The same, for measuring many pieces.
    level: CutPlane,
    /// How the primitive's vertices turn as seen.
    turning: Ordering,
    /// The primitive's largest coordinate.
    scale: f64,
}

impl Knife {
    /// `None` for a primitive without a plane, or edge-on.
    pub(super) fn new(source: usize, polygon: &Polygon, eye: DVec4) -> Option<Self> {
        let plane = polygon.plane()?;
        // Of one place, the representation with a positive w, for which signs are sides.
        let eye = if eye.w < 0.0 { -eye } else { eye };
        let side = dot(plane.coefficients(), eye).0;
        let turning = side.partial_cmp(&0.0)?;
        let plane = match turning {
            Ordering::Greater => plane,
            Ordering::Less => plane.turned(),
            Ordering::Equal => return None,
        };
        Some(Self {
            source,
            plane,
            level: CutPlane::of(plane)?,
            turning,
            scale: polygon.scale(),
        })
    }
}

impl<'a> Piece<'a> {
    pub(super) fn whole(source: usize, polygon: &'a Polygon, view: &View) -> Self {
        Self::of(source, Cow::Borrowed(polygon), Vec::new(), view)
    }

    fn of(source: usize, polygon: Cow<'a, Polygon>, cuts: Vec<CutBy>, view: &View) -> Self {
        Self {
            extent: view.extent(&polygon),
            polygon,
            source,
            cuts,
            seen: OnceCell::new(),
        }
    }

    /// The distance that is sorted by.
    pub(super) fn distance(&self) -> f64 {
        self.extent.map_or(f64::INFINITY, |e| e.distance)
    }

    /// Whether it was cut off on the eye's side of the plane of `source`, or on the other.
    fn is_near(&self, source: usize) -> Option<bool> {
        let at = self.cuts.binary_search_by_key(&source, |cut| cut.source);
        Some(self.cuts.get(at.ok()?)?.is_near)
    }

    /// How it and another piece hide each other; never [`Pair::Coplanar`]: the one submitted first is then in front.
    ///
    /// ```text
    /// P and Q on two sides of a plane:
    ///                            the one on the eye's side is hidden by nothing of the other
    /// … and of another, the other way:    they share no sight line
    /// ```
    ///
    /// Pieces of one primitive lie side by side. Cuts come before a comparison, which sees rounded vertices.
    pub(super) fn compare(&self, other: &Self, eye: DVec4, work: &mut impl Count) -> Pair {
        if self.source == other.source {
            return Pair::Apart;
        }
        if self.source > other.source {
            // Each two are always asked the same way round.
            return other.compare(self, eye, work).swapped();
        }
        let sides = [self.is_near(other.source), other.is_near(self.source)];
        let mut is_nearer = sides[0] == Some(true) || sides[1] == Some(false);
        let mut is_farther = sides[0] == Some(false) || sides[1] == Some(true);
        for cut in &self.cuts {
            if let Some(other_near) = other.is_near(cut.source) {
                is_nearer |= cut.is_near && !other_near;
                is_farther |= !cut.is_near && other_near;
            }
        }
        if is_nearer && is_farther {
            return Pair::Apart;
        }
        work.add(Counter::Pairs, 1);
        match (self.seen(eye), other.seen(eye)) {
            (Some(first), Some(second)) => match compare_seen(first, second) {
                Pair::Apart => Pair::Apart,
                _ if is_nearer => Pair::FirstNearer,
                _ if is_farther => Pair::SecondNearer,
                Pair::Coplanar => Pair::FirstNearer,
                pair => pair,
            },
            _ => Pair::Apart,
        }
    }

    fn seen(&self, eye: DVec4) -> Option<&Seen> {
        let seen = || Seen::new(&self.polygon, eye).map(Box::new);
        self.seen.get_or_init(seen).as_deref()
    }

    /// Forgets what only comparisons need, which is most of its memory.
    pub(super) fn forget_sight(&mut self) {
        self.seen = OnceCell::new();
    }

    /// As it is handed out.
    pub(super) fn into_part(self) -> (usize, Polygon) {
        (self.source, self.polygon.into_owned())
    }

    /// The parts on the eye's side of a plane and beyond it; `own` is the plane that the piece lies in.
    ///
    /// `None` where the plane does not pass through the inside, or has cut before.
    pub(super) fn cut(
        &self,
        knife: &Knife,
        own: &Knife,
        eye: DVec4,
        view: &View,
    ) -> Option<[Self; 2]> {
        if knife.source == self.source || self.is_near(knife.source).is_some() {
            return None;
        }
        let [near, far] = self.reach(knife, |v| knife.plane.signed_distance(v));
        if near == 0.0 || far == 0.0 {
            return None;
        }
        self.halves(knife, own, eye, view)
    }

    /// [`Self::cut`] at a plane that does pass through the inside; `None` where rounding leaves nothing of a half.
    pub(super) fn halves(
        &self,
        knife: &Knife,
        own: &Knife,
        eye: DVec4,
        view: &View,
    ) -> Option<[Self; 2]> {
        let half = |plane: &Plane, is_near: bool| {
            let outline = clip_against_plane(&self.polygon.vertices, plane);
            let vertices = convex(outline, eye, own.turning);
            let mut cuts = Vec::with_capacity(self.cuts.len() + 1);
            cuts.extend_from_slice(&self.cuts);
            let at = cuts.partition_point(|cut| cut.source < knife.source);
            let source = knife.source;
            cuts.insert(at, CutBy { source, is_near });
            let polygon = Cow::Owned(Polygon { vertices });
            let piece = Self::of(self.source, polygon, cuts, view);
            piece.extent.is_some().then_some(piece)
        };
        Some([
            half(&knife.plane, true)?,
            half(&knife.plane.turned(), false)?,
        ])
    }

    /// How far it reaches beyond a plane, towards the eye and away from it; 0 within the tolerance of equal depths.
    fn reach(&self, knife: &Knife, distance: impl Fn(DVec3) -> f64) -> [f64; 2] {
        let tolerance = tolerance(knife.scale.max(self.polygon.scale()));
        let vertices = self.polygon.vertices.iter();
        let distances = vertices.map(|&v| distance(v));
        distances.fold([0.0, 0.0], |[near, far], d| match d {
            d if d > tolerance => [d.max(near), far],
            d if d < -tolerance => [near, far.max(-d)],
            _ => [near, far],
        })
    }

    /// Whether it lies on the eye's side of a plane, or if on both, farther on that side; and whether on both.
    ///
    /// In the plane it lies on the eye's side of what was submitted later.
    pub(super) fn side_of(&self, knife: &Knife) -> Lies {
        if let Some(is_near) = self.is_near(knife.source) {
            return Lies {
                is_near,
                is_across: false,
            };
        }
        let [near, far] = self.reach(knife, |v| knife.level.distance(v));
        let is_near = if near == far {
            self.source < knife.source
        } else {
            near > far
        };
        let is_across = near > 0.0 && far > 0.0;
        Lies { is_near, is_across }
    }
}

/// Where a piece lies from a plane.
pub(super) struct Lies {
    pub(super) is_near: bool,
    pub(super) is_across: bool,
}
