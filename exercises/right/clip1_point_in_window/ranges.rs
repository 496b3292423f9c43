// right: ranges
use glam::DVec2;

#[derive(Clone, Copy, Debug)]
struct Window {
    min: DVec2,
    max: DVec2,
}

fn contains(window: Window, p: DVec2) -> bool {
    let Window { min, max } = window;
    (min.x..=max.x).contains(&p.x) && (min.y..=max.y).contains(&p.y)
}
