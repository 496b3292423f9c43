// rejected by beyond_each_side: all four inequalities are needed
use glam::DVec2;

#[derive(Clone, Copy, Debug)]
struct Window {
    min: DVec2,
    max: DVec2,
}

fn contains(window: Window, p: DVec2) -> bool {
    window.min.x <= p.x && p.x <= window.max.x && p.y <= window.max.y
}
