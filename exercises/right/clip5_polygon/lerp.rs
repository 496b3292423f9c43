// right: lerp, the edge before the first vertex first, early return
use glam::{DVec2, DVec3};

#[derive(Clone, Copy, Debug)]
struct Window {
    min: DVec2,
    max: DVec2,
}

fn clip_against_line(polygon: &[DVec2], line: DVec3) -> Vec<DVec2> {
    if polygon.len() < 3 {
        return Vec::new();
    }
    let s = |p: DVec2| line.x.mul_add(p.x, line.y.mul_add(p.y, line.z));
    let mut out = Vec::with_capacity(polygon.len() + 2);
    let mut a = polygon[polygon.len() - 1];
    for &b in polygon {
        let (sa, sb) = (s(a), s(b));
        if (sa < 0.0 && sb > 0.0) || (sa > 0.0 && sb < 0.0) {
            out.push(a.lerp(b, sa.abs() / (sa.abs() + sb.abs())));
        }
        if sb >= 0.0 {
            out.push(b);
        }
        a = b;
    }
    if out.len() < 3 {
        out.clear();
    }
    out
}

fn clip_polygon(window: Window, polygon: &[DVec2]) -> Vec<DVec2> {
    let mut polygon = polygon.to_vec();
    for (axis, normal) in [DVec2::X, DVec2::Y].into_iter().enumerate() {
        polygon = clip_against_line(&polygon, normal.extend(-window.min[axis]));
        polygon = clip_against_line(&polygon, (-normal).extend(window.max[axis]));
    }
    polygon
}
