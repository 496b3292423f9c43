// right: the matrix of the exercise before, then w
use glam::{DMat4, DVec3, DVec4};
fn shadow(plane: DVec4, light: DVec4, v: DVec3) -> Option<DVec3> {
    let k = plane.dot(light);
    let pl = if k < 0.0 { -plane } else { plane };
    let k = k.abs();
    if k == 0.0 || pl.dot(v.extend(1.0)) < 0.0 {
        return None;
    }
    let m = DMat4::from_diagonal(DVec4::splat(k))
        - DMat4::from_cols(light * pl.x, light * pl.y, light * pl.z, light * pl.w);
    let p = m * v.extend(1.0);
    if p.w <= 0.0 {
        return None;
    }
    Some(p.truncate() / p.w)
}
