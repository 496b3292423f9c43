// rejected by known_triangle: is inside: put the crossing
use glam::{DVec2, DVec3};

#[derive(Clone, Copy, Debug)]
struct Window {
    min: DVec2,
    max: DVec2,
}

fn clip_against_line(polygon: &[DVec2], line: DVec3) -> Vec<DVec2> {
    let side = |p: DVec2| line.dot(p.extend(1.0));
    let mut kept = Vec::new();
    let edges = (0..polygon.len()).map(|i| (polygon[i], polygon[(i + 1) % polygon.len()]));
    for (a, b) in edges {
        let (side_a, side_b) = (side(a), side(b));
        let crossing = a + (b - a) * (side_a / (side_a - side_b));
        if side_a > 0.0 && side_b < 0.0 {
            kept.push(crossing);
        }
        if side_b >= 0.0 {
            kept.push(b);
        }
    }
    if kept.len() < 3 {
        kept.clear();
    }
    kept
}

fn clip_polygon(window: Window, polygon: &[DVec2]) -> Vec<DVec2> {
    let sides = [
        DVec3::new(1.0, 0.0, -window.min.x),
        DVec3::new(-1.0, 0.0, window.max.x),
        DVec3::new(0.0, 1.0, -window.min.y),
        DVec3::new(0.0, -1.0, window.max.y),
    ];
    sides.into_iter().fold(polygon.to_vec(), |polygon, side| {
        clip_against_line(&polygon, side)
    })
}
