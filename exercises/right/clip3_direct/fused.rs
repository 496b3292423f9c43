// right: lerp and fma, iterators, the ends put last
use glam::DVec2;

#[derive(Clone, Copy, Debug)]
struct Window {
    min: DVec2,
    max: DVec2,
}

fn clip(window: Window, a: DVec2, b: DVec2) -> Option<(DVec2, DVec2)> {
    let inside = |p: DVec2| p.cmpge(window.min).all() && p.cmple(window.max).all();
    let sides = [
        (0, window.min.x),
        (0, window.max.x),
        (1, window.min.y),
        (1, window.max.y),
    ];
    let mut all: Vec<(f64, DVec2)> = sides
        .into_iter()
        .filter(|&(axis, _)| a[axis] != b[axis])
        .map(|(axis, side)| {
            let t = (side - a[axis]) / (b[axis] - a[axis]);
            let other = 1 - axis;
            let mut p = DVec2::splat(side);
            p[other] = t.mul_add(b[other] - a[other], a[other]);
            (t, p)
        })
        .filter(|&(t, p)| t >= 0.0 && t <= 1.0 && inside(p))
        .chain([(0.0, a), (1.0, b)].into_iter().filter(|&(_, p)| inside(p)))
        .collect();
    all.sort_by(|p, q| p.0.partial_cmp(&q.0).unwrap());
    all.first().map(|first| (first.1, all[all.len() - 1].1))
}
