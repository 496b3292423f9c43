//! Indexed triangle meshes: shared vertices, edges with the two faces beside them, vertex normals.
//!
//! A shadow volume is drawn from the edges between a lit and an unlit face, so a mesh must tell for each edge
//! which faces it has, and whether every edge has two. Everything here takes time linear in the mesh.

use crate::triangle::{scaled_normal, unit};
use crate::work::{Count, Counter};
use core::fmt;
use glam::DVec3;

/// Triangles that share vertices.
///
/// # Properties
///
/// A face is seen from the side from which its vertices run counter-clockwise. [`Mesh::new`] checks what it is
/// given; the fields are public, so every method is total as well: a triangle that names a missing vertex is as
/// good as absent.
///
/// # Examples
///
/// ```
/// use ombra_math::glam::DVec3;
/// use ombra_math::mesh::{Mesh, MeshError};
///
/// let corners = vec![DVec3::ZERO, DVec3::X, DVec3::Y];
/// let mesh = Mesh::new(corners.clone(), vec![[0, 1, 2]]).unwrap();
/// assert!(!mesh.is_closed());
///
/// let error = Mesh::new(corners, vec![[0, 1, 3]]).unwrap_err();
/// assert_eq!(error, MeshError::Index { triangle: 0, index: 3, vertices: 3 });
/// assert_eq!(error.to_string(), "triangle 0 names vertex 3, but there are 3, numbered from 0");
/// ```
///
/// # References
///
/// Grafica 3 and CIS 781 take their casters so; Olomouc, «Stínové těleso».
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// The places of the vertices.
    pub positions: Vec<DVec3>,
    /// The three vertices of each triangle, as indices into `positions`.
    pub triangles: Vec<[u32; 3]>,
}

/// What is wrong with a mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum MeshError {
    /// A triangle names a vertex that is not there.
    Index {
        /// The triangle.
        triangle: usize,
        /// The vertex it names.
        index: u32,
        /// How many vertices there are.
        vertices: usize,
    },
    /// A position is NaN or infinite.
    Position {
        /// The vertex.
        vertex: usize,
        /// Its position.
        position: DVec3,
    },
    /// More than [`Mesh::MAX_TRIANGLES`].
    TooManyTriangles {
        /// How many there are.
        triangles: usize,
    },
}

impl fmt::Display for MeshError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Index {
                triangle,
                index,
                vertices,
            } => write!(
                f,
                "triangle {triangle} names vertex {index}, but there are {vertices}, numbered from 0"
            ),
            Self::Position { vertex, position } => {
                write!(
                    f,
                    "vertex {vertex} is at {position}; its coordinates must be finite numbers"
                )
            }
            Self::TooManyTriangles { triangles } => {
                write!(
                    f,
                    "{triangles} triangles are too many; at most {} are allowed",
                    Mesh::MAX_TRIANGLES
                )
            }
        }
    }
}

impl core::error::Error for MeshError {}

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

/// How much each face counts in a vertex normal.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Weighting {
    /// All faces alike.
    Plain,
    /// Large faces more: by area.
    Area,
    /// Wide corners more: by the face's angle at the vertex.
    Angle,
}

impl Mesh {
    /// The most triangles a mesh can have, 1 431 655 765: their sides are numbered with 32 bits.
    pub const MAX_TRIANGLES: usize = (u32::MAX / 3) as usize;

    /// A mesh of `positions` and `triangles`, checked.
    ///
    /// # Errors
    ///
    /// A triangle that names a missing vertex, a position that is not finite, more than
    /// [`Mesh::MAX_TRIANGLES`]. Degenerate triangles and unused vertices are allowed.
    pub fn new(positions: Vec<DVec3>, triangles: Vec<[u32; 3]>) -> Result<Self, MeshError> {
        if triangles.len() > Self::MAX_TRIANGLES {
            return Err(MeshError::TooManyTriangles {
                triangles: triangles.len(),
            });
        }
        if let Some((vertex, &position)) =
            positions.iter().enumerate().find(|(_, p)| !p.is_finite())
        {
            return Err(MeshError::Position { vertex, position });
        }
        let vertices = positions.len();
        for (triangle, corners) in triangles.iter().enumerate() {
            if let Some(&index) = corners.iter().find(|&&i| i as usize >= vertices) {
                return Err(MeshError::Index {
                    triangle,
                    index,
                    vertices,
                });
            }
        }
        Ok(Self {
            positions,
            triangles,
        })
    }

