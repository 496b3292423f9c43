// right: NaN of the last step is None
use glam::DVec3;

fn face_normal(normals: [DVec3; 3]) -> Option<DVec3> {
    let s: DVec3 = normals.iter().map(|n| n.normalize()).sum();
    let n = s.normalize();
    if n.is_nan() { None } else { Some(n) }
}
