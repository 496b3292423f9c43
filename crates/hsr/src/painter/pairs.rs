//! Which primitive hides part of which, by comparing every pair.

use ombra_math::glam::DVec4;
use ombra_math::work::{Count, Counter};

use crate::pair::{Pair, Seen, compare_seen};
use crate::polygon::Polygon;

/// [`hiding_pairs`](super::hiding_pairs), counting the pairs compared: k (k − 1) / 2.
#[must_use]
pub fn hiding_pairs(polygons: &[Polygon], eye: DVec4, work: &mut impl Count) -> Vec<[usize; 2]> {
    let seen: Vec<_> = polygons.iter().map(|p| Seen::new(p, eye)).collect();
    let mut pairs = Vec::new();
    for (i, first) in seen.iter().enumerate() {
        for (j, second) in seen.iter().enumerate().skip(i + 1) {
            work.add(Counter::Pairs, 1);
            let pair = first.as_ref().zip(second.as_ref());
            match pair.map_or(Pair::Apart, |(first, second)| compare_seen(first, second)) {
                Pair::Apart => {}
                Pair::FirstNearer | Pair::Coplanar => pairs.push([i, j]),
                Pair::SecondNearer => pairs.push([j, i]),
                Pair::Crossing => pairs.extend([[i, j], [j, i]]),
            }
        }
    }
    pairs.sort_unstable();
    pairs
}
