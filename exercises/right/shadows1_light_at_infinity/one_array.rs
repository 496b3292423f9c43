// right: sixteen numbers in one array, columns first
use glam::{DMat4, DVec3};

fn shadow_matrix(light: DVec3) -> Option<DMat4> {
    let DVec3 { x, y, z } = light;
    if y.abs() > 0.0 {
        let (a, b) = (-(x / y), -(z / y));
        #[rustfmt::skip]
        let m = [1.0, 0.0, 0.0, 0.0, a, 0.0, b, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0];
        Some(DMat4::from_cols_array(&m))
    } else {
        None
    }
}
