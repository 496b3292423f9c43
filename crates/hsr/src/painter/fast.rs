//! The depth sort: the farthest first, unless it hides what is not painted yet; and what to do about a ring.

use core::cmp::{Ordering, Reverse};
use std::collections::{BinaryHeap, HashMap};

use ombra_math::glam::DVec4;
use ombra_math::work::Count;

use super::cut::Planes;
use super::cycle::{Cycle, ring_on};
use super::divide::by_planes;
use super::piece::Piece;
use super::tree::Tree;
use crate::polygon::Polygon;

/// [`order`](super::order), counting each pair compared, once, or twice where one of the two waits for the other, and
/// the tests of two boxes as comparisons.
///
/// # Errors
///
/// As for [`order`](super::order).
pub fn order(polygons: &[Polygon], eye: DVec4, work: &mut impl Count) -> Result<Vec<usize>, Cycle> {
    let mut sort = DepthSort::new(polygons, eye, work);
    match sort.paint_until_ring() {
        Some(ring) => Err(Cycle::of(ring)),
        None => Ok(sort.painted),
    }
}

/// [`order_by_cutting`](super::order_by_cutting), counting as [`order`] does; what is compared to choose a cut is
/// counted too, and a piece held against a plane as a comparison.
#[must_use]
pub fn order_by_cutting(
    polygons: &[Polygon],
    eye: DVec4,
    work: &mut impl Count,
) -> Vec<(usize, Polygon)> {
    DepthSort::new(polygons, eye, work).by_cutting(polygons.len().max(FEW))
}

/// So many rings are opened one by one, however few the primitives.
const FEW: usize = 64;

#[derive(Clone, Copy)]
enum State {
    Waiting,
    /// To be painted as soon as what it hides is: at this place of the path.
    Open(usize),
    Painted,
    /// Cut in two other pieces.
    Cut([usize; 2]),
}

/// A place in the sort: farther first, then as submitted.
#[derive(Clone, Copy, PartialEq)]
struct Place {
    distance: f64,
    source: usize,
    piece: usize,
}

impl Place {
    fn of(number: usize, piece: &Piece) -> Self {
        Self {
            distance: piece.distance(),
            source: piece.source,
            piece: number,
        }
    }
}

impl Eq for Place {}

impl Ord for Place {
    fn cmp(&self, other: &Self) -> Ordering {
        let nearer = self.distance.total_cmp(&other.distance);
        nearer
            .then(other.source.cmp(&self.source))
            .then(other.piece.cmp(&self.piece))
    }
}

impl PartialOrd for Place {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

/// A step of the path: a piece, and what it hides.
struct Step {
    piece: usize,
    /// Farthest first.
    hides: Vec<usize>,
    /// How many of these are done.
    done: usize,
}

/// What is painted, what waits, and why.
pub(super) struct DepthSort<'a, 'w, C> {
    planes: Planes<'a>,
    /// The primitives, then what they were cut into.
    pieces: Vec<Piece<'a>>,
    states: Vec<State>,
    tree: Tree,
    /// All that may have to be painted, the next on top.
    sorted: BinaryHeap<Place>,
    /// What is next in the sort, and after it what has to be painted before because the one before hides it.
    path: Vec<Step>,
    /// What pieces hide that were taken back from the path: they need not be compared again.
    found: HashMap<usize, Vec<usize>>,
    painted: Vec<usize>,
    work: &'w mut C,
}

impl<'a, 'w, C: Count> DepthSort<'a, 'w, C> {
    pub(super) fn new(polygons: &'a [Polygon], eye: DVec4, work: &'w mut C) -> Self {
        let planes = Planes::new(polygons, eye);
        let whole = |(i, polygon)| Piece::whole(i, polygon, &planes.view);
        let pieces: Vec<_> = polygons.iter().enumerate().map(whole).collect();
        let extents: Vec<_> = pieces.iter().map(|p| p.extent).collect();
        let places = pieces.iter().enumerate();
        Self {
            planes,
            states: vec![State::Waiting; pieces.len()],
            tree: Tree::new(&extents),
            sorted: places.map(|(i, piece)| Place::of(i, piece)).collect(),
            path: Vec::new(),
            found: HashMap::new(),
            painted: Vec::with_capacity(pieces.len()),
            pieces,
            work,
        }
    }

