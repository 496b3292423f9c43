// right: the rows of the formula, then transposed
use glam::{DMat4, DVec3, DVec4};

fn shadow_matrix(light: DVec3) -> Option<DMat4> {
    if light.y == 0.0 {
        return None;
    }
    let rows = DMat4::from_cols(
        DVec4::new(1.0, -light.x / light.y, 0.0, 0.0),
        DVec4::ZERO,
        DVec4::new(0.0, -light.z / light.y, 1.0, 0.0),
        DVec4::W,
    );
    Some(rows.transpose())
}
