use glam::{DMat4, DVec3, DVec4};

/// The matrix that casts the shadow of any point P on the ground y = 0, from a light at infinity.
///
/// ```text
/// S = P − t L     t = y_P / y_L     so that y_S = 0
///
///     ⎡ 1   −x_L/y_L   0   0 ⎤
/// M = ⎢ 0       0      0   0 ⎥        M (x_P, y_P, z_P, 1) = (x_S, 0, z_S, 1)
///     ⎢ 0   −z_L/y_L   1   0 ⎥
///     ⎣ 0       0      0   1 ⎦
/// ```
///
/// `light` is the direction L *towards* the light, of any length, from above (y_L > 0). The shadow of a point is a
/// point, w = 1; the slide's worked example prints w = 0 (erratum E4). `None` where y_L = 0: a horizontal light
/// casts no shadow on the ground. Vectors are columns; `DMat4::from_cols` takes the columns of M one by one.
///
/// Olomouc, Zdroj v nekonečnu.
fn shadow_matrix(light: DVec3) -> Option<DMat4> {
    if light.y == 0.0 {
        return None;
    }
    let along_ray = DVec4::new(-light.x / light.y, 0.0, -light.z / light.y, 0.0);
    Some(DMat4::from_cols(DVec4::X, along_ray, DVec4::Z, DVec4::W))
}

fn main() {}
