//! A primitive or a part of one, and which of two hides part of the other.

use core::cell::OnceCell;
use core::cmp::Ordering;
use std::borrow::Cow;

use ombra_clip::sutherland_hodgman::clip_against_plane;
use ombra_math::exact::dot;
use ombra_math::glam::DVec4;
use ombra_math::plane::Plane;
use ombra_math::work::{Count, Counter};

use super::cut::Scene;
use super::extent::{Extent, View};
use crate::pair::{Pair, Seen, compare_seen, convex, tolerance};
use crate::polygon::Polygon;

/// A primitive, or a part of one.
#[derive(Clone)]
pub(super) struct Piece<'a> {
    pub(super) polygon: Cow<'a, Polygon>,
    /// The number of the primitive.
    pub(super) source: usize,
    pub(super) extent: Option<Extent>,
    /// Where it lies from the planes of other primitives, as far as that was asked.
    sides: Vec<Side>,
    /// Made when it is first compared.
    seen: OnceCell<Option<Seen>>,
}

/// Where a piece lies from the plane of a primitive.
#[derive(Clone, Copy)]
struct Side {
    of: usize,
    is_near: bool,
}

/// The plane of a primitive that cuts others.
pub(super) struct Knife {
    source: usize,
    /// Its front towards the eye.
    plane: Plane,
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
            turning,
            scale: polygon.scale(),
        })
    }
}

impl<'a> Piece<'a> {
    pub(super) fn whole(source: usize, polygon: &'a Polygon, view: &View) -> Self {
        Self::of(source, Cow::Borrowed(polygon), Vec::new(), view)
    }

    fn of(source: usize, polygon: Cow<'a, Polygon>, sides: Vec<Side>, view: &View) -> Self {
        Self {
            extent: view.extent(&polygon),
            polygon,
            source,
            sides,
            seen: OnceCell::new(),
        }
    }

    /// The distance that is sorted by.
    pub(super) fn distance(&self) -> f64 {
        self.extent.map_or(f64::INFINITY, |e| e.distance)
    }

    /// Whether it is known to lie on the eye's side of the plane of `source`, or on the other.
    fn is_near(&self, source: usize) -> Option<bool> {
        let side = self.sides.iter().find(|side| side.of == source)?;
        Some(side.is_near)
    }

    /// How it and another piece hide each other; never [`Pair::Coplanar`]: the one submitted first is then in front.
    ///
    /// ```text
    /// P and Q on two sides of a plane:    the one on the eye's side is hidden by nothing of the other
    /// … and of another, the other way:    they share no sight line
    /// ```
    ///
    /// Pieces of one primitive lie side by side. Known sides come before a comparison, which sees rounded vertices.
    pub(super) fn compare(&self, other: &Self, eye: DVec4, work: &mut impl Count) -> Pair {
        if self.source == other.source {
            return Pair::Apart;
        }
        if self.source > other.source {
            // Each two are always asked the same way round.
            return other.compare(self, eye, work).swapped();
        }
        let mut is_nearer = self.is_near(other.source).is_some_and(|near| near)
            || other.is_near(self.source).is_some_and(|near| !near);
        let mut is_farther = self.is_near(other.source).is_some_and(|near| !near)
            || other.is_near(self.source).is_some_and(|near| near);
        for side in &self.sides {
            if let Some(other_near) = other.is_near(side.of) {
                is_nearer |= side.is_near && !other_near;
                is_farther |= !side.is_near && other_near;
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
        let seen = self.seen.get_or_init(|| Seen::new(&self.polygon, eye));
        seen.as_ref()
    }

    /// The parts on the eye's side of a plane and beyond it; `own` is the plane that the piece lies in.
    ///
    /// `None` where the plane does not pass through the inside, or was asked for before.
    pub(super) fn cut(&self, knife: &Knife, own: &Knife, scene: &Scene) -> Option<[Self; 2]> {
        if knife.source == self.source || self.is_near(knife.source).is_some() {
            return None;
        }
        let [near, far] = self.reach(knife);
        if near == 0.0 || far == 0.0 {
            return None;
        }
        let half = |plane: &Plane, is_near: bool| {
            let outline = clip_against_plane(&self.polygon.vertices, plane);
            let vertices = convex(outline, scene.eye, own.turning);
            let mut sides = self.sides.clone();
            sides.push(Side {
                of: knife.source,
                is_near,
            });
            let polygon = Cow::Owned(Polygon { vertices });
            let piece = Self::of(self.source, polygon, sides, &scene.view);
            piece.extent.is_some().then_some(piece)
        };
        Some([
            half(&knife.plane, true)?,
            half(&knife.plane.turned(), false)?,
        ])
    }

    /// How far it reaches beyond a plane, towards the eye and away from it; 0 within the tolerance of equal depths.
    fn reach(&self, knife: &Knife) -> [f64; 2] {
        let tolerance = tolerance(knife.scale.max(self.polygon.scale()));
        let vertices = self.polygon.vertices.iter();
        let distances = vertices.map(|&v| knife.plane.signed_distance(v));
        distances.fold([0.0, 0.0], |[near, far], d| match d {
            d if d > tolerance => [d.max(near), far],
            d if d < -tolerance => [near, far.max(-d)],
            _ => [near, far],
        })
    }

    /// Settles on which side of a plane it lies, by the vertex farthest from it; says whether that was news.
    ///
    /// In the plane it lies on the eye's side of what was submitted later.
    pub(super) fn settle(&mut self, knife: &Knife) -> bool {
        if knife.source == self.source || self.is_near(knife.source).is_some() {
            return false;
        }
        let [near, far] = self.reach(knife);
        let is_near = if near == far {
            self.source < knife.source
        } else {
            near > far
        };
        self.sides.push(Side {
            of: knife.source,
            is_near,
        });
        true
    }
}
