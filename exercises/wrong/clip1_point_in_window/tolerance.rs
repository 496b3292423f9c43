// rejected by beyond_each_side: compare with the side itself, without a tolerance
use glam::DVec2;

#[derive(Clone, Copy, Debug)]
struct Window {
    min: DVec2,
    max: DVec2,
}

fn contains(window: Window, p: DVec2) -> bool {
    let Window { min, max } = window;
    min.x - 1e-6 <= p.x && p.x <= max.x + 1e-6 && min.y - 1e-6 <= p.y && p.y <= max.y + 1e-6
}
