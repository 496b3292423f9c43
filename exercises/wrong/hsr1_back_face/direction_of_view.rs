// rejected by either_side: not the way the viewer looks
use glam::{DVec3, DVec4};

fn is_front_facing(triangle: [DVec3; 3], eye: DVec4) -> bool {
    let [a, b, c] = triangle;
    let normal = (b - a).cross(c - a);
    let direction_of_view = eye.w * a - eye.truncate();
    normal.dot(direction_of_view) >= 0.0
}
