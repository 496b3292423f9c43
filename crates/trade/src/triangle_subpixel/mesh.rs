//! A mesh that covers a picture, and the owner of each pixel.

use core::cmp::Ordering;
use core::ops::Range;

use ombra_math::glam::DVec2;

use crate::deviation::{Deviation, Verdict};
use crate::random::Random;

/// The sub-pixel bits with which vertices are given.
pub const BITS: u32 = 16;
/// One more bit, which centres need.
const ONE: i64 = 2 << BITS;

/// Distance of the vertices before they are moved, in pixels.
const CELL: u32 = 8;
/// How far they are moved in x and in y. With half a pixel more for snapping, √2 · 1.7 for a vertex and as much for the
/// diagonal across from it are less than the 8/√2 between them: no triangle turns over.
const MOVE: f64 = 1.2;

/// Triangles that cover the square from (0, 0) to (side, side) and more.
pub struct Mesh {
    pub side: u32,
    pub vertices: Vec<DVec2>,
    /// Where edge functions are positive inside.
    pub triangles: Vec<[usize; 3]>,
    /// For each pixel, row by row, the triangle that owns it.
    pub owners: Vec<u32>,
}

impl Mesh {
    /// A grid with moved vertices, a cell more than the picture on each side, each cell cut along one diagonal or the
    /// other. Vertices are multiples of 2⁻ᵇⁱᵗˢ.
    pub fn new(side: u32, bits: u32) -> Self {
        let mut random = Random::new(1988);
        let cells = side / CELL + 2;
        let unit = f64::from(1_u32 << bits.min(BITS));
        let mut moved = |i: u32| {
            let x = f64::from(i) * f64::from(CELL) - f64::from(CELL) + random.between(-MOVE, MOVE);
            (x * unit).floor() / unit
        };
        let (mut vertices, mut triangles) = (Vec::new(), Vec::new());
        for j in 0..=cells {
            for i in 0..=cells {
                vertices.push(DVec2::new(moved(i), moved(j)));
            }
        }
        let mut random = Random::new(1986);
        let at = |i: u32, j: u32| (j * (cells + 1) + i) as usize;
        for j in 0..cells {
            for i in 0..cells {
                // With y down, this is the order in which edge functions are positive.
                let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
                if random.bits() & 1 == 0 {
                    triangles.extend([[a, b, c], [a, c, d]]);
                } else {
                    triangles.extend([[a, b, d], [b, c, d]]);
                }
            }
        }
        let mut mesh = Self {
            side,
            vertices,
            triangles,
            owners: Vec::new(),
        };
        mesh.owners = mesh.exact_owners().pixels;
        mesh
    }

    /// Each triangle's corners among `vertices`, with its number.
    pub fn corners<V: Copy>(&self, vertices: &[V]) -> impl Iterator<Item = (u32, [V; 3])> {
        let triangles = self.triangles.iter().zip(0..);
        triangles.filter_map(|(&[a, b, c], i)| {
            Some((i, [*vertices.get(a)?, *vertices.get(b)?, *vertices.get(c)?]))
        })
    }

    /// The triangle that holds each centre, moved by (δ, δ²).
    fn exact_owners(&self) -> Owners {
        let integer = |x: f64| (x * ONE as f64) as i64;
        let vertices: Vec<_> = self
            .vertices
            .iter()
            .map(|v| [integer(v.x), integer(v.y)])
            .collect();
        let mut owners = Owners::nobody(self.side);
        for (i, corners) in self.corners(&vertices) {
            let [columns, rows] = [0, 1].map(|axis| {
                let all = corners.map(|corner| corner.get(axis).copied().unwrap_or(0));
                let [low, high] = [
                    all.into_iter().fold(i64::MAX, i64::min),
                    all.into_iter().fold(i64::MIN, i64::max),
                ];
                let pixel = |x: i64| x.div_euclid(ONE).clamp(0, i64::from(self.side)) as u32;
                pixel(low)..(pixel(high) + 1).min(self.side)
            });
            for y in rows {
                for x in columns.clone() {
                    let centre = [x, y].map(|c| i64::from(c) * ONE + ONE / 2);
                    if holds(corners, centre) {
                        owners.draw(y, x..x + 1, i);
                    }
                }
            }
        }
        owners
    }

    /// How the drawn pixels differ from those of the owners.
    pub fn verdict(&self, drawn: &Owners) -> Verdict {
        let [mut gaps, mut overlaps, mut others] = [0; 3];
        let pixels = drawn
            .pixels
            .iter()
            .copied()
            .map(Some)
            .chain(core::iter::repeat(None));
        let errors = self.owners.iter().zip(pixels).map(|(&owner, drawn)| {
            match drawn? {
                drawn if drawn == owner => return Some(0.0),
                Owners::NOBODY => gaps += 1,
                Owners::SEVERAL => overlaps += 1,
                _ => others += 1,
            }
            Some(1.0)
        });
        let deviation = Deviation::of(errors);
        Verdict {
            deviation,
            faults: vec![
                ("gaps", gaps),
                ("overlaps", overlaps),
                ("other owner", others),
            ],
        }
    }
}

