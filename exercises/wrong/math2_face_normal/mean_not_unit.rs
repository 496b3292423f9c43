// rejected by any_triangle: the direction is right, but the length is
use glam::DVec3;

fn face_normal(normals: [DVec3; 3]) -> Option<DVec3> {
    let [first, second, third] = normals;
    let sum = first.try_normalize()? + second.try_normalize()? + third.try_normalize()?;
    Some(sum / 3.0)
}
