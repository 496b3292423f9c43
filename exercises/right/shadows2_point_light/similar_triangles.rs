// right: the similar triangles of the slide
use glam::{DMat4, DVec3, DVec4};

fn shadow_matrix(light: DVec3) -> DMat4 {
    DMat4::from_cols(
        light.y * DVec4::X,
        -DVec4::new(light.x, 0.0, light.z, 1.0),
        light.y * DVec4::Z,
        light.y * DVec4::W,
    )
}

fn shadow(light: DVec3, v: DVec3) -> Option<DVec3> {
    let below = light.y - v.y;
    if below <= 0.0 {
        return None;
    }
    let from_light = light.y / below;
    Some(DVec3::new(
        light.x + from_light * (v.x - light.x),
        0.0,
        light.z + from_light * (v.z - light.z),
    ))
}
