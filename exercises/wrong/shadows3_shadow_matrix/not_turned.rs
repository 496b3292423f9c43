// rejected by positive_w: the light is on the plane's back side
use glam::{DMat4, DVec4};

fn shadow_matrix(plane: DVec4, light: DVec4) -> Option<DMat4> {
    let dot = plane.dot(light);
    if dot == 0.0 {
        return None;
    }
    Some(DMat4::from_cols(
        dot * DVec4::X - plane.x * light,
        dot * DVec4::Y - plane.y * light,
        dot * DVec4::Z - plane.z * light,
        dot * DVec4::W - plane.w * light,
    ))
}