    /// The order of pieces: each ring is opened by a cut, as long as there are few of them and a plane cuts one.
    pub(super) fn by_cutting(mut self, most: usize) -> Vec<(usize, Polygon)> {
        let mut cuts = 0;
        while let Some(ring) = self.paint_until_ring()
            && cuts < most
        {
            let pieces: Vec<_> = ring.iter().map(|&i| &self.pieces[i]).collect();
            let Some((i, halves)) = self.planes.cut(&pieces, self.work) else {
                break;
            };
            self.replace(ring[i], halves);
            cuts += 1;
        }
        let mut pieces = self.pieces;
        let mut take = |i: usize| core::mem::take(&mut pieces[i]);
        let painted = self.painted.into_iter().map(&mut take);
        let mut painted: Vec<_> = painted.map(Piece::into_part).collect();
        let is_left = |&i: &usize| matches!(self.states[i], State::Waiting | State::Open(_));
        let mut left: Vec<Piece> = (0..self.states.len()).filter(is_left).map(take).collect();
        left.sort_by(|a, b| b.distance().total_cmp(&a.distance()));
        painted.extend(by_planes(&self.planes, left, self.work));
        painted
    }

    /// Paints all, or up to a ring of which each hides the next. Then the last step's next hidden one is on the path.
    fn paint_until_ring(&mut self) -> Option<Vec<usize>> {
        loop {
            let Some(step) = self.path.last_mut() else {
                let next = self.sorted.pop()?.piece;
                if let State::Waiting = self.states[next] {
                    self.open(next);
                }
                continue;
            };
            let Some(&hidden) = step.hides.get(step.done) else {
                self.paint_last();
                continue;
            };
            match self.states[hidden] {
                State::Painted => step.done += 1,
                State::Waiting => self.open(hidden),
                State::Cut(halves) => self.hide_instead(halves),
                State::Open(start) => return Some(self.ring_from(start)),
            }
        }
    }

    /// Paints the last piece of the path.
    fn paint_last(&mut self) {
        if let Some(step) = self.path.pop() {
            self.states[step.piece] = State::Painted;
            self.tree.remove(step.piece);
            self.painted.push(step.piece);
            self.pieces[step.piece].forget_sight();
        }
    }

    /// Puts a piece at the end of the path.
    fn open(&mut self, piece: usize) {
        let hides = match self.found.remove(&piece) {
            Some(hides) => hides,
            None => self.find_hidden(piece),
        };
        self.states[piece] = State::Open(self.path.len());
        self.path.push(Step {
            piece,
            hides,
            done: 0,
        });
    }

    /// What a piece hides of all that waits, the farthest first.
    fn find_hidden(&mut self, piece: usize) -> Vec<usize> {
        let Some(extent) = self.pieces[piece].extent else {
            return Vec::new();
        };
        let mut hidden = self.tree.may_be_hidden(&extent, self.work);
        hidden.retain(|&other| self.hides(piece, other));
        let place = |&i: &usize| Reverse(Place::of(i, &self.pieces[i]));
        hidden.sort_by_cached_key(place);
        hidden
    }

    fn hides(&mut self, front: usize, back: usize) -> bool {
        let [front, back] = [front, back].map(|i| &self.pieces[i]);
        self.planes.hides(front, back, self.work)
    }

    /// The pieces of the path from `start` on that make a ring.
    fn ring_from(&self, start: usize) -> Vec<usize> {
        let path: Vec<usize> = self.path[start..].iter().map(|s| s.piece).collect();
        ring_on(&path, |piece| match self.states[piece] {
            State::Open(place) => &self.path[place].hides,
            _ => &[],
        })
    }

    /// Takes the last step's next hidden piece for its halves.
    fn hide_instead(&mut self, halves: [usize; 2]) {
        let Some(front) = self.path.last().map(|s| s.piece) else {
            return;
        };
        let hidden = halves.map(|half| self.hides(front, half).then_some(half));
        if let Some(step) = self.path.last_mut() {
            step.hides
                .splice(step.done..=step.done, hidden.into_iter().flatten());
        }
    }

    /// Ends the path before this place.
    fn take_back(&mut self, place: usize) {
        for (i, step) in (place..).zip(self.path.drain(place..)) {
            if i == 0 {
                // What the path began with was taken out of the sort.
                let piece = &self.pieces[step.piece];
                self.sorted.push(Place::of(step.piece, piece));
            }
            self.states[step.piece] = State::Waiting;
            self.found.insert(step.piece, step.hides);
        }
    }

    /// Puts the halves of a piece in its place. The path is taken back to where it was opened.
    fn replace(&mut self, piece: usize, halves: [Piece<'a>; 2]) {
        let State::Open(place) = self.states[piece] else {
            return;
        };
        self.take_back(place);
        let first = self.pieces.len();
        for (number, half) in (first..).zip(halves) {
            self.sorted.push(Place::of(number, &half));
            if let Some(extent) = half.extent {
                self.tree.insert(number, extent, piece);
            }
            self.pieces.push(half);
            self.states.push(State::Waiting);
        }
        self.tree.remove(piece);
        self.states[piece] = State::Cut([first, first + 1]);
        // What hides it is still asked about the whole.
        self.pieces[piece].forget_sight();
    }
}
