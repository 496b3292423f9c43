// rejected by edge_on: n·v = 0 exactly
use glam::{DVec3, DVec4};

fn is_front_facing(triangle: [DVec3; 3], eye: DVec4) -> bool {
    let [a, b, c] = triangle;
    let normal = (b - a).cross(c - a);
    let towards_viewer = eye.truncate() - eye.w * a;
    normal.dot(towards_viewer) > 0.0
}
