// rejected by any_triangle: make each of them unit first (erratum E14)
use glam::DVec3;

fn face_normal(normals: [DVec3; 3]) -> Option<DVec3> {
    let [a, b, c] = normals;
    if a == DVec3::ZERO || b == DVec3::ZERO || c == DVec3::ZERO {
        return None;
    }
    (a + b + c).try_normalize()
}
