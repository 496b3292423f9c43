use core::f64::consts::PI;

use ombra_math::glam::DQuat;

use super::*;

mod any;
mod crossing;
mod ring;
mod scenes;
mod sight_lines;
mod touching;
mod whole;

fn polygon<const N: usize>(vertices: [[f64; 3]; N]) -> Polygon {
    Polygon {
        vertices: vertices.map(DVec3::from).to_vec(),
    }
}

/// [x, x + size] × [y, y + size] at the height z.
fn square(x: f64, y: f64, z: f64, size: f64) -> Polygon {
    let corners = [[0.0, 0.0], [size, 0.0], [size, size], [0.0, size]];
    polygon(corners.map(|[i, j]| [x + i, y + j, z]))
}

/// The faces of [0, 1]³, turned by `turn` and moved.
fn cube(turn: DQuat, shift: DVec3) -> Vec<Polygon> {
    let faces = [
        [0, 2, 3, 1],
        [4, 5, 7, 6],
        [0, 1, 5, 4],
        [2, 6, 7, 3],
        [0, 4, 6, 2],
        [1, 3, 7, 5],
    ];
    let bit = |i: usize, k: usize| f64::from(u8::from(i >> k & 1 == 1));
    let corner = |i: usize| turn * DVec3::new(bit(i, 0), bit(i, 1), bit(i, 2)) + shift;
    faces
        .map(|face| Polygon {
            vertices: face.map(corner).to_vec(),
        })
        .to_vec()
}

fn place(x: f64, y: f64, z: f64) -> DVec4 {
    DVec4::new(x, y, z, 1.0)
}

fn areas(parts: &[(usize, Polygon)], source: usize) -> f64 {
    let of_source = parts.iter().filter(|(i, _)| *i == source);
    of_source.map(|(_, part)| part.area()).sum()
}

fn close(x: f64, expected: f64, scale: f64) {
    // Some ten cuts, each corner within a few ε of the coordinates.
    assert!(
        (x - expected).abs() <= 64.0 * f64::EPSILON * scale,
        "{x} instead of {expected}"
    );
}

/// A source of numbers in 0 … 1, the same on every run.
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    fn vector(&mut self) -> DVec3 {
        DVec3::new(self.next(), self.next(), self.next())
    }

    /// A triangle or a regular polygon of up to seven corners in [−1, 1]³.
    fn polygon(&mut self, size: f64) -> Polygon {
        let centre = self.vector() * 2.0 - 1.0;
        let turn = DQuat::from_axis_angle(
            (self.vector() - 0.5).normalize_or(DVec3::X),
            6.0 * self.next(),
        );
        let n = 3 + (5.0 * self.next()) as usize;
        let at = |k: usize| {
            let angle = 2.0 * PI * k as f64 / n as f64;
            size * DVec3::new(libm::cos(angle), libm::sin(angle), 0.0)
        };
        let shift = centre * (1.0 - size);
        Polygon {
            vertices: (0..n).map(|k| turn * at(k) + shift).collect(),
        }
    }
}
