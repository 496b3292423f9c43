// rejected by any_triangle: the sign of the middle component is turned round
use glam::DVec3;

fn triangle_normal(a: DVec3, b: DVec3, c: DVec3) -> DVec3 {
    let (u, v) = (b - a, c - a);
    DVec3::new(
        u.y * v.z - u.z * v.y,
        u.x * v.z - u.z * v.x,
        u.x * v.y - u.y * v.x,
    )
}
