//! Time of `Mesh::edges` on a mesh of a million triangles, beside a hash map and the reading of the mesh.
//!
//! `cargo run --release -p ombra-math --example edges_time`
//!
//! All run in turn in every round; the table gives medians of wall time and the spread (lowest … highest).

use ombra_math::mesh::Mesh;
use ombra_math::solids;
use ombra_math::work::Work;
use std::collections::HashMap;
use std::hint::black_box;
use std::time::{Duration, Instant};

const ROUNDS: usize = 15;

/// Edges as most write them first: each side looked up by its two vertices. Gives their number.
fn edges_by_hash_map(mesh: &Mesh) -> usize {
    let mut edges: HashMap<(u32, u32), [Option<u32>; 2]> = HashMap::new();
    for (t, &[a, b, c]) in (0u32..).zip(&mesh.triangles) {
        for (p, q) in [(a, b), (b, c), (c, a)] {
            edges.entry((p.min(q), p.max(q))).or_default()[usize::from(p > q)] = Some(t);
        }
    }
    black_box(&edges).len()
}

/// The least that any such method does: every position and index once.
fn read(mesh: &Mesh) -> u64 {
    let indices = mesh
        .triangles
        .iter()
        .flatten()
        .fold(0u64, |sum, &i| sum + u64::from(i));
    let bits = |sum: u64, x: &f64| sum ^ x.to_bits();
    mesh.positions
        .iter()
        .fold(indices, |sum, p| p.as_ref().iter().fold(sum, bits))
}

/// The same mesh with vertices and triangles numbered at random, the worst case for caches.
fn shuffled(mesh: &Mesh) -> Mesh {
    let mut state = 0x9e37_79b9_7f4a_7c15u64;
    let mut below = |n: usize| {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state % n as u64) as usize
    };
    let mut name: Vec<u32> = (0..mesh.positions.len() as u32).collect();
    let mut triangles = mesh.triangles.clone();
    for i in (1..name.len()).rev() {
        name.swap(i, below(i + 1));
    }
    for i in (1..triangles.len()).rev() {
        triangles.swap(i, below(i + 1));
    }
    let mut positions = mesh.positions.clone();
    for (from, &to) in name.iter().enumerate() {
        positions[to as usize] = mesh.positions[from];
    }
    triangles
        .iter_mut()
        .flatten()
        .for_each(|i| *i = name[*i as usize]);
    Mesh {
        positions,
        triangles,
    }
}

fn time<R>(of: impl FnOnce() -> R) -> Duration {
    let start = Instant::now();
    black_box(of());
    start.elapsed()
}

fn main() -> Result<(), solids::SolidError> {
    let torus = solids::torus(3.0, 1.0, 1024, 512)?;
    for (name, mesh) in [("in order", &torus), ("shuffled", &shuffled(&torus))] {
        let mut work = Work::default();
        let edges = mesh.edges_counted(&mut work);
        assert_eq!(edges.len(), edges_by_hash_map(mesh));
        println!(
            "{name}: {} triangles, {} vertices, {} edges; {work}",
            mesh.triangles.len(),
            mesh.positions.len(),
            edges.len()
        );
        let mut times: [Vec<Duration>; 3] = Default::default();
        for _ in 0..ROUNDS {
            times[0].push(time(|| read(mesh)));
            times[1].push(time(|| mesh.edges()));
            times[2].push(time(|| edges_by_hash_map(mesh)));
        }
        let mut base = None;
        for (what, mut times) in ["read the mesh", "Mesh::edges", "std HashMap"]
            .into_iter()
            .zip(times)
        {
            times.sort_unstable();
            let milliseconds = |t: Duration| t.as_secs_f64() * 1e3;
            let median = milliseconds(times[ROUNDS / 2]);
            let base = *base.get_or_insert(median);
            println!(
                "  {what:14} {median:8.2} ms   ({:.2} … {:.2})   {:6.1} × reading",
                milliseconds(times[0]),
                milliseconds(times[ROUNDS - 1]),
                median / base
            );
        }
    }
    Ok(())
}
