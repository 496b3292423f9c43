// rejected by no_direction: a vertex normal of length 0 cannot be made unit
use glam::DVec3;

fn face_normal(normals: [DVec3; 3]) -> Option<DVec3> {
    let sum: DVec3 = normals.iter().map(|n| n.normalize()).sum();
    (sum != DVec3::ZERO).then(|| sum.normalize())
}
