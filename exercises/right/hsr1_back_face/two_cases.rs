// right: a place and a direction apart, the answer by what is not behind
use glam::{DVec3, DVec4};

fn is_front_facing(triangle: [DVec3; 3], eye: DVec4) -> bool {
    let [a, b, c] = triangle;
    let v = if eye.w == 0.0 {
        eye.truncate()
    } else {
        eye.truncate() / eye.w - c
    };
    let normal = (a - c).cross(b - c);
    let is_behind = normal.dot(v) < 0.0;
    !is_behind
}
