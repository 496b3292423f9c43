//! Newell's teapot, evaluated from its bicubic Bézier patches.

use super::{Rings, SolidError, allowed, at_least};
use crate::mesh::Mesh;
use glam::{DVec2, DVec3};

/// A row of control points of a patch of the pot or the lid, a quarter of a ring around the axis.
///
/// In the published coordinates, z up, the row is (r, 0, z), (r, −t, z), (t, −r, z), (0, −r, z); the three other
/// quarters are its reflections.
#[derive(Clone, Copy)]
struct Ring {
    r: f64,
    t: f64,
    z: f64,
}

/// A row of control points of a patch of the handle or the spout, half of a ring across the tube.
///
/// In the published coordinates the row is (x, 0, z), (x, −w, z) at `a` = (x, z), then (x, −w, z), (x, 0, z) at
/// `b`; the other half is its reflection in y = 0.
#[derive(Clone, Copy)]
struct Loop {
    a: DVec2,
    b: DVec2,
    w: f64,
}

const fn ring(r: f64, t: f64, z: f64) -> Ring {
    Ring { r, t, z }
}

const fn around(a: (f64, f64), b: (f64, f64), w: f64) -> Loop {
    Loop {
        a: DVec2::new(a.0, a.1),
        b: DVec2::new(b.0, b.1),
        w,
    }
}

/// Rim, upper body, lower body, bottom: each patch ends with the row the next begins with.
const POT: [Ring; 13] = [
    ring(1.4, 0.784, 2.4),
    ring(1.3375, 0.749, 2.53125),
    ring(1.4375, 0.805, 2.53125),
    ring(1.5, 0.84, 2.4),
    ring(1.75, 0.98, 1.875),
    ring(2.0, 1.12, 1.35),
    ring(2.0, 1.12, 0.9),
    ring(2.0, 1.12, 0.45),
    ring(1.5, 0.84, 0.225),
    ring(1.5, 0.84, 0.15),
    ring(1.5, 0.84, 0.075),
    ring(1.425, 0.798, 0.0),
    ring(0.0, 0.0, 0.0),
];

/// Knob and lid.
const LID: [Ring; 7] = [
    ring(0.0, 0.0, 3.15),
    ring(0.8, 0.45, 3.15),
    ring(0.0, 0.0, 2.85),
    ring(0.2, 0.112, 2.7),
    ring(0.4, 0.224, 2.55),
    ring(1.3, 0.728, 2.55),
    ring(1.3, 0.728, 2.4),
];

/// From the upper end to the lower.
const HANDLE: [Loop; 7] = [
    around((-1.6, 2.025), (-1.5, 2.25), 0.3),
    around((-2.3, 2.025), (-2.5, 2.25), 0.3),
    around((-2.7, 2.025), (-3.0, 2.25), 0.3),
    around((-2.7, 1.8), (-3.0, 1.8), 0.3),
    around((-2.7, 1.575), (-3.0, 1.35), 0.3),
    around((-2.5, 1.125), (-2.65, 0.9375), 0.3),
    around((-2.0, 0.9), (-1.9, 0.6), 0.3),
];

/// From the body to the tip.
const SPOUT: [Loop; 7] = [
    around((1.7, 1.425), (1.7, 0.6), 0.66),
    around((2.6, 1.425), (3.1, 0.825), 0.66),
    around((2.3, 2.1), (2.4, 2.025), 0.25),
    around((2.7, 2.4), (3.3, 2.4), 0.25),
    around((2.8, 2.475), (3.525, 2.49375), 0.25),
    around((2.9, 2.475), (3.45, 2.5125), 0.15),
    around((2.8, 2.4), (3.2, 2.4), 0.15),
];

