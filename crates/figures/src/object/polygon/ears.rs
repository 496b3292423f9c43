//! Ears: corners whose triangle with both neighbours has no other corner in it.

use core::cmp::Ordering;
use std::collections::VecDeque;

use ombra_math::glam::DVec2;
use ombra_math::predicates::orient_2d;

use super::boxes::Boxes;

/// Ears lower than this part of their longest side wait until no better one is left.
const LOW: f64 = 1e-3;

/// Most steps for each corner. A contour that does not cross itself takes some dozens; one that runs over itself again
/// and again would take as many as it has corners, and the rest of it is cut without care.
const MOST_STEPS: u64 = 1000;

/// What keeps an ear from being cut, from step to step less; only a face that touches or crosses itself goes beyond
/// the first.
const CARE: [Care; 3] = [Care::Full, Care::Inside, Care::None];

#[derive(Clone, Copy, PartialEq)]
enum Care {
    /// A corner inside it or on the cut, and one on its border from which a side runs inside.
    Full,
    /// The same without a corner that only touches the cut.
    Inside,
    /// Nothing.
    None,
}

/// The triangles of a contour that runs counter-clockwise, as places in it. `steps` counts boxes and corners tested.
pub(super) fn cut(contour: &[DVec2], steps: &mut u64) -> Vec<[usize; 3]> {
    let most = steps.saturating_add(MOST_STEPS * contour.len() as u64);
    let mut ring = Ring::new(contour);
    let mut triangles = Vec::with_capacity(contour.len().saturating_sub(2));
    for care in CARE {
        let mut cut_before = usize::MAX;
        // Once more round as long as a round has cut something.
        while ring.left > 3 && triangles.len() != cut_before {
            cut_before = triangles.len();
            ring.ask_all();
            while ring.left > 3 {
                let care = if *steps > most { Care::None } else { care };
                let Some(i) = ring.next_ear(care, steps) else {
                    break;
                };
                triangles.push(ring.take_out(i));
            }
        }
    }
    // What turns right everywhere: it has no area of its own to keep.
    while let (3.., Some(i)) = (ring.left, ring.first()) {
        triangles.push(ring.take_out(ring.after[i]));
    }
    triangles
}

/// The corners that are left, and what is known of them.
struct Ring<'a> {
    at: &'a [DVec2],
    before: Vec<usize>,
    after: Vec<usize>,
    left: usize,
    gone: Vec<bool>,
    /// The corners that do not turn left: where there is one in an ear, there is one of these.
    reflex: Boxes,
    is_reflex: Vec<bool>,
    /// To be looked at next, with the number of changes beside them; out of date when that has grown.
    fresh: VecDeque<(usize, u32)>,
    low: VecDeque<(usize, u32)>,
    changes: Vec<u32>,
    /// The corners whose ear a corner is inside of, and those whose ear it touches.
    inside: Vec<Vec<usize>>,
    touching: Vec<Vec<usize>>,
}

