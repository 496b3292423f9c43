// rejected by sum_is_zero: which is short, but not 0
use glam::DVec3;

fn face_normal(normals: [DVec3; 3]) -> Option<DVec3> {
    let mut s = DVec3::ZERO;
    for n in normals {
        s += n.try_normalize()?;
    }
    if s.length() < 1e-8 {
        return None;
    }
    Some(s.normalize())
}
