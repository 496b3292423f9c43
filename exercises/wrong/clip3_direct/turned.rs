// rejected by any_segment: a clipped segment keeps its direction
use glam::DVec2;
#[derive(Clone, Copy, Debug)]
struct Window {
    min: DVec2,
    max: DVec2,
}

fn clip(window: Window, a: DVec2, b: DVec2) -> Option<(DVec2, DVec2)> {
    let d = b - a;
    let in_x = |p: DVec2| window.min.x <= p.x && p.x <= window.max.x;
    let in_y = |p: DVec2| window.min.y <= p.y && p.y <= window.max.y;
    let mut found: Vec<(f64, DVec2)> = Vec::new();
    for (t, p) in [(0.0, a), (1.0, b)] {
        if in_x(p) && in_y(p) {
            found.push((t, p));
        }
    }
    for x in [window.min.x, window.max.x] {
        if d.x != 0.0 {
            let t = (x - a.x) / d.x;
            let p = DVec2::new(x, a.y + t * d.y);
            if (0.0..=1.0).contains(&t) && in_y(p) {
                found.push((t, p));
            }
        }
    }
    for y in [window.min.y, window.max.y] {
        if d.y != 0.0 {
            let t = (y - a.y) / d.y;
            let p = DVec2::new(a.x + t * d.x, y);
            if (0.0..=1.0).contains(&t) && in_x(p) {
                found.push((t, p));
            }
        }
    }
    found.sort_by(|p, q| p.1.x.total_cmp(&q.1.x));
    Some((found.first()?.1, found.last()?.1))
}
