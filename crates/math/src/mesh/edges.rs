//! Edges by counting sort, and the questions they answer.

use super::Mesh;
use crate::work::{Count, Counter};

/// An edge with the faces beside it.
#[doc(alias = "half-edge")]
#[doc(alias = "adjacency")]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Edge {
    /// The vertex with the lower index.
    pub from: u32,
    /// The vertex with the higher index.
    pub to: u32,
    /// The triangle that runs from → to: seen from outside and along the edge, it lies on the left.
    pub left: Option<u32>,
    /// The triangle that runs to → from.
    pub right: Option<u32>,
}

impl Mesh {
    /// The edges, each once, in the order of `from` and then `to`.
    ///
    /// # Properties
    ///
    /// Takes time linear in vertices and triangles, and the answer depends on nothing but the mesh: the sides
    /// are sorted by counting, nothing is hashed. At most 3 edge records are touched a triangle
    /// ([`Mesh::edges_counted`]).
    ///
    /// A record pairs one triangle on the left with one on the right. Where three or more share
    /// two vertices, or two run along them the same way, there is a record for each further pair or single
    /// triangle, in the order of the triangles.
    ///
    /// # Pitfalls
    ///
    /// Vertices are the same only if their index is: a model that repeats positions along a seam of texture
    /// coordinates has an open edge there. A side from a vertex to itself is none.
    ///
    /// # Examples
    ///
    /// ```
    /// use ombra_math::mesh::Edge;
    /// use ombra_math::solids::slide_cube;
    ///
    /// let edges = slide_cube().edges();
    /// assert_eq!(edges.len(), 12 + 6); // the cube's, and a diagonal for each side
    /// let [bottom, front] = [0, 4];
    /// assert_eq!(edges[0], Edge { from: 0, to: 1, left: Some(bottom), right: Some(front) });
    /// ```
    ///
    /// # References
    ///
    /// CIS 781, «Shadow Volume»: silhouette edges. Counting sort: H. Seward, 1954.
    #[must_use]
    pub fn edges(&self) -> Vec<Edge> {
        self.edges_counted(&mut ())
    }

    /// [`Mesh::edges`], counting in `work` each time a side of a record is filled.
    #[must_use]
    pub fn edges_counted(&self, work: &mut impl Count) -> Vec<Edge> {
        let (ends, mut sides) = self.sides_by_lower_vertex();
        let mut edges = Vec::with_capacity(sides.len() / 2);
        let mut spare = Vec::new();
        let mut start = 0;
        for (from, end) in (0u32..).zip(ends) {
            let sides = &mut sides[start..end];
            start = end;
            sort_by_higher_vertex(sides, &mut spare);
            for group in sides.chunk_by(|a, b| a.to() == b.to()) {
                pair_up(from, group, &mut edges, work);
            }
        }
        edges
    }

    /// Whether the mesh has no border: every edge record has a face on both sides.
    ///
    /// # Pitfalls
    ///
    /// Faces that disagree on which side is out leave records with one side each, and the mesh counts as open.
    /// Edges with four faces can be closed; [`Mesh::is_two_manifold`] asks for more. A mesh
    /// without edges has no border.
    #[doc(alias = "watertight")]
    #[must_use]
    pub fn is_closed(&self) -> bool {
        self.edges()
            .iter()
            .all(|e| e.left.is_some() && e.right.is_some())
    }

    /// Whether the mesh is a closed surface: closed, two faces an edge, and the faces round each vertex one fan.
    ///
    /// # Properties
    ///
    /// Vertices that no triangle uses do not count. Any number of separate pieces may be there, also none.
    ///
    /// # Pitfalls
    ///
    /// Asks indices alone, not positions: the surface may cross itself, and a double-sided sheet passes. A triangle
    /// that names a vertex twice fails.
    ///
    /// # Examples
    ///
    /// ```
    /// use ombra_math::solids;
    ///
    /// assert!(solids::slide_cube().is_two_manifold());
    /// // Two tetrahedra that share a vertex: closed, but two fans meet there.
    /// let mut pair = solids::tetrahedron();
    /// for i in 0..4 {
    ///     let face = pair.triangles[i].map(|v| if v == 0 { 0 } else { v + 3 });
    ///     pair.triangles.push(face);
    /// }
    /// pair.positions.extend_from_within(1..);
    /// assert!(pair.is_closed() && !pair.is_two_manifold());
    /// ```
    #[doc(alias = "manifold")]
    #[must_use]
    pub fn is_two_manifold(&self) -> bool {
        let sides = |t: u32| {
            let [a, b, c] = self.triangles.get(t as usize).copied().unwrap_or_default();
            [(a, b), (b, c), (c, a)]
        };
        // The side of a triangle that runs from → to; numbered 3 × triangle + corner.
        let side_of = |t: u32, from: u32, to: u32| {
            (0..3)
                .zip(sides(t))
                .find(|&(_, side)| side == (from, to))
                .map(|(k, _)| 3 * t + k)
        };
        let none = u32::MAX;
        let mut across = vec![none; 3 * self.triangles.len().min(Self::MAX_TRIANGLES)];
        let mut previous = None;
        for e in self.edges() {
            let (Some(left), Some(right)) = (e.left, e.right) else {
                return false;
            };
            let (Some(l), Some(r)) = (side_of(left, e.from, e.to), side_of(right, e.to, e.from))
            else {
                return false;
            };
            if previous == Some((e.from, e.to)) {
                return false;
            }
            previous = Some((e.from, e.to));
            (across[l as usize], across[r as usize]) = (r, l);
        }
        // Walk the fan of each vertex once; whatever side is left over at the vertex begins a second one.
        let mut walked = vec![false; across.len()];
        let mut has_fan = vec![false; self.positions.len()];
        for (t, corners) in (0u32..).zip(self.used_triangles()) {
            for (k, v) in (0..3).zip(corners.into_iter().flatten()) {
                let mut side = (3 * t + k) as usize;
                if walked[side] {
                    continue;
                }
                if core::mem::replace(&mut has_fan[v as usize], true) {
                    return false;
                }
                while !core::mem::replace(&mut walked[side], true) {
                    let other = across[side];
                    if other == none {
                        return false; // from a vertex to itself
                    }
                    // The other face runs towards the vertex there; its next side leaves the vertex again.
                    side = (other - other % 3 + (other + 1) % 3) as usize;
                }
            }
        }
        true
    }

