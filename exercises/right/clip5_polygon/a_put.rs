// right: A is put instead of B, the share from the other end
use glam::{DVec2, DVec3};

#[derive(Clone, Copy, Debug)]
struct Window {
    min: DVec2,
    max: DVec2,
}

fn clip_against_line(polygon: &[DVec2], line: DVec3) -> Vec<DVec2> {
    let s: Vec<f64> = polygon
        .iter()
        .map(|p| line.x * p.x + line.y * p.y + line.z)
        .collect();
    let n = polygon.len();
    let mut out = vec![];
    for i in 0..n {
        let j = if i + 1 == n { 0 } else { i + 1 };
        if s[i] >= 0.0 {
            out.push(polygon[i]);
        }
        if s[i].signum() * s[j].signum() < 0.0 && s[i] != 0.0 && s[j] != 0.0 {
            let t = s[j] / (s[j] - s[i]);
            out.push(polygon[j] + t * (polygon[i] - polygon[j]));
        }
    }
    if out.len() >= 3 { out } else { vec![] }
}

fn clip_polygon(window: Window, polygon: &[DVec2]) -> Vec<DVec2> {
    let p = clip_against_line(polygon, DVec3::new(0.0, -1.0, window.max.y));
    let p = clip_against_line(&p, DVec3::new(0.0, 1.0, -window.min.y));
    let p = clip_against_line(&p, DVec3::new(-1.0, 0.0, window.max.x));
    clip_against_line(&p, DVec3::new(1.0, 0.0, -window.min.x))
}
