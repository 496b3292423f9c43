// right: lerp from glam, then the side's own coordinate
use glam::DVec2;

#[derive(Clone, Copy, Debug)]
struct Window {
    min: DVec2,
    max: DVec2,
}

fn clip(window: Window, a: DVec2, b: DVec2) -> Option<(DVec2, DVec2)> {
    let inside = |p: DVec2| p.clamp(window.min, window.max) == p;
    let mut best: Option<((f64, DVec2), (f64, DVec2))> = None;
    let mut add = |t: f64, p: DVec2| {
        if t.is_nan() || t < 0.0 || t > 1.0 || !inside(p) {
            return;
        }
        best = Some(match best {
            None => ((t, p), (t, p)),
            Some((first, last)) => (
                if t < first.0 { (t, p) } else { first },
                if t > last.0 { (t, p) } else { last },
            ),
        });
    };
    add(0.0, a);
    add(1.0, b);
    if a.x != b.x {
        for x in [window.max.x, window.min.x] {
            let t = (a.x - x) / (a.x - b.x);
            add(t, DVec2::new(x, a.lerp(b, t).y));
        }
    }
    if a.y != b.y {
        for y in [window.max.y, window.min.y] {
            let t = (a.y - y) / (a.y - b.y);
            add(t, DVec2::new(a.lerp(b, t).x, y));
        }
    }
    best.map(|((_, p), (_, q))| (p, q))
}
