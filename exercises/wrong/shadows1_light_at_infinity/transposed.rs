// rejected by any_light: this is the transposed matrix
use glam::{DMat4, DVec3};

fn shadow_matrix(light: DVec3) -> Option<DMat4> {
    if light.y == 0.0 {
        return None;
    }
    let (x, z) = (-light.x / light.y, -light.z / light.y);
    Some(DMat4::from_cols_array(&[
        1.0, x, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, z, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0,
    ]))
}
