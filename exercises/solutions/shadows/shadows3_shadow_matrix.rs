use glam::{DMat4, DVec4};

/// The matrix that casts shadows on any plane, from any light.
///
/// ```text
/// M = (π·L) I − L πᵀ          M (V, 1) = (w P, w)
///
/// (L πᵀ)ᵢⱼ = Lᵢ πⱼ            π·L = a L_x + b L_y + c L_z + d L_w
/// ```
///
/// `plane` is π = (a, b, c, d): the points with a x + b y + c z + d = 0. `light` is homogeneous: L_w = 1 a place,
/// L_w = 0 the direction towards a light at infinity. Vectors are columns.
///
/// π and −π are the same plane: it is turned so that π·L > 0, and then w > 0 for every true shadow, so that clipping
/// keeps it. `None` where π·L = 0 as computed, without a tolerance: the light lies in the plane or shines along it.
/// Whether the plane is made unit first is left to you: that changes M by a factor and P by roundings.
///
/// Bologna, Ombre su piani in WebGL, prints the transposed matrix (erratum E1). Olomouc, Projekce na libovolnou
/// plochu, gives that one for rows, with a misprint (erratum E2).
fn shadow_matrix(plane: DVec4, light: DVec4) -> Option<DMat4> {
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

fn main() {}
