// rejected by any_triangle: the direction is right, but the length is
use glam::DVec3;

fn face_normal(normals: [DVec3; 3]) -> Option<DVec3> {
    let [a, b, c] = normals;
    Some((a.try_normalize()? + b.try_normalize()? + c.try_normalize()?) / 3.0)
}
