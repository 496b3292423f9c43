// rejected by either_side: the answer does not depend on the side of the eye
use glam::{DVec3, DVec4};

fn is_front_facing(triangle: [DVec3; 3], eye: DVec4) -> bool {
    let [a, b, c] = triangle;
    let normal = (b - a).cross(c - a);
    normal.z >= 0.0
}
