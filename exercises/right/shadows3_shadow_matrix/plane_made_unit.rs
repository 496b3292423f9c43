// right: the plane is made unit first
use glam::{DMat4, DVec4};

fn shadow_matrix(plane: DVec4, light: DVec4) -> Option<DMat4> {
    let plane = plane / plane.truncate().length();
    let dot = plane.dot(light);
    if dot == 0.0 {
        return None;
    }
    let product = DMat4::from_cols(
        plane.x * light,
        plane.y * light,
        plane.z * light,
        plane.w * light,
    );
    Some((DMat4::from_diagonal(DVec4::splat(dot)) - product) * dot.signum())
}
