// right: A × B + B × C + C × A
use glam::DVec3;

fn triangle_normal(a: DVec3, b: DVec3, c: DVec3) -> DVec3 {
    a.cross(b) + b.cross(c) + c.cross(a)
}
