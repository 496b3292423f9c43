// right: rows of the formula, transposed; the point by `project_point3`
use glam::{DMat4, DVec3, DVec4};

fn shadow_matrix(light: DVec3) -> DMat4 {
    let DVec3 { x, y, z } = light;
    DMat4::from_cols(
        DVec4::new(y, -x, 0.0, 0.0),
        DVec4::ZERO,
        DVec4::new(0.0, -z, y, 0.0),
        DVec4::new(0.0, -1.0, 0.0, y),
    )
    .transpose()
}

fn shadow(light: DVec3, v: DVec3) -> Option<DVec3> {
    (light.y > v.y).then(|| shadow_matrix(light).project_point3(v))
}
