// rejected by any_triangle: the cross product changes sign with the order of its factors
use glam::DVec3;

fn triangle_normal(a: DVec3, b: DVec3, c: DVec3) -> DVec3 {
    (c - a).cross(b - a)
}
