// right: each component by a fused multiplication and addition
use glam::DVec3;

fn triangle_normal(a: DVec3, b: DVec3, c: DVec3) -> DVec3 {
    let (u, v) = (b - a, c - a);
    DVec3::new(
        u.y.mul_add(v.z, -(u.z * v.y)),
        u.z.mul_add(v.x, -(u.x * v.z)),
        u.x.mul_add(v.y, -(u.y * v.x)),
    )
}
