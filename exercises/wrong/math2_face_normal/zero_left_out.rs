// rejected by no_direction: a vertex normal of length 0 has no direction
use glam::DVec3;

fn face_normal(normals: [DVec3; 3]) -> Option<DVec3> {
    let s: DVec3 = normals.iter().filter_map(|n| n.try_normalize()).sum();
    s.try_normalize()
}