impl Ring<'_> {
    fn new(at: &[DVec2]) -> Ring<'_> {
        let n = at.len();
        let before: Vec<usize> = (0..n).map(|i| (i + n - 1) % n).collect();
        let after: Vec<usize> = (0..n).map(|i| (i + 1) % n).collect();
        let turns_left =
            |i: usize| orient_2d(at[before[i]], at[i], at[after[i]]) == Some(Ordering::Greater);
        let is_reflex: Vec<bool> = (0..n).map(|i| !turns_left(i)).collect();
        Ring {
            at,
            reflex: Boxes::new((0..n).map(|i| is_reflex[i].then_some(at[i]))),
            before,
            after,
            left: n,
            gone: vec![false; n],
            is_reflex,
            fresh: VecDeque::new(),
            low: VecDeque::new(),
            changes: vec![0; n],
            inside: vec![Vec::new(); n],
            touching: vec![Vec::new(); n],
        }
    }

    fn first(&self) -> Option<usize> {
        self.gone.iter().position(|gone| !gone)
    }

    /// Every corner to be looked at, from the second on: a square is cut from its first corner.
    fn ask_all(&mut self) {
        let n = self.at.len();
        let all = (1..n).chain([0]).filter(|&i| !self.gone[i]);
        self.fresh = all.map(|i| (i, self.changes[i])).collect();
        self.low.clear();
    }

    /// The next corner whose ear may be cut.
    fn next_ear(&mut self, care: Care, steps: &mut u64) -> Option<usize> {
        loop {
            let (first_look, (i, change)) = match self.fresh.pop_front() {
                Some(entry) => (true, entry),
                None => (false, self.low.pop_front()?),
            };
            *steps += 1;
            if self.gone[i] || change != self.changes[i] {
                continue;
            }
            let ear = [self.before[i], i, self.after[i]];
            let [a, b, c] = ear.map(|i| self.at[i]);
            match orient_2d(a, b, c) {
                Some(Ordering::Less) | None => continue,
                Some(_) if first_look && is_low(a, b, c) => self.low.push_back((i, change)),
                // Without area: nothing is covered by cutting it.
                Some(Ordering::Equal) => return Some(i),
                Some(Ordering::Greater) => match self.hinders(ear, care, steps) {
                    None => return Some(i),
                    Some((by, true)) => self.inside[by].push(i),
                    Some((by, false)) => self.touching[by].push(i),
                },
            }
        }
    }

    /// A corner that keeps the ear from being cut, and whether it lies inside it.
    fn hinders(&self, ear: [usize; 3], care: Care, steps: &mut u64) -> Option<(usize, bool)> {
        if care == Care::None {
            return None;
        }
        let [a, b, c] = ear.map(|i| self.at[i]);
        let sides = [(a, b), (b, c), (c, a)];
        let side_of = |(from, to): (DVec2, DVec2), p: DVec2| orient_2d(from, to, p);
        self.reflex.find([a, b, c], steps, |i| {
            let p = self.at[i];
            if ear.contains(&i) {
                return None;
            }
            let of_sides = sides.map(|side| side_of(side, p));
            if of_sides.contains(&Some(Ordering::Less)) {
                return None;
            }
            if of_sides == [Some(Ordering::Greater); 3] {
                return Some((i, true));
            }
            // On the border. From there a side runs inside if it is to the left of all sides that the corner is on.
            let runs_inside = |q: DVec2| {
                sides.iter().zip(of_sides).all(|(&side, of_p)| {
                    of_p == Some(Ordering::Greater) || side_of(side, q) == Some(Ordering::Greater)
                })
            };
            let runs_inside = [self.before[i], self.after[i]]
                .into_iter()
                .any(|q| runs_inside(self.at[q]));
            let on_the_cut = p != a && p != c && of_sides[2] == Some(Ordering::Equal);
            (runs_inside || (care == Care::Full && on_the_cut)).then_some((i, false))
        })
    }

    /// Cuts off the ear at `b`.
    fn take_out(&mut self, b: usize) -> [usize; 3] {
        let (a, c) = (self.before[b], self.after[b]);
        (self.after[a], self.before[c]) = (c, a);
        self.gone[b] = true;
        self.left -= 1;
        self.set_reflex(b, false);
        for i in [a, c] {
            self.changes[i] += 1;
            self.fresh.push_back((i, self.changes[i]));
            let turn = orient_2d(self.at[self.before[i]], self.at[i], self.at[self.after[i]]);
            self.set_reflex(i, turn != Some(Ordering::Greater));
            self.ask_again(|ring| &mut ring.touching[i]);
        }
        [a, b, c]
    }

    fn set_reflex(&mut self, i: usize, is_reflex: bool) {
        if self.is_reflex[i] == is_reflex {
            return;
        }
        self.is_reflex[i] = is_reflex;
        self.reflex.set(i, is_reflex.then_some(self.at[i]));
        if !is_reflex {
            self.ask_again(|ring| &mut ring.inside[i]);
            self.ask_again(|ring| &mut ring.touching[i]);
        }
    }

    fn ask_again(&mut self, waiting: impl Fn(&mut Self) -> &mut Vec<usize>) {
        for i in core::mem::take(waiting(self)) {
            self.fresh.push_back((i, self.changes[i]));
        }
    }
}

fn is_low(a: DVec2, b: DVec2, c: DVec2) -> bool {
    let sides = [b - a, c - b, a - c].map(DVec2::length_squared);
    (b - a).perp_dot(c - b) <= LOW * sides.into_iter().fold(0.0, f64::max)
}
