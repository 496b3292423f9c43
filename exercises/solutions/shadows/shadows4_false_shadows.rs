use glam::{DVec3, DVec4};

/// The shadow of the vertex V on a plane, where there is one in truth.
///
/// ```text
/// P = ((π·L) V − (π·V) L) / w          w = π·L − L_w (π·V)
/// ```
///
/// With L = (L_x, L_y, L_z, L_w) and V = (V_x, V_y, V_z, 1) this is the point where the line through light and vertex
/// meets the plane. The formula flattens any vertex, wherever it is. A true shadow needs the order light, vertex,
/// plane on the ray; otherwise the point is a false shadow, and the answer is `None`:
///
/// - the light lies between the vertex and the plane, or as far from the plane as the vertex;
/// - the plane lies between the light and the vertex;
/// - the light lies in the plane or shines along it, π·L = 0: such a plane is unlit.
///
/// A vertex on the plane is its own shadow. All signs are taken as they are computed, without a tolerance; whether the
/// plane is made unit first is left to you, P then differs by roundings. `plane` is π = (a, b, c, d), and (−a, −b, −c, −d) is the same plane.
/// `light` is homogeneous: L_w = 1 a place, L_w = 0 the direction towards a light at infinity.
///
/// Olomouc, Nevýhody (projection methods).
fn shadow(plane: DVec4, light: DVec4, v: DVec3) -> Option<DVec3> {
    // Turned towards the light, the plane has both heights positive for a true shadow.
    let towards_light = plane.dot(light);
    if towards_light == 0.0 {
        return None;
    }
    let plane = if towards_light < 0.0 { -plane } else { plane };
    let dot = towards_light.abs();
    let height = plane.dot(v.extend(1.0));
    let w = dot - light.w * height;
    (height >= 0.0 && w > 0.0).then(|| (dot * v - height * light.truncate()) / w)
}

fn main() {}
