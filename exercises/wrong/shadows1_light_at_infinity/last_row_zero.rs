// rejected by any_light: w = 0 is a direction
use glam::{DMat4, DVec3, DVec4};

fn shadow_matrix(light: DVec3) -> Option<DMat4> {
    if light.y == 0.0 {
        return None;
    }
    let column = DVec4::new(-light.x / light.y, 0.0, -light.z / light.y, 0.0);
    Some(DMat4::from_cols(DVec4::X, column, DVec4::Z, DVec4::ZERO))
}
