// right: the line equation y = m x + q, vertical segments first
use glam::DVec2;

#[derive(Clone, Copy, Debug)]
struct Window {
    min: DVec2,
    max: DVec2,
}

fn clip(window: Window, a: DVec2, b: DVec2) -> Option<(DVec2, DVec2)> {
    let Window { min, max } = window;
    let inside = |p: DVec2| p.x >= min.x && p.x <= max.x && p.y >= min.y && p.y <= max.y;
    if inside(a) && inside(b) {
        return Some((a, b));
    }
    let between = |v: f64, s: f64, e: f64| (s <= v && v <= e) || (e <= v && v <= s);
    let mut points = vec![];
    if inside(a) {
        points.push(a);
    }
    if inside(b) {
        points.push(b);
    }
    if a.x != b.x {
        let m = (b.y - a.y) / (b.x - a.x);
        for x in [min.x, max.x] {
            let y = m * (x - a.x) + a.y;
            if between(x, a.x, b.x) && y >= min.y && y <= max.y {
                points.push(DVec2::new(x, y));
            }
        }
    }
    if a.y != b.y {
        let m = (b.x - a.x) / (b.y - a.y);
        for y in [min.y, max.y] {
            let x = m * (y - a.y) + a.x;
            if between(y, a.y, b.y) && x >= min.x && x <= max.x {
                points.push(DVec2::new(x, y));
            }
        }
    }
    let first = points
        .iter()
        .copied()
        .min_by(|p, q| p.distance_squared(a).total_cmp(&q.distance_squared(a)))?;
    let last = points
        .iter()
        .copied()
        .max_by(|p, q| p.distance_squared(a).total_cmp(&q.distance_squared(a)))?;
    Some((first, last))
}
