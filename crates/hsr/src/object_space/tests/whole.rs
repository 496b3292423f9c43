//! The parts make up all that can be seen.

use ombra_math::glam::DMat3;

use super::*;

/// The solid angle of a polygon from the origin, from its triangles: A. Van Oosterom, J. Strackee, «The solid angle
/// of a plane triangle», 1983.
fn solid_angle(polygon: &Polygon, eye: DVec3) -> f64 {
    let rays: Vec<_> = polygon
        .vertices
        .iter()
        .map(|&v| (v - eye).normalize())
        .collect();
    let triangles = (1..rays.len() - 1).map(|i| {
        let [a, b, c] = [rays[0], rays[i], rays[i + 1]];
        let volume = DMat3::from_cols(a, b, c).determinant();
        2.0 * libm::atan2(volume.abs(), 1.0 + a.dot(b) + b.dot(c) + c.dot(a))
    });
    triangles.sum()
}

/// From inside a closed room every sight line ends somewhere, so the parts fill the sphere of directions: 4π.
#[test]
fn the_parts_fill_the_sphere() {
    let mut numbers = Numbers(2463534242);
    for round in 0..60 {
        let walls = cube(DQuat::IDENTITY, DVec3::splat(-0.5));
        let room = walls.iter().map(|p| Polygon {
            vertices: p.vertices.iter().map(|&v| 4.0 * v).collect(),
        });
        let mut scene: Vec<_> = room.collect();
        for _ in 0..round {
            let at = (scene.len() as f64 * numbers.next()) as usize;
            scene.insert(at, numbers.polygon(0.6));
        }
        let eye = numbers.vector() * 2.0 - 1.0;
        let parts = visible_parts(&scene, eye.extend(1.0));
        let sum: f64 = parts.iter().map(|(_, part)| solid_angle(part, eye)).sum();
        // Corners within 64 ε of where they belong, seen from 10⁻³ at the nearest, along all edges.
        let tolerance = 64.0 * f64::EPSILON * 1e3 * parts.len() as f64;
        assert!(
            (sum - 4.0 * PI).abs() <= tolerance,
            "{round}: {:e}",
            sum - 4.0 * PI
        );
    }
}

/// In a parallel view over a ground that lies under everything, the parts' pictures make up the ground's.
#[test]
fn the_parts_fill_the_picture() {
    let mut numbers = Numbers(88172645463325252);
    for round in 0..60 {
        let mut scene = vec![square(-4.0, -4.0, -4.0, 8.0)];
        for _ in 0..round {
            let at = (scene.len() as f64 * numbers.next()) as usize;
            scene.insert(at, numbers.polygon(0.9));
        }
        let eye = (DVec3::Z + 0.5 * numbers.vector()).extend(0.0);
        let parts = visible_parts(&scene, eye);
        let picture = |p: &Polygon| {
            let flat = p
                .vertices
                .iter()
                .map(|v| *v - eye.truncate() * (v.z / eye.z));
            Polygon {
                vertices: flat.collect(),
            }
            .area()
        };
        let sum: f64 = parts.iter().map(|(_, part)| picture(part)).sum();
        let tolerance = 64.0 * f64::EPSILON * 8.0 * parts.len() as f64;
        assert!((sum - 64.0).abs() <= tolerance, "{round}: {:e}", sum - 64.0);
    }
}
