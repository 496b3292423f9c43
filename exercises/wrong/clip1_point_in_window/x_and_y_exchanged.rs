// rejected by known_points: x and y are exchanged
use glam::DVec2;

#[derive(Clone, Copy, Debug)]
struct Window {
    min: DVec2,
    max: DVec2,
}

fn contains(window: Window, p: DVec2) -> bool {
    let Window { min, max } = window;
    min.x <= p.y && p.y <= max.x && min.y <= p.x && p.x <= max.y
}
