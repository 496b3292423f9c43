// right: the shadow along the ray, without the matrix
use glam::{DMat4, DVec3, DVec4};

fn shadow_matrix(light: DVec3) -> DMat4 {
    let mut m = DMat4::IDENTITY * light.y;
    m.y_axis = DVec4::new(-light.x, 0.0, -light.z, -1.0);
    m
}

fn shadow(light: DVec3, v: DVec3) -> Option<DVec3> {
    if v.y >= light.y {
        return None;
    }
    let t = v.y / (light.y - v.y);
    Some(DVec3::new(
        v.x + t * (v.x - light.x),
        0.0,
        v.z + t * (v.z - light.z),
    ))
}