/// The Utah teapot, each side of its 32 patches cut in `divisions`.
///
/// # Formula
///
/// ```text
/// P(u, v) = Σ Bᵢ(v) Bⱼ(u) Pᵢⱼ      B₀ = (1−t)³, B₁ = 3t(1−t)², B₂ = 3t²(1−t), B₃ = t³
/// ```
///
/// # Properties
///
/// y is up, the spout points along +x, the handle along −x. The base stands on y = 0, the knob ends at y = 3.15; the body
/// is 4 wide. (The published data have z up; theirs is x, y, z ↦ x, z, −y here.) 64 n² − 8 n triangles, none
/// degenerate; a corner of the 32 patches is a vertex. Patches share the vertices along their seams and at the
/// poles (knob, middle of the base), and the two reflections hold to the last bit.
///
/// It is *not* closed, and neither is the original. Its four pieces share no vertex, and six loops of edges are open:
///
/// | piece | open at | edges |
/// | --- | --- | --- |
/// | pot: rim, body, base | the inner edge of the rim: circle of radius 1.4 at y = 2.4 | 4 n |
/// | lid with knob | its lower edge: circle of radius 1.3 at y = 2.4, so a gap of 0.1 to the rim | 4 n |
/// | handle | its upper end, within the body | 2 n |
/// | handle | its lower end, within the body, which it touches in the point (−2, 0.9, 0) | 2 n |
/// | spout | its lower end, within the body | 2 n |
/// | spout | its tip, the mouth, turned inwards | 2 n |
///
/// # Pitfalls
///
/// Handle and spout run into the body without joining it, and a pot without thickness shows its back
/// faces through the gap. Shadow volumes that need a closed caster do not take it as it is. The "circles" are cubic
/// Béziers, up to 0.6 % off.
///
/// # Errors
///
/// Fewer than 2 divisions (a loop of the handle would have two edges, one upon the other) or more than 512
/// ([`MAX_TRIANGLES`](super::MAX_TRIANGLES)).
///
/// # Examples
///
/// ```
/// use ombra_math::solids::teapot;
///
/// let pot = teapot(4).unwrap();
/// assert_eq!(pot.triangles.len(), 64 * 4 * 4 - 8 * 4);
/// let open = pot.edges().iter().filter(|e| e.left.is_none() || e.right.is_none()).count();
/// assert_eq!(open, 2 * (4 * 4) + 4 * (2 * 4));
/// ```
///
/// # References
///
/// M. Newell, «The Utilization of Procedure Models in Digital Image Synthesis», 1975, as scaled by J. Blinn;
/// F. Crow, «The Origins of the Teapot», IEEE CG&A 7(1), 1987. The four patches of the base were added to
/// Newell's 28 later.
pub fn teapot(divisions: u32) -> Result<Mesh, SolidError> {
    at_least("divisions", divisions, 2)?;
    let n = u128::from(divisions);
    allowed(64 * n * n - 8 * n)?;
    let mut rings = Rings::default();
    for profile in [&POT[..], &LID[..]] {
        for_each_row(profile, divisions, |rows, weights| {
            let mix = |of: fn(&Ring) -> f64| mix(rows.map(|row| of(&row)), weights);
            rings.push(lathe(
                mix(|row| row.r),
                mix(|row| row.t),
                mix(|row| row.z),
                divisions,
            ));
        });
        rings.cut();
    }
    for tube in [&HANDLE[..], &SPOUT[..]] {
        for_each_row(tube, divisions, |rows, weights| {
            let mix = |of: fn(&Loop) -> f64| mix(rows.map(|row| of(&row)), weights);
            let row = Loop {
                a: DVec2::new(mix(|row| row.a.x), mix(|row| row.a.y)),
                b: DVec2::new(mix(|row| row.b.x), mix(|row| row.b.y)),
                w: mix(|row| row.w),
            };
            rings.push(across(row, divisions));
        });
        rings.cut();
    }
    Ok(rings.mesh)
}

/// Steps along a chain of patches; rows where two patches meet come once.
fn for_each_row<R: Copy>(chain: &[R], n: u32, mut visit: impl FnMut([R; 4], [f64; 4])) {
    // Windows of four rows that begin at every third: the patches.
    for (i, patch) in chain.windows(4).step_by(3).enumerate() {
        if let &[a, b, c, d] = patch {
            for k in u32::from(i > 0)..=n {
                visit([a, b, c, d], bernstein(k, n));
            }
        }
    }
}

