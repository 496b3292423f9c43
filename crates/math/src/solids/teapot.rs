//! Newell's teapot, evaluated from its bicubic Bézier patches.

use super::rings::Rings;
use super::{SolidError, allowed, at_least};
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
#[doc(alias = "Utah teapot")]
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
mod tests;
