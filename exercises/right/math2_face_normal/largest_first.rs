// right: scaled by the largest coordinate, added from the last
use glam::DVec3;

fn face_normal(normals: [DVec3; 3]) -> Option<DVec3> {
    let unit = |n: DVec3| {
        let m = n.abs().max_element();
        (m > 0.0).then(|| (n / m).normalize())
    };
    unit(unit(normals[2])? + unit(normals[0])? + unit(normals[1])?)
}
