// right: divided by π·L, so that w = 1 on the plane
use glam::{DMat4, DVec4};

fn shadow_matrix(plane: DVec4, light: DVec4) -> Option<DMat4> {
    let dot = plane.dot(light);
    if dot == 0.0 {
        return None;
    }
    let row = plane / dot;
    Some(
        DMat4::IDENTITY
            - DMat4::from_cols(light * row.x, light * row.y, light * row.z, light * row.w),
    )
}
