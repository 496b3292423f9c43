// right: AB × BC
use glam::DVec3;

fn triangle_normal(a: DVec3, b: DVec3, c: DVec3) -> DVec3 {
    (b - a).cross(c - b)
}
