// right: heights over the plane, then the share of the ray
use glam::{DVec3, DVec4};
fn shadow(plane: DVec4, light: DVec4, v: DVec3) -> Option<DVec3> {
    let hl = plane.x * light.x + plane.y * light.y + plane.z * light.z + plane.w * light.w;
    let hv = plane.x * v.x + plane.y * v.y + plane.z * v.z + plane.w;
    if hl == 0.0 || hv != 0.0 && (hv > 0.0) != (hl > 0.0) {
        return None;
    }
    let l = light.truncate();
    if light.w == 0.0 {
        return Some(v - l * (hv / hl));
    }
    if hv.abs() >= hl.abs() {
        return None;
    }
    Some(v + (v - l) * (hv / (hl - hv)))
}
