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
