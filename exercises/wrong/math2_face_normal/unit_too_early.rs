// rejected by any_triangle: add all three first and make the sum unit then
use glam::DVec3;

fn face_normal(normals: [DVec3; 3]) -> Option<DVec3> {
    let [a, b, c] = normals;
    ((a.try_normalize()? + b.try_normalize()?).try_normalize()? + c.try_normalize()?)
        .try_normalize()
}
