// rejected by places_and_directions: L_w is not used
use glam::{DMat4, DVec4};

fn shadow_matrix(plane: DVec4, light: DVec4) -> Option<DMat4> {
    let light = light.truncate().extend(0.0);
    let towards_light = plane.dot(light);
    if towards_light == 0.0 {
        return None;
    }
    let plane = if towards_light < 0.0 { -plane } else { plane };
    let dot = towards_light.abs();
    Some(DMat4::from_cols(
        dot * DVec4::X - plane.x * light,
        dot * DVec4::Y - plane.y * light,
        dot * DVec4::Z - plane.z * light,
        dot * DVec4::W - plane.w * light,
    ))
}