/// The ring with radius r, tangent t and height z of its control points, or a pole.
fn lathe(r: f64, t: f64, z: f64, n: u32) -> Vec<DVec3> {
    if r == 0.0 {
        return vec![DVec3::new(0.0, z, 0.0)];
    }
    // Along a quarter: r, r, t, 0 one way and, the same backwards, 0, t, r, r the other way.
    let along = |k: u32| mix([r, r, t, 0.0], bernstein(k, n));
    (0..4 * n)
        .map(|k| {
            let (p, q) = (along(k % n), along(n - k % n));
            let (x, y) = match k / n {
                0 => (p, q),
                1 => (-q, p),
                2 => (-p, -q),
                _ => (q, -p),
            };
            DVec3::new(x, z, -y)
        })
        .collect()
}

/// The loop across a tube: from a over +y to b, and back over −y.
fn across(row: Loop, n: u32) -> Vec<DVec3> {
    (0..2 * n)
        .map(|k| {
            let (k, side) = if k < n { (k, 1.0) } else { (2 * n - k, -1.0) };
            let weights = bernstein(k, n);
            let x = mix([row.a.x, row.a.x, row.b.x, row.b.x], weights);
            let z = mix([row.a.y, row.a.y, row.b.y, row.b.y], weights);
            let y = mix([0.0, row.w, row.w, 0.0], weights);
            DVec3::new(x, z, -side * y)
        })
        .collect()
}

/// B₀ … B₃ at t = k/n; those at n − k are the same backwards, to the last bit.
fn bernstein(k: u32, n: u32) -> [f64; 4] {
    let (t, s) = (f64::from(k) / f64::from(n), f64::from(n - k) / f64::from(n));
    [
        s * s * s,
        3.0 * (t * (s * s)),
        3.0 * (s * (t * t)),
        t * t * t,
    ]
}