/// Whether a triangle holds the point `p` + (δ, δ²), δ → 0.
fn holds([a, b, c]: [[i64; 2]; 3], p: [i64; 2]) -> bool {
    [(a, b), (b, c), (c, a)]
        .into_iter()
        .all(|([ax, ay], [bx, by])| {
            let (dx, dy) = (bx - ax, by - ay);
            let at_p = dx * (p[1] - ay) - dy * (p[0] - ax);
            // The edge function grows by −dy δ + dx δ².
            let sign = at_p.cmp(&0).then(0.cmp(&dy)).then(dx.cmp(&0));
            sign == Ordering::Greater
        })
}

/// Who has drawn each pixel.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Owners {
    side: u32,
    pixels: Vec<u32>,
}

impl Owners {
    /// No triangle.
    pub const NOBODY: u32 = u32::MAX;
    /// More than one.
    pub const SEVERAL: u32 = u32::MAX - 1;

    /// A picture in which nothing is drawn.
    pub fn nobody(side: u32) -> Self {
        Self {
            side,
            pixels: vec![Self::NOBODY; side as usize * side as usize],
        }
    }

    /// Pixels of one row drawn by one triangle.
    #[inline]
    pub fn draw(&mut self, y: u32, x: Range<u32>, triangle: u32) {
        let row = y as usize * self.side as usize;
        let pixels = row + x.start as usize..row + x.end as usize;
        for pixel in self.pixels.get_mut(pixels).into_iter().flatten() {
            *pixel = if *pixel == Self::NOBODY {
                triangle
            } else {
                Self::SEVERAL
            };
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_pixel_has_one_owner() {
        let mesh = Mesh::new(64, BITS);
        assert_eq!(mesh.triangles.len(), 2 * 10 * 10);
        assert_eq!(mesh.owners.len(), 64 * 64);
        assert!(mesh.owners.iter().all(|&owner| owner < 200));
        // Triangles are half a cell of 64 pixels each: more than half of the 128 over the picture own about that many.
        let distinct: std::collections::BTreeSet<_> = mesh.owners.iter().collect();
        assert!(distinct.len() >= 128, "{}", distinct.len());
    }

    #[test]
    fn no_triangle_turns_over() {
        for mesh in [Mesh::new(256, BITS), Mesh::new(256, 1)] {
            for (_, corners) in mesh.corners(&mesh.vertices) {
                for bits in [0, 4, 16] {
                    let [a, b, c] = corners.map(|v| ombra_raster::triangle::snap(v, bits));
                    assert!((b - a).perp_dot(c - a) > 0.0, "{corners:?}");
                }
            }
        }
    }

    #[test]
    fn owners_on_an_edge() {
        // A square of two triangles; centres are odd multiples of ½.
        let [a, b, c, d] = [[0, 0], [4, 0], [4, 4], [0, 4]].map(|v| v.map(|x| x * ONE));
        let centre = |x: i64, y: i64| [x * ONE + ONE / 2, y * ONE + ONE / 2];
        // The diagonal is the left edge of the triangle to its right.
        for i in 0..4 {
            assert!(holds([a, b, c], centre(i, i)) && !holds([a, c, d], centre(i, i)));
        }
        // On the square's own sides: top and left ones are in, the others are out.
        let on = |x, y| [[a, b, c], [a, c, d]].map(|t| holds(t, [x * ONE, y * ONE]));
        assert_eq!(on(2, 0), [true, false]);
        assert_eq!(on(0, 2), [false, true]);
        assert_eq!((on(4, 2), on(2, 4)), ([false, false], [false, false]));
    }

    #[test]
    fn faults_are_told_apart() {
        let mesh = Mesh::new(16, BITS);
        let mut drawn = Owners::nobody(16);
        for (i, &owner) in (0..).zip(&mesh.owners) {
            match i {
                0 => {}
                1 => drawn.draw(0, 1..2, owner + 1),
                2 => [owner, owner]
                    .into_iter()
                    .for_each(|o| drawn.draw(0, 2..3, o)),
                _ => drawn.draw(i / 16, i % 16..i % 16 + 1, owner),
            }
        }
        let verdict = mesh.verdict(&drawn);
        assert_eq!((verdict.deviation.asked, verdict.deviation.wrong), (256, 3));
        assert!(verdict.faults.iter().all(|fault| fault.1 == 1));
        // A picture too small leaves the rest without an answer.
        let missing = mesh.verdict(&Owners::nobody(2)).deviation.missing;
        assert_eq!(missing, 252);
    }
}
