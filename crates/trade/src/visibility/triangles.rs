//! Triangles that cover twice the picture, however many there are.

use core::f64::consts::TAU;

use ombra_math::glam::{DVec2, DVec3};
use ombra_math::mesh::Mesh;

use crate::random::Random;

/// How often the triangles cover the picture.
pub const LAYERS: f64 = 2.0;
/// The distances of the triangles' centres.
const DISTANCES: [f64; 2] = [4.0, 12.0];
/// How much the distance of a corner may differ from that of the centre, over the size of the triangle in the picture.
const INCLINED: f64 = 0.3;

/// `number` triangles, equilateral in the picture and wholly in it, at random places, turned and inclined.
pub fn triangles(number: usize) -> Mesh {
    let mut random = Random::new(1972);
    // In NDC the picture is 2 × 2; an equilateral triangle in a circle of radius r has the area r² 3√3 / 4.
    let area = 4.0 * LAYERS / number.max(1) as f64;
    let radius = (area * 4.0 / (3.0 * 3f64.sqrt())).sqrt();
    let reach = (1.0 - radius).max(0.0);
    let mut positions = Vec::with_capacity(3 * number);
    for _ in 0..number {
        let middle = DVec2::new(random.between(-reach, reach), random.between(-reach, reach));
        let distance = random.between(DISTANCES[0], DISTANCES[1]);
        let turn = random.between(0.0, TAU);
        for corner in [0.0, 1.0, 2.0] {
            let angle = turn + corner * TAU / 3.0;
            let place = middle + radius * DVec2::new(libm::cos(angle), libm::sin(angle));
            let distance = distance * (1.0 + INCLINED * radius * random.between(-1.0, 1.0));
            positions.push(DVec3::new(place.x, place.y, -1.0) * distance);
        }
    }
    let corners = (0..number as u32).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]);
    Mesh {
        positions,
        triangles: corners.collect(),
    }
}
