//! Edges by counting sort, and the questions they answer.

use super::Mesh;
use crate::work::{Count, Counter};

/// An edge with the faces beside it.
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
    fn for_each_side(&self, mut visit: impl FnMut(usize, Side)) {
        for (t, corners) in (0u32..).zip(self.used_triangles()) {
            let Some([a, b, c]) = corners else { continue };
            for (p, q) in [(a, b), (b, c), (c, a)] {
                if p < q {
                    visit(p as usize, Side::new(q, t, false));
                } else if p > q {
                    visit(q as usize, Side::new(p, t, true));
                }
            }
        }
    }

    /// First half of the sort: the sides grouped by their lower vertex, and where each vertex's group ends.
    fn sides_by_lower_vertex(&self) -> (Vec<usize>, Vec<Side>) {
        let mut ends = vec![0usize; self.positions.len()];
        self.for_each_side(|low, _| ends[low] += 1);
        // Counts become starts; filling moves each start to the group's end.
        let mut total = 0;
        for end in &mut ends {
            total += core::mem::replace(end, total);
        }
        let mut sides = vec![Side(0); total];
        self.for_each_side(|low, side| {
            sides[ends[low]] = side;
            ends[low] += 1;
        });
        (ends, sides)
    }
}

/// A triangle's side, seen from its lower vertex: the higher vertex, the triangle, and whether it runs down.
#[derive(Clone, Copy)]
struct Side(u64);

