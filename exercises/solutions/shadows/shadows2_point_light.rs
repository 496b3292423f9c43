use glam::{DMat4, DVec3, DVec4};

/// The matrix that casts the shadow of any vertex V on the ground y = 0, from a light in the point L.
///
/// ```text
///       L_y V_x − L_x V_y            L_y V_z − L_z V_y
/// P_x = ─────────────────      P_z = ─────────────────
///           L_y − V_y                    L_y − V_y
///
///     ⎡ L_y   −L_x    0     0  ⎤
/// M = ⎢  0      0     0     0  ⎥        M (V_x, V_y, V_z, 1) = (w P_x, 0, w P_z, w)     w = L_y − V_y
///     ⎢  0    −L_z   L_y    0  ⎥
///     ⎣  0     −1     0    L_y ⎦
/// ```
///
/// The signs are those of the Bologna deck: w > 0 for every true shadow, so that clipping keeps it. The Olomouc
/// matrix has all signs turned round, and its w is negative (erratum E21).
///
/// Bologna, Ombre su piani; Olomouc, Zdroj světla v bodě.
fn shadow_matrix(light: DVec3) -> DMat4 {
    DMat4::from_cols(
        DVec4::new(light.y, 0.0, 0.0, 0.0),
        DVec4::new(-light.x, 0.0, -light.z, -1.0),
        DVec4::new(0.0, 0.0, light.y, 0.0),
        DVec4::new(0.0, 0.0, 0.0, light.y),
    )
}

/// The shadow of the vertex V on the ground, from a light in the point L: M V divided by its w.
///
/// The vertex lies on or above the ground, the light above it. `None` where w ≤ 0: no ray goes down through a
/// vertex that is as high as the light or higher.
///
/// Olomouc, Zdroj světla v bodě; its worked example prints the shadow of a light at infinity (erratum E3).
fn shadow(light: DVec3, v: DVec3) -> Option<DVec3> {
    let p = shadow_matrix(light) * v.extend(1.0);
    (p.w > 0.0).then(|| p.truncate() / p.w)
}

fn main() {}
