// rejected by any_triangle: n points to the back, as AC × AB does
use glam::DVec3;

fn triangle_normal(a: DVec3, b: DVec3, c: DVec3) -> DVec3 {
    (c - a).cross(b - a)
}