impl Side {
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
fn sort_by_higher_vertex(sides: &mut [Side], spare: &mut Vec<Side>) {
    // So few are sooner placed by their rank: no branch to mispredict, and bounded by this number a side. No two
    // are equal, as no triangle runs along two vertices twice the same way.
    const FEW: usize = 16;
    if sides.len() <= FEW {
        let mut sorted = [Side(0); FEW];
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
        let byte = |side: Side| (side.0 >> shift) as usize & 0xff;
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
fn pair_up(from: u32, group: &[Side], edges: &mut Vec<Edge>, work: &mut impl Count) {
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
mod tests {
    use super::*;
    use crate::solids;
    use crate::work::Work;
    use glam::DVec3;
    use proptest::prelude::*;
    use std::collections::BTreeMap;

    fn mesh(vertices: usize, triangles: &[[u32; 3]]) -> Mesh {
        Mesh {
            positions: vec![DVec3::ZERO; vertices],
            triangles: triangles.to_vec(),
        }
    }

    /// Each pair of vertices with its triangles up and down, looked up in a map.
    fn edges_by_map(mesh: &Mesh) -> Vec<Edge> {
        let mut map: BTreeMap<(u32, u32), [Vec<u32>; 2]> = BTreeMap::new();
        for (t, &[a, b, c]) in mesh.triangles.iter().enumerate() {
            if mesh.triangle(t).is_none() {
                continue;
            }
            for (p, q) in [(a, b), (b, c), (c, a)] {
                if p != q {
                    map.entry((p.min(q), p.max(q))).or_default()[usize::from(p > q)].push(t as u32);
                }
            }
        }
        let mut edges = Vec::new();
        for ((from, to), [up, down]) in map {
            for i in 0..up.len().max(down.len()) {
                edges.push(Edge {
                    from,
                    to,
                    left: up.get(i).copied(),
                    right: down.get(i).copied(),
                });
            }
        }
        edges
    }

    /// By definition: all edges paired, two faces a pair, and at each vertex the faces hang together by its edges.
    fn is_two_manifold_by_definition(mesh: &Mesh) -> bool {
        let faces: Vec<_> = (0..mesh.triangles.len())
            .filter(|&t| mesh.triangle(t).is_some())
            .map(|t| mesh.triangles[t])
            .collect();
        if faces.iter().any(|[a, b, c]| a == b || b == c || c == a) {
            return false;
        }
        let runs = |p, q| {
            faces
                .iter()
                .filter(|[a, b, c]| [(*a, *b), (*b, *c), (*c, *a)].contains(&(p, q)))
                .count()
        };
        let paired = faces.iter().all(|&[a, b, c]| {
            [(a, b), (b, c), (c, a)]
                .iter()
                .all(|&(p, q)| runs(p, q) == 1 && runs(q, p) == 1)
        });
        paired
            && (0..mesh.positions.len() as u32).all(|v| {
                let fan: Vec<_> = faces.iter().filter(|f| f.contains(&v)).collect();
                let mut reached = vec![false; fan.len()];
                let mut open = vec![0];
                while let Some(i) = open.pop() {
                    if i < fan.len() && !core::mem::replace(&mut reached[i], true) {
                        open.extend(
                            (0..fan.len())
                                .filter(|&j| fan[i].iter().any(|w| *w != v && fan[j].contains(w))),
                        );
                    }
                }
                reached.iter().all(|&r| r)
            })
    }

    #[test]
    fn a_third_face_opens_another_record() {
        // Three faces on the edge 0-1, two of them up; one more that runs down.
        let fan = mesh(6, &[[0, 1, 2], [0, 1, 3], [1, 0, 4], [0, 1, 5]]);
        let on_edge: Vec<_> = fan
            .edges()
            .into_iter()
            .filter(|e| (e.from, e.to) == (0, 1))
            .collect();
        let expected = [(Some(0), Some(2)), (Some(1), None), (Some(3), None)];
        assert_eq!(
            on_edge
                .iter()
                .map(|e| (e.left, e.right))
                .collect::<Vec<_>>(),
            expected
        );
    }

    #[test]
    fn at_most_three_records_a_triangle() {
        for mesh in [
            solids::slide_cube(),
            solids::torus(3.0, 1.0, 40, 30).unwrap(),
            solids::teapot(5).unwrap(),
        ] {
            let mut work = Work::default();
            let edges = mesh.edges_counted(&mut work);
            assert_eq!(edges, mesh.edges());
            assert_eq!(work.edge_records, 3 * mesh.triangles.len() as u64);
            let sides = edges
                .iter()
                .flat_map(|e| [e.left, e.right])
                .flatten()
                .count();
            assert_eq!(work.edge_records, sides as u64);
        }
    }

    #[test]
    fn a_vertex_with_many_edges() {
        // More than are sorted by insertion, and higher vertices that differ in each of three bytes.
        let n = 100_000u64;
        let star: Vec<_> = (1..n)
            .map(|i| ((i * 70_001) % n) as u32)
            .filter(|&i| i > 0)
            .collect();
        let triangles: Vec<_> = star.windows(2).map(|w| [0, w[0], w[1]]).collect();
        let star = mesh(n as usize, &triangles);
        assert_eq!(star.edges(), edges_by_map(&star));
    }

    #[test]
    fn closed_and_two_manifold() {
        let tetrahedron = solids::tetrahedron();
        let mut turned = tetrahedron.clone();
        turned.triangles[2].reverse();
        let mut open = tetrahedron.clone();
        open.triangles.pop();
        // Two that share vertex 0 alone: closed, two faces an edge, but two fans.
        let mut touching = tetrahedron.clone();
        let second = |v: u32| if v == 0 { 0 } else { v + 3 };
        let copies = tetrahedron.triangles.iter().map(|t| t.map(second));
        touching.triangles.extend(copies);
        touching.positions.extend_from_within(1..);
        let mut twice = tetrahedron.clone();
        twice.triangles.extend_from_within(..);
        // A torus of 2 × 5 squares: the two ways from (0, j) to (1, j) join the same two vertices.
        let at = |i: u32, j: u32| 5 * (i % 2) + j % 5;
        let squares = (0..2).flat_map(|i| (0..5).map(move |j| (i, j)));
        let narrow: Vec<_> = squares
            .flat_map(|(i, j)| {
                let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
                [[a, b, c], [a, c, d]]
            })
            .collect();
        let cases = [
            ("a narrow torus", mesh(10, &narrow), true, false),
            ("empty", mesh(0, &[]), true, true),
            ("vertices alone", mesh(3, &[]), true, true),
            ("a missing vertex", mesh(3, &[[0, 1, 3]]), true, true),
            ("a vertex three times", mesh(3, &[[1, 1, 1]]), true, false),
            ("a vertex twice", mesh(3, &[[1, 1, 2]]), true, false),
            ("one triangle", mesh(3, &[[0, 1, 2]]), false, false),
            (
                "both its sides",
                mesh(3, &[[0, 1, 2], [0, 2, 1]]),
                true,
                true,
            ),
            ("two that touch", touching, true, false),
            ("tetrahedron", tetrahedron, true, true),
            ("a face turned over", turned, false, false),
            ("a face missing", open, false, false),
            ("each face twice", twice, true, false),
        ];
        for (name, mesh, closed, manifold) in cases {
            assert_eq!(
                (mesh.is_closed(), mesh.is_two_manifold()),
                (closed, manifold),
                "{name}"
            );
        }
    }

    /// Solids, damaged in ways that keep the indices plausible.
    fn damaged() -> impl Strategy<Value = Mesh> {
        let solid = prop_oneof![
            Just(solids::tetrahedron()),
            Just(solids::slide_cube()),
            Just(solids::torus(3.0, 1.0, 3, 4).unwrap()),
            Just(solids::sphere(1.0, 5, 4).unwrap()),
        ];
        let damage = (
            0..6u8,
            any::<prop::sample::Index>(),
            any::<prop::sample::Index>(),
        );
        (solid, prop::collection::vec(damage, 0..3)).prop_map(|(mut mesh, damage)| {
            for (kind, i, j) in damage {
                let (t, v, w) = (
                    i.index(mesh.triangles.len()),
                    i.index(mesh.positions.len()) as u32,
                    j.index(mesh.positions.len()) as u32,
                );
                match kind {
                    0 => mesh.triangles.swap(t, 0),
                    1 => mesh.triangles[t].reverse(),
                    2 => mesh
                        .triangles
                        .iter_mut()
                        .flatten()
                        .filter(|x| **x == v)
                        .for_each(|x| *x = w),
                    3 => mesh.triangles.push(mesh.triangles[t]),
                    4 => mesh.triangles[t][0] = w,
                    _ => {
                        mesh.positions.pop();
                    }
                }
            }
            mesh
        })
    }

    fn any_mesh() -> impl Strategy<Value = Mesh> {
        (
            0..7usize,
            prop::collection::vec([0..8u32, 0..8u32, 0..8u32], 0..24),
        )
            .prop_map(|(n, t)| mesh(n, &t))
    }

    proptest! {
        #[test]
        fn edges_are_those_of_a_map(mesh in prop_oneof![any_mesh(), damaged()]) {
            let mut work = Work::default();
            let edges = mesh.edges_counted(&mut work);
            prop_assert_eq!(&edges, &edges_by_map(&mesh));
            prop_assert!(work.edge_records <= 3 * mesh.triangles.len() as u64);
            prop_assert!(edges.is_sorted_by_key(|e| (e.from, e.to)));
        }

        #[test]
        fn two_manifold_by_definition(mesh in prop_oneof![any_mesh(), damaged()]) {
            prop_assert_eq!(mesh.is_two_manifold(), is_two_manifold_by_definition(&mesh));
            prop_assert!(!mesh.is_two_manifold() || mesh.is_closed());
        }
    }
}
