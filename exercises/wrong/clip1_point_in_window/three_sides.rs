// rejected by beyond_each_side: it lies beyond the upper side: y ≤ y_max
use glam::DVec2;

#[derive(Clone, Copy, Debug)]
struct Window {
    min: DVec2,
    max: DVec2,
}

fn contains(window: Window, p: DVec2) -> bool {
    let Window { min, max } = window;
    min.x <= p.x && p.x <= max.x && min.y <= p.y
}