fn mix([a, b, c, d]: [f64; 4], [wa, wb, wc, wd]: [f64; 4]) -> f64 {
    (a * wa + d * wd) + (b * wb + c * wc)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeMap;

    const EPS: f64 = f64::EPSILON;

    /// The published patches, z up, one of each reflected set, with their control points written out.
    #[rustfmt::skip]
    const PUBLISHED: [[[f64; 3]; 16]; 10] = [
        // rim
        [
            [1.4, 0.0, 2.4], [1.4, -0.784, 2.4], [0.784, -1.4, 2.4], [0.0, -1.4, 2.4],
            [1.3375, 0.0, 2.53125], [1.3375, -0.749, 2.53125], [0.749, -1.3375, 2.53125], [0.0, -1.3375, 2.53125],
            [1.4375, 0.0, 2.53125], [1.4375, -0.805, 2.53125], [0.805, -1.4375, 2.53125], [0.0, -1.4375, 2.53125],
            [1.5, 0.0, 2.4], [1.5, -0.84, 2.4], [0.84, -1.5, 2.4], [0.0, -1.5, 2.4],
        ],
        // upper body
        [
            [1.5, 0.0, 2.4], [1.5, -0.84, 2.4], [0.84, -1.5, 2.4], [0.0, -1.5, 2.4],
            [1.75, 0.0, 1.875], [1.75, -0.98, 1.875], [0.98, -1.75, 1.875], [0.0, -1.75, 1.875],
            [2.0, 0.0, 1.35], [2.0, -1.12, 1.35], [1.12, -2.0, 1.35], [0.0, -2.0, 1.35],
            [2.0, 0.0, 0.9], [2.0, -1.12, 0.9], [1.12, -2.0, 0.9], [0.0, -2.0, 0.9],
        ],
        // lower body
        [
            [2.0, 0.0, 0.9], [2.0, -1.12, 0.9], [1.12, -2.0, 0.9], [0.0, -2.0, 0.9],
            [2.0, 0.0, 0.45], [2.0, -1.12, 0.45], [1.12, -2.0, 0.45], [0.0, -2.0, 0.45],
            [1.5, 0.0, 0.225], [1.5, -0.84, 0.225], [0.84, -1.5, 0.225], [0.0, -1.5, 0.225],
            [1.5, 0.0, 0.15], [1.5, -0.84, 0.15], [0.84, -1.5, 0.15], [0.0, -1.5, 0.15],
        ],
        // knob
        [
            [0.0, 0.0, 3.15], [0.0, 0.0, 3.15], [0.0, 0.0, 3.15], [0.0, 0.0, 3.15],
            [0.8, 0.0, 3.15], [0.8, -0.45, 3.15], [0.45, -0.8, 3.15], [0.0, -0.8, 3.15],
            [0.0, 0.0, 2.85], [0.0, 0.0, 2.85], [0.0, 0.0, 2.85], [0.0, 0.0, 2.85],
            [0.2, 0.0, 2.7], [0.2, -0.112, 2.7], [0.112, -0.2, 2.7], [0.0, -0.2, 2.7],
        ],
        // lid
        [
            [0.2, 0.0, 2.7], [0.2, -0.112, 2.7], [0.112, -0.2, 2.7], [0.0, -0.2, 2.7],
            [0.4, 0.0, 2.55], [0.4, -0.224, 2.55], [0.224, -0.4, 2.55], [0.0, -0.4, 2.55],
            [1.3, 0.0, 2.55], [1.3, -0.728, 2.55], [0.728, -1.3, 2.55], [0.0, -1.3, 2.55],
            [1.3, 0.0, 2.4], [1.3, -0.728, 2.4], [0.728, -1.3, 2.4], [0.0, -1.3, 2.4],
        ],
        // base
        [
            [0.0, 0.0, 0.0], [0.0, 0.0, 0.0], [0.0, 0.0, 0.0], [0.0, 0.0, 0.0],
            [0.0, -1.425, 0.0], [0.798, -1.425, 0.0], [1.425, -0.798, 0.0], [1.425, 0.0, 0.0],
            [0.0, -1.5, 0.075], [0.84, -1.5, 0.075], [1.5, -0.84, 0.075], [1.5, 0.0, 0.075],
            [0.0, -1.5, 0.15], [0.84, -1.5, 0.15], [1.5, -0.84, 0.15], [1.5, 0.0, 0.15],
        ],
        // upper half of the handle
        [
            [-1.6, 0.0, 2.025], [-1.6, -0.3, 2.025], [-1.5, -0.3, 2.25], [-1.5, 0.0, 2.25],
            [-2.3, 0.0, 2.025], [-2.3, -0.3, 2.025], [-2.5, -0.3, 2.25], [-2.5, 0.0, 2.25],
            [-2.7, 0.0, 2.025], [-2.7, -0.3, 2.025], [-3.0, -0.3, 2.25], [-3.0, 0.0, 2.25],
            [-2.7, 0.0, 1.8], [-2.7, -0.3, 1.8], [-3.0, -0.3, 1.8], [-3.0, 0.0, 1.8],
        ],
        // lower half of the handle
        [
            [-2.7, 0.0, 1.8], [-2.7, -0.3, 1.8], [-3.0, -0.3, 1.8], [-3.0, 0.0, 1.8],
            [-2.7, 0.0, 1.575], [-2.7, -0.3, 1.575], [-3.0, -0.3, 1.35], [-3.0, 0.0, 1.35],
            [-2.5, 0.0, 1.125], [-2.5, -0.3, 1.125], [-2.65, -0.3, 0.9375], [-2.65, 0.0, 0.9375],
            [-2.0, 0.0, 0.9], [-2.0, -0.3, 0.9], [-1.9, -0.3, 0.6], [-1.9, 0.0, 0.6],
        ],
        // lower half of the spout
        [
            [1.7, 0.0, 1.425], [1.7, -0.66, 1.425], [1.7, -0.66, 0.6], [1.7, 0.0, 0.6],
            [2.6, 0.0, 1.425], [2.6, -0.66, 1.425], [3.1, -0.66, 0.825], [3.1, 0.0, 0.825],
            [2.3, 0.0, 2.1], [2.3, -0.25, 2.1], [2.4, -0.25, 2.025], [2.4, 0.0, 2.025],
            [2.7, 0.0, 2.4], [2.7, -0.25, 2.4], [3.3, -0.25, 2.4], [3.3, 0.0, 2.4],
        ],
        // upper half of the spout
        [
            [2.7, 0.0, 2.4], [2.7, -0.25, 2.4], [3.3, -0.25, 2.4], [3.3, 0.0, 2.4],
            [2.8, 0.0, 2.475], [2.8, -0.25, 2.475], [3.525, -0.25, 2.49375], [3.525, 0.0, 2.49375],
            [2.9, 0.0, 2.475], [2.9, -0.15, 2.475], [3.45, -0.15, 2.5125], [3.45, 0.0, 2.5125],
            [2.8, 0.0, 2.4], [2.8, -0.15, 2.4], [3.2, -0.15, 2.4], [3.2, 0.0, 2.4],
        ],
    ];

    /// De Casteljau: between neighbours, again and again.
    fn casteljau(mut p: [DVec3; 4], t: f64) -> DVec3 {
        for left in (1..4).rev() {
            for i in 0..left {
                p[i] = p[i].lerp(p[i + 1], t);
            }
        }
        p[0]
    }

    #[test]
    fn the_published_patches() {
        for n in [2, 3, 5, 8] {
            let pot = teapot(n).unwrap();
            for patch in PUBLISHED {
                let points = patch.map(|[x, y, z]| DVec3::new(x, z, -y));
                let row = |i: usize, u: f64| casteljau([0, 1, 2, 3].map(|j| points[4 * i + j]), u);
                for (k, l) in (0..=n).flat_map(|k| (0..=n).map(move |l| (k, l))) {
                    let (u, v) = (f64::from(k) / f64::from(n), f64::from(l) / f64::from(n));
                    let p = casteljau([0, 1, 2, 3].map(|i| row(i, u)), v);
                    // A dozen roundings at coordinates up to 3.6.
                    let near = pot
                        .positions
                        .iter()
                        .any(|q| (p - q).abs().max_element() <= 12.0 * EPS * 4.0);
                    assert!(near, "{n}: {p} is no vertex");
                }
            }
        }
    }

    /// The loops of open edges, each as the vertices in the order of its faces.
    fn border(mesh: &Mesh) -> Vec<Vec<DVec3>> {
        let mut next: BTreeMap<u32, u32> = BTreeMap::new();
        for e in mesh.edges() {
            match (e.left, e.right) {
                (Some(_), None) => assert_eq!(next.insert(e.from, e.to), None),
                (None, Some(_)) => assert_eq!(next.insert(e.to, e.from), None),
                _ => {}
            }
        }
        let mut loops = Vec::new();
        while let Some((&start, _)) = next.first_key_value() {
            let mut found = Vec::new();
            let mut at = start;
            while let Some(to) = next.remove(&at) {
                found.push(mesh.positions[at as usize]);
                at = to;
            }
            assert_eq!(at, start);
            loops.push(found);
        }
        loops
    }

    #[test]
    fn open_where_the_original_is_and_nowhere_else() {
        for n in [2, 3, 6] {
            let pot = teapot(n).unwrap();
            let loops = border(&pot);
            let n = n as usize;
            // A point of each in the published data (here y up), and how many edges.
            let expected = [
                ("rim", DVec3::new(1.4, 2.4, 0.0), 4 * n),
                ("lid", DVec3::new(0.0, 2.4, 1.3), 4 * n),
                (
                    "upper end of the handle",
                    DVec3::new(-1.5, 2.25, 0.0),
                    2 * n,
                ),
                ("lower end of the handle", DVec3::new(-2.0, 0.9, 0.0), 2 * n),
                ("foot of the spout", DVec3::new(1.7, 0.6, 0.0), 2 * n),
                ("mouth of the spout", DVec3::new(3.2, 2.4, 0.0), 2 * n),
            ];
            assert_eq!(loops.len(), expected.len());
            for (name, p, edges) in expected {
                let lengths: Vec<_> = loops
                    .iter()
                    .filter(|l| l.contains(&p))
                    .map(Vec::len)
                    .collect();
                assert_eq!(lengths, [edges], "{name}");
            }
            for (height, radius) in [(2.4, 1.4), (2.4, 1.3)] {
                let flat = loops.iter().any(|l| {
                    l.len() == 4 * n
                        && l.iter().all(|p| {
                            let across = p.with_y(0.0).length();
                            // The cubic quarter bulges by less than 0.6 %.
                            p.y == height
                                && across >= radius * (1.0 - EPS)
                                && across < radius * 1.006
                        })
                });
                assert!(flat, "{radius}");
            }
        }
    }

    /// With its loops stopped by fans, each piece is closed, and encloses a positive volume only if it looks outwards.
    #[test]
    fn every_piece_looks_outwards() {
        let mut pot = teapot(6).unwrap();
        for found in border(&pot) {
            let middle = pot.positions.len() as u32;
            let index = |p: &DVec3| pot.positions.iter().rposition(|q| q == p).unwrap() as u32;
            // The touching point of handle and pot is there twice; the border's is the handle's, the later one.
            let ring: Vec<_> = found.iter().map(index).collect();
            for (i, &v) in ring.iter().enumerate() {
                pot.triangles.push([ring[(i + 1) % ring.len()], v, middle]);
            }
            pot.positions
                .push(found.iter().sum::<DVec3>() / found.len() as f64);
        }
        assert!(pot.is_two_manifold());
        let vertices = pot.positions.len();
        let mut piece: Vec<usize> = (0..vertices).collect();
        for _ in 0..vertices {
            let before = piece.clone();
            for t in &pot.triangles {
                let least = t.iter().map(|&v| piece[v as usize]).min().unwrap();
                t.iter().for_each(|&v| piece[v as usize] = least);
            }
            if piece == before {
                break;
            }
        }
        let mut volumes: BTreeMap<usize, f64> = BTreeMap::new();
        for (i, t) in pot.triangles.iter().enumerate() {
            let [a, b, c] = pot.triangle(i).unwrap();
            *volumes.entry(piece[t[0] as usize]).or_default() += a.dot(b.cross(c)) / 6.0;
        }
        assert_eq!(volumes.len(), 4);
        assert!(volumes.values().all(|&v| v > 0.0), "{volumes:?}");
        // The pot between the cylinders of radius 1.4 and 2.02 about its height of 2.5.
        let body = volumes.values().copied().fold(0.0, f64::max);
        assert!(body > 15.0 && body < 32.0, "{body}");
    }

    #[test]
    fn shape() {
        for n in [2, 3, 7] {
            let pot = teapot(n).unwrap();
            assert_eq!(pot.triangles.len() as u32, 64 * n * n - 8 * n);
            for i in 0..pot.triangles.len() {
                let [a, b, c] = pot.triangle(i).unwrap();
                assert!(crate::triangle::area(a, b, c) > 0.0, "{n}: {i}");
            }
            let has = |p: DVec3| pot.positions.contains(&p);
            assert!(pot.positions.iter().all(|&p| has(p.with_z(-p.z))), "{n}");
            let [low, high] = pot.bounds().unwrap();
            assert_eq!(
                (low, high.y, high.z),
                (DVec3::new(-3.0, 0.0, -2.0), 3.15, 2.0)
            );
            assert!(high.x > 3.3 && high.x < 3.525);
            // Each place once, but for the point where the handle touches the pot.
            let mut places: Vec<_> = pot
                .positions
                .iter()
                .map(|p| p.to_array().map(|x| (x + 0.0).to_bits()))
                .collect();
            places.sort_unstable();
            let again: Vec<_> = places
                .windows(2)
                .filter(|w| w[0] == w[1])
                .map(|w| w[0].map(f64::from_bits))
                .collect();
            assert_eq!(again, [[-2.0, 0.9, 0.0]]);
        }
    }
}
