// rejected by by_a_hair: the sign of n·v is taken as it is, without a tolerance
use glam::{DVec3, DVec4};

fn is_front_facing(triangle: [DVec3; 3], eye: DVec4) -> bool {
    let [a, b, c] = triangle;
    let n = (b - a).cross(c - a);
    n.dot(eye.truncate() - eye.w * a) >= -1e-9
}
