// rejected by any_triangle: n₃ does not count
use glam::DVec3;

fn face_normal(normals: [DVec3; 3]) -> Option<DVec3> {
    let [a, b, c] = normals;
    c.try_normalize()?;
    (a.try_normalize()? + b.try_normalize()?).try_normalize()
}
