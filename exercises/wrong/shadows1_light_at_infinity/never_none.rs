// rejected by horizontal_light: a horizontal light never meets the ground
use glam::{DMat4, DVec3, DVec4};

fn shadow_matrix(light: DVec3) -> Option<DMat4> {
    let column = DVec4::new(-light.x / light.y, 0.0, -light.z / light.y, 0.0);
    Some(DMat4::from_cols(DVec4::X, column, DVec4::Z, DVec4::W))
}
