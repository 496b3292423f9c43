// right: the sign of a determinant, from another vertex
use glam::{DMat3, DVec3, DVec4};

fn is_front_facing(triangle: [DVec3; 3], eye: DVec4) -> bool {
    let [a, b, c] = triangle;
    let v = eye.truncate() - eye.w * b;
    DMat3::from_cols(c - b, a - b, v).determinant() >= 0.0
}
