//! Boxes around boxes, over points along a contour: which of them lie in a triangle?

use core::cmp::Ordering;

use ombra_math::glam::DVec2;
use ombra_math::predicates::orient_2d;

/// A tree of boxes over numbered points, each of which can be put in and taken out.
pub(super) struct Boxes {
    /// The children of node i are 2i and 2i + 1; the points are the leaves, from `points` on.
    nodes: Vec<[DVec2; 2]>,
    points: usize,
}

/// Around nothing.
const EMPTY: [DVec2; 2] = [DVec2::INFINITY, DVec2::NEG_INFINITY];

impl Boxes {
    /// The points for which there is one, in their order.
    pub(super) fn new(points: impl ExactSizeIterator<Item = Option<DVec2>>) -> Boxes {
        let count = points.len();
        let mut nodes = vec![EMPTY; count];
        nodes.extend(points.map(|p| p.map_or(EMPTY, |p| [p, p])));
        let mut boxes = Boxes {
            nodes,
            points: count,
        };
        for node in (1..count).rev() {
            boxes.gather(node);
        }
        boxes
    }

    /// Point `i` put in, or taken out.
    pub(super) fn set(&mut self, i: usize, p: Option<DVec2>) {
        let mut node = self.points + i;
        if let Some(leaf) = self.nodes.get_mut(node) {
            *leaf = p.map_or(EMPTY, |p| [p, p]);
        }
        while node > 1 {
            node /= 2;
            self.gather(node);
        }
    }

    fn gather(&mut self, node: usize) {
        let child = |i: usize| self.nodes.get(i).copied().unwrap_or(EMPTY);
        let [[a, b], [c, d]] = [child(2 * node), child(2 * node + 1)];
        if let Some(node) = self.nodes.get_mut(node) {
            *node = [a.min(c), b.max(d)];
        }
    }

    /// The first answer of `visit` to a point of a box that meets the triangle, which turns left. `steps` counts the
    /// boxes.
    pub(super) fn find<T>(
        &self,
        triangle: [DVec2; 3],
        steps: &mut u64,
        mut visit: impl FnMut(usize) -> Option<T>,
    ) -> Option<T> {
        let mut open = vec![1_usize];
        while let Some(node) = open.pop() {
            *steps += 1;
            let Some(&around) = self.nodes.get(node) else {
                continue;
            };
            if !meets(around, triangle) {
                continue;
            }
            match node.checked_sub(self.points) {
                Some(i) => {
                    if let Some(answer) = visit(i) {
                        return Some(answer);
                    }
                }
                None => open.extend([2 * node, 2 * node + 1]),
            }
        }
        None
    }
}

/// Whether a box and a triangle that turns left have a point in common, or may have one: no side of either parts them.
fn meets([low, high]: [DVec2; 2], [a, b, c]: [DVec2; 3]) -> bool {
    let apart = a.max(b).max(c).cmplt(low).any() || a.min(b).min(c).cmpgt(high).any();
    if apart || low.x > high.x {
        return false;
    }
    [(a, b), (b, c), (c, a)].into_iter().all(|(from, to)| {
        // That corner of the box which lies farthest to the left of the side.
        let x = if to.y < from.y { high.x } else { low.x };
        let y = if to.x > from.x { high.y } else { low.y };
        orient_2d(from, to, DVec2::new(x, y)) != Some(Ordering::Less)
    })
}
