// rejected by above_the_light: the light is below the vertex: no shadow here
use glam::{DMat4, DVec3, DVec4};

fn shadow_matrix(light: DVec3) -> DMat4 {
    DMat4::from_cols(
        DVec4::new(light.y, 0.0, 0.0, 0.0),
        DVec4::new(-light.x, 0.0, -light.z, -1.0),
        DVec4::new(0.0, 0.0, light.y, 0.0),
        DVec4::new(0.0, 0.0, 0.0, light.y),
    )
}

fn shadow(light: DVec3, v: DVec3) -> Option<DVec3> {
    let p = shadow_matrix(light) * v.extend(1.0);
    Some(p.truncate() / p.w)
}
