// rejected by any_triangle: it is made of the sides AB and AC, not of the points
use glam::DVec3;

fn triangle_normal(a: DVec3, b: DVec3, c: DVec3) -> DVec3 {
    b.cross(c)
}
