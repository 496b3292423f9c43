// rejected by any_triangle: n is the zero vector
use glam::DVec3;

fn triangle_normal(a: DVec3, b: DVec3, c: DVec3) -> DVec3 {
    DVec3::ZERO
}
