// rejected by moved_along: An eye that is a place is no direction
use glam::{DVec3, DVec4};

fn is_front_facing(triangle: [DVec3; 3], eye: DVec4) -> bool {
    let [a, b, c] = triangle;
    let normal = (b - a).cross(c - a);
    normal.dot(eye.truncate()) >= 0.0
}
