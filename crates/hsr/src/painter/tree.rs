//! A tree of boxes round the extents: finds what may share a sight line with a primitive without asking all.

use ombra_math::work::{Count, Counter};

use super::extent::Extent;

/// A number, and the extent of what bears it.
type Item = (usize, Extent);

/// Extents a leaf holds at first.
const LEAF: usize = 4;

/// Boxes in boxes. A leaf keeps what is still waiting to be painted; what is put in later widens the boxes above it.
#[derive(Debug)]
pub(super) struct Tree {
    nodes: Vec<Node>,
    /// The leaf of every number that was put in.
    leaf_of: Vec<Option<usize>>,
}

#[derive(Debug)]
struct Node {
    extent: Extent,
    parent: Option<usize>,
    /// How many are waiting below.
    waiting: usize,
    below: Below,
}

#[derive(Debug)]
enum Below {
    Nodes([usize; 2]),
    Leaf(Vec<Item>),
}

impl Tree {
    /// A tree of the extents numbered 0, 1, …; those that are `None` are left out.
    pub(super) fn new(extents: &[Option<Extent>]) -> Self {
        let mut items: Vec<_> = (0..)
            .zip(extents)
            .filter_map(|(i, e)| Some((i, (*e)?)))
            .collect();
        let mut tree = Self {
            nodes: Vec::with_capacity(items.len()),
            leaf_of: vec![None; extents.len()],
        };
        if !items.is_empty() {
            tree.grow(&mut items, None);
        }
        tree
    }

    /// Adds the node of `items` and those below it; says which it is.
    fn grow(&mut self, items: &mut [Item], parent: Option<usize>) -> usize {
        let number = self.nodes.len();
        let extent = items
            .iter()
            .map(|(_, e)| *e)
            .reduce(|a, b| a.union(&b))
            .unwrap_or(Extent::EVERYWHERE);
        self.nodes.push(Node {
            extent,
            parent,
            waiting: items.len(),
            below: Below::Leaf(Vec::new()),
        });
        let below = if items.len() <= LEAF {
            for (i, _) in items.iter() {
                self.leaf_of[*i] = Some(number);
            }
            Below::Leaf(items.to_vec())
        } else {
            let (near, far) = halve(items);
            Below::Nodes([self.grow(near, Some(number)), self.grow(far, Some(number))])
        };
        self.nodes[number].below = below;
        number
    }

    /// Takes out what is painted or cut.
    pub(super) fn remove(&mut self, number: usize) {
        let mut at = self.leaf_of[number];
        while let Some(i) = at {
            let node = &mut self.nodes[i];
            node.waiting -= 1;
            if let Below::Leaf(items) = &mut node.below {
                items.retain(|(i, _)| *i != number);
            }
            at = node.parent;
        }
    }

    /// Puts in a piece of what was numbered `of`, beside it.
    pub(super) fn insert(&mut self, number: usize, extent: Extent, of: usize) {
        self.leaf_of
            .resize(self.leaf_of.len().max(number + 1), None);
        self.leaf_of[number] = self.leaf_of[of];
        let mut at = self.leaf_of[of];
        while let Some(i) = at {
            let node = &mut self.nodes[i];
            node.waiting += 1;
            node.extent = node.extent.union(&extent);
            if let Below::Leaf(items) = &mut node.below {
                items.push((number, extent));
            }
            at = node.parent;
        }
    }

    /// The numbers of what is waiting and may be hidden by what lies at `extent`, itself included: in no order.
    ///
    /// Left out: what shares no sight line with it, and what ends before it begins. Counts a comparison a box.
    pub(super) fn may_be_hidden(&self, extent: &Extent, work: &mut impl Count) -> Vec<usize> {
        let mut found = Vec::new();
        let mut open = vec![0];
        while let Some(node) = open.pop().and_then(|i| self.nodes.get(i)) {
            if node.waiting == 0 {
                continue;
            }
            let mut meets = |e: &Extent| {
                work.add(Counter::Comparisons, 1);
                e.farthest >= extent.nearest && e.overlaps(extent)
            };
            if !meets(&node.extent) {
                continue;
            }
            match &node.below {
                Below::Nodes(children) => open.extend(children),
                Below::Leaf(items) => {
                    found.extend(items.iter().filter(|(_, e)| meets(e)).map(|(i, _)| *i));
                }
            }
        }
        found
    }
}

/// Two halves by the middle of the boxes, along the axis on which these lie farthest apart.
fn halve(items: &mut [Item]) -> (&mut [Item], &mut [Item]) {
    // Unbounded boxes have no middle; they go to one end.
    let middle = |e: &Extent, axis: usize| {
        let sum = e.min[axis] + e.max[axis];
        if sum.is_nan() { f64::INFINITY } else { sum }
    };
    let spread = |axis: usize| {
        let middles = items.iter().map(|(_, e)| middle(e, axis));
        let finite = middles.filter(|m| m.is_finite());
        let (low, high) = finite.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), m| {
            (low.min(m), high.max(m))
        });
        high - low
    };
    let axis = (0..3)
        .max_by(|&a, &b| spread(a).total_cmp(&spread(b)))
        .unwrap_or(0);
    let half = items.len() / 2;
    items.select_nth_unstable_by(half, |(i, a), (j, b)| {
        middle(a, axis).total_cmp(&middle(b, axis)).then(i.cmp(j))
    });
    items.split_at_mut(half)
}
