// rejected by no_direction: the answer is Some(NaN)
use glam::DVec3;

fn face_normal(normals: [DVec3; 3]) -> Option<DVec3> {
    let sum: DVec3 = normals.iter().map(|n| n.normalize()).sum();
    Some(sum.normalize())
}
