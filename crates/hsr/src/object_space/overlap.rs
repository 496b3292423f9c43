//! Which primitives share sight lines, and which of them make a knot that no order by pairs opens.
//!
//! At every sight line each two of the primitives that it meets have a winner, so taking from each what any other
//! hides leaves the nearest, if the pairs agree: P before Q, and Q before R, and P before R. Depths do agree; but what
//! is equally deep within a tolerance may not, and in a ring each is hidden by the one before it.
//!
//! Then the pairs are a knockout. The primitives come one after the other, in the order in which they were submitted,
//! and each meets the *winner* of those before it, not all of them. It may only be hidden by what is itself still
//! visible. Exactly one is left, whatever the pairs say; but cutting at parts leaves more of them than cutting at
//! wholes, so this is done in knots only:
//!
//! ```text
//! P → Q:  P hides part of Q
//! knot:   primitives that lead to each other along →, three or more of them, two of which
//!         nearly lie in each other
//! ```
//!
//! A winner W has beaten all before it, one way or another: W → … → P. If P hides the next one, Q, from outside of its
//! knot, then W hides it too: with Q → W there would be a ring Q → W → … → P → Q, and all were in one knot.

use ombra_math::work::{Count, Counter};

use crate::pair::{Pair, Seen, compare_seen, rings};

/// How a primitive lies along the sight lines that it shares with one submitted later.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Overlap {
    /// The first of the two.
    pub(super) with: usize,
    pub(super) pair: Pair,
    /// Whether both are in one knot.
    pub(super) is_knotted: bool,
}

/// For each primitive its overlaps with those before it; every two are compared.
pub(super) fn overlaps(seen: &[Option<Seen>], work: &mut impl Count) -> Vec<Vec<Overlap>> {
    let mut overlaps = vec![Vec::new(); seen.len()];
    let mut clinging = Vec::new();
    for (j, (second, overlaps)) in seen.iter().zip(&mut overlaps).enumerate() {
        for (i, first) in seen.iter().enumerate().take(j) {
            work.add(Counter::Pairs, 1);
            let (Some(p), Some(q)) = (first, second) else {
                continue;
            };
            let pair = compare_seen(p, q);
            if pair == Pair::Apart {
                continue;
            }
            if p.clings_to(q) {
                clinging.push([i, j]);
            }
            overlaps.push(Overlap {
                with: i,
                pair,
                is_knotted: false,
            });
        }
    }
    if !clinging.is_empty() {
        tie(&mut overlaps, &clinging);
    }
    overlaps
}

/// Finds the knots; `clinging` are the pairs that nearly lie in each other.
fn tie(overlaps: &mut [Vec<Overlap>], clinging: &[[usize; 2]]) {
    let ring = rings(&hidden_by_each(overlaps));
    let mut members = vec![0; ring.len()];
    for &ring in &ring {
        members[ring] += 1;
    }
    let mut is_knot = vec![false; ring.len()];
    for &[i, j] in clinging {
        is_knot[ring[i]] |= ring[i] == ring[j] && members[ring[i]] > 2;
    }
    for (j, overlaps) in overlaps.iter_mut().enumerate() {
        for overlap in overlaps {
            overlap.is_knotted = ring[overlap.with] == ring[j] && is_knot[ring[j]];
        }
    }
}

/// What each primitive hides.
fn hidden_by_each(overlaps: &[Vec<Overlap>]) -> Vec<Vec<usize>> {
    let mut hides = vec![Vec::new(); overlaps.len()];
    for (j, overlaps) in overlaps.iter().enumerate() {
        for &Overlap { with: i, pair, .. } in overlaps {
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
