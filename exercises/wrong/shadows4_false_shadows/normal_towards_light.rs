// rejected by either_side: it is the same plane
use glam::{DVec3, DVec4};

fn shadow(plane: DVec4, light: DVec4, v: DVec3) -> Option<DVec3> {
    let dot = plane.dot(light);
    if dot <= 0.0 {
        return None;
    }
    let height = plane.dot(v.extend(1.0));
    let w = dot - light.w * height;
    (height >= 0.0 && w > 0.0).then(|| (dot * v - height * light.truncate()) / w)
}