    /// The corners of triangle `i`, or `None` if there is no such triangle or one of its vertices is missing.
    #[must_use]
    pub fn triangle(&self, i: usize) -> Option<[DVec3; 3]> {
        let &[a, b, c] = self.triangles.get(i)?;
        let at = |index: u32| self.positions.get(index as usize).copied();
        Some([at(a)?, at(b)?, at(c)?])
    }

    /// The lowest and the highest of each coordinate, or `None` without positions. NaN is passed over.
    #[must_use]
    pub fn bounds(&self) -> Option<[DVec3; 2]> {
        let &first = self.positions.first()?;
        let extend = |choose: fn(f64, f64) -> f64| {
            self.positions.iter().fold(first, |a, b| {
                DVec3::new(choose(a.x, b.x), choose(a.y, b.y), choose(a.z, b.z))
            })
        };
        Some([extend(f64::min), extend(f64::max)])
    }

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
            if left == right || previous == Some((e.from, e.to)) {
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

    /// Unit normal of each vertex, averaged from the faces around it.
    ///
    /// # Formula
    ///
    /// ```text
    /// n = Σ wᵢ nᵢ, made unit     nᵢ the unit normals of the faces at the vertex
    /// wᵢ = 1 (plain), the face's area, or its angle at the vertex
    /// ```
    ///
    /// # Properties
    ///
    /// Holds at every scale. Only the angle weighting is the same however a flat side is cut into triangles.
    ///
    /// # Pitfalls
    ///
    /// At (0, 20, 0) of the slide's cube two triangles of one side meet, and one of the other: the plain mean is
    /// (−1, −2, −2)/3, not (−1, −1, −1)/√3. Where faces nearly cancel, rounding picks the direction.
    ///
    /// # Errors
    ///
    /// A face without area or with a coordinate that is not finite counts for nothing. A vertex that has no other
    /// face, or whose faces cancel, gets `DVec3::ZERO`.
    ///
    /// # Examples
    ///
    /// ```
    /// use ombra_math::glam::DVec3;
    /// use ombra_math::mesh::Weighting;
    /// use ombra_math::solids::slide_cube;
    ///
    /// let cube = slide_cube();
    /// assert_eq!(cube.vertex_normals(Weighting::Plain)[0], DVec3::new(-1.0, -2.0, -2.0) / 3.0);
    /// let corner = DVec3::splat(-1.0).normalize();
    /// assert!((cube.vertex_normals(Weighting::Angle)[0] - corner).length() < 1e-15);
    /// ```
    ///
    /// # References
    ///
    /// Olomouc, «Gouraud shading». G. Thürmer and C. Wüthrich, «Computing Vertex Normals from Polygonal
    /// Facets», 1998: the angle weighting.
    #[must_use]
    pub fn vertex_normals(&self, weighting: Weighting) -> Vec<DVec3> {
        let faces = || {
            (0..self.triangles.len()).filter_map(|i| {
                let corners = self.triangle(i)?;
                let [a, b, c] = corners;
                let (n, exponent) = scaled_normal(a, b, c);
                Some((self.triangles[i], corners, n, exponent, unit(n)?))
            })
        };
        // Areas are summed relative to the largest at the vertex, so that none overflows or vanishes.
        let mut largest = vec![i32::MIN; self.positions.len()];
        if weighting == Weighting::Area {
            for (triangle, _, _, exponent, _) in faces() {
                for v in triangle {
                    let at_vertex = &mut largest[v as usize];
                    *at_vertex = exponent.max(*at_vertex);
                }
            }
        }
        let mut sums = vec![DVec3::ZERO; self.positions.len()];
        for (triangle, corners, n, exponent, unit_n) in faces() {
            for (k, v) in triangle.into_iter().enumerate() {
                let v = v as usize;
                sums[v] += match weighting {
                    Weighting::Plain => unit_n,
                    Weighting::Area => n * libm::scalbn(1.0, exponent - largest[v]),
                    Weighting::Angle => {
                        unit_n * angle(corners[k], corners[(k + 1) % 3], corners[(k + 2) % 3])
                    }
                };
            }
        }
        sums.into_iter()
            .map(|sum| unit(sum).unwrap_or(DVec3::ZERO))
            .collect()
    }

    /// Each triangle, or `None` in the place of one that names a missing vertex.
    fn used_triangles(&self) -> impl Iterator<Item = Option<[u32; 3]>> {
        let vertices = self.positions.len();
        self.triangles
            .iter()
            .take(Self::MAX_TRIANGLES)
            .map(move |&t| t.iter().all(|&i| (i as usize) < vertices).then_some(t))
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

/// The angle at `a` of the triangle `a`, `b`, `c`.
fn angle(a: DVec3, b: DVec3, c: DVec3) -> f64 {
    // Halves, where a difference itself is too long.
    let towards = |p: DVec3| {
        if (p - a).is_finite() {
            unit(p - a)
        } else {
            unit(p * 0.5 - a * 0.5)
        }
    };
    match (towards(b), towards(c)) {
        (Some(u), Some(v)) => libm::atan2(u.cross(v).length(), u.dot(v)),
        _ => 0.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solids;
    use crate::work::Work;
    use proptest::num::f64::ANY;
    use proptest::prelude::*;
    use std::collections::BTreeMap;

    const EPS: f64 = f64::EPSILON;

    fn mesh(vertices: usize, triangles: &[[u32; 3]]) -> Mesh {
        Mesh {
            positions: vec![DVec3::ZERO; vertices],
            triangles: triangles.to_vec(),
        }
    }

    /// Exercise math3: the corner's normal under each weighting.
    #[test]
    fn the_slide_cubes_corners() {
        let cube = solids::slide_cube();
        assert_eq!(
            cube.vertex_normals(Weighting::Plain)[0],
            DVec3::new(-1.0, -2.0, -2.0) / 3.0
        );
        // All triangles are alike, so area changes nothing.
        let by_area = cube.vertex_normals(Weighting::Area);
        assert!((by_area[0] - DVec3::new(-1.0, -2.0, -2.0) / 3.0).length() <= 4.0 * EPS);
        let middle = DVec3::new(5.0, 25.0, 5.0);
        for (n, p) in cube
            .vertex_normals(Weighting::Angle)
            .into_iter()
            .zip(&cube.positions)
        {
            let corner = (p - middle).signum() / 3f64.sqrt();
            assert!((n - corner).length() <= 4.0 * EPS, "{p}: {n}");
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
        let mut twice = tetrahedron.clone();
        twice.triangles.extend_from_within(..);
        let cases = [
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

    #[test]
    fn rejected() {
        let three = vec![DVec3::ZERO, DVec3::X, DVec3::Y];
        let bad = DVec3::new(0.0, f64::NEG_INFINITY, 0.0);
        let error = MeshError::Index {
            triangle: 1,
            index: u32::MAX,
            vertices: 3,
        };
        assert_eq!(
            Mesh::new(three.clone(), vec![[0, 1, 2], [0, u32::MAX, 1]]),
            Err(error)
        );
        let error = MeshError::Position {
            vertex: 1,
            position: bad,
        };
        assert_eq!(Mesh::new(vec![DVec3::ZERO, bad], vec![]), Err(error));
        assert!(error.to_string().contains("vertex 1") && error.to_string().contains("-inf"));
        assert!(Mesh::new(vec![], vec![]).is_ok());
        assert!(Mesh::new(three, vec![[0, 0, 0]]).is_ok());
    }

    #[test]
    fn degenerate() {
        assert_eq!(mesh(0, &[]).bounds(), None);
        let cube = solids::slide_cube();
        assert_eq!(
            cube.bounds(),
            Some([DVec3::new(0.0, 20.0, 0.0), DVec3::new(10.0, 30.0, 10.0)])
        );
        assert_eq!(mesh(2, &[[0, 1, 2]]).triangle(0), None);
        assert_eq!(mesh(2, &[]).triangle(0), None);
        let sheet = |a: DVec3, b: DVec3, c: DVec3| Mesh {
            positions: vec![a, b, c, DVec3::ONE],
            triangles: vec![[0, 1, 2]],
        };
        let (o, x, y) = (DVec3::ZERO, DVec3::X, DVec3::Y);
        let cases = [
            ("collinear", sheet(o, x, x * 2.0), o),
            ("NaN", sheet(o, x, y * f64::NAN), o),
            ("infinite", sheet(o, x, y * f64::INFINITY), o),
            ("subnormal", sheet(o, x * 5e-324, y * 5e-324), DVec3::Z),
            (
                "the whole range",
                sheet(DVec3::splat(-f64::MAX), x * f64::MAX, y * f64::MAX),
                (DVec3::Z - x - y).normalize(),
            ),
        ];
        for (name, mesh, expected) in cases {
            for weighting in [Weighting::Plain, Weighting::Area, Weighting::Angle] {
                let normals = mesh.vertex_normals(weighting);
                assert_eq!(normals[3], DVec3::ZERO, "{name}: a vertex without faces");
                if name != "the whole range" {
                    assert_eq!(normals[..3], [expected; 3], "{name} {weighting:?}");
                }
                assert!(normals.iter().all(|n| n.is_finite()), "{name}");
            }
        }
        let both_sides = Mesh {
            positions: vec![o, x, y],
            triangles: vec![[0, 1, 2], [0, 2, 1]],
        };
        assert_eq!(
            both_sides.vertex_normals(Weighting::Angle),
            [DVec3::ZERO; 3]
        );
    }

    #[test]
    fn weights_are_what_they_say() {
        // At the origin: a face with normal +z, area a, right angle; one with normal +x, area b, angle of 45°.
        let (long, s) = (7.0, 3.0);
        let mesh = Mesh {
            positions: vec![
                DVec3::ZERO,
                DVec3::X * s,
                DVec3::Y * long,
                DVec3::Y * 5.0,
                DVec3::new(0.0, 5.0, 5.0),
            ],
            triangles: vec![[0, 1, 2], [0, 3, 4]],
        };
        for (weighting, z, x) in [
            (Weighting::Plain, 1.0, 1.0),
            (Weighting::Area, s * long / 2.0, 12.5),
            (Weighting::Angle, 2.0, 1.0),
        ] {
            let expected = DVec3::new(x, 0.0, z).normalize();
            for scale in [1e-300, 1e-160, 1.0, 1e160, 1e300] {
                let mut scaled = mesh.clone();
                scaled.positions.iter_mut().for_each(|p| *p *= scale);
                let n = scaled.vertex_normals(weighting)[0];
                // Scaling rounds each coordinate once.
                assert!(
                    (n - expected).length() <= 8.0 * EPS,
                    "{weighting:?} {scale}: {n}"
                );
            }
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

        #[test]
        fn never_panics(p in prop::collection::vec([ANY, ANY, ANY], 0..6), t in prop::collection::vec([0..7u32, 0..7u32, 0..7u32], 0..8)) {
            let mesh = Mesh { positions: p.into_iter().map(DVec3::from_array).collect(), triangles: t };
            for weighting in [Weighting::Plain, Weighting::Area, Weighting::Angle] {
                for n in mesh.vertex_normals(weighting) {
                    prop_assert!(n == DVec3::ZERO || (n.length() - 1.0).abs() <= 4.0 * EPS);
                }
            }
            let _ = (mesh.bounds(), mesh.is_closed(), mesh.is_two_manifold());
            let _ = Mesh::new(mesh.positions, mesh.triangles);
        }
    }
}
