// right: all products written out
use glam::{DVec3, DVec4};

fn is_front_facing(triangle: [DVec3; 3], eye: DVec4) -> bool {
    let [a, b, c] = triangle;
    let (u, w) = (b - a, c - a);
    let n = [
        u.y * w.z - u.z * w.y,
        u.z * w.x - u.x * w.z,
        u.x * w.y - u.y * w.x,
    ];
    let v = [
        eye.x - eye.w * a.x,
        eye.y - eye.w * a.y,
        eye.z - eye.w * a.z,
    ];
    n.iter().zip(v).map(|(n, v)| n * v).sum::<f64>() >= 0.0
}
