// rejected by any_triangle: the length of n is the area of the triangle
use glam::DVec3;

fn triangle_normal(a: DVec3, b: DVec3, c: DVec3) -> DVec3 {
    (b - a).cross(c - a) / 2.0
}
