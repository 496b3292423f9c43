// right: the plane is made unit first
use glam::{DVec3, DVec4};

fn shadow(plane: DVec4, light: DVec4, v: DVec3) -> Option<DVec3> {
    let plane = plane / plane.truncate().length();
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
