// rejected by rows_and_columns: this is the transposed matrix
use glam::{DMat4, DVec4};

fn shadow_matrix(plane: DVec4, light: DVec4) -> Option<DMat4> {
    let towards_light = plane.dot(light);
    if towards_light == 0.0 {
        return None;
    }
    let plane = if towards_light < 0.0 { -plane } else { plane };
    let dot = towards_light.abs();
    Some(DMat4::from_cols(
        dot * DVec4::X - light.x * plane,
        dot * DVec4::Y - light.y * plane,
        dot * DVec4::Z - light.z * plane,
        dot * DVec4::W - light.w * plane,
    ))
}
