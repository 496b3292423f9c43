// rejected by any_triangle: make each of them unit first (erratum E14)
use glam::DVec3;

fn face_normal(normals: [DVec3; 3]) -> Option<DVec3> {
    let [first, second, third] = normals;
    if first == DVec3::ZERO || second == DVec3::ZERO || third == DVec3::ZERO {
        return None;
    }
    (first + second + third).try_normalize()
}
