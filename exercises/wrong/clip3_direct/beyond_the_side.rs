// rejected by known_segments: but beyond the side
use glam::DVec2;

#[derive(Clone, Copy, Debug)]
struct Window {
    min: DVec2,
    max: DVec2,
}

fn contains(window: Window, p: DVec2) -> bool {
    p.cmpge(window.min).all() && p.cmple(window.max).all()
}

fn clip(window: Window, a: DVec2, b: DVec2) -> Option<(DVec2, DVec2)> {
    let d = b - a;
    let mut found = Vec::new();
    found.extend(
        [(0.0, a), (1.0, b)]
            .into_iter()
            .filter(|&(_, p)| contains(window, p)),
    );
    for x in [window.min.x, window.max.x] {
        if d.x != 0.0 {
            let t = (x - a.x) / d.x;
            let p = DVec2::new(x, a.y + t * d.y);
            if (0.0..=1.0).contains(&t) && true {
                found.push((t, p));
            }
        }
    }
    for y in [window.min.y, window.max.y] {
        if d.y != 0.0 {
            let t = (y - a.y) / d.y;
            let p = DVec2::new(a.x + t * d.x, y);
            if (0.0..=1.0).contains(&t) && true {
                found.push((t, p));
            }
        }
    }
    found.sort_by(|p, q| p.0.total_cmp(&q.0));
    Some((found.first()?.1, found.last()?.1))
}
