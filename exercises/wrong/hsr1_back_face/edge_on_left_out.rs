// rejected by edge_on: the slide keeps it
use glam::{DVec3, DVec4};

fn is_front_facing(triangle: [DVec3; 3], eye: DVec4) -> bool {
    let [a, b, c] = triangle;
    let n = (b - a).cross(c - a);
    n.dot(eye.truncate() - eye.w * a) > 0.0
}
