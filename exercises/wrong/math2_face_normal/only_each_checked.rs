// rejected by sum_is_zero: a sum that cannot be made unit
use glam::DVec3;

fn face_normal(normals: [DVec3; 3]) -> Option<DVec3> {
    if normals.iter().any(|n| *n == DVec3::ZERO) {
        return None;
    }
    let s: DVec3 = normals.iter().map(|n| n.normalize()).sum();
    Some(s.normalize())
}
