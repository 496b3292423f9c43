// rejected by places_and_directions: but w is not what divides them
use glam::{DMat4, DVec4};

fn shadow_matrix(plane: DVec4, light: DVec4) -> Option<DMat4> {
    let towards_light = plane.dot(light);
    if towards_light == 0.0 {
        return None;
    }
    let plane = if towards_light < 0.0 { -plane } else { plane };
    let dot = towards_light.abs();
    let direction = light.truncate().extend(0.0);
    Some(DMat4::from_cols(
        dot * DVec4::X - plane.x * direction,
        dot * DVec4::Y - plane.y * direction,
        dot * DVec4::Z - plane.z * direction,
        dot * DVec4::W - plane.w * direction,
    ))
}
