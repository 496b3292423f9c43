// rejected by parallel_view: v is that direction itself
use glam::{DVec3, DVec4};

fn is_front_facing(triangle: [DVec3; 3], eye: DVec4) -> bool {
    let [a, b, c] = triangle;
    let normal = (b - a).cross(c - a);
    normal.dot(eye.truncate() - a) >= 0.0
}