    /// Calls `visit(low, side)` for the sides of all triangles.
    fn for_each_side(&self, mut visit: impl FnMut(usize, HalfEdge)) {
        for (t, corners) in (0u32..).zip(self.used_triangles()) {
            let Some([a, b, c]) = corners else { continue };
            for (p, q) in [(a, b), (b, c), (c, a)] {
                if p < q {
                    visit(p as usize, HalfEdge::new(q, t, false));
                } else if p > q {
                    visit(q as usize, HalfEdge::new(p, t, true));
                }
            }
        }
    }

    /// First half of the sort: the sides grouped by their lower vertex, and where each vertex's group ends.
    fn sides_by_lower_vertex(&self) -> (Vec<usize>, Vec<HalfEdge>) {
        let mut ends = vec![0usize; self.positions.len()];
        self.for_each_side(|low, _| ends[low] += 1);
        // Counts become starts; filling moves each start to the group's end.
        let mut total = 0;
        for end in &mut ends {
            total += core::mem::replace(end, total);
        }
        let mut sides = vec![HalfEdge(0); total];
        self.for_each_side(|low, side| {
            sides[ends[low]] = side;
            ends[low] += 1;
        });
        (ends, sides)
    }
}

/// A triangle's side, seen from its lower vertex: the higher vertex, the triangle, and whether it runs down.
#[derive(Clone, Copy)]
struct HalfEdge(u64);

impl HalfEdge {
    fn new(to: u32, triangle: u32, down: bool) -> Self {
        Self(u64::from(to) << 32 | u64::from(triangle) << 1 | u64::from(down))
    }

    fn to(self) -> u32 {
        (self.0 >> 32) as u32
    }

    fn triangle(self) -> u32 {
        self.0 as u32 >> 1
    }

    fn is_down(self) -> bool {
        self.0 & 1 == 1
    }
}

/// Second half of the sort: one vertex's sides by their higher vertex, keeping the order of triangles.
fn sort_by_higher_vertex(sides: &mut [HalfEdge], spare: &mut Vec<HalfEdge>) {
    // So few are sooner placed by their rank: no branch to mispredict, and bounded by this number a side. No two
    // are equal, as no triangle runs along two vertices twice the same way.
    const FEW: usize = 16;
    if sides.len() <= FEW {
        let mut sorted = [HalfEdge(0); FEW];
        for side in &*sides {
            let rank: usize = sides
                .iter()
                .map(|other| usize::from(other.0 < side.0))
                .sum();
            sorted[rank] = *side;
        }
        sides.copy_from_slice(&sorted[..sides.len()]);
        return;
    }
    // Counting sort by each byte of the higher vertex, the lowest first; the order of triangles is there already.
    for shift in [32, 40, 48, 56] {
        let byte = |side: HalfEdge| (side.0 >> shift) as usize & 0xff;
        let mut starts = [0usize; 256];
        for &side in &*sides {
            starts[byte(side)] += 1;
        }
        if starts.contains(&sides.len()) {
            continue;
        }
        let mut total = 0;
        for start in &mut starts {
            total += core::mem::replace(start, total);
        }
        spare.clear();
        spare.extend_from_slice(sides);
        for &side in &*spare {
            sides[starts[byte(side)]] = side;
            starts[byte(side)] += 1;
        }
    }
}

/// Adds the records of one vertex pair: the first triangle up with the first down, the second with the second, …
#[inline]
fn pair_up(from: u32, group: &[HalfEdge], edges: &mut Vec<Edge>, work: &mut impl Count) {
    work.add(Counter::EdgeRecords, group.len() as u64);
    let Some(to) = group.first().map(|side| side.to()) else {
        return;
    };
    if let [a, b] = group
        && a.is_down() != b.is_down()
    {
        let (left, right) = if a.is_down() { (b, a) } else { (a, b) };
        edges.push(Edge {
            from,
            to,
            left: Some(left.triangle()),
            right: Some(right.triangle()),
        });
        return;
    }
    let mut up = group
        .iter()
        .filter(|side| !side.is_down())
        .map(|side| side.triangle());
    let mut down = group
        .iter()
        .filter(|side| side.is_down())
        .map(|side| side.triangle());
    loop {
        let (left, right) = (up.next(), down.next());
        if left.is_none() && right.is_none() {
            return;
        }
        edges.push(Edge {
            from,
            to,
            left,
            right,
        });
    }
}

#[cfg(test)]
mod tests;
