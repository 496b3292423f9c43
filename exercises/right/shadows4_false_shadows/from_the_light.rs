// right: along the ray from the light
use glam::{DVec3, DVec4};
fn shadow(plane: DVec4, light: DVec4, v: DVec3) -> Option<DVec3> {
    let n = plane.truncate();
    let d = plane.w;
    let l = light.truncate();
    let from = n.dot(l) + d * light.w;
    let at = n.dot(v) + d;
    if from == 0.0 {
        return None;
    }
    if light.w == 0.0 {
        if at / from < 0.0 {
            return None;
        }
        return Some(v - l * at / from);
    }
    let s = from.signum();
    if at * s < 0.0 || at * s >= from * s {
        return None;
    }
    let t = from / (from - at);
    Some(l + (v - l) * t)
}
