//! Primitives that hide each other in a ring, so that none can be painted first.

use core::fmt;
use std::collections::{HashMap, VecDeque};

/// Why there is no order back to front: each of these primitives hides part of the next, the last of the first.
///
/// # Properties
///
/// - Two primitives: they cross, or each hides another part of the other.
/// - No primitive stands there twice, and none hides another of the ring than the next: the ring cannot be made
///   shorter by leaving some out. It starts with the lowest index.
///
/// # Examples
///
/// ```
/// use ombra_hsr::painter::Cycle;
///
/// let cycle = Cycle { primitives: vec![0, 4, 2] };
/// assert_eq!(
///     cycle.to_string(),
///     "no order back to front: primitive 0 hides part of 4, 4 of 2, 2 of 0"
/// );
/// ```
///
/// # References
///
/// Grafica 3, «Algoritmo del Pittore (depth-sort)»: whether an order always exists (no).
#[doc(alias = "cyclic overlap")]
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Cycle {
    /// Their indices, as they were submitted.
    pub primitives: Vec<usize>,
}

impl fmt::Display for Cycle {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("no order back to front: ")?;
        if let [a, b] = self.primitives[..] {
            return write!(f, "primitives {a} and {b} each hide part of the other");
        }
        let next = self.primitives.iter().cycle().skip(1);
        for (i, (a, b)) in self.primitives.iter().zip(next).enumerate() {
            match i {
                0 => write!(f, "primitive {a} hides part of {b}")?,
                _ => write!(f, ", {a} of {b}")?,
            }
        }
        Ok(())
    }
}

impl core::error::Error for Cycle {}

impl Cycle {
    /// The ring, turned to start with its lowest number.
    pub(super) fn of(mut primitives: Vec<usize>) -> Self {
        let lowest = (0..primitives.len()).min_by_key(|&i| primitives[i]);
        primitives.rotate_left(lowest.unwrap_or(0));
        Self { primitives }
    }
}

/// The members of a ring without shortcuts on a path of which each member hides the next and the last hides the first;
/// `hides` gives all that a member hides.
pub(super) fn ring_on<'a>(path: &[usize], hides: impl Fn(usize) -> &'a [usize]) -> Vec<usize> {
    let place: HashMap<usize, usize> = path.iter().enumerate().map(|(i, &p)| (p, i)).collect();
    let on_path = |&p: &usize| {
        let hidden = hides(p).iter();
        hidden.filter_map(|q| place.get(q).copied()).collect()
    };
    let edges: Vec<Vec<usize>> = path.iter().map(on_path).collect();
    let ring = without_shortcuts(&edges).into_iter();
    ring.map(|i| path[i]).collect()
}

/// The members of a ring without shortcuts among 0 … n − 1, of which each hides the next and the last hides 0;
/// `hides[i]` are all those that i hides.
///
/// ```text
/// breadth first from 0 back to 0: no edge skips ahead
/// of the edges that lead back, the shortest closes the ring
/// ```
fn without_shortcuts(hides: &[Vec<usize>]) -> Vec<usize> {
    let mut from: Vec<Option<usize>> = vec![None; hides.len()];
    let mut queue = VecDeque::from([0]);
    let mut ring = Vec::new();
    'search: while let Some(a) = queue.pop_front() {
        for &b in &hides[a] {
            if b == 0 {
                ring.push(a);
                break 'search;
            }
            if from[b].is_none() {
                from[b] = Some(a);
                queue.push_back(b);
            }
        }
    }
    while let Some(before) = ring.last().and_then(|&a| from[a]) {
        ring.push(before);
    }
    ring.reverse();
    let mut place = vec![None; hides.len()];
    for (i, &a) in ring.iter().enumerate() {
        place[a] = Some(i);
    }
    let mut best = (0, ring.len().saturating_sub(1));
    for (i, &a) in ring.iter().enumerate() {
        for j in hides[a].iter().filter_map(|&b| place[b]) {
            if j < i && i - j < best.1 - best.0 {
                best = (j, i);
            }
        }
    }
    ring.drain(best.0..).take(best.1 - best.0 + 1).collect()
}
